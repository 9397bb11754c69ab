// SPDX-License-Identifier: BSD-3-Clause
// What moves a model: the solvers over it and their work space. None of this is state; all of it can be made anew from the model.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "core/device.hpp"
#include "core/workers.hpp"
#include "equilibrium/equilibrium_solver.hpp"
#include "flow/flow_solver.hpp"
#include "flow/second_fluid.hpp"
#include "frac/facets.hpp"
#include "heat/heat.hpp"
#include "heat/water_in_pores.hpp"
#include "model/model.hpp"
#include "options/options.hpp"
#include "solid/boundary.hpp"
#include "solid/explicit_solver.hpp"

namespace hfrac {

// Asked now and then while a step goes on: true asks to stop.
using Interrupt = std::function<bool()>;

struct Engine {
  // The model and the options must stay where they are.
  Engine(const Options& options, Model& model, const Ranks& ranks = {}, std::unique_ptr<Device> on = nullptr);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] bool wet() const;  // with fluid
  // What follows from the model's list of wells: at first, and after one was added or another state was loaded.
  void take_wells();

  const Options& options;
  Model& model;
  const Ranks ranks;
  std::unique_ptr<Workers, Workers::Release> workers;
  std::unique_ptr<Heat> heat;           // none with thermal.mode = "off"
  std::unique_ptr<WaterInPores> water;  // with fluid.kind = "water" and temperature
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<Device> device;  // of the explicit solver's cycles; none: the processor
  std::unique_ptr<ExplicitSolver> mechanics;
  Facets facets;  // of fractures, from the end of the initial equilibration on; law facet only
  std::unique_ptr<FlowSolver> flow;  // from the end of the initial equilibration on; none in a dry model
  std::unique_ptr<SecondFluid> second_fluid;       // likewise; none without fluid.second_viscosity
  std::vector<SecondFluid::Inlet> inlets;          // of the wells, work space
  std::unique_ptr<EquilibriumSolver> equilibrium;  // likewise; none with solver.kind = "explicit"
  std::vector<double> source;                      // m2/s per domain, from wells at a rate
  std::vector<double> pore_viscosity;              // of domains over fluid.viscosity, work space
  bool well_jumped = false;                        // a well's imposed pressure changed in the step at hand
  std::vector<std::array<float, 2>>
      moved_before;                         // m, displacement of each disc as the step began (checks.hpp)
  std::vector<std::byte> before_increment;  // state to go back to within a step
};

}  // namespace hfrac
