// SPDX-License-Identifier: BSD-3-Clause
// Fractures: cracks that belong together.
//
// A broken bond opens a way between the domain on its left and the one on its right. Cracks that share a domain are one
// fracture; a well's domain joins what starts from it. Seen as a graph, domains are the nodes and cracks the edges, and a
// fracture's length is the longest way through it (two shortest-path sweeps); ways through a well leave out the hole.
#pragma once

#include <vector>

#include "model/assembly.hpp"
#include "model/crack_log.hpp"
#include "model/network.hpp"
#include "model/well.hpp"

namespace hfrac {

class Facets;

struct Fracture {
  std::int64_t crack_count = 0, tensile_cracks = 0;
  std::int64_t wings = 0;  // separate branches that start at the well; 1 if not connected to one
  double length = 0.0, extent = 0.0, reach = 0.0, azimuth = 0.0;     // m, m, m, rad
  double mean_aperture = 0.0, largest_aperture = 0.0, volume = 0.0;  // m, m, m2
  double mean_pressure = 0.0;                                        // Pa
  std::int64_t well = -1;
};

// The line a crack is drawn as: across the contact, one bond diameter long.
struct CrackLine {
  Vec2 middle, normal;  // m; from first to second disc
  double length;        // m
  double aperture;      // m, mechanical opening
};
CrackLine crack_line(const Assembly& assembly, const Options& options, std::int64_t bond);
// The same with the opening across the crack's plane where there is one (crack_plane.hpp).
CrackLine crack_line(const Network& network, const Assembly& assembly, const Options& options,
                     std::int64_t bond);

// Farthest crack end from the centre of its well, of cracks that are connected to one [m]; 0 if none is.
double farthest_tip(const Assembly& assembly, const Network& network, const Options& options,
                    const std::vector<WellPlace>& wells, const CrackLog& log);

// All fractures, most cracks first; writes each crack's fracture into the log. The volume of facets is what the fluid between them
// fills, opening by length along the fracture; of other cracks it is aperture by the crack's line, or its pipe's length on a plane.
std::vector<Fracture> find_fractures(const Assembly& assembly, const Network& network, const Options& options,
                                     const std::vector<WellPlace>& wells, CrackLog& log,
                                     const Facets* facets = nullptr);

}  // namespace hfrac
