// SPDX-License-Identifier: BSD-3-Clause
// A bond that softens beyond its strength, by the fracture energy G_c given: linear softening (Hillerborg, Modeer and Petersson 1976) with
// one damage D for tension, shear and bending together (Camanho and Davila 2002, NASA/TM-2002-211737: start by strength, end by energy).
//
//   opening    w = sqrt(max(0, g)^2 + k_s / k_n u_s^2 + R^2 / 3 theta^2), so that k_n w^2 / 2 is the energy of the whole bond but for pressure
//   start      w_0: where the bond's stress first is its strength, bending and shear included, as for one that is brittle (eq. 21-23)
//   end        w_c = 2 G_c A / (k_n w_0), A = 2 R; in pure tension k_n w_0 = T A and w_c = 2 G_c / T
//   damage     1 - D = w_0 (w_c - w) / (w (w_c - w_0)) at the largest w so far: (1 - D) k_n w falls on a line from w_0 to w_c
//   forces     tension, shear and moment times 1 - D, back to the origin where w falls; pressure, g < 0, whole
//   energy     k_n w_0 w_c / 2 (w - w_0) / (w_c - w_0) has been taken, whatever the way; G_c A in all
// At w_c the bond is broken. One that stores more than G_c A at its strength, in shear under pressure for instance, cannot soften: it lets go
// steeply, w_c = `steepest` w_0, and takes a little more than it stored.
#pragma once

#include <cstdint>

#include "model/assembly.hpp"
#include "options/options.hpp"

namespace hfrac {

struct PairMotion;

// A bond at the displacements as they stand.
struct Softened {
  double kept = 1.0;                    // 1 - D
  double tensile = 0.0, shear = 0.0;    // stress over strength, as if it were whole
  double start = 0.0, worst = 0.0;      // m, as they are with these displacements
  double spent = 0.0;                   // w / w_c: 1 where the bond is broken
  double at_start = 1.0;                // w_0 / w: its forces there over those it would have if it were whole
  double by_gap = 0.0, by_shear = 0.0;  // 1/m, of `kept`
  double by_bend = 0.0;                 // 1/rad
};
Softened soften(const Assembly& assembly, const Options& options, std::int64_t bond,
                const PairMotion& motion);

// Energy that a bond has taken so far, to the displacements last kept [J/m], and that of all.
double energy_taken(const Assembly& assembly, const Options& options, std::int64_t bond);
double energy_taken(const Assembly& assembly, const Options& options);

// Largest stress over strength of a bond that is whole, 1 or more where one softens.
double largest_stress(const Assembly& assembly, const Options& options);

// From now on bonds soften. Refuses discs too large for the energy given.
void begin_softening(Assembly& assembly, const Options& options);

}  // namespace hfrac
