// SPDX-License-Identifier: BSD-3-Clause
// The energy and fluid balance of a simulation.
#include <algorithm>
#include <cmath>

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
  contacts += solver_->non_bonded_contacts().energy(assembly_);
}

double Simulation::stored_fluid() const {
  double stored = 0.0;
  if (flow_) {
    for (std::size_t d = 1; d < start_content_.size(); ++d) stored += network_.content[d] - start_content_[d];
  } else {
    for (std::size_t w = 0; w < wells_.size(); ++w) {
      const auto d = wells_[w].place.domain;
      const auto end = wells_.begin() + static_cast<std::ptrdiff_t>(w);  // two wells may share a hole
      if (std::none_of(wells_.begin(), end, [d](const Well& other) { return other.place.domain == d; }))
        stored += network_.content[d] - start_content_[w];
    }
  }
  return stored;
}

// Works of fluid, far field and temperature = change of stored energy + what was dissipated + what breaking bonds took along.
Balance Simulation::balance() const {
  Balance b{};
  double bonds = 0.0, contacts = 0.0;
  elastic_energy(bonds, contacts);
  const Energies& e = solver_->energies();
  b.kinetic = solver_->kinetic_energy();
  b.bond_elastic = bonds;
  b.contact_elastic = contacts;
  // The outside's pressure does its work through walls' discs only; under stress control the far field is all there is.
  const double outside =
      boundary_->walled()
          ? 0.0
          : outside_work_ + network_.pressure[0] * (network_.volume_change[0] - start_outside_change_);
  b.fluid_work = e.fluid - outside;
  b.boundary_work = boundary_->load_work(assembly_) - start_boundary_work_;
  b.friction = e.friction;
  b.damping = e.damping;
  b.fracture = e.fracture;
  b.energy_error = b.fluid_work + b.boundary_work - b.kinetic - (bonds - start_bond_energy_) -
                   (contacts - start_contact_energy_) - b.friction - b.damping - b.fracture +
                   (heat_ ? heat_->state.thermal_work : 0.0);
  for (const auto& well : wells_) b.injected += well.injected;
  b.stored = stored_fluid();
  b.leaked = leaked_;
  b.host = host_added_;
  b.fluid_error = b.injected + b.host - b.stored - b.leaked;
  return b;
}

StopReason Simulation::stop_reason() const {
  const Options& o = options();
  if (tip_distance_ > o.stop_extent_fraction * std::min(o.model_width, o.model_height))
    return StopReason::extent;
  if (o.stop_cracks > 0 && static_cast<std::int64_t>(cracks_.size()) >= o.stop_cracks)
    return StopReason::cracks;
  return StopReason::target;
}

void Simulation::set_stop(double extent_fraction, std::int64_t cracks) {
  definition_.options.stop_extent_fraction = extent_fraction;
  definition_.options.stop_cracks = cracks;
}

}  // namespace hfrac
