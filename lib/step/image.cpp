// SPDX-License-Identifier: BSD-3-Clause
#include "step/image.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "model/visit_state.hpp"
#include "options/choices.hpp"
#include "state/seal.hpp"
#include "step/snapshot.hpp"

namespace hfrac {
namespace {

constexpr SealKind image_seal{"hfracimg", image_format, "the state image cannot be restored: ", "an image",
                              "use the version of the library that wrote it, or run the case anew."};

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::argument, image_seal.refusal + why);
}

// Options that a state makes no sense without. Others, such as the length of a step, may differ.
bool is_of_the_model(std::string_view key) {
  if (key == "fluid.formation_pressure") return false;  // of the state: a host may change it
  if (key == "stress.convention") return true;
  const auto section = key.substr(0, key.find('.'));
  for (const std::string_view kept : {"model", "disc", "contact", "bond", "boundary", "fluid", "flow"}) {
    if (section == kept) return true;
  }
  return false;
}

}  // namespace

std::uint64_t fingerprint_of(const Engine& e, const SetupReport& report) {
  const Assembly& a = e.model.assembly;
  Hash hash;
  hash.add_all(a.x);
  hash.add_all(a.y);
  hash.add_all(a.radius);
  for (std::int64_t bond = 0; bond < a.bond_count(); ++bond) hash.add(a.bond_radius(bond));
  hash.add(a.tensile_per_radius);
  hash.add(a.shear_per_radius);
  hash.add_all(a.strength_scale);
  const auto add_of_joints = [&](double JointLaw::*value, double elsewhere) {
    for (std::int64_t bond = 0; !a.joints.normal.empty() && bond < a.bond_count(); ++bond) {
      const JointLaw* law = a.joint_law_of(bond);
      hash.add(law != nullptr ? law->*value : elsewhere);
    }
  };
  add_of_joints(&JointLaw::tensile_factor, 1.0);
  add_of_joints(&JointLaw::shear_factor, 1.0);
  add_of_joints(&JointLaw::friction, e.options.contact_friction);
  for (const auto& contact : a.smooth.contacts) {
    const JointLaw& law = a.smooth.law_of(contact);
    for (const double value : {static_cast<double>(contact.bond), contact.normal.x, contact.normal.y,
                               contact.area, law.normal_stiffness, law.shear_stiffness})
      hash.add(value);
    // Fingerprints of joints that have no more than that are what they were before there was more.
    const auto more = {law.max_closure,       law.tensile_strength, law.cohesion,      law.residual_friction,
                       law.weakening_slip,    law.dilation,         law.dilation_slip, law.aperture,
                       law.residual_aperture, law.roughness};
    if (std::any_of(more.begin(), more.end(), [](double value) { return value != 0.0; }))
      for (const double value : more) hash.add(value);
    if (law.storage != 0.0) hash.add(law.storage);
  }
  hash.add_all(e.model.network.volume);
  // Models whose wells are holes and nothing else have the fingerprints that they had before there was more.
  for (const auto& wellbore : e.model.wellbores) {
    hash.add(wellbore.storage);
    for (const auto& cluster : wellbore.clusters) {
      for (const double value :
           {static_cast<double>(cluster.well), cluster.friction.square, cluster.friction.root})
        hash.add(value);
    }
  }
  for (const auto& well : e.model.wells) {
    if (well.storage > 0.0) hash.add(well.storage);
  }
  if (report.unbonded > 0) hash.add(report.bonded);
  // Models without the rock beyond have the fingerprints that they had before there was any.
  const bool beyond = BoundaryKind{e.options.boundary_kind} == BoundaryKind::infinite;
  for (const auto& info : option_table()) {
    const std::string_view key = info.key;
    if (!beyond && (key.starts_with("boundary.exterior_") || key == "boundary.flow_distance")) continue;
    if (key == "fluid.kind" && e.options.fluid_kind == 0) continue;  // likewise
    if (key == "bond.fracture_energy" && e.options.bond_fracture_energy == 0.0) continue;
    const bool thermal = e.heat && std::string_view(info.key).starts_with("thermal.");
    if (thermal || is_of_the_model(info.key)) hash.add(get_value(e.options, info));
  }
  return hash.value();
}

std::size_t image_size(const Engine& e) {
  return seal_size + state_size(e, true);
}

void write_image(const Engine& e, std::uint64_t fingerprint, std::span<std::byte> image) {
  write_state(e, image.subspan(seal_size), true);
  put_seal(image, image_seal, fingerprint);
}

void restore_image(Engine& e, std::uint64_t fingerprint, std::span<const std::byte> image) {
  const Sealed opened = open_seal(image, image_seal);
  const auto state = opened.body;
  if (opened.model != fingerprint) {
    refuse(
        "it was taken from another model: discs, wells, or options of model, disc, contact, bond, boundary, "
        "fluid, flow or "
        "thermal differ.");
  }
  std::vector<std::byte> before;
  const bool had_one = !e.mechanics->is_lost();
  if (had_one) save_state(e, before, true);
  try {
    load_state(e, state, true);
    FiniteCheck start;  // where the ledger begins; what else is not finite the next step finds
    visit_start(start, e.model, e.wet());
    if (!start.finite()) refuse("it holds a number that is not finite.");
  } catch (...) {
    if (had_one)
      load_state(e, before, true);
    else
      e.mechanics->lose();
    throw;
  }
}

}  // namespace hfrac
