// SPDX-License-Identifier: BSD-3-Clause
// The state of a model kept in memory, to put it back: before a step, before an increment, when a step is opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "step/engine.hpp"

namespace hfrac {

// `whole`: with what never changes after the initial equilibration, as images have it; without, in a shorter form.
std::size_t state_size(const Engine& engine, bool whole);
void write_state(const Engine& engine, std::span<std::byte> state, bool whole);
void save_state(const Engine& engine, std::vector<std::byte>& state, bool whole = false);
// Throws Error(argument) if the bytes are not those of a state of this model; what is left then is not one.
void load_state(Engine& engine, std::span<const std::byte> state, bool whole = false);
// The same for a step and back, where a device may keep part of the state: a copy of that stays there, too.
void save_before_step(Engine& engine, std::vector<std::byte>& state);
void load_before_step(Engine& engine, std::span<const std::byte> state);
// Makes anew what follows from a state that has just come.
void follow_state(Engine& engine);

// Every number of the state is finite.
bool is_finite(const Engine& engine);
std::uint64_t hash_of_state(const Engine& engine);

}  // namespace hfrac
