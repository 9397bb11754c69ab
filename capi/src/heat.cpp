// SPDX-License-Identifier: BSD-3-Clause
// Temperature from C.
#include "hfrac/heat.h"

#include <algorithm>
#include <string>
#include <utility>

#include "internal.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
#include "step/host_state.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"
#include "stepping.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

template <class Value>
std::span<const Value> values_of(const Value* values, std::int64_t count, const char* name) {
  require_not_null(values, name);
  if (count < 0) throw Error(ErrorKind::argument, "count = " + std::to_string(count) + " is negative.");
  return {values, static_cast<std::size_t>(count)};
}

std::size_t require_well(const hfrac_sim& sim, std::int32_t index) {
  const auto count = sim.simulation->wells().size();
  if (index < 0 || static_cast<std::size_t>(index) >= count) {
    throw Error(ErrorKind::argument, "well " + std::to_string(index) + " is not there: this simulation has " +
                                         std::to_string(count) + " wells, counted from 0.");
  }
  return static_cast<std::size_t>(index);
}

}  // namespace

int32_t hfrac_set_temperature(hfrac_sim* sim, double temperature) {
  return guarded_sim(sim, [&] {
    require_not_between_tries(*sim, "temperatures");
    set_temperature(*sim->simulation, temperature);
    ++sim->epoch;
    tell(*sim, HFRAC_LOG_INFO, "rock and fluid at " + number_text(temperature) + " K");
  });
}

int32_t hfrac_set_disc_temperature(hfrac_sim* sim, const double* temperature, int64_t count) {
  return guarded_sim(sim, [&] {
    require_not_between_tries(*sim, "temperatures");
    set_disc_temperature(*sim->simulation, values_of(temperature, count, "temperature"));
    ++sim->epoch;
  });
}

int32_t hfrac_set_cell_temperature(hfrac_sim* sim, const double* temperature, int64_t count) {
  return guarded_sim(sim, [&] {
    require_grid(*sim);
    require_not_between_tries(*sim, "temperatures");
    set_cell_temperature(*sim->simulation, values_of(temperature, count, "temperature"));
    ++sim->epoch;
  });
}

int32_t hfrac_get_cell_temperature(hfrac_sim* sim, double* buffer, int64_t capacity, int64_t* count) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    require_heat(sim->simulation->engine_as_is());
    require_grid(*sim);
    const std::vector<double> cells = cell_temperature(*sim->simulation);
    *count = static_cast<std::int64_t>(cells.size());
    if (buffer == nullptr) return;
    std::copy_n(cells.begin(), std::clamp<std::int64_t>(capacity, 0, *count), buffer);
  });
}

int32_t hfrac_hold_disc_temperature(hfrac_sim* sim, const int32_t* held, int64_t count) {
  return guarded_sim(sim, [&] {
    require_not_between_tries(*sim, "held temperatures");
    hold_temperature(*sim->simulation, values_of(held, count, "held"));
    ++sim->epoch;
  });
}

int32_t hfrac_well_set_temperature(hfrac_sim* sim, int32_t index, double temperature) {
  return guarded_sim(sim, [&] {
    set_well_temperature(*sim->simulation, require_well(*sim, index), temperature);
    ++sim->epoch;
    tell(*sim, HFRAC_LOG_INFO,
         "well " + std::to_string(index) + ": injects at " + number_text(temperature) + " K");
  });
}

int32_t hfrac_well_get_temperature(const hfrac_sim* sim, int32_t index, double* temperature) {
  return guarded_sim(sim, [&] {
    require_not_null(temperature, "temperature");
    const Well& well = sim->simulation->wells()[require_well(*sim, index)];
    require_heat(sim->simulation->engine_as_is());
    *temperature = sim->simulation->model().heat->fluid[static_cast<std::size_t>(well.place.domain)];
  });
}

int32_t hfrac_get_heat(const hfrac_sim* sim, hfrac_heat* heat) {
  return guarded_sim(sim, [&] {
    const HeatBalance from = heat_balance_of(std::as_const(*sim->simulation).engine());
    hfrac_heat full{};
    full.mode = static_cast<std::int32_t>(sim->simulation->options().thermal_mode);
    full.stored = from.stored;
    full.wells = from.from_wells;
    full.outside = from.from_outside;
    full.held = from.from_held;
    full.host = from.from_host;
    full.error = from.error;
    full.thermal_work = from.thermal_work;
    full.lowest = from.lowest;
    full.highest = from.highest;
    write_struct(heat, full, "hfrac_heat");
  });
}
