// SPDX-License-Identifier: BSD-3-Clause
// V21  Smooth joints: a plane of weakness under biaxial load.
//
// Formula    Jaeger (1959), Geol. Mag. 96: a plane without cohesion whose normal stands at the angle beta to sigma_1 slips at
//            sigma_1 = sigma_3 (1 + mu tan beta) / (1 - mu cot beta), and not at all where tan beta <= mu.
// Set-up     Dry blocks of 100 m that do not break, sigma_3 along y. A joint right through under the angle 90 degrees - beta to x:
//            sigma_1 is raised until there is no equilibrium any more. Random and square packing, quasi-static solver.
// Tolerance  3 % of what the load on the packing's outline asks for (outline() below); beyond 10 sigma_3 counts as never
// Page       docs/verification/V21.md
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../joint_def.hpp"
#include "support.hpp"

namespace V21_smooth_joint {

using namespace verification;

constexpr double side = 100.0, sigma_3 = 10e6, most = 10.0;  // m, Pa, of sigma_3

hfrac_joint_def line(double degrees, double half, double friction) {
  const double c = half * std::cos(degrees * pi / 180.0), s = half * std::sin(degrees * pi / 180.0);
  return joint_def(0.5 * side - c, 0.5 * side - s, 0.5 * side + c, 0.5 * side + s, 1.0, 1.0, friction,
                   HFRAC_JOINT_SMOOTH_BROKEN);
}

hfrac::Definition block(int64_t discs, bool square) {
  hfrac::Definition def = new_def();
  def.model_width = def.model_height = side;
  def.packing_disc_count = discs;
  def.packing_method = square ? 3 : 0;
  def.flow_scheme = 2;
  def.solver_kind = 1;
  def.contact_mode = 1;
  def.bond_normal_stiffness = 16e9;
  def.bond_shear_stiffness = square ? 16e9 : 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = sigma_3;
  return def;
}

// The outline of a packing has corners: the load on either half ends in the middles of the outermost two bonds that the joint cuts.
// Statics of a half under it: sigma_1 / sigma_3 = (tan phi / tan psi) Jaeger's, phi the joint's angle, psi that of the line between
// those middles. Returned is tan phi / tan psi.
double outline(Simulation& sim, double degrees) {
  const auto place = sim.values(HFRAC_DISC_POSITION);
  const auto discs = sim.indices(HFRAC_BOND_DISCS);
  const double c = std::cos(degrees * pi / 180.0), s = std::sin(degrees * pi / 180.0);
  double low = 1e300, high = -1e300, dx = 0.0, dy = 0.0;
  std::array<double, 2> first{}, last{};
  for (std::size_t e = 0; e < discs.size(); e += 2) {
    const auto i = 2 * static_cast<std::size_t>(discs[e]), j = 2 * static_cast<std::size_t>(discs[e + 1]);
    const auto side_of = [&](std::size_t k) {
      return c * (place[k + 1] - 0.5 * side) - s * (place[k] - 0.5 * side) > 0.0;
    };
    if (side_of(i) == side_of(j)) continue;
    const std::array<double, 2> middle{0.5 * (place[i] + place[j]), 0.5 * (place[i + 1] + place[j + 1])};
    const double along = c * middle[0] + s * middle[1];
    if (along < low) first = middle;
    if (along > high) last = middle;
    low = std::min(low, along);
    high = std::max(high, along);
  }
  dx = last[0] - first[0];
  dy = last[1] - first[1];
  return s * dx / (c * dy);
}

// sigma_1 over sigma_3 at which the joint gives way; `most` if it bears that.
double strength(const hfrac_sim_def& given, double degrees, double friction, double& turned) {
  hfrac::Definition def = given;
  hfrac_sim_def_set_i64(&def, "joint_count", 1);
  def.joints[0] = line(degrees, side, friction);
  Simulation sim(def);
  turned = outline(sim, degrees);
  const auto holds = [&](double ratio) {
    sim.set_far_field(ratio * sigma_3, sigma_3);
    try {
      sim.step(1);
    } catch (const std::runtime_error&) {
      return false;  // no equilibrium; the state before the step stands
    }
    return true;
  };
  double bears = 1.0, gives = 0.0;
  while (gives == 0.0 && bears < most)
    (holds(std::min(most, 1.15 * bears)) ? bears : gives) = std::min(most, 1.15 * bears);
  while (gives > 0.0 && gives > 1.005 * bears) {
    const double between = std::sqrt(bears * gives);
    (holds(between) ? bears : gives) = between;
  }
  return gives > 0.0 ? std::sqrt(bears * gives) : most;
}

double jaeger(double degrees, double friction) {
  const double beta = (90.0 - degrees) * pi / 180.0;
  const double bottom = std::sin(beta) - friction * std::cos(beta);
  if (bottom <= 0.0 || degrees == 0.0) return most;
  return std::min(most, (1.0 + friction * std::tan(beta)) / (1.0 - friction / std::tan(beta)));
}

void compare(bool square, int64_t discs, const std::vector<double>& angles) {
  constexpr double friction = 0.5;
  const char* packing = square ? "square" : "random";
  Curves curves("V21", "Strength of a block with a smooth joint, friction 0.5",
                "angle from sigma_1,sigma_1 over sigma_3");
  static bool drawn = false;  // one line for all packings
  if (!drawn) {
    curves.line("Jaeger (1959)", 4.0, 60.0,
                [](double degrees) { return std::vector<double>{jaeger(degrees, 0.5)}; });
  }
  drawn = true;
  for (const double degrees : angles) {
    double turned = 1.0;
    const double measured = strength(block(discs, square), degrees, friction, turned),
                 plane = jaeger(degrees, friction);
    const double expected = plane < most ? turned * plane : most;
    if (plane < most)
      std::printf("    Jaeger alone %.4f, error %+.2e; the outline's share %.4f\n", plane,
                  measured / plane - 1.0, turned);
    curves.point(std::string(packing) + " packing", {degrees, plane < most ? measured / turned : measured});
    const std::string name = std::string("sigma_1 over sigma_3, ") + packing + ", joint at " +
                             std::to_string(static_cast<int>(degrees)) + " degrees";
    report(name.c_str(), measured, expected, 0.03);
  }
}

TEST(V21SmoothJointSmoke, GivesWayWhereItsPlaneSays) {
  compare(false, 500, {20.0, 40.0});
}

TEST(V21SmoothJoint, IsCoulombsInARandomPacking) {
  compare(false, 1500, {10.0, 30.0, 45.0, 90.0});
}

TEST(V21SmoothJointLong, IsCoulombsAtAllAnglesInARandomPacking) {
  compare(false, 3000, {0.0, 5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 55.0, 70.0, 90.0});
}

TEST(V21SmoothJointLong, IsCoulombsAtAllAnglesInASquarePacking) {
  compare(true, 3600, {0.0, 5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 55.0, 70.0, 90.0});
}

}  // namespace V21_smooth_joint
