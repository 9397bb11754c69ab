// SPDX-License-Identifier: BSD-3-Clause
// The books of a simulation: energy and fluid balance, state hash, and the state kept to undo a failed step.
#include <algorithm>
#include <cmath>

#include "core/hash.hpp"
#include "couple/simulation.hpp"
#include "options/choices.hpp"

namespace hfrac {

std::vector<WellPlace> Simulation::well_places() const {
  std::vector<WellPlace> places;
  for (const auto& well : wells_) places.push_back(well.place);
  return places;
}

void Simulation::elastic_energy(double& bonds, double& contacts) const {
  bonds = 0.0;
  contacts = boundary_->walled() ? boundary_->wall_energy(assembly_) : 0.0;
  for (std::int64_t e = 0; e < assembly_.bond_count(); ++e) {
    const BondView view = view_bond(assembly_, options(), e);
    bonds += view.bond_energy;
    contacts += view.contact_energy;
  }
  contacts += solver_->loose_contacts().energy();
}

// Works of fluid and far field = change of stored energy + what was dissipated + what breaking bonds took along.
Balance Simulation::balance() const {
  Balance b{};
  double bonds = 0.0, contacts = 0.0;
  elastic_energy(bonds, contacts);
  const Energies& e = solver_->energies();
  b.kinetic = solver_->kinetic_energy();
  b.bond_elastic = bonds;
  b.contact_elastic = contacts;
  // The outside's pressure does its work through walls' discs only; under stress control the far field is all there is.
  const double outside = boundary_->walled() ? 0.0 : network_.reference_pressure * (network_.volume_change[0] - start_outside_change_);
  b.fluid_work = e.fluid - outside;
  b.boundary_work = boundary_->load_work(assembly_) - start_boundary_work_;
  b.friction = e.friction;
  b.damping = e.damping;
  b.fracture = e.fracture;
  b.energy_error = b.fluid_work + b.boundary_work - b.kinetic - (bonds - start_bond_energy_) - (contacts - start_contact_energy_) -
                   b.friction - b.damping - b.fracture;
  for (const auto& well : wells_) b.injected += well.injected;
  for (std::size_t d = 1; d < start_content_.size(); ++d) b.stored += network_.content[d] - start_content_[d];
  b.leaked = leaked_;
  b.fluid_error = b.injected - b.stored - b.leaked;
  return b;
}

StopReason Simulation::stop_reason() const {
  const Options& o = options();
  if (tip_distance_ > o.stop_extent_fraction * std::min(o.model_width, o.model_height)) return StopReason::extent;
  if (o.stop_cracks > 0 && static_cast<std::int64_t>(cracks_.size()) >= o.stop_cracks) return StopReason::cracks;
  return StopReason::target;
}

std::uint64_t Simulation::state_hash() const {
  Hash hash;
  for (const auto* values : {&assembly_.ux, &assembly_.uy, &assembly_.rotation, &assembly_.vx, &assembly_.vy, &assembly_.spin,
                             &assembly_.intact, &assembly_.slip, &network_.content, &network_.pressure, &network_.aperture}) {
    hash.add_all(*values);
  }
  for (const auto& wall : boundary_->walls()) {
    hash.add(wall.displacement);
    hash.add(wall.velocity);
  }
  for (const auto& pair : solver_->loose_contacts().pairs()) {
    hash.add(static_cast<std::int64_t>(pair.first));
    hash.add(static_cast<std::int64_t>(pair.second));
    hash.add(pair.shear_force);
  }
  for (const auto& well : wells_) {
    hash.add(well.injected);
    hash.add(well.target_pressure);
    hash.add(static_cast<std::int64_t>(well.control));
  }
  for (const auto& crack : cracks_) {
    hash.add(crack.bond);
    hash.add(crack.step);
    hash.add(crack.cycle);
    hash.add(static_cast<std::int64_t>(crack.mode));
  }
  hash.add(time_);
  hash.add(step_);
  hash.add(leaked_);
  return hash.value();
}

// All that a step changes. Arrays are copied whole: a copy costs about one cycle, a step has dozens at least.
struct Simulation::Kept {
  std::array<Array<double>, 11> solid;
  std::array<Array<double>, 7> fluid;
  std::array<Boundary::Wall, 4> walls;
  LooseContacts::State loose;
  std::vector<Well> wells;
  std::vector<double> well_content;
  std::size_t cracks;
  Energies energies;
  double time, force_ratio, leaked, tip_distance;
  std::int64_t step, cycles;
  bool at_rest;
};

std::shared_ptr<const Simulation::Kept> Simulation::keep() const {
  const Assembly& a = assembly_;
  const Network& n = network_;
  auto kept = std::make_shared<const Kept>(Kept{
      {a.ux, a.uy, a.rotation, a.vx, a.vy, a.spin, a.external_x, a.external_y, a.external_moment, a.intact, a.slip},
      {n.aperture, n.conductance, n.flow, n.volume_change, n.content, n.pressure, n.stiffness},
      boundary_->walls(), solver_->loose_contacts().state(), wells_, well_content_, cracks_.size(), solver_->energies(), time_, force_ratio_, leaked_, tip_distance_,
      step_, solver_->total_cycles(), at_rest_});
  return kept;
}

void Simulation::undo(const Kept& kept) {
  Assembly& a = assembly_;
  Network& n = network_;
  Array<double>* const solid[] = {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.external_x, &a.external_y, &a.external_moment,
                                   &a.intact, &a.slip};
  Array<double>* const fluid[] = {&n.aperture, &n.conductance, &n.flow, &n.volume_change, &n.content, &n.pressure, &n.stiffness};
  // Element by element: the solver holds the arrays' addresses.
  for (std::size_t k = 0; k < kept.solid.size(); ++k) std::copy(kept.solid[k].begin(), kept.solid[k].end(), solid[k]->begin());
  for (std::size_t k = 0; k < kept.fluid.size(); ++k) std::copy(kept.fluid[k].begin(), kept.fluid[k].end(), fluid[k]->begin());
  boundary_->walls() = kept.walls;
  solver_->restore_loose_contacts(kept.loose);
  wells_ = kept.wells;
  well_content_ = kept.well_content;
  cracks_.resize(kept.cracks);
  solver_->energies() = kept.energies;
  solver_->set_total_cycles(kept.cycles);
  time_ = kept.time;
  force_ratio_ = kept.force_ratio;
  leaked_ = kept.leaked;
  tip_distance_ = kept.tip_distance;
  step_ = kept.step;
  at_rest_ = kept.at_rest;
}

}  // namespace hfrac
