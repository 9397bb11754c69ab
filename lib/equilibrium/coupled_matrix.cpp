// SPDX-License-Identifier: BSD-3-Clause
// The tangent of coupled_system.hpp as a sparse matrix for a factor: which unknowns go together, and the list of entries. The list
// has the same places from call to call, zeros included, as long as the same pairs of discs are near.
#include <algorithm>
#include <cmath>

#include "equilibrium/coupled_system.hpp"

namespace hfrac {
namespace {

constexpr std::size_t entries_of_pair = 36;
constexpr double no_tangent[16] = {};

// The 6 x 6 block of a pair, from its tangent in q = (d, theta_i, theta_j).
template <class Emit>
void emit_pair(const double* tangent, std::int32_t i, std::int32_t j, double force_scale, double length_scale,
               const Emit& emit) {
  const std::int32_t place[6] = {3 * i, 3 * i + 1, 3 * i + 2, 3 * j, 3 * j + 1, 3 * j + 2};
  constexpr int way[6] = {0, 1, 2, 0, 1, 3};
  const double factor[6] = {-1.0, -1.0, 1.0 / length_scale, 1.0, 1.0, 1.0 / length_scale};
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c)
      emit(place[r], place[c], factor[r] * factor[c] * tangent[4 * way[r] + way[c]] / force_scale);
  }
}

}  // namespace

template <class Emit, class Needs>
void CoupledSystem::each_entry(const Emit& emit, const Needs& needs) const {
  const auto& a = assembly_;
  const auto& n = network_;
  const auto at = [&](std::int64_t domain) { return static_cast<std::int32_t>(pressure_at(domain)); };
  for (std::size_t e = 0; e < changes_.size(); ++e) {
    const auto emit_bond = [&](const double* tangent) {
      emit_pair(tangent, a.first[e], a.second[e], force_scale_, length_scale_, emit);
    };
    if (needs(entries_of_pair))
      with_tangent(e, emit_bond);
    else
      emit_bond(no_tangent);
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const auto& pair = non_bonded_.pairs()[k];
    emit_pair(pairs_[k].tangent, pair.first, pair.second, force_scale_, length_scale_, emit);
  }
  for (std::int32_t u = 0; u < 3 * discs_; ++u)
    emit(u, u, adrift_[static_cast<std::size_t>(u / 3)] != 0 ? 1.0 : regularisation);
  for (const auto& pin : pins_) {
    const std::int32_t p = 3 * pin.disc;
    emit(p, p, pin.along.x * pin.along.x);
    emit(p, p + 1, pin.along.x * pin.along.y);
    emit(p + 1, p, pin.along.x * pin.along.y);
    emit(p + 1, p + 1, pin.along.y * pin.along.y);
  }
  for (std::size_t w = 0; boundary_.walled() && w < boundary_.walls().size(); ++w) {
    const auto& wall = boundary_.walls()[w];
    for (const auto i : wall.discs) {
      const double touches = wall.displacement - dot({a.ux[i], a.uy[i]}, wall.inward) > 0.0 ? 1.0 : 0.0;
      const std::int32_t p = 3 * i + (wall.inward.x == 0.0 ? 1 : 0);  // walls stand along the axes
      const double inward = wall.inward.x + wall.inward.y;
      emit(p, p, touches);
      if (w >= servo_walls_) continue;
      const auto q = static_cast<std::int32_t>(wall_at(w));
      emit(q, p, -touches * inward);
      emit(p, q, -touches * inward);
      emit(q, q, touches);
    }
    if (w < servo_walls_)
      emit(static_cast<std::int32_t>(wall_at(w)), static_cast<std::int32_t>(wall_at(w)), regularisation);
  }
  for (std::int64_t d = 0; d < domains_; ++d) {
    const bool solved = wet_ && at_floor_[static_cast<std::size_t>(d)] == 0;
    emit(at(d), at(d), wet_ ? -floor_entry(d) : -1.0);
    if (!wet_ || n.kind[d] == DomainKind::outside) continue;
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const std::int32_t p = 3 * n.corner_disc[k];
      const double held = adrift_[static_cast<std::size_t>(n.corner_disc[k])] != 0 ? 0.0 : 1.0;
      const double x = n.corner_weight[2 * k] / length_scale_, y = n.corner_weight[2 * k + 1] / length_scale_;
      emit(p, at(d), -held * x);
      emit(p + 1, at(d), -held * y);
      emit(at(d), p, solved ? -x : 0.0);
      emit(at(d), p + 1, solved ? -y : 0.0);
      if (n.corner_turn.empty()) continue;
      const double turn = n.corner_turn[k] / length_scale_ / length_scale_;
      emit(p + 2, at(d), -held * turn);
      emit(at(d), p + 2, solved ? -turn : 0.0);
    }
  }
  each_rim_weight([&](std::int32_t disc, std::int32_t point, double weight) {
    const double held = adrift_[static_cast<std::size_t>(disc)] != 0 ? 0.0 : 1.0;
    for (std::int32_t axis = 0; axis < 2; ++axis) {
      const auto traction = static_cast<std::int32_t>(traction_at(2 * point + axis));
      emit(3 * disc + axis, traction, held * weight / length_scale_);
      emit(traction, 3 * disc + axis, weight / length_scale_);
    }
  });
  for (std::int64_t column = 0; column < tractions_; ++column) {
    for (std::int64_t row = 0; row < tractions_; ++row)
      emit(static_cast<std::int32_t>(traction_at(row)), static_cast<std::int32_t>(traction_at(column)),
           -boundary_.exterior()->compliance()(row, column) * pressure_scale_ / length_scale_);
  }
  if (!wet_ || duration_ <= 0.0) return;
  each_cluster_pair([&](std::int32_t row, std::int32_t column, double by) {
    emit(at(row), at(column), at_floor_[static_cast<std::size_t>(row)] == 0 ? by : 0.0);
  });
  for (std::size_t e = 0; e < changes_.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    if (l == r) continue;
    const double on_l = at_floor_[static_cast<std::size_t>(l)] == 0 ? 1.0 : 0.0,
                 on_r = at_floor_[static_cast<std::size_t>(r)] == 0 ? 1.0 : 0.0;
    const double c = duration_ * slope_[e] * pressure_scale_ / length_scale_;
    emit(at(l), at(l), -on_l * c);
    emit(at(r), at(r), -on_r * c);
    emit(at(l), at(r), on_l * c);
    emit(at(r), at(l), on_r * c);
    const Vec2 way = (aperture_change_[e] / length_scale_) * opening_way_[e].along +
                     (squeeze_change_[e] / length_scale_) * opening_way_[e].direction;
    const double x = way.x, y = way.y;
    for (const auto& [disc, sign] : {std::pair{a.first[e], -1.0}, std::pair{a.second[e], 1.0}}) {
      emit(at(l), 3 * disc, -on_l * sign * x);
      emit(at(l), 3 * disc + 1, -on_l * sign * y);
      emit(at(r), 3 * disc, on_r * sign * x);
      emit(at(r), 3 * disc + 1, on_r * sign * y);
    }
    if (!turns_open_) continue;
    const double change = aperture_change_[e] / length_scale_ / length_scale_;
    for (const auto& [disc, turn] : {std::pair{a.first[e], change * opening_way_[e].by_first},
                                     std::pair{a.second[e], change * opening_way_[e].by_second}}) {
      emit(at(l), 3 * disc + 2, -on_l * turn);
      emit(at(r), 3 * disc + 2, on_r * turn);
    }
  }
}

template <class Visit>
void CoupledSystem::each_place(const Visit& visit) const {
  each_entry([&](std::int32_t row, std::int32_t column, double) { visit(row, column); },
             [](std::size_t) { return false; });
}

std::size_t CoupledSystem::entry_count() const {
  std::size_t all = 0;
  each_place([&](std::int32_t, std::int32_t) { ++all; });
  return all;
}

template <class Real>
double CoupledSystem::entries(std::vector<Real>& values, const std::vector<bool>& wanted,
                              std::size_t count) const {
  values.clear();
  values.reserve(count);
  double largest = 0.0;
  std::size_t number = 0;
  const auto take = [&](std::int32_t, std::int32_t, double value) {
    const bool is_wanted = values.size() < count && (wanted.empty() || wanted[number]);
    ++number;
    if (!is_wanted) return;
    values.push_back(static_cast<Real>(value));
    if (const double size = std::abs(value); size > largest) largest = size;
  };
  const auto needs = [&](std::size_t next) {
    return wanted.empty() || std::any_of(wanted.begin() + static_cast<std::ptrdiff_t>(number),
                                         wanted.begin() + static_cast<std::ptrdiff_t>(number + next),
                                         [](bool is) { return is; });
  };
  each_entry(take, needs);
  return largest;
}

template double CoupledSystem::entries(std::vector<float>&, const std::vector<bool>&, std::size_t) const;
template double CoupledSystem::entries(std::vector<double>&, const std::vector<bool>&, std::size_t) const;

std::vector<std::int32_t> CoupledSystem::entries_of_rows() const {
  std::vector<std::int32_t> count(static_cast<std::size_t>(size()), 0);
  each_place([&](std::int32_t row, std::int32_t) { ++count[static_cast<std::size_t>(row)]; });
  return count;
}

std::size_t CoupledSystem::entries(std::vector<double>& values, std::int64_t first, std::int64_t end) const {
  std::size_t all = 0, wanted = 0;
  const auto is_wanted = [&](std::int32_t row) { return row >= first && row < end; };
  each_place([&](std::int32_t row, std::int32_t) {
    ++all;
    wanted += is_wanted(row) ? 1 : 0;
  });
  values.clear();
  values.reserve(wanted);
  each_entry(
      [&](std::int32_t row, std::int32_t, double value) {
        if (is_wanted(row)) values.push_back(value);
      },
      [](std::size_t) { return true; });
  return all;
}

void CoupledSystem::places(std::vector<std::int32_t>& rows, std::vector<std::int32_t>& columns,
                           std::int64_t first, std::int64_t end) const {
  each_place([&](std::int32_t row, std::int32_t column) {
    if (row < first || row >= end) return;
    rows.push_back(row);
    columns.push_back(column);
  });
}

CoupledSystem::Structure CoupledSystem::structure() const {
  const auto& n = network_;
  Structure s;
  // Nodes: discs with three unknowns, then domains, servo-driven walls and tractions of the rock beyond with one each.
  const auto discs = static_cast<std::int32_t>(discs_);
  const auto nodes = discs + static_cast<std::int32_t>(domains_) + static_cast<std::int32_t>(servo_walls_) +
                     static_cast<std::int32_t>(tractions_);
  for (std::int32_t k = 0; k <= nodes; ++k) s.node_start.push_back(k <= discs ? 3 * k : 2 * discs + k);
  s.late.assign(static_cast<std::size_t>(nodes), 0);
  for (std::int32_t i = 0; i < discs; ++i) s.position.push_back({assembly_.x[i], assembly_.y[i]});
  for (std::size_t d = 0; d < n.centroid.size(); ++d) {
    s.position.push_back(n.centroid[d]);
    if (n.kind[d] != DomainKind::rock) s.late[static_cast<std::size_t>(discs) + d] = 1;
  }
  for (std::size_t w = 0; w < servo_walls_; ++w) {
    s.position.push_back({});
    s.late[static_cast<std::size_t>(discs) + n.centroid.size() + w] = 1;
  }
  for (std::int64_t k = 0; k < tractions_; ++k) {
    s.position.push_back(boundary_.exterior()->points()[static_cast<std::size_t>(k / 2)]);
    s.late[static_cast<std::size_t>(nodes - tractions_ + k)] = 1;
  }
  s.each_place = [this](const auto& visit) {
    each_place([&](std::int32_t row, std::int32_t column) { visit({row, column}); });
  };
  const auto node_of = [&](std::int32_t unknown) {
    return unknown < 3 * discs ? unknown / 3 : unknown - 2 * discs;
  };
  // Neighbours node by node, most of them several times over, which a list of those seen last by which node tells.
  std::vector<std::int64_t> begin(static_cast<std::size_t>(nodes) + 1, 0);
  const auto each_edge = [&](const auto& visit) {
    std::int32_t last_p = -1, last_q = -1;  // entries of the same two nodes often follow each other
    each_place([&](std::int32_t row, std::int32_t column) {
      const auto p = node_of(row), q = node_of(column);
      if (p == q || (p == last_p && q == last_q)) return;
      visit(p, q);
      visit(q, p);
      last_p = p;
      last_q = q;
    });
  };
  each_edge([&](std::int32_t p, std::int32_t) { ++begin[static_cast<std::size_t>(p) + 1]; });
  for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
  std::vector<std::int32_t> others(static_cast<std::size_t>(begin.back()));
  auto cursor = begin;
  each_edge([&](std::int32_t p, std::int32_t q) {
    others[static_cast<std::size_t>(cursor[static_cast<std::size_t>(p)]++)] = q;
  });
  std::vector<std::int32_t> seen_by(static_cast<std::size_t>(nodes), -1);
  s.graph.start.assign(1, 0);
  for (std::int32_t p = 0; p < nodes; ++p) {
    const auto first = s.graph.neighbour.size();
    for (auto k = begin[static_cast<std::size_t>(p)]; k < begin[static_cast<std::size_t>(p) + 1]; ++k) {
      const auto q = others[static_cast<std::size_t>(k)];
      if (seen_by[static_cast<std::size_t>(q)] == p) continue;
      seen_by[static_cast<std::size_t>(q)] = p;
      s.graph.neighbour.push_back(q);
    }
    std::sort(s.graph.neighbour.begin() + static_cast<std::ptrdiff_t>(first), s.graph.neighbour.end());
    s.graph.start.push_back(static_cast<std::int32_t>(s.graph.neighbour.size()));
  }
  return s;
}

}  // namespace hfrac
