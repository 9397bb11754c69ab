// SPDX-License-Identifier: BSD-3-Clause
#include "solid/tiles.hpp"

#include <algorithm>

namespace hfrac {
namespace {

std::int64_t tile_of(std::int32_t disc) {
  return disc / tile_size;
}

// Tile of all the domain's discs, -1 if they lie in several.
std::int64_t tile_of_domain(const Network& n, std::int64_t d) {
  const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
  const auto tile = tile_of(n.corner_disc[begin]);
  for (auto k = begin + 1; k < end; ++k) {
    if (tile_of(n.corner_disc[k]) != tile) return -1;
  }
  return tile;
}

}  // namespace

TilePlan plan_tiles(const Assembly& a, const Network& n, bool fluid, bool outside_pushes) {
  TilePlan plan;
  const std::int64_t discs = a.disc_count(), bonds = a.bond_count(), domains = n.domain_count();
  const std::int64_t count = (discs + tile_size - 1) / tile_size;
  plan.tiles.assign(static_cast<std::size_t>(count), Tile{});
  for (std::int64_t t = 0; t < count; ++t) {
    plan.tiles[t].first_disc = t * tile_size;
    plan.tiles[t].last_disc = std::min(discs, (t + 1) * tile_size);
  }

  for (std::int64_t t = 0; t < count; ++t) {
    plan.tiles[t].first_bond = a.tile_first_bond[t];
    plan.tiles[t].last_bond = a.tile_first_bond[t + 1];
    plan.tiles[t].first_block = a.geometry.first_block(static_cast<std::size_t>(t));
  }
  plan.first_cross_bond = a.tile_first_bond.back();

  // Pores of a dry model neither push nor answer: none is on the plan.
  if (fluid) plan.cross_domain.push_back(0);
  std::int64_t d = 1;
  for (std::int64_t t = 0; t < count; ++t) {
    plan.tiles[t].first_domain = d;
    while (d < domains && tile_of_domain(n, d) == t) ++d;
    plan.tiles[t].last_domain = d;
  }
  for (; fluid && d < domains; ++d) plan.cross_domain.push_back(static_cast<std::int32_t>(d));

  // A place in the inter-tile force buffer for either end of a bond and every corner of a domain, in the order of discs.
  const auto pushes = [&](std::int32_t domain) { return domain != 0 || outside_pushes; };
  std::vector<std::int32_t> place(static_cast<std::size_t>(discs) + 1, 0);
  for (auto e = plan.first_cross_bond; e < bonds; ++e) {
    ++place[a.first[e] + 1];
    ++place[a.second[e] + 1];
  }
  plan.cross_corner_start.push_back(0);
  std::int32_t corners = 0;
  for (const auto domain : plan.cross_domain) {
    for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k) {
      if (pushes(domain)) ++place[n.corner_disc[k] + 1];
    }
    corners += n.corner_start[domain + 1] - n.corner_start[domain];
    plan.cross_corner_start.push_back(corners);
  }
  for (std::int64_t i = 0; i < discs; ++i) place[i + 1] += place[i];
  for (auto& tile : plan.tiles) {
    tile.first_slot = place[tile.first_disc];
    tile.last_slot = place[tile.last_disc];
  }
  plan.force_buffer.assign(static_cast<std::size_t>(place[discs]), BufferedForce{0.0, 0.0, 0.0, 0});
  const auto take_place = [&](std::int32_t disc) {
    const auto at = place[disc]++;
    plan.force_buffer[at].disc = disc;
    return at;
  };
  plan.bond_slot.reserve(2 * static_cast<std::size_t>(bonds - plan.first_cross_bond));
  for (auto e = plan.first_cross_bond; e < bonds; ++e) {
    plan.bond_slot.push_back(take_place(a.first[e]));
    plan.bond_slot.push_back(take_place(a.second[e]));
  }
  plan.corner_slot.reserve(static_cast<std::size_t>(corners));
  for (const auto domain : plan.cross_domain) {
    for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k)
      plan.corner_slot.push_back(pushes(domain) ? take_place(n.corner_disc[k]) : -1);
  }
  const auto blocks = [](std::int64_t items) { return (items + cross_block - 1) / cross_block; };
  plan.bond_blocks = blocks(bonds - plan.first_cross_bond);
  plan.domain_blocks = blocks(static_cast<std::int64_t>(plan.cross_domain.size()));
  return plan;
}

}  // namespace hfrac
