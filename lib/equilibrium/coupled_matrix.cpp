// SPDX-License-Identifier: BSD-3-Clause
// The tangent of coupled_system.hpp as a sparse matrix, for factors: its symmetric part, and a good order of elimination.
#include <algorithm>
#include <cmath>

#include "equilibrium/coupled_system.hpp"

namespace hfrac {
namespace {

void put(std::vector<Eigen::Triplet<double>>& entries, Eigen::Index row, Eigen::Index column, double value) {
  if (value != 0.0 || row == column)
    entries.emplace_back(std::max(row, column), std::min(row, column), value);
}

}  // namespace

void CoupledSystem::pair_entries(const double* k, std::int32_t i, std::int32_t j,
                                 std::vector<Eigen::Triplet<double>>& entries) const {
  // q = B (six unknowns of the two discs); the symmetric part of B' k B.
  double s[4][4];
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      const double scale = force_scale_ * (r >= 2 ? length_scale_ : 1.0) * (c >= 2 ? length_scale_ : 1.0);
      s[r][c] = 0.5 * (k[4 * r + c] + k[4 * c + r]) / scale;
    }
  }
  const Eigen::Index bi = 3 * static_cast<Eigen::Index>(i), bj = 3 * static_cast<Eigen::Index>(j);
  const Eigen::Index place[6] = {bi, bi + 1, bi + 2, bj, bj + 1, bj + 2};
  const int way[6] = {0, 1, 2, 0, 1, 3};
  const double sign[6] = {-1.0, -1.0, 1.0, 1.0, 1.0, 1.0};
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c <= r; ++c) put(entries, place[r], place[c], sign[r] * sign[c] * s[way[r]][way[c]]);
  }
}

void CoupledSystem::symmetric_part(std::vector<Eigen::Triplet<double>>& entries) const {
  const auto& a = assembly_;
  const auto& n = network_;
  entries.clear();
  for (std::size_t e = 0; e < bonds_.size(); ++e)
    pair_entries(bonds_[e].tangent, a.first[e], a.second[e], entries);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    if (pairs_[k].gap < 0.0)
      pair_entries(pairs_[k].tangent, loose_.pairs()[k].first, loose_.pairs()[k].second, entries);
  }
  // A disc that nothing holds any more is held by a hair.
  for (std::int64_t i = 0; i < 3 * discs_; ++i) put(entries, i, i, 1e-9);
  for (const auto& pin : pins_) {
    const Eigen::Index p = 3 * static_cast<Eigen::Index>(pin.disc);
    put(entries, p, p, pin.along.x * pin.along.x);
    put(entries, p + 1, p, pin.along.x * pin.along.y);
    put(entries, p + 1, p + 1, pin.along.y * pin.along.y);
  }
  for (std::size_t w = 0; w < boundary_.walls().size() && boundary_.walled(); ++w) {
    const auto& wall = boundary_.walls()[w];
    for (const auto i : wall.discs) {
      if (wall.displacement - dot({a.ux[i], a.uy[i]}, wall.inward) <= 0.0) continue;
      const Eigen::Index p = 3 * static_cast<Eigen::Index>(i);
      put(entries, p, p, wall.inward.x * wall.inward.x);
      put(entries, p + 1, p + 1, wall.inward.y * wall.inward.y);
      if (w >= servo_walls_) continue;
      put(entries, wall_at(w), p, -wall.inward.x);
      put(entries, wall_at(w), p + 1, -wall.inward.y);
      put(entries, wall_at(w), wall_at(w), 1.0);
    }
    if (w < servo_walls_) put(entries, wall_at(w), wall_at(w), 1e-9);
  }
  const auto solved = [&](std::int64_t d) { return wet_ && at_floor_[static_cast<std::size_t>(d)] == 0; };
  for (std::int64_t d = 0; d < domains_; ++d) {
    if (!solved(d)) {
      put(entries, pressure_at(d), pressure_at(d), -1.0);
      continue;
    }
    put(entries, pressure_at(d), pressure_at(d), -pressure_scale_ / n.stiffness[d] / length_scale_);
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const Eigen::Index p = 3 * static_cast<Eigen::Index>(n.corner_disc[k]);
      put(entries, pressure_at(d), p, -n.corner_weight[2 * k] / length_scale_);
      put(entries, pressure_at(d), p + 1, -n.corner_weight[2 * k + 1] / length_scale_);
    }
  }
  if (!wet_ || duration_ <= 0.0) return;
  for (std::size_t e = 0; e < bonds_.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    if (n.conductance[e] == 0.0) continue;
    const double c = duration_ * n.conductance[e] * pressure_scale_ / length_scale_;
    if (solved(l)) put(entries, pressure_at(l), pressure_at(l), -c);
    if (solved(r)) put(entries, pressure_at(r), pressure_at(r), -c);
    if (solved(l) && solved(r)) put(entries, pressure_at(l), pressure_at(r), c);
  }
}

std::vector<Eigen::Index> CoupledSystem::order() const {
  // Nodes: discs, then domains; the outside and servo walls touch too many and go last.
  const auto& a = assembly_;
  const auto& n = network_;
  const auto cut = discs_ + domains_ - 1;
  const auto node_of_domain = [&](std::int32_t d) {
    return static_cast<std::int32_t>(d == 0 ? cut : discs_ + d - 1);
  };
  std::vector<Vec2> position;
  for (std::int64_t i = 0; i < discs_; ++i) position.push_back({a.x[i], a.y[i]});
  for (std::size_t d = 1; d < n.centroid.size(); ++d) position.push_back(n.centroid[d]);
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  const auto join = [&](std::int32_t p, std::int32_t q) {
    if (p == q || p >= cut || q >= cut) return;
    edges.emplace_back(p, q);
    edges.emplace_back(q, p);
  };
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    join(a.first[e], a.second[e]);
    join(node_of_domain(n.left[e]), node_of_domain(n.right[e]));
  }
  for (const auto& pair : loose_.pairs()) join(pair.first, pair.second);
  // A well is a domain with corners all around it: it goes last too.
  std::vector<char> late(static_cast<std::size_t>(discs_ + domains_), 0);
  for (std::int64_t d = 1; d < domains_; ++d) {
    if (n.kind[d] != DomainKind::rock) {
      late[static_cast<std::size_t>(node_of_domain(static_cast<std::int32_t>(d)))] = 1;
      continue;
    }
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
      join(n.corner_disc[k], node_of_domain(static_cast<std::int32_t>(d)));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Adjacency graph;
  graph.start.assign(static_cast<std::size_t>(cut) + 1, 0);
  for (const auto& [p, q] : edges) {
    if (late[static_cast<std::size_t>(p)] != 0 || late[static_cast<std::size_t>(q)] != 0) continue;
    ++graph.start[static_cast<std::size_t>(p) + 1];
    graph.neighbour.push_back(q);
  }
  for (std::int64_t k = 0; k < cut; ++k)
    graph.start[static_cast<std::size_t>(k) + 1] += graph.start[static_cast<std::size_t>(k)];
  const auto nodes = dissect(position, graph, 0);
  std::vector<Eigen::Index> unknowns, end;
  for (const auto node : nodes) {
    if (node < discs_) {
      for (int k = 0; k < 3; ++k) unknowns.push_back(3 * static_cast<Eigen::Index>(node) + k);
    } else {
      auto& list = late[static_cast<std::size_t>(node)] != 0 ? end : unknowns;
      list.push_back(pressure_at(node - discs_ + 1));
    }
  }
  unknowns.insert(unknowns.end(), end.begin(), end.end());
  unknowns.push_back(pressure_at(0));
  for (std::size_t w = 0; w < servo_walls_; ++w) unknowns.push_back(wall_at(w));
  return unknowns;
}

}  // namespace hfrac
