// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation: the one list of what it is made of, and what is done with it: keeping a step undoable, images
// in memory, the state hash.
#include <algorithm>
#include <bit>

#include "couple/simulation.hpp"
#include "options/choices.hpp"
#include "state/archive.hpp"

namespace hfrac {

// Everything that a step, a well or the host can change. Derived values (forces, stable step) are found anew. This is kept
// before every step, so what cannot change is left out: in a dry model the pores, in any the books' beginning.
template <class Archive, class Self>
void Simulation::visit_state(Archive& archive, Self& s) {
  auto& a = s.assembly_;
  auto& n = s.network_;
  for (auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.slip}) archive.array(*values);
  for (auto* values : {&a.external_x, &a.external_y, &a.external_moment}) archive.mostly_zero(*values);
  archive.array(a.intact);
  if (FlowScheme{s.options().flow_scheme} != FlowScheme::off) {
    for (auto* values : {&n.aperture, &n.conductance, &n.flow, &n.volume_change, &n.content, &n.pressure,
                         &n.stiffness, &n.rim_excess}) {
      archive.array(*values);
    }
  }
  archive.value(n.zero_stress_aperture);
  archive.array(s.pressure_rate_);
  for (auto* value :
       {&s.time_, &s.force_ratio_, &s.leaked_, &s.tip_distance_, &s.host_added_, &s.part_, &s.excess_,
        &s.definition_.options.stress_sigma_H, &s.definition_.options.stress_sigma_h}) {
    archive.value(*value);
  }
  auto& work = s.work_;
  for (auto* value : {&work.parts, &work.rounds, &work.newton, &work.krylov, &work.factors,
                      &work.rejected_error, &work.rejected_strength, &work.rejected_stuck})
    archive.value(*value);
  archive.value(s.step_);
  archive.value(s.at_rest_);
  archive.value(s.flow_rounds_);
  s.boundary_->visit_state(archive);
  s.solver_->visit_state(archive);
  archive.list(s.wells_, [&n](auto& ar, auto& well) {
    ar.value(well.place.centre.x);
    ar.value(well.place.centre.y);
    ar.value(well.place.equivalent_radius);
    ar.value(well.place.domain);
    ar.value(well.control);
    for (auto* value : {&well.target_pressure, &well.ramp_per_step, &well.set_rate, &well.rate,
                        &well.injected, &well.content, &well.taken})
      ar.value(*value);
    for (auto* values : {&n.pressure, &n.content, &n.stiffness}) ar.value((*values)[well.place.domain]);
  });
  archive.list(s.cracks_, [](auto& ar, auto& crack) {
    ar.value(crack.bond);
    ar.value(crack.step);
    ar.value(crack.cycle);
    for (auto* value : {&crack.time, &crack.normal_force, &crack.shear_force, &crack.energy})
      ar.value(*value);
    ar.value(crack.mode);
  });
}

template <class Archive, class Self>
void Simulation::visit_start(Archive& archive, Self& s) {
  for (auto* values : {&s.start_x_, &s.start_y_, &s.start_rotation_, &s.start_content_})
    archive.array(*values);
  for (auto* value :
       {&s.start_bond_energy_, &s.start_contact_energy_, &s.start_boundary_work_, &s.start_outside_change_})
    archive.value(*value);
}

void Simulation::save_state(std::vector<std::byte>& image, bool whole) const {
  const auto visit = [&](auto&& archive) {
    visit_state(archive, *this);
    if (whole) visit_start(archive, *this);
  };
  Measurer measurer;
  visit(measurer);
  image.clear();
  image.reserve(measurer.size());
  visit(Saver(image));
}

void Simulation::load_state(std::span<const std::byte> image, bool whole) {
  Loader loader(image);
  visit_state(loader, *this);
  if (whole) visit_start(loader, *this);
  if (loader.left() != 0)
    throw Error(ErrorKind::argument, "the state image is longer than this simulation's state.");
  boundary_->restore_load(assembly_, options().stress_sigma_H, options().stress_sigma_h);
  solver_->after_restore();
}

std::uint64_t Simulation::state_hash() const {
  Hasher hasher;
  visit_state(hasher, *this);
  visit_start(hasher, *this);
  return hasher.result();
}

// Image in memory: magic, format, byte order, fingerprint of the model, size and checksum of the state, the state.
namespace {

struct ImageHeader {
  char magic[8];
  std::uint32_t format;
  std::uint32_t byte_order;
  std::uint64_t model, size, checksum;
};
constexpr char image_magic[8] = {'h', 'f', 'r', 'a', 'c', 'i', 'm', 'g'};
constexpr std::uint32_t image_format = 2, image_byte_order = 0x01020304;

std::uint64_t checksum(std::span<const std::byte> bytes) {
  Hash hash;
  std::size_t k = 0;
  for (; k + 8 <= bytes.size(); k += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + k, 8);
    hash.add(word);
  }
  for (; k < bytes.size(); ++k) hash.add(static_cast<std::uint64_t>(bytes[k]));
  return hash.value();
}

[[noreturn]] void refuse(const char* why) {
  throw Error(ErrorKind::argument, std::string("the state image cannot be restored: ") + why);
}

}  // namespace

std::uint64_t Simulation::model_fingerprint() const {
  Hash hash;
  hash.add_all(assembly_.x);
  hash.add_all(assembly_.y);
  hash.add_all(assembly_.radius);
  hash.add_all(assembly_.bond_radius);
  hash.add(assembly_.tensile_per_radius);
  hash.add(assembly_.shear_per_radius);
  hash.add_all(network_.volume);
  return hash.value();
}

std::vector<std::byte> Simulation::image() const {
  std::vector<std::byte> state;
  save_state(state, true);
  ImageHeader header{};
  std::memcpy(header.magic, image_magic, sizeof header.magic);
  header.format = image_format;
  header.byte_order = image_byte_order;
  header.model = model_fingerprint();
  header.size = state.size();
  header.checksum = checksum(state);
  std::vector<std::byte> image(sizeof header + state.size());
  std::memcpy(image.data(), &header, sizeof header);
  std::memcpy(image.data() + sizeof header, state.data(), state.size());
  return image;
}

void Simulation::restore(std::span<const std::byte> image) {
  ImageHeader header{};
  if (image.size() < sizeof header) refuse("it is shorter than an image's header.");
  std::memcpy(&header, image.data(), sizeof header);
  const auto state = image.subspan(sizeof header);
  if (std::memcmp(header.magic, image_magic, sizeof header.magic) != 0)
    refuse("it is not an image of this library.");
  if (header.byte_order != image_byte_order) refuse("it comes from a machine of the other byte order.");
  if (header.format != image_format) refuse("it has another format version than this library reads.");
  if (header.size != state.size() || header.checksum != checksum(state))
    refuse("it is damaged: size or checksum differ.");
  if (header.model != model_fingerprint()) refuse("it was taken from another model.");
  std::vector<std::byte> before;
  save_state(before, true);
  try {
    load_state(state, true);
  } catch (...) {
    load_state(before, true);
    throw;
  }
}

}  // namespace hfrac
