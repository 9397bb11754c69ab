/* SPDX-License-Identifier: BSD-3-Clause */
/* Seconds of processor time for single steps, as C takes them.   step CASE STEPS */
#include <hfrac/hfrac.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

int main(int argc, char** argv) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  struct timespec start, end;
  int k, steps = argc > 2 ? atoi(argv[2]) : 0;
  if (steps < 1 || hfrac_sim_def_init(&def, (int32_t)sizeof def) < 0 ||
      hfrac_sim_def_load(&def, argv[1]) < 0 || hfrac_sim_create(&def, &sim) < 0) {
    return 1;
  }
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &start);
  for (k = 0; k < steps; ++k) {
    if (hfrac_step(sim, 1) < 0) return 1;
  }
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
  printf("%.6f\n", (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec));
  return hfrac_sim_def_free(&def) < 0 || hfrac_sim_destroy(&sim) < 0;
}
