// SPDX-License-Identifier: BSD-3-Clause
// V20  Permeability of a host's cell against a flow solve on the network, and against parallel plates.
//
// Formula    one crack through a block of height H at an angle t to the flow: k = w^3 cos(t) / (12 H) (cubic law).
// Source     Oda, Geotechnique 35 (1985) 483; Durlofsky, Water Resour. Res. 27 (1991) 699; Witherspoon et al., Water Resour.
//            Res. 16 (1980) 1016 (cubic law).
// Set-up     100 m x 100 m, 4 000 discs, rigid; the block is one cell of 70 m in the middle, rock of 5.6 mD. Cracks are chains
//            of pipes of 0.5 mm from pore to pore along given lines. Reference: the engine's own flow solver, pressure on two
//            opposite sides of the block, the other two closed; permeability from the flow that passes.
// Tolerance  flow over reference 3 %. Oda is an upper bound and is held to be one: 1 to 1.3 where a single crack passes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "flow/flow_solver.hpp"
#include "host/cell_report.hpp"
#include "rigid_network.hpp"
#include "support.hpp"

namespace V20_upscaling {

using namespace verification;

constexpr double rock_permeability = 5.527e-15, crack_aperture = 5e-4;
constexpr double low = 15.0, high = 85.0, side = high - low;

// A rigid block with cracks drawn into it.
class CrackedBlock {
 public:
  explicit CrackedBlock(std::int64_t seed)
      : rock_(4000, seed), grid_(HostGrid::regular(1, 1, {low, low}, {side, side}, 0.0)) {
    rock_.calibrate(rock_permeability);
    grid_.lay_over(rock_.assembly(), rock_.network());
    matrix_factor_ =
        rock_permeability / uniform_gradient_permeability(rock_.assembly(), rock_.network(), viscosity());
  }

  // Breaks the pipes of the shortest way between the pores nearest to two points, off the line between them at a price.
  void crack(Vec2 from, Vec2 to) {
    const Network& n = rock_.network();
    const auto nearest = [&](Vec2 p) {
      std::int32_t best = 1;
      double distance = 1e300;
      for (std::int32_t d = 1; d < n.domain_count(); ++d) {
        const Vec2 off = n.centroid[d] - p;
        if (dot(off, off) < distance) {
          distance = dot(off, off);
          best = d;
        }
      }
      return best;
    };
    const Vec2 line = to - from;
    const double length = std::sqrt(dot(line, line));
    std::vector<std::vector<std::pair<std::int32_t, std::size_t>>> next(
        static_cast<std::size_t>(n.domain_count()));
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      if (n.left[e] == 0 || n.right[e] == 0 || n.left[e] == n.right[e]) continue;
      next[n.left[e]].emplace_back(n.right[e], e);
      next[n.right[e]].emplace_back(n.left[e], e);
    }
    const std::int32_t start = nearest(from), end = nearest(to);
    std::map<std::int32_t, std::pair<std::int32_t, std::size_t>> came;
    std::map<std::int32_t, double> way;
    using Item = std::pair<double, std::int32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    open.emplace(0.0, start);
    way[start] = 0.0;
    while (!open.empty()) {
      const auto [distance, d] = open.top();
      open.pop();
      if (d == end) break;
      if (distance > way[d]) continue;
      for (const auto& [other, pipe] : next[d]) {
        const Vec2 step = n.centroid[other] - n.centroid[d];
        const double off = std::abs(cross(line, n.centroid[other] - from)) / length;
        const double there = distance + std::sqrt(dot(step, step)) * (1.0 + off * off);
        if (way.count(other) == 0 || there < way[other]) {
          way[other] = there;
          came[other] = {d, pipe};
          open.emplace(there, other);
        }
      }
    }
    for (std::int32_t d = end; d != start; d = came[d].first) {
      const std::size_t e = came[d].second;
      rock_.assembly().intact[e] = 0;
      rock_.network().aperture[e] = crack_aperture;
      rock_.network().conductance[e] =
          std::pow(crack_aperture, 3) /
          (12.0 * viscosity() * rock_.assembly().pipe_length(static_cast<std::int64_t>(e)));
    }
  }

  CellReport cell(Upscaling rule) {
    return report_cells(grid_, rock_.assembly(), rock_.network(), rock_.options(), rule, matrix_factor_)[0];
  }

  // Permeability of the block along x (axis 0) or y (axis 1) by the engine's flow solver.
  double solved(int axis) {
    Network n = rock_.network();
    const auto along = [&](std::int32_t d) { return axis == 0 ? n.centroid[d].x : n.centroid[d].y; };
    const auto across = [&](std::int32_t d) { return axis == 0 ? n.centroid[d].y : n.centroid[d].x; };
    for (std::int32_t d = 1; d < n.domain_count(); ++d) {
      n.content[d] = 0.0;
      n.stiffness[d] =
          along(d) > low && along(d) < high ? rock_.options().fluid_bulk_modulus / n.volume[d] : 0.0;
      n.pressure[d] = along(d) <= low ? 1e5 : 0.0;
    }
    const auto beside = [&](std::int32_t d) { return across(d) < low || across(d) > high; };
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      if (n.left[e] == 0 || n.right[e] == 0 || beside(n.left[e]) || beside(n.right[e]))
        n.conductance[e] = 0.0;
    }
    FlowSolver flow(n, rock_.options());
    for (int step = 0; step < 2; ++step) flow.advance(n, 1e12, {});
    // The distance the drop is spread over: between where the flow enters and leaves, weighted by it.
    double through = 0.0, entry = 0.0, entry_weight = 0.0, exit = 0.0, exit_weight = 0.0;
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      const auto l = n.left[e], r = n.right[e];
      if (l == 0 || r == 0 || (n.stiffness[l] > 0.0) == (n.stiffness[r] > 0.0)) continue;
      const auto fixed = n.stiffness[l] > 0.0 ? r : l;
      const double q = std::abs(n.flow[e]);
      if (along(fixed) <= low) {
        through += fixed == l ? n.flow[e] : -n.flow[e];
        entry += q * along(fixed);
        entry_weight += q;
      } else {
        exit += q * along(fixed);
        exit_weight += q;
      }
    }
    return through * viscosity() * (exit / exit_weight - entry / entry_weight) / (1e5 * side);
  }

  [[nodiscard]] double viscosity() const { return rock_.options().fluid_viscosity; }

 private:
  RigidNetwork rock_;
  HostGrid grid_;
  double matrix_factor_ = 1.0;
};

// One line of the table; gives flow and Oda over reference.
std::pair<double, double> compare(const char* what, CrackedBlock& block, int axis, double plates) {
  const double reference = block.solved(axis);
  const CellReport oda = block.cell(Upscaling::oda), flow = block.cell(Upscaling::flow);
  const double by_oda = oda.permeability[axis] + oda.matrix_permeability,
               by_flow = flow.permeability[axis] + flow.matrix_permeability;
  std::printf("  %-34s k%s  solve %10.3e m2  flow/solve %6.3f  Oda/solve %8.3f  solve/plates %6.3f\n", what,
              axis == 0 ? "xx" : "yy", reference, by_flow / reference, by_oda / reference,
              plates > 0.0 ? (reference - rock_permeability) / plates : 0.0);
  Curves curves("V20", "Permeability of a cell over that of a flow solve, case by case",
                "case,over the flow solve");
  static double number = 0.0;
  number += 1.0;
  curves.point("rule flow", {number, by_flow / reference});
  curves.point("Oda", {number, by_oda / reference});
  curves.point("exact", {number, 1.0});
  return {by_flow / reference, by_oda / reference};
}

const double cubic = std::pow(crack_aperture, 3) / 12.0;

TEST(V20UpscalingSmoke, RockAlone) {
  CrackedBlock block(1);
  for (const int axis : {0, 1}) {
    const auto [flow, oda] = compare("rock alone", block, axis, 0.0);
    report("rule flow over the flow solve", flow, 1.0, 0.03);
    report("Oda over the flow solve", oda, 1.0, 0.05);
  }
}

TEST(V20Upscaling, StraightCrack) {
  CrackedBlock block(1);
  block.crack({2.0, 50.0}, {98.0, 50.0});
  const auto [flow, oda] = compare("straight, through", block, 0, cubic / side);
  report("rule flow over the flow solve", flow, 1.0, 0.03);
  EXPECT_GT(oda, 1.0);
  EXPECT_LT(oda, 1.3);
  const auto [flow_y, oda_y] = compare("straight, through", block, 1, 0.0);
  report("rule flow over the flow solve", flow_y, 1.0, 0.03);
  EXPECT_GT(oda_y, 1.0);
}

TEST(V20Upscaling, ObliqueCrack) {
  CrackedBlock block(1);
  block.crack({2.0, 50.0 - 48.0 * std::tan(pi / 6.0)}, {98.0, 50.0 + 48.0 * std::tan(pi / 6.0)});
  const auto [flow, oda] = compare("30 degrees, through", block, 0, cubic * std::cos(pi / 6.0) / side);
  report("rule flow over the flow solve", flow, 1.0, 0.03);
  EXPECT_GT(oda, 1.0);
  EXPECT_LT(oda, 1.3);
  // The direction in which the tensor is largest is the crack's.
  const CellReport cell = block.cell(Upscaling::flow);
  const double azimuth =
      0.5 * std::atan2(2.0 * cell.permeability[2], cell.permeability[0] - cell.permeability[1]);
  report_absolute("main direction of the tensor, degrees", azimuth * 180.0 / pi, 30.0, 3.0);
}

TEST(V20Upscaling, CrossingCracks) {
  CrackedBlock block(1);
  block.crack({2.0, 50.0}, {98.0, 50.0});
  block.crack({50.0, 2.0}, {50.0, 98.0});
  for (const int axis : {0, 1}) {
    const auto [flow, oda] = compare("crossing, through", block, axis, cubic / side);
    report("rule flow over the flow solve", flow, 1.0, 0.03);
    EXPECT_GE(oda, flow);
  }
}

TEST(V20Upscaling, BlindCrack) {
  CrackedBlock block(1);
  block.crack({35.0, 50.0}, {65.0, 50.0});
  const auto [flow, oda] = compare("straight, 30 m, blind", block, 0, 0.0);
  report("rule flow over the flow solve", flow, 1.0, 0.03);
  EXPECT_GT(oda, 3.0) << "Oda takes a blind crack as connected; if that no longer shows, say so in V20.md";
}

}  // namespace V20_upscaling
