// SPDX-License-Identifier: BSD-3-Clause
#include "model/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/hash.hpp"
#include "core/random.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Rock has cracks before it is tested: contacts without bond, drawn by where they lie. Discs keep enough bonds to be held.
void leave_unbonded(Assembly& a, double share) {
  constexpr std::int64_t fewest = 3;
  Array<std::int64_t> bonds(a.x.size(), 0);  // of each disc
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    for (const auto disc : {a.first[e], a.second[e]}) bonds[disc] += a.intact[e] == 0 ? 0 : 1;
  }
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    auto &here = bonds[a.first[e]], &there = bonds[a.second[e]];
    if (a.intact[e] == 0 || std::min(here, there) <= fewest) continue;
    Hash place;
    place.add(a.dx(e));
    place.add(a.dy(e));
    if (Random(place.value()).uniform() >= share) continue;
    a.intact[e] = 0;
    --here;
    --there;
  }
}

}  // namespace

Assembly build_assembly(ContactGraph graph, const Options& options) {
  Assembly a;
  a.x = std::move(graph.x);
  a.y = std::move(graph.y);
  a.radius = std::move(graph.radius);
  a.first = std::move(graph.first);
  a.second = std::move(graph.second);
  a.part_first_bond = std::move(graph.part_first_edge);
  a.tile_first_pair = std::move(graph.tile_first_pair);
  a.mean_radius = graph.mean_radius;
  a.sizes = std::move(graph.sizes);
  a.density = options.disc_density;
  const std::size_t n = a.x.size(), bonds = a.first.size();
  for (auto* values :
       {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.external_x, &a.external_y, &a.external_moment})
    values->assign(n, 0.0);

  // Toughness of a bonded assembly goes with strength times sqrt(R) (Potyondy and Cundall 2004): strengths given for
  // one mean radius serve any resolution of the same rock.
  if (options.bond_toughness_reference_radius > 0.0) {
    a.strength_factor = std::sqrt(options.bond_toughness_reference_radius / a.mean_radius);
  }
  a.tensile_per_radius = 2.0 * options.bond_tensile_strength * a.strength_factor;
  a.shear_per_radius = 2.0 * options.bond_shear_strength * a.strength_factor;
  a.geometry.lay_out(a.part_first_bond);
  a.intact.assign(graph.bonded.begin(), graph.bonded.end());
  a.slip.assign(bonds, 0.0);
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = a.first[e], j = a.second[e];
    const double dx = a.x[j] - a.x[i], dy = a.y[j] - a.y[i], length = std::sqrt(dx * dx + dy * dy);
    const auto bond = static_cast<std::int64_t>(e);
    a.geometry.put(a.part_of(bond), bond,
                   {dx, dy, length, length * a.radius[i] / (a.radius[i] + a.radius[j]),
                    options.bond_radius_factor * std::min(a.radius[i], a.radius[j])});
  }
  if (options.bond_open_share > 0.0) leave_unbonded(a, options.bond_open_share);
  if (a.sizes.graded() && options.bond_toughness_reference_radius > 0.0) {
    for (std::int64_t e = 0; e < a.bond_count(); ++e)
      a.strength_scale.push_back(std::sqrt(a.mean_radius / a.mean_radius_of(e)));
    combine_factors(a, options);
  }
  return a;
}

std::int64_t Assembly::bond_between(std::int32_t i, std::int32_t j) const {
  if (i > j) std::swap(i, j);
  // Each part is sorted by (first, second), those inside a tile by rank.
  const auto from = static_cast<std::size_t>(i / tile_size), to = static_cast<std::size_t>(j / tile_size);
  const bool across = from != to;
  auto part = from;
  if (across) {
    part = static_cast<std::size_t>(tile_first_pair[from]);
    const auto end = static_cast<std::size_t>(tile_first_pair[from + 1]);
    while (part < end && static_cast<std::size_t>(second[part_first_bond[part]] / tile_size) != to) ++part;
    if (part == end) return -1;
  }
  const std::int64_t begin = part_first_bond[part], count = part_first_bond[part + 1] - begin;
  const auto place = [&](std::int64_t rank) { return begin + (across ? rank : edge_at(rank, count)); };
  std::int64_t low = 0, high = count;
  while (low < high) {
    const auto middle = low + (high - low) / 2, e = place(middle);
    const bool before = first[e] != i ? first[e] < i : second[e] < j;
    (before ? low : high) = before ? middle + 1 : middle;
  }
  if (low == count) return -1;
  const auto e = place(low);
  return first[e] == i && second[e] == j ? e : -1;
}

}  // namespace hfrac
