// SPDX-License-Identifier: BSD-3-Clause
// V7  A crack held open by a uniform fluid pressure.
//
// Formula    w(x) = 4 p a / E' sqrt(1 - x^2 / a^2), area of the opening 2 pi p a^2 / E', for a crack of half length a in a plate
//            without end. E' is the slope of the two-dimensional model.
// Source     Sneddon (1946), Proc. R. Soc. A 187; Sneddon and Lowengrub (1969).
// Set-up     Linear rock (contacts only after a break), square of 5 crack lengths, slit in the middle: `hfrac lab
//            pressurised-crack`. The pores that touch the slit are at 1 % of the pressure at failure, all others drained. E' by
//            `hfrac lab elastic` on the same packing. Opening of each bond cut, averaged over tenths of the slit.
// Tolerance  -4 to +13 % (section 6 of the physics study), held to 13 % either way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab_support.hpp"

namespace {

using namespace verification;

struct Errors {
  double area, middle, profile;  // relative; the profile's is rms over its largest value
};

// Openings of all packings together, each over its own p, a and E'.
Errors measure(int64_t discs, int packings) {
  constexpr int bins = 10;
  double sum[bins] = {}, count[bins] = {};
  for (int64_t seed = 1; seed <= packings; ++seed) {
    hfrac_lab_spec spec = specimen(HFRAC_LAB_PRESSURISED_CRACK, discs, 100.0);
    spec.slit_share = 0.2;
    spec.seed = seed;
    const Lab crack(linear_rock(), spec);
    spec.test = HFRAC_LAB_ELASTIC;
    const double modulus = Lab(linear_rock(), spec).report().plane_modulus;
    const double a = crack.report().slit_half_length;
    const auto rows = crack.table(HFRAC_LAB_OPENING);
    for (std::size_t k = 0; k + 3 <= rows.size(); k += 3) {
      const int bin = std::clamp(static_cast<int>((rows[k] / a + 1.0) * 0.5 * bins), 0, bins - 1);
      sum[bin] += rows[k + 1] * modulus / (4.0 * rows[k + 2] * a);
      count[bin] += 1.0;
    }
  }
  Errors e{0.0, 0.0, 0.0};
  std::printf("  %lld discs, %d packings; opening over 4 p a / E':\n", static_cast<long long>(discs),
              packings);
  for (int bin = 0; bin < bins; ++bin) {
    const double low = -1.0 + 2.0 * bin / bins, high = low + 2.0 / bins;
    const auto integral = [](double s) {
      return 0.5 * (s * std::sqrt(std::max(0.0, 1.0 - s * s)) + std::asin(std::clamp(s, -1.0, 1.0)));
    };
    const double analytic = (integral(high) - integral(low)) / (high - low), measured = sum[bin] / count[bin];
    std::printf("    x/a %+.1f to %+.1f: %.3f, formula %.3f\n", low, high, measured, analytic);
    e.area += measured * (high - low) / (0.5 * pi);
    e.profile += (measured - analytic) * (measured - analytic) / bins;
    if (bin == bins / 2 || bin == bins / 2 - 1) e.middle += 0.5 * measured / analytic;
  }
  e.area -= 1.0;
  e.middle -= 1.0;
  e.profile = std::sqrt(e.profile);
  std::printf("    area %+.1f %%, middle %+.1f %%, profile rms %.1f %% of its largest\n", 100.0 * e.area,
              100.0 * e.middle, 100.0 * e.profile);
  return e;
}

void hold(const Errors& e) {
  report("area of the opening over Sneddon's", 1.0 + e.area, 1.0, 0.13);
  report("opening in the middle over Sneddon's", 1.0 + e.middle, 1.0, 0.13);
  EXPECT_LT(e.profile, 0.13);
}

TEST(V7Sneddon, ACrackOpensAsTheFormulaSays) {
  hold(measure(2000, 4));
}

TEST(V7SneddonLong, FinerDiscsDoToo) {
  hold(measure(8000, 2));
}

}  // namespace
