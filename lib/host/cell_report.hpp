// SPDX-License-Identifier: BSD-3-Clause
// What a reservoir simulator reads of the model, by cell of its grid.
//
// Permeability of the cracks, K_f, as a tensor that is added to the rock's. Two rules:
//
//   oda   Crack tensor (Oda, Geotechnique 35 (1985) 483, in its form for pipes). Every pipe sees the pressure of a
//         uniform gradient at its two ends. With c = w^3 / (12 eta L), way d and share s in the cell of area A:
//             K_f = eta / A  sum over broken bonds of  s c d (x) d
//         A contact of a joint that conducts (model/joint_pores.hpp) counts by its piece of length l along t, whatever way its
//         pipe takes in the packing: s w^3 / 12 l t (x) t / A, so a joint through a cell of height h gives w^3 / (12 h) along it.
//         It assumes that all cracks are connected and that pressure in them never differs from the rock's mean field: an
//         upper bound. A crack that ends blind in tight rock counts in full, which is wrong by orders of magnitude.
//   flow  Flow through the cell's own network of pipes, intact and broken, in two directions, with the pressure of a uniform
//         gradient on the cell's boundary (Durlofsky, Water Resour. Res. 27 (1991) 699, linear boundary conditions):
//             K = eta / A  sum over all pipes of  s c dp_i dp_j      (energy form: symmetric, never negative)
//         once as it is and once with every fracture's pipe (broken bonds, and those that a joint's fluid passes) narrowed to the
//         mean of the cell's others;
//         the second gives the rock's K_m, the difference K_f. Connection counts as it is. What remains is the bias of linear
//         boundary pressures: in a cell of few discs they let cracks through that end in the next cell.
#pragma once

#include <cstdint>
#include <vector>

#include "host/host_grid.hpp"
#include "options/options.hpp"

namespace hfrac {

enum class Upscaling : std::int32_t { oda = 0, flow = 1 };

struct CellReport {
  double area = 0.0;                 // m2 of the cell
  double coverage = 0.0;             // share of it that the model covers, 0 to 1
  double permeability[3] = {};       // m2; xx, yy, xy of K_f in model axes, over the cell's whole area
  double matrix_permeability = 0.0;  // m2; of the rock between the cracks, over the part covered
  double fracture_porosity = 0.0;    // opening times length of the cracks over the cell's area
  double matrix_porosity = 0.0;      // pore volume over area, of the part covered
  double crack_length = 0.0;         // m; of a smooth joint its contacts' pieces
  double leak_off = 0.0;             // m2/s out of cracks into rock, in the last step
  double outflow = 0.0;      // m2/s out through the model's outer boundary into this cell, in the last step
  double conductance = 0.0;  // m2/(Pa s) of the pipes through the rim to this cell
  double pressure = 0.0;     // Pa; of pores beside no crack, mean by pore volume
  double fracture_pressure =
      0.0;                       // Pa; of pores beside a crack, mean by opening; as `pressure` without cracks
  std::int64_t crack_count = 0;  // cracks with some length in the cell
};

// Whether a pipe's fluid is a fracture's: its bond is broken, or left to the rock where joints meet and passed by their fluid.
bool carries_fracture_fluid(const Assembly& assembly, const Network& network, std::size_t pipe);

// Pores that such a pipe opens to: their fluid is the fracture's. Wells and the outside are neither.
std::vector<char> fractured_pores(const Assembly& assembly, const Network& network);

// `oda_matrix` is the rock's true permeability over that of a uniform gradient, found at set-up.
std::vector<CellReport> report_cells(const HostGrid& grid, const Assembly& assembly, const Network& network,
                                     const Options& options, Upscaling rule, double oda_matrix);

// The permeability of the whole network if every pipe saw a uniform gradient: mean of xx and yy [m2]. The real one is lower.
double uniform_gradient_permeability(const Assembly& assembly, const Network& network, double viscosity);

// Rule `flow` for one cell: K_f (xx, yy, xy; over the covered part) and K_m [m2].
struct CellFlow {
  double fracture[3] = {};
  double matrix = 0.0;
};
CellFlow flow_through_cell(const HostGrid& grid, std::int64_t cell, double covered_area,
                           const Assembly& assembly, const Network& network, double viscosity);

}  // namespace hfrac
