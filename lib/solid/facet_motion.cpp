// SPDX-License-Identifier: BSD-3-Clause
#include "solid/facet_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/far_discs.hpp"
#include "model/joint_pores.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr double settled = 1e-11;  // of the largest pressure
constexpr int most_sweeps = 400;

void sort_out(std::vector<std::int32_t>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The bonds around a tip break when the openings behind it say so (frac/tip.hpp), not by what they bear.
void hold_bonds_around(Assembly& a, const Network& n, std::int32_t domain) {
  for (auto k = n.corner_start[domain]; k < n.corner_start[domain + 1]; ++k) {
    const auto corner = n.corner(domain, k);
    const auto bond = a.bond_between(corner.disc, corner.after);
    if (bond >= 0) hold_bond(a, bond);
  }
}

}  // namespace

void hold_bond(Assembly& a, std::int64_t bond) {
  a.factors.tensile[bond] = a.factors.shear[bond] = never_breaks;
}

bool FacetMotion::at_tip(std::int32_t domain) const {
  return options_.bond_fracture_toughness > 0.0 && count_[domain] == 1 &&
         !joint_passes(network_, assembly_, domain);
}

void FacetMotion::begin(const FacetStart& start, const Array<double>& weight) {
  start_ = &start;
  weight_ = &weight;
  refill_factors(assembly_, options_);
  count_.assign(network_.kind.size(), 0);
  network_.facet_worked = network_.pressure;
  if (BoundaryKind{options_.boundary_kind} != BoundaryKind::stress) return;
  const FarDiscs two = far_discs(assembly_);
  far_apart_ = {two.lowest, two.far};
}

void FacetMotion::take(std::span<const Facet> facets, std::vector<Push> pushes, std::vector<Face> faces,
                       bool restored) {
  Network& n = network_;
  ++changes_;
  facets_ = facets;
  pushes_ = std::move(pushes);
  faces_ = std::move(faces);
  refill_factors(assembly_, options_);
  discs_.clear();
  std::vector<std::int32_t> rock, holes;
  std::fill(count_.begin(), count_.end(), 0);
  for (const Facet& f : facets) {
    assembly_.factors.stiffness[f.bond] = 0.0;
    discs_.insert(discs_.end(), {assembly_.first[f.bond], assembly_.second[f.bond]});
    for (const auto d : {f.left, f.right}) {
      const bool pore = n.kind[d] == DomainKind::rock;
      (pore ? rock : holes).push_back(d);
      if (pore) ++count_[d];
    }
  }
  for (const auto& push : pushes_)
    discs_.insert(discs_.end(), {assembly_.first[push.bond], assembly_.second[push.bond]});
  for (const auto& face : faces_) discs_.push_back(face.disc);
  if (!facets.empty()) discs_.insert(discs_.end(), far_apart_.begin(), far_apart_.end());
  for (auto* list : {&rock, &holes, &discs_}) sort_out(*list);
  holes_.clear();
  for (const auto d : holes) holes_.push_back({d, n.pressure[d]});
  const auto place = [&](std::int32_t d) {
    const bool pore = n.kind[d] == DomainKind::rock;
    const auto& list = pore ? rock : holes;
    const auto at = static_cast<std::int32_t>(std::lower_bound(list.begin(), list.end(), d) - list.begin());
    return pore ? at : ~at;
  };
  items_.clear();
  for (const Facet& f : facets) items_.push_back({place(f.left), place(f.right), 0.0, 0.0});
  const auto before = std::move(pores_);
  pores_.clear();
  std::int32_t sides = 0;
  auto known = before.begin();
  for (const auto d : rock) {
    known = std::find_if(known, before.end(), [d](const Pore& pore) { return pore.domain >= d; });
    if (!restored && (known == before.end() || known->domain != d)) n.facet_worked[d] = n.pressure[d];
    pores_.push_back({d, sides, sides, n.facet_worked[d], n.facet_offset[d], n.volume_change[d]});
    sides += count_[d];
  }
  sides_.resize(static_cast<std::size_t>(sides));
  for (std::size_t k = 0; k < items_.size(); ++k)
    for (const auto& [at, length] : {std::pair{items_[k].left, facets[k].left_length},
                                     std::pair{items_[k].right, facets[k].right_length}})
      if (at >= 0)
        sides_[static_cast<std::size_t>(pores_[static_cast<std::size_t>(at)].last++)] = {
            static_cast<std::int32_t>(k), length};
  const double zone = tip_zone(assembly_, options_);
  for (const auto& pore : pores_) {
    if (!at_tip(pore.domain)) continue;
    hold_bonds_around(assembly_, n, pore.domain);
    for (std::int64_t e = 0; e < assembly_.bond_count(); ++e)
      if (in_tip_zone(assembly_, zone, n.centroid[pore.domain], e)) hold_bond(assembly_, e);
  }
  book_change(restored);
}

void FacetMotion::begin_cycles() {
  Network& n = network_;
  stiffness_ = n.stiffness;
  for (auto& hole : holes_) hole.pressure = n.pressure[hole.domain];
  for (auto& pore : pores_) {
    pore.pressure = n.pressure[pore.domain];
    pore.volume = n.volume_change[pore.domain];
    stiffness_[pore.domain] = 0.0;
    n.volume_change[pore.domain] = 0.0;
  }
}

void FacetMotion::end_cycles() {
  measure();
  count_work();
  couple_ = {};
  stored_ = energy();
  for (const auto& pore : pores_) {
    network_.pressure[pore.domain] = pore.pressure;
    network_.volume_change[pore.domain] = pore.volume;
  }
}

void FacetMotion::push_all() {
  for (std::size_t k = 0; k < items_.size(); ++k)
    items_[k].push = pressure_at(items_[k].left) * facets_[k].left_length +
                     pressure_at(items_[k].right) * facets_[k].right_length;
}

void FacetMotion::measure() {
  const Assembly& a = assembly_;
  for (auto& pore : pores_) pore.fixed = network_.facet_offset[pore.domain];
  for (const auto& face : faces_) {
    const auto at = std::lower_bound(pores_.begin(), pores_.end(), face.domain,
                                     [](const Pore& pore, std::int32_t d) { return pore.domain < d; });
    at->fixed += dot(face.weight, {a.ux[face.disc], a.uy[face.disc]}) + face.turn * a.rotation[face.disc];
  }
  for (std::size_t k = 0; k < items_.size(); ++k)
    items_[k].apart =
        facet_jump(a, *start_, facets_[k], facets_[k].normal) - facets_[k].initial_normal / start_->stiffness;
  push_all();
}

double FacetMotion::volume_change(const Pore& pore) const {
  double change = pore.fixed;
  for (auto k = pore.first; k < pore.last; ++k) {
    const Side& side = sides_[static_cast<std::size_t>(k)];
    const Item& item = items_[static_cast<std::size_t>(side.facet)];
    change += side.length * std::max(0.0, item.apart + item.push / start_->stiffness);
  }
  return change;
}

// One step of Newton's method on a pore's own pressure. Returns by how much it changed [Pa].
double FacetMotion::correct(Pore& pore) {
  const double storing = 1.0 / network_.stiffness[pore.domain];
  double lacking = network_.content[pore.domain] + network_.growth_of(pore.domain) -
                   (pore.pressure - network_.reference_pressure) * storing - pore.fixed;
  double slope = storing;
  for (auto k = pore.first; k < pore.last; ++k) {
    const Side& side = sides_[static_cast<std::size_t>(k)];
    const Item& item = items_[static_cast<std::size_t>(side.facet)];
    const double opening = item.apart + item.push / start_->stiffness;
    if (opening < 0.0) continue;
    lacking -= side.length * opening;
    slope += side.length * side.length / start_->stiffness;
  }
  const double pressure = std::max(network_.floor_pressure, pore.pressure + lacking / slope);
  const double change = pressure - pore.pressure;
  pore.pressure = pressure;
  for (auto k = pore.first; k < pore.last; ++k) {
    const Side& side = sides_[static_cast<std::size_t>(k)];
    items_[static_cast<std::size_t>(side.facet)].push += side.length * change;
  }
  return std::abs(change);
}

void FacetMotion::answer(bool undrained) {
  const Assembly& a = assembly_;
  const Network& n = network_;
  // A hole's own pressure follows from its corners, as the kernels find it, which may not have done so yet.
  for (auto& hole : holes_) {
    if (!undrained || n.stiffness[hole.domain] <= 0.0) continue;
    double change = 0.0;
    for (auto k = n.corner_start[hole.domain]; k < n.corner_start[hole.domain + 1]; ++k) {
      const auto i = n.corner_disc[k];
      change += n.corner_weight[2 * k] * a.ux[i] + n.corner_weight[2 * k + 1] * a.uy[i];
      if (!n.corner_turn.empty()) change += n.corner_turn[k] * a.rotation[i];
    }
    hole.pressure =
        std::max(n.floor_pressure,
                 n.reference_pressure +
                     n.stiffness[hole.domain] * (n.content[hole.domain] + n.growth_of(hole.domain) - change));
  }
  measure();
  if (undrained) settle_pressures();
  count_work();
}

void FacetMotion::settle_pressures() {
  const Network& n = network_;
  double largest = 0.0;
  for (const auto& pore : pores_) largest = std::max(largest, std::abs(pore.pressure));
  double change = largest;
  for (int sweep = 0; sweep < most_sweeps && change > settled * largest; ++sweep) {
    change = 0.0;
    const auto visit = [&](Pore& pore) {
      if (n.stiffness[pore.domain] <= 0.0) return;
      change = std::max(change, correct(pore));
      largest = std::max(largest, std::abs(pore.pressure));
    };
    if (sweep % 2 == 0) {
      std::for_each(pores_.begin(), pores_.end(), visit);
    } else {
      std::for_each(pores_.rbegin(), pores_.rend(), visit);
    }
  }
  push_all();  // without what rounding left
}

double FacetMotion::push_pair(std::int64_t bond, Vec2 force, double on_first, double on_second) {
  Assembly& a = assembly_;
  const auto i = a.first[bond], j = a.second[bond];
  a.external_x[i] += force.x;
  a.external_y[i] += force.y;
  a.external_x[j] -= force.x;
  a.external_y[j] -= force.y;
  a.external_moment[i] += on_first;
  a.external_moment[j] += on_second;
  const Vec2 between{a.dx(bond) + a.ux[j] - a.ux[i], a.dy(bond) + a.uy[j] - a.uy[i]};
  return on_first + on_second - cross(between, force);
}

void FacetMotion::add_forces() {
  Assembly& a = assembly_;
  double turns = 0.0;  // N m, what all here turns the whole by
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const Facet& f = facets_[k];
    const Vec2 n = f.normal, t{-n.y, n.x};
    Vec2 force = f.locked;
    double on_first = -f.locked_first, on_second = -f.locked_second;
    const double opening = items_[k].apart + items_[k].push / start_->stiffness;
    if (opening >= 0.0) {
      // A hole pushes on its own corners.
      double push = items_[k].push;
      if (items_[k].left < 0) push -= pressure_at(items_[k].left) * f.left_length;
      if (items_[k].right < 0) push -= pressure_at(items_[k].right) * f.right_length;
      force = force - push * n;
    } else {
      const ClosedFacet c = closed_facet(a, options_, *start_, f, opening);
      const double arm_i = a.arm(f.bond), arm_j = a.length(f.bond) - arm_i;
      force = force + c.normal * n + c.shear * t;
      on_first += arm_i * c.shear;
      on_second += arm_j * c.shear;
    }
    turns += push_pair(f.bond, force, on_first, on_second);
  }
  for (const auto& [bond, force] : pushes_) turns += push_pair(bond, force, 0.0, 0.0);
  for (const auto& face : faces_) {
    const auto at = std::lower_bound(pores_.begin(), pores_.end(), face.domain,
                                     [](const Pore& pore, std::int32_t d) { return pore.domain < d; });
    const Vec2 force = at->pressure * face.weight;
    const double moment = at->pressure * face.turn;
    a.external_x[face.disc] += force.x;
    a.external_y[face.disc] += force.y;
    a.external_moment[face.disc] += moment;
    turns += moment + cross(a.position(face.disc), force);
  }
  if (!far_apart_.empty() && !items_.empty()) hold_against(turns);
}

// The couple that two discs bear.
void FacetMotion::hold_against(double turns) {
  Assembly& a = assembly_;
  const auto p = far_apart_[0], q = far_apart_[1];
  const Vec2 between = a.position(q) - a.position(p);
  couple_ = (turns / dot(between, between)) * Vec2{-between.y, between.x};
  a.external_x[p] += couple_.x;
  a.external_y[p] += couple_.y;
  a.external_x[q] -= couple_.x;
  a.external_y[q] -= couple_.y;
}

}  // namespace hfrac
