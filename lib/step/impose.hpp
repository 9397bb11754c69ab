// SPDX-License-Identifier: BSD-3-Clause
// What a host imposes on a simulation from the next step on, by name: each function changes its Loads (loads.hpp) after it has
// checked that this model can bear them. Throws Error(argument) and changes nothing otherwise.
#pragma once

#include <span>
#include <vector>

#include "step/simulation.hpp"

namespace hfrac {

void set_well_pressure(Simulation& simulation, std::size_t well, double pressure);               // Pa
void set_well_ramp(Simulation& simulation, std::size_t well, double pressure, double per_step);  // Pa
void set_well_rate(Simulation& simulation, std::size_t well, double rate);                       // m2/s
// Replaces the well's schedule. Entries already past take effect with the next step, the last of them in the end. The three
// functions above end a well's schedule.
void set_well_schedule(Simulation& simulation, std::size_t well, std::vector<ScheduleEntry> schedule);
// What the well pumps. Its schedule goes on; an entry that names a fluid changes it again. Of a wellbore its first well's counts.
void set_well_fluid(Simulation& simulation, std::size_t well, WellFluid fluid);
void set_well_temperature(Simulation& simulation, std::size_t well, double kelvin);  // of what it injects

// Pa, stress-controlled or servo-driven boundaries only.
void set_far_field(Simulation& simulation, double sigma_Hmax, double sigma_hmin);
// Another absolute pressure in the pores outside the model. Total stresses stay; inside it follows by flow.
void set_formation_pressure(Simulation& simulation, double pressure);

// Pressure beyond the model's outer boundary by cell of the grid [Pa]; empty: the formation's again.
void set_boundary_pressure(Simulation& simulation, std::span<const double> pressure);
// Stress on top of the far field by cell [Pa; xx, yy, xy].
void set_cell_stress(Simulation& simulation, std::span<const double> stress);

// Discs not 0 keep their temperature until told otherwise. Not while a step is open.
void hold_temperature(Simulation& simulation, std::span<const std::int32_t> held);

}  // namespace hfrac
