// SPDX-License-Identifier: BSD-3-Clause
// One VTU file in memory, checked for damage. Only arrays that are asked for are decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "array_text.h"
#include "snapshot.h"
#include "xml_tree.h"

namespace hfrac::viz {

class GridFile {
 public:
  // Reads the file. Throws Failure(HFRAC_VIZ_ERR_READ), as all below do.
  explicit GridFile(const SeriesFile& file);

  std::size_t point_count() const { return point_count_; }
  std::size_t cell_count() const { return cell_count_; }
  // All points, finite.
  std::vector<Point> points() const;
  // As many values as there are points or cells, times components.
  std::vector<double> point_array(const char* name, std::size_t components = 1) const;
  std::vector<double> cell_array(const char* name) const;
  bool has_cell_array(const char* name) const { return find_array("CellData", name) != nullptr; }
  // One component of an array in "PointData" or "CellData"; nothing if there is no such array or component.
  std::optional<std::vector<double>> component(const char* section, const std::string& name,
                                               std::size_t index) const;
  std::vector<std::string> array_names(const char* section) const;
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

 private:
  [[noreturn]] void damaged(const std::string& what) const;
  const XmlElement* find_array(const char* section, const char* name) const;
  std::vector<double> decode(const XmlElement& array, const std::string& name) const;
  std::vector<double> scalars(const char* section, const char* name, std::size_t count) const;
  std::vector<double> field_values(const char* name) const;

  SeriesFile file_;
  std::unique_ptr<XmlElement> root_;
  const XmlElement* grid_ = nullptr;
  const XmlElement* piece_ = nullptr;
  ArrayCoding coding_;
  std::size_t point_count_ = 0;
  std::size_t cell_count_ = 0;
};

}  // namespace hfrac::viz
