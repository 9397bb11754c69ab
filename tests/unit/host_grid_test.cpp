// SPDX-License-Identifier: BSD-3-Clause
// Cells of a host's grid: what lies in them, which one holds a point, how the model is shared out among them.
#include "host/host_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "model.hpp"

namespace host_grid_test {

using namespace testing_unit;

constexpr Quad unit_square{Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}};

TEST(Quad, CommonArea) {
  const std::vector<Vec2> half = {{-1, 0.25}, {0.5, 0.25}, {0.5, 0.75}, {-1, 0.75}};
  EXPECT_DOUBLE_EQ(common_area(half, unit_square), 0.25);
  const std::vector<Vec2> around = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}};
  EXPECT_DOUBLE_EQ(common_area(around, unit_square), 1.0);
  const std::vector<Vec2> away = {{2, 0}, {3, 0}, {3, 1}};
  EXPECT_EQ(common_area(away, unit_square), 0.0);
  // Not convex: two prongs reach in, the gap between them stays out.
  const std::vector<Vec2> fork = {{-1, 0},      {1, 0},    {1, 0.25}, {-0.5, 0.25},
                                  {-0.5, 0.75}, {1, 0.75}, {1, 1},    {-1, 1}};
  EXPECT_DOUBLE_EQ(common_area(fork, unit_square), 0.5);
}

TEST(Quad, ShareOfALine) {
  EXPECT_DOUBLE_EQ(share_inside({-1, 0.5}, {3, 0.5}, unit_square), 0.25);
  EXPECT_DOUBLE_EQ(share_inside({0.2, 0.2}, {0.4, 0.9}, unit_square), 1.0);
  EXPECT_EQ(share_inside({-1, 2}, {3, 2}, unit_square), 0.0);
  EXPECT_EQ(share_inside({-1, 0.5}, {0.5, 2.5}, unit_square), 0.0) << "past the corner";
  EXPECT_DOUBLE_EQ(distance_to(unit_square, {4, 5}), 5.0);
  EXPECT_DOUBLE_EQ(distance_to(unit_square, {0.5, -2}), 2.0);
}

TEST(HostGrid, FindsCells) {
  const double angle = 0.3;
  const HostGrid grid = HostGrid::regular(40, 30, {10, 20}, {2.0, 3.0}, angle);
  for (std::int64_t j = 0; j < 30; ++j) {
    for (std::int64_t i = 0; i < 40; ++i) {
      const double a = 2.0 * (static_cast<double>(i) + 0.3), b = 3.0 * (static_cast<double>(j) + 0.8);
      const Vec2 p{10 + a * std::cos(angle) - b * std::sin(angle),
                   20 + a * std::sin(angle) + b * std::cos(angle)};
      ASSERT_EQ(grid.cell_at(p), i + 40 * j);
    }
  }
  EXPECT_EQ(grid.cell_at({9.0, 10.0}), -1);
  EXPECT_EQ(grid.nearest_cell({9.0, 10.0}), 0);
  EXPECT_NEAR(grid.i_direction(7).x, std::cos(angle), 1e-12);
  EXPECT_NEAR(grid.j_direction(7).x, -std::sin(angle), 1e-12);
  // The same directions when the corners go the other way round.
  const double clockwise[] = {0, 0, 0, 1, 2, 1, 2, 0};  // i along y
  const HostGrid one = HostGrid::from_corners(1, 1, clockwise);
  EXPECT_NEAR(one.i_direction(0).y, 1.0, 1e-12);
  EXPECT_NEAR(one.j_direction(0).x, 1.0, 1e-12);
  EXPECT_THROW(HostGrid::from_corners(1, 1, std::vector<double>{0, 0, 1, 1, 1, 0, 0, 1}.data()), Error);
}

TEST(HostGrid, DividesTheModelWithoutLoss) {
  const Options o = dry_options(400);
  const TestModel model(o, packed(o));
  const HostGrid base = HostGrid::regular(1, 1, {-100, -100}, {400, 400}, 0.0);
  for (HostGrid grid : {base, HostGrid::regular(13, 9, {-60, -50}, {20, 25}, 0.4)}) {
    grid.lay_over(model.assembly, model.network);
    std::vector<double> area(static_cast<std::size_t>(model.network.domain_count()), 0.0),
        share(model.network.left.size(), 0.0);
    for (const auto& part : grid.pores()) area[part.item] += part.amount;
    for (const auto& part : grid.pipes()) share[part.item] += part.amount;
    for (std::size_t d = 1; d < area.size(); ++d)
      ASSERT_NEAR(area[d], model.faces.polygon_area[d], 1e-9 * model.faces.polygon_area[d]) << d;
    for (std::size_t e = 0; e < share.size(); ++e) {
      if (model.network.left[e] == model.network.right[e]) continue;
      ASSERT_NEAR(share[e], 1.0, 1e-9) << e;
    }
    std::size_t sum = 0;
    for (std::int64_t c = 0; c < grid.count(); ++c) sum += grid.pipes_of(c).size();
    EXPECT_EQ(sum, grid.pipes().size());
    EXPECT_EQ(grid.outer_cell().size(), model.network.outer_pipe.size());
  }
}

}  // namespace host_grid_test
