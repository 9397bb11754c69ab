// SPDX-License-Identifier: BSD-3-Clause
#include "frac/facets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/joint_pores.hpp"

namespace hfrac {
namespace {

constexpr double plane_reach = 4.0;   // mean radii to either side that a fracture's plane is fitted over
constexpr double long_ago = -1e30;    // s
constexpr double shortest_way = 0.2;  // mean radii
constexpr double slot_width = 1e-3;   // m, that a cut slot lets fluid through by at least
constexpr double gauss =
    0.28867513459481287;  // 1 / (2 sqrt(3)): points of the two-point rule from the middle

Vec2 turned(Vec2 v) {
  return {v.y, -v.x};
}
double size(Vec2 v) {
  return std::sqrt(dot(v, v));
}
// What a bond and its contact pull their first disc with, as in the equations of equilibrium (bond_response.cpp).
Vec2 force_on_first(const Assembly& a, std::int64_t e, const BondView& v) {
  const auto i = a.first[e], j = a.second[e];
  const Vec2 now{a.dx(e) + a.ux[j] - a.ux[i], a.dy(e) + a.uy[j] - a.uy[i]};
  const double turn = a.smooth.of(e) != nullptr ? 1.0 : a.length(e) / size(now);
  return v.normal_force() * v.normal + turn * v.shear_force() * Vec2{-v.normal.y, v.normal.x};
}
}  // namespace

// From the contact into the pore on one side, turned so that it points towards the second disc.
Vec2 Facets::part(std::int64_t e, bool left) const {
  const auto d = left ? network_->left[e] : network_->right[e];
  if (network_->kind[d] != DomainKind::rock) return {};
  const Vec2 way = network_->centroid[d] - contact_[e];
  return left ? turned(way) : -1.0 * turned(way);
}

// What a pore pushes on the first disc of a bond, per pressure [m]: over the chord from the contact; the fluid in a joint that conducts
// pushes on the faces of its contacts alone (model/joint_pores.hpp).
Vec2 Facets::pushed(std::int64_t e, bool left) const {
  const auto d = left ? network_->left[e] : network_->right[e];
  if (!in_joint(d)) return part(e, left);
  const SmoothContact* contact = assembly_->smooth.of(e);
  const bool conducts = contact != nullptr && joint_length(*network_, static_cast<std::size_t>(e)) > 0.0;
  return conducts ? 0.5 * contact->area * contact->normal : Vec2{};
}

void Facets::begin(const Assembly& a, Network& n, const std::vector<WellPlace>& wells, const Options& o) {
  plate_ = {o.stress_sigma_Hmax, o.stress_sigma_hmin, {}};
  for (const auto& well : wells)
    plate_.holes.push_back({well.centre, well.equivalent_radius, n.pressure[well.domain], well.domain});
  active_ = true;
  assembly_ = &a;
  network_ = &n;
  start_.stiffness = o.contact_normal_stiffness;
  const auto bonds = a.first.size();
  start_.x = a.ux;
  start_.y = a.uy;
  start_.rotation = a.rotation;
  of_.assign(bonds, -1);
  cut_.assign(bonds, 0);
  fractured_.assign(n.kind.size(), 0);
  bonds_.assign(n.kind.size(), {});
  n.facet_offset.assign(n.kind.size(), 0.0);
  for (auto* values : {&n.facet_opening, &n.facet_way, &n.facet_least}) values->assign(bonds, 0.0);
  n.facet_time.assign(bonds, long_ago);
  biot_ = o.rock_biot_coefficient;
  pressure_.assign(n.pressure.begin(), n.pressure.end());
  for (std::size_t d = 0; d < pressure_.size(); ++d)
    if (n.kind[d] == DomainKind::rock && !in_joint(static_cast<std::int32_t>(d))) pressure_[d] *= biot_;
  pore_push_.assign(2 * bonds, 0.0);
  weight_ = n.corner_weight;
  turn_ = n.corner_turn;
  force_.assign(4 * bonds, 0.0);
  contact_.resize(bonds);
  const auto discs = static_cast<std::size_t>(a.disc_count());
  Array<double> area;
  area.assign(discs, 0.0);
  for (std::size_t e = 0; e < bonds; ++e) {
    const auto i = a.first[e], j = a.second[e];
    const auto b = static_cast<std::int64_t>(e);
    const BondView v = view_bond(a, o, b);
    const Vec2 d = (1.0 / a.length(b)) * Vec2{a.dx(b), a.dy(b)};
    contact_[e] = Vec2{a.x[i], a.y[i]} + a.arm(b) * d;
    bonds_[n.left[e]].push_back(static_cast<std::int32_t>(e));
    if (n.right[e] != n.left[e]) bonds_[n.right[e]].push_back(static_cast<std::int32_t>(e));
    const Vec2 f = force_on_first(a, b, v);
    const double arm_i = a.arm(b), arm_j = a.length(b) - arm_i;
    force_[4 * e] = f.x;
    force_[4 * e + 1] = f.y;
    force_[4 * e + 2] = -(v.shear_force() * arm_i + v.bond_moment);
    force_[4 * e + 3] = -(v.shear_force() * arm_j - v.bond_moment);
    const Vec2 h_l = part(b, true), h_r = part(b, false);
    // Love's mean over a disc and its share of the pores: forces times their arms over the area out to the facets.
    const double facet = std::abs(dot(h_l + h_r, d));
    area[i] += 0.5 * arm_i * facet;
    area[j] += 0.5 * arm_j * facet;
  }
  area_ = area;
  disc_bonds_.assign(discs, {});
  for (std::size_t e = 0; e < bonds; ++e) {
    disc_bonds_[a.first[e]].push_back(static_cast<std::int32_t>(e));
    disc_bonds_[a.second[e]].push_back(static_cast<std::int32_t>(e));
  }
}

void Facets::stress_around(const Assembly& a, const Network& n, const Options& o, std::int32_t domain,
                           double* stress) const {
  std::vector<std::int32_t> discs;
  const auto add = [&](std::int32_t i) {
    if (std::find(discs.begin(), discs.end(), i) == discs.end()) discs.push_back(i);
  };
  for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k) add(n.corner_disc[k]);
  const auto ring = discs;
  for (const auto i : ring)
    for (const auto e : disc_bonds_[i])
      if (a.intact[e] != 0) {
        add(a.first[e]);
        add(a.second[e]);
      }
  double area = 0.0;
  stress[0] = stress[1] = stress[2] = 0.0;
  for (const auto i : discs) {
    area += area_[i];
    const auto initial = plate_.at({a.x[i], a.y[i]});
    stress[0] += area_[i] * initial.xx;
    stress[1] += area_[i] * initial.yy;
    stress[2] += area_[i] * initial.xy;
    for (const auto e : disc_bonds_[i]) {
      const Vec2 d = (1.0 / a.length(e)) * Vec2{a.dx(e), a.dy(e)};
      const Vec2 h_l = pushed(e, true), h_r = pushed(e, false);
      const SmoothContact* joint = a.smooth.of(e);
      // Force on the first disc now less that at the initial equilibrium, fluid included.
      Vec2 now;
      if (of_[e] >= 0) {
        const Facet& f = facets_[of_[e]];
        const double push = n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length;
        const double w = opening(a, n, f);
        now = (w >= 0.0 ? -push : start_.stiffness * jump(a, f, f.normal) - f.initial_normal) * f.normal + f.locked;
      } else {
        const auto borne = [&](std::int32_t pore) {
          if (in_joint(pore)) return n.pressure[pore];
          return fractured_[pore] ? pressure_[pore] : biot_ * n.pressure[pore];
        };
        now = force_on_first(a, e, view_bond(a, o, e)) - (borne(n.left[e]) * h_l + borne(n.right[e]) * h_r);
      }
      const Vec2 before = initial_force(e) - (pressure_[n.left[e]] * h_l + pressure_[n.right[e]] * h_r);
      Vec2 more = now - before;
      const bool is_first = a.first[e] == i;
      Vec2 arm = is_first ? a.arm(e) * d : (a.arm(e) - a.length(e)) * d;
      if (joint != nullptr) arm = is_first ? joint->first_arm : joint->second_arm;
      if (!is_first) more = -1.0 * more;
      stress[0] -= arm.x * more.x;
      stress[1] -= arm.y * more.y;
      stress[2] -= 0.5 * (arm.x * more.y + arm.y * more.x);
    }
  }
  for (int k = 0; k < 3; ++k) stress[k] /= area;
}

double Facets::opening(const Assembly& a, const Network& n, const Facet& f) const {
  const double push = n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length;
  return facet_opening(a, start_, f, push);
}

void Facets::tell_openings(const Assembly& a, Network& n) const {
  for (const Facet& f : facets_) n.facet_opening[f.bond] = std::max(0.0, jump(a, f, f.normal));
}

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
    change += n.corner_weight[2 * k] * a.ux[n.corner_disc[k]] +
              n.corner_weight[2 * k + 1] * a.uy[n.corner_disc[k]];
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
void Facets::tell_motion(const Assembly& a, Network& n) const {
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
  for (const auto e : bonds) pushes.push_back({e, locked_of(e)});
  motion_->take(facets_, std::move(pushes), std::move(faces));
}

void Facets::put_push(const Assembly& a, const Network& n, std::int64_t e) {
  Vec2 push{};
  const auto low = std::min(n.left[e], n.right[e]), high = std::max(n.left[e], n.right[e]);
  if (of_[e] < 0 && a.smooth.of(e) == nullptr)
    for (const auto d : {low, high})
      if (fractured_[d] != 0 && (d == low || high != low))
        push = push - pressure_[d] * pushed(e, n.left[e] == d);
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
  for (std::int64_t e = 0; e < a.bond_count(); ++e) put_push(a, n, e);
  tell_motion(a, n);
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
      for (const auto bond : bonds_[d]) put_push(a, n, bond);
  tell_motion(a, n);
}

// Facets that may lie otherwise for new ones: whose way through the rock's pores (lay_along_fracture) can come to a pore of theirs. The pores
// that such a way goes on from are, but for its first, within its reach of the facet, so within twice that of each other.
std::vector<std::int64_t> Facets::near_to(const Assembly& a, const Network& n,
                                          const std::vector<std::int64_t>& fresh) const {
  const double reach = 2.0 * (1.0 + 1e-9) * plane_reach * a.mean_radius;
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
          if (n.kind[next] != DomainKind::rock ||
              std::find(pores.begin(), pores.end(), next) != pores.end())
            continue;
          take(next);
          if (size(n.centroid[next] - n.centroid[from]) <= reach) pores.push_back(next);
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
    to = hole.centre + (hole.radius / size(out)) * out;
    length = std::abs(dot(turned(to - f.middle), f.normal)) * (size(out) > hole.radius ? 1.0 : -1.0);
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
    double far = size(best - f.middle);
    while (!stack.empty()) {
      const auto [d, by] = stack.back();
      stack.pop_back();
      for (const auto e : bonds_[d]) {
        if (of_[e] < 0 || e == by) continue;
        const auto other = n.left[e] == d ? n.right[e] : n.left[e];
        if (std::find(seen.begin(), seen.end(), other) != seen.end()) continue;
        seen.push_back(other);
        const Vec2 at = n.kind[other] == DomainKind::rock ? n.centroid[other] : contact_[e];
        const double way = size(at - f.middle);
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
  f.normal = turned(along);  // towards the second disc's flank
  if (!(size(f.normal) > 0.0)) f.normal = left + right;
  f.normal = (1.0 / size(f.normal)) * f.normal;
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
  f.locked_first = force_[4 * f.bond + 2];
  f.locked_second = force_[4 * f.bond + 3];
}

}  // namespace hfrac
