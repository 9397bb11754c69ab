// SPDX-License-Identifier: BSD-3-Clause
#include "host/host_grid.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr std::int64_t most_cells = 100'000'000;

std::string name_of(std::int64_t cell, std::int64_t nx) {
  return "cell (" + std::to_string(cell % nx) + ", " + std::to_string(cell / nx) + ")";
}

void require_counts(std::int64_t nx, std::int64_t ny) {
  if (nx >= 1 && ny >= 1 && nx <= most_cells && ny <= most_cells / nx) return;
  throw Error(ErrorKind::argument, "a grid of nx = " + std::to_string(nx) +
                                       " times ny = " + std::to_string(ny) +
                                       " cells is not possible; both from 1, together at most " +
                                       std::to_string(most_cells) + ".");
}

}  // namespace

HostGrid HostGrid::regular(std::int64_t nx, std::int64_t ny, Vec2 origin, Vec2 size, double angle) {
  require_counts(nx, ny);
  if (!(size.x > 0.0) || !(size.y > 0.0) || !std::isfinite(size.x) || !std::isfinite(size.y)) {
    throw Error(ErrorKind::argument, "cells of " + std::to_string(size.x) + " m by " +
                                         std::to_string(size.y) +
                                         " m: both sizes must be positive and finite.");
  }
  if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(angle))
    throw Error(ErrorKind::argument, "origin or angle of the grid is not a finite number.");
  const Vec2 along{size.x * std::cos(angle), size.x * std::sin(angle)},
      up{-size.y * std::sin(angle), size.y * std::cos(angle)};
  std::vector<Quad> cells;
  cells.reserve(static_cast<std::size_t>(nx * ny));
  for (std::int64_t j = 0; j < ny; ++j) {
    for (std::int64_t i = 0; i < nx; ++i) {
      const auto corner = [&](std::int64_t a, std::int64_t b) {
        return origin + static_cast<double>(a) * along + static_cast<double>(b) * up;
      };
      cells.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return {nx, ny, std::move(cells)};
}

HostGrid HostGrid::from_corners(std::int64_t nx, std::int64_t ny, const double* corners) {
  require_counts(nx, ny);
  std::vector<Quad> cells(static_cast<std::size_t>(nx * ny));
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t k = 0; k < 4; ++k) {
      cells[c][k] = {corners[8 * c + 2 * k], corners[8 * c + 2 * k + 1]};
      if (std::isfinite(cells[c][k].x) && std::isfinite(cells[c][k].y)) continue;
      throw Error(ErrorKind::argument,
                  "a corner of " + name_of(static_cast<std::int64_t>(c), nx) + " is not a finite number.");
    }
  }
  return {nx, ny, std::move(cells)};
}

HostGrid::HostGrid(std::int64_t nx, std::int64_t ny, std::vector<Quad> cells)
    : nx_(nx), ny_(ny), cells_(std::move(cells)), turned_(cells_.size(), 0) {
  constexpr double far = std::numeric_limits<double>::max();
  Vec2 high{-far, -far};
  low_ = {far, far};
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    Quad& q = cells_[c];
    if (area_of(q) < 0.0) {
      std::swap(q[1], q[3]);  // keeps the first corner
      turned_[c] = 1;
    }
    const double area = area_of(q);
    for (std::size_t k = 0; k < 4; ++k) {
      if (!(turn(q[k], q[(k + 1) % 4], q[(k + 2) % 4]) > 1e-12 * area)) {
        throw Error(
            ErrorKind::argument,
            name_of(static_cast<std::int64_t>(c), nx_) +
                " is no convex quadrilateral; give its four corners in order around it, none of them on a "
                "line between its neighbours.");
      }
      low_ = {std::min(low_.x, q[k].x), std::min(low_.y, q[k].y)};
      high = {std::max(high.x, q[k].x), std::max(high.y, q[k].y)};
    }
  }
  // A raster of about as many bins as cells, shaped like the grid's box.
  const Vec2 extent = high - low_;
  const double side = std::sqrt(extent.x * extent.y / static_cast<double>(cells_.size()));
  bins_x_ = std::clamp<std::int64_t>(std::llround(extent.x / side), 1, 4 * nx_ * ny_);
  bins_y_ = std::clamp<std::int64_t>(std::llround(extent.y / side), 1, 4 * nx_ * ny_ / bins_x_ + 1);
  bin_ = {extent.x / static_cast<double>(bins_x_), extent.y / static_cast<double>(bins_y_)};
  bin_start_.assign(static_cast<std::size_t>(bins_x_ * bins_y_) + 1, 0);
  std::vector<std::size_t> cursor;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      Vec2 from{far, far}, to{-far, -far};
      for (const Vec2 p : cells_[c]) {
        from = {std::min(from.x, p.x), std::min(from.y, p.y)};
        to = {std::max(to.x, p.x), std::max(to.y, p.y)};
      }
      const auto bin_of = [&](double at, double start, double size, std::int64_t bins) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((at - start) / size)), 0,
                                        bins - 1);
      };
      for (auto y = bin_of(from.y, low_.y, bin_.y, bins_y_); y <= bin_of(to.y, low_.y, bin_.y, bins_y_);
           ++y) {
        for (auto x = bin_of(from.x, low_.x, bin_.x, bins_x_); x <= bin_of(to.x, low_.x, bin_.x, bins_x_);
             ++x) {
          const auto b = static_cast<std::size_t>(x + bins_x_ * y);
          if (pass == 0) {
            ++bin_start_[b + 1];
          } else {
            bin_cell_[cursor[b]++] = static_cast<std::int64_t>(c);
          }
        }
      }
    }
    if (pass == 1) break;
    for (std::size_t b = 0; b + 1 < bin_start_.size(); ++b) bin_start_[b + 1] += bin_start_[b];
    bin_cell_.resize(bin_start_.back());
    cursor.assign(bin_start_.begin(), bin_start_.end() - 1);
  }
}

std::vector<std::int64_t> HostGrid::cells_near(Vec2 low, Vec2 high) const {
  const auto first_x = static_cast<std::int64_t>(std::floor((low.x - low_.x) / bin_.x)),
             last_x = static_cast<std::int64_t>(std::floor((high.x - low_.x) / bin_.x)),
             first_y = static_cast<std::int64_t>(std::floor((low.y - low_.y) / bin_.y)),
             last_y = static_cast<std::int64_t>(std::floor((high.y - low_.y) / bin_.y));
  std::vector<std::int64_t> near;
  for (auto y = std::max<std::int64_t>(first_y, 0); y <= std::min(last_y, bins_y_ - 1); ++y) {
    for (auto x = std::max<std::int64_t>(first_x, 0); x <= std::min(last_x, bins_x_ - 1); ++x) {
      const auto b = static_cast<std::size_t>(x + bins_x_ * y);
      near.insert(near.end(), bin_cell_.begin() + static_cast<std::ptrdiff_t>(bin_start_[b]),
                  bin_cell_.begin() + static_cast<std::ptrdiff_t>(bin_start_[b + 1]));
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

std::int64_t HostGrid::cell_at(Vec2 p) const {
  for (const auto c : cells_near(p, p)) {
    if (holds(cell(c), p)) return c;
  }
  return -1;
}

std::int64_t HostGrid::nearest_cell(Vec2 p, const std::function<bool(std::int64_t)>& fits) const {
  // A growing box: what lies within its half width is found in it.
  const Vec2 extent{bin_.x * static_cast<double>(bins_x_), bin_.y * static_cast<double>(bins_y_)};
  const double largest = std::abs(p.x - low_.x) + std::abs(p.y - low_.y) + extent.x + extent.y;
  for (double reach = bin_.x + bin_.y;; reach *= 2.0) {
    std::int64_t best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto c : cells_near({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach})) {
      if (!fits(c)) continue;
      const double distance = distance_to(cell(c), p);
      if (distance < nearest) {
        nearest = distance;
        best = c;
      }
    }
    if (nearest <= reach || reach > largest) return best;
  }
}

Vec2 HostGrid::i_direction(std::int64_t c) const {
  const Quad& q = cell(c);
  // Corner 1 is that beyond corner 0 along i; after turning a clockwise cell around it stands last.
  const Vec2 along = turned_[static_cast<std::size_t>(c)] != 0 ? (q[2] + q[3]) - (q[0] + q[1])
                                                               : (q[1] + q[2]) - (q[0] + q[3]);
  return (1.0 / norm(along)) * along;
}

Vec2 HostGrid::j_direction(std::int64_t c) const {
  const Quad& q = cell(c);
  const Vec2 along = turned_[static_cast<std::size_t>(c)] != 0 ? (q[1] + q[2]) - (q[0] + q[3])
                                                               : (q[2] + q[3]) - (q[0] + q[1]);
  return (1.0 / norm(along)) * along;
}

PipeWay pipe_way(const Assembly& a, const Network& n, std::size_t pipe) {
  const auto i = a.first[pipe], j = a.second[pipe];
  const double share = a.radius[i] / (a.radius[i] + a.radius[j]);
  const Vec2 contact{a.x[i] + share * (a.x[j] - a.x[i]), a.y[i] + share * (a.y[j] - a.y[i])};
  const auto end = [&](std::int32_t d) { return n.kind[d] == DomainKind::rock ? n.centroid[d] : contact; };
  return {end(n.left[pipe]), end(n.right[pipe])};
}

void HostGrid::lay_over(const Assembly& a, const Network& n) {
  pores_.clear();
  pipes_.clear();
  pore_cell_.assign(static_cast<std::size_t>(n.domain_count()), -1);
  std::vector<Vec2> polygon;
  for (std::int32_t d = 1; d < n.domain_count(); ++d) {
    polygon.clear();
    constexpr double far = std::numeric_limits<double>::max();
    Vec2 low{far, far}, high{-far, -far};
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const Vec2 p{a.x[n.corner_disc[k]], a.y[n.corner_disc[k]]};
      polygon.push_back(p);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    for (const auto c : cells_near(low, high)) {
      const double area = common_area(polygon, cell(c));
      if (area > 0.0) pores_.push_back({c, d, area});
    }
    pore_cell_[static_cast<std::size_t>(d)] = cell_at(n.centroid[d]);
  }
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if (n.left[e] == n.right[e]) continue;
    const PipeWay way = pipe_way(a, n, e);
    along(way.left, way.right, [&](std::int64_t c, double share) {
      pipes_.push_back({c, static_cast<std::int32_t>(e), share});
    });
  }
  std::stable_sort(pipes_.begin(), pipes_.end(),
                   [](const CellPart& p, const CellPart& q) { return p.cell < q.cell; });
  pipe_start_.assign(cells_.size() + 1, 0);
  for (const auto& part : pipes_) ++pipe_start_[static_cast<std::size_t>(part.cell) + 1];
  for (std::size_t c = 0; c < cells_.size(); ++c) pipe_start_[c + 1] += pipe_start_[c];

  std::vector<double> covered(cells_.size(), 0.0);
  for (const auto& part : pores_) covered[static_cast<std::size_t>(part.cell)] += part.amount;
  const auto free = [&](std::int64_t c) {
    return covered[static_cast<std::size_t>(c)] < 0.5 * area_of(cell(c));
  };
  bool any_free = false;
  for (std::int64_t c = 0; c < count() && !any_free; ++c) any_free = free(c);
  outer_cell_.clear();
  for (const auto e : n.outer_pipe) {
    const Vec2 from{a.x[a.first[e]], a.y[a.first[e]]}, to{a.x[a.second[e]], a.y[a.second[e]]};
    const Vec2 middle = 0.5 * (from + to);
    outer_cell_.push_back(any_free ? nearest_cell(middle, free) : nearest_cell(middle));
  }
  loop_cell_.clear();
  for (auto k = n.corner_start[0]; k < n.corner_start[1]; ++k)
    loop_cell_.push_back(nearest_cell({a.x[n.corner_disc[k]], a.y[n.corner_disc[k]]}));
}

}  // namespace hfrac
