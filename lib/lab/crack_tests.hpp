// SPDX-License-Identifier: BSD-3-Clause
// Fracture toughness from plates with a slit.
//
// K_Ic = F sigma sqrt(pi a) at the largest constant load (or fluid pressure) sigma that the slit of half length a (depth a of a
// notch) bears. F corrects for the plate's finite width (Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook):
//   centre_crack       F = (1 - 0.025 s^2 + 0.06 s^4) sqrt(sec(pi s / 2)), s = 2 a / width                 (0.1 %)
//   sent               F = sqrt(2 / (pi s) tan(pi s / 2)) (0.752 + 2.02 s + 0.37 (1 - sin(pi s / 2))^3) / cos(pi s / 2),
//                      s = a / width                                                                       (0.5 %)
//   pressurised_crack  as centre_crack: pressure on the faces is far tension less a uniform stress, which adds no K
//                      (Sneddon 1946; Irwin 1957)
// a is measured on the bonds the slit cuts, not taken from its drawing.
#pragma once

#include "lab/laboratory.hpp"

namespace hfrac {

LabResult test_crack(const Options& material, const LabSpec& spec, const Packing& packing,
                     const std::function<bool()>& interrupt);

// F of the formulas above; the share s is that of the test.
double crack_geometry_factor(LabTest test, double share);

}  // namespace hfrac
