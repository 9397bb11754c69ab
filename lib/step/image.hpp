// SPDX-License-Identifier: BSD-3-Clause
// Images: the whole state as bytes that a host keeps, or a file. A restored simulation goes on bit for bit as the saved one did.
// Images fit the model they were taken from; anything else is refused and changes nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "build/build_model.hpp"
#include "step/engine.hpp"

namespace hfrac {

// Of what never changes: discs, bonds, and the options that a state makes no sense without.
std::uint64_t fingerprint_of(const Engine& engine, const SetupReport& report);

std::size_t image_size(const Engine& engine);
void write_image(const Engine& engine, std::uint64_t fingerprint,
                 std::span<std::byte> image);  // of image_size() bytes
void restore_image(Engine& engine, std::uint64_t fingerprint, std::span<const std::byte> image);

}  // namespace hfrac
