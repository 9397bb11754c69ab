// SPDX-License-Identifier: BSD-3-Clause
// The XML around the arrays; the numbers themselves are coded in array_coding.cpp.
#include "run/vtu_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace hfrac::run {
namespace {

template <class Value>
constexpr const char* kTypeName = nullptr;
template <>
constexpr const char* kTypeName<float> = "Float32";
template <>
constexpr const char* kTypeName<double> = "Float64";
template <>
constexpr const char* kTypeName<int32_t> = "Int32";
template <>
constexpr const char* kTypeName<uint8_t> = "UInt8";

/** Grows the text of a file, element by element. */
class Text {
 public:
  explicit Text(Compression compression) : compression_(compression) {}

  void line(std::string_view words) {
    text_ += words;
    text_ += '\n';
  }

  void array(const VtuArray& array, const char* extra = "") {
    std::visit([&](const auto& values) { this->array(array, values, extra); }, array.values);
  }

  /** The section `name` with its arrays. */
  void section(const char* name, const std::vector<VtuArray>& arrays) {
    line(fmt::format("<{}>", name));
    for (const auto& one : arrays) array(one);
    line(fmt::format("</{}>", name));
  }

  std::string finish() {
    line("</UnstructuredGrid>");
    line("</VTKFile>");
    return std::move(text_);
  }

 private:
  template <class Value>
  void array(const VtuArray& array, const std::vector<Value>& values, const char* extra) {
    text_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\"{}", kTypeName<Value>, array.name, extra);
    if (!array.components.empty())
      text_ += fmt::format(" NumberOfComponents=\"{}\"", array.components.size());
    for (size_t i = 0; i < array.components.size(); ++i)
      text_ += fmt::format(" ComponentName{}=\"{}\"", i, array.components[i]);
    line(" format=\"binary\">");
    append_coded(text_, std::as_bytes(std::span(values)), compression_);
    text_ += '\n';
    if (!array.unit.empty())
      line(fmt::format("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                       array.unit));
    line("</DataArray>");
  }

  Compression compression_;
  std::string text_;
};

void add_moment(Text& text, const Moment& moment) {
  text.line("<FieldData>");
  for (const auto& array :
       {exact("TimeValue", "s", {moment.time}), exact("step", "", {static_cast<double>(moment.step)}),
        exact("well_pressure_Pa", "Pa", moment.well_pressure)}) {
    const auto count = std::get<std::vector<double>>(array.values).size();
    text.array(array, fmt::format(" NumberOfTuples=\"{}\"", count).c_str());
  }
  text.line("</FieldData>");
}

void add_cells(Text& text, const VtuGrid& grid, size_t cells) {
  std::vector<int32_t> ends;  // a file has the end of each cell
  if (cells > 0) ends.assign(std::next(grid.offsets.begin()), grid.offsets.end());
  text.section("Cells",
               {whole("connectivity", grid.connectivity),
                whole("offsets", std::move(ends)),
                {"types", "", {}, std::vector<uint8_t>(cells, static_cast<uint8_t>(grid.cell_type))}});
}

}  // namespace

std::vector<int32_t> even_offsets(size_t count, int32_t corners) {
  std::vector<int32_t> offsets(count + 1);
  for (size_t i = 0; i <= count; ++i) offsets[i] = static_cast<int32_t>(i) * corners;
  return offsets;
}

VtuArray floats(std::string name, std::string unit, const std::vector<double>& values,
                std::vector<const char*> components) {
  std::vector<float> rounded(values.size());
  for (size_t i = 0; i < values.size(); ++i) rounded[i] = static_cast<float>(values[i]);
  return {std::move(name), std::move(unit), std::move(components), std::move(rounded)};
}

VtuArray exact(std::string name, std::string unit, std::vector<double> values) {
  return {std::move(name), std::move(unit), {}, std::move(values)};
}

VtuArray whole(std::string name, std::vector<int32_t> values) {
  return {std::move(name), "", {}, std::move(values)};
}

std::vector<double> in_space(const std::vector<double>& plane) {
  std::vector<double> space(plane.size() / 2 * 3);
  for (size_t i = 0; i < plane.size() / 2; ++i) {
    space[3 * i] = plane[2 * i];
    space[3 * i + 1] = plane[2 * i + 1];
  }
  return space;
}

std::string encode(const VtuGrid& grid, const Moment& moment, Compression compression) {
  const size_t cells = grid.offsets.empty() ? 0 : grid.offsets.size() - 1;
  const auto compressor = compressor_name(compression);
  Text text(compression);
  text.line("<?xml version=\"1.0\"?>");
  text.line(fmt::format(
      R"(<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" header_type="UInt32"{}>)",
      compressor.empty() ? "" : fmt::format(" compressor=\"{}\"", compressor)));
  text.line("<UnstructuredGrid>");
  add_moment(text, moment);
  text.line(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", grid.positions.size() / 2, cells));
  text.section("PointData", grid.point_data);
  text.section("CellData", grid.cell_data);
  text.section("Points", {{"Points", "", {"x", "y", "z"}, in_space(grid.positions)}});
  add_cells(text, grid, cells);
  text.line("</Piece>");
  return text.finish();
}

}  // namespace hfrac::run
