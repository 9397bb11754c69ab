/* SPDX-License-Identifier: BSD-3-Clause */
/* What the small case gives after 5 steps, as seen from C: the yardstick for the other languages. One line
 * per thing, numbers as bit patterns, so that texts are equal if and only if the values are. */
#include <hfrac/hfrac.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void need(int32_t status, const hfrac_sim* sim) {
  char text[1024];
  if (status >= 0) return;
  hfrac_last_error(sim, text, (int32_t)sizeof text, NULL);
  fprintf(stderr, "%s\n", text);
  exit(1);
}

/* Depends on every bit and on the order. */
static uint64_t mix(uint64_t sum, uint64_t bits) {
  return ((sum << 1) | (sum >> 63)) ^ bits;
}

static uint64_t bits_of(double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

static void report_field(hfrac_sim* sim, const char* name) {
  hfrac_field_desc desc = {0};
  int32_t field;
  int64_t values, count, i;
  uint64_t sum = 0;
  desc.struct_size = (int32_t)sizeof desc;
  need(hfrac_field_find(name, &field), NULL);
  need(hfrac_field_info(sim, field, &desc), sim);
  values = desc.count * desc.components;
  if (desc.dtype == 0) {
    double* array = malloc(sizeof(double) * (size_t)values);
    need(hfrac_field_copy_f64(sim, field, array, values, &count), sim);
    for (i = 0; i < count; ++i) sum = mix(sum, bits_of(array[i]));
    free(array);
  } else {
    int32_t* array = malloc(sizeof(int32_t) * (size_t)values);
    need(hfrac_field_copy_i32(sim, field, array, values, &count), sim);
    for (i = 0; i < count; ++i) sum = mix(sum, (uint64_t)(int64_t)array[i]);
    free(array);
  }
  printf("%s %d %" PRId64 " %" PRId64 "\n", name, (int)desc.components, desc.count, (int64_t)sum);
}

int main(int argc, char** argv) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  hfrac_sim_state state = {0};
  hfrac_crack* cracks;
  hfrac_fracture fracture;
  int64_t hash, count, next, i;
  uint64_t sum = 0;
  if (argc != 2) return 2;
  need(hfrac_sim_def_init(&def, (int32_t)sizeof def), NULL);
  need(hfrac_sim_def_load(&def, argv[1]), NULL);
  need(hfrac_sim_create(&def, &sim), NULL);
  need(hfrac_sim_def_free(&def), NULL);
  need(hfrac_step(sim, 5), sim);

  need(hfrac_state_hash(sim, &hash), sim);
  printf("hash %" PRId64 "\n", hash);
  state.struct_size = (int32_t)sizeof state;
  need(hfrac_sim_get_state(sim, &state), sim);
  printf("state %" PRId64 " %" PRId64 " %" PRId64 "\n", state.step, state.cycles,
         (int64_t)bits_of(state.time));

  need(hfrac_cracks_since(sim, 0, (int32_t)sizeof *cracks, NULL, 0, &count, NULL), sim);
  cracks = calloc((size_t)count + 1, sizeof *cracks);
  need(hfrac_cracks_since(sim, 0, (int32_t)sizeof *cracks, cracks, count, &count, &next), sim);
  for (i = 0; i < count; ++i) {
    sum = mix(mix(sum, (uint64_t)cracks[i].bond), bits_of(cracks[i].aperture));
    sum = mix(mix(sum, bits_of(cracks[i].position[1])), (uint64_t)cracks[i].disc[1]);
  }
  free(cracks);
  printf("cracks %" PRId64 " %" PRId64 "\n", count, (int64_t)sum);
  memset(&fracture, 0, sizeof fracture);
  need(hfrac_fractures(sim, (int32_t)sizeof fracture, &fracture, 1, &count), sim);
  printf("fractures %" PRId64 " %" PRId64 "\n", count, (int64_t)bits_of(fracture.length));

  report_field(sim, "disc.position");
  report_field(sim, "disc.radius");
  report_field(sim, "disc.stress");
  report_field(sim, "disc.intact_bonds");
  report_field(sim, "bond.discs");
  report_field(sim, "bond.normal_force");
  report_field(sim, "pipe.aperture");
  report_field(sim, "domain.pressure");
  report_field(sim, "domain.kind");
  need(hfrac_sim_destroy(&sim), NULL);
  return 0;
}
