// SPDX-License-Identifier: BSD-3-Clause
// One VTU file in memory, or the pieces that a PVTU file lists as if they were one, checked for damage. Only arrays that are asked for are
// decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "run/array_coding.hpp"
#include "run/series.hpp"
#include "run/vtu_writer.hpp"
#include "run/xml_tree.hpp"

namespace hfrac::run {

struct Point {
  double x = 0;  ///< [m]
  double y = 0;  ///< [m]
};

/** What a file says of one of its arrays. */
struct ArrayHead {
  std::string name;
  std::string type;                ///< "Float32", ...
  std::string unit;                ///< empty: a number without one
  std::size_t components = 1;      ///< at most 64: more is damage
  std::vector<std::string> parts;  ///< names of the components, if they have any
};

class GridFile {
 public:
  // Reads the file. Throws ReadError, as all below do.
  explicit GridFile(const SeriesFile& file);

  std::size_t point_count() const { return point_count_; }
  std::size_t cell_count() const { return cell_count_; }
  // All points, finite.
  std::vector<Point> points() const;
  // As many values as there are points or cells.
  std::vector<double> point_array(const char* name) const;
  std::vector<double> cell_array(const char* name) const;
  bool has_cell_array(const char* name) const;
  /** Of the arrays of "PointData", "CellData" or "FieldData". */
  std::vector<ArrayHead> arrays(std::string_view section) const;
  /** All values of one of them; of a point or cell array, as many as there are points or cells. */
  std::vector<double> values(std::string_view section, const std::string& name) const;
  /** Whether every cell is a single point, as in files of discs. */
  bool of_vertices() const;
  Moment moment() const;

  // Corners of the cells, all in range: those of cell i are corners[first[i]] to corners[first[i + 1] - 1].
  struct Cells {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> corners;
    std::span<const std::uint32_t> of(std::size_t cell) const {
      return std::span<const std::uint32_t>(corners).subspan(first[cell], first[cell + 1] - first[cell]);
    }
  };
  Cells cells() const;

  /** Throws ReadError: the file is not as it should be. */
  [[noreturn]] void damaged(const std::string& what) const;

 private:
  struct Piece {
    const XmlElement* element;
    ArrayCoding coding;
    std::size_t points, cells;
  };
  // Takes the pieces of a file of its own, or of one that a list names.
  void take(std::unique_ptr<XmlElement> root);
  void take_listed(const XmlElement& list);
  const XmlElement* section_named(const Piece& piece, std::string_view section) const;
  const XmlElement* find_array(const Piece& piece, std::string_view section, std::string_view name) const;
  std::vector<double> decode(const XmlElement& array, const std::string& name,
                             const ArrayCoding& coding) const;
  // Of the piece's points or cells, `components` values each.
  void append_values(const Piece& piece, std::string_view section, const std::string& name,
                     std::size_t components, std::vector<double>& values) const;
  std::vector<double> scalars(std::string_view section, const std::string& name,
                              std::size_t components = 1) const;

  std::filesystem::path path_;
  double time_;
  std::vector<std::unique_ptr<XmlElement>> roots_;
  const XmlElement* grid_ = nullptr;  // of the first file
  std::vector<Piece> pieces_;
  std::size_t point_count_ = 0;
  std::size_t cell_count_ = 0;
};

}  // namespace hfrac::run
