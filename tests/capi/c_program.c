/* SPDX-License-Identifier: BSD-3-Clause */
/* The interface as a C99 program sees it: no C++ anywhere, every result through a pointer. */
#include <hfrac/hfrac.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int32_t status, int32_t wanted, const char *what) {
  if (status != wanted) {
    char text[1024];
    hfrac_last_error(NULL, text, (int32_t)sizeof text, NULL);
    fprintf(stderr, "%s: status %d instead of %d: %s\n", what, (int)status, (int)wanted, text);
    ++failures;
  }
}

/* Every option of the table, read by its key. */
static void list_options(const hfrac_sim_def *def) {
  int32_t count = 0, i;
  expect(hfrac_option_count(&count), HFRAC_OK, "option_count");
  for (i = 0; i < count; ++i) {
    hfrac_option_info info;
    double value = 0.0;
    memset(&info, 0, sizeof info);
    info.struct_size = (int32_t)sizeof info;
    expect(hfrac_option_at(i, &info), HFRAC_OK, "option_at");
    expect(hfrac_sim_def_get_f64(def, info.key, &value), HFRAC_OK, info.key);
    printf("%s = %g %s\n", info.key, value, info.unit);
  }
}

int main(void) {
  hfrac_sim_def def;
  char text[8192];
  int32_t major = 0, minor = 0, patch = 0, abi = -1, needed = 0;

  expect(hfrac_version(&major, &minor, &patch), HFRAC_OK, "version");
  expect(hfrac_abi_version(&abi), HFRAC_OK, "abi_version");
  expect(abi, HFRAC_ABI_VERSION, "abi number");
  expect(hfrac_build_info(text, (int32_t)sizeof text, NULL), HFRAC_OK, "build_info");
  printf("%s\n", text);
  expect(hfrac_status_text(HFRAC_ERR_MODEL, text, (int32_t)sizeof text, NULL), HFRAC_OK, "status_text");

  expect(hfrac_sim_def_init(&def, (int32_t)sizeof def), HFRAC_OK, "def_init");
  list_options(&def);
  def.stress_sigma_H = 40e6;
  expect(hfrac_sim_def_set_f64(&def, "stress.sigma_h", 30e6), HFRAC_OK, "set_f64");
  expect(hfrac_sim_def_set_i64(&def, "packing.disc_count", 2000), HFRAC_OK, "set_i64");
  expect(hfrac_sim_def_set_str(&def, "title", "from C"), HFRAC_OK, "set_str");
  def.well_count = 1;
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 6.0;
  def.wells[0].pressure = 45e6;
  def.wells[0].control = HFRAC_WELL_PRESSURE;
  expect(hfrac_sim_def_check(&def), HFRAC_OK, "def_check");
  expect(hfrac_sim_def_write(&def, text, (int32_t)sizeof text, &needed), HFRAC_OK, "def_write");
  expect(needed, (int32_t)strlen(text) + 1, "size of the text");

  def.wells[0].radius = -1.0;
  expect(hfrac_sim_def_check(&def), HFRAC_ERR_ARGUMENT, "negative radius");
  expect(hfrac_sim_def_load(&def, "/nonexistent/case.toml"), HFRAC_ERR_CASE_FILE, "missing file");
  return failures == 0 ? 0 : 1;
}
