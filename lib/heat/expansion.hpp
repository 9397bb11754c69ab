// SPDX-License-Identifier: BSD-3-Clause
// What temperature does to the rock: discs and bonds grow, and micro-parameters follow the table.
//
//   disc    R grows by alpha R dT
//   bond    alpha (a_i dT_i + a_j dT_j), a the two arms of the line between the centres, is taken from the gap of bond and
//           contact (bond_factors.cpp): with one dT the assembly just grows by alpha dT, without stress
// dT counts from the temperature at set-up. The law of thermal strain in a bonded assembly is that of PFC (Itasca, thermal
// option: dR = alpha R dT, and a bond's normal force changes by -k A alpha L dT). Rotations and shear feel nothing.
#pragma once

#include "heat/micro_table.hpp"
#include "model/assembly.hpp"

namespace hfrac {

// Sets assembly.thermal, and the bonds' factors with it, from the discs' temperatures [K].
void feel_temperature(Assembly& assembly, const Array<double>& temperature, const MicroTable& table,
                      const Options& options);

}  // namespace hfrac
