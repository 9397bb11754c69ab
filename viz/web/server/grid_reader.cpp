// SPDX-License-Identifier: BSD-3-Clause
// Files are read with the renderer's parts, which check every size before they use it: VTK's own reader ends
// the process on some damaged files. What comes out is checked again before anything indexes with it.
// Coordinates become floats: seven digits of the model's extent, far below a pixel.
#include <fmt/format.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "array_text.h"
#include "failure.h"
#include "web/server/grid.hpp"
#include "xml_tree.h"

namespace hfrac::web {
namespace {

using viz::XmlElement;

constexpr int64_t kMostItems = std::numeric_limits<int32_t>::max() / 4;

vtkSmartPointer<vtkDataCompressor> compressor_named(const std::string& name) {
  if (name == "vtkZLibDataCompressor") return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return nullptr;
}

/** The elements of a VTU file, with the numbers of those that are asked for. */
class VtuFile {
 public:
  explicit VtuFile(std::filesystem::path path) : path_(std::move(path)), root_(viz::read_xml(path_)) {
    grid_ = root_->child("UnstructuredGrid");
    piece_ = grid_ != nullptr ? grid_->child("Piece") : nullptr;
    if (piece_ == nullptr) damaged("it holds no unstructured grid");
    if (root_->attribute("byte_order") == "BigEndian") damaged("its numbers are big-endian");
    const std::string compressor = root_->attribute("compressor");
    coding_.wide_headers = root_->attribute("header_type") == "UInt64";
    coding_.compressor = compressor_named(compressor);
    if (!compressor.empty() && coding_.compressor == nullptr) damaged("its compressor is unknown");
  }

  [[noreturn]] void damaged(const std::string& why) const {
    throw GridError(fmt::format("'{}' cannot be read: {}", path_.string(), why));
  }
  const XmlElement* piece(const char* section) const { return piece_->child(section); }
  const XmlElement* fields() const { return grid_->child("FieldData"); }

  int64_t count(const char* attribute) const {
    const long long number = std::strtoll(piece_->attribute(attribute).c_str(), nullptr, 10);
    if (number < 0 || number > kMostItems) damaged("it has more points or cells than a page can show");
    return number;
  }

  std::vector<double> values(const XmlElement& array) const {
    try {
      return viz::decode_array(array.text, array.attribute("type"), array.attribute("format"), coding_);
    } catch (const viz::ArrayDamage& damage) {
      damaged(fmt::format("array {}: {}", array.attribute("Name"), damage.what()));
    }
  }

  /** Of the array `name` of the piece's `section`. */
  std::vector<double> values_in(const char* section, const char* name) const {
    if (const XmlElement* arrays = piece(section); arrays != nullptr)
      for (const auto& array : arrays->children)
        if (array->name == "DataArray" && array->attribute("Name") == name) return values(*array);
    damaged(fmt::format("array {} is missing", name));
  }

 private:
  std::filesystem::path path_;
  std::unique_ptr<XmlElement> root_;
  const XmlElement* grid_ = nullptr;
  const XmlElement* piece_ = nullptr;
  viz::ArrayCoding coding_;
};

/** What InformationKey elements of an array say under this name. */
std::string information(const XmlElement& array, const std::string& name) {
  for (const auto& key : array.children) {
    if (key->name != "InformationKey" || key->attribute("name") != name) continue;
    const size_t begin = key->text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return {};
    return key->text.substr(begin, key->text.find_last_not_of(" \t\r\n") - begin + 1);
  }
  return {};
}

template <class Value>
std::vector<Value> cast(const std::vector<double>& values, size_t given, size_t wanted) {
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

/** Integers up to 32 bits stay exact, doubles stay doubles, all else is float. Vectors in space lose their
 * third component, which is always 0 in a plane model. */
GridArray converted(const VtuFile& file, const XmlElement& array, const char* of) {
  GridArray result;
  result.name = array.attribute("Name");
  result.of = of;
  result.unit = information(array, "UNITS_LABEL");
  const long given = std::max(1L, std::strtol(array.attribute("NumberOfComponents").c_str(), nullptr, 10));
  const bool flat = given == 3 && array.attribute("ComponentName2") == "z";
  result.components = static_cast<int32_t>(flat ? 2 : std::min(given, 64L));
  for (int i = 0; i < result.components && !array.attribute("ComponentName0").empty(); ++i)
    result.parts.push_back(array.attribute(fmt::format("ComponentName{}", i)));
  const auto values = file.values(array);
  const auto from = static_cast<size_t>(given);
  const auto to = static_cast<size_t>(result.components);
  const std::string type = array.attribute("type");
  if (type == "Float64")
    result.values = cast<double>(values, from, to);
  else if (type == "Int32" || type == "Int16" || type == "Int8" || type == "UInt16" || type == "UInt8")
    result.values = cast<int32_t>(values, from, to);
  else
    result.values = cast<float>(values, from, to);
  return result;
}

size_t length_of(const GridArray& array) {
  return std::visit([](const auto& values) { return values.size(); }, array.values);
}

void add_section(Grid& grid, const VtuFile& file, const XmlElement* section, const char* of, int64_t count) {
  if (section == nullptr) return;
  for (const auto& array : section->children) {
    if (array->name != "DataArray") continue;
    auto one = converted(file, *array, of);
    if (count >= 0 && length_of(one) != static_cast<size_t>(count) * static_cast<size_t>(one.components))
      file.damaged(fmt::format("array {} has the wrong length", one.name));
    grid.arrays.push_back(std::move(one));
  }
}

void add_positions(Grid& grid, const VtuFile& file) {
  const auto values = file.values_in("Points", "Points");
  if (values.size() != static_cast<size_t>(grid.points) * 3) file.damaged("its points have the wrong length");
  grid.arrays.push_back({"position", "geometry", "m", 2, {"x", "y"}, cast<float>(values, 3, 2)});
}

/** Lines and polygons; a grid of vertices is its points and needs no cells. */
void add_cells(Grid& grid, const VtuFile& file) {
  constexpr double kVertex = 1.0;
  const auto types = file.values_in("Cells", "types");
  if (types.empty() || types.front() == kVertex) return;
  const auto corners = file.values_in("Cells", "connectivity");
  const auto ends = file.values_in("Cells", "offsets");
  if (ends.size() != static_cast<size_t>(grid.cells)) file.damaged("its cells have the wrong length");
  double before = 0.0;
  std::vector<double> first{0.0};
  for (const double end : ends) {
    if (!(end >= before) || end > static_cast<double>(corners.size()))
      file.damaged("its cells are out of order");
    first.push_back(before = end);
  }
  for (const double corner : corners)
    if (!(corner >= 0.0) || corner >= static_cast<double>(grid.points))
      file.damaged("a cell names a point that is not there");
  grid.arrays.push_back({"first", "geometry", "", 1, {}, cast<int32_t>(first, 1, 1)});
  grid.arrays.push_back({"corner", "geometry", "", 1, {}, cast<int32_t>(corners, 1, 1)});
}

std::shared_ptr<const Grid> decoded(const std::filesystem::path& path) {
  const VtuFile file(path);
  auto grid = std::make_shared<Grid>();
  grid->points = file.count("NumberOfPoints");
  grid->cells = file.count("NumberOfCells");
  if (grid->points > 0) add_positions(*grid, file);
  if (grid->cells > 0) add_cells(*grid, file);
  add_section(*grid, file, file.piece("PointData"), "points", grid->points);
  add_section(*grid, file, file.piece("CellData"), "cells", grid->cells);
  add_section(*grid, file, file.fields(), "run", -1);
  for (const auto& array : grid->arrays)
    if (array.of == "run" && array.name == "TimeValue")
      if (const auto* time = std::get_if<std::vector<double>>(&array.values);
          time != nullptr && !time->empty())
        grid->time = time->front();
  return grid;
}

}  // namespace

std::shared_ptr<const Grid> read_grid(const std::filesystem::path& file) {
  try {
    return decoded(file);
  } catch (const viz::Failure& failure) {
    throw GridError(failure.what());
  }
}

}  // namespace hfrac::web
