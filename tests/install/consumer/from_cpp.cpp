// SPDX-License-Identifier: BSD-3-Clause
// The installed headers in a C++ program.
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <cstdio>

int main(int argc, char** argv) {
  hfrac::Definition def;
  hfrac_sim* sim = nullptr;
  if (argc < 2 || hfrac_sim_def_load(&def, argv[1]) < 0 || hfrac_sim_create(&def, &sim) < 0 ||
      hfrac_step(sim, def.stepping_steps) < 0) {
    return 1;
  }
  hfrac_fracture fracture{};
  int64_t count = 0;
  if (hfrac_fractures(sim, sizeof fracture, &fracture, 1, &count) < 0) return 1;
  std::printf("fracture of %.1f m\n", fracture.length);
  return hfrac_sim_destroy(&sim) < 0 ? 1 : 0;
}
