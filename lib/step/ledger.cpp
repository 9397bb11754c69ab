// SPDX-License-Identifier: BSD-3-Clause
#include "step/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "solid/bond_law.hpp"

namespace hfrac {
namespace {

double stored_fluid(const Engine& e) {
  const Model& m = e.model;
  const Network& n = m.network;
  double stored = 0.0;
  if (e.wet()) {
    for (std::size_t d = 1; d < m.start.content.size(); ++d) stored += n.content[d] - m.start.content[d];
    for (const auto& wellbore : m.wellbores) stored += wellbore.content;
  } else {
    for (std::size_t w = 0; w < m.wells.size(); ++w) {
      const auto d = m.wells[w].place.domain;
      const auto end = m.wells.begin() + static_cast<std::ptrdiff_t>(w);  // two wells may share a hole
      if (std::none_of(m.wells.begin(), end, [d](const Well& other) { return other.place.domain == d; }))
        stored += n.content[d] - m.start.content[w];
    }
  }
  return stored;
}

// The balance with what the works leave over in energy_error, whether that says anything or not.
Balance full_balance(const Engine& engine) {
  const Model& m = engine.model;
  const Network& n = m.network;
  Balance b{};
  const ElasticEnergy elastic = elastic_energy(engine);
  const Energies& e = m.accounts.energies;
  b.kinetic = engine.mechanics->kinetic_energy();
  b.bond_elastic = elastic.bonds;
  b.contact_elastic = elastic.contacts;
  // The outside's pressure does its work through walls' discs only; under stress control the far field is all there is.
  const double outside =
      engine.boundary->walled()
          ? 0.0
          : m.accounts.outside_work + n.pressure[0] * (n.volume_change[0] - m.accounts.outside_change);
  b.fluid_work = e.fluid - outside;
  b.boundary_work = engine.boundary->load_work(m.assembly) - m.start.boundary_work + e.held;
  b.friction = e.friction;
  b.damping = e.damping;
  b.fracture = e.fracture + energy_taken(m.assembly, engine.options);
  b.energy_error = b.fluid_work + b.boundary_work - b.kinetic - (elastic.bonds - m.start.bond_energy) -
                   (elastic.contacts - m.start.contact_energy) - b.friction - b.damping - b.fracture +
                   (m.heat ? m.heat->thermal_work : 0.0);
  b.energy_checked = !engine.equilibrium;
  // A wellbore with friction counts by its pump, and stores beside the pores.
  for (const auto& well : m.wells) b.injected += well.wellbore < 0 ? well.injected : 0.0;
  for (const auto& wellbore : m.wellbores) b.injected += wellbore.pumped;
  b.stored = stored_fluid(engine);
  b.leaked = m.accounts.leaked;
  b.host = m.accounts.host_added;
  b.fluid_error = b.injected + b.host - b.stored - b.leaked;
  return b;
}

}  // namespace

Balance balance_of(const Engine& engine) {
  Balance b = full_balance(engine);
  if (!b.energy_checked) b.energy_error = std::numeric_limits<double>::quiet_NaN();
  return b;
}

ElasticEnergy elastic_energy(const Engine& e) {
  e.mechanics->bring_home();
  const Assembly& a = e.model.assembly;
  ElasticEnergy energy;
  energy.contacts = e.boundary->walled() ? e.boundary->wall_energy(a) : e.boundary->exterior_energy(a);
  // Workers look at bonds, a chunk at a time; added up they are one after the other, in the order of bonds.
  constexpr std::int64_t chunk = 1 << 15, grain = 64, worth_sharing = 4096;
  struct OfBond {
    double bond, contact;
  };
  std::vector<OfBond> held(static_cast<std::size_t>(std::min(chunk, a.bond_count())));
  for (std::int64_t first = 0; first < a.bond_count(); first += chunk) {
    const auto count = std::min(chunk, a.bond_count() - first);
    const auto look = [&](std::int64_t from, std::int64_t to) {
      for (auto k = from; k < to; ++k) {
        const BondView view = view_bond(a, e.options, first + k);
        held[static_cast<std::size_t>(k)] = {view.bond_energy, view.contact_energy};
      }
    };
    share_items(e.workers.get(), count, look, worth_sharing, grain);
    for (std::int64_t k = 0; k < count; ++k) {
      energy.bonds += held[static_cast<std::size_t>(k)].bond;
      if (e.facets.of(first + k) < 0) energy.contacts += held[static_cast<std::size_t>(k)].contact;
    }
  }
  energy.contacts += e.facets.energy(a, e.model.network, e.options);
  energy.contacts += e.mechanics->non_bonded_contacts().energy(a);
  return energy;
}

void begin_ledger(Engine& e) {
  Model& m = e.model;
  if (e.wet()) {
    m.start.content = m.network.content;
  } else {
    for (const auto& well : m.wells) m.start.content.push_back(m.network.content[well.place.domain]);
  }
  const ElasticEnergy elastic = elastic_energy(e);
  m.start.bond_energy = elastic.bonds;
  m.start.contact_energy = elastic.contacts;
  m.start.boundary_work = e.boundary->load_work(m.assembly);
  m.accounts.outside_change = m.network.volume_change[0];
  m.accounts.energies = {};
  m.accounts.energies.fracture = -energy_taken(m.assembly, e.options);  // before the start
}

void accumulate_flow(Engine& e, double duration) {
  Network& n = e.model.network;
  auto& wells = e.model.wells;
  // What left through the pipes; domains of imposed pressure keep no content of their own.
  std::vector<double> outflow(wells.size(), 0.0);
  if (e.flow) {
    double leak = 0.0;
    for (const auto p : n.outer_pipe)
      leak += n.left[static_cast<std::size_t>(p)] == 0 ? -n.flow[p] : n.flow[p];
    e.model.accounts.leaked += duration * leak;
    for (std::size_t w = 0; w < wells.size(); ++w) outflow[w] = e.flow->outflow(n, wells[w].place.domain);
  }
  for (std::size_t w = 0; w < wells.size(); ++w) {
    Well& well = wells[w];
    const auto d = well.place.domain;
    const double injected_before = well.injected;
    if (n.stiffness[d] == 0.0) {
      // What it took to keep the pressure: what flowed out, and what the hole holds more than before.
      const double content = content_at(n, d, e.options.fluid_bulk_modulus, n.pressure[d]);
      well.injected += duration * outflow[w] + content - well.content;
      n.content[d] = content;
    } else {
      if (e.flow && well.wellbore < 0) well.injected += duration * e.source[static_cast<std::size_t>(d)];
    }
    well.content = n.content[d];
    well.taken += well.injected - injected_before;
  }
  for (const auto& wellbore : e.model.wellbores) {
    for (const auto& cluster : wellbore.clusters) {
      Well& well = wells[static_cast<std::size_t>(cluster.well)];
      well.injected += duration * cluster.rate;
      well.taken += duration * cluster.rate;
    }
  }
}

void book_host_fluid(Engine& e, std::size_t domain, double gain) {
  e.model.accounts.host_added += gain;
  Network& n = e.model.network;
  if (gain < 0.0 && !n.second_content.empty()) {  // some of both fluids went, as they stood in the pore
    const double before = n.fluid_in(domain) - gain,
                 taken = before > 0.0 ? std::min(1.0, -gain / before) * n.second_content[domain] : 0.0;
    n.second_content[domain] -= taken;
    e.model.accounts.second.from_host -= taken;
  }
  if (!e.heat || !e.heat->solver) return;
  const Options& o = e.options;
  e.model.heat->from_host += gain * o.thermal_fluid_density * o.thermal_fluid_specific_heat *
                             (e.model.heat->fluid[domain] - o.thermal_rock_temperature);
}

double unaccounted_work(const Engine& e) {
  return full_balance(e).energy_error;
}

void book_damping(Engine& e) {
  e.model.accounts.energies.damping += unaccounted_work(e);
}

void keep_outside_work(Model& m) {
  m.accounts.outside_work += m.network.pressure[0] * (m.network.volume_change[0] - m.accounts.outside_change);
  m.accounts.outside_change = m.network.volume_change[0];
}

void require_heat(const Engine& e) {
  if (e.heat) return;
  throw Error(ErrorKind::argument,
              "this simulation has no temperature; set thermal.mode = \"uniform\" or \"transport\".");
}

double stored_heat(const Engine& e) {
  const HeatState& s = *e.model.heat;
  if (e.heat->solver) return e.heat->solver->stored(s);
  double heat = 0.0;
  for (std::size_t i = 0; i < s.disc.size(); ++i)
    heat += e.heat->network.capacity[i] * (s.disc[i] - e.options.thermal_rock_temperature);
  return heat;
}

HeatBalance heat_balance_of(const Engine& e) {
  require_heat(e);
  const HeatState& s = *e.model.heat;
  HeatBalance b{};
  b.stored = stored_heat(e);
  b.from_wells = s.from_wells;
  b.from_outside = s.from_outside;
  b.from_held = s.from_held;
  b.from_host = s.from_host;
  b.error = b.from_wells + b.from_outside + b.from_held + b.from_host - b.stored;
  b.thermal_work = s.thermal_work;
  b.lowest = *std::min_element(s.disc.begin(), s.disc.end());
  b.highest = *std::max_element(s.disc.begin(), s.disc.end());
  return b;
}

}  // namespace hfrac
