// SPDX-License-Identifier: BSD-3-Clause
// V8  Fracture toughness does not depend on disc size when it is given.
//
// Formula    K_Ic = F sigma sqrt(pi a), F for the plate's width; given bond strengths make K_Ic = c sigma_c sqrt(R), which
//            halves when discs are a quarter as large.
// Source     Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook; Potyondy and Cundall (2004), section 3.4.
// Set-up     Plate of 40 m x 60 m, slit of 12 m in its middle under constant load; square of 40 m, slit of 12 m under fluid
//            pressure that follows the crack: `hfrac lab centre-crack`, `pressurised-crack`. Default rock with
//            bond.fracture_toughness = 50 MPa m^0.5; beside it, strengths of 42.5 MPa. Radii 1.0, 0.50, 0.25, 0.125 m.
// Tolerance  Every size within 10 % of the mean of all sizes.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "lab_support.hpp"

namespace V8_toughness {

using namespace verification;

hfrac::Definition tough_rock() {
  hfrac::Definition def = new_def();
  def.bond_fracture_toughness = 50e6;
  return def;
}

using Sizes = std::vector<std::pair<int64_t, int>>;  // discs and packings

// 600 discs in 40 m x 60 m have a mean radius of 1.00 m.
void draw(const char* series, int64_t discs, const Sample& value) {
  Curves("V8", "K_Ic against the size of the discs; bars: one packing's spread",
         "mean radius (m),K_Ic (MPa m^0.5),K_Ic (MPa m^0.5)_spread")
      .point(series, {std::sqrt(600.0 / static_cast<double>(discs)), 1e-6 * value.mean, 1e-6 * value.spread});
}

void hold(const char* what, int32_t test, const Sizes& sizes) {
  std::vector<Sample> values;
  double mean = 0.0;
  for (const auto& [discs, packings] : sizes) {
    values.push_back(sample(tough_rock(), specimen(test, discs, 40.0), packings));
    std::printf("  %s, %lld discs, %d packings: K_Ic %.2f +- %.2f MPa m^0.5\n", what,
                static_cast<long long>(discs), packings, 1e-6 * values.back().mean,
                1e-6 * values.back().spread);
    draw(test == HFRAC_LAB_CENTRE_CRACK ? "centre crack; 50 asked for" : "pressurised slit; 50 asked for",
         discs, values.back());
    mean += values.back().mean / static_cast<double>(sizes.size());
  }
  for (const Sample& value : values) report(what, value.mean / mean, 1.0, 0.10);
  if (test == HFRAC_LAB_CENTRE_CRACK) {
    report("mean of all sizes against the K_Ic asked for, Pa m^0.5", mean, 50e6, 0.10);
  } else {
    std::printf("  mean of all sizes over the K_Ic asked for %.3f (why it is more: the page)\n", mean / 50e6);
  }
}

TEST(V8ToughnessSmoke, OfCoarseDiscsIsThatAskedFor) {
  const Sample value = sample(tough_rock(), specimen(HFRAC_LAB_CENTRE_CRACK, 600, 40.0), 12);
  report("centre crack, 600 discs: K_Ic, Pa m^0.5", value.mean, 50e6, 0.10);
}

TEST(V8Toughness, StaysWhenDiscsAreHalfAsLarge) {
  hold("centre crack over the mean of sizes", HFRAC_LAB_CENTRE_CRACK, {{600, 12}, {2400, 6}});
}

TEST(V8Toughness, WithoutItGoesWithTheRootOfTheDiscSize) {
  const Sample coarse = sample(new_def(), specimen(HFRAC_LAB_CENTRE_CRACK, 600, 40.0), 12),
               fine = sample(new_def(), specimen(HFRAC_LAB_CENTRE_CRACK, 2400, 40.0), 6);
  std::printf("  strengths as given: K_Ic %.1f and %.1f MPa m^0.5\n", 1e-6 * coarse.mean, 1e-6 * fine.mean);
  draw("strengths as given", 600, coarse);
  draw("strengths as given", 2400, fine);
  report("K_Ic of coarse over fine discs, strengths as given", coarse.mean / fine.mean, std::sqrt(2.0), 0.10);
}

TEST(V8ToughnessLong, HoldsOverAFactorOfEightInRadius) {
  hold("centre crack over the mean of sizes", HFRAC_LAB_CENTRE_CRACK,
       {{600, 16}, {2400, 8}, {9600, 4}, {38400, 1}});
}

TEST(V8ToughnessLong, HoldsForThePressureThatBreaksANotch) {
  hold("pressurised slit over the mean of sizes", HFRAC_LAB_PRESSURISED_CRACK,
       {{600, 16}, {2400, 6}, {9600, 2}, {38400, 1}});
}

}  // namespace V8_toughness
