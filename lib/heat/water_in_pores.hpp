// SPDX-License-Identifier: BSD-3-Clause
// Water that feels temperature in the pores of the rock (fluid.kind = "water" with thermal.mode).
//
//   grows    At temperature T it wants v = rho_0 / rho(T) times the room that it had at thermal.rock_temperature, and grains that grow by alpha dT
//            take angle R^2 alpha dT of a pore's void at each corner, beside what moves with the discs:
//                p = max(floor, p_ref + K(T) (zeta + growth - dV) / V),     growth = (v - 1) (V + zeta) + sum angle R^2 alpha dT
//            In tight rock this is thermal pressurisation (Palciauskas and Domenico 1982). The opening of a joint follows its own law, which feels
//            the growth of its discs, so a joint's pore has the first term alone.
//   stores   by its bulk modulus K(T).
//   flows    by its kinematic viscosity: contents and flows are volumes at the formation's density, so fluid is kept to rounding (step/stages.cpp).
//
// rho and K by IAPWS R7-97 at the formation pressure. Found as the rock feels its temperature and fixed until it does so again. Not in wells: what a hole
// holds is its own balance's.
#pragma once

#include "model/assembly.hpp"
#include "model/heat_state.hpp"
#include "model/network.hpp"
#include "options/options.hpp"

namespace hfrac {

class WaterInPores {
 public:
  // Makes Network::growth and Network::storing_at_start.
  WaterInPores(const Assembly& assembly, Network& network, const Options& options);

  // Of all pores, from HeatState::fluid and what discs have grown by (Assembly::thermal).
  void feel(const Assembly& assembly, Network& network, const HeatState& heat) const;

 private:
  struct State {
    double room;     // rho_0 / rho
    double modulus;  // Pa
  };
  [[nodiscard]] State at(double kelvin) const;

  std::vector<State> table_;  // by kelvin
  Array<double> sector_;      // m, per corner: angle R
  double modulus_at_start_;   // Pa
};

}  // namespace hfrac
