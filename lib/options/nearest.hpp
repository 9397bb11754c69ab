// SPDX-License-Identifier: BSD-3-Clause
// The known name a user most likely meant.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace hfrac {

// Fewest insertions, deletions, replacements and swaps of neighbours that turn one text into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

// The candidate closest to `name`, empty if none is close enough to be worth suggesting. A candidate that
// ends in the same last part (after the dot) counts as close: packing.density finds disc.density.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace hfrac
