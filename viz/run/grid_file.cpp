// SPDX-License-Identifier: BSD-3-Clause
#include "run/grid_file.hpp"

#include <algorithm>
#include <cmath>

#include "run/files.hpp"
#include "run/text.hpp"

namespace hfrac::run {
namespace {

// 0 if it is no sensible number
std::size_t count_attribute(const XmlElement& element, const char* name) {
  const std::size_t count = number_in<std::size_t>(element.attribute(name)).value_or(0);
  return count < 4'000'000'000U ? count : 0;
}

/** What an array's InformationKey elements say under this name. */
std::string information(const XmlElement& array, std::string_view name) {
  for (const auto& key : array.children) {
    if (key->name != "InformationKey" || key->attribute("name") != name) continue;
    const size_t begin = key->text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return {};
    return key->text.substr(begin, key->text.find_last_not_of(" \t\r\n") - begin + 1);
  }
  return {};
}

/** Beside the list, and nowhere else. */
bool is_plain_name(const std::string& file) {
  return !file.empty() && file != "." && file != ".." && file.find_first_of("/\\") == std::string::npos;
}

}  // namespace

GridFile::GridFile(const SeriesFile& file) : path_(file.path), time_(file.time) {
  auto root = parse_xml(file.content != nullptr ? *file.content : read_whole(file.path), file.path);
  if (const XmlElement* list = root->child("PUnstructuredGrid")) {
    take_listed(*list);
  } else {
    take(std::move(root));
  }
  grid_ = roots_.front()->child("UnstructuredGrid");
  for (const Piece& piece : pieces_) {
    point_count_ += piece.points;
    cell_count_ += piece.cells;
  }
}

void GridFile::take_listed(const XmlElement& list) {
  for (const auto& entry : list.children) {
    if (entry->name != "Piece") continue;
    const std::string file = entry->attribute("Source");
    if (!is_plain_name(file)) damaged("it lists a piece '" + file + "' that is no file beside it");
    const auto path = path_.parent_path() / file;
    take(parse_xml(read_whole(path), path));
  }
  if (roots_.empty()) damaged("it lists no Piece");
}

void GridFile::take(std::unique_ptr<XmlElement> root) {
  const XmlElement* grid = root->child("UnstructuredGrid");
  if (grid == nullptr) damaged("it holds no UnstructuredGrid");
  if (root->attribute("byte_order") == "BigEndian")
    damaged("its numbers are big-endian, which is not supported");
  ArrayCoding coding;
  coding.wide_headers = root->attribute("header_type") == "UInt64";
  const std::string compressor = root->attribute("compressor");
  const auto compression = compression_named(compressor);
  if (!compression) damaged("its compressor " + compressor + " is unknown");
  coding.compression = *compression;
  const std::size_t before = pieces_.size();
  for (const auto& element : grid->children) {
    if (element->name == "Piece")
      pieces_.push_back({element.get(), coding, count_attribute(*element, "NumberOfPoints"),
                         count_attribute(*element, "NumberOfCells")});
  }
  if (pieces_.size() == before) damaged("it holds no Piece");
  roots_.push_back(std::move(root));
}

void GridFile::damaged(const std::string& what) const {
  fail_reading(path_.string() + " cannot be read: " + what);
}

const XmlElement* GridFile::section_named(const Piece& piece, std::string_view section) const {
  return section == "FieldData" ? grid_->child(section) : piece.element->child(section);
}

const XmlElement* GridFile::find_array(const Piece& piece, std::string_view section,
                                       std::string_view name) const {
  const XmlElement* arrays = section_named(piece, section);
  if (arrays == nullptr) return nullptr;
  for (const auto& array : arrays->children) {
    if (array->name == "DataArray" && array->attribute("Name") == name) return array.get();
  }
  return nullptr;
}

bool GridFile::has_cell_array(const char* name) const {
  return find_array(pieces_.front(), "CellData", name) != nullptr;
}

std::vector<double> GridFile::decode(const XmlElement& array, const std::string& name,
                                     const ArrayCoding& coding) const {
  try {
    return decode_array(array.text, array.attribute("type"), array.attribute("format"), coding);
  } catch (const ArrayDamage& damage) {
    this->damaged("array " + name + ": " + damage.what());
  }
}

void GridFile::append_values(const Piece& piece, std::string_view section, const std::string& name,
                             std::size_t components, std::vector<double>& values) const {
  const std::size_t count = (section == "PointData" ? piece.points : piece.cells) * components;
  if (count == 0) return;
  const XmlElement* array = find_array(piece, section, name);
  if (array == nullptr) damaged("array " + name + " is missing");
  std::vector<double> more = decode(*array, name, piece.coding);
  if (more.size() != count) damaged("array " + name + " has the wrong length");
  if (values.empty())
    values = std::move(more);
  else
    values.insert(values.end(), more.begin(), more.end());
}

std::vector<double> GridFile::scalars(std::string_view section, const std::string& name,
                                      std::size_t components) const {
  std::vector<double> values;
  for (const Piece& piece : pieces_) append_values(piece, section, name, components, values);
  return values;
}

std::vector<double> GridFile::point_array(const char* name) const {
  return scalars("PointData", name);
}

std::vector<double> GridFile::cell_array(const char* name) const {
  return scalars("CellData", name);
}

std::vector<ArrayHead> GridFile::arrays(std::string_view section) const {
  std::vector<ArrayHead> heads;
  const XmlElement* data = section_named(pieces_.front(), section);
  if (data == nullptr) return heads;
  for (const auto& array : data->children) {
    ArrayHead head{
        array->attribute("Name"), array->attribute("type"), information(*array, "UNITS_LABEL"), 1, {}};
    if (array->name != "DataArray" || head.name.empty()) continue;
    if (const std::string told = array->attribute("NumberOfComponents"); !told.empty())
      head.components = std::clamp<std::size_t>(number_in<std::size_t>(told).value_or(1), 1, 64);
    for (std::size_t k = 0; k < head.components && array->attributes.contains("ComponentName0"); ++k)
      head.parts.push_back(array->attribute("ComponentName" + std::to_string(k)));
    heads.push_back(std::move(head));
  }
  return heads;
}

std::vector<double> GridFile::values(std::string_view section, const std::string& name) const {
  if (section == "FieldData") {
    const XmlElement* array = find_array(pieces_.front(), section, name);
    return array != nullptr ? decode(*array, name, pieces_.front().coding) : std::vector<double>();
  }
  const auto heads = arrays(section);
  const auto head =
      std::find_if(heads.begin(), heads.end(), [&](const auto& one) { return one.name == name; });
  if (head == heads.end()) damaged("array " + name + " is missing");
  return scalars(section, name, head->components);
}

bool GridFile::of_vertices() const {
  constexpr double vertex = 1;  // VTK's number
  if (cell_count_ == 0) return false;
  const auto types = scalars("Cells", "types");
  return std::all_of(types.begin(), types.end(), [](double type) { return type == vertex; });
}

std::vector<Point> GridFile::points() const {
  std::vector<Point> points;
  for (const Piece& piece : pieces_) {
    if (piece.points == 0) continue;
    const XmlElement* section = piece.element->child("Points");
    const XmlElement* array = section != nullptr ? section->child("DataArray") : nullptr;
    if (array == nullptr) damaged("the points are missing");
    const std::vector<double> values = decode(*array, "Points", piece.coding);
    if (values.size() != 3 * piece.points) damaged("array Points has the wrong length");
    points.reserve(points.size() + piece.points);
    for (std::size_t i = 0; i < piece.points; ++i) {
      const Point point{values[3 * i], values[3 * i + 1]};
      // Beyond single precision nothing can be drawn.
      constexpr double farthest = 1e30;
      if (!(std::fabs(point.x) < farthest) || !(std::fabs(point.y) < farthest))
        damaged("a coordinate is not finite");
      points.push_back(point);
    }
  }
  return points;
}

GridFile::Cells GridFile::cells() const {
  Cells cells;
  cells.first.push_back(0);
  std::size_t points_before = 0;
  for (const Piece& piece : pieces_) {
    if (piece.cells == 0) {
      points_before += piece.points;
      continue;
    }
    const XmlElement* connectivity = find_array(piece, "Cells", "connectivity");
    if (connectivity == nullptr) damaged("array connectivity is missing");
    const std::vector<double> corners = decode(*connectivity, "connectivity", piece.coding);
    const std::size_t corners_before = cells.corners.size();
    cells.corners.reserve(corners_before + corners.size());
    for (const double corner : corners) {
      if (!(corner >= 0) || corner >= static_cast<double>(piece.points)) {
        damaged("a cell refers to a point that is not there");
      }
      cells.corners.push_back(static_cast<std::uint32_t>(points_before + static_cast<std::size_t>(corner)));
    }
    std::vector<double> ends;
    append_values(piece, "Cells", "offsets", 1, ends);
    cells.first.reserve(cells.first.size() + ends.size());
    double last = 0.0;
    for (const double end : ends) {
      if (!(end >= last) || end > static_cast<double>(corners.size())) damaged("cells are out of order");
      cells.first.push_back(static_cast<std::uint32_t>(corners_before + static_cast<std::size_t>(end)));
      last = end;
    }
    points_before += piece.points;
  }
  return cells;
}

Moment GridFile::moment() const {
  Moment moment;
  moment.time = time_;
  const std::vector<double> time = values("FieldData", "TimeValue");
  if (!time.empty() && std::isfinite(time.front())) moment.time = time.front();
  const std::vector<double> step = values("FieldData", "step");
  if (!step.empty() && step.front() >= 0 && step.front() < 9e15) {
    moment.step = static_cast<std::int64_t>(step.front());
  }
  for (const double pressure : values("FieldData", "well_pressure_Pa")) {
    moment.well_pressure.push_back(std::isfinite(pressure) ? pressure : 0.0);
  }
  return moment;
}

}  // namespace hfrac::run
