// SPDX-License-Identifier: BSD-3-Clause
// What the page shows of a snapshot too large to draw: nothing gets lost, what is the same everywhere stays so.
#include "web/server/averages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace hfrac::web;

template <class Value>
const std::vector<Value>& values(const Grid& grid, const char* name) {
  for (const auto& array : grid.arrays)
    if (array.name == name) return std::get<std::vector<Value>>(array.values);
  ADD_FAILURE() << "no array " << name;
  static const std::vector<Value> none;
  return none;
}

bool has(const Grid& grid, const char* name) {
  return std::any_of(grid.arrays.begin(), grid.arrays.end(),
                     [&](const auto& array) { return array.name == name; });
}

constexpr int side = 40;

/** Discs in rows and columns a metre apart, every other one larger; a value that rises along x, and one that is the same. */
std::shared_ptr<Grid> discs() {
  auto grid = std::make_shared<Grid>();
  std::vector<float> position, radius, along, same;
  std::vector<int32_t> bonds, id;
  for (int i = 0; i < side * side; ++i) {
    position.insert(position.end(), {static_cast<float>(i % side), static_cast<float>(i / side)});
    radius.push_back(i % 2 == 0 ? 0.4F : 0.5F);
    along.push_back(3.0F * static_cast<float>(i % side));
    same.push_back(7.0F);
    bonds.push_back(4);
    id.push_back(i);
  }
  grid->points = side * side;
  grid->time = 0.5;
  grid->arrays.push_back({"position", "geometry", "m", 2, {"x", "y"}, position});
  grid->arrays.push_back({"radius_m", "points", "m", 1, {}, radius});
  grid->arrays.push_back({"along", "points", "Pa", 1, {}, along});
  grid->arrays.push_back({"same", "points", "Pa", 1, {}, same});
  grid->arrays.push_back({"intact_bonds", "points", "", 1, {}, bonds});
  grid->arrays.push_back({"disc_id", "points", "", 1, {}, id});
  grid->arrays.push_back({"step", "run", "", 1, {}, std::vector<double>{3.0}});
  return grid;
}

TEST(Averages, LeaveWhatCanBeDrawnAlone) {
  const auto grid = discs();
  EXPECT_EQ(averaged(grid, side * side), grid);
}

TEST(Averages, OfDiscsKeepTheirAreaAndTheirMeans) {
  const auto grid = discs();
  const auto coarse = averaged(grid, 400);
  EXPECT_GT(coarse->points, 80);
  EXPECT_LE(coarse->points, 121);
  EXPECT_EQ(coarse->time, 0.5);
  const auto& radius = values<float>(*coarse, "radius_m");
  const auto& position = values<float>(*coarse, "position");
  const auto& along = values<float>(*coarse, "along");
  const auto& count = values<float>(*coarse, "averaged");
  double area = 0.0;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    area += static_cast<double>(radius[k]) * static_cast<double>(radius[k]);
    EXPECT_NEAR(along[k], 3.0 * position[2 * k], 1e-3);
    EXPECT_FLOAT_EQ(values<float>(*coarse, "same")[k], 7.0F);
    EXPECT_FLOAT_EQ(values<float>(*coarse, "intact_bonds")[k], 4.0F);
  }
  EXPECT_NEAR(area, side * side * 0.5 * (0.16 + 0.25), 1e-3);
  EXPECT_EQ(std::accumulate(count.begin(), count.end(), 0.0), side * side);
  EXPECT_FALSE(has(*coarse, "disc_id"));
  EXPECT_TRUE(has(*coarse, "step"));
  EXPECT_FALSE(values_of(*coarse, "points", 0).empty());
}

/** Squares of a metre, or with `corners` 2, lines. */
std::shared_ptr<Grid> cells(int corners) {
  auto grid = std::make_shared<Grid>();
  std::vector<float> position, pressure;
  std::vector<int32_t> first{0}, corner;
  for (int i = 0; i < side * side; ++i) {
    for (int k = 0; k < corners; ++k) {
      const auto x = i % side + (k == 1 || k == 2 ? 1 : 0), y = i / side + (k > 1 ? 1 : 0);
      corner.push_back(static_cast<int32_t>(corner.size()));
      position.insert(position.end(), {static_cast<float>(x), static_cast<float>(y)});
    }
    first.push_back(static_cast<int32_t>(corner.size()));
    pressure.push_back(static_cast<float>(i / side));
  }
  grid->points = static_cast<int64_t>(corner.size());
  grid->cells = side * side;
  grid->arrays.push_back({"position", "geometry", "m", 2, {"x", "y"}, position});
  grid->arrays.push_back({"first", "geometry", "", 1, {}, first});
  grid->arrays.push_back({"corner", "geometry", "", 1, {}, corner});
  grid->arrays.push_back({"pressure_Pa", "cells", "Pa", 1, {}, pressure});
  return grid;
}

TEST(Averages, OfPoresAreSquaresOfTheRaster) {
  const auto coarse = averaged(cells(4), 400);
  EXPECT_GT(coarse->cells, 80);
  EXPECT_LE(coarse->cells, 121);
  EXPECT_EQ(coarse->points, 4 * coarse->cells);
  const auto& position = values<float>(*coarse, "position");
  const auto& pressure = values<float>(*coarse, "pressure_Pa");
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    EXPECT_GE(pressure[k], position[8 * k + 1] - 0.51F);
    EXPECT_LE(pressure[k], position[8 * k + 5]);
  }
  const auto& count = values<float>(*coarse, "averaged");
  EXPECT_EQ(std::accumulate(count.begin(), count.end(), 0.0), side * side);
}

TEST(Averages, OfLinesAreRefusedInWords) {
  try {
    (void)averaged(cells(2), 400);
    FAIL();
  } catch (const GridError& error) {
    EXPECT_NE(std::string(error.what()).find("hfrac render"), std::string::npos) << error.what();
  }
}

}  // namespace
