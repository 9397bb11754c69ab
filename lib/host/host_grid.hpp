// SPDX-License-Identifier: BSD-3-Clause
// A reservoir simulator's areal grid, laid over the model.
//
// Cells are convex quadrilaterals, cell (i, j) has the index i + nx j (Eclipse's order: i fastest). The grid may be larger
// or smaller than the model, turned against it, and need not follow its edges. Cells should not overlap; nothing here
// depends on it, but whatever lies in two cells is then counted twice.
//
// When the grid is set, the pores, pipes and the model's outer boundary are shared out among the cells once and for all, at
// their places of bonding: a crack opens by centimetres, a cell is metres.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host/quad.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"

namespace hfrac {

// `amount` of item `item` that lies in cell `cell`.
struct CellPart {
  std::int64_t cell;
  std::int32_t item;
  double amount;
};

class HostGrid {
 public:
  // The two ways to say where the cells are. Both throw Error(argument) for what is no grid.
  static HostGrid regular(std::int64_t nx, std::int64_t ny, Vec2 origin, Vec2 size, double angle);
  // `corners`: nx ny times x, y of the four corners in order around the cell, either way round.
  static HostGrid from_corners(std::int64_t nx, std::int64_t ny, const double* corners);

  // Shares the model out among the cells.
  void lay_over(const Assembly& assembly, const Network& network);

  [[nodiscard]] std::int64_t nx() const { return nx_; }
  [[nodiscard]] std::int64_t ny() const { return ny_; }
  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(cells_.size()); }
  [[nodiscard]] const Quad& cell(std::int64_t c) const { return cells_[static_cast<std::size_t>(c)]; }
  // Unit vectors in which i and j grow, between the middles of opposite sides.
  [[nodiscard]] Vec2 i_direction(std::int64_t c) const;
  [[nodiscard]] Vec2 j_direction(std::int64_t c) const;
  // The cell that holds a point, -1 if none does; the nearest one.
  [[nodiscard]] std::int64_t cell_at(Vec2 p) const;
  [[nodiscard]] std::int64_t nearest_cell(Vec2 p) const {
    return nearest_cell(p, [](std::int64_t) { return true; });
  }
  // fn(cell, share) for every cell that holds a share of the line.
  template <class Function>
  void along(Vec2 a, Vec2 b, Function&& fn) const {
    for (const auto c :
         cells_near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)})) {
      const double share = share_inside(a, b, cell(c));
      if (share > 0.0) fn(c, share);
    }
  }

  // Pores by pore: area of the pore's polygon (discs' share included) in the cell [m2].
  [[nodiscard]] const std::vector<CellPart>& pores() const { return pores_; }
  // Pipes by cell: share of the pipe's way in the cell.
  [[nodiscard]] const std::vector<CellPart>& pipes() const { return pipes_; }
  [[nodiscard]] std::span<const CellPart> pipes_of(std::int64_t c) const {
    return std::span(pipes_).subspan(
        pipe_start_[static_cast<std::size_t>(c)],
        pipe_start_[static_cast<std::size_t>(c) + 1] - pipe_start_[static_cast<std::size_t>(c)]);
  }
  // Cell of every pore's centroid, -1 outside the grid.
  [[nodiscard]] const std::vector<std::int64_t>& pore_cell() const { return pore_cell_; }
  // Cell beyond every pipe of the outer boundary (Network::outer_pipe): the nearest of those that the model covers less than half, or of all
  // if it covers more of every one.
  [[nodiscard]] const std::vector<std::int64_t>& outer_cell() const { return outer_cell_; }
  // Cell of every disc of the model's outermost loop, in its order (corners of domain 0): the one that holds it, or the
  // nearest.
  [[nodiscard]] const std::vector<std::int64_t>& loop_cell() const { return loop_cell_; }

 private:
  HostGrid(std::int64_t nx, std::int64_t ny, std::vector<Quad> cells);
  // The nearest cell that `fits`, -1 if none does; the one of lowest index if several are.
  [[nodiscard]] std::int64_t nearest_cell(Vec2 p, const std::function<bool(std::int64_t)>& fits) const;
  // Every cell whose bins touch the box, each once, in order.
  [[nodiscard]] std::vector<std::int64_t> cells_near(Vec2 low, Vec2 high) const;

  std::int64_t nx_, ny_;
  std::vector<Quad> cells_;
  std::vector<char> turned_;  // per cell: corners were given clockwise
  // cells by the bins of a raster that their bounding boxes touch
  Vec2 low_, bin_;
  std::int64_t bins_x_ = 1, bins_y_ = 1;
  std::vector<std::size_t> bin_start_;
  std::vector<std::int64_t> bin_cell_;
  std::vector<CellPart> pores_, pipes_;
  std::vector<std::size_t> pipe_start_;
  std::vector<std::int64_t> pore_cell_, outer_cell_, loop_cell_;
};

// Where a pipe runs: from pore to pore; at a well or the outside the way ends at the contact.
struct PipeWay {
  Vec2 left, right;
};
PipeWay pipe_way(const Assembly& assembly, const Network& network, std::size_t pipe);

}  // namespace hfrac
