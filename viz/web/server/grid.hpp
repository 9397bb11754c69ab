// SPDX-License-Identifier: BSD-3-Clause
// One VTU file, decoded, and the two forms in which the page gets it: a message of whole arrays, and the
// values of a single disc, bond, crack or domain.
//
// A message is made to be used where it lies, without parsing:
//
//     bytes 0-3    "HFG1"
//     bytes 4-7    length N of the head, unsigned, little-endian
//     N bytes      the head: JSON text, padded with blanks so that 8 + N is a multiple of 8
//     the rest     the arrays one after the other, little-endian, each beginning at a multiple of 8
//
// The head says {"points": n, "cells": m, "time_s": t, "arrays": [{"name", "of": "geometry" | "points" |
// "cells" | "run", "type": "f32" | "i32" | "f64", "components", "parts", "unit", "offset", "length"}]}, offset in bytes
// from the end of the head, length in numbers. Geometry is "position" (x, y in metres) and, for cells,
// "first" (m + 1 numbers) and "corner": cell i has the points corner[first[i]] to corner[first[i + 1] - 1]. Arrays
// that were not asked for stand under "others", without offset.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "run/files.hpp"

namespace hfrac::web {

/** A file is not there, or is no grid that can be shown; the text says which and why. */
using GridError = run::ReadError;

struct GridArray {
  std::string name;
  std::string of;    ///< "geometry", "points", "cells" or "run" (values of the moment, not of a place)
  std::string unit;  ///< empty: a number without one
  int32_t components = 1;
  std::vector<std::string> parts;  ///< names of the components, if they have any
  std::variant<std::vector<float>, std::vector<int32_t>, std::vector<double>> values;
};

struct Grid {
  int64_t points = 0;
  int64_t cells = 0;
  double time = 0.0;  ///< [s]
  std::vector<GridArray> arrays;

  /** Memory that the arrays take [byte]. */
  size_t bytes() const;
};

/** Reads a VTU file of any encoding VTK knows. Throws GridError. */
std::shared_ptr<const Grid> read_grid(const std::filesystem::path& file);

/** The message with all arrays, or with the geometry, the values of the moment, and the arrays in `chosen`. */
std::string grid_message(const Grid& grid, const std::vector<std::string>& chosen = {});

/** Name, unit and values of each array for one point or cell. Throws GridError if there is none such. */
nlohmann::ordered_json values_of(const Grid& grid, const std::string& of, int64_t index);

}  // namespace hfrac::web
