// SPDX-License-Identifier: BSD-3-Clause
// The straight hydraulic fracture in plane strain that a fluid drives at a constant rate (Khristianovic, Geertsma and de Klerk: KGD),
// between the regimes of toughness and viscosity, without leak-off.
//
// With M = 12 eta E'^3 Q / K'^4, K' = 4 sqrt(2 / pi) K_Ic (Detournay 2004) and the volume V that it holds:
//   l = a(M) (E' Q^3 / (12 eta))^(1/6) (V / Q)^(2/3),  w0^2 = b(M) (12 eta Q / E')^(1/2) l,  w0 p0 = c(M) (12 eta Q E')^(1/2)
// a, b, c and the profiles come from a table of the self-similar solution (kgd_table.inc).
#pragma once

#include <array>

namespace hfrac::command {

struct KgdCase {
  double modulus = 0.0;    ///< [Pa] E'
  double toughness = 0.0;  ///< [Pa m^0.5] K_Ic
  double viscosity = 0.0;  ///< [Pa s]
  double rate = 0.0;       ///< [m2/s] of both wings
};

struct KgdFracture {
  static constexpr std::array<double, 12> places = {0.0, 0.1, 0.2, 0.3, 0.4,  0.5,
                                                    0.6, 0.7, 0.8, 0.9, 0.95, 0.99};

  double half_length = 0.0;                         ///< [m]
  std::array<double, places.size()> opening = {};   ///< [m] at places times half_length
  std::array<double, places.size()> pressure = {};  ///< [Pa] above the stress across it, there
};

/** The fracture that holds `volume` [m2]. */
KgdFracture kgd_fracture(const KgdCase& given, double volume);

}  // namespace hfrac::command
