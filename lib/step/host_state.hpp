// SPDX-License-Identifier: BSD-3-Clause
// What a host puts into a simulation at once, and what it reads by cell of its grid. Not while a step is open, whose tries start from
// where it was opened. Throws Error(argument) and changes nothing if this model cannot take it.
//
// Whose fluid is whose. The pores of the model are the simulation's; the host's are what lies outside. Fluid passes in two
// ways, each with an entry of its own in the ledger:
//   leaked   through the outer boundary's pipes, driven by the pressure the host sets beyond them
//   host     put into (or out of) pores when the host sets their pressure
// injected + host = stored + leaked holds to rounding whatever the host does.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/cell_report.hpp"
#include "step/simulation.hpp"

namespace hfrac {

// `per_cell` values for every cell of the grid.
void require_cells(const Simulation& simulation, std::size_t given, std::size_t per_cell, const char* what);
std::string cell_name(const HostGrid& grid, std::size_t cell);
// Throws unless temperatures differ from place to place here / no step is open.
void require_transport(const Engine& engine, const char* what);
void require_no_open_step(const Simulation& simulation, const char* what);

// Pores beside no crack take the host's pressure at once, each the mean of its cells by area; `added` (empty or one per cell)
// gets the fluid each cell thereby gave [m2].
void set_cell_pressure(Simulation& simulation, std::span<const double> pressure, std::span<double> added);

// In kelvin; the rock answers in the next step. By disc, or by the cell that holds a disc's centre, in mode transport only.
void set_temperature(Simulation& simulation, double kelvin);
void set_disc_temperature(Simulation& simulation, std::span<const double> kelvin);
void set_cell_temperature(Simulation& simulation, std::span<const double> kelvin);

std::vector<CellReport> report_cells(const Simulation& simulation, Upscaling rule);
std::vector<double> cell_temperature(const Simulation& simulation);  // mean by heat capacity

}  // namespace hfrac
