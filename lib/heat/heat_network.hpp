// SPDX-License-Identifier: BSD-3-Clause
// The ways heat takes through a model, as conductances between nodes.
//
// Discs are nodes, and in a wet model so are the domains, which stand for the fluid in them. Heat goes
//   disc to disc      through the contact:    G = f b / L, b the distance of the pores on either side, L that of the centres:
//                     two-point fluxes through the faces of the dual mesh (Eymard, Gallouet and Herbin 2000)
//   disc to fluid     through the disc's face: H = 4 f angle, the sector of the disc that looks into the pore: a cylinder's mean
//                     and face temperatures differ by q R / (4 lambda) once it warms evenly (Carslaw and Jaeger 1959, chapter
//                     7); with a film, 1 / H = 1 / (4 f angle) + 1 / (h R angle)
//   fluid to fluid    with the flow (heat_solver.hpp); it conducts nothing along the pipes
// The one factor f is calibrated on the network at hand, so that rock and resting fluid together conduct as
// thermal.conductivity says, as apertures are calibrated to a permeability. A thermal pipe network after Feng, Han, Li
// and Owen (2008), with pores as nodes of their own. Breakage changes nothing here: a centimetre of water resists a
// twentieth of what a metre of rock does, and what flows along a crack carries far more.
#pragma once

#include "core/array.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"

namespace hfrac {

struct HeatNetwork {
  Array<double> capacity;  // J/(m K) per disc
  Array<double> contact;   // W/(m K) per bond
  Array<double> face;      // W/(m K) per corner of a domain; empty in a dry model
  double factor = 0.0;     // W/(m K), f
};

// Angle of the disc's sector at corner k of a domain.
double sector_angle(const Assembly& assembly, const Network& network, std::int64_t domain, std::int32_t k);

HeatNetwork build_heat_network(const Assembly& assembly, const Network& network, const Options& options);

}  // namespace hfrac
