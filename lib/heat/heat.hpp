// SPDX-License-Identifier: BSD-3-Clause
// What moves heat in a simulation with temperature; the temperatures themselves are model/heat_state.hpp.
#pragma once

#include <memory>

#include "heat/heat_network.hpp"
#include "heat/heat_solver.hpp"
#include "heat/micro_table.hpp"

namespace hfrac {

struct Heat {
  explicit Heat(const Options& options) : table(options) {}
  MicroTable table;
  HeatNetwork network;
  std::unique_ptr<HeatSolver> solver;  // mode transport
  std::vector<std::int32_t> well_domain;
};

}  // namespace hfrac
