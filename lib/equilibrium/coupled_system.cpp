// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/coupled_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flow/aperture.hpp"
#include "model/far_discs.hpp"
#include "model/joint_pores.hpp"
#include "options/choices.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {

CoupledSystem::CoupledSystem(Assembly& assembly, Network& network, Boundary& boundary,
                             const NonBondedContacts& non_bonded, const Options& options, Workers& workers,
                             Facets& facets, std::vector<Wellbore>* wellbores, const Ranks& ranks)
    : assembly_(assembly),
      network_(network),
      boundary_(boundary),
      non_bonded_(non_bonded),
      options_(options),
      team_(workers, ranks),
      facets_(facets),
      wellbores_(wellbores),
      discs_(assembly.disc_count()),
      domains_(network.domain_count()),
      tractions_(boundary.exterior() == nullptr ? 0 : static_cast<std::int64_t>(boundary.exterior()->size())),
      servo_walls_(boundary.walled() && boundary.follows_far_field() ? boundary.walls().size() : 0),
      wet_(FlowScheme{options.flow_scheme} != FlowScheme::off),
      closed_outside_(OuterPores{options.flow_outer} == OuterPores::closed),
      force_scale_(options.contact_normal_stiffness),
      length_scale_(assembly.mean_radius),
      pressure_scale_(force_scale_ / length_scale_),
      keeps_tangents_(FactorOf{options.solver_factor} != FactorOf::petsc),
      turns_open_(network.planes.kept() || !assembly.smooth.empty()),
      law_(options),
      at_floor_(static_cast<std::size_t>(domains_), 0) {
  const auto bonds = static_cast<std::size_t>(assembly.bond_count());
  changes_.resize(bonds);
  if (wet_) {
    for (auto* per_pipe : {&aperture_change_, &squeeze_change_, &slope_, &opening_})
      per_pipe->assign(bonds, 0.0);
    opening_way_.resize(bonds);
  }
  residual_.setZero(traction_at(tractions_));
  list_neighbours();
  find_own_bonds();
  if (keeps_tangents_) tangents_.resize(own_.all() ? bonds : own_.bond.size());
  if (boundary.walled() || tractions_ > 0) return;
  // A body held by nothing: three springs take up rounding. At equilibrium they bear nothing.
  const auto [lowest, far, distance] = far_discs(assembly_);
  const Vec2 line =
      (1.0 / distance) * Vec2{assembly_.x[far] - assembly_.x[lowest], assembly_.y[far] - assembly_.y[lowest]};
  pins_ = {{lowest, {1.0, 0.0}, 0.0}, {lowest, {0.0, 1.0}, 0.0}, {far, {-line.y, line.x}, 0.0}};
}

void CoupledSystem::begin(double duration, const std::vector<double>& source) {
  const auto& a = assembly_;
  duration_ = duration;
  source_ = source;
  source_.resize(static_cast<std::size_t>(domains_), 0.0);
  wellbore_flow_.resize(wet_ && wellbores_ != nullptr ? wellbores_->size() : 0);
  for (std::size_t w = 0; w < wellbore_flow_.size(); ++w)
    wellbore_flow_[w].begin((*wellbores_)[w], duration, network_.floor_pressure);
  content_start_.assign(network_.content.begin(), network_.content.end());
  outer_drop_.assign(network_.outer_pipe.empty() ? 0 : changes_.size(), 0.0);
  for (std::size_t k = 0; k < network_.outer_pipe.size(); ++k) {
    const auto e = static_cast<std::size_t>(network_.outer_pipe[k]);
    outer_drop_[e] = network_.left[e] == 0 ? network_.outer_excess[k] : -network_.outer_excess[k];
  }
  held_before_.clear();  // other pairs may be near
  keep_pairs();
  if (!boundary_.grips().empty()) {
    pins_.clear();
    for (const auto& grip : boundary_.grips()) pins_.push_back({grip.disc, grip.along, grip.target});
    return;
  }
  for (auto& pin : pins_) pin.start = dot({a.ux[pin.disc], a.uy[pin.disc]}, pin.along);
}

void CoupledSystem::keep_pairs() {
  const auto& a = assembly_;
  pair_start_.clear();
  for (const auto& pair : non_bonded_.pairs()) {
    pair_start_.push_back(
        {a.position(pair.second) - a.position(pair.first), a.rotation[pair.first], a.rotation[pair.second]});
  }
}

void CoupledSystem::add_pair(const BondResponse& r, std::int32_t i, std::int32_t j) {
  residual_[3 * i] += r.force[0];
  residual_[3 * i + 1] += r.force[1];
  residual_[3 * j] -= r.force[0];
  residual_[3 * j + 1] -= r.force[1];
  residual_[3 * i + 2] -= r.force[2];
  residual_[3 * j + 2] -= r.force[3];
}

// A pore of both a fracture and a joint pushes on the joint's faces too.
void CoupledSystem::add_faces_of_joints() {
  if (network_.joint_pore.empty()) return;
  for (std::int32_t d = 0; d < domains_; ++d) {
    if (network_.joint_pore[d] == 0 || !facets_.fractured(d)) continue;
    for (auto k = network_.corner_start[d]; k < network_.corner_start[d + 1]; ++k)
      network_.corner_turn[k] = 0.0;
    add_face_weights(network_, assembly_, d);
  }
}

// Pores of fractures push and are filled through their open facets alone.
void CoupledSystem::open_facets() {
  if (!facets_.active()) return;
  auto& n = network_;
  facet_change_.assign(static_cast<std::size_t>(domains_), 0.0);
  facet_open_.assign(facets_.all().size(), 0);
  for (const Facet& f : facets_.all()) {
    for (const auto d : {f.left, f.right}) {
      if (n.kind[d] != DomainKind::rock) continue;
      facet_change_[static_cast<std::size_t>(d)] = n.facet_offset[d];
      for (auto k = 2 * n.corner_start[d]; k < 2 * n.corner_start[d + 1]; ++k) n.corner_weight[k] = 0.0;
    }
  }
  add_faces_of_joints();
  for (std::size_t k = 0; k < facets_.all().size(); ++k) {
    const Facet& f = facets_.all()[k];
    if (facets_.opening(assembly_, n, f) < 0.0) continue;
    facet_open_[k] = 1;
    const auto i = assembly_.first[f.bond], j = assembly_.second[f.bond];
    const double more =
        n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length - f.initial_normal;
    for (int side = 0; side < 2; ++side) {
      const auto d = side == 0 ? f.left : f.right;
      if (n.kind[d] != DomainKind::rock) continue;
      const double length = side == 0 ? f.left_length : f.right_length;
      const Vec2 part = length * f.normal;
      const auto ci = f.corner[2 * side], cj = f.corner[2 * side + 1];
      n.corner_weight[2 * ci] -= part.x;
      n.corner_weight[2 * ci + 1] -= part.y;
      n.corner_weight[2 * cj] += part.x;
      n.corner_weight[2 * cj + 1] += part.y;
      facet_change_[static_cast<std::size_t>(d)] +=
          length * more / facets_.start().stiffness - facet_growth(assembly_, f.bond, part) -
          dot(part,
              {facets_.start().x[j] - facets_.start().x[i], facets_.start().y[j] - facets_.start().y[i]});
    }
  }
}

void CoupledSystem::evaluate() {
  network_.planes.refresh(network_, assembly_);
  open_facets();
  boundary_.answer(assembly_);
  answer_all();
  evaluate_few();
  find_fragments();
  for (std::int64_t i = 0; i < discs_; ++i) {
    if (adrift_[static_cast<std::size_t>(i)] != 0) residual_.segment<3>(3 * i).setZero();
  }
  evaluate_wellbores();
  if (wet_) evaluate_domains();
  measure();
  for (std::int64_t i = 0; i < discs_; ++i) {
    residual_[3 * i] /= force_scale_;
    residual_[3 * i + 1] /= force_scale_;
    residual_[3 * i + 2] /= force_scale_ * length_scale_;
  }
}

BondResponse CoupledSystem::answer_of(std::size_t e) const {
  const auto bond = static_cast<std::int64_t>(e);
  if (const auto facet = facets_.of(bond); facet >= 0)
    return respond(assembly_, options_, network_, facets_, facets_.all()[static_cast<std::size_t>(facet)]);
  BondResponse answer = respond(assembly_, options_, bond);
  if (facets_.active()) {
    const Vec2 locked = facets_.locked_of(bond);
    answer.force[0] += locked.x;
    answer.force[1] += locked.y;
  }
  return answer;
}

// Bonds answer one by one, then discs add up what pulls and pushes them.
void CoupledSystem::answer_all() {
  const auto bonds = static_cast<std::int64_t>(changes_.size());
  const bool flows = wet_ && duration_ > 0.0;
  holds_.resize(changes_.size());
  by_push_.resize(facets_.all().size());
  bond_forces_.resize(static_cast<std::size_t>((bonds + grain - 1) / grain));
  team_.workers().share(worth_sharing(), [&](const Workers::Member& member) {
    const auto mine = member.part(bonds, grain);
    for (auto begin = mine.first; begin < mine.last; begin += grain) {
      double force = 0.0;
      for (auto k = begin; k < std::min(begin + grain, mine.last); ++k) {
        const auto e = static_cast<std::size_t>(k);
        const BondResponse bond = answer_of(e);
        std::copy_n(bond.force, 4, changes_[e].force);
        if (const auto kept = place_of_tangent(e); kept >= 0)
          std::copy_n(bond.tangent, 16, tangents_[static_cast<std::size_t>(kept)].data());
        if (const auto facet = facets_.of(k); facet >= 0)
          by_push_[static_cast<std::size_t>(facet)] = bond.by_push;
        holds_[e] = assembly_.intact[e] > 0.0 || bond.gap < 0.0 ? 1 : 0;
        if (flows) evaluate_pipe(e, bond);
        force += std::abs(bond.force[0]) + std::abs(bond.force[1]);
      }
      bond_forces_[static_cast<std::size_t>(begin / grain)] = force;
    }
    member.barrier();
    add_up_on_discs(member.part(discs_, grain));
  });
  contact_force_ = 0.0;
  for (const double force : bond_forces_) contact_force_ += force;
}

void CoupledSystem::add_up_on_discs(Workers::Range discs) {
  const auto pushing = first_pushing();
  for (auto i = discs.first; i < discs.last; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Vec2 force = boundary_.load_on(static_cast<std::int32_t>(i));
    double turn = 0.0;
    for (auto k = bond_start_[at]; k < bond_start_[at + 1]; ++k) {
      const auto end = bond_of_[static_cast<std::size_t>(k)];
      const double* f = changes_[static_cast<std::size_t>(end / 2)].force;
      const double way = end % 2 == 0 ? 1.0 : -1.0;
      force = force + way * Vec2{f[0], f[1]};
      turn -= f[2 + end % 2];
    }
    for (auto k = corner_start_[at]; k < corner_start_[at + 1]; ++k) {
      const auto domain = corner_domain_[static_cast<std::size_t>(k)];
      if (domain < pushing) continue;
      const auto corner = static_cast<std::size_t>(corner_of_[static_cast<std::size_t>(k)]);
      force = force + network_.pressure[static_cast<std::size_t>(domain)] *
                          Vec2{network_.corner_weight[2 * corner], network_.corner_weight[2 * corner + 1]};
      if (!network_.corner_turn.empty())
        turn += network_.pressure[static_cast<std::size_t>(domain)] * network_.corner_turn[corner];
    }
    residual_[3 * i] = force.x;
    residual_[3 * i + 1] = force.y;
    residual_[3 * i + 2] = turn;
  }
}

// Contacts of discs that were never bonded, pins and walls.
void CoupledSystem::evaluate_few() {
  const auto& a = assembly_;
  pairs_.resize(non_bonded_.pairs().size());
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto& pair = non_bonded_.pairs()[k];
    pairs_[k] = respond(a, options_, pair, pair_start_[k]);
    if (pairs_[k].gap < 0.0) add_pair(pairs_[k], pair.first, pair.second);
  }
  for (const auto& pin : pins_) {
    const double bears = force_scale_ * (dot({a.ux[pin.disc], a.uy[pin.disc]}, pin.along) - pin.start);
    residual_[3 * pin.disc] -= bears * pin.along.x;
    residual_[3 * pin.disc + 1] -= bears * pin.along.y;
  }
  if (boundary_.walled()) evaluate_walls();
}

void CoupledSystem::evaluate_walls() {
  const double k = options_.contact_normal_stiffness;
  for (std::size_t w = 0; w < boundary_.walls().size(); ++w) {
    const auto& wall = boundary_.walls()[w];
    double push = 0.0;
    for (const auto i : wall.discs) {
      const double closing = Boundary::closing_of(assembly_, wall, i);
      if (closing <= 0.0) continue;
      push += k * closing;
      residual_[3 * i] += k * closing * wall.inward.x;
      residual_[3 * i + 1] += k * closing * wall.inward.y;
    }
    if (w < servo_walls_) residual_[wall_at(w)] = (wall.target * wall.length - push) / force_scale_;
  }
}

// Small pieces that no bond, contact or wall holds any more have no equilibrium of their own: they stay where they are until
// something touches them.
void CoupledSystem::find_fragments() {
  const auto& a = assembly_;
  const std::size_t bonds = changes_.size();
  for (const auto& pair : pairs_) holds_.push_back(pair.gap < 0.0 ? 1 : 0);
  if (holds_ == held_before_) return;
  held_before_ = holds_;
  auto& piece = piece_;
  piece.resize(static_cast<std::size_t>(discs_));
  for (std::size_t i = 0; i < piece.size(); ++i) piece[i] = static_cast<std::int32_t>(i);
  const auto root = [&](std::int32_t i) {
    while (piece[static_cast<std::size_t>(i)] != i) {
      auto& up = piece[static_cast<std::size_t>(i)];
      up = piece[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  const auto join = [&](std::int32_t i, std::int32_t j) {
    const auto p = root(i), q = root(j);
    piece[static_cast<std::size_t>(std::max(p, q))] = std::min(p, q);
  };
  for (std::size_t e = 0; e < bonds; ++e) {
    if (holds_[e] != 0) join(a.first[e], a.second[e]);
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (holds_[bonds + k] != 0) join(non_bonded_.pairs()[k].first, non_bonded_.pairs()[k].second);
  }
  std::vector<std::int32_t> members(piece.size(), 0);
  for (std::int32_t i = 0; i < discs_; ++i) ++members[static_cast<std::size_t>(root(i))];
  std::int32_t largest = 0;
  for (std::int32_t i = 0; i < discs_; ++i) {
    if (members[static_cast<std::size_t>(i)] > members[static_cast<std::size_t>(largest)]) largest = i;
  }
  adrift_.assign(piece.size(), 0);
  for (std::int32_t i = 0; i < discs_; ++i) {
    const auto at = root(i);
    if (at != largest && members[static_cast<std::size_t>(at)] < discs_ / 20)
      adrift_[static_cast<std::size_t>(i)] = 1;
  }
}

// Aperture of the displacements at hand, and what a change of gap does to the flow.
void CoupledSystem::evaluate_pipe(std::size_t e, const BondResponse& bond) {
  auto& n = network_;
  const auto l = n.left[e], r = n.right[e];
  aperture_change_[e] = squeeze_change_[e] = slope_[e] = 0.0;
  if (l == r || (closed_outside_ && (l == 0 || r == 0))) {
    n.conductance[e] = 0.0;
    return;
  }
  if (const auto k = facets_.of(static_cast<std::int64_t>(e)); k >= 0) {
    evaluate_facet_pipe(e, static_cast<std::size_t>(k));
    return;
  }
  const double joint = joint_opening(assembly_, static_cast<std::int64_t>(e));
  const CrackPlane* plane = n.planes.of(e);
  CrackApertureResponse w{};
  const SmoothContact* flowing = flowing_contact(n, assembly_, e);
  if (flowing != nullptr) {
    opening_[e] = smooth_opening(assembly_, *flowing);
    w = joint_aperture_response(options_, assembly_.smooth.law_of(*flowing), opening_[e]);
    opening_way_[e] = {flowing->normal, flowing->opens_by_first, flowing->opens_by_second, bond.direction};
    if (flowing->bond != static_cast<std::int64_t>(e)) w.by_opening = 0.0;  // of other discs
  } else if (plane != nullptr && joint <= 0.0) {
    opening_[e] = CrackPlanes::opening(*plane, assembly_, e);
    opening_way_[e] = {plane->normal, plane->by_first, plane->by_second, bond.direction};
    w = crack_aperture_response(options_, n.pipe_at_rest(e), opening_[e], bond.normal, bond.normal_stiffness);
  } else {
    opening_[e] = joint > 0.0 ? joint : bond.gap;
    OpeningWay& way = opening_way_[e];
    way = {joint > 0.0 ? assembly_.joint_normal(static_cast<std::int64_t>(e)) : bond.direction, 0.0, 0.0,
           bond.direction};
    if (const SmoothContact* smooth = assembly_.smooth.of(static_cast<std::int64_t>(e))) {
      way.by_first = smooth->opens_by_first;
      way.by_second = smooth->opens_by_second;
    }
    const auto of_gap =
        aperture_response(options_, n.pipe_at_rest(e), opening_[e], joint > 0.0 ? 0.0 : bond.normal,
                          bond.normal_stiffness, assembly_.intact[e] > 0.0);
    w = {of_gap.aperture, 0.0, of_gap.by_gap};
  }
  n.aperture[e] = w.aperture;
  const bool held = flowing != nullptr && !held_joints_.empty();
  const auto place = held ? flowing - assembly_.smooth.contacts.data() : 0;
  const auto flow =
      FluidLaw::in_series(law_.respond(held ? held_joints_[static_cast<std::size_t>(place)] : w.aperture,
                                       pipe_length(n, assembly_, e), drop(e), n.viscosity_share_of(e)),
                          n.beyond_of(e));
  n.conductance[e] = flow.conductance;
  slope_[e] = flow.slope;
  if (held || w.aperture <= 0.0) return;  // or pressed shut
  const double by_aperture = duration_ * flow.by_aperture * n.conductance[e] / w.aperture;
  aperture_change_[e] = by_aperture * w.by_opening * drop(e);
  squeeze_change_[e] = by_aperture * w.by_gap * drop(e);
}

// Rates of clusters at the pressures of their holes as they stand.
void CoupledSystem::evaluate_wellbores() {
  for (std::size_t w = 0; duration_ > 0.0 && w < wellbore_flow_.size(); ++w) {
    const auto& clusters = (*wellbores_)[w].clusters;
    hole_.clear();
    for (const auto& cluster : clusters)
      hole_.push_back(std::max(network_.pressure[cluster.domain], network_.floor_pressure));
    wellbore_flow_[w].solve(hole_);
    for (std::size_t i = 0; i < clusters.size(); ++i)
      source_[static_cast<std::size_t>(clusters[i].domain)] = wellbore_flow_[w].rate(i);
  }
}

void CoupledSystem::keep_wellbores() {
  for (std::size_t w = 0; duration_ > 0.0 && w < wellbore_flow_.size(); ++w)
    wellbore_flow_[w].keep((*wellbores_)[w]);
}

void CoupledSystem::evaluate_domains() {
  struct Most {
    double off = 0.0, range = 1.0;
  };
  std::vector<Most> most(static_cast<std::size_t>(team_.workers().count()));
  team_.workers().share(worth_sharing(), [&](const Workers::Member& member) {
    Most& mine = most[static_cast<std::size_t>(member.number)];
    const auto domains = member.part(domains_, grain);
    for (auto d = domains.first; d < domains.last; ++d) {
      mine.range = std::max(mine.range, std::abs(network_.pressure[d] - network_.reference_pressure));
      mine.off = std::max(mine.off, evaluate_domain(d));
    }
  });
  Most all;
  for (const auto& m : most) all = {std::max(all.off, m.off), std::max(all.range, m.range)};
  pressure_error_ = all.off / all.range;
}

double CoupledSystem::volume_change(std::int64_t d) const {
  const auto& n = network_;
  double change = facets_.fractured(d) ? facet_change_[static_cast<std::size_t>(d)] : 0.0;
  for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
    change += n.corner_weight[2 * k] * assembly_.ux[n.corner_disc[k]] +
              n.corner_weight[2 * k + 1] * assembly_.uy[n.corner_disc[k]];
    if (!n.corner_turn.empty()) change += n.corner_turn[k] * assembly_.rotation[n.corner_disc[k]];
  }
  return change;
}

// How far its pressure is from what its content asks for [Pa].
double CoupledSystem::evaluate_domain(std::int64_t d) {
  auto& n = network_;
  const auto at = static_cast<std::size_t>(d);
  auto& r = residual_[pressure_at(d)];
  at_floor_[at] = 1;
  if (n.stiffness[d] <= 0.0) {  // imposed; what it holds the balance finds out
    n.content[d] = content_start_[at];
    r = 0.0;
    return 0.0;
  }
  n.content[d] = content_start_[at] + duration_ * source_[at];
  double through = 0.0;  // m2/Pa
  if (duration_ > 0.0) {
    for (auto k = pipe_start_[at]; k < pipe_start_[at + 1]; ++k) {
      const auto end = pipe_of_[static_cast<std::size_t>(k)];
      const auto e = static_cast<std::size_t>(end / 2);
      const double moved = duration_ * n.conductance[e] * drop(e);
      through += duration_ * n.conductance[e];
      n.content[d] += end % 2 == 0 ? -moved : moved;
    }
  }
  const double change = volume_change(d);
  const double full = n.reference_pressure + n.stiffness[d] * (n.content[d] + n.growth_of(d) - change);
  // The fluid fills the domain, or its pressure is at the floor: whichever is farther from fulfilled. Both in one scale, or the residual
  // would jump, and one no stiffer than the rock, or the little that a joint's pore stores would decide.
  const double filled = (n.pressure[d] - full) / n.stiffness[d],
               above = (n.pressure[d] - n.floor_pressure) / floor_stiffness(d);
  if (filled < above) at_floor_[at] = 0;
  r = std::min(filled, above) / length_scale_;
  const double off = std::abs(n.pressure[d] - std::max(full, n.floor_pressure));
  if (n.joint_pore.empty()) return off;
  // A joint's pore holds little of what passes it in a long increment: the last digits of pressures are worth more than its content.
  constexpr double last_digits = 16.0 * std::numeric_limits<double>::epsilon();
  return std::max(0.0, off - last_digits * n.stiffness[d] * through * std::abs(n.pressure[d]));
}

void CoupledSystem::measure() {
  double unbalanced = 0.0;
  for (std::int64_t i = 0; i < discs_; ++i) {
    unbalanced += std::abs(residual_[3 * i]) + std::abs(residual_[3 * i + 1]) +
                  std::abs(residual_[3 * i + 2]) / assembly_.radius[i];
  }
  // Below a strain of 1e-12 everywhere there is nothing to balance.
  const double least = 1e-12 * force_scale_ * length_scale_;
  const double mean = contact_force_ / static_cast<double>(std::max<std::size_t>(1, changes_.size()));
  force_ratio_ = unbalanced / static_cast<double>(discs_) / std::max(mean, least);
  for (std::size_t w = 0; w < servo_walls_; ++w)
    force_ratio_ = std::max(
        force_ratio_, std::abs(residual_[wall_at(w)]) * force_scale_ /
                          std::max(mean * static_cast<double>(boundary_.walls()[w].discs.size()), least));
}

Vec2 CoupledSystem::worst_place() const {
  Eigen::Index worst = 0;  // or the first that is no number at all
  const auto size = [this](Eigen::Index k) {
    return std::isfinite(residual_[k]) ? std::abs(residual_[k]) : std::numeric_limits<double>::infinity();
  };
  for (Eigen::Index k = 1; k < 3 * discs_ + domains_; ++k) {
    if (size(k) > size(worst)) worst = k;
  }
  if (worst >= 3 * discs_) return network_.centroid[static_cast<std::size_t>(worst - 3 * discs_)];
  return assembly_.position(worst / 3);
}

// What x adds to the opening that a pipe's aperture goes by [m].
double CoupledSystem::opens(std::size_t e, const Vector& x) const {
  const auto i = assembly_.first[e], j = assembly_.second[e];
  const OpeningWay& way = opening_way_[e];
  const double opening = way.along.x * (x[3 * j] - x[3 * i]) + way.along.y * (x[3 * j + 1] - x[3 * i + 1]);
  if (!turns_open_) return opening;
  return opening + (way.by_first * x[3 * i + 2] + way.by_second * x[3 * j + 2]) / length_scale_;
}

double CoupledSystem::work_along(const Vector& x) const {
  const auto discs = 3 * discs_, rest = x.size() - discs - domains_;
  return x.head(discs).dot(residual_.head(discs)) -
         x.segment(discs, domains_).dot(residual_.segment(discs, domains_)) +
         x.tail(rest).dot(residual_.tail(rest));
}

void CoupledSystem::limit(Vector& x, double longest) const {
  for (std::int64_t i = 0; i < discs_; ++i) {
    const double size = std::max({std::abs(x[3 * i]), std::abs(x[3 * i + 1]), std::abs(x[3 * i + 2])});
    if (size > longest) x.segment<3>(3 * i) *= longest / size;
  }
}

// Flow goes with the cube of the aperture: a pipe seen closed lets nothing on to what would open it, and one seen
// open too much. Growing by steps, it meets the opening at which both agree.
double CoupledSystem::share_for_apertures(const Vector& x, double growth) const {
  if (!wet_ || duration_ <= 0.0) return 1.0;
  double share = 1.0;
  for (std::size_t e = 0; e < changes_.size(); ++e) {
    if (assembly_.intact[e] > 0.0 || network_.conductance[e] == 0.0) continue;
    const double aperture = network_.aperture[e];
    if (aperture >= options_.flow_aperture_limit) continue;
    const double more = opens(e, x);
    const double room = std::max(0.0, opening_[e]) + (growth - 1.0) * aperture - opening_[e];
    if (more > room) share = std::min(share, room / more);
  }
  return share;
}

void CoupledSystem::move(const Vector& x, double share) {
  auto& a = assembly_;
  for (std::int64_t i = 0; i < discs_; ++i) {
    a.ux[i] += share * x[3 * i];
    a.uy[i] += share * x[3 * i + 1];
    a.rotation[i] += share * x[3 * i + 2] / length_scale_;
  }
  if (wet_) {
    for (std::int64_t d = 0; d < domains_; ++d) {
      if (network_.stiffness[d] > 0.0) network_.pressure[d] += share * pressure_scale_ * x[pressure_at(d)];
    }
  }
  for (std::size_t w = 0; w < servo_walls_; ++w) boundary_.shift_wall(w, share * x[wall_at(w)]);
}

// A facet's pipe: as wide as the fracture is open across its plane, as long as the way along it.
void CoupledSystem::evaluate_facet_pipe(std::size_t e, std::size_t facet) {
  auto& n = network_;
  const Facet& f = facets_.all()[facet];
  opening_[e] = facets_.jump(assembly_, f, f.normal);
  opening_way_[e] = {f.normal, 0.0, 0.0, {}};
  auto w = aperture_response(options_, n.pipe_at_rest(e), opening_[e], 0.0, 0.0, false);
  if (w.aperture < n.facet_least[e]) w = {n.facet_least[e], 0.0};
  n.aperture[e] = w.aperture;
  const bool held = facet < held_.size();
  const auto flow = FluidLaw::in_series(
      law_.respond(held ? held_[facet] : w.aperture, f.way, drop(e), n.viscosity_share_of(e)),
      n.beyond_of(e));
  n.conductance[e] = flow.conductance;
  slope_[e] = flow.slope;
  squeeze_change_[e] = 0.0;
  if (!held)
    aperture_change_[e] = duration_ * flow.by_aperture * n.conductance[e] / w.aperture * w.by_gap * drop(e);
}

namespace {
// How far the apertures held are off those now, over the largest of them; then moves them there by `share`.
template <class Items, class BondOf>
double follow(std::vector<double>& held, const Items& items, const Network& n, double share,
              const BondOf& bond_of) {
  double off = 0.0, largest = 1e-300;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const double now = n.aperture[static_cast<std::size_t>(bond_of(items[k]))];
    largest = std::max(largest, now);
    if (k >= held.size()) {
      held.push_back(now);
      off = 1.0;
      continue;
    }
    off = std::max(off, std::abs(now - held[k]));
    held[k] += share * (now - held[k]);
  }
  held.resize(items.size());
  return off / largest;
}
}  // namespace

double CoupledSystem::hold_apertures(double share) {
  const auto& joints = assembly_.smooth.contacts;
  const double facets = follow(held_, facets_.all(), network_, share, [](const Facet& f) { return f.bond; });
  if (network_.joint_pore.empty()) return facets;
  return std::max(facets, follow(held_joints_, joints, network_, share,
                                 [](const SmoothContact& contact) { return contact.bond; }));
}

void CoupledSystem::keep_flow() {
  if (!wet_) return;
  for (std::size_t e = 0; e < changes_.size(); ++e) {
    network_.flow[e] = network_.conductance[e] * drop(e);
  }
}

}  // namespace hfrac
