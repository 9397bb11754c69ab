// SPDX-License-Identifier: BSD-3-Clause
#include "web/server/averages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hfrac::web {
namespace {

constexpr double kLeastWeight = 1e-30;  // [m2] a pore without area counts for nothing beside others

const GridArray* find(const Grid& grid, const char* of, const char* name) {
  const auto at = std::find_if(grid.arrays.begin(), grid.arrays.end(),
                               [&](const GridArray& array) { return array.of == of && array.name == name; });
  return at == grid.arrays.end() ? nullptr : &*at;
}

template <class Value>
const std::vector<Value>* numbers(const Grid& grid, const char* of, const char* name) {
  const GridArray* array = find(grid, of, name);
  return array == nullptr ? nullptr : std::get_if<std::vector<Value>>(&array->values);
}

struct Item {
  double x, y, area;  // [m, m, m2]
};

/** The discs of a grid of points, or the polygons of one of cells. */
class Items {
 public:
  explicit Items(const Grid& grid)
      : position_(numbers<float>(grid, "geometry", "position")),
        radius_(numbers<float>(grid, "points", "radius_m")),
        first_(numbers<int32_t>(grid, "geometry", "first")),
        corner_(numbers<int32_t>(grid, "geometry", "corner")) {
    if (position_ == nullptr) throw GridError("the snapshot has no places");
    of_cells = first_ != nullptr && corner_ != nullptr;
    count = of_cells ? grid.cells : grid.points;
    if (of_cells && static_cast<int64_t>(corner_->size()) <= 2 * count)
      throw GridError(fmt::format(
          "it has {} bonds or cracks, and the page draws {} at most; draw a part of them with hfrac render "
          "DIR --view bonds --zoom well, or open the run in ParaView",
          count, kMostDrawn));
  }

  Item operator[](int64_t i) const {
    const auto at = static_cast<size_t>(i);
    if (!of_cells) {
      const double r = radius_ == nullptr ? 1.0 : (*radius_)[at];
      return {(*position_)[2 * at], (*position_)[2 * at + 1], r * r};
    }
    const auto begin = static_cast<size_t>((*first_)[at]), end = static_cast<size_t>((*first_)[at + 1]);
    Item item{0, 0, 0};
    for (size_t k = begin, before = end - 1; k < end; before = k++) {
      const auto here = place((*corner_)[k]), there = place((*corner_)[before]);
      item.x += here.x / static_cast<double>(end - begin);
      item.y += here.y / static_cast<double>(end - begin);
      item.area += 0.5 * (there.x * here.y - here.x * there.y);
    }
    item.area = std::abs(item.area);
    return item;
  }

  bool of_cells = false;
  int64_t count = 0;

 private:
  Item place(int32_t corner) const {
    const auto at = 2 * static_cast<size_t>(corner);
    return {(*position_)[at], (*position_)[at + 1], 0};
  }
  const std::vector<float>*position_, *radius_;
  const std::vector<int32_t>*first_, *corner_;
};

/** The squares in which something lies, by rows from below, and what lies where. */
struct Raster {
  double left, below, side;         // [m]
  int64_t columns;                  // of squares, those without anything included
  std::vector<int64_t> square;      // of each that has something, its place among all
  std::vector<int32_t> number;      // by item: which of them it lies in
  std::vector<float> weight;        // by item [m2]
  std::vector<double> total, much;  // by square: sum of weights, and how many items
};

Raster lay_over(const Items& items, int64_t squares) {
  double left = INFINITY, right = -INFINITY, below = INFINITY, above = -INFINITY;
  for (int64_t i = 0; i < items.count; ++i) {
    const Item item = items[i];
    left = std::min(left, item.x);
    right = std::max(right, item.x);
    below = std::min(below, item.y);
    above = std::max(above, item.y);
  }
  Raster raster{};
  raster.left = left;
  raster.below = below;
  const double width = right - left, height = above - below;
  raster.side = std::max({std::sqrt(width * height / static_cast<double>(squares)),
                          std::max(width, height) / static_cast<double>(squares), 1e-12});
  raster.columns = 1 + static_cast<int64_t>(width / raster.side);
  const auto rows = 1 + static_cast<int64_t>(height / raster.side);
  std::vector<int32_t> number(static_cast<size_t>(raster.columns * rows), -1);
  const auto square_of = [&](const Item& item) {
    return static_cast<size_t>(static_cast<int64_t>((item.y - below) / raster.side) * raster.columns +
                               static_cast<int64_t>((item.x - left) / raster.side));
  };
  for (int64_t i = 0; i < items.count; ++i) number[square_of(items[i])] = 0;
  for (size_t s = 0; s < number.size(); ++s) {
    if (number[s] < 0) continue;
    number[s] = static_cast<int32_t>(raster.square.size());
    raster.square.push_back(static_cast<int64_t>(s));
  }
  raster.total.assign(raster.square.size(), 0.0);
  raster.much.assign(raster.square.size(), 0.0);
  for (int64_t i = 0; i < items.count; ++i) {
    const Item item = items[i];
    const auto k = number[square_of(item)];
    raster.number.push_back(k);
    raster.weight.push_back(static_cast<float>(item.area + kLeastWeight));
    raster.total[static_cast<size_t>(k)] += raster.weight.back();
    raster.much[static_cast<size_t>(k)] += 1.0;
  }
  return raster;
}

std::vector<float> means(const GridArray& array, const Raster& raster) {
  const auto parts = static_cast<size_t>(array.components);
  std::vector<double> sums(parts * raster.square.size(), 0.0);
  std::visit(
      [&](const auto& values) {
        for (size_t i = 0; i < raster.number.size(); ++i)
          for (size_t c = 0; c < parts; ++c)
            sums[parts * static_cast<size_t>(raster.number[i]) + c] +=
                static_cast<double>(raster.weight[i]) * static_cast<double>(values[parts * i + c]);
      },
      array.values);
  std::vector<float> result(sums.size());
  for (size_t k = 0; k < sums.size(); ++k) result[k] = static_cast<float>(sums[k] / raster.total[k / parts]);
  return result;
}

/** A disc in the middle of those of its square, as large as they are together. */
void add_discs(Grid& coarse, const Grid& grid, const Raster& raster) {
  GridArray position = *find(grid, "geometry", "position");
  position.values = means(position, raster);
  coarse.arrays.push_back(std::move(position));
  std::vector<float> radius;
  for (const double area : raster.total) radius.push_back(static_cast<float>(std::sqrt(area)));
  coarse.points = static_cast<int64_t>(radius.size());
  coarse.arrays.push_back({"radius_m", "points", "m", 1, {}, std::move(radius)});
}

void add_squares(Grid& coarse, const Raster& raster) {
  std::vector<float> position;
  std::vector<int32_t> first{0}, corner;
  for (const auto square : raster.square) {
    const int64_t row = square / raster.columns, column = square % raster.columns;
    const double x = raster.left + raster.side * static_cast<double>(column),
                 y = raster.below + raster.side * static_cast<double>(row);
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      corner.push_back(static_cast<int32_t>(corner.size()));
      position.push_back(static_cast<float>(x + i * raster.side));
      position.push_back(static_cast<float>(y + j * raster.side));
    }
    first.push_back(static_cast<int32_t>(corner.size()));
  }
  coarse.points = static_cast<int64_t>(corner.size());
  coarse.cells = static_cast<int64_t>(raster.square.size());
  coarse.arrays.push_back({"position", "geometry", "m", 2, {"x", "y"}, std::move(position)});
  coarse.arrays.push_back({"first", "geometry", "", 1, {}, std::move(first)});
  coarse.arrays.push_back({"corner", "geometry", "", 1, {}, std::move(corner)});
}

}  // namespace

std::shared_ptr<const Grid> averaged(std::shared_ptr<const Grid> grid, int64_t most) {
  if (std::max(grid->points, grid->cells) <= most) return grid;
  const Items items(*grid);
  if (items.count <= most) return grid;  // many corners of few pores
  const Raster raster = lay_over(items, std::max<int64_t>(1, most / 4));
  auto coarse = std::make_shared<Grid>();
  coarse->time = grid->time;
  const char* of = items.of_cells ? "cells" : "points";
  if (items.of_cells)
    add_squares(*coarse, raster);
  else
    add_discs(*coarse, *grid, raster);
  for (const auto& array : grid->arrays) {
    if (array.of == "run") coarse->arrays.push_back(array);
    if (array.of != of || array.name == "radius_m" || array.name.ends_with("_id")) continue;
    coarse->arrays.push_back(
        {array.name, of, array.unit, array.components, array.parts, means(array, raster)});
  }
  coarse->arrays.push_back(
      {"averaged", of, "", 1, {}, std::vector<float>(raster.much.begin(), raster.much.end())});
  return coarse;
}

}  // namespace hfrac::web
