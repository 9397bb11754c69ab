// SPDX-License-Identifier: BSD-3-Clause
#include "step/image.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "model/visit_state.hpp"
#include "options/choices.hpp"
#include "step/snapshot.hpp"

namespace hfrac {

// Image: magic, format, byte order, fingerprint of the model, size of the state, checksum, the state. The format is that
// of visit_state: whoever changes what is visited, or in which order, raises it.
namespace {

struct ImageHeader {
  char magic[8];
  std::uint32_t format;
  std::uint32_t byte_order;
  std::uint64_t model, size, checksum;  // the checksum is of the header before it and of the state
};
constexpr char image_magic[8] = {'h', 'f', 'r', 'a', 'c', 'i', 'm', 'g'};
constexpr std::uint32_t image_format = 7, image_byte_order = 0x01020304;

std::uint64_t checksum(const ImageHeader& header, std::span<const std::byte> bytes) {
  Hash hash;
  hash.add(header.model);
  hash.add(header.size);
  hash.add((static_cast<std::uint64_t>(header.format) << 32U) | header.byte_order);
  std::size_t k = 0;
  for (; k + 8 <= bytes.size(); k += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + k, 8);
    hash.add(word);
  }
  for (; k < bytes.size(); ++k) hash.add(static_cast<std::uint64_t>(bytes[k]));
  return hash.value();
}

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::argument, "the state image cannot be restored: " + why);
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
  return sizeof(ImageHeader) + state_size(e, true);
}

void write_image(const Engine& e, std::uint64_t fingerprint, std::span<std::byte> image) {
  const auto state = image.subspan(sizeof(ImageHeader));
  write_state(e, state, true);
  ImageHeader header{};
  std::memcpy(header.magic, image_magic, sizeof header.magic);
  header.format = image_format;
  header.byte_order = image_byte_order;
  header.model = fingerprint;
  header.size = state.size();
  header.checksum = checksum(header, state);
  std::memcpy(image.data(), &header, sizeof header);
}

void restore_image(Engine& e, std::uint64_t fingerprint, std::span<const std::byte> image) {
  ImageHeader header{};
  if (image.size() < sizeof header) refuse("it is shorter than an image's header.");
  std::memcpy(&header, image.data(), sizeof header);
  const auto state = image.subspan(sizeof header);
  if (std::memcmp(header.magic, image_magic, sizeof header.magic) != 0)
    refuse("it is not an image of this library.");
  if (header.byte_order != image_byte_order) refuse("it comes from a machine of the other byte order.");
  if (header.format != image_format) {
    refuse("its format is " + std::to_string(header.format) + ", and this library reads format " +
           std::to_string(image_format) +
           "; use the version of the library that wrote it, or run the case anew.");
  }
  if (header.size != state.size()) {
    refuse("it should be " + std::to_string(header.size + sizeof header) + " bytes long and is " +
           std::to_string(image.size()) + ": it was cut, or something was added.");
  }
  if (header.checksum != checksum(header, state)) refuse("it is damaged: its checksum differs.");
  if (header.model != fingerprint) {
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
