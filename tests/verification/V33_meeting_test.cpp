// SPDX-License-Identifier: BSD-3-Clause
// V33  A hydraulic fracture meets a natural one.
//
// Formula    T: a fracture of facets (the stem) ends in the middle of a joint without friction (the arms), with one pressure above the stress in
//            both: openings by displacement discontinuities in rock without end (Crouch and Starfield 1983). By symmetry both arms hold as much.
//            T by flow: at rest and steady, an arm of hydraulic aperture w and length L takes w^3 / (12 eta L) of the pressure at the junction (parallel conductances).
//            Tip: the stress on an interface that does not slip, across the tip of a pressurised crack, by Westergaard (1939): z = a + i y,
//            Z = z / sqrt(z^2 - a^2) - 1, sigma_xx = p (Re Z - y Im Z'), tau = -p y Re Z'; what criteria of crossing compare with friction.
// Set-up     Random packings of 100 m, stress by a load, tight rock that does not break, pores that drain; stem of 20 m along x, joint of 20 m across.
//            T: 10 MPa all round, 1 MPa more in stem and arms. T by flow: 30 MPa across two joints that end at the stem's end and stay closed, one of 0.15 mm
//            whose pressure is held 12 m off, one of 0.2 mm and 18 m; the stem is opened as before, then fluid goes in at its far end and rock stands still. Tip: 12 MPa across the joint, whose friction is 10, 1 MPa more than 10 MPa
//            in the stem. Tip, once open: 16 MPa across the joint; from 1 to 2 MPa more in the stem, whose faces touch no more. The stem that is shut bears 10 MPa, which
//            differ from place to place by as much as the net pressure is (V23: 8 to 16 % over 8 R), and opening it takes all that away; a rise of pressure in an open one knows nothing of it. E' is measured on each packing without joint.
// Measured   T: volume of stem and arms over the formula's; the arms' over each other. T by flow: the upper arm's share of what both take, over the hand's. Tip: at the joint's contacts between 2 and 10 R from the tip, shear by
//            least squares over the formula's, and the mean change of normal stress less the formula's, over the net pressure.
// Tolerance  Means of three packings of 10 000 discs: volumes 10 %, the arms' difference 10 % of their mean, shear 15 %;
//            normal stress is told only. Once the stem is open: change of normal stress within 15 % of the rise, shear 15 %. Share by flow: 10 % in each packing.
// Page       docs/verification/V33.md
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "displacement_discontinuity.hpp"
#include "flow/flow_solver.hpp"
#include "flow/joint_view.hpp"
#include "joint_model.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V33_meeting {

using namespace hfrac;

constexpr double side = 100.0, junction = 55.0, middle = 50.0, stem = 20.0, arm = 10.0;  // m
constexpr double stress = 10e6, net = 1e6, pores = 5e6;                                  // Pa

JointOptions joint(double from, double to, double friction, double aperture) {
  constexpr double stiff = 1e12;  // Pa/m
  return verification::plate_joint({junction, from}, {junction, to}, friction, stiff, aperture);
}

// A model with a stem whose bonds are broken, and a joint across its right end.
class Meeting {
 public:
  Meeting(std::int64_t discs, std::int64_t seed, double across, double friction)
      : Meeting(discs, seed, across, std::vector{joint(middle - arm, middle + arm, friction, 1e-3)}) {}
  Meeting(std::int64_t discs, std::int64_t seed, double across, std::vector<JointOptions> joints)
      : sim_(definition(discs, seed, across, std::move(joints)), {}, {}), a_(sim_.assembly()) {
    Engine& e = sim_.engine();
    Model& m = e.model;
    double first = side, before = 0.0;
    for (std::int64_t b = 0; b < a_.bond_count(); ++b) {
      const auto i = a_.first[b], j = a_.second[b];
      if ((a_.y[i] - middle) * (a_.y[j] - middle) >= 0.0 || a_.smooth.of(b) != nullptr) continue;
      const double x = a_.x[i] + (a_.x[j] - a_.x[i]) * (middle - a_.y[i]) / (a_.y[j] - a_.y[i]);
      if (x < junction - stem) before = std::max(before, x);
      if (x < junction - stem || x > junction) continue;
      first = std::min(first, x);
      if (!e.mechanics->stays(b)) e.mechanics->break_bond(b, m.cracks);  // else its disc would come loose
    }
    left_ = 0.5 * (before + first);
    e.facets.update(a_, m.network);
    for (const Facet& f : facets()) pressed_.insert(pressed_.end(), {f.left, f.right});
  }
  void press_joint_too() {
    for (const auto& c : a_.smooth.contacts)
      pressed_.insert(pressed_.end(), {network().left[c.bond], network().right[c.bond]});
  }
  // In steps of that length [s]: at once, some packings find no equilibrium. Pressures less the stress across the stem [Pa].
  void press(double duration,
             const std::vector<double>& pressures = {-0.1 * stress, 0.25 * net, 0.5 * net, 0.75 * net, net}) {
    for (const double more : pressures) {
      for (const auto d : pressed_) {
        network().stiffness[d] = 0.0;
        network().pressure[d] = stress + more;
      }
      sim_.step(sim_.loads(), duration);
    }
  }
  // Lets go of the pores of the stem but for the one at its far end.
  void feed_from_the_far_end() {
    const auto at = [&](const Facet& f) {
      return network().centroid[f.left].x + network().centroid[f.right].x;
    };
    const auto far = *std::min_element(facets().begin(), facets().end(),
                                       [&](const Facet& f, const Facet& g) { return at(f) < at(g); });
    const bool left = network().centroid[far.left].x < network().centroid[far.right].x;
    for (const auto d : pressed_) network().stiffness[d] = any_stiffness;
    hold(left ? far.left : far.right, stress + net);
  }
  void hold(std::int32_t pore, double pressure) {
    network().stiffness[pore] = 0.0;
    network().pressure[pore] = pressure;
  }
  // Steady flow while the rock stands still.
  void flow() {
    FlowSolver solver(network(), sim_.options());
    const std::vector<double> source(static_cast<std::size_t>(network().domain_count()), 0.0);
    for (int k = 0; k < 3; ++k) solver.advance(network(), long_time, source);
  }
  [[nodiscard]] const std::vector<Facet>& facets() { return sim_.engine().facets.all(); }
  [[nodiscard]] Network& network() { return sim_.engine().model.network; }
  [[nodiscard]] const Assembly& assembly() const { return a_; }
  [[nodiscard]] double left() const { return left_; }  // m, of the stem
  [[nodiscard]] double stem_volume() {
    double volume = 0.0;
    for (const Facet& f : facets())
      volume += f.length * std::max(0.0, sim_.engine().facets.opening(a_, network(), f));
    return volume;
  }
  // Of its length.
  [[nodiscard]] double open_share() {
    double all = 0.0, open = 0.0;
    for (const Facet& f : facets()) {
      all += f.length;
      if (sim_.engine().facets.opening(a_, network(), f) > 0.0) open += f.length;
    }
    return open / all;
  }
  [[nodiscard]] JointView view(const SmoothContact& c) { return view_joint(a_, network(), c); }
  [[nodiscard]] double along(const SmoothContact& c) const {
    return a_.y[a_.first[c.bond]] + c.first_arm().y - middle;
  }

 private:
  static CaseDefinition definition(std::int64_t discs, std::int64_t seed, double across,
                                   std::vector<JointOptions> joints) {
    CaseDefinition definition = verification::tight_rock(discs, seed, pores);
    Options& o = definition.options;
    o.stress_sigma_Hmax = across;
    o.stress_sigma_hmin = stress;
    o.fluid_bulk_modulus = 1e6;
    o.fracture_law = static_cast<std::int64_t>(FractureLaw::facet);
    definition.joints = std::move(joints);
    return definition;
  }
  static constexpr double any_stiffness = 1e9, long_time = 1e9;  // Pa/m2, s: what is steady knows neither
  hfrac::Simulation sim_;
  const Assembly& a_;
  double left_ = 0.0;
  std::vector<std::int32_t> pressed_;  // pores
};

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

struct OnInterface {
  double normal,
      shear;  // less the formula's, over the net pressure (the formula goes through 0 there); over the formula's
};

using Views = std::vector<JointView>;

Views views_of(Meeting& meeting) {
  Views views;
  for (const auto& c : meeting.assembly().smooth.contacts) views.push_back(meeting.view(c));
  return views;
}

// Between two states whose pressures in the stem differ by the net pressure.
OnInterface change_of_stress(Meeting& meeting, const Views& before, const Views& after) {
  constexpr double from = 2.0, to = 10.0;  // R
  const auto& contacts = meeting.assembly().smooth.contacts;
  const double a = 0.5 * (junction - meeting.left()), radius = meeting.assembly().mean_radius;
  double normal[2] = {}, shear[2] = {};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double y = meeting.along(contacts[k]);
    if (std::abs(y) < from * radius || std::abs(y) > to * radius) continue;
    const std::complex<double> z{a, y}, root = std::sqrt(z - a) * std::sqrt(z + a), z0 = z / root - 1.0,
                                        slope = -a * a / (root * root * root);
    const double pulls = net * (z0.real() - y * slope.imag()), tau = -net * y * slope.real();
    const double area = contacts[k].area;
    normal[0] += area * (before[k].normal_stress - after[k].normal_stress - pulls) / net;
    normal[1] += area;
    shear[0] += area * (after[k].shear_stress - before[k].shear_stress) * tau;
    shear[1] += area * tau * tau;
  }
  return {normal[0] / normal[1], std::abs(shear[0] / shear[1])};
}

struct AtTip {
  OnInterface opens, opened;  // from a stem that is shut to the net pressure; from there to twice that
};

AtTip stress_at_tip(std::int64_t discs, std::int64_t seed, double across) {
  constexpr double sticks = 10.0, at_once = 1e-9;  // 1, s: so short that no fluid flows into the joint
  Meeting meeting(discs, seed, across, sticks);
  const Views shut = views_of(meeting);
  meeting.press(at_once);
  const Views once = views_of(meeting);
  const double open = meeting.open_share();
  meeting.press(at_once, {1.5 * net, 2.0 * net});
  const AtTip found{change_of_stress(meeting, shut, once),
                    change_of_stress(meeting, once, views_of(meeting))};
  std::printf(
      "  %lld discs, packing %lld, %.0f MPa across the joint: normal stress off by %+.3f of the net "
      "pressure, shear %.3f of the "
      "formula's; once open (%.0f %% of the stem): %+.3f, %.3f\n",
      static_cast<long long>(discs), static_cast<long long>(seed), 1e-6 * across, found.opens.normal,
      found.opens.shear, 100.0 * open, found.opened.normal, found.opened.shear);
  std::fflush(stdout);
  return found;
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

constexpr int packings = 3;

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

// Means of packings.
AtTip tip_of(std::int64_t discs, int last, double across) {
  AtTip mean{};
  for (int seed = 1; seed <= last; ++seed) {
    const AtTip found = stress_at_tip(discs, seed, across);
    for (auto part : {&AtTip::opens, &AtTip::opened}) {
      (mean.*part).normal += (found.*part).normal / last;
      (mean.*part).shear += (found.*part).shear / last;
    }
  }
  return mean;
}

// Across the joint [Pa], in which the fluid of the stem's end is still shut at twice the net pressure.
constexpr double shuts = 16e6;

void hold_once_open(std::int64_t discs) {
  constexpr double tolerance = 0.15;
  const AtTip mean = tip_of(discs, packings, shuts);
  const std::string name = std::to_string(discs) + " discs: tip, stem open, ";
  verification::report_absolute(name + "normal stress less the formula's, over the rise", mean.opened.normal,
                                0.0, tolerance);
  verification::report(name + "shear on the interface over the formula's", mean.opened.shear, 1.0, tolerance);
}

void hold_tip(std::int64_t discs) {
  const AtTip mean = tip_of(discs, packings, 12e6);
  std::printf("  tip, normal stress off by %.3f of the net pressure in the mean; 0.15 wanted, not held\n",
              mean.opens.normal);
  verification::report(std::to_string(discs) + " discs: tip, shear on the interface over the formula's",
                       mean.opens.shear, 1.0, 0.15);
  hold_once_open(discs);
}

TEST(V33MeetingFlow, EachArmOfATTakesItsShareByFlow) {
  for (int seed = 1; seed <= 3; ++seed)
    verification::report(
        "T by flow, packing " + std::to_string(seed) + ": the upper arm's share over the hand's",
        share_by_flow(10000, seed), 1.0, 0.10);
}

TEST(V33MeetingSmoke, OpensAsAT) {
  const Volumes v = open_t(3000, 1);
  verification::report("T, volume of the stem over the formula's", v.stem, 1.0, 0.2);
  verification::report("T, volume of the arms over the formula's", 0.5 * (v.upper + v.lower), 1.0, 0.2);
}

TEST(V33Meeting, OpensAsATAndStressesTheInterfaceAsATip) {
  hold_t(10000);
  hold_tip(10000);
}

// What the scatter of packings is, and what the size of the discs.
TEST(V33MeetingLong, StressesTheInterfaceAsATipWithFinerDiscs) {
  tip_of(10000, 6, shuts);
  hold_once_open(20000);
}

}  // namespace V33_meeting
