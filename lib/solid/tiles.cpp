// SPDX-License-Identifier: BSD-3-Clause
#include "solid/tiles.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hfrac {
namespace {

std::int64_t tile_of(std::int32_t disc) {
  return disc / tile_size;
}

// The first and the last tile that a domain's discs are of.
struct Touched {
  std::int64_t first, last;
};

Touched tiles_of_domain(const Network& n, std::int64_t d) {
  const auto [low, high] = std::minmax_element(n.corner_disc.begin() + n.corner_start[d],
                                               n.corner_disc.begin() + n.corner_start[d + 1]);
  return {tile_of(*low), tile_of(*high)};
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

  plan.cross_parts.assign(static_cast<std::size_t>(count) + 1, CrossPart{});
  for (std::int64_t t = 0; t < count; ++t) {
    const auto part = static_cast<std::size_t>(t);
    plan.tiles[t].first_bond = a.part_first_bond[part];
    plan.tiles[t].last_bond = a.part_first_bond[part + 1];
    plan.tiles[t].first_block = a.geometry.first_block(part);
    plan.cross_parts[t].first_pair = a.tile_first_pair[part] - count;
    plan.cross_parts[t].last_pair = a.tile_first_pair[part + 1] - count;
  }
  for (auto part = static_cast<std::size_t>(count); part + 1 < a.part_first_bond.size(); ++part)
    plan.pairs.push_back(
        {a.part_first_bond[part], a.part_first_bond[part + 1], a.geometry.first_block(part)});
  auto& outside = plan.cross_parts.back();
  outside.first_pair = outside.last_pair = static_cast<std::int64_t>(plan.pairs.size());

  // Pores of a dry model neither push nor answer: none is on the plan.
  std::int64_t d = 1;
  for (std::int64_t t = 0; t < count; ++t) {
    plan.tiles[t].first_domain = d;
    for (; d < domains; ++d) {
      const auto [first, last] = tiles_of_domain(n, d);
      if (first != t || last != t) break;
    }
    plan.tiles[t].last_domain = d;
  }
  std::vector<std::int64_t> first_tile(static_cast<std::size_t>(domains), count);  // the outside comes last
  for (auto k = d; fluid && k < domains; ++k) {
    first_tile[k] = tiles_of_domain(n, k).first;
    plan.cross_domain.push_back(static_cast<std::int32_t>(k));
  }
  if (fluid) plan.cross_domain.push_back(0);
  std::stable_sort(plan.cross_domain.begin(), plan.cross_domain.end(),
                   [&](std::int32_t p, std::int32_t q) { return first_tile[p] < first_tile[q]; });
  std::int64_t place_of_domain = 0;
  for (std::int64_t t = 0; t <= count; ++t) {
    auto& part = plan.cross_parts[t];
    part.first_domain = place_of_domain;
    const auto listed = static_cast<std::int64_t>(plan.cross_domain.size());
    while (place_of_domain < listed && first_tile[plan.cross_domain[place_of_domain]] == t) ++place_of_domain;
    part.last_domain = place_of_domain;
  }

  // A place in the inter-tile force buffer for either end of a bond, in the order of discs.
  std::vector<std::int32_t> place(static_cast<std::size_t>(discs) + 1, 0);
  for (auto e = a.first_cross_bond(); e < bonds; ++e) {
    ++place[a.first[e] + 1];
    ++place[a.second[e] + 1];
  }
  std::partial_sum(place.begin(), place.end(), place.begin());
  // Corners of pores across by tile, pore by pore, so that what belongs to one is together; but for those that push nobody.
  const auto each_corner = [&](const auto& visit) {
    for (const auto domain : plan.cross_domain) {
      if (domain == 0 && !outside_pushes) continue;
      for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k)
        visit(CrossCorner{n.corner_disc[k], domain, k});
    }
  };
  each_corner([&](const CrossCorner& c) { ++plan.tiles[tile_of(c.disc)].last_corner; });
  std::int64_t corners = 0;
  for (auto& tile : plan.tiles) {
    tile.first_slot = place[tile.first_disc];
    tile.last_slot = place[tile.last_disc];
    tile.first_corner = corners;
    corners += std::exchange(tile.last_corner, corners);
  }
  plan.cross_corner.resize(static_cast<std::size_t>(corners));
  each_corner(
      [&](const CrossCorner& c) { plan.cross_corner[plan.tiles[tile_of(c.disc)].last_corner++] = c; });
  plan.force_buffer.assign(static_cast<std::size_t>(place[discs]), BufferedForce{0.0, 0.0, 0.0, 0});
  const auto take_place = [&](std::int32_t disc) {
    const auto at = place[disc]++;
    plan.force_buffer[at].disc = disc;
    return at;
  };
  plan.bond_slot.reserve(2 * static_cast<std::size_t>(bonds - a.first_cross_bond()));
  for (auto e = a.first_cross_bond(); e < bonds; ++e) {
    plan.bond_slot.push_back(take_place(a.first[e]));
    plan.bond_slot.push_back(take_place(a.second[e]));
  }
  return plan;
}

}  // namespace hfrac
