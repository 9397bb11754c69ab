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
// before every step, so what cannot change is left out: in a dry model the pores, in any the beginning of the balance.
template <class Archive, class Self>
void Simulation::visit_state(Archive& archive, Self& s) {
  auto& a = s.assembly_;
  auto& n = s.network_;
  for (auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin}) archive.array(*values);
  archive.often_zero(a.slip);
  for (auto* values : {&a.external_x, &a.external_y, &a.external_moment}) archive.mostly_zero(*values);
  archive.flags(a.intact);
  if (FlowScheme{s.options().flow_scheme} != FlowScheme::off) {
    for (auto* values : {&n.aperture, &n.conductance, &n.flow, &n.volume_change, &n.content, &n.pressure,
                         &n.stiffness, &n.outer_excess}) {
      archive.array(*values);
    }
  }
  archive.value(n.zero_stress_aperture);
  archive.often_zero(s.pressure_rate_);
  for (auto* value : {&s.time_, &s.force_ratio_, &s.leaked_, &s.tip_distance_, &s.host_added_, &s.increment_,
                      &s.excess_, &s.formation_pressure_, &s.outside_work_, &s.start_outside_change_,
                      &s.definition_.options.stress_sigma_Hmax, &s.definition_.options.stress_sigma_hmin}) {
    archive.value(*value);
  }
  auto& work = s.work_;
  for (auto* value : {&work.increments, &work.rounds, &work.newton, &work.krylov, &work.factors,
                      &work.rejected_error, &work.rejected_strength, &work.rejected_divergence})
    archive.value(*value);
  archive.value(s.step_);
  archive.value(s.at_rest_);
  archive.value(s.outer_is_hosts_);
  archive.value(s.flow_rounds_);
  s.boundary_->visit_state(archive);
  s.solver_->visit_state(archive);
  archive.list(s.wells_, [&n](auto& ar, auto& well) {
    ar.value(well.place.centre.x);
    ar.value(well.place.centre.y);
    ar.value(well.place.equivalent_radius);
    ar.value(well.place.domain);
    ar.require(well.place.domain > 0 && well.place.domain < n.domain_count());
    ar.value(well.control);
    ar.require(well.control >= WellControl::pressure && well.control <= WellControl::rate);
    for (auto* value : {&well.target_pressure, &well.ramp_per_step, &well.set_rate, &well.rate,
                        &well.injected, &well.content, &well.taken})
      ar.value(*value);
    // Hashes of runs without a schedule are what they were before there were any.
    constexpr bool hashing = std::is_same_v<std::decay_t<decltype(ar)>, Hasher>;
    if (!hashing || !well.schedule.empty()) {
      ar.value(well.next);
      ar.list(well.schedule, [](auto& inner, auto& entry) {
        inner.value(entry.time);
        inner.value(entry.value);
        inner.value(entry.control);
      });
    }
    for (auto* values : {&n.pressure, &n.content, &n.stiffness}) ar.value((*values)[well.place.domain]);
  });
  archive.require(s.wells_.size() == s.definition_.wells.size());
  archive.list(s.cracks_, [&a](auto& ar, auto& crack) {
    ar.value(crack.bond);
    ar.require(crack.bond >= 0 && crack.bond < a.bond_count());
    ar.value(crack.step);
    ar.value(crack.cycle);
    for (auto* value : {&crack.time, &crack.normal_force, &crack.shear_force, &crack.energy})
      ar.value(*value);
    ar.value(crack.mode);
    ar.require(crack.mode == CrackMode::tension || crack.mode == CrackMode::shear);
  });
  // A model without temperature has the image, and the hash, that it had before there was any.
  if (s.heat_) HeatState::visit(archive, s.heat_->state);
  archive.require(s.solver_->non_bonded_contacts().fits(a.disc_count()));
}

// By domain in any image. In a dry model the start is what there is now but for the wells, and only those are kept.
template <class Archive, class Self>
void Simulation::visit_start_content(Archive& archive, Self& s) {
  if (s.flow_) {
    archive.array(s.start_content_);
    return;
  }
  Array<double> content = s.network_.content;
  for (std::size_t w = 0; w < s.wells_.size(); ++w) content[s.wells_[w].place.domain] = s.start_content_[w];
  archive.array(content);
  if constexpr (Archive::loading) {
    for (std::size_t w = 0; w < s.wells_.size(); ++w) s.start_content_[w] = content[s.wells_[w].place.domain];
  }
}

template <class Archive, class Self>
void Simulation::visit_start(Archive& archive, Self& s) {
  for (auto* values : {&s.start_x_, &s.start_y_, &s.start_rotation_}) archive.array(*values);
  visit_start_content(archive, s);
  for (auto* value : {&s.start_bond_energy_, &s.start_contact_energy_, &s.start_boundary_work_})
    archive.value(*value);
}

bool Simulation::is_finite() const {
  FiniteCheck check;
  visit_state(check, *this);
  return check.finite();
}

std::size_t Simulation::state_size(bool whole) const {
  Counter counter(!whole);
  visit_state(counter, *this);
  if (whole) visit_start(counter, *this);
  return counter.size();
}

void Simulation::write_state(std::span<std::byte> state, bool whole) const {
  Saver saver(state, !whole);
  visit_state(saver, *this);
  if (whole) visit_start(saver, *this);
}

void Simulation::save_state(std::vector<std::byte>& state, bool whole) const {
  const std::size_t size = state_size(whole);
  if (state.capacity() < size) {
    // Not both at once; and room for the cracks to come.
    state = {};
    state.reserve(size + size / 64);
  }
  state.resize(size);
  write_state(state, whole);
}

void Simulation::load_state(std::span<const std::byte> image, bool whole) {
  Loader loader(image, !whole);
  visit_state(loader, *this);
  if (whole) visit_start(loader, *this);
  if (loader.left() != 0)
    throw Error(ErrorKind::argument, "the state image is longer than this simulation's state.");
  feel_again();
  network_.planes.refresh(network_, assembly_);
  solver_->after_restore(options().stress_sigma_Hmax, options().stress_sigma_hmin);
}

std::uint64_t Simulation::state_hash() const {
  Hasher hasher;
  visit_state(hasher, *this);
  visit_start(hasher, *this);
  return hasher.result();
}

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
constexpr std::uint32_t image_format = 3, image_byte_order = 0x01020304;

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

std::uint64_t Simulation::model_fingerprint() const {
  Hash hash;
  hash.add_all(assembly_.x);
  hash.add_all(assembly_.y);
  hash.add_all(assembly_.radius);
  for (std::int64_t e = 0; e < assembly_.bond_count(); ++e) hash.add(assembly_.bond_radius(e));
  hash.add(assembly_.tensile_per_radius);
  hash.add(assembly_.shear_per_radius);
  hash.add_all(assembly_.strength_scale);
  for (const auto* values : {&assembly_.joint_tensile, &assembly_.joint_shear, &assembly_.joint_friction})
    hash.add_all(*values);
  for (const auto& contact : assembly_.smooth.contacts) {
    for (const double value :
         {static_cast<double>(contact.bond), contact.normal.x, contact.normal.y, contact.area,
          assembly_.smooth.normal_stiffness, assembly_.smooth.shear_stiffness})
      hash.add(value);
  }
  hash.add_all(network_.volume);
  if (setup_.unbonded > 0) hash.add(bonds_given_);
  for (const auto& info : option_table()) {
    const bool thermal = heat_ && std::string_view(info.key).starts_with("thermal.");
    if (thermal || is_of_the_model(info.key)) hash.add(get_value(options(), info));
  }
  return hash.value();
}

std::size_t Simulation::image_size() const {
  return sizeof(ImageHeader) + state_size(true);
}

void Simulation::write_image(std::span<std::byte> image) const {
  const auto state = image.subspan(sizeof(ImageHeader));
  write_state(state, true);
  ImageHeader header{};
  std::memcpy(header.magic, image_magic, sizeof header.magic);
  header.format = image_format;
  header.byte_order = image_byte_order;
  header.model = model_;
  header.size = state.size();
  header.checksum = checksum(header, state);
  std::memcpy(image.data(), &header, sizeof header);
}

void Simulation::restore(std::span<const std::byte> image) {
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
  if (header.model != model_) {
    refuse(
        "it was taken from another model: discs, wells, or options of model, disc, contact, bond, boundary, "
        "fluid, flow or "
        "thermal differ.");
  }
  std::vector<std::byte> before;
  save_state(before, true);
  try {
    load_state(state, true);
    FiniteCheck start;  // where the balance begins; what else is not finite the next step finds
    visit_start(start, *this);
    if (!start.finite()) refuse("it holds a number that is not finite.");
  } catch (...) {
    load_state(before, true);
    throw;
  }
}

}  // namespace hfrac
