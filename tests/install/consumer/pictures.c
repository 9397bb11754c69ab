/* SPDX-License-Identifier: BSD-3-Clause */
/* The installed renderer can be linked to and called. */
#include <hfrac/viz.h>

int main(void) {
  hfrac_viz_options options;
  return hfrac_viz_options_init(&options, (int32_t)sizeof options) == HFRAC_OK ? 0 : 1;
}
