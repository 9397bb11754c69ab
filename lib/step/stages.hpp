// SPDX-License-Identifier: BSD-3-Clause
// The stages of a step that all steppers share (steppers.hpp says what each is for, and their order).
#pragma once

#include <cstddef>

#include "step/engine.hpp"

namespace hfrac {

// An entry of a schedule that is due at the model's time.
bool is_due(const Engine& engine, const ScheduleEntry& entry);

void drive_wells(Engine& engine);
// Fluid for `duration` seconds, heat with it, and what the rock feels of it.
void move_fluid(Engine& engine, double duration);
void carry_second_fluid(Engine& engine, double duration);
void move_heat(Engine& engine, double duration);
// Growth and micro-parameters follow the temperatures; after a restore they are found again.
void feel_heat(Engine& engine);
void feel_heat_again(Engine& engine);
void update_geometry(Engine& engine);
void close_step(Engine& engine, double duration, std::size_t cracks_before);

}  // namespace hfrac
