// SPDX-License-Identifier: BSD-3-Clause
// Random packings with natural fractures in rock that does not break and lets nothing through: what V23 and V24 share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "model.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace verification {

using namespace hfrac;

constexpr double normal_stiffness = 68e9, shear_stiffness = 23.8e9;  // N/m, of bonds and contacts

// 100 m x 100 m, no well, coupled quasi-static steps of any length. Pressure in the pores [Pa].
inline CaseDefinition tight_rock(std::int64_t discs, std::int64_t seed, double pore_pressure) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.packing_disc_count = discs;
  o.model_seed = seed;
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = normal_stiffness;
  o.contact_shear_stiffness = o.bond_shear_stiffness = shear_stiffness;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.fluid_formation_pressure = pore_pressure;
  o.fluid_viscosity = 1e-3;
  o.flow_permeability = 1e-24;
  o.flow_aperture_limit = 0.01;
  o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  o.stepping_mode = static_cast<std::int64_t>(SteppingMode::coupled);
  o.stepping_flow_step = 1e-9;
  return definition;
}

// The same packing without joints and fluid, to measure its modulus.
inline hfrac::Definition dry_rock(std::int64_t discs, std::int64_t seed) {
  hfrac::Definition def = new_def();
  def.packing_disc_count = discs;
  def.model_seed = seed;
  def.flow_scheme = 2;
  def.solver_kind = 1;
  def.contact_mode = 1;
  def.contact_normal_stiffness = def.bond_normal_stiffness = normal_stiffness;
  def.contact_shear_stiffness = def.bond_shear_stiffness = shear_stiffness;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  return def;
}

// A joint that conducts by a residual aperture [m] and no other; stiffness of both kinds [Pa/m].
inline JointOptions plate_joint(Vec2 from, Vec2 to, double friction, double stiffness, double aperture) {
  JointOptions joint;
  joint.x1 = from.x;
  joint.y1 = from.y;
  joint.x2 = to.x;
  joint.y2 = to.y;
  joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
  joint.friction = friction;
  joint.normal_stiffness = joint.shear_stiffness = stiffness;
  joint.residual_aperture = aperture;
  return joint;
}

// A joint at 45 degrees through the model's middle, and the overpressure that one of its pores is held at. No well: its hole would be as wide as
// the slip is long at first.
class DrivenJoint {
 public:
  DrivenJoint(hfrac::Simulation& sim, double middle, double over) : sim_(sim), middle_(middle) {
    sim.step();  // what set-up left of the slip
    for (const auto& c : contacts()) before_.push_back(sim.assembly().slip[c.bond]);
    const auto nearest = std::min_element(
        contacts().begin(), contacts().end(),
        [&](const auto& p, const auto& q) { return std::abs(along(p)) < std::abs(along(q)); });
    source_ = along(*nearest) - 0.5 * nearest->area;  // in one pore, so at the beginning of that contact
    Network& n = sim.engine().model.network;
    const auto left = n.left[nearest->bond], right = n.right[nearest->bond];
    const Vec2 way = n.centroid[right] - n.centroid[left];
    const auto inlet = way.x + way.y > 0.0 ? left : right;
    n.stiffness[inlet] = 0.0;
    n.pressure[inlet] = n.reference_pressure + over;
  }
  [[nodiscard]] const Array<SmoothContact>& contacts() const { return sim_.assembly().smooth.contacts; }
  // Of contact k: from that pore along the joint [m], and slip since then [m].
  [[nodiscard]] double at(std::size_t k) const { return along(contacts()[k]) - source_; }
  [[nodiscard]] double slip(std::size_t k) const {
    return std::abs(sim_.assembly().slip[contacts()[k].bond] - before_[k]);
  }

 private:
  [[nodiscard]] double along(const SmoothContact& c) const {
    const Assembly& a = sim_.assembly();
    const auto i = a.first[c.bond];
    return std::sqrt(0.5) * (a.x[i] + c.first_arm().x - middle_ + a.y[i] + c.first_arm().y - middle_);
  }
  hfrac::Simulation& sim_;
  double middle_, source_ = 0.0;
  std::vector<double> before_;
};

}  // namespace verification
