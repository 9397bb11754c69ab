// SPDX-License-Identifier: BSD-3-Clause
#include "step/impose.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "step/host_state.hpp"

namespace hfrac {
namespace {

// Of a wellbore's clusters the first is driven, and the others with it.
void require_driver(const Simulation& s, std::size_t well) {
  const auto wellbore = s.wells()[well].wellbore;
  if (wellbore < 0) return;
  const auto first =
      s.engine_as_is().model.wellbores[static_cast<std::size_t>(wellbore)].clusters.front().well;
  if (first == static_cast<std::int64_t>(well)) return;
  throw Error(ErrorKind::argument, "well " + std::to_string(well) + " is a cluster of a wellbore that well " +
                                       std::to_string(first) + " drives; drive well " +
                                       std::to_string(first) + ".");
}

// The well's schedule ends; the value it is now driven by is changed by `set`.
template <class Set>
void drive(Simulation& s, std::size_t well, WellControl control, const Set& set) {
  require_driver(s, well);
  Loads loads = s.loads();
  WellLoad& load = loads.wells[well];
  load = {s.wells()[well].drive, {}};
  load.drive.control = control;
  set(load.drive);
  s.impose(loads);
}

// What walls would have to pull at they run away from.
void require_walls_to_push(const Engine& e, double sigma_hmin, double outside) {
  const double bears = sigma_hmin - (e.flow ? outside : 0.0);
  if (!e.boundary->walled() || !e.boundary->follows_far_field() || bears >= 0.0) return;
  throw Error(
      ErrorKind::argument,
      "sigma_hmin = " + std::to_string(sigma_hmin) + " Pa is " + std::to_string(-bears) +
          " Pa below the pressure in the pores outside, and walls only push; keep sigma_hmin at or above "
          "it, or use boundary.kind = \"stress\".");
}

}  // namespace

void set_well_pressure(Simulation& s, std::size_t well, double pressure) {
  drive(s, well, WellControl::pressure, [&](WellDrive& d) { d.target_pressure = pressure; });
}

void set_well_ramp(Simulation& s, std::size_t well, double pressure, double per_step) {
  drive(s, well, WellControl::ramp, [&](WellDrive& d) {
    d.target_pressure = pressure;
    d.ramp_per_step = per_step;
  });
}

void set_well_rate(Simulation& s, std::size_t well, double rate) {
  drive(s, well, WellControl::rate, [&](WellDrive& d) { d.set_rate = rate; });
}

void set_well_schedule(Simulation& s, std::size_t well, std::vector<ScheduleEntry> schedule) {
  require_driver(s, well);
  Loads loads = s.loads();
  loads.wells[well] = {s.wells()[well].drive, std::move(schedule)};
  s.impose(loads);
}

void set_well_fluid(Simulation& s, std::size_t well, WellFluid fluid) {
  require_driver(s, well);
  if (fluid == WellFluid::second && !s.engine_as_is().second_fluid) {
    throw Error(ErrorKind::argument, "well " + std::to_string(well) +
                                         " cannot pump the second fluid: this model has none; build it with "
                                         "fluid.second_viscosity above 0 Pa s.");
  }
  // Without the entries that are past, which have made the drive what it is.
  const Well& now = s.wells()[well];
  Loads loads = s.loads();
  loads.wells[well] = {now.drive, {now.schedule.begin() + now.next, now.schedule.end()}};
  loads.wells[well].drive.fluid = fluid;
  s.impose(loads);
}

void set_well_temperature(Simulation& s, std::size_t well, double kelvin) {
  require_transport(s.engine_as_is(), "the temperature of a well's fluid");
  s.engine_as_is().heat->table.require(kelvin, "the temperature of well " + std::to_string(well));
  Loads loads = s.loads();
  loads.well_temperature[well] = kelvin;
  s.impose(loads);
}

void set_far_field(Simulation& s, double sigma_Hmax, double sigma_hmin) {
  const Engine& e = s.engine_as_is();
  if (!e.boundary->follows_far_field()) {
    throw Error(ErrorKind::argument,
                "the walls are fixed, so the far field cannot act; use boundary.kind = \"stress\" or "
                "boundary.walls_after_equilibration = \"servo\".");
  }
  if (sigma_hmin > sigma_Hmax)
    throw Error(ErrorKind::argument, "sigma_hmin = " + std::to_string(sigma_hmin) +
                                         " Pa is larger than sigma_Hmax = " + std::to_string(sigma_Hmax) +
                                         " Pa; swap them.");
  require_walls_to_push(e, sigma_hmin, s.network().pressure[0]);
  Loads loads = s.loads();
  loads.sigma_Hmax = sigma_Hmax;
  loads.sigma_hmin = sigma_hmin;
  s.impose(loads);
}

void set_formation_pressure(Simulation& s, double pressure) {
  const Options& o = s.options();
  const Engine& e = s.engine_as_is();
  Loads loads = s.loads();
  if (!e.flow || OuterPores{o.flow_outer} == OuterPores::closed) {
    throw Error(
        ErrorKind::argument,
        "no pores outside are connected to the model, so their pressure cannot act; use flow.scheme = "
        "\"implicit\" or \"explicit\" with flow.outer = \"formation\".");
  }
  const bool total = StressConvention{o.stress_convention} == StressConvention::total;
  if (total && e.boundary->follows_far_field() && pressure > loads.sigma_hmin) {
    throw Error(ErrorKind::argument, "a formation pressure of " + std::to_string(pressure) +
                                         " Pa is above sigma_hmin = " + std::to_string(loads.sigma_hmin) +
                                         " Pa and would pull the rock apart; raise the far field first.");
  }
  require_walls_to_push(e, loads.sigma_hmin, outside_pressure(e, pressure));
  // What a host's grid said of the outer boundary is absolute and stays; the excess is over what lies beyond.
  if (loads.boundary_pressure_set) {
    const double rise = s.network().pressure[0] - outside_pressure(e, pressure);
    for (double& excess : loads.boundary_excess) excess += rise;
  }
  loads.formation_pressure = pressure;
  s.impose(loads);
}

void set_boundary_pressure(Simulation& s, std::span<const double> pressure) {
  const Network& n = s.network();
  if (!s.engine_as_is().flow || OuterPores{s.options().flow_outer} == OuterPores::closed) {
    throw Error(ErrorKind::argument,
                "no fluid passes this model's outer boundary; it takes flow.outer = \"formation\" and a "
                "flow.scheme other than "
                "\"off\".");
  }
  if (s.options().boundary_flow_distance > 0.0) {
    throw Error(ErrorKind::argument,
                "a host's pressure holds at the model's outer boundary, and boundary.flow_distance puts rock "
                "between; set it to 0 m.");
  }
  Loads loads = s.loads();
  if (pressure.empty()) {  // taken back: the same all around again
    std::fill(loads.boundary_excess.begin(), loads.boundary_excess.end(), 0.0);
    loads.boundary_pressure_set = false;
    s.impose(loads);
    return;
  }
  require_cells(s, pressure.size(), 1, "pressure");
  const auto& cell = s.grid().outer_cell();
  for (const auto c : cell) {
    const double p = pressure[static_cast<std::size_t>(c)];
    if (std::isfinite(p) && p >= n.floor_pressure) continue;
    throw Error(ErrorKind::argument,
                "pressure of " + cell_name(s.grid(), static_cast<std::size_t>(c)) + " is " +
                    std::to_string(p) + " Pa; at the model's outer boundary it must be finite and at least " +
                    std::to_string(n.floor_pressure) + " Pa.");
  }
  for (std::size_t k = 0; k < cell.size(); ++k)
    loads.boundary_excess[k] = pressure[static_cast<std::size_t>(cell[k])] - n.pressure[0];
  loads.boundary_pressure_set = true;
  s.impose(loads);
}

void set_cell_stress(Simulation& s, std::span<const double> stress) {
  const Boundary& boundary = *s.engine_as_is().boundary;
  require_cells(s, stress.size(), 3, "stress");
  if (boundary.walled()) {
    throw Error(ErrorKind::argument,
                "walls are straight and cannot carry a stress that changes along them; use boundary.kind = "
                "\"stress\".");
  }
  if (boundary.exterior() != nullptr) {
    throw Error(ErrorKind::argument,
                "boundary.kind = \"infinite\" has elastic rock of its own beyond the model, whose answer a "
                "host's stress holds "
                "already; use boundary.kind = \"stress\".");
  }
  std::vector<double> loop;
  for (const auto c : s.grid().loop_cell()) {
    for (std::size_t k = 0; k < 3; ++k) {
      loop.push_back(stress[3 * static_cast<std::size_t>(c) + k]);
      if (std::isfinite(loop.back())) continue;
      throw Error(ErrorKind::argument, "stress of " + cell_name(s.grid(), static_cast<std::size_t>(c)) +
                                           " is not a finite number.");
    }
  }
  Loads loads = s.loads();
  loads.cell_load = boundary.load_of_stress(s.assembly(), s.network(), loop);
  s.impose(loads);
}

void hold_temperature(Simulation& s, std::span<const std::int32_t> held) {
  require_transport(s.engine_as_is(), "holding the temperature of discs");
  require_no_open_step(s, "held temperatures");
  Loads loads = s.loads();
  auto& keeps = loads.held_temperature;
  if (held.size() != keeps.size()) {
    throw Error(ErrorKind::argument, "held has " + std::to_string(held.size()) + " values; there are " +
                                         std::to_string(keeps.size()) + " discs.");
  }
  for (std::size_t i = 0; i < held.size(); ++i) keeps[i] = held[i] != 0 ? 1 : 0;
  s.impose(loads);
}

}  // namespace hfrac
