// SPDX-License-Identifier: BSD-3-Clause
// What is behind `hfrac_sim *`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/ranks.hpp"
#include "hfrac/exchange.h"
#include "internal.hpp"
#include "linear/outside_matrix.hpp"

namespace hfrac {
class Simulation;
}

struct hfrac_sim : hfrac::capi::HandleBase {
  hfrac_sim();
  ~hfrac_sim();  // in sim.cpp, where Simulation is complete

  // A host may call with a handle it has destroyed. So a handle's address is never given out again and stays readable, with
  // zeros and without memory behind it: a page or two of address space for every simulation that ever was.
  static void* operator new(std::size_t size);
  static void operator delete(void* place, std::size_t size);

  hfrac_exchange exchange{};  // what `ranks` talk by
  hfrac_linear_solver linear_solver{};
  hfrac::OutsideSolver solver;  // that solves for them
  std::unique_ptr<hfrac::Simulation> simulation;
  hfrac::Ranks ranks;
  hfrac_progress_fn progress = nullptr;
  void* progress_user = nullptr;
  double progress_seconds = 0.0;
  hfrac_step_fn on_step = nullptr;
  void* on_step_user = nullptr;

  // Raised by every call that may change the simulation. Views are filled when asked for and hold for their epoch.
  std::int64_t epoch = 1;
  std::int64_t numbered = 0;  // epoch in which cracks were last told which fracture they belong to
  struct View {
    std::int64_t epoch = 0;
    std::vector<double> values;
    std::vector<std::int32_t> indices;
  };
  std::map<std::int32_t, View> views;
};

namespace hfrac::capi {
// hfrac_sim_create, on one rank or several (exchange.cpp).
std::int32_t create(const hfrac_sim_def* def, const hfrac_exchange& exchange, hfrac_sim** sim);
// Ranks that talk by the handle's table, which has to stay where it is.
Ranks ranks_of(hfrac_sim& kept);
}  // namespace hfrac::capi
