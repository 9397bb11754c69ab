// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads.hpp"

#include <cmath>

#include "core/error.hpp"
#include "step/ledger.hpp"

namespace hfrac {
namespace {

// Of two numbers of a load. What is no number, from a damaged image, is told by the step and not put on again.
bool differ(double a, double b) {
  return !(a == b || (std::isnan(a) && std::isnan(b)));
}

}  // namespace

double outside_pressure(const Engine& engine, double formation) {
  return engine.model.network.reference_pressure + (formation - engine.options.fluid_formation_pressure);
}

Loads loads_of(const Model& model) {
  Loads loads;
  loads.sigma_Hmax = model.far_field.sigma_Hmax;
  loads.sigma_hmin = model.far_field.sigma_hmin;
  loads.formation_pressure = model.far_field.formation_pressure;
  loads.boundary_pressure_set = model.far_field.boundary_pressure_set;
  loads.boundary_excess = model.network.outer_excess;
  loads.cell_load = model.boundary.cell_load;
  for (const auto& well : model.wells) loads.wells.push_back({well.drive, well.schedule});
  if (model.heat) {
    loads.well_temperature = model.heat->well;
    loads.held_temperature = model.heat->held;
  }
  return loads;
}

void impose(Engine& engine, Loads& now, const Loads& wanted) {
  Model& m = engine.model;
  if (wanted.wells.size() != m.wells.size())
    throw Error(ErrorKind::internal, "loads of other wells than there are.");
  for (std::size_t w = 0; w < m.wells.size(); ++w) {
    if (now.wells[w] == wanted.wells[w]) continue;
    m.wells[w].drive = wanted.wells[w].drive;
    if (now.wells[w].schedule == wanted.wells[w].schedule) continue;
    m.wells[w].schedule = wanted.wells[w].schedule;
    m.wells[w].next = 0;
  }
  bool stress = differ(now.sigma_Hmax, wanted.sigma_Hmax) || differ(now.sigma_hmin, wanted.sigma_hmin);
  const auto same = [](Vec2 a, Vec2 b) { return !differ(a.x, b.x) && !differ(a.y, b.y); };
  for (std::size_t k = 0; k < wanted.cell_load.size(); ++k)
    stress = stress || !same(m.boundary.cell_load[k], wanted.cell_load[k]);
  if (stress || differ(now.formation_pressure, wanted.formation_pressure)) engine.mechanics->bring_home();
  m.boundary.cell_load = wanted.cell_load;
  if (differ(now.formation_pressure, wanted.formation_pressure)) {
    keep_outside_work(m);
    m.network.pressure[0] = outside_pressure(engine, wanted.formation_pressure);
    engine.boundary->set_outside_pressure(m.assembly, m.network, wanted.sigma_Hmax, wanted.sigma_hmin);
  } else if (stress) {
    engine.boundary->set_far_field(m.assembly, wanted.sigma_Hmax, wanted.sigma_hmin);
  }
  m.network.outer_excess = wanted.boundary_excess;
  m.far_field = {wanted.sigma_Hmax, wanted.sigma_hmin, wanted.formation_pressure,
                 wanted.boundary_pressure_set};
  if (m.heat) {
    m.heat->well = wanted.well_temperature;
    m.heat->held = wanted.held_temperature;
  }
  now = wanted;
}

}  // namespace hfrac
