// SPDX-License-Identifier: BSD-3-Clause
#include "grid_file.h"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "failure.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

vtkSmartPointer<vtkDataCompressor> make_compressor(const std::string& name) {
  if (name == "vtkZLibDataCompressor") return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return nullptr;
}

// 0 if it is no sensible number
std::size_t count_attribute(const XmlElement& element, const char* name) {
  const long long count = std::strtoll(element.attribute(name).c_str(), nullptr, 10);
  return count > 0 && count < 4'000'000'000LL ? static_cast<std::size_t>(count) : 0;
}

}  // namespace

GridFile::GridFile(const SeriesFile& file) : file_(file), root_(read_xml(file.path)) {
  grid_ = root_->child("UnstructuredGrid");
  if (grid_ == nullptr) damaged("it holds no UnstructuredGrid");
  if (root_->attribute("byte_order") == "BigEndian")
    damaged("its numbers are big-endian, which is not supported");
  coding_.wide_headers = root_->attribute("header_type") == "UInt64";
  const std::string compressor = root_->attribute("compressor");
  coding_.compressor = make_compressor(compressor);
  if (!compressor.empty() && coding_.compressor == nullptr)
    damaged("its compressor " + compressor + " is unknown");
  piece_ = grid_->child("Piece");
  if (piece_ == nullptr) damaged("it holds no Piece");
  const auto is_piece = [](const auto& element) { return element->name == "Piece"; };
  if (std::count_if(grid_->children.begin(), grid_->children.end(), is_piece) > 1)
    damaged("it is in several pieces; save it as one");
  point_count_ = count_attribute(*piece_, "NumberOfPoints");
  cell_count_ = count_attribute(*piece_, "NumberOfCells");
}

void GridFile::damaged(const std::string& what) const {
  fail_reading(file_.path.string() + " cannot be read: " + what);
}

const XmlElement* GridFile::find_array(const char* section, const char* name) const {
  const XmlElement* arrays = piece_->child(section);
  if (arrays == nullptr) return nullptr;
  for (const auto& array : arrays->children) {
    if (array->attribute("Name") == name) return array.get();
  }
  return nullptr;
}

std::vector<double> GridFile::decode(const XmlElement& array, const std::string& name) const {
  try {
    VtkMessages messages;  // a compressor says aloud what its result says too
    return decode_array(array.text, array.attribute("type"), array.attribute("format"), coding_);
  } catch (const ArrayDamage& damage) {
    this->damaged("array " + name + ": " + damage.what());
  }
}

std::vector<double> GridFile::scalars(const char* section, const char* name, std::size_t count) const {
  if (count == 0) return {};
  const XmlElement* array = find_array(section, name);
  if (array == nullptr) damaged(std::string("array ") + name + " is missing");
  std::vector<double> values = decode(*array, name);
  if (values.size() != count) damaged(std::string("array ") + name + " has the wrong length");
  return values;
}

std::vector<double> GridFile::point_array(const char* name, std::size_t components) const {
  return scalars("PointData", name, point_count_ * components);
}

std::vector<double> GridFile::cell_array(const char* name) const {
  return scalars("CellData", name, cell_count_);
}

std::optional<std::vector<double>> GridFile::component(const char* section, const std::string& name,
                                                       std::size_t index) const {
  const XmlElement* array = find_array(section, name.c_str());
  if (array == nullptr) return std::nullopt;
  const std::string told = array->attribute("NumberOfComponents");
  std::size_t components = 1;
  if (!told.empty()) std::from_chars(told.data(), told.data() + told.size(), components);
  constexpr std::size_t most = 64;  // more is damage
  if (index >= components || components > most) return std::nullopt;
  const std::size_t count = std::string_view(section) == "PointData" ? point_count_ : cell_count_;
  const std::vector<double> all = scalars(section, name.c_str(), count * components);
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = all[i * components + index];
  return values;
}

std::vector<std::string> GridFile::array_names(const char* section) const {
  std::vector<std::string> names;
  const XmlElement* data = piece_->child(section);
  if (data == nullptr) return names;
  for (const auto& array : data->children) {
    if (const std::string name = array->attribute("Name"); !name.empty()) names.push_back(name);
  }
  return names;
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

std::vector<double> GridFile::field_values(const char* name) const {
  const XmlElement* fields = grid_->child("FieldData");
  if (fields == nullptr) return {};
  for (const auto& array : fields->children) {
    if (array->attribute("Name") == name) return decode(*array, name);
  }
  return {};
}

Moment GridFile::moment() const {
  Moment moment;
  moment.time = file_.time;
  const std::vector<double> time = field_values("TimeValue");
  if (!time.empty() && std::isfinite(time.front())) moment.time = time.front();
  const std::vector<double> step = field_values("step");
  if (!step.empty() && step.front() >= 0 && step.front() < 9e15) {
    moment.step = static_cast<std::int64_t>(step.front());
  }
  for (const double pressure : field_values("well_pressure_Pa")) {
    moment.well_pressure.push_back(std::isfinite(pressure) ? pressure : 0.0);
  }
  return moment;
}

}  // namespace hfrac::viz
