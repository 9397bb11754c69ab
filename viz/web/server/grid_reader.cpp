// SPDX-License-Identifier: BSD-3-Clause
// Reading goes through VTK, which knows every encoding (inline and appended, zlib, LZ4, LZMA, none), and what
// comes out is checked before anything indexes with it. Coordinates become floats: seven digits of the
// model's extent, far below a pixel.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <limits>

#include "web/server/grid.hpp"

namespace hfrac::web {
namespace {

template <class Value>
std::vector<Value> copied(vtkDataArray& array, int32_t components) {
  std::vector<Value> values;
  const vtkIdType count = array.GetNumberOfTuples();
  values.reserve(static_cast<size_t>(count) * static_cast<size_t>(components));
  for (vtkIdType i = 0; i < count; ++i)
    for (int32_t j = 0; j < components; ++j) values.push_back(static_cast<Value>(array.GetComponent(i, j)));
  return values;
}

/** Integers up to 32 bits stay exact, doubles stay doubles, all else is float. Vectors in space lose their
 * third component, which is always 0 in a plane model. */
GridArray converted(vtkDataArray& array, const char* of) {
  GridArray result;
  result.name = array.GetName() != nullptr ? array.GetName() : "";
  result.of = of;
  if (auto* information = array.GetInformation(); information->Has(vtkDataArray::UNITS_LABEL()))
    result.unit = information->Get(vtkDataArray::UNITS_LABEL());
  const int components = array.GetNumberOfComponents();
  const bool flat = components == 3 && array.GetComponentName(2) != nullptr &&
                    std::string(array.GetComponentName(2)) == "z";
  result.components = flat ? 2 : components;
  for (int i = 0; i < result.components && array.HasAComponentName(); ++i)
    result.parts.emplace_back(array.GetComponentName(i) != nullptr ? array.GetComponentName(i) : "");
  switch (array.GetDataType()) {
    case VTK_DOUBLE:
      result.values = copied<double>(array, result.components);
      break;
    case VTK_FLOAT:
    case VTK_UNSIGNED_INT:
    case VTK_LONG:
    case VTK_UNSIGNED_LONG:
    case VTK_LONG_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      result.values = copied<float>(array, result.components);
      break;
    default:
      result.values = copied<int32_t>(array, result.components);
  }
  return result;
}

void add_all(Grid& grid, vtkFieldData& data, const char* of, int64_t count) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetArray(i);
    if (array == nullptr || (count >= 0 && array->GetNumberOfTuples() != count)) continue;
    grid.arrays.push_back(converted(*array, of));
  }
}

void add_positions(Grid& grid, vtkUnstructuredGrid& source) {
  GridArray positions{"position", "geometry", "m", 2, {"x", "y"}, {}};
  std::vector<float> values;
  values.reserve(static_cast<size_t>(grid.points) * 2);
  for (vtkIdType i = 0; i < grid.points; ++i) {
    const double* point = source.GetPoints()->GetPoint(i);
    values.insert(values.end(), {static_cast<float>(point[0]), static_cast<float>(point[1])});
  }
  positions.values = std::move(values);
  grid.arrays.push_back(std::move(positions));
}

/** Lines and polygons; a grid of vertices is its points and needs no cells. */
void add_cells(Grid& grid, vtkUnstructuredGrid& source, const std::filesystem::path& file) {
  if (grid.cells == 0 || source.GetCellType(0) == VTK_VERTEX) return;
  std::vector<int32_t> first{0}, corners;
  const vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid.cells; ++i) {
    source.GetCells()->GetCellAtId(i, ids);
    for (vtkIdType j = 0; j < ids->GetNumberOfIds(); ++j) {
      if (ids->GetId(j) < 0 || ids->GetId(j) >= grid.points)
        throw GridError(fmt::format("'{}' is damaged: cell {} names point {} of {}", file.string(), i,
                                    ids->GetId(j), grid.points));
      corners.push_back(static_cast<int32_t>(ids->GetId(j)));
    }
    first.push_back(static_cast<int32_t>(corners.size()));
  }
  grid.arrays.push_back({"first", "geometry", "", 1, {}, std::move(first)});
  grid.arrays.push_back({"corner", "geometry", "", 1, {}, std::move(corners)});
}

}  // namespace

std::shared_ptr<const Grid> read_grid(const std::filesystem::path& file) {
  const vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkUnstructuredGrid* source = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || source == nullptr || source->GetFieldData()->GetNumberOfArrays() == 0)
    throw GridError(
        fmt::format("'{}' cannot be read: it is damaged or not a VTU file of hfrac", file.string()));
  if (source->GetNumberOfPoints() > std::numeric_limits<int32_t>::max() / 4)
    throw GridError(fmt::format("'{}' has more points than a page can show", file.string()));

  auto grid = std::make_shared<Grid>();
  grid->points = source->GetNumberOfPoints();
  grid->cells = source->GetNumberOfCells();
  if (vtkDataArray* time = source->GetFieldData()->GetArray("TimeValue");
      time != nullptr && time->GetNumberOfTuples() > 0)
    grid->time = time->GetComponent(0, 0);
  if (grid->points > 0) add_positions(*grid, *source);
  add_cells(*grid, *source, file);
  add_all(*grid, *source->GetPointData(), "points", grid->points);
  add_all(*grid, *source->GetCellData(), "cells", grid->cells);
  add_all(*grid, *source->GetFieldData(), "run", -1);
  return grid;
}

}  // namespace hfrac::web
