// SPDX-License-Identifier: BSD-3-Clause
#include "synthetic_run.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <vector>

namespace hfrac::viz_test {
namespace {

namespace fs = std::filesystem;
using Value = std::function<double(vtkIdType)>;

// Three values per item.
void add_vectors(vtkFieldData* data, const char* name, vtkIdType count,
                 const std::function<std::array<double, 3>(vtkIdType)>& value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) array->SetTypedTuple(i, value(i).data());
  data->AddArray(array);
}

void add_array(vtkFieldData* data, const char* name, vtkIdType count, const Value& value,
               bool integer = false) {
  const auto array = vtkSmartPointer<vtkDataArray>::Take(
      integer ? static_cast<vtkDataArray*>(vtkIntArray::New()) : vtkDoubleArray::New());
  array->SetName(name);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) array->SetTuple1(i, value(i));
  data->AddArray(array);
}

// The lattice: a point per disc, -1 where the hole is.
struct Lattice {
  int columns;
  int rows;
  std::vector<int> disc;  // columns x rows
  vtkNew<vtkPoints> centres;

  explicit Lattice(const SyntheticRun& run)
      : columns(run.columns), rows(static_cast<int>(std::floor(run.height / run.spacing()))) {
    disc.assign(static_cast<std::size_t>(columns) * rows, -1);
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const double x = (i + 0.5) * run.spacing();
        const double y = (j + 0.5) * run.spacing();
        if (std::hypot(x - run.well_x(), y - run.well_y()) < run.well_radius) continue;
        at(i, j) = static_cast<int>(centres->InsertNextPoint(x, y, 0.0));
      }
    }
  }
  int& at(int i, int j) { return disc[static_cast<std::size_t>(j) * columns + i]; }
};

double share(const SyntheticRun& run, int snapshot) {
  return run.snapshots > 1 ? static_cast<double>(snapshot) / (run.snapshots - 1) : 1.0;
}

void write_grid(const fs::path& folder, const char* kind, int snapshot, const SyntheticRun& run,
                vtkUnstructuredGrid* grid) {
  add_array(grid->GetFieldData(), "TimeValue", 1, [&](vtkIdType) { return 2.5 * snapshot; });
  add_array(
      grid->GetFieldData(), "step", 1, [&](vtkIdType) { return 100 * snapshot; }, true);
  add_array(grid->GetFieldData(), "well_pressure_Pa", 1,
            [&](vtkIdType) { return 45e6 * std::sqrt(share(run, snapshot)); });
  char name[64];
  std::snprintf(name, sizeof name, "%s_%05d.vtu", kind, snapshot);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName((folder / name).c_str());
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  writer->SetInputData(grid);
  if (writer->Write() == 0) throw std::runtime_error("cannot write " + (folder / name).string());
}

void write_discs(const fs::path& folder, int snapshot, const SyntheticRun& run, Lattice& lattice) {
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(lattice.centres);
  const vtkIdType count = lattice.centres->GetNumberOfPoints();
  grid->Allocate(count);
  for (vtkIdType i = 0; i < count; ++i) grid->InsertNextCell(VTK_VERTEX, 1, &i);
  add_array(grid->GetPointData(), "radius_m", count, [&](vtkIdType) { return run.spacing() / 2; });
  add_array(
      grid->GetPointData(), "disc_id", count, [](vtkIdType i) { return static_cast<double>(i); }, true);
  // Left of the well pressed, right of it pulled; every disc moved up by a millimetre per metre of x, none turned.
  const auto x = [&](vtkIdType i) { return lattice.centres->GetPoint(i)[0]; };
  add_vectors(grid->GetPointData(), "displacement_m", count, [&](vtkIdType i) {
    return std::array<double, 3>{0.0, 1e-3 * x(i), 0.0};
  });
  add_vectors(grid->GetPointData(), "stress_Pa", count, [&](vtkIdType i) {
    const double mean = x(i) < run.well_x() ? 10e6 : -10e6;
    return std::array<double, 3>{mean, mean, 0.0};
  });
  add_array(grid->GetPointData(), "rotation_rad", count, [](vtkIdType) { return 0.0; });
  add_array(
      grid->GetPointData(), "intact_bonds", count, [](vtkIdType) { return 6; }, true);
  if (run.with_temperature) {
    add_array(grid->GetPointData(), "temperature_K", count,
              [&](vtkIdType i) { return run.temperature_at(x(i), lattice.centres->GetPoint(i)[1]); });
  }
  write_grid(folder, "discs", snapshot, run, grid);
}

void write_bonds(const fs::path& folder, int snapshot, const SyntheticRun& run, Lattice& lattice) {
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(lattice.centres);
  std::vector<int> state;
  std::vector<double> force;
  const auto bond = [&](int from, int to) {
    if (from < 0 || to < 0) return;
    const vtkIdType ends[2] = {from, to};
    grid->InsertNextCell(VTK_LINE, 2, ends);
    double a[3];
    double b[3];
    lattice.centres->GetPoint(from, a);
    lattice.centres->GetPoint(to, b);
    force.push_back(a[1] == b[1] ? -5e6 : 5e6);  // rows are pressed, columns are pulled
    const bool crosses = (a[1] - run.well_y()) * (b[1] - run.well_y()) < 0;
    state.push_back(crosses && std::fabs(a[0] - run.well_x()) < run.half_length_at(snapshot) ? 1 : 0);
  };
  for (int j = 0; j < lattice.rows; ++j) {
    for (int i = 0; i < lattice.columns; ++i) {
      if (i + 1 < lattice.columns) bond(lattice.at(i, j), lattice.at(i + 1, j));
      if (j + 1 < lattice.rows) bond(lattice.at(i, j), lattice.at(i, j + 1));
    }
  }
  add_array(
      grid->GetCellData(), "state", grid->GetNumberOfCells(),
      [&](vtkIdType i) { return state[static_cast<std::size_t>(i)]; }, true);
  add_array(grid->GetCellData(), "normal_force_N", grid->GetNumberOfCells(),
            [&](vtkIdType i) { return force[static_cast<std::size_t>(i)]; });
  write_grid(folder, "bonds", snapshot, run, grid);
}

// Along y = well_y from the well's wall outwards, one crack per column; every fifth one in shear.
void write_cracks(const fs::path& folder, int snapshot, const SyntheticRun& run) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  const double length = run.half_length_at(snapshot);
  std::vector<double> aperture;
  for (int i = 0; i < run.columns; ++i) {
    const double x = (i + 0.5) * run.spacing();
    const double distance = std::fabs(x - run.well_x());
    if (distance < run.well_radius || distance > length) continue;
    const vtkIdType ends[2] = {points->InsertNextPoint(x - run.spacing() / 2, run.well_y(), 0.0),
                               points->InsertNextPoint(x + run.spacing() / 2, run.well_y(), 0.0)};
    grid->InsertNextCell(VTK_LINE, 2, ends);
    aperture.push_back(2e-3 * std::sqrt(std::max(0.0, 1 - distance / length)));
  }
  grid->SetPoints(points);
  const vtkIdType count = grid->GetNumberOfCells();
  add_array(
      grid->GetCellData(), "mode", count, [](vtkIdType i) { return i % 5 == 4 ? 2 : 1; }, true);
  add_array(grid->GetCellData(), "aperture_m", count,
            [&](vtkIdType i) { return aperture[static_cast<std::size_t>(i)]; });
  add_array(grid->GetCellData(), "time_s", count, [](vtkIdType i) { return 0.1 * static_cast<double>(i); });
  add_array(grid->GetCellData(), "pressure_Pa", count,
            [](vtkIdType i) { return 1e6 * static_cast<double>(i); });
  write_grid(folder, "cracks", snapshot, run, grid);
}

// An upright joint at a quarter of the width, of four pieces from below: of states 0, 1, 2, 3, each wider than the one before; the
// lower two slipped to the right, the others to the left.
void write_joints(const fs::path& folder, int snapshot, const SyntheticRun& run) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  constexpr int pieces = 4;
  for (int k = 0; k < pieces; ++k) {
    const vtkIdType ends[2] = {points->InsertNextPoint(run.width / 4, run.height * (k + 0.0) / pieces, 0.0),
                               points->InsertNextPoint(run.width / 4, run.height * (k + 1.0) / pieces, 0.0)};
    grid->InsertNextCell(VTK_LINE, 2, ends);
  }
  grid->SetPoints(points);
  const auto index = [](vtkIdType i) { return static_cast<double>(i); };
  add_array(grid->GetCellData(), "state", pieces, index, true);
  add_array(grid->GetCellData(), "hydraulic_aperture_m", pieces,
            [&](vtkIdType i) { return 1e-4 * index(i); });
  add_array(grid->GetCellData(), "slip_m", pieces, [](vtkIdType i) { return i < 2 ? -1e-3 : 1e-3; });
  add_array(grid->GetCellData(), "pressure_Pa", pieces, [&](vtkIdType i) { return 1e6 * index(i); });
  write_grid(folder, "joints", snapshot, run, grid);
}

// Squares between four discs; pressure falls off with the distance from the crack. The well is the square
// around it.
void write_flow(const fs::path& folder, int snapshot, const SyntheticRun& run, Lattice& lattice) {
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(lattice.centres);
  std::vector<double> pressure;
  const double length = run.half_length_at(snapshot);
  const double well_pressure = 45e6 * std::sqrt(share(run, snapshot));
  for (int j = 0; j + 1 < lattice.rows; ++j) {
    for (int i = 0; i + 1 < lattice.columns; ++i) {
      const int corners[4] = {lattice.at(i, j), lattice.at(i + 1, j), lattice.at(i + 1, j + 1),
                              lattice.at(i, j + 1)};
      vtkIdType ids[4];
      bool whole = true;
      for (int k = 0; k < 4; ++k) {
        ids[k] = corners[k];
        whole = whole && corners[k] >= 0;
      }
      if (!whole) continue;
      grid->InsertNextCell(VTK_POLYGON, 4, ids);
      const double x = (i + 1) * run.spacing() - run.well_x();
      const double y = (j + 1) * run.spacing() - run.well_y();
      const double distance = std::hypot(std::max(0.0, std::fabs(x) - length), y);
      pressure.push_back(well_pressure * std::exp(-distance / (0.12 * run.width)));
    }
  }
  // The hole's edge: discs with a missing neighbour, in order of their angle.
  std::vector<std::pair<double, vtkIdType>> edge;
  for (int j = 1; j + 1 < lattice.rows; ++j) {
    for (int i = 1; i + 1 < lattice.columns; ++i) {
      if (lattice.at(i, j) < 0) continue;
      bool missing = false;
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) missing = missing || lattice.at(i + di, j + dj) < 0;
      }
      if (!missing) continue;
      const double x = (i + 0.5) * run.spacing() - run.well_x();
      const double y = (j + 0.5) * run.spacing() - run.well_y();
      edge.emplace_back(std::atan2(y, x), lattice.at(i, j));
    }
  }
  std::sort(edge.begin(), edge.end());
  std::vector<vtkIdType> ring;
  for (const auto& [angle, disc] : edge) ring.push_back(disc);
  if (ring.size() > 2) {
    grid->InsertNextCell(VTK_POLYGON, static_cast<vtkIdType>(ring.size()), ring.data());
    pressure.push_back(well_pressure);
  }
  const vtkIdType count = grid->GetNumberOfCells();
  add_array(grid->GetCellData(), "pressure_Pa", count,
            [&](vtkIdType i) { return pressure[static_cast<std::size_t>(i)]; });
  add_array(
      grid->GetCellData(), "kind", count, [&](vtkIdType i) { return i == count - 1 ? 1 : 0; }, true);
  write_grid(folder, "flow", snapshot, run, grid);
}

}  // namespace

double SyntheticRun::half_length_at(int snapshot) const {
  return well_radius + (half_length - well_radius) * share(*this, snapshot);
}

double SyntheticRun::temperature_at(double x, double y) const {
  const double distance = std::hypot(x - well_x(), y - well_y());
  return 373.15 - 80.0 * std::exp(-(distance - well_radius) / well_radius);
}

void write_run(const fs::path& folder, const SyntheticRun& run) {
  fs::create_directories(folder);
  Lattice lattice(run);
  for (int i = 0; i < run.snapshots; ++i) {
    write_discs(folder, i, run, lattice);
    write_bonds(folder, i, run, lattice);
    write_cracks(folder, i, run);
    if (run.with_flow) write_flow(folder, i, run, lattice);
    if (run.with_joints) write_joints(folder, i, run);
  }
  write_tables(folder, run);
}

}  // namespace hfrac::viz_test
