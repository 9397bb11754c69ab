// SPDX-License-Identifier: BSD-3-Clause
// V33  A hydraulic fracture meets a natural one: what each holds and takes. Stress at its tip: V33_tip_test.cpp.
//
// Formula    T: a fracture of facets (the stem) ends in the middle of a joint without friction (the arms), with one pressure above the stress in
//            both: openings by displacement discontinuities in rock without end (Crouch and Starfield 1983). By symmetry both arms hold as much.
//            T by flow: at rest and steady, an arm of hydraulic aperture w and length L takes w^3 / (12 eta L) of the pressure at the junction (parallel conductances).
// Set-up     Random packings of 100 m, stress by a load, tight rock that does not break, pores that drain; stem of 20 m along x, joint of 20 m across.
//            T: 10 MPa all round, 1 MPa more in stem and arms. T by flow: 30 MPa across two joints that end at the stem's end and stay closed, one of 0.15 mm
//            whose pressure is held 12 m off, one of 0.2 mm and 18 m; the stem is opened as before, then fluid goes in at its far end and rock stands still.
//            E' is measured on each packing without joint.
// Measured   T: volume of stem and arms over the formula's; the arms' over each other. T by flow: the upper arm's share of what both take, over the hand's.
// Tolerance  Means of three packings of 10 000 discs: volumes 10 %, the arms' difference 10 % of their mean. Share by flow: 10 % in each packing.
// Page       docs/verification/V33.md
#include <cmath>
#include <string>
#include <vector>

#include "displacement_discontinuity.hpp"
#include "meeting_model.hpp"
#include "support.hpp"

namespace V33_meeting {

using namespace hfrac;
using namespace verification::meeting;

double modulus(std::int64_t discs, std::int64_t seed) {
  return verification::elasticity(verification::dry_rock(discs, seed), 10e6).modulus;
}

struct Volumes {
  double stem, upper, lower;  // m2, or over the formula's
};

// Volumes of a T under 1 Pa where E' is 1 Pa [m2].
Volumes formula(double left) {
  std::vector<verification::JumpElement> elements;
  constexpr int count = 80;
  const double length = junction - left;
  verification::add_elements(elements, junction - 0.5 * length, 0.0, 0.0, length, count);
  verification::add_elements(elements, junction, 0.0, 0.5 * verification::pi, 2.0 * arm, count);
  const Eigen::MatrixXd a = verification::influences(elements);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(a.rows());
  for (Eigen::Index k = 1; k < a.rows(); k += 2) right[k] = -1.0;
  const Eigen::VectorXd jump = a.partialPivLu().solve(right);
  Volumes v{};
  for (int k = 0; k < 2 * count; ++k) {
    const double part = 2.0 * elements[static_cast<std::size_t>(k)].half * std::abs(jump[2 * k + 1]);
    (k < count ? v.stem : elements[static_cast<std::size_t>(k)].y > 0.0 ? v.upper : v.lower) += part;
  }
  return v;
}

Volumes open_t(std::int64_t discs, std::int64_t seed) {
  Meeting meeting(discs, seed, stress, 0.0);
  meeting.press_joint_too();
  meeting.press(1.0);
  Volumes v{meeting.stem_volume(), 0.0, 0.0};
  for (const auto& c : meeting.assembly().smooth.contacts)
    (meeting.along(c) > 0.0 ? v.upper : v.lower) += c.area * std::max(0.0, meeting.view(c).opening);
  const Volumes expected = formula(meeting.left());
  const double unit = net / modulus(discs, seed);
  v.stem /= unit * expected.stem;
  v.upper /= unit * expected.upper;
  v.lower /= unit * expected.lower;
  std::printf(
      "  %lld discs, packing %lld, arm = %.0f R: stem %.3f, upper arm %.3f, lower arm %.3f of the "
      "formula's\n",
      static_cast<long long>(discs), static_cast<long long>(seed), arm / meeting.assembly().mean_radius,
      v.stem, v.upper, v.lower);
  std::fflush(stdout);
  return v;
}

struct Arm {
  double length, aperture;  // m; to where its pressure is held
  [[nodiscard]] double conducts(double to) const { return aperture * aperture * aperture / to; }
};

// Share that the upper arm takes of what comes through the stem, over the hand's.
double share_by_flow(std::int64_t discs, std::int64_t seed) {
  constexpr Arm arms[2] = {{12.0, 1.5e-4}, {18.0, 2e-4}};
  constexpr double beyond = 2.0, across = 30e6, friction = 10.0;  // m, Pa
  Meeting meeting(discs, seed, across,
                  {joint(middle, middle + arms[0].length + beyond, friction, arms[0].aperture),
                   joint(middle - arms[1].length - beyond, middle, friction, arms[1].aperture)});
  meeting.press(1.0);
  const Network& n = meeting.network();
  double at[2] = {}, taken[2] = {}, conducts[2] = {};
  std::int32_t end[2] = {-1, -1};
  for (const auto& c : meeting.assembly().smooth.contacts) {
    const auto k = static_cast<std::size_t>(c.joint);
    const double from_junction =
        std::abs(meeting.along(c)) - 0.5 * c.area;  // where the contact's piece begins
    if (end[k] >= 0 && std::abs(from_junction - arms[k].length) > std::abs(at[k] - arms[k].length)) continue;
    const bool left =
        std::abs(n.centroid[n.left[c.bond]].y - middle) < std::abs(n.centroid[n.right[c.bond]].y - middle);
    at[k] = from_junction;
    end[k] = left ? n.left[c.bond] : n.right[c.bond];
  }
  meeting.feed_from_the_far_end();
  for (const auto pore : end) meeting.hold(pore, pores);
  meeting.flow();
  for (std::size_t k = 0; k < 2; ++k) {
    conducts[k] = arms[k].conducts(at[k]);
    for (std::size_t e = 0; e < n.left.size(); ++e)
      if ((n.left[e] == end[k]) != (n.right[e] == end[k]))
        taken[k] += n.right[e] == end[k] ? n.flow[e] : -n.flow[e];
  }
  const double found = taken[0] / (taken[0] + taken[1]), hand = conducts[0] / (conducts[0] + conducts[1]);
  std::printf(
      "  %lld discs, packing %lld: flow %.3e and %.3e m2/s, the upper arm's share %.3f, by hand %.3f\n",
      static_cast<long long>(discs), static_cast<long long>(seed), taken[0], taken[1], found, hand);
  std::fflush(stdout);
  return found / hand;
}

void hold_t(std::int64_t discs) {
  double in_stem = 0.0, in_arms = 0.0, uneven = 0.0;
  for (int seed = 1; seed <= packings; ++seed) {
    const Volumes v = open_t(discs, seed);
    in_stem += v.stem / packings;
    in_arms += 0.5 * (v.upper + v.lower) / packings;
    uneven += 2.0 * (v.upper - v.lower) / (v.upper + v.lower) / packings;
  }
  const std::string name = std::to_string(discs) + " discs: T, ";
  verification::report(name + "volume of the stem over the formula's", in_stem, 1.0, 0.10);
  verification::report(name + "volume of the arms over the formula's", in_arms, 1.0, 0.10);
  verification::report_absolute(name + "upper arm less lower one, over their mean", uneven, 0.0, 0.10);
}

TEST(V33MeetingFlow, EachArmOfATTakesItsShareByFlow) {
  for (int seed = 1; seed <= packings; ++seed)
    verification::report(
        "T by flow, packing " + std::to_string(seed) + ": the upper arm's share over the hand's",
        share_by_flow(10000, seed), 1.0, 0.10);
}

TEST(V33MeetingSmoke, OpensAsAT) {
  const Volumes v = open_t(3000, 1);
  verification::report("T, volume of the stem over the formula's", v.stem, 1.0, 0.2);
  verification::report("T, volume of the arms over the formula's", 0.5 * (v.upper + v.lower), 1.0, 0.2);
}

TEST(V33Meeting, OpensAsAT) {
  hold_t(10000);
}

}  // namespace V33_meeting
