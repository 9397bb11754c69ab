// SPDX-License-Identifier: BSD-3-Clause
// A second fluid that displaces the first: how much of it each domain holds, carried with the flow of an increment.
//
// Both fluids move with the volume that flows, and a domain mixes what it holds: the share s of the second fluid obeys
//     M s - M_0 s_0 = dt (sum over inflow q s_up - sum over outflow q s),      M = fluid in the domain (eq. 8's content and its pore)
// by backward Euler, upwind (Patankar 1980), so that 0 <= s <= 1 whatever the step. Fluid flows from higher to lower pressure, so the domains
// stand in an order in which each takes from those before it only: one sweep solves the system exactly, without a matrix. What leaves one
// domain enters the next to the last bit; where flows averaged over sub-cycles go round in a ring, the ring is cut at one domain and what
// enters that late counts in the next increment.
//
// Viscosity of a pipe: the mean of the domains at its ends, each eta_1 + s (eta_2 - eta_1). That is what two fluids with a sharp front between
// them resist in a slot, piston-like: their pieces lie in series (Muskat 1937, sect. 8.3; Bear 1972, sect. 9.5). It holds for a front within a
// domain as for one between them; fluids that mix by molecules, and fingers of a thin fluid in a thick one, are not in it.
//
// A well that feeds the rock gives the fluid it pumps; a well that takes from it mixes what comes. Outside is the first fluid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/clock.hpp"
#include "model/network.hpp"

namespace hfrac {

class SecondFluid {
 public:
  explicit SecondFluid(const Network& network);

  // What a domain with a well pumps: share of the second fluid, 0 or 1.
  struct Inlet {
    std::int32_t domain;
    double share;
  };
  // The flow now in network.flow, which has already moved the contents, for `duration` seconds.
  void carry(Network& network, std::span<const Inlet> inlets, double duration, SecondFluidBooks& books);

 private:
  void pass_on(Network& network, std::int32_t domain, double duration, SecondFluidBooks& books);
  void give(Network& network, std::int32_t domain, double amount, SecondFluidBooks& books);

  std::vector<std::int32_t> start_, pipe_;  // pipes at each domain
  std::vector<std::int32_t> waiting_;       // per domain: pipes that flow into it from domains not yet done
  std::vector<double> inlet_;               // per domain: what its well pumps
  std::vector<double> gained_;              // m2 per domain, in the increment so far
  std::vector<char> done_;
  std::vector<std::int32_t> ready_;
};

}  // namespace hfrac
