// SPDX-License-Identifier: BSD-3-Clause
#include "step/stages.hpp"

#include <algorithm>
#include <cmath>

#include "core/water.hpp"
#include "flow/aperture.hpp"
#include "frac/fractures.hpp"
#include "heat/expansion.hpp"
#include "options/choices.hpp"
#include "step/ledger.hpp"

namespace hfrac {
namespace {

void follow_schedules(Engine& e) {
  bool turned = false;
  for (auto& well : e.model.wells) {
    for (; well.next < static_cast<std::int64_t>(well.schedule.size()); ++well.next) {
      const ScheduleEntry& entry = well.schedule[static_cast<std::size_t>(well.next)];
      if (!is_due(e, entry)) break;
      well.drive.control = WellControl{entry.control};
      (well.drive.control == WellControl::rate ? well.drive.set_rate : well.drive.target_pressure) =
          entry.value;
      if (ScheduleFluid{entry.fluid} != ScheduleFluid::same)
        well.drive.fluid =
            ScheduleFluid{entry.fluid} == ScheduleFluid::second ? WellFluid::second : WellFluid::first;
      turned = true;
    }
  }
  // What pressures were heading for before says nothing any more.
  auto& rate = e.model.increment.pressure_rate;
  if (turned) std::fill(rate.begin(), rate.end(), 0.0);
}

// Where a well that is driven by pressure is taken to in a step, from `now` [Pa].
double next_pressure(const WellDrive& drive, double now) {
  const double gap = drive.target_pressure - now;
  const bool there = drive.control == WellControl::pressure || std::abs(gap) <= drive.ramp_per_step;
  return there ? drive.target_pressure : now + std::copysign(drive.ramp_per_step, gap);
}

// Of a wellbore with friction: its first well's drive. The holes of all its clusters take what comes through.
void drive_wellbore(Engine& e, Wellbore& wellbore, const WellDrive& drive) {
  wellbore.held = drive.control != WellControl::rate;
  wellbore.rate = wellbore.held ? 0.0 : drive.set_rate;
  for (auto& cluster : wellbore.clusters)
    cluster.friction.square = cluster.square_of[static_cast<std::size_t>(drive.fluid)];
  if (!wellbore.held) return;
  const double before = wellbore.pressure;
  wellbore.pressure = std::max(next_pressure(drive, before), e.model.network.floor_pressure);
  e.well_jumped = e.well_jumped || wellbore.pressure != before;
}

// The hole's pressure follows its content.
void release_hole(Engine& e, std::int32_t d) {
  Network& n = e.model.network;
  if (n.stiffness[d] != 0.0) return;
  n.stiffness[d] = e.options.fluid_bulk_modulus / n.storing[d];
  n.content[d] = content_at(n, d, e.options.fluid_bulk_modulus, n.pressure[d]);
}

void impose_well_pressure(Engine& e, const Well& well, double pressure) {
  Network& n = e.model.network;
  n.stiffness[well.place.domain] = 0.0;
  const double before = n.pressure[well.place.domain];
  n.pressure[well.place.domain] = std::max(pressure, n.floor_pressure);
  e.well_jumped = e.well_jumped || n.pressure[well.place.domain] != before;
}

// In every pipe, the mean of the pores at its ends; until the end of the next step or increment it is fixed, and the tangent exact. Of water it is
// the kinematic one over the formation's, since flows are volumes at the formation's density.
void update_viscosity(Engine& e) {
  Network& n = e.model.network;
  if (n.viscosity_share.empty()) return;
  const Options& o = e.options;
  const double datum = o.fluid_formation_pressure - n.reference_pressure;
  auto& share = e.pore_viscosity;
  share.resize(n.kind.size());
  const bool water = e.water != nullptr;
  for (std::size_t d = 0; d < share.size(); ++d) {
    const double second = n.second_share_of(d);
    const double first = water ? water_kinematic_viscosity_at(e.model.heat->fluid[d], n.pressure[d] + datum) *
                                     o.thermal_fluid_density / o.fluid_viscosity
                               : 1.0;
    share[d] = first + second * (o.fluid_second_viscosity / o.fluid_viscosity - first);
  }
  const bool two = e.second_fluid != nullptr;  // then a pipe to the outside holds what the pore inside does
  for (std::size_t p = 0; p < n.left.size(); ++p) {
    const auto l = n.left[p], r = n.right[p];
    n.viscosity_share[p] = 0.5 * (share[static_cast<std::size_t>(two && l == 0 ? r : l)] +
                                  share[static_cast<std::size_t>(two && r == 0 ? l : r)]);
  }
}

void feel_in_rock(Engine& e) {
  HeatState& state = *e.model.heat;
  e.mechanics->bring_home();
  const ElasticEnergy before = elastic_energy(e);
  state.felt = state.disc;
  feel_heat_again(e);
  const ElasticEnergy after = elastic_energy(e);
  state.thermal_work += after.bonds + after.contacts - before.bonds - before.contacts;
  if (!e.heat->table.empty()) e.mechanics->refresh_stiffness();
}

}  // namespace

// Adding up steps rounds: a billionth of a step early is on time.
bool is_due(const Engine& e, const ScheduleEntry& entry) {
  return entry.time <= e.model.clock.time + 1e-9 * e.options.stepping_flow_step;
}

void drive_wells(Engine& e) {
  Network& n = e.model.network;
  follow_schedules(e);
  e.well_jumped = false;
  std::fill(e.source.begin(), e.source.end(), 0.0);
  for (auto& well : e.model.wells) {
    const auto d = well.place.domain;
    if (well.wellbore >= 0) {
      release_hole(e, d);
      continue;
    }
    switch (well.drive.control) {
      case WellControl::pressure:
      case WellControl::ramp:
        impose_well_pressure(e, well, next_pressure(well.drive, n.pressure[d]));
        break;
      case WellControl::rate:
        release_hole(e, d);
        if (e.flow) e.source[static_cast<std::size_t>(d)] = well.drive.set_rate;
        break;
    }
  }
  for (auto& wellbore : e.model.wellbores)
    drive_wellbore(e, wellbore,
                   e.model.wells[static_cast<std::size_t>(wellbore.clusters.front().well)].drive);
}

void move_fluid(Engine& e, double duration) {
  if (e.flow) e.model.clock.flow_rounds = e.flow->advance(e.model.network, duration, e.source);
  carry_second_fluid(e, duration);
  move_heat(e, duration);
  feel_heat(e);
}

void carry_second_fluid(Engine& e, double duration) {
  if (!e.second_fluid) return;
  e.inlets.clear();
  for (const Well& well : e.model.wells)
    e.inlets.push_back({well.place.domain, e.model.drive_of(well).fluid == WellFluid::second ? 1.0 : 0.0});
  e.second_fluid->carry(e.model.network, e.inlets, duration, e.model.accounts.second);
}

void move_heat(Engine& e, double duration) {
  if (e.heat && e.heat->solver) e.heat->solver->advance(*e.model.heat, e.heat->well_domain, duration);
}

void feel_heat(Engine& e) {
  if (!e.heat) return;
  if (e.model.heat->felt != e.model.heat->disc) feel_in_rock(e);
  if (e.water) e.water->feel(e.model.assembly, e.model.network, *e.model.heat);
}

void feel_heat_again(Engine& e) {
  if (e.heat) feel_temperature(e.model.assembly, e.model.heat->felt, e.heat->table, e.options);
}

void update_geometry(Engine& e) {
  update_viscosity(e);
  e.facets.tell_openings(e.model.assembly, e.model.network);
  // Of facets the quasi-static solver finds the apertures with the equilibrium.
  if (e.flow && !(e.facets.active() && e.equilibrium))
    update_apertures(e.model.network, e.model.assembly, e.options, e.workers.get(), e.ranks);
  e.mechanics->search_contacts(e.model.cracks);
}

void close_step(Engine& e, double duration, std::size_t cracks_before) {
  Model& m = e.model;
  m.clock.time += duration;
  ++m.clock.step;
  for (auto& well : m.wells) {
    well.rate = well.taken / duration;
    well.taken = 0.0;
  }
  for (auto& wellbore : m.wellbores) {
    wellbore.pump_rate = wellbore.taken / duration;
    wellbore.taken = 0.0;
  }
  for (std::size_t c = cracks_before; c < m.cracks.size(); ++c) {
    m.cracks.since_start(c).step = m.clock.step;
    m.cracks.since_start(c).time = m.clock.time;
  }
  // Cracks elsewhere, say at the outer boundary, are no part of what the wells drive.
  if (m.cracks.size() > cracks_before) {
    e.mechanics->bring_home();
    m.clock.tip_distance = std::max(
        m.clock.tip_distance, farthest_tip(m.assembly, m.network, e.options, m.well_places(), m.cracks));
  }
  if (e.equilibrium) book_damping(e);
}

}  // namespace hfrac
