/* SPDX-License-Identifier: BSD-3-Clause */
/* A client as it was compiled against the oldest supported headers (capi/abi/oldest), run with the library of today: its
 * structs may be shorter than the library's, and nothing may be written beyond their end. */
#include <hfrac/hfrac.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(int holds, const char* what) {
  if (!holds) {
    char text[1024] = "";
    hfrac_last_error(NULL, text, (int32_t)sizeof text, NULL);
    fprintf(stderr, "not so: %s (%s)\n", what, text);
    ++failures;
  }
}

/* A struct as the client has it, with a fence behind. */
#define FENCED(type, name)    \
  struct {                    \
    type value;               \
    unsigned char fence[512]; \
  } name
#define RAISE(name)                                           \
  do {                                                        \
    memset(&(name), 0xA5, sizeof(name));                      \
    (name).value.struct_size = (int32_t)sizeof((name).value); \
  } while (0)

static void intact(const unsigned char* fence, size_t size, const char* name) {
  size_t i;
  for (i = 0; i < size; ++i) {
    if (fence[i] != 0xA5) {
      fprintf(stderr, "%s: written beyond its end\n", name);
      ++failures;
      return;
    }
  }
}
#define STANDS(name, what) intact((name).fence, sizeof((name).fence), what)

int main(void) {
  FENCED(hfrac_sim_def, def);
  FENCED(hfrac_sim_def, back);
  FENCED(hfrac_sim_state, state);
  FENCED(hfrac_setup_report, setup);
  FENCED(hfrac_balance, balance);
  FENCED(hfrac_well_state, well);
  FENCED(hfrac_field_desc, desc);
  FENCED(hfrac_option_info, option);
  hfrac_crack cracks[4];
  hfrac_fracture fractures[4];
  hfrac_sim* sim = NULL;
  int32_t abi = -1;
  int64_t count = 0, next = 0;

  hfrac_abi_version(&abi);
  check(abi == HFRAC_ABI_VERSION, "the library has the ABI this client was compiled for");

  memset(&def, 0xA5, sizeof def);
  check(hfrac_sim_def_init(&def.value, (int32_t)sizeof def.value) == HFRAC_OK, "def_init");
  STANDS(def, "hfrac_sim_def after init");
  check(def.value.struct_size == (int32_t)sizeof def.value, "the struct keeps the client's size");
  check(def.value.packing_disc_count == 10000 && def.value.bond_tensile_strength == 42.5e6,
        "members are where they were");
  def.value.stress_convention = 1;
  def.value.boundary_kind = 1;
  def.value.packing_disc_count = 500;
  def.value.packing_residual = 1e-3;
  def.value.stress_sigma_Hmax = def.value.stress_sigma_hmin = 0.0;
  def.value.well_count = 1;
  def.value.wells[0].x = def.value.wells[0].y = 50.0;
  def.value.wells[0].radius = 10.0;
  def.value.wells[0].pressure = 60e6;
  check(hfrac_sim_def_set_str(&def.value, "title", "an old client") == HFRAC_OK, "set_str");
  STANDS(def, "hfrac_sim_def after a keyed setter");
  check(def.value.packing_disc_count == 500, "a keyed setter leaves the rest alone");
  check(hfrac_sim_def_check(&def.value) == HFRAC_OK, "def_check");

  RAISE(option);
  check(hfrac_option_at(0, &option.value) == HFRAC_OK && strcmp(option.value.key, "model.width") == 0,
        "option_at");
  STANDS(option, "hfrac_option_info");

  check(hfrac_sim_create(&def.value, &sim) == HFRAC_OK, "create");
  check(hfrac_step(sim, 1) >= 0, "step");

  memset(&back, 0xA5, sizeof back);
  check(hfrac_sim_def_init(&back.value, (int32_t)sizeof back.value) == HFRAC_OK, "def_init");
  check(hfrac_sim_definition(sim, &back.value) == HFRAC_OK, "definition");
  STANDS(back, "hfrac_sim_def from a simulation");
  check(back.value.packing_disc_count == 500 && strcmp(back.value.title, "an old client") == 0,
        "it is this client's");

  RAISE(state);
  check(
      hfrac_sim_get_state(sim, &state.value) == HFRAC_OK && state.value.step == 1 && state.value.time == 1.0,
      "get_state");
  STANDS(state, "hfrac_sim_state");
  RAISE(setup);
  check(hfrac_sim_get_setup(sim, &setup.value) == HFRAC_OK && setup.value.packed_discs == 500, "get_setup");
  STANDS(setup, "hfrac_setup_report");
  RAISE(balance);
  check(hfrac_get_balance(sim, &balance.value) == HFRAC_OK && balance.value.injected_volume > 0.0,
        "get_balance");
  STANDS(balance, "hfrac_balance");
  RAISE(well);
  check(hfrac_well_get(sim, 0, &well.value) == HFRAC_OK && well.value.pressure == 60e6, "well_get");
  STANDS(well, "hfrac_well_state");
  RAISE(desc);
  check(hfrac_field_info(sim, HFRAC_DISC_POSITION, &desc.value) == HFRAC_OK && desc.value.components == 2,
        "field_info");
  STANDS(desc, "hfrac_field_desc");

  /* Records of the client's size, one right after the other. */
  check(hfrac_cracks_since(sim, 0, (int32_t)sizeof cracks[0], cracks, 4, &count, &next) == HFRAC_OK,
        "cracks_since");
  check(count == 4 && cracks[0].id == 0 && cracks[3].id == 3 && cracks[3].length > 0.0,
        "cracks are laid out as they were");
  check(hfrac_fractures(sim, (int32_t)sizeof fractures[0], fractures, 4, &count) == HFRAC_OK, "fractures");
  check(count > 0 && fractures[0].index == 0 && fractures[0].length > 0.0,
        "fractures are laid out as they were");

  check(hfrac_sim_destroy(&sim) == HFRAC_OK && sim == NULL, "destroy");
  printf("hfrac_sim_def of this client: %d bytes\n", (int)sizeof def.value);
  return failures == 0 ? 0 : 1;
}
