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

/** Grows the text of a file, element by element. Arrays stay the caller's until finish() codes them. */
class Text {
 public:
  explicit Text(Compression compression) : compression_(compression) {}

  void line(std::string_view words) {
    text_.back() += words;
    text_.back() += '\n';
  }

  void array(const VtuArray& array, const char* extra = "") {
    std::visit(
        [&]<class Value>(const std::vector<Value>& values) {
          element(array, kTypeName<Value>, std::as_bytes(std::span(values)), extra);
        },
        array.values);
  }

  /** An array without a unit, of numbers that stand elsewhere. */
  void integers(const char* name, std::span<const int32_t> values) {
    element(whole(name, {}), kTypeName<int32_t>, std::as_bytes(values), "");
  }

  /** The section `name` with its arrays. */
  void section(const char* name, const std::vector<VtuArray>& arrays) {
    line(fmt::format("<{}>", name));
    for (const auto& one : arrays) array(one);
    line(fmt::format("</{}>", name));
  }

  /** Begins a file of a kind of grid. */
  void begin(const char* kind, const char* more) {
    const auto compressor = compressor_name(compression_);
    line("<?xml version=\"1.0\"?>");
    line(fmt::format(R"(<VTKFile type="{}" version="0.1" byte_order="LittleEndian" header_type="UInt32"{}>)",
                     kind, compressor.empty() ? "" : fmt::format(" compressor=\"{}\"", compressor)));
    line(fmt::format("<{}{}>", kind, more));
  }

  /** The section `name` of a list of pieces: which arrays they have. */
  void listed(const char* name, const std::vector<VtuArray>& arrays) {
    line(fmt::format("<{}>", name));
    for (const auto& one : arrays) {
      std::visit([&]<class Value>(const std::vector<Value>&) { head("PDataArray", kTypeName<Value>, one); },
                 one.values);
      line(">");
      unit(one);
      line("</PDataArray>");
    }
    line(fmt::format("</{}>", name));
  }

  std::string finish(const char* kind, int workers = 1) {
    line(fmt::format("</{}>", kind));
    line("</VTKFile>");
    return with_coded_arrays(text_, arrays_, compression_, workers);
  }

 private:
  /** An element's beginning: what an array holds, but not its values. */
  void head(const char* element, const char* type, const VtuArray& array, const char* extra = "") {
    text_.back() += fmt::format("<{} type=\"{}\" Name=\"{}\"{}", element, type, array.name, extra);
    if (!array.components.empty())
      text_.back() += fmt::format(" NumberOfComponents=\"{}\"", array.components.size());
    for (size_t i = 0; i < array.components.size(); ++i)
      text_.back() += fmt::format(" ComponentName{}=\"{}\"", i, array.components[i]);
  }

  void element(const VtuArray& array, const char* type, RawBytes bytes, const char* extra) {
    head("DataArray", type, array, extra);
    line(" format=\"binary\">");
    arrays_.push_back(bytes);
    text_.emplace_back("\n");
    unit(array);
    line("</DataArray>");
  }

  void unit(const VtuArray& array) {
    if (!array.unit.empty())
      line(fmt::format("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                       array.unit));
  }

  Compression compression_;
  std::vector<std::string> text_ = {""};  ///< before each array, and behind the last
  std::vector<RawBytes> arrays_;
};

std::vector<VtuArray> arrays_of(const Moment& moment) {
  return {exact("TimeValue", "s", {moment.time}), exact("step", "", {static_cast<double>(moment.step)}),
          exact("well_pressure_Pa", "Pa", moment.well_pressure)};
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

std::string encode(const VtuGrid& grid, const Moment& moment, Compression compression, int workers) {
  const size_t cells = grid.offsets.empty() ? 0 : grid.offsets.size() - 1;
  const auto when = arrays_of(moment);
  const VtuArray points{"Points", "", {"x", "y", "z"}, in_space(grid.positions)};
  const VtuArray types{"types", "", {}, std::vector<uint8_t>(cells, static_cast<uint8_t>(grid.cell_type))};
  Text text(compression);
  text.begin("UnstructuredGrid", "");
  text.line("<FieldData>");
  for (const auto& array : when) {
    const auto count = std::get<std::vector<double>>(array.values).size();
    text.array(array, fmt::format(" NumberOfTuples=\"{}\"", count).c_str());
  }
  text.line("</FieldData>");
  text.line(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", grid.positions.size() / 2, cells));
  text.section("PointData", grid.point_data);
  text.section("CellData", grid.cell_data);
  text.line("<Points>");
  text.array(points);
  text.line("</Points>");
  text.line("<Cells>");
  text.integers("connectivity", grid.connectivity);
  // A file has the end of each cell.
  text.integers("offsets", std::span(grid.offsets).last(cells));
  text.array(types);
  text.line("</Cells>");
  text.line("</Piece>");
  return text.finish("UnstructuredGrid", workers);
}

std::string encode_list(const VtuGrid& piece, const std::vector<std::string>& files,
                        Compression compression) {
  Text text(compression);
  text.begin("PUnstructuredGrid", " GhostLevel=\"0\"");
  text.listed("PPointData", piece.point_data);
  text.listed("PCellData", piece.cell_data);
  text.listed("PPoints", {{"Points", "", {"x", "y", "z"}, std::vector<double>()}});
  for (const auto& file : files) text.line(fmt::format("<Piece Source=\"{}\"/>", file));
  return text.finish("PUnstructuredGrid");
}

void keep_used_points(VtuGrid& grid) {
  std::vector<int32_t> place(grid.positions.size() / 2, -1);
  for (const int32_t point : grid.connectivity) place[static_cast<size_t>(point)] = 0;
  std::vector<double> positions;
  int32_t used = 0;
  for (size_t i = 0; i < place.size(); ++i) {
    if (place[i] < 0) continue;
    place[i] = used++;
    positions.insert(positions.end(), {grid.positions[2 * i], grid.positions[2 * i + 1]});
  }
  for (int32_t& point : grid.connectivity) point = place[static_cast<size_t>(point)];
  grid.positions = std::move(positions);
}

}  // namespace hfrac::run
