// SPDX-License-Identifier: BSD-3-Clause
// From forces and gaps to apertures and conductances of pipes (eq. 6 and 7).
#pragma once

#include "core/ranks.hpp"
#include "core/workers.hpp"
#include "model/network.hpp"
#include "solid/bond_law.hpp"

namespace hfrac {

// Aperture of one pipe with r0 and F0 of `rest`:
//   pressed together   w = r0 F0 / (F + F0)                                             (eq. 7)
//   open               w = r0 + lambda gap, lambda by whether the bond still holds      (eq. 7)
// capped at flow.aperture_limit.
double pipe_aperture(const Options& options, PipeAtRest rest, const NormalView& bond, bool intact);

// The same with its change, for a pipe whose discs answer a gap with `normal` [N, tension positive] and normal_stiffness [N/m].
struct ApertureResponse {
  double aperture;  // m
  double by_gap;    // d aperture / d gap
};
ApertureResponse aperture_response(const Options& options, PipeAtRest rest, double gap, double normal,
                                   double normal_stiffness, bool intact);

// Of a broken bond in a fracture with a plane (crack_plane.hpp): w = r0 F0 / (F + F0) + lambda max(0, U), the first factor 1 where
// the discs are not pressed together.
struct CrackApertureResponse {
  double aperture;    // m
  double by_gap;      // d aperture / d gap of the discs
  double by_opening;  // d aperture / d U
};
CrackApertureResponse crack_aperture_response(const Options& options, PipeAtRest rest, double opening,
                                              double normal, double normal_stiffness);

// Of a broken contact of a joint that conducts (model/joint_pores.hpp), by its opening.
CrackApertureResponse joint_aperture_response(const Options& options, const JointLaw& law, double opening);

// All apertures from the assembly as it stands and the planes of its cracks, and conductances (fluid_law.hpp) from them and the pressures;
// shared by workers and ranks, if there are any.
void update_apertures(Network& network, const Assembly& assembly, const Options& options,
                      Workers* workers = nullptr, const Ranks& ranks = {});

// Permeability of the network as it stands, k = q eta L / dp [m2]: a steady solve between two bands of domains across the part
// of the model left of the wells and, likewise, right of them; their mean. A large network is solved by iteration, from
// `pressure` on if it is not empty; it gets what was found, by domain, over the pressure imposed [1].
double measure_permeability(const Network& network, const Assembly& assembly,
                            const std::vector<WellOptions>& wells, double viscosity,
                            std::vector<double>& pressure);

// Sets zero_stress_aperture so that the network has flow.permeability now (or takes flow.zero_stress_aperture as given).
// `pressure` as above: for a measurement that follows.
void calibrate_aperture(Network& network, const Assembly& assembly, const Options& options,
                        const std::vector<WellOptions>& wells, std::vector<double>& pressure);

}  // namespace hfrac
