// SPDX-License-Identifier: BSD-3-Clause
// A fracture of facets that ends at a joint across its way, in rock that does not break: what the two tests of V33 share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "flow/flow_solver.hpp"
#include "flow/joint_view.hpp"
#include "joint_model.hpp"
#include "step/simulation.hpp"

namespace verification::meeting {

constexpr double side = 100.0, junction = 55.0, middle = 50.0, stem = 20.0, arm = 10.0;  // m
constexpr double stress = 10e6, net = 1e6, pores = 5e6;                                  // Pa

constexpr int packings = 3;

inline JointOptions joint(double from, double to, double friction, double aperture) {
  constexpr double stiff = 1e12;  // Pa/m
  return plate_joint({junction, from}, {junction, to}, friction, stiff, aperture);
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
    double first = side, before = 0.0, last = 0.0;
    for (std::int64_t b = 0; b < a_.bond_count(); ++b) {
      const auto i = a_.first[b], j = a_.second[b];
      if ((a_.y[i] - middle) * (a_.y[j] - middle) >= 0.0 || a_.smooth.of(b) != nullptr) continue;
      const double x = a_.x[i] + (a_.x[j] - a_.x[i]) * (middle - a_.y[i]) / (a_.y[j] - a_.y[i]);
      if (x < junction - stem) before = std::max(before, x);
      if (x < junction - stem || x > junction) continue;
      first = std::min(first, x);
      if (e.mechanics->stays(b)) continue;  // else its disc would come loose
      last = std::max(last, x);
      e.mechanics->break_bond(b, m.cracks);
    }
    left_ = 0.5 * (before + first);
    short_of_ = junction - last;
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
  [[nodiscard]] double left() const { return left_; }          // m, of the stem
  [[nodiscard]] double short_of() const { return short_of_; }  // m, from its last bond to the joint
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
      all += std::abs(f.length);
      if (sim_.engine().facets.opening(a_, network(), f) > 0.0) open += std::abs(f.length);
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
    CaseDefinition definition = tight_rock(discs, seed, pores);
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
  double left_ = 0.0, short_of_ = 0.0;
  std::vector<std::int32_t> pressed_;  // pores
};

}  // namespace verification::meeting
