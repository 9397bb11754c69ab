// SPDX-License-Identifier: BSD-3-Clause
// V25  A natural fracture that fluid presses open.
//
// Formula    Sneddon (1946): in rock without end a pressure p above the stress across it opens a crack of half length c to
//            4 p / E' sqrt(c^2 - x^2), E' = E / (1 - nu^2) (Crouch and Starfield 1983 for the same in a plate); its volume is 2 pi p c^2 / E'.
// Set-up     Random packings of 100 m under 25 MPa all round, pores at 10 MPa; a joint of 20 m at 30 degrees, closed, nearly stiff, that conducts;
//            1 MPa above the stress in all of its pores: 16 MPa more than at first, sixteen times what opens it. Quasi-static
//            solver. E' is measured on the packing without the joint, whose pores are drained (the fluid gives).
// Measured   volume over the formula's, and the root mean square of what the contacts' openings are off the formula's, over its largest.
// Tolerance  Volume, mean of three packings: 10 % at c = 20 R and finer; openings of each packing 12 % of the largest.
// Page       docs/verification/V25.md
#include <cmath>
#include <string>

#include "flow/joint_view.hpp"
#include "joint_model.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V25_joint_opening {

using namespace hfrac;

constexpr double side = 100.0, half = 10.0, stress = 25e6, pores = 10e6, above = 1e6;  // m, Pa

double plane_modulus(std::int64_t discs, std::int64_t seed) {
  return verification::elasticity(verification::dry_rock(discs, seed), 10e6).modulus;
}

struct Opened {
  double volume, off;  // over the formula's; rms over the formula's largest opening
};

Opened press(std::int64_t discs, std::int64_t seed) {
  CaseDefinition definition = verification::tight_rock(discs, seed, pores);
  Options& o = definition.options;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = stress;
  o.fluid_bulk_modulus = 1e6;
  const double turn = verification::pi / 6.0;
  const Vec2 along{std::cos(turn), std::sin(turn)}, middle{0.5 * side, 0.5 * side};
  constexpr double friction = 0.6, stiff = 1e12, aperture = 1e-3;  // 1, Pa/m, m
  definition.joints = {
      verification::plate_joint(middle - half * along, middle + half * along, friction, stiff, aperture)};
  Simulation sim(definition, {}, {});
  const Assembly& a = sim.assembly();
  Network& n = sim.engine().model.network;
  for (const auto& c : a.smooth.contacts) {
    for (const auto d : {n.left[c.bond], n.right[c.bond]}) {
      n.stiffness[d] = 0.0;
      n.pressure[d] = stress + above;
    }
  }
  sim.step(sim.loads(), 1.0);
  const double modulus = plane_modulus(discs, seed), largest = 4.0 * above / modulus * half;
  double volume = 0.0, squares = 0.0, length = 0.0;
  for (const auto& c : a.smooth.contacts) {
    const auto i = a.first[c.bond];
    const double x = dot(Vec2{a.x[i], a.y[i]} + c.first_arm() - middle, along);
    const double opening = std::max(0.0, view_joint(a, n, c).opening);
    volume += c.area * opening;
    squares +=
        c.area * std::pow(opening / largest - std::sqrt(std::max(0.0, 1.0 - x * x / (half * half))), 2);
    length += c.area;
  }
  const Opened found{volume / (0.5 * verification::pi * half * largest), std::sqrt(squares / length)};
  std::printf("  %lld discs, packing %lld, c = %.0f R: volume %.3f, openings off by %.3f rms\n",
              static_cast<long long>(discs), static_cast<long long>(seed), half / a.mean_radius, found.volume,
              found.off);
  std::fflush(stdout);
  return found;
}

void hold(std::int64_t discs, double tolerance) {
  double mean = 0.0;
  constexpr int packings = 3;
  for (int seed = 1; seed <= packings; ++seed) {
    const Opened found = press(discs, seed);
    mean += found.volume / packings;
    verification::report_absolute("openings, rms off the formula's, packing " + std::to_string(seed),
                                  found.off, 0.0, 0.12);
  }
  verification::report("volume, mean of three packings", mean, 1.0, tolerance);
}

TEST(V25JointOpeningSmoke, OpensAsACrack) {
  const Opened found = press(4000, 1);
  verification::report("volume over the formula's", found.volume, 1.0, 0.2);
}

TEST(V25JointOpening, OpensAsACrackInThreePackings) {
  hold(10000, 0.10);
}

TEST(V25JointOpeningLong, NearsTheFormulaWithFinerDiscs) {
  hold(40000, 0.10);
}

}  // namespace V25_joint_opening
