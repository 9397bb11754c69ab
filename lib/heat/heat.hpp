// SPDX-License-Identifier: BSD-3-Clause
// All a simulation with temperature has beyond one without.
#pragma once

#include <memory>

#include "heat/heat_network.hpp"
#include "heat/heat_solver.hpp"
#include "heat/heat_state.hpp"
#include "heat/micro_table.hpp"

namespace hfrac {

struct Heat {
  explicit Heat(const Options& options) : table(options) {}
  MicroTable table;
  HeatNetwork network;
  std::unique_ptr<HeatSolver> solver;  // mode transport
  HeatState state;
  std::vector<std::int32_t> well_domain;
};

}  // namespace hfrac
