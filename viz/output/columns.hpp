// SPDX-License-Identifier: BSD-3-Clause
// The columns of the run folder's tables, each list once: visit(name, value) for every column of an item, in the file's
// order. Units are in the names, SI. What summary.json says of the same things has the same names.
#pragma once

#include <hfrac/hfrac.h>

#include <cmath>
#include <cstddef>

namespace hfrac::output {

/** A column for each component of a member. */
template <class Visit, class Values, std::size_t count>
void parts(const Visit& visit, const char* const (&names)[count], Values& values) {
  for (std::size_t i = 0; i < count; ++i) visit(names[i], values[i]);
}

/** A column of the balance. */
struct Member {
  const char* name;
  double hfrac_balance::*value;
};

/** Where a crack or a slip is. */
template <class One, class Visit>
void place_columns(One& one, const Visit& visit) {
  visit("bond_id", one.bond);
  parts(visit, {"disc_0", "disc_1"}, one.disc);
  parts(visit, {"x_m", "y_m"}, one.position);
  parts(visit, {"normal_x", "normal_y"}, one.normal);
  visit("length_m", one.length);
}

/** cracks.csv. Of a crack that may be changed, the values may be. */
template <class Crack, class Visit>
void crack_columns(Crack& crack, const Visit& visit) {
  visit("crack_id", crack.id);
  visit("step", crack.step);
  visit("cycle", crack.cycle);
  visit("time_s", crack.time);
  visit("mode", crack.mode);
  place_columns(crack, visit);
  visit("aperture_m", crack.aperture);
  visit("normal_force_N", crack.normal_force);
  visit("shear_force_N", crack.shear_force);
  visit("energy_J_per_m", crack.energy);
  visit("fracture", crack.fracture);
  visit("distance_m", crack.distance);
}

/** slips.csv, likewise. */
template <class Slip, class Visit>
void slip_columns(Slip& slip, const Visit& visit) {
  visit("slip_id", slip.id);
  visit("step", slip.step);
  visit("time_s", slip.time);
  visit("duration_s", slip.duration);
  visit("joint", slip.joint);
  place_columns(slip, visit);
  visit("slip_m", slip.slip);
  visit("distance_m", slip.distance);
  visit("shear_modulus_Pa", slip.shear_modulus);
}

/** Of history.csv and summary.json: the energies; the error is NaN where it is not checked. */
inline constexpr Member energies[] = {{"kinetic_J_per_m", &hfrac_balance::kinetic},
                                      {"bond_elastic_J_per_m", &hfrac_balance::bond_elastic},
                                      {"contact_elastic_J_per_m", &hfrac_balance::contact_elastic},
                                      {"fluid_work_J_per_m", &hfrac_balance::fluid_work},
                                      {"boundary_work_J_per_m", &hfrac_balance::boundary_work},
                                      {"friction_J_per_m", &hfrac_balance::friction},
                                      {"damping_J_per_m", &hfrac_balance::damping},
                                      {"fracture_J_per_m", &hfrac_balance::fracture}};
template <class Visit>
void energy_columns(const hfrac_balance& balance, const Visit& visit) {
  for (const auto& [name, member] : energies) visit(name, balance.*member);
  visit("energy_error_J_per_m", balance.energy_checked != 0 ? balance.energy_error : std::nan(""));
}

/** fractures.csv but for the first column, the fracture's number. */
template <class Visit>
void fracture_columns(const hfrac_fracture& fracture, const Visit& visit) {
  visit("crack_count", fracture.crack_count);
  visit("tensile_cracks", fracture.tensile_cracks);
  visit("length_m", fracture.length);
  visit("extent_m", fracture.extent);
  visit("reach_m", fracture.reach);
  visit("azimuth_rad", fracture.azimuth);
  visit("mean_aperture_m", fracture.mean_aperture);
  visit("largest_aperture_m", fracture.largest_aperture);
  visit("volume_m2", fracture.volume);
  visit("mean_pressure_Pa", fracture.mean_pressure);
  visit("well", fracture.well);
  visit("wings", fracture.wings);
}

/** fracture_lines.csv but for the fracture's number. */
template <class Visit>
void line_columns(const hfrac_fracture_point& point, const Visit& visit) {
  visit("x_m", point.position[0]);
  visit("y_m", point.position[1]);
  visit("distance_m", point.distance);
  visit("length_m", point.length);
  visit("aperture_m", point.aperture);
  visit("hydraulic_aperture_m", point.hydraulic_aperture);
  visit("pressure_Pa", point.pressure);
  visit("saturation", point.saturation);
  visit("bond", point.bond);
  visit("wing", point.wing);
  visit("tip", point.tip);
}

/** Likewise, the fluid, but for what was injected. */
inline constexpr Member fluid_volumes[] = {{"stored_volume_m2", &hfrac_balance::stored_volume},
                                           {"leaked_volume_m2", &hfrac_balance::leaked_volume},
                                           {"fluid_error_m2", &hfrac_balance::fluid_error}};
template <class Visit>
void fluid_columns(const hfrac_balance& balance, const Visit& visit) {
  for (const auto& [name, member] : fluid_volumes) visit(name, balance.*member);
}

/** events.csv. */
template <class Visit>
void event_columns(const hfrac_event& event, const Visit& visit) {
  visit("event", event.index);
  visit("first_crack", event.first_crack);
  visit("crack_count", event.crack_count);
  visit("tensile_cracks", event.tensile_cracks);
  visit("first_cycle", event.first_cycle);
  visit("last_cycle", event.last_cycle);
  visit("time_s", event.time);
  parts(visit, {"x_m", "y_m"}, event.position);
  parts(visit, {"moment_xx_N_m", "moment_yy_N_m", "moment_xy_N_m"}, event.moment_tensor);
  visit("moment_N_m", event.moment);
  visit("magnitude", event.magnitude);
  visit("energy_J", event.energy);
  visit("energy_magnitude", event.energy_magnitude);
  visit("isotropic_fraction", event.isotropic_fraction);
  visit("length_m", event.length);
  visit("radius_m", event.radius);
  visit("kind", event.kind == HFRAC_EVENT_SLIP ? "slip" : "cracks");
  visit("first_slip", event.first_slip);
  visit("slip_count", event.slip_count);
  visit("slip_m", event.slip);
  visit("duration_s", event.duration);
}

/** cells.csv but for the first two columns, i and j. */
template <class Visit>
void cell_columns(const hfrac_cell& cell, const Visit& visit) {
  visit("area_m2", cell.area);
  visit("coverage", cell.coverage);
  parts(visit, {"kxx_m2", "kyy_m2", "kxy_m2"}, cell.permeability);
  visit("matrix_permeability_m2", cell.matrix_permeability);
  visit("fracture_porosity", cell.fracture_porosity);
  visit("matrix_porosity", cell.matrix_porosity);
  visit("crack_count", cell.crack_count);
  visit("crack_length_m", cell.crack_length);
  visit("leak_off_m2_per_s", cell.leak_off);
  visit("outflow_m2_per_s", cell.outflow);
  visit("pressure_Pa", cell.pressure);
  visit("fracture_pressure_Pa", cell.fracture_pressure);
}

}  // namespace hfrac::output
