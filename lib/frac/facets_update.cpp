// SPDX-License-Identifier: BSD-3-Clause
// Which facets there are, and how they lie: from all bonds, or near those that just broke.
#include <algorithm>
#include <cmath>
#include <utility>

#include "frac/facets.hpp"
#include "model/joint_pores.hpp"

namespace hfrac {
namespace {

constexpr double plane_reach = 4.0;   // mean radii to either side that a fracture's plane is fitted over
constexpr double shortest_way = 0.2;  // mean radii
constexpr double slot_width = 1e-3;   // m, that a cut slot lets fluid through by at least
constexpr double gauss =
    0.28867513459481287;  // 1 / (2 sqrt(3)): points of the two-point rule from the middle

}  // namespace

bool Facets::is_face(const Assembly& a, const Network& n, std::int64_t e) const {
  if (a.intact[e] != 0 || n.left[e] == n.right[e]) return false;
  if (a.smooth.of(e) != nullptr) return false;  // a joint's has a law of its own
  return n.kind[n.left[e]] != DomainKind::outside && n.kind[n.right[e]] != DomainKind::outside;
}

Facet Facets::face_of(const Assembly& a, const Network& n, std::int64_t e) const {
  Facet f;
  f.bond = e;
  f.left = n.left[e];
  f.right = n.right[e];
  f.middle = contact_[e];
  f.slot = cut_[e] != 0;
  for (int side = 0; side < 2; ++side) {
    const auto dom = side == 0 ? f.left : f.right;
    if (n.kind[dom] != DomainKind::rock) continue;
    for (auto k = n.corner_start[dom]; k < n.corner_start[dom + 1]; ++k) {
      if (n.corner_disc[k] == a.first[e]) f.corner[2 * side] = k;
      if (n.corner_disc[k] == a.second[e]) f.corner[2 * side + 1] = k;
    }
  }
  return f;
}

// What a pore was pushed apart by when its fluid began to act on facets instead [m2].
double Facets::change_before(const Assembly& a, const Network& n, std::int32_t d) const {
  // A joint's faces go on as they were (add_face_weights).
  if (in_joint(d)) return 0.0;
  double change = 0.0;
  for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
    change +=
        n.corner_weight[2 * k] * a.ux[n.corner_disc[k]] + n.corner_weight[2 * k + 1] * a.uy[n.corner_disc[k]];
  return change;
}

void Facets::put_weights(Network& n, std::int32_t d, bool open) const {
  const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
  for (auto k = 2 * begin; k < 2 * end; ++k) n.corner_weight[k] = open ? 0.0 : weight_[k];
  if (n.corner_turn.empty()) return;
  for (auto k = begin; k < end; ++k) n.corner_turn[k] = open ? 0.0 : turn_[k];
}

void Facets::put_pipe(Network& n, const Facet& f) const {
  n.facet_way[f.bond] = f.way;
  n.facet_least[f.bond] = f.slot ? slot_width : 0.0;
}

// What the explicit solver has to know.
void Facets::tell_motion(const Assembly& a, Network& n, bool restored) const {
  if (motion_ == nullptr) return;
  std::vector<std::int32_t> pores;
  for (const Facet& f : facets_)
    for (const auto d : {f.left, f.right})
      if (fractured_[d] != 0) pores.push_back(d);
  std::sort(pores.begin(), pores.end());
  pores.erase(std::unique(pores.begin(), pores.end()), pores.end());
  std::vector<std::int64_t> bonds;
  std::vector<FacetMotion::Face> faces;
  for (const auto d : pores) {
    for (const auto e : bonds_[d])
      if (of_[e] < 0 && a.smooth.of(e) == nullptr) bonds.push_back(e);
    if (!in_joint(d)) continue;
    add_face_weights(n, a, d);
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const Vec2 weight{n.corner_weight[2 * k], n.corner_weight[2 * k + 1]};
      if (weight.x != 0.0 || weight.y != 0.0 || n.corner_turn[k] != 0.0)
        faces.push_back({d, n.corner_disc[k], weight, n.corner_turn[k]});
    }
    put_weights(n, d, true);
  }
  std::sort(bonds.begin(), bonds.end());
  bonds.erase(std::unique(bonds.begin(), bonds.end()), bonds.end());
  std::vector<FacetMotion::Push> pushes;
  pushes.reserve(bonds.size());
  for (const auto e : bonds) pushes.push_back({e, locked_of(e)});
  motion_->take(facets_, std::move(pushes), std::move(faces), restored);
}

void Facets::put_push(const Assembly& a, Network& n, std::int64_t e, bool restored) {
  Vec2 push{};
  const auto low = std::min(n.left[e], n.right[e]), high = std::max(n.left[e], n.right[e]);
  if (of_[e] < 0 && a.smooth.of(e) == nullptr)
    for (const auto d : {low, high})
      if (fractured_[d] != 0 && (d == low || high != low))
        push = push - pressure_[d] * pushed(e, n.left[e] == d);
  if (!restored) n.facet_pushed += push_energy(a, start_, e, push - locked_of(e));
  pore_push_[2 * e] = push.x;
  pore_push_[2 * e + 1] = push.y;
}

void Facets::update(const Assembly& a, Network& n, bool restored) {
  if (!active_) return;
  facets_.clear();
  std::fill(of_.begin(), of_.end(), -1);
  std::vector<char> before = fractured_;
  std::fill(fractured_.begin(), fractured_.end(), 0);
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (!is_face(a, n, e)) continue;
    of_[e] = static_cast<std::int32_t>(facets_.size());
    facets_.push_back(face_of(a, n, e));
    for (const auto dom : {n.left[e], n.right[e]})
      if (n.kind[dom] == DomainKind::rock) fractured_[dom] = 1;
  }
  std::fill(n.facet_way.begin(), n.facet_way.end(), 0.0);
  std::fill(n.facet_least.begin(), n.facet_least.end(), 0.0);
  for (auto& f : facets_) {
    lay_along_fracture(a, n, f);
    put_pipe(n, f);
  }
  tell_openings(a, n);
  for (std::int32_t d = 1; d < n.domain_count(); ++d) {
    if (fractured_[d] != before[d]) put_weights(n, d, false);
    if (fractured_[d] == 0) continue;
    if (before[d] == 0 && !restored) n.facet_offset[d] = change_before(a, n, d);
    put_weights(n, d, true);
  }
  for (std::int64_t e = 0; e < a.bond_count(); ++e) put_push(a, n, e, restored);
  tell_motion(a, n, restored);
}

void Facets::add(const Assembly& a, Network& n, std::span<const std::int64_t> broken) {
  if (!active_) return;
  std::vector<std::int64_t> fresh;
  for (const auto e : broken)
    if (of_[e] < 0 && is_face(a, n, e)) fresh.push_back(e);
  std::sort(fresh.begin(), fresh.end());
  for (const auto e : fresh) {
    const auto at = std::lower_bound(facets_.begin(), facets_.end(), e,
                                     [](const Facet& f, std::int64_t bond) { return f.bond < bond; });
    facets_.insert(at, face_of(a, n, e));
  }
  for (std::size_t k = 0; k < facets_.size(); ++k) of_[facets_[k].bond] = static_cast<std::int32_t>(k);
  for (const auto e : fresh)
    for (const auto d : {n.left[e], n.right[e]}) {
      if (n.kind[d] != DomainKind::rock || fractured_[d] != 0) continue;
      n.facet_offset[d] = change_before(a, n, d);
      fractured_[d] = 1;
    }
  for (const auto bond : near_to(a, n, fresh)) {
    Facet& f = facets_[of_[bond]];
    lay_along_fracture(a, n, f);
    put_pipe(n, f);
  }
  tell_openings(a, n);
  for (const Facet& f : facets_)
    for (const auto d : {f.left, f.right})
      if (fractured_[d] != 0) put_weights(n, d, true);
  for (const auto e : fresh)
    for (const auto d : {n.left[e], n.right[e]})
      for (const auto bond : bonds_[d]) put_push(a, n, bond, false);
  tell_motion(a, n, false);
}

// Facets that may lie otherwise for new ones: whose way through the rock's pores (lay_along_fracture) can come to a pore of theirs. The pores
// that such a way goes on from are, but for its first, within its reach of the facet, so within twice that of each other.
std::vector<std::int64_t> Facets::near_to(const Assembly& a, const Network& n,
                                          const std::vector<std::int64_t>& fresh) const {
  const double reach = 2.0 * (1.0 + 1e-9) * plane_reach * a.coarsest_radius();
  std::vector<std::int64_t> near;
  const auto take = [&](std::int32_t pore) {
    for (const auto e : bonds_[pore])
      if (of_[e] >= 0) near.push_back(e);
  };
  for (const auto e : fresh)
    for (const auto from : {n.left[e], n.right[e]}) {
      if (n.kind[from] != DomainKind::rock) continue;
      std::vector<std::int32_t> pores{from};
      take(from);
      for (std::size_t k = 0; k < pores.size(); ++k)
        for (const auto by : bonds_[pores[k]]) {
          if (of_[by] < 0) continue;
          const auto next = n.left[by] == pores[k] ? n.right[by] : n.left[by];
          if (n.kind[next] != DomainKind::rock || std::find(pores.begin(), pores.end(), next) != pores.end())
            continue;
          take(next);
          if (norm(n.centroid[next] - n.centroid[from]) <= reach) pores.push_back(next);
        }
    }
  near.insert(near.end(), fresh.begin(), fresh.end());
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

// Force of the plate's stress on a facet's part on one side. Beside a hole that is what lies between the contact at its wall and the
// circle of the plate, less the hole's pressure: over the hole and along the fracture the plate's stress adds up to the far field's.
Vec2 Facets::mean_force(const Network& n, const Facet& f, bool left) const {
  const auto domain = left ? f.left : f.right;
  Vec2 to = n.kind[domain] == DomainKind::rock ? n.centroid[domain] : f.middle;
  double length = left ? f.left_length : f.right_length, pressure = 0.0;
  for (const auto& hole : plate_.holes) {
    if (hole.domain != domain) continue;
    const Vec2 out = f.middle - hole.centre;
    to = hole.centre + (hole.radius / norm(out)) * out;
    length = std::abs(dot(clockwise(to - f.middle), f.normal)) * (norm(out) > hole.radius ? 1.0 : -1.0);
    pressure = hole.pressure;
  }
  Vec2 sum;
  for (const double at : {0.5 - gauss, 0.5 + gauss}) {
    const auto s = plate_.at(f.middle + at * (to - f.middle));
    sum = sum + 0.5 * length *
                    Vec2{(s.xx - pressure) * f.normal.x + s.xy * f.normal.y,
                         s.xy * f.normal.x + (s.yy - pressure) * f.normal.y};
  }
  return sum;
}

// The facet turned into the fracture around it, from the pores a few facets away on one side to those on the other, and what the mean
// stress releases on it then.
void Facets::lay_along_fracture(const Assembly& a, const Network& n, Facet& f) const {
  const double reach = plane_reach * a.mean_radius_at(f.middle);
  const auto walk = [&](std::int32_t from, std::int32_t to) -> Vec2 {
    // The farthest point that is reached through broken bonds, starting into `to`.
    Vec2 best = n.kind[to] == DomainKind::rock ? n.centroid[to] : f.middle;
    if (n.kind[to] != DomainKind::rock) return best;
    std::vector<std::pair<std::int32_t, std::int64_t>> stack{{to, f.bond}};
    std::vector<std::int32_t> seen{from, to};
    double far = norm(best - f.middle);
    while (!stack.empty()) {
      const auto [d, by] = stack.back();
      stack.pop_back();
      for (const auto e : bonds_[d]) {
        if (of_[e] < 0 || e == by) continue;
        const auto other = n.left[e] == d ? n.right[e] : n.left[e];
        if (std::find(seen.begin(), seen.end(), other) != seen.end()) continue;
        seen.push_back(other);
        const Vec2 at = n.kind[other] == DomainKind::rock ? n.centroid[other] : contact_[e];
        const double way = norm(at - f.middle);
        if (way > far) {
          far = way;
          best = at;
        }
        if (way < reach && n.kind[other] == DomainKind::rock) stack.push_back({other, e});
      }
    }
    return best;
  };
  const Vec2 left = part(f.bond, true), right = part(f.bond, false);
  const Vec2 along = walk(f.right, f.left) - walk(f.left, f.right);
  f.normal = clockwise(along);  // towards the second disc's flank
  if (!(norm(f.normal) > 0.0)) f.normal = left + right;
  f.normal = (1.0 / norm(f.normal)) * f.normal;
  // Negative where the way from pore to pore turns back: along a fracture they add up to the way from end to end.
  f.left_length = dot(left, f.normal);
  f.right_length = dot(right, f.normal);
  f.length = f.left_length + f.right_length;
  f.way = std::max(std::abs(f.length), shortest_way * a.mean_radius_at(f.middle));
  const Vec2 mean = mean_force(n, f, true) + mean_force(n, f, false);
  f.initial_normal = dot(mean, f.normal);
  f.initial_shear = dot(mean, {-f.normal.y, f.normal.x});
  // What the bond bore with the fluid around it, less that of the mean.
  f.locked = initial_force(f.bond) -
             (pressure_[f.left] * pushed(f.bond, true) + pressure_[f.right] * pushed(f.bond, false)) + mean;
  f.initial_energy = energy_[f.bond];
  f.locked_first = force_[4 * f.bond + 2];
  f.locked_second = force_[4 * f.bond + 3];
}

}  // namespace hfrac
