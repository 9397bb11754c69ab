// SPDX-License-Identifier: BSD-3-Clause
#include "grid_file.h"

#include <vtkCellData.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <string>
#include <system_error>

#include "failure.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

void select(vtkDataArraySelection* selection, std::initializer_list<const char*> names) {
  selection->DisableAllArrays();
  for (const char* name : names) {
    if (selection->ArrayExists(name) != 0) selection->EnableArray(name);
  }
}

}  // namespace

GridFile::GridFile(const SeriesFile& file, std::initializer_list<const char*> point_arrays,
                   std::initializer_list<const char*> cell_arrays)
    : file_(file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file.path, error)) fail_reading("there is no file " + file.path.string());
  VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.path.c_str());
  reader->UpdateInformation();
  std::string errors = messages.take_errors();
  if (errors.empty()) {
    select(reader->GetPointDataArraySelection(), point_arrays);
    select(reader->GetCellDataArraySelection(), cell_arrays);
    reader->Update();
    errors = messages.take_errors();
  }
  if (!errors.empty()) fail_reading(file.path.string() + " cannot be read: " + errors);
  grid_ = reader->GetOutput();
  if (grid_ == nullptr || (grid_->GetNumberOfPoints() > 0 && grid_->GetPoints() == nullptr)) damaged("no points");
  check_cells();
}

void GridFile::damaged(const char* what) const {
  fail_reading(file_.path.string() + " is damaged: " + what);
}

void GridFile::check_cells() const {
  vtkCellArray* cells = grid_->GetCells();
  if (cells == nullptr) {
    if (grid_->GetNumberOfCells() > 0) damaged("no cells");
    return;
  }
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  const vtkIdType corner_count = connectivity->GetNumberOfTuples();
  vtkIdType previous = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i) {
    const auto offset = static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    if (offset < previous || offset > corner_count) damaged("cell offsets out of order");
    previous = offset;
  }
  for (vtkIdType i = 0; i < corner_count; ++i) {
    const auto corner = static_cast<vtkIdType>(connectivity->GetComponent(i, 0));
    if (corner < 0 || corner >= point_count()) damaged("a cell refers to a point that is not there");
  }
}

Point GridFile::point(vtkIdType index) const {
  double position[3];
  grid_->GetPoint(index, position);
  if (!std::isfinite(position[0]) || !std::isfinite(position[1])) damaged("a coordinate is not finite");
  return {position[0], position[1]};
}

std::span<const vtkIdType> GridFile::corners(vtkIdType cell) {
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  grid_->GetCellPoints(cell, count, points);
  return {points, static_cast<std::size_t>(count)};
}

vtkDataArray* GridFile::point_array(const char* name) const {
  vtkDataArray* array = grid_->GetPointData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfTuples() != point_count() || array->GetNumberOfComponents() < 1) {
    damaged((std::string("the array ") + name + " is missing or too short").c_str());
  }
  return array;
}

vtkDataArray* GridFile::cell_array(const char* name) const {
  vtkDataArray* array = grid_->GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfTuples() != cell_count() || array->GetNumberOfComponents() < 1) {
    damaged((std::string("the array ") + name + " is missing or too short").c_str());
  }
  return array;
}

Moment GridFile::moment() const {
  Moment moment;
  moment.time = file_.time;
  vtkFieldData* facts = grid_->GetFieldData();
  if (facts == nullptr) return moment;
  if (vtkDataArray* time = facts->GetArray("TimeValue"); time != nullptr && time->GetNumberOfTuples() > 0) {
    if (std::isfinite(time->GetComponent(0, 0))) moment.time = time->GetComponent(0, 0);
  }
  if (vtkDataArray* step = facts->GetArray("step"); step != nullptr && step->GetNumberOfTuples() > 0) {
    moment.step = static_cast<std::int64_t>(step->GetComponent(0, 0));
  }
  if (vtkDataArray* pressure = facts->GetArray("well_pressure_Pa"); pressure != nullptr) {
    for (vtkIdType i = 0; i < pressure->GetNumberOfTuples(); ++i) {
      for (int k = 0; k < pressure->GetNumberOfComponents(); ++k) {
        moment.well_pressure.push_back(pressure->GetComponent(i, k));
      }
    }
  }
  return moment;
}

}  // namespace hfrac::viz
