// SPDX-License-Identifier: BSD-3-Clause
// VTK's array and cell classes, wrapped so that the four writers read as lists of what is in a file.
#include "output/vtu_grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkZLibDataCompressor.h>

#include <numeric>
#include <stdexcept>

namespace hfrac::output {
namespace {

template <class Array, class Value>
void add_array(vtkFieldData& data, const char* name, const char* unit, const std::vector<Value>& values,
               const std::vector<const char*>& components) {
  const int width = components.empty() ? 1 : static_cast<int>(components.size());
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(width);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / width);
  for (int i = 0; i < width && width > 1; ++i) array->SetComponentName(i, components[static_cast<size_t>(i)]);
  for (size_t i = 0; i < values.size(); ++i)
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename Array::ValueType>(values[i]));
  if (unit) array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  data.AddArray(array);
}

vtkSmartPointer<vtkTypeInt32Array> identifiers(const std::vector<int32_t>& values) {
  auto array = vtkSmartPointer<vtkTypeInt32Array>::New();
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (size_t i = 0; i < values.size(); ++i) array->SetValue(static_cast<vtkIdType>(i), values[i]);
  return array;
}

}  // namespace

void set_points(vtkUnstructuredGrid& grid, const std::vector<double>& positions) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size() / 2));
  for (size_t i = 0; i + 1 < positions.size(); i += 2)
    points->SetPoint(static_cast<vtkIdType>(i / 2), positions[i], positions[i + 1], 0.0);
  grid.SetPoints(points);
}

void set_cells(vtkUnstructuredGrid& grid, int cell_type, const std::vector<int32_t>& offsets,
               const std::vector<int32_t>& connectivity) {
  vtkNew<vtkCellArray> cells;
  cells->SetData(identifiers(offsets), identifiers(connectivity));
  grid.SetCells(cell_type, cells);
}

std::vector<int32_t> even_offsets(size_t count, int32_t corners) {
  std::vector<int32_t> offsets(count + 1);
  for (size_t i = 0; i <= count; ++i) offsets[i] = static_cast<int32_t>(i) * corners;
  return offsets;
}

void add_floats(vtkFieldData& data, const char* name, const char* unit, const std::vector<double>& values,
                const std::vector<const char*>& components) {
  add_array<vtkFloatArray>(data, name, unit, values, components);
}

void add_doubles(vtkFieldData& data, const char* name, const char* unit, const std::vector<double>& values) {
  add_array<vtkDoubleArray>(data, name, unit, values, {});
}

void add_integers(vtkFieldData& data, const char* name, const std::vector<int32_t>& values) {
  add_array<vtkIntArray>(data, name, nullptr, values, {});
}

void add_numbering(vtkFieldData& data, const char* name, size_t count) {
  std::vector<int32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  add_integers(data, name, numbers);
}

std::vector<double> in_space(const std::vector<double>& plane) {
  std::vector<double> space;
  space.reserve(plane.size() / 2 * 3);
  for (size_t i = 0; i + 1 < plane.size(); i += 2) space.insert(space.end(), {plane[i], plane[i + 1], 0.0});
  return space;
}

std::string encode(vtkUnstructuredGrid& grid, const hfrac_sim_state& state,
                   const std::vector<hfrac_well_state>& wells) {
  std::vector<double> pressures;
  for (const auto& well : wells) pressures.push_back(well.pressure);
  auto& field = *grid.GetFieldData();
  add_doubles(field, "TimeValue", "s", {state.time});
  add_doubles(field, "step", nullptr, {static_cast<double>(state.step)});
  add_doubles(field, "well_pressure_Pa", "Pa", pressures);

  vtkNew<vtkZLibDataCompressor> compressor;
  compressor->SetCompressionLevel(1);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt32();
  writer->SetCompressor(compressor);
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0 || writer->GetErrorCode() != 0)
    throw std::runtime_error("VTK could not encode a grid; is the machine out of memory?");
  return writer->GetOutputString();
}

}  // namespace hfrac::output
