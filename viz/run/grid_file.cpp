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

}  // namespace

GridFile::GridFile(const SeriesFile& file)
    : path_(file.path),
      time_(file.time),
      root_(file.content != nullptr ? parse_xml(*file.content, file.path)
                                    : parse_xml(read_whole(file.path), file.path)) {
  grid_ = root_->child("UnstructuredGrid");
  if (grid_ == nullptr) damaged("it holds no UnstructuredGrid");
  if (root_->attribute("byte_order") == "BigEndian")
    damaged("its numbers are big-endian, which is not supported");
  coding_.wide_headers = root_->attribute("header_type") == "UInt64";
  const std::string compressor = root_->attribute("compressor");
  const auto compression = compression_named(compressor);
  if (!compression) damaged("its compressor " + compressor + " is unknown");
  coding_.compression = *compression;
  piece_ = grid_->child("Piece");
  if (piece_ == nullptr) damaged("it holds no Piece");
  const auto is_piece = [](const auto& element) { return element->name == "Piece"; };
  if (std::count_if(grid_->children.begin(), grid_->children.end(), is_piece) > 1)
    damaged("it is in several pieces; save it as one");
  point_count_ = count_attribute(*piece_, "NumberOfPoints");
  cell_count_ = count_attribute(*piece_, "NumberOfCells");
}

void GridFile::damaged(const std::string& what) const {
  fail_reading(path_.string() + " cannot be read: " + what);
}

const XmlElement* GridFile::section_named(std::string_view section) const {
  return section == "FieldData" ? grid_->child(section) : piece_->child(section);
}

const XmlElement* GridFile::find_array(std::string_view section, std::string_view name) const {
  const XmlElement* arrays = section_named(section);
  if (arrays == nullptr) return nullptr;
  for (const auto& array : arrays->children) {
    if (array->name == "DataArray" && array->attribute("Name") == name) return array.get();
  }
  return nullptr;
}

std::vector<double> GridFile::decode(const XmlElement& array, const std::string& name) const {
  try {
    return decode_array(array.text, array.attribute("type"), array.attribute("format"), coding_);
  } catch (const ArrayDamage& damage) {
    this->damaged("array " + name + ": " + damage.what());
  }
}

std::vector<double> GridFile::scalars(std::string_view section, const std::string& name,
                                      std::size_t count) const {
  if (count == 0) return {};
  const XmlElement* array = find_array(section, name);
  if (array == nullptr) damaged("array " + name + " is missing");
  std::vector<double> values = decode(*array, name);
  if (values.size() != count) damaged("array " + name + " has the wrong length");
  return values;
}

std::vector<double> GridFile::point_array(const char* name) const {
  return scalars("PointData", name, point_count_);
}

std::vector<double> GridFile::cell_array(const char* name) const {
  return scalars("CellData", name, cell_count_);
}

std::vector<ArrayHead> GridFile::arrays(std::string_view section) const {
  std::vector<ArrayHead> heads;
  const XmlElement* data = section_named(section);
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
    const XmlElement* array = find_array(section, name);
    return array != nullptr ? decode(*array, name) : std::vector<double>();
  }
  const auto heads = arrays(section);
  const auto head =
      std::find_if(heads.begin(), heads.end(), [&](const auto& one) { return one.name == name; });
  if (head == heads.end()) damaged("array " + name + " is missing");
  return scalars(section, name, (section == "PointData" ? point_count_ : cell_count_) * head->components);
}

bool GridFile::of_vertices() const {
  constexpr double vertex = 1;  // VTK's number
  if (cell_count_ == 0) return false;
  const auto types = scalars("Cells", "types", cell_count_);
  return std::all_of(types.begin(), types.end(), [](double type) { return type == vertex; });
}

std::vector<Point> GridFile::points() const {
  if (point_count_ == 0) return {};
  const XmlElement* section = piece_->child("Points");
  const XmlElement* array = section != nullptr ? section->child("DataArray") : nullptr;
  if (array == nullptr) damaged("the points are missing");
  const std::vector<double> values = decode(*array, "Points");
  if (values.size() != 3 * point_count_) damaged("array Points has the wrong length");
  std::vector<Point> points(point_count_);
  for (std::size_t i = 0; i < point_count_; ++i) {
    points[i] = {values[3 * i], values[3 * i + 1]};
    // Beyond single precision nothing can be drawn.
    constexpr double farthest = 1e30;
    if (!(std::fabs(points[i].x) < farthest) || !(std::fabs(points[i].y) < farthest)) {
      damaged("a coordinate is not finite");
    }
  }
  return points;
}

GridFile::Cells GridFile::cells() const {
  Cells cells;
  cells.first.push_back(0);
  if (cell_count_ == 0) return cells;
  const XmlElement* connectivity = find_array("Cells", "connectivity");
  if (connectivity == nullptr) damaged("array connectivity is missing");
  const std::vector<double> corners = decode(*connectivity, "connectivity");
  cells.corners.reserve(corners.size());
  for (const double corner : corners) {
    if (!(corner >= 0) || corner >= static_cast<double>(point_count_)) {
      damaged("a cell refers to a point that is not there");
    }
    cells.corners.push_back(static_cast<std::uint32_t>(corner));
  }
  cells.first.reserve(cell_count_ + 1);
  for (const double end : scalars("Cells", "offsets", cell_count_)) {
    if (!(end >= cells.first.back()) || end > static_cast<double>(corners.size()))
      damaged("cells are out of order");
    cells.first.push_back(static_cast<std::uint32_t>(end));
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
