// SPDX-License-Identifier: BSD-3-Clause
// history.csv: one line per step. `well_...` is the first well; further ones are well_1_..., well_2_... as in
// the case file, where wells count from 0.
#include <fmt/format.h>

#include "output/tables.hpp"

namespace hfrac::output {
namespace {

std::string well_prefix(size_t index) {
  return index == 0 ? "well" : fmt::format("well_{}", index);
}

}  // namespace

std::string history_header(size_t wells) {
  std::string header = "step,time_s";
  for (size_t i = 0; i < (wells == 0 ? 1 : wells); ++i)
    header += fmt::format(",{0}_pressure_Pa,{0}_rate_m2_per_s", well_prefix(i));
  return header +
         ",injected_volume_m2,crack_count,tensile_cracks,shear_cracks,tip_distance_m,fracture_length_m,"
         "fracture_width_m,fracture_volume_m2,force_ratio,cycles,at_rest,kinetic_J_per_m,bond_elastic_J_per_"
         "m,"
         "contact_elastic_J_per_m,fluid_work_J_per_m,boundary_work_J_per_m,friction_J_per_m,damping_J_per_m,"
         "fracture_J_per_m,energy_error_J_per_m,stored_volume_m2,leaked_volume_m2,fluid_error_m2,"
         "solver_increments,newton_iterations,rejected_error,rejected_strength,rejected_divergence\n";
}

std::string history_row(hfrac_sim* sim) {
  const auto state = state_of(sim);
  const auto balance = balance_of(sim);
  const auto fracture = measure(fractures_of(sim));
  const auto wells = wells_of(sim);

  std::string row = fmt::format("{},{}", state.step, state.time);
  for (const auto& well : wells) row += fmt::format(",{},{}", well.pressure, well.rate);
  if (wells.empty()) row += ",,";
  row += fmt::format(",{},{},{},{},{}", balance.injected_volume, state.crack_count, state.tensile_cracks,
                     state.shear_cracks, state.tip_distance);
  row += fmt::format(",{},{},{}", fracture.length, fracture.width, fracture.volume);
  row += fmt::format(",{},{},{}", state.force_ratio, state.cycles, state.at_rest);
  row += fmt::format(",{},{},{},{},{}", balance.kinetic, balance.bond_elastic, balance.contact_elastic,
                     balance.fluid_work, balance.boundary_work);
  row += fmt::format(",{},{},{},{}", balance.friction, balance.damping, balance.fracture,
                     balance.energy_checked != 0 ? fmt::to_string(balance.energy_error) : "");
  row += fmt::format(",{},{},{}", balance.stored_volume, balance.leaked_volume, balance.fluid_error);
  const auto solver = solver_of(sim);
  row += fmt::format(",{},{},{},{},{}\n", solver.increments, solver.newton_iterations, solver.rejected_error,
                     solver.rejected_strength, solver.rejected_divergence);
  return row;
}

FractureMeasure measure(const std::vector<hfrac_fracture>& fractures) {
  FractureMeasure result;
  for (const auto& fracture : fractures) {
    result.volume += fracture.volume;
    if (fracture.length > result.length) {
      result.length = fracture.length;
      result.width = fracture.largest_aperture;
    }
  }
  return result;
}

}  // namespace hfrac::output
