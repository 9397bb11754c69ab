// SPDX-License-Identifier: BSD-3-Clause
// Coordinates become floats: seven digits of the model's extent, far below a pixel.
#include <cmath>
#include <limits>
#include <type_traits>

#include "run/grid_file.hpp"
#include "web/server/grid.hpp"

namespace hfrac::web {
namespace {

constexpr int64_t kMostItems = std::numeric_limits<int32_t>::max() / 4;

template <class Value>
std::vector<Value> cast(const std::vector<double>& values, size_t given = 1, size_t wanted = 1) {
  std::vector<Value> result;
  result.reserve(values.size() / given * wanted);
  for (size_t i = 0; i + given <= values.size(); i += given)
    for (size_t j = 0; j < wanted; ++j) {
      const double value = values[i + j];
      if constexpr (std::is_integral_v<Value>)
        result.push_back(std::abs(value) <= std::numeric_limits<Value>::max() ? static_cast<Value>(value)
                                                                              : -1);
      else
        result.push_back(static_cast<Value>(value));
    }
  return result;
}

/** Integers up to 32 bits stay exact, doubles stay doubles, all else is float. Vectors in space lose their third component,
 * which is always 0 in a plane model. */
void add_section(Grid& grid, const run::GridFile& file, const char* section, const char* of) {
  for (const auto& head : file.arrays(section)) {
    GridArray array{head.name, of, head.unit, 1, head.parts, {}};
    const bool flat = head.parts.size() == 3 && head.parts[2] == "z";
    const size_t wanted = flat ? 2 : head.components;
    array.components = static_cast<int32_t>(wanted);
    array.parts.resize(std::min(array.parts.size(), wanted));
    const auto values = file.values(section, head.name);
    if (head.type == "Float64")
      array.values = cast<double>(values, head.components, wanted);
    else if (head.type.find("Int") != std::string::npos && head.type != "Int64" && head.type != "UInt64" &&
             head.type != "UInt32")
      array.values = cast<int32_t>(values, head.components, wanted);
    else
      array.values = cast<float>(values, head.components, wanted);
    grid.arrays.push_back(std::move(array));
  }
}

}  // namespace

std::shared_ptr<const Grid> read_grid(const std::filesystem::path& path) {
  const run::GridFile file({path});
  auto grid = std::make_shared<Grid>();
  grid->points = static_cast<int64_t>(file.point_count());
  grid->cells = static_cast<int64_t>(file.cell_count());
  if (std::max(grid->points, grid->cells) > kMostItems)
    file.damaged("it has more points or cells than a page can show");
  grid->time = file.moment().time;
  if (grid->points > 0) {
    std::vector<float> positions;
    for (const auto& point : file.points())
      positions.insert(positions.end(), {static_cast<float>(point.x), static_cast<float>(point.y)});
    grid->arrays.push_back({"position", "geometry", "m", 2, {"x", "y"}, std::move(positions)});
  }
  if (grid->cells > 0 && !file.of_vertices()) {  // a grid of vertices is its points and needs no cells
    const auto cells = file.cells();
    grid->arrays.push_back(
        {"first", "geometry", "", 1, {}, std::vector<int32_t>(cells.first.begin(), cells.first.end())});
    grid->arrays.push_back(
        {"corner", "geometry", "", 1, {}, std::vector<int32_t>(cells.corners.begin(), cells.corners.end())});
  }
  add_section(*grid, file, "PointData", "points");
  add_section(*grid, file, "CellData", "cells");
  add_section(*grid, file, "FieldData", "run");
  return grid;
}

}  // namespace hfrac::web
