// SPDX-License-Identifier: BSD-3-Clause
// The one list of what the state of a model is. Whoever changes what is visited, or in which order, raises the format of images
// and changes every fingerprint.
#pragma once

#include <cstdint>
#include <type_traits>

#include "model/model.hpp"
#include "state/archive.hpp"

namespace hfrac {

// Of state images, and of the state in a model file (step/packed_model.hpp).
inline constexpr std::uint32_t image_format = 7;

// Everything that a step, a well or the host can change. Derived values (forces, stable step) are found anew. This is kept
// before every step, so what cannot change is left out: in a dry model (`wet` false) the pores, in any where the ledger begins.
template <class Archive, class Self>
void visit_state(Archive& archive, Self& s, bool wet) {
  auto& a = s.assembly;
  auto& n = s.network;
  for (auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin}) archive.array(*values);
  archive.often_zero(a.slip);
  for (auto* values : {&a.external_x, &a.external_y, &a.external_moment}) archive.mostly_zero(*values);
  archive.flags(a.intact);
  if (wet) {
    for (auto* values : {&n.aperture, &n.conductance, &n.flow, &n.volume_change, &n.content, &n.pressure,
                         &n.stiffness, &n.outer_excess}) {
      archive.array(*values);
    }
  }
  // Hashes of models without facets are what they were before there were any.
  if (!n.facet_offset.empty()) {
    archive.array(n.facet_offset);
    archive.array(n.facet_time);
    archive.value(n.facet_pushed);
  }
  if (!n.facet_worked.empty()) {
    archive.array(n.facet_worked);
    archive.value(s.accounts.energies.held);
  }
  if (!n.viscosity_share.empty()) archive.array(n.viscosity_share);  // likewise
  if (!n.growth.empty()) {
    archive.array(n.growth);
    archive.array(n.storing);
  }
  const bool two_fluids = !n.second_content.empty();
  if (two_fluids) {
    archive.array(n.second_content);
    auto& books = s.accounts.second;
    for (auto* value : {&books.from_wells, &books.from_host, &books.leaked}) archive.value(*value);
  }
  if (!a.softening.empty()) {
    archive.often_zero(a.softening.start);
    archive.often_zero(a.softening.worst);
  }
  archive.value(n.zero_stress_aperture);
  archive.often_zero(s.increment.pressure_rate);
  for (auto* value : {&s.clock.time, &s.clock.force_ratio, &s.accounts.leaked, &s.clock.tip_distance,
                      &s.accounts.host_added, &s.increment.length, &s.increment.excess,
                      &s.far_field.formation_pressure, &s.accounts.outside_work, &s.accounts.outside_change,
                      &s.far_field.sigma_Hmax, &s.far_field.sigma_hmin}) {
    archive.value(*value);
  }
  auto& work = s.work;
  for (auto* value : {&work.increments, &work.rounds, &work.newton, &work.krylov, &work.factors,
                      &work.rejected_error, &work.rejected_strength, &work.rejected_divergence})
    archive.value(*value);
  archive.value(s.clock.step);
  archive.value(s.clock.at_rest);
  archive.value(s.far_field.boundary_pressure_set);
  archive.value(s.clock.flow_rounds);
  BoundaryState::visit(archive, s.boundary);
  auto& e = s.accounts.energies;
  for (auto* value : {&e.friction, &e.damping, &e.fluid, &e.fracture}) archive.value(*value);
  archive.value(s.clock.cycles);
  ContactPairs::visit(archive, s.contact_pairs);
  archive.list(s.wells, [&n, two_fluids](auto& ar, auto& well) {
    ar.value(well.place.centre.x);
    ar.value(well.place.centre.y);
    ar.value(well.place.equivalent_radius);
    ar.value(well.place.domain);
    ar.require(well.place.domain > 0 && well.place.domain < n.domain_count());
    auto& drive = well.drive;
    ar.value(drive.control);
    ar.require(drive.control >= WellControl::pressure && drive.control <= WellControl::rate);
    for (auto* value : {&drive.target_pressure, &drive.ramp_per_step, &drive.set_rate, &well.rate,
                        &well.injected, &well.content, &well.taken})
      ar.value(*value);
    if (two_fluids) {
      ar.value(drive.fluid);
      ar.require(drive.fluid == WellFluid::first || drive.fluid == WellFluid::second);
    }
    // Hashes of runs without a schedule are what they were before there were any.
    constexpr bool hashing = std::is_same_v<std::decay_t<decltype(ar)>, Hasher>;
    if (!hashing || !well.schedule.empty()) {
      ar.value(well.next);
      ar.list(well.schedule, [two_fluids](auto& inner, auto& entry) {
        inner.value(entry.time);
        inner.value(entry.value);
        inner.value(entry.control);
        if (two_fluids) inner.value(entry.fluid);
      });
    }
    for (auto* values : {&n.pressure, &n.content, &n.stiffness}) ar.value((*values)[well.place.domain]);
  });
  // Wells added since the model was built: pores of the rock, each one's own.
  archive.require(s.wells.size() == s.well_count || (wet && s.wells.size() > s.well_count));
  for (std::size_t w = s.well_count; w < s.wells.size(); ++w) {
    const auto d = s.wells[w].place.domain;
    archive.require(n.kind[d] == DomainKind::rock);
    for (std::size_t other = s.well_count; other < w; ++other)
      archive.require(d != s.wells[other].place.domain);
  }
  // Hashes of models without friction in their wells are what they were before there was any.
  for (auto& wellbore : s.wellbores) {
    for (auto* value :
         {&wellbore.pressure, &wellbore.content, &wellbore.pumped, &wellbore.taken, &wellbore.pump_rate})
      archive.value(*value);
    for (auto& cluster : wellbore.clusters) archive.value(cluster.rate);
  }
  archive.log(s.cracks, [&a](auto& ar, auto& crack) {
    ar.value(crack.bond);
    ar.require(crack.bond >= 0 && crack.bond < a.bond_count());
    ar.value(crack.step);
    ar.value(crack.cycle);
    for (auto* value : {&crack.time, &crack.normal_force, &crack.shear_force, &crack.energy})
      ar.value(*value);
    ar.value(crack.mode);
    ar.require(crack.mode == CrackMode::tension || crack.mode == CrackMode::shear);
  });
  // Hashes of models without smooth joints are what they were before slips were logged.
  if (!a.smooth.empty()) {
    archive.log(s.slips, [&a](auto& ar, auto& slip) {
      ar.value(slip.bond);
      ar.require(slip.bond >= 0 && slip.bond < a.bond_count() && a.smooth.of(slip.bond) != nullptr);
      ar.value(slip.step);
      for (auto* value : {&slip.time, &slip.duration, &slip.slip}) ar.value(*value);
    });
  }
  // A model without temperature has the image, and the hash, that it had before there was any.
  if (s.heat) {
    if constexpr (Archive::loading) s.heat->well.resize(s.wells.size());
    HeatState::visit(archive, *s.heat);
  }
  archive.require(s.contact_pairs.fits(a.disc_count()));
}

// By domain in any image. In a dry model the start is what there is now but for the wells, and only those are kept.
template <class Archive, class Self>
void visit_start_content(Archive& archive, Self& s, bool wet) {
  if (wet) {
    archive.array(s.start.content);
    return;
  }
  Array<double> content = s.network.content;
  for (std::size_t w = 0; w < s.wells.size(); ++w) content[s.wells[w].place.domain] = s.start.content[w];
  archive.array(content);
  if constexpr (Archive::loading) {
    for (std::size_t w = 0; w < s.wells.size(); ++w) s.start.content[w] = content[s.wells[w].place.domain];
  }
}

// What is fixed once the model came to rest.
template <class Archive, class Self>
void visit_start(Archive& archive, Self& s, bool wet) {
  for (auto* values : {&s.start.x, &s.start.y, &s.start.rotation}) archive.array(*values);
  visit_start_content(archive, s, wet);
  for (auto* value : {&s.start.bond_energy, &s.start.contact_energy, &s.start.boundary_work})
    archive.value(*value);
}

}  // namespace hfrac
