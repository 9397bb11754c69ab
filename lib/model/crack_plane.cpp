// SPDX-License-Identifier: BSD-3-Clause
#include "model/crack_plane.hpp"

#include <algorithm>
#include <cmath>

#include "geom/cell_grid.hpp"
#include "model/assembly.hpp"
#include "model/joint_pores.hpp"
#include "model/network.hpp"

namespace hfrac {
namespace {

constexpr double reach = 3.0;           // mean radii
constexpr double shortest_share = 0.1;  // of R_i + R_j, of a pipe's length

bool contains(const std::vector<std::int32_t>& list, std::int32_t item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

}  // namespace

void CrackPlanes::begin(const Network& n, const Assembly& a) {
  const auto bonds = a.first.size();
  planes_.assign(bonds, {});
  intact_.assign(bonds, 1);
  broken_.clear();
  pipe_start_.assign(static_cast<std::size_t>(n.domain_count()) + 1, 0);
  for (std::size_t e = 0; e < bonds; ++e) {
    ++pipe_start_[static_cast<std::size_t>(n.left[e]) + 1];
    ++pipe_start_[static_cast<std::size_t>(n.right[e]) + 1];
  }
  for (std::size_t d = 1; d < pipe_start_.size(); ++d) pipe_start_[d] += pipe_start_[d - 1];
  pipe_of_.resize(2 * bonds);
  auto cursor = pipe_start_;
  for (std::size_t e = 0; e < bonds; ++e) {
    for (const auto d : {n.left[e], n.right[e]})
      pipe_of_[static_cast<std::size_t>(cursor[static_cast<std::size_t>(d)]++)] =
          static_cast<std::int32_t>(e);
  }
  refresh(n, a);
}

Vec2 CrackPlanes::middle(const Assembly& a, std::int32_t bond) const {
  const auto i = a.first[static_cast<std::size_t>(bond)];
  const double share = a.arm(bond) / a.length(bond);
  return {a.x[i] + share * a.dx(bond), a.y[i] + share * a.dy(bond)};
}

void CrackPlanes::refresh(const Network& n, const Assembly& a) {
  if (planes_.empty() || intact_ == a.intact) return;
  std::vector<double> x, y;  // of what changed
  bool mended = false;
  for (std::size_t e = 0; e < intact_.size(); ++e) {
    if (intact_[e] == a.intact[e]) continue;
    const auto bond = static_cast<std::int32_t>(e);
    const Vec2 at = middle(a, bond);
    x.push_back(at.x);
    y.push_back(at.y);
    if (a.intact[e] == 0) {
      broken_.push_back(bond);
    } else {
      planes_[e] = {};
      mended = true;
    }
  }
  intact_ = a.intact;
  if (mended)
    std::erase_if(broken_, [&](std::int32_t e) { return intact_[static_cast<std::size_t>(e)] != 0; });
  std::sort(broken_.begin(), broken_.end());
  const CellGrid changed(x, y, reach * a.mean_radius);
  for (const auto e : broken_) {
    const double far = reach * a.mean_radius_of(e);
    const Vec2 at = middle(a, e);
    bool near = false;
    changed.near(at.x, at.y, far, [&](std::int32_t k) {
      const Vec2 between{x[static_cast<std::size_t>(k)] - at.x, y[static_cast<std::size_t>(k)] - at.y};
      near = near || dot(between, between) <= far * far;
    });
    if (near) planes_[static_cast<std::size_t>(e)] = fit(n, a, e);
  }
}

CrackPlane CrackPlanes::fit(const Network& n, const Assembly& a, std::int32_t e) {
  const auto bond = static_cast<std::size_t>(e);
  const Vec2 at = middle(a, e);
  const Vec2 along_bond{a.dx(e) / a.length(e), a.dy(e) / a.length(e)};
  const auto joins = [&](std::int32_t d) { return n.kind[static_cast<std::size_t>(d)] == DomainKind::rock; };
  // Through the left pore lies what is behind (side -1), through the right one what is ahead. Domains in the order in which they
  // are reached.
  queue_.clear();
  bonds_.assign(1, e);
  domains_.clear();
  double count = 1.0, behind = 0.0, ahead = 0.0;
  Vec2 sum{}, from{}, to{};
  double xx = 0.0, xy = 0.0, yy = 0.0;
  const auto add = [&](Vec2 place, double side) {
    const Vec2 p = place - at;
    count += 1.0;
    sum = sum + p;
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
    (side < 0.0 ? behind : ahead) += 1.0;
    (side < 0.0 ? from : to) = (side < 0.0 ? from : to) + p;
  };
  const auto enter = [&](std::int32_t d, double side) {
    if (!joins(d) || contains(domains_, d)) return;
    domains_.push_back(d);
    queue_.push_back({d, side});
    add(n.centroid[static_cast<std::size_t>(d)], side);
  };
  enter(n.left[bond], -1.0);
  enter(n.right[bond], 1.0);
  const double far = reach * a.mean_radius_of(e);
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const Visit here = queue_[k];
    for (auto q = pipe_start_[static_cast<std::size_t>(here.domain)];
         q < pipe_start_[static_cast<std::size_t>(here.domain) + 1]; ++q) {
      const auto other = pipe_of_[static_cast<std::size_t>(q)];
      if (intact_[static_cast<std::size_t>(other)] != 0 || contains(bonds_, other)) continue;
      const Vec2 place = middle(a, other), between = place - at;
      if (dot(between, between) > far * far) continue;
      bonds_.push_back(other);
      add(place, here.side);
      const auto o = static_cast<std::size_t>(other);
      enter(n.left[o] == here.domain ? n.right[o] : n.left[o], here.side);
    }
  }
  CrackPlane plane;
  Vec2 way{along_bond.y, -along_bond.x};  // from the left domain to the right one, across the line of centres
  if (a.joints.joint_of(e) >= 0) {
    plane.normal = a.joint_normal(e);
    way = {plane.normal.y, -plane.normal.x};
  } else {
    xx -= sum.x * sum.x / count;
    xy -= sum.x * sum.y / count;
    yy -= sum.y * sum.y / count;
    if (count > 2.0 && xx + yy > 0.0) {
      const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
      const Vec2 axis{std::cos(angle), std::sin(angle)};
      Vec2 forward = way;
      if (behind > 0.0 && ahead > 0.0)
        forward = (1.0 / ahead) * to - (1.0 / behind) * from;
      else if (ahead > 0.0)
        forward = to;
      else if (behind > 0.0)
        forward = -1.0 * from;
      way = dot(axis, forward) < 0.0 ? -1.0 * axis : axis;
    }
    plane.normal = {-way.y, way.x};
  }
  const Vec2 across{-along_bond.y, along_bond.x};
  plane.by_first = -dot(plane.normal, across) * a.arm(e);
  plane.by_second = -dot(plane.normal, across) * (a.length(e) - a.arm(e));
  plane.shrinks = dot(plane.normal, along_bond);
  Vec2 leg{};
  if (joins(n.right[bond])) leg = leg + (n.centroid[static_cast<std::size_t>(n.right[bond])] - at);
  if (joins(n.left[bond])) leg = leg - (n.centroid[static_cast<std::size_t>(n.left[bond])] - at);
  plane.length = std::max(std::abs(dot(way, leg)), shortest_share * a.pipe_length(e));
  return plane;
}

double CrackPlanes::opening(const CrackPlane& plane, const Assembly& a, std::size_t bond) {
  const auto i = a.first[bond], j = a.second[bond];
  return plane.normal.x * (a.ux[j] - a.ux[i]) + plane.normal.y * (a.uy[j] - a.uy[i]) +
         plane.by_first * a.rotation[i] + plane.by_second * a.rotation[j] -
         plane.shrinks * a.factors.growth_of(static_cast<std::int64_t>(bond));
}

double pipe_length(const Network& n, const Assembly& a, std::size_t pipe) {
  if (const double length = joint_length(n, pipe); length > 0.0) return length;
  const CrackPlane* plane = n.planes.of(pipe);
  return plane != nullptr ? plane->length : a.pipe_length(static_cast<std::int64_t>(pipe));
}

}  // namespace hfrac
