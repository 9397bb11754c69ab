// SPDX-License-Identifier: BSD-3-Clause
// From what rock is known to have to the micro-parameters that give it.
//
// Nothing here is a general optimiser, since the model says which parameter does what:
//   nu               falls as k_s / k_n rises and depends on no stiffness by itself: bracketed on linear solves
//   E                goes with all stiffnesses together: one division
//   UCS over T       rises with tau_c / sigma_c up to a bound: bracketed on strength tests
//                    Beyond the bound, step by step: beta 0 with flat contacts, closed cracks, friction (harder_rocks)
//   T, UCS, K_Ic     go with both strengths together: one division
//   K_Ic with T      K_Ic over T goes with sqrt(R): fixes the disc size, and so the number of discs of the model
//   permeability     goes with r0^3 / R: the engine calibrates r0 by itself, here it is said
// Kept as given: contact.mode, the bonds' share of the stiffness (bond over contact, normal and shear), lambda, packing; friction and
// beta where UCS over T does not ask for other ones. Values are means over packings; what is achieved is measured anew on other packings than those calibrated on.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "options/options.hpp"

namespace hfrac {

enum class Macro : std::int32_t {
  modulus = 0,      // Pa, E in plane strain
  poisson = 1,      // nu in plane strain
  compressive = 2,  // Pa, UCS
  tensile = 3,      // Pa, direct tension
  toughness = 4,    // Pa m^0.5
  permeability = 5  // m2
};
constexpr std::size_t macro_count = 6;

struct CalibrationTargets {
  std::array<double, macro_count> target{};  // NaN: not asked
  bool plane_slopes = false;  // E and nu are the slopes E', nu' of the two-dimensional model instead
  std::int64_t packings = 4, discs = 4000, strength_discs = 2000, seed = 1;
};

struct CalibrationResult {
  Options options;  // the material given, with the micro-parameters found
  std::array<double, macro_count> achieved{},
      spread{};  // mean and standard deviation over other packings; NaN: not asked
  std::array<double, macro_count> lowest{}, highest{};  // what can be had, with the other targets as they are
  std::array<bool, macro_count> reachable{};            // false: a bound of the model was met
  double zero_stress_aperture = 0.0;                    // m, r0 at the model's disc size
  double toughness_coefficient = 0.0;                   // K_Ic over sigma_c sqrt(R)
  double seconds = 0.0;
  std::int64_t tests = 0;
  bool stopped = false;
  std::string text;  // what could not be reached and why; empty if all was
};

// `step` is asked before each test with how many were made; true stops. Throws Error(argument) for targets out of range.
CalibrationResult calibrate(const CaseDefinition& definition, const CalibrationTargets& targets,
                            const std::function<bool(std::int64_t)>& step = {});

}  // namespace hfrac
