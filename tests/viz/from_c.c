/* SPDX-License-Identifier: BSD-3-Clause */
/* The header in plain C99, and one call from it. */
#include "hfrac/viz.h"

int32_t hfrac_viz_test_from_c(const char* run_dir, const char* path);

int32_t hfrac_viz_test_from_c(const char* run_dir, const char* path) {
  char error[256];
  hfrac_viz_options options;
  int32_t status = hfrac_viz_options_init(&options);
  if (status != HFRAC_OK) return status;
  options.width = 320;
  return hfrac_viz_render_picture(run_dir, HFRAC_VIZ_MODEL, path, &options, error, (int32_t)sizeof error, 0);
}
