// SPDX-License-Identifier: BSD-3-Clause
#include "solid/non_bonded_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "geom/cell_grid.hpp"

namespace hfrac {
namespace {

constexpr double search_gap = 0.4;   // pairs up to this gap are listed, in mean radii
constexpr double search_move = 0.1;  // listed anew when a disc moved this far, in mean radii

// But for bonds in place of which a contact of a smooth joint answers: those leave the rock on either side of the joint as whole as it was, and
// no disc of one side bears on one of the other.
std::vector<std::int32_t> discs_with_broken_bonds(const Assembly& a, const CrackLog& cracks) {
  std::vector<std::int32_t> discs;
  for (const auto& crack : cracks) {
    if (a.smooth.of(crack.bond) != nullptr) continue;
    discs.push_back(a.first[crack.bond]);
    discs.push_back(a.second[crack.bond]);
  }
  std::sort(discs.begin(), discs.end());
  discs.erase(std::unique(discs.begin(), discs.end()), discs.end());
  return discs;
}

double gap_of(const Assembly& a, std::int32_t i, std::int32_t j) {  // m
  const Vec2 d = a.position(j) - a.position(i);
  return norm(d) - a.radius[i] - a.radius[j] - a.thermal.growth_of(i) - a.thermal.growth_of(j);
}

// The few discs beside cracks are sorted into cells; all others only ask whether one of those is near, which needs neither
// memory nor, away from the cracks, more than a look at their bounding box.
std::vector<NonBondedContacts::Pair> pairs_near_cracks(const Assembly& a,
                                                       const std::vector<std::int32_t>& cracked) {
  if (cracked.empty()) return {};
  const double largest = *std::max_element(a.radius.begin(), a.radius.end());
  std::vector<double> x, y;
  for (const auto i : cracked) {
    const Vec2 p = a.position(i);
    x.push_back(p.x);
    y.push_back(p.y);
  }
  const double cell = 2.0 * largest + search_gap * a.coarsest_radius();
  const CellGrid grid(x, y, cell);
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  std::vector<NonBondedContacts::Pair> found;
  for (std::int64_t d = 0; d < a.disc_count(); ++d) {
    const Vec2 p = a.position(d);
    if (p.x < *left - cell || p.x > *right + cell || p.y < *low - cell || p.y > *high + cell) continue;
    const auto j = static_cast<std::int32_t>(d);
    const double reach = search_gap * a.mean_radius_at({a.x[d], a.y[d]});
    grid.near(p.x, p.y, cell, [&](std::int32_t k) {
      const auto i = cracked[static_cast<std::size_t>(k)];
      if (i == j) return;
      const double touch = a.radius[i] + a.radius[j];
      const auto at = static_cast<std::size_t>(k);
      if (std::hypot(p.x - x[at], p.y - y[at]) - touch > reach || a.bond_between(i, j) >= 0) return;
      // Across a smooth joint its own contacts bear everything.
      if (a.smooth.separate(i, {a.x[i], a.y[i]}, j, {a.x[j], a.y[j]})) return;
      const double at_bonding = std::hypot(a.x[j] - a.x[i], a.y[j] - a.y[i]) - touch;
      found.push_back({std::min(i, j), std::max(i, j), std::min(0.0, at_bonding)});
    });
  }
  return found;
}

}  // namespace

bool NonBondedContacts::is_due(const Assembly& a, const CrackLog& cracks) const {
  if (cracks.empty()) return false;
  bool due = cracks.size() != list_.cracks_seen;
  for (std::size_t k = 0; k < list_.cracked.size() && !due; ++k) {
    const auto i = list_.cracked[k];
    const double limit = search_move * a.mean_radius_at({a.x[i], a.y[i]});
    due = std::hypot(a.ux[i] - list_.searched_x[k], a.uy[i] - list_.searched_y[k]) > limit;
  }
  return due;
}

bool NonBondedContacts::search(Assembly& a, const Boundary& boundary, const CrackLog& cracks) {
  if (!is_due(a, cracks)) return false;
  list_.cracked = discs_with_broken_bonds(a, cracks);
  list_.cracks_seen = cracks.size();
  list_.searched_x.clear();
  list_.searched_y.clear();
  list_.searched_x.reserve(list_.cracked.size());
  list_.searched_y.reserve(list_.cracked.size());
  for (const auto i : list_.cracked) {
    list_.searched_x.push_back(a.ux[i]);
    list_.searched_y.push_back(a.uy[i]);
  }
  std::vector<Pair> found = pairs_near_cracks(a, list_.cracked);
  const auto before = [](const Pair& p, const Pair& q) {
    return p.first != q.first ? p.first < q.first : p.second < q.second;
  };
  std::sort(found.begin(), found.end(), before);
  found.erase(
      std::unique(found.begin(), found.end(),
                  [](const Pair& p, const Pair& q) { return p.first == q.first && p.second == q.second; }),
      found.end());
  for (auto& pair : found) {
    const auto old = std::lower_bound(list_.pairs.begin(), list_.pairs.end(), pair, before);
    if (old != list_.pairs.end() && old->first == pair.first && old->second == pair.second) {
      pair = *old;
    } else {
      pair.reference_gap = std::min(pair.reference_gap, gap_of(a, pair.first, pair.second));
    }
  }
  release(a, boundary);
  list_.pairs.swap(found);
  list_.discs.clear();
  for (const auto& pair : list_.pairs) {
    list_.discs.push_back(pair.first);
    list_.discs.push_back(pair.second);
  }
  std::sort(list_.discs.begin(), list_.discs.end());
  list_.discs.erase(std::unique(list_.discs.begin(), list_.discs.end()), list_.discs.end());
  return true;
}

// The boundary's own force back onto the discs of the list.
void NonBondedContacts::release(Assembly& a, const Boundary& boundary) {
  for (const auto i : list_.discs) {
    a.external_moment[i] = 0.0;
    if (boundary.touches_wall(i)) continue;  // written anew in every cycle
    const Vec2 load = boundary.load_on(i);
    a.external_x[i] = load.x;
    a.external_y[i] = load.y;
  }
}

void NonBondedContacts::cycle(Assembly& a, double step, double& friction) {
  for (auto& pair : list_.pairs) {
    const auto i = pair.first, j = pair.second;
    const double stiffness = a.thermal.pair_stiffness(i, j);
    const double kn = options_.contact_normal_stiffness * stiffness,
                 ks = options_.contact_shear_stiffness * stiffness;
    const Vec2 d = a.position(j) - a.position(i);
    const double distance = norm(d);
    const double gap = distance - a.radius[i] - a.radius[j] - pair.reference_gap - a.thermal.growth_of(i) -
                       a.thermal.growth_of(j);
    if (gap >= 0.0) {
      pair.shear_force = pair.normal_force = 0.0;
      continue;
    }
    const Vec2 normal = (1.0 / distance) * d, tangent{-normal.y, normal.x};
    const double share = distance / (a.radius[i] + a.radius[j]), arm_i = share * a.radius[i],
                 arm_j = share * a.radius[j];
    const Vec2 speed{a.vx[j] - a.vx[i], a.vy[j] - a.vy[i]};
    const double slide = step * (dot(speed, tangent) - a.spin[i] * arm_i - a.spin[j] * arm_j);
    pair.normal_force = -kn * gap;
    const double limit = options_.contact_friction * a.thermal.pair_friction(i, j) * pair.normal_force;
    const double trial = pair.shear_force + ks * slide;
    pair.shear_force = std::clamp(trial, -limit, limit);
    if (ks > 0.0) friction += std::abs(pair.shear_force * (trial - pair.shear_force)) / ks;
    const Vec2 on_first = -pair.normal_force * normal + pair.shear_force * tangent;
    a.external_x[i] += on_first.x;
    a.external_y[i] += on_first.y;
    a.external_x[j] -= on_first.x;
    a.external_y[j] -= on_first.y;
    a.external_moment[i] += pair.shear_force * arm_i;
    a.external_moment[j] += pair.shear_force * arm_j;
  }
}

void NonBondedContacts::add_stiffness(const Assembly& a, std::span<double> row_x, std::span<double> row_y,
                                      std::span<double> row_rotation) const {
  for (const auto& pair : list_.pairs) {
    const double share = a.thermal.pair_stiffness(pair.first, pair.second);
    const double translation =
        2.0 * (options_.contact_normal_stiffness + options_.contact_shear_stiffness) * share;
    for (const auto i : {pair.first, pair.second}) {
      row_x[i] += translation;
      row_y[i] += translation;
      row_rotation[i] += 5.0 * options_.contact_shear_stiffness * share * a.radius[i] * a.radius[i];
    }
  }
}

double NonBondedContacts::energy(const Assembly& a) const {
  double sum = 0.0;
  for (const auto& pair : list_.pairs) {
    const double share = a.thermal.pair_stiffness(pair.first, pair.second);
    sum += 0.5 * pair.normal_force * pair.normal_force / (options_.contact_normal_stiffness * share);
    if (options_.contact_shear_stiffness > 0.0)
      sum += 0.5 * pair.shear_force * pair.shear_force / (options_.contact_shear_stiffness * share);
  }
  return sum;
}

}  // namespace hfrac
