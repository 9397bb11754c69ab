// SPDX-License-Identifier: BSD-3-Clause
// The tangent of coupled_system.hpp times a vector, without a matrix: bonds answer one by one, then discs and domains pick up what
// theirs answered, in the order of their numbers. Nobody adds into what somebody else adds into, so workers share all of it and
// their number changes no bit. Ranks share discs and domains, too: what lies between two of them is answered on both, and all are told
// of all rows.
#include "equilibrium/coupled_system.hpp"

namespace hfrac {
namespace {

// From where each item stands to the items at each place: places[k] of item k, ascending by item within a place.
void invert(const std::vector<std::int32_t>& place, std::int64_t places, std::vector<std::int32_t>& start,
            std::vector<std::int32_t>& item) {
  start.assign(static_cast<std::size_t>(places) + 1, 0);
  item.resize(place.size());
  for (const auto at : place) ++start[static_cast<std::size_t>(at) + 1];
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
  auto cursor = start;
  for (std::size_t k = 0; k < place.size(); ++k)
    item[static_cast<std::size_t>(cursor[static_cast<std::size_t>(place[k])]++)] =
        static_cast<std::int32_t>(k);
}

}  // namespace

void CoupledSystem::list_neighbours() {
  const auto both = [](const auto& first, const auto& second, std::size_t count) {
    std::vector<std::int32_t> ends(2 * count);
    for (std::size_t k = 0; k < count; ++k) {
      ends[2 * k] = first[k];
      ends[2 * k + 1] = second[k];
    }
    return ends;
  };
  const std::size_t bonds = changes_.size();
  invert(both(assembly_.first, assembly_.second, bonds), discs_, bond_start_, bond_of_);
  corner_start_.assign(static_cast<std::size_t>(discs_) + 1, 0);
  if (!wet_) return;
  invert(both(network_.left, network_.right, bonds), domains_, pipe_start_, pipe_of_);
  const auto& discs = network_.corner_disc;
  invert({discs.begin(), discs.end()}, discs_, corner_start_, corner_of_);
  corner_domain_.resize(corner_of_.size());
  std::vector<std::int32_t> domain(discs.size());
  for (std::int64_t d = 0; d < domains_; ++d) {
    for (auto k = network_.corner_start[d]; k < network_.corner_start[d + 1]; ++k)
      domain[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(d);
  }
  for (std::size_t k = 0; k < corner_of_.size(); ++k)
    corner_domain_[k] = domain[static_cast<std::size_t>(corner_of_[k])];
}

void CoupledSystem::find_own_bonds() {
  const Ranks& ranks = team_.ranks();
  if (ranks.alone() || !worth_sharing()) return;
  own_.slot.assign(changes_.size(), -1);
  const auto want = [&](std::int64_t count, const std::vector<std::int32_t>& start,
                        const std::vector<std::int32_t>& ends) {
    const auto mine = ranks.part(ranks.rank(), count, grain);
    for (auto k = start[static_cast<std::size_t>(mine.first)]; k < start[static_cast<std::size_t>(mine.end)];
         ++k)
      own_.slot[static_cast<std::size_t>(ends[static_cast<std::size_t>(k)] / 2)] = 0;
  };
  want(discs_, bond_start_, bond_of_);
  if (wet_) want(domains_, pipe_start_, pipe_of_);
  for (std::size_t e = 0; e < own_.slot.size(); ++e) {
    if (own_.slot[e] < 0) continue;
    own_.slot[e] = static_cast<std::int32_t>(own_.bond.size());
    own_.bond.push_back(static_cast<std::int32_t>(e));
  }
  own_.bond.shrink_to_fit();
}

void CoupledSystem::pair_product(const double* k, std::int32_t i, std::int32_t j, const Vector& x,
                                 double* f) const {
  const double q[4] = {x[3 * j] - x[3 * i], x[3 * j + 1] - x[3 * i + 1], x[3 * i + 2] / length_scale_,
                       x[3 * j + 2] / length_scale_};
  for (int row = 0; row < 4; ++row) {
    f[row] = (k[4 * row] * q[0] + k[4 * row + 1] * q[1] + k[4 * row + 2] * q[2] + k[4 * row + 3] * q[3]) /
             force_scale_;
  }
}

void CoupledSystem::products_of_bonds(const Vector& x, Workers::Range bonds) const {
  const auto& n = network_;
  const bool flows = wet_ && duration_ > 0.0;
  for (auto k = bonds.first; k < bonds.last; ++k) {
    const auto e = own_.all() ? static_cast<std::size_t>(k)
                              : static_cast<std::size_t>(own_.bond[static_cast<std::size_t>(k)]);
    Change& change = changes_[e];
    with_tangent(e, [&](const double* tangent) {
      pair_product(tangent, assembly_.first[e], assembly_.second[e], x, change.force);
    });
    if (!flows) continue;
    change.moved = 0.0;
    if (n.conductance[e] == 0.0) continue;
    double opened = aperture_change_[e] == 0.0 ? 0.0 : aperture_change_[e] * opens(e, x);
    if (squeeze_change_[e] != 0.0) {
      const auto i = assembly_.first[e], j = assembly_.second[e];
      const Vec2 way = opening_way_[e].direction;
      opened += squeeze_change_[e] * (way.x * (x[3 * j] - x[3 * i]) + way.y * (x[3 * j + 1] - x[3 * i + 1]));
    }
    change.moved =
        (duration_ * slope_[e] * pressure_scale_ * (x[pressure_at(n.left[e])] - x[pressure_at(n.right[e])]) +
         opened) /
        length_scale_;
  }
}

void CoupledSystem::products_on_discs(const Vector& x, Vector& y, Workers::Range discs) const {
  const auto pushing = first_pushing();
  for (auto i = discs.first; i < discs.last; ++i) {
    const auto at = static_cast<std::size_t>(i);
    double to_x = 0.0, to_y = 0.0, turn = 0.0;
    for (auto k = bond_start_[at]; k < bond_start_[at + 1]; ++k) {
      const auto end = bond_of_[static_cast<std::size_t>(k)];
      const double* f = changes_[static_cast<std::size_t>(end / 2)].force;
      const double way = end % 2 == 0 ? -1.0 : 1.0;
      to_x += way * f[0];
      to_y += way * f[1];
      turn += f[2 + end % 2];
    }
    const double holds = adrift_[at] != 0 ? 1.0 : regularisation;
    to_x += holds * x[3 * i];
    to_y += holds * x[3 * i + 1];
    y[3 * i + 2] = turn / length_scale_ + holds * x[3 * i + 2];
    if (adrift_[at] == 0) {
      for (auto k = corner_start_[at]; k < corner_start_[at + 1]; ++k) {
        const auto domain = corner_domain_[static_cast<std::size_t>(k)];
        if (domain < pushing) continue;
        const auto corner = static_cast<std::size_t>(corner_of_[static_cast<std::size_t>(k)]);
        const double p = x[pressure_at(domain)] / length_scale_;
        to_x -= p * network_.corner_weight[2 * corner];
        to_y -= p * network_.corner_weight[2 * corner + 1];
        if (!network_.corner_turn.empty()) y[3 * i + 2] -= p * network_.corner_turn[corner] / length_scale_;
      }
    }
    y[3 * i] = to_x;
    y[3 * i + 1] = to_y;
  }
}

void CoupledSystem::products_on_domains(const Vector& x, Vector& y, Workers::Range domains) const {
  const auto& n = network_;
  for (auto d = domains.first; d < domains.last; ++d) {
    const auto at = static_cast<std::size_t>(d);
    auto& out = y[pressure_at(d)];
    if (!wet_) {
      out = -x[pressure_at(d)];
      continue;
    }
    if (at_floor_[at] != 0) {
      out = -x[pressure_at(d)] * floor_entry(d);
      continue;
    }
    double change = 0.0;
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      change += n.corner_weight[2 * k] * x[3 * n.corner_disc[k]] +
                n.corner_weight[2 * k + 1] * x[3 * n.corner_disc[k] + 1];
      if (!n.corner_turn.empty()) change += n.corner_turn[k] * x[3 * n.corner_disc[k] + 2] / length_scale_;
    }
    out = -(change + pressure_scale_ / n.stiffness[d] * x[pressure_at(d)]) / length_scale_;
    if (duration_ <= 0.0) continue;
    for (auto k = pipe_start_[at]; k < pipe_start_[at + 1]; ++k) {
      const auto end = pipe_of_[static_cast<std::size_t>(k)];
      const double moved = changes_[static_cast<std::size_t>(end / 2)].moved;
      out += end % 2 == 0 ? -moved : moved;
    }
  }
}

// Contacts of discs that were never bonded, pins and walls.
void CoupledSystem::products_of_few(const Vector& x, Vector& y) const {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_[k].gap >= 0.0) continue;
    const auto i = non_bonded_.pairs()[k].first, j = non_bonded_.pairs()[k].second;
    double f[4];
    pair_product(pairs_[k].tangent, i, j, x, f);
    y[3 * i] -= f[0];
    y[3 * i + 1] -= f[1];
    y[3 * j] += f[0];
    y[3 * j + 1] += f[1];
    y[3 * i + 2] += f[2] / length_scale_;
    y[3 * j + 2] += f[3] / length_scale_;
  }
  for (const auto& pin : pins_) {
    const double moved = x[3 * pin.disc] * pin.along.x + x[3 * pin.disc + 1] * pin.along.y;
    y[3 * pin.disc] += moved * pin.along.x;
    y[3 * pin.disc + 1] += moved * pin.along.y;
  }
  if (tractions_ > 0) products_of_exterior(x, y);
  if (!boundary_.walled()) return;
  for (std::size_t w = 0; w < boundary_.walls().size(); ++w) {
    const auto& wall = boundary_.walls()[w];
    if (w < servo_walls_) y[wall_at(w)] = regularisation * x[wall_at(w)];
    for (const auto i : wall.discs) {
      if (Boundary::closing_of(assembly_, wall, i) <= 0.0) continue;
      double closing = -(x[3 * i] * wall.inward.x + x[3 * i + 1] * wall.inward.y);
      if (w < servo_walls_) closing += x[wall_at(w)];
      y[3 * i] -= closing * wall.inward.x;
      y[3 * i + 1] -= closing * wall.inward.y;
      if (w < servo_walls_) y[wall_at(w)] += closing;
    }
  }
}

void CoupledSystem::products_of_exterior(const Vector& x, Vector& y) const {
  const Eigen::MatrixXd& compliance = boundary_.exterior()->compliance();
  const double scale = pressure_scale_ / length_scale_;
  for (std::int64_t row = 0; row < tractions_; ++row) y[traction_at(row)] = 0.0;
  for (std::int64_t column = 0; column < tractions_; ++column) {
    const double by = scale * x[traction_at(column)];
    for (std::int64_t row = 0; row < tractions_; ++row) y[traction_at(row)] -= compliance(row, column) * by;
  }
  each_rim_weight([&](std::int32_t disc, std::int32_t point, double weight) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const auto traction = traction_at(2 * point + axis);
      const double share = weight / length_scale_;
      y[traction] += share * x[3 * disc + axis];
      if (adrift_[static_cast<std::size_t>(disc)] == 0) y[3 * disc + axis] += share * x[traction];
    }
  });
}

void CoupledSystem::product(const Vector& x, Vector& y) const {
  const bool by_ranks = !own_.all();
  const auto bonds = static_cast<std::int64_t>(by_ranks ? own_.bond.size() : changes_.size());
  y.resize(x.size());
  team_.share(worth_sharing(), by_ranks, [&](const RankTeam::Member& member) {
    products_of_bonds(x, member.among(false).part(bonds, grain));
    member.barrier();
    products_on_discs(x, y, member.part(discs_, grain));
    products_on_domains(x, y, member.part(domains_, grain));
    if (!by_ranks) return;
    member.gather(y.data(), 3 * discs_, 3 * grain);
    member.gather(y.data() + pressure_at(0), domains_, grain);
  });
  products_of_few(x, y);
  if (!wet_) return;
  each_cluster_pair([&](std::int32_t row, std::int32_t column, double by) {
    if (at_floor_[static_cast<std::size_t>(row)] == 0) y[pressure_at(row)] += by * x[pressure_at(column)];
  });
  products_of_facets(x, y);
}

// What pressures do to facets: beside what domains' corners have, an open one is compressed at its faces, and a closed one slides.
void CoupledSystem::products_of_facets(const Vector& x, Vector& y) const {
  for (std::size_t k = 0; k < facet_open_.size(); ++k) {
    const Facet& f = facets_.all()[k];
    const double push = x[pressure_at(f.left)] * f.left_length + x[pressure_at(f.right)] * f.right_length;
    if (facet_open_[k] != 0) {
      const double more = push * pressure_scale_ / facets_.start().stiffness / length_scale_;
      for (const auto& [domain, length] :
           {std::pair{f.left, f.left_length}, std::pair{f.right, f.right_length}})
        if (network_.kind[domain] == DomainKind::rock && at_floor_[domain] == 0)
          y[pressure_at(domain)] -= length * more;
      continue;
    }
    const double shear = by_push_[k] * push / length_scale_;
    if (shear == 0.0) continue;
    const auto i = assembly_.first[f.bond], j = assembly_.second[f.bond];
    const double arm_i = assembly_.arm(f.bond), arm_j = assembly_.length(f.bond) - arm_i;
    const Vec2 t{-f.normal.y, f.normal.x};
    y[3 * i] -= shear * t.x;
    y[3 * i + 1] -= shear * t.y;
    y[3 * j] += shear * t.x;
    y[3 * j + 1] += shear * t.y;
    y[3 * i + 2] -= shear * arm_i / length_scale_;
    y[3 * j + 2] -= shear * arm_j / length_scale_;
  }
}

}  // namespace hfrac
