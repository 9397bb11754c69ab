// SPDX-License-Identifier: BSD-3-Clause
// One VTU file, opened with the few arrays that are wanted and checked for damage.
#pragma once

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>
#include <initializer_list>
#include <span>

#include "snapshot.h"

namespace hfrac::viz {

class GridFile {
 public:
  // Reads the points, the cells and the named arrays only.
  GridFile(const SeriesFile& file, std::initializer_list<const char*> point_arrays,
           std::initializer_list<const char*> cell_arrays);

  vtkIdType point_count() const { return grid_->GetNumberOfPoints(); }
  vtkIdType cell_count() const { return grid_->GetNumberOfCells(); }
  // Points are finite, corners are in range.
  Point point(vtkIdType index) const;
  std::span<const vtkIdType> corners(vtkIdType cell);
  // A scalar array as long as there are points or cells.
  vtkDataArray* point_array(const char* name) const;
  vtkDataArray* cell_array(const char* name) const;
  Moment moment() const;

 private:
  [[noreturn]] void damaged(const char* what) const;
  void check_cells() const;

  SeriesFile file_;
  vtkSmartPointer<vtkUnstructuredGrid> grid_;
};

}  // namespace hfrac::viz
