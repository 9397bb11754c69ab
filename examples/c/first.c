/* The shortest useful program: build a case, run it, ask for the fracture.
 *   cc first.c $(pkg-config --cflags --libs hfrac) && ./a.out case.toml */
#include <hfrac/hfrac.h>
#include <stdio.h>

static int failed(int32_t status, const hfrac_sim* sim) {
  char text[512];
  if (status >= 0) return 0;
  hfrac_last_error(sim, text, sizeof text, NULL);
  fprintf(stderr, "%s\n", text);
  return 1;
}

int main(int argc, char** argv) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  hfrac_fracture fracture;
  int64_t count = 0;

  if (failed(hfrac_sim_def_init(&def, sizeof def), NULL)) return 1;
  if (argc > 1 && failed(hfrac_sim_def_load(&def, argv[1]), NULL)) return 1;
  if (failed(hfrac_sim_create(&def, &sim), NULL)) return 1;
  if (!failed(hfrac_step(sim, def.stepping_steps), sim) &&
      !failed(hfrac_fractures(sim, sizeof fracture, &fracture, 1, &count), sim)) {
    if (count == 0)
      printf("no fracture\n");
    else
      printf("fracture of %.1f m, %.1f mm wide, %d cracks\n", fracture.length,
             1e3 * fracture.largest_aperture, (int)fracture.crack_count);
  }
  hfrac_sim_destroy(&sim);
  hfrac_sim_def_free(&def);
  return 0;
}
