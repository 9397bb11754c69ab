// SPDX-License-Identifier: BSD-3-Clause
// Permeability of a cell from flow through its pipes (rule `flow` of cell_report.hpp).
//
// Unknown are the pressures of the pores whose centroid lies in the cell. A pipe that leaves the cell is cut where it does, and
// has the pressure of the gradient there; so have walls of wells and the model's edge. More conductance anywhere then never
// gives less permeability (Rayleigh's principle), so that of the cracks is not negative.
#include <cmath>

#include "host/cell_report.hpp"
#include "linear/sparse.hpp"
#include "linear/symmetric_factor.hpp"

namespace hfrac {
namespace {

struct CellPipe {
  std::int32_t left, right;  // unknown at either end, -1: imposed
  Vec2 from, to;             // m, ends from the cell's middle
  double weight, conductance, length;
};

// Energy of flow for unit gradients along x and y: xx, yy, xy of sum c dp_i dp_j [m4/(Pa s)].
void flow_energy(const std::vector<CellPipe>& pipes, std::int32_t unknowns, double energy[3]) {
  energy[0] = energy[1] = energy[2] = 0.0;
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(unknowns, 2);
  if (unknowns > 0) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(unknowns, 2);
    double largest = 0.0;
    for (const auto& pipe : pipes) {
      const double c = pipe.conductance;
      largest = std::max(largest, c);
      const auto add = [&](std::int32_t here, std::int32_t there, Vec2 end) {
        if (here < 0) return;
        entries.emplace_back(here, here, c);
        if (there >= 0) {
          entries.emplace_back(here, there, -c);
        } else {
          rhs(here, 0) += c * end.x;
          rhs(here, 1) += c * end.y;
        }
      };
      add(pipe.left, pipe.right, pipe.to);
      add(pipe.right, pipe.left, pipe.from);
    }
    if (largest <= 0.0) return;
    // A pore that no open pipe reaches: something on the diagonal, far below the rest.
    for (std::int32_t k = 0; k < unknowns; ++k) entries.emplace_back(k, k, 1e-14 * largest);
    SparseMatrix matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const SymmetricFactor solver(matrix);
    if (!solver.succeeded()) return;
    p = solver.solve(rhs);
  }
  for (const auto& pipe : pipes) {
    const auto at = [&](std::int32_t unknown, Vec2 end) {
      return unknown >= 0 ? Vec2{p(unknown, 0), p(unknown, 1)} : end;
    };
    const Vec2 drop = at(pipe.left, pipe.from) - at(pipe.right, pipe.to);
    const double weight = pipe.weight * pipe.conductance;
    energy[0] += weight * drop.x * drop.x;
    energy[1] += weight * drop.y * drop.y;
    energy[2] += weight * drop.x * drop.y;
  }
}

}  // namespace

CellFlow flow_through_cell(const HostGrid& grid, std::int64_t cell, double covered_area, const Assembly& a,
                           const Network& n, double viscosity) {
  CellFlow result;
  if (covered_area <= 0.0) return result;
  const Vec2 middle = middle_of(grid.cell(cell));
  std::vector<CellPipe> pipes;
  std::vector<std::int32_t> pore;  // of each unknown, sorted
  const auto inside = [&](std::int32_t d) {
    return n.kind[d] == DomainKind::rock && grid.pore_cell()[static_cast<std::size_t>(d)] == cell;
  };
  for (const auto& part : grid.pipes_of(cell)) {
    for (const auto d : {n.left[part.item], n.right[part.item]}) {
      if (inside(d)) pore.push_back(d);
    }
  }
  std::sort(pore.begin(), pore.end());
  pore.erase(std::unique(pore.begin(), pore.end()), pore.end());
  const auto unknown_of = [&](std::int32_t d) {
    return inside(d) ? static_cast<std::int32_t>(std::lower_bound(pore.begin(), pore.end(), d) - pore.begin())
                     : -1;
  };
  double cube = 0.0, shares = 0.0;
  bool cracked = false;
  for (const auto& part : grid.pipes_of(cell)) {
    const auto e = static_cast<std::size_t>(part.item);
    const PipeWay way = pipe_way(a, n, e);
    CellPipe pipe{unknown_of(n.left[e]),
                  unknown_of(n.right[e]),
                  way.left - middle,
                  way.right - middle,
                  1.0,
                  n.conductance_of(e) * n.viscosity_share_of(e),
                  a.pipe_length(part.item)};
    if (pipe.left < 0 && pipe.right < 0) {
      pipe.weight = part.amount;  // passes through: its part in the cell under the gradient
    } else if (part.amount < 1.0) {
      const double share = std::max(part.amount, 1e-6);
      if (pipe.left >= 0 && pipe.right < 0) pipe.to = pipe.from + share * (pipe.to - pipe.from);
      if (pipe.right >= 0 && pipe.left < 0) pipe.from = pipe.to + share * (pipe.from - pipe.to);
      pipe.conductance /= share;
      pipe.length *= share;
    }
    pipes.push_back(pipe);
    if (!carries_fracture_fluid(a, n, e)) {
      cube += part.amount * n.conductance_of(e) * n.viscosity_share_of(e) * a.pipe_length(part.item);
      shares += part.amount;
    } else {
      cracked = true;
    }
  }
  const auto unknowns = static_cast<std::int32_t>(pore.size());
  double whole[3], rock[3];
  flow_energy(pipes, unknowns, whole);
  std::copy(whole, whole + 3, rock);
  if (cracked) {
    const double mean = shares > 0.0 ? cube / shares : 0.0;
    for (std::size_t k = 0; k < pipes.size(); ++k) {
      const auto e = static_cast<std::size_t>(grid.pipes_of(cell)[k].item);
      // A closed crack may be tighter than the rock around it: then it stays in both.
      if (carries_fracture_fluid(a, n, e))
        pipes[k].conductance = std::min(pipes[k].conductance, mean / pipes[k].length);
    }
    flow_energy(pipes, unknowns, rock);
  }
  const double scale = viscosity / covered_area;
  for (std::size_t k = 0; k < 3; ++k) result.fracture[k] = scale * (whole[k] - rock[k]);
  result.matrix = 0.5 * scale * (rock[0] + rock[1]);
  return result;
}

}  // namespace hfrac
