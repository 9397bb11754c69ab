// SPDX-License-Identifier: BSD-3-Clause
// What the four kinds of VTU files share: a grid as plain vectors, and its text.
//
// The files are inline binary with zlib level 1 unless the case says otherwise: every ParaView can read that,
// and a higher level costs time but hardly less space. Coordinates and times are doubles; all other numbers are floats, whose seven digits
// are more than a picture shows. Exact values are in the CSV files and behind the C interface.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "run/array_coding.hpp"

namespace hfrac::run {

/** An array with its unit as ParaView shows it. Values are flat, components innermost. */
struct VtuArray {
  std::string name;
  std::string unit;                          ///< empty: a number without one
  std::vector<const char*> components = {};  ///< their names; empty for scalars
  std::variant<std::vector<float>, std::vector<double>, std::vector<int32_t>, std::vector<uint8_t>> values;
};

enum class CellType : uint8_t { vertex = 1, line = 3, polyline = 4, polygon = 7 };  // VTK's numbers

/** A grid in the plane. Cell i has the points connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1]. */
struct VtuGrid {
  std::vector<double> positions;  ///< [m] x0 y0 x1 y1 ...
  CellType cell_type = CellType::vertex;
  std::vector<int32_t> offsets;
  std::vector<int32_t> connectivity;
  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;
};

/** Offsets of `count` cells with `corners` points each. */
std::vector<int32_t> even_offsets(size_t count, int32_t corners);

VtuArray floats(std::string name, std::string unit, const std::vector<double>& values,
                std::vector<const char*> components = {});
VtuArray exact(std::string name, std::string unit, std::vector<double> values);
VtuArray whole(std::string name, std::vector<int32_t> values);

/** x0 y0 x1 y1 ... with a zero after each pair, since VTK knows vectors in space only. */
std::vector<double> in_space(const std::vector<double>& plane);

/** When a file was written and how the wells stood. */
struct Moment {
  double time = 0.0;                  ///< [s]
  int64_t step = -1;                  ///< -1 if unknown
  std::vector<double> well_pressure;  ///< [Pa] one per well, may be empty
};

/** The file's text, with the moment in its field data, coded on up to `workers` threads. */
std::string encode(const VtuGrid& grid, const Moment& moment, Compression compression, int workers = 1);

/** The text of a PVTU file: the list of `files`, pieces of one grid, beside it. `piece` is one of them, maybe an empty one, for the names
 * and kinds of its arrays. */
std::string encode_list(const VtuGrid& piece, const std::vector<std::string>& files, Compression compression);

/** Part `index` of `count` of a grid's cells, each as large as the others but for one cell. */
struct Part {
  int64_t index = 0, count = 1;
  bool whole() const { return count == 1; }
  struct Range {
    int32_t first, last;
  };
  Range of(size_t cells) const {
    const auto n = static_cast<int64_t>(cells);
    return {static_cast<int32_t>(n * index / count), static_cast<int32_t>(n * (index + 1) / count)};
  }
};

/** Leaves the points out that no cell uses; the others stay in their order. */
void keep_used_points(VtuGrid& grid);

}  // namespace hfrac::run
