// SPDX-License-Identifier: BSD-3-Clause
// Calls of a host that knows the whole interface: cells and temperatures, schedules, catalogue, laboratory, texts. Arguments
// are right and wrong ones, as a number of the input says.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace fuzz {

inline void demand(bool good) {
  if (!good) std::abort();
}

/** Numbers a host may come up with. */
inline double number(std::uint8_t pick) {
  static constexpr std::array<double, 12> odd = {0.0, -0.0, 1.0,  -1.0, 1e-300, 1e300,
                                                 1e6, 60e6, 0.01, 1e-3, 50.0,   30e6};
  if (pick >= 250)
    return pick % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
  return odd[pick % odd.size()];
}

inline int32_t ignore_step(void* /*user*/, hfrac_sim* sim, int64_t /*step*/, double /*time*/) {
  demand(hfrac_step(sim, 1) == HFRAC_ERR_BUSY);
  return 0;
}
inline int32_t ignore_message(void* /*user*/, int32_t /*level*/, const char* message) {
  demand(message != nullptr);
  return 0;
}

/** What a host puts into cells and discs, and reads of them. */
inline int32_t cell_call(hfrac_sim* sim, int kind, std::uint8_t argument, double value) {
  std::array<double, 256> values{};
  values.fill(argument % 3 == 0 ? value : 300.0 + argument);
  std::array<int32_t, 256> flags{};
  flags.fill(argument % 2);
  int64_t discs = 72, cells = 3 * (argument % 6), count = 0;
  hfrac_sim_state state{};
  state.struct_size = sizeof state;
  if (hfrac_sim_get_state(sim, &state) == HFRAC_OK) discs = argument % 7 == 0 ? argument : state.disc_count;
  if (argument % 11 == 0) cells = -1;
  const double* from = argument % 13 == 0 ? nullptr : values.data();
  switch (kind) {
    case 0:
      return hfrac_set_boundary_pressure(sim, from, cells);
    case 1:
      return hfrac_set_cell_pressure(sim, from, cells, argument % 2 == 0 ? nullptr : values.data(), 256);
    case 2:
      return hfrac_set_cell_stress(sim, from, argument % 5 == 0 ? cells : 3 * cells);
    case 3:
      return hfrac_set_temperature(sim, values[0]);
    case 4:
      return hfrac_set_disc_temperature(sim, from, discs);
    case 5:
      return hfrac_set_cell_temperature(sim, from, cells);
    case 6:
      return hfrac_get_cell_temperature(sim, values.data(), argument % 4 == 0 ? 2 : 256, &count);
    case 7:
      return hfrac_hold_disc_temperature(sim, argument % 13 == 0 ? nullptr : flags.data(), discs);
    case 8:
      return hfrac_well_set_temperature(sim, argument % 3 - 1, values[0]);
    default:
      return hfrac_well_get_temperature(sim, argument % 3 - 1, values.data());
  }
}

template <class Struct, class Call>
int32_t get(std::uint8_t argument, const Call& call) {
  Struct into{};
  // A host of another version may have less of a struct, and one that forgot its size none.
  into.struct_size =
      argument % 4 == 3 ? argument % static_cast<int32_t>(sizeof into) : static_cast<int32_t>(sizeof into);
  return call(&into);
}

/** The catalogue of cracks that nobody logged. */
inline int32_t catalogue_call(std::uint8_t argument, double value) {
  std::array<hfrac_crack, 6> cracks{};
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    cracks[k].id = static_cast<int64_t>(k);
    cracks[k].position[0] = argument % 5 == 0 ? value : static_cast<double>(k * argument % 7);
    cracks[k].normal[1] = 1.0;
    cracks[k].distance = value;
    cracks[k].normal_force = -value;
    cracks[k].energy = cracks[k].length = 1.0;
  }
  hfrac_catalogue_options options{};
  options.struct_size = sizeof options;
  options.distance = argument % 3 == 0 ? value : 0.0;
  options.time_window = argument % 7 == 0 ? value : 0.0;
  std::array<hfrac_event, 6> events{};
  std::array<int64_t, 6> of{};
  int64_t count = argument % 8 == 0 ? -1 : argument % 7, found = 0;
  const auto* rule = argument % 2 == 0 ? &options : nullptr;
  hfrac_find_event_of_cracks(cracks.data(), sizeof(hfrac_crack), count, rule, of.data(), 6, &found);
  std::array<hfrac_slip, 6> slips{};
  for (std::size_t k = 0; k < slips.size(); ++k) {
    slips[k].step = static_cast<int64_t>(k) + argument % 2;
    slips[k].position[0] = cracks[k].position[0];
    slips[k].normal[1] = slips[k].duration = slips[k].shear_modulus = 1.0;
    slips[k].length = slips[k].slip = slips[k].distance = value;
  }
  options.slip_rate = argument % 4 == 0 ? value : 0.0;
  hfrac_find_slip_events(slips.data(), sizeof(hfrac_slip), count, rule, sizeof(hfrac_event), events.data(), 6,
                         &found);
  return hfrac_find_events(cracks.data(), sizeof(hfrac_crack), count, rule, sizeof(hfrac_event),
                           events.data(), 6, &found);
}

inline int32_t host_call(hfrac_sim* sim, hfrac_sim_def& def, int kind, std::uint8_t argument, double value) {
  int64_t count = 0, epoch = 0;
  int32_t number_of = 0;
  switch (kind) {
    case 10:
      return get<hfrac_heat>(argument, [&](auto* to) { return hfrac_get_heat(sim, to); });
    case 11: {
      const std::array<double, 3> time = {0.0, value, 0.05}, pressure = {60e6, value, 1e-4};
      const std::array<int32_t, 3> control = {HFRAC_WELL_PRESSURE, argument % 3, HFRAC_WELL_RATE};
      return hfrac_well_set_schedule(sim, argument % 3 - 1, argument % 5 - 1, time.data(), control.data(),
                                     argument % 13 == 0 ? nullptr : pressure.data());
    }
    case 12:
      return catalogue_call(argument, value);
    case 13: {
      const std::array<double, 4> magnitudes = {value, -1.0, -2.0 + argument, -2.5};
      return get<hfrac_magnitude_law>(argument, [&](auto* to) {
        return hfrac_find_magnitude_law(magnitudes.data(), argument % 6 - 1 > 4 ? 4 : argument % 6 - 1, value,
                                        to);
      });
    }
    case 14: {
      const void* data = nullptr;
      const int32_t status = hfrac_field_view(sim, argument, &data, &count, &epoch);
      if (status == HFRAC_OK) demand(hfrac_epoch(sim, &count) == HFRAC_OK && count == epoch);
      return status;
    }
    case 15:
      return get<hfrac_setup_report>(argument, [&](auto* to) { return hfrac_sim_get_setup(sim, to); });
    case 16:
      return get<hfrac_solver_report>(argument, [&](auto* to) { return hfrac_sim_get_solver(sim, to); });
    case 17:
      return get<hfrac_step_limits>(argument, [&](auto* to) { return hfrac_get_step_limits(sim, to); });
    case 18:
      hfrac_wall_count(sim, &number_of);
      return get<hfrac_wall_state>(argument,
                                   [&](auto* to) { return hfrac_wall_get(sim, argument % 6 - 1, to); });
    case 19:
      hfrac_well_count(sim, &number_of);
      if (argument % 5 == 0)
        return hfrac_well_add(sim, argument, value, argument % 13 == 0 ? nullptr : &number_of);
      return get<hfrac_well_state>(argument,
                                   [&](auto* to) { return hfrac_well_get(sim, argument % 3 - 1, to); });
    case 20:
      return hfrac_set_on_step(sim, argument % 2 == 0 ? ignore_step : nullptr, nullptr);
    case 21:
      return hfrac_set_log(sim, argument % 2 == 0 ? ignore_message : nullptr, nullptr, argument % 7 - 1);
    case 22: {
      hfrac::Definition read;
      if (argument % 3 == 0) read.struct_version = 1;
      return hfrac_sim_definition(sim, &read);
    }
    case 23: {
      hfrac_lab* lab = nullptr;
      hfrac_lab_spec spec{};
      demand(hfrac_lab_spec_init(&spec, sizeof spec) == HFRAC_OK);
      spec.test = argument % 9 - 1;
      spec.disc_count = -static_cast<int64_t>(argument);  // a real one takes seconds
      spec.confining = value;
      const int32_t status = hfrac_lab_run(&def, &spec, nullptr, nullptr, &lab);
      demand(status < 0 && lab == nullptr);
      return hfrac_lab_destroy(&lab);
    }
    case 24: {
      double real = 0.0;
      return hfrac_sim_def_get_f64(&def, argument % 2 == 0 ? "well[0].pressure" : "no.such", &real);
    }
    case 25:
      return hfrac_sim_def_get_i64(&def, argument % 2 == 0 ? "run.workers" : "stress.sigma_Hmax", &count);
    case 26:
      return hfrac_field_find(argument % 2 == 0 ? "disc.radius" : "disc", &number_of);
    case 27:
      return get<hfrac_option_info>(argument,
                                    [&](auto* to) { return hfrac_option_at(argument * 3 - 1, to); });
    case 28:
      return hfrac_write_grdecl(sim, "/dev/full/none", argument % 4, argument % 3, argument % 3, value, 0.0);
    case 29: {
      int32_t major = 0, minor = 0, patch = 0;
      return hfrac_version(&major, &minor, argument % 2 == 0 ? &patch : nullptr);
    }
    default:
      return cell_call(sim, kind, argument, value);
  }
}

}  // namespace fuzz
