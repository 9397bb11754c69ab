// SPDX-License-Identifier: BSD-3-Clause
#include "step/snapshot.hpp"

#include "core/error.hpp"
#include "model/visit_state.hpp"
#include "step/slips.hpp"
#include "step/stages.hpp"

namespace hfrac {

namespace {

std::size_t size_here(const Engine& e, bool whole) {
  Counter counter(!whole, e.workers.get());
  visit_state(counter, e.model, e.wet());
  if (whole) visit_start(counter, e.model, e.wet());
  return counter.size();
}

void write_here(const Engine& e, std::span<std::byte> state, bool whole) {
  Saver saver(state, !whole, e.workers.get());
  visit_state(saver, e.model, e.wet());
  if (whole) visit_start(saver, e.model, e.wet());
}

// As the host's arrays stand.
void save_here(const Engine& e, std::vector<std::byte>& state, bool whole) {
  const std::size_t size = size_here(e, whole);
  if (state.capacity() < size) {
    // Not both at once, nor a hole where the smaller one was; and room for the contacts to come.
    std::vector<std::byte>().swap(state);
    state.reserve(size + size / 64);
    return_unused_pages();
  }
  state.resize(size);
  write_here(e, state, whole);
}

void load_here(Engine& e, std::span<const std::byte> image, bool whole, bool of_a_step) {
  Loader loader(image, !whole);
  visit_state(loader, e.model, e.wet());
  if (whole) visit_start(loader, e.model, e.wet());
  if (loader.left() != 0)
    throw Error(ErrorKind::argument, "the state image is longer than this simulation's state.");
  if (of_a_step) e.mechanics->take_back();
  follow_state(e);
}

}  // namespace

void follow_state(Engine& e) {
  e.take_wells();
  count_logged_slips(e.model);
  feel_heat_again(e);
  e.facets.update(e.model.assembly, e.model.network, true);
  e.model.network.planes.refresh(e.model.network, e.model.assembly);
  e.mechanics->after_restore(e.model.far_field.sigma_Hmax, e.model.far_field.sigma_hmin);
}

std::size_t state_size(const Engine& e, bool whole) {
  e.mechanics->bring_home();
  return size_here(e, whole);
}

void write_state(const Engine& e, std::span<std::byte> state, bool whole) {
  e.mechanics->bring_home();
  write_here(e, state, whole);
}

void save_state(const Engine& e, std::vector<std::byte>& state, bool whole) {
  e.mechanics->bring_home();
  save_here(e, state, whole);
}

void load_state(Engine& e, std::span<const std::byte> image, bool whole) {
  e.mechanics->forget_device();
  load_here(e, image, whole, false);
}

// What a device holds stays there: a copy of it, too. Of that the image has what the host last knew.
void save_before_step(Engine& e, std::vector<std::byte>& state) {
  e.mechanics->keep_for_step();
  save_here(e, state, false);
}

void load_before_step(Engine& e, std::span<const std::byte> image) {
  e.mechanics->forget_device();
  load_here(e, image, false, true);
}

bool is_finite(const Engine& e) {
  FiniteCheck check(e.workers.get());
  visit_state(check, e.model, e.wet());
  return check.finite() && e.mechanics->holds_numbers();
}

std::uint64_t hash_of_state(const Engine& e) {
  e.mechanics->bring_home();
  Hasher hasher;
  visit_state(hasher, e.model, e.wet());
  visit_start(hasher, e.model, e.wet());
  return hasher.result();
}

}  // namespace hfrac
