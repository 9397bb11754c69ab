// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.h"

#include <cmath>

#include "grid_file.h"

namespace hfrac::viz {
namespace {

constexpr int shear_code = 2;  // in `state` of bonds and `mode` of cracks

int code(vtkDataArray* array, vtkIdType index) { return static_cast<int>(std::lround(array->GetComponent(index, 0))); }

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

Discs read_discs(const SeriesFile& file) {
  GridFile grid(file, {"radius_m"}, {});
  Discs read;
  read.moment = grid.moment();
  vtkDataArray* radius = grid.point_array("radius_m");
  read.discs.reserve(static_cast<std::size_t>(grid.point_count()));
  for (vtkIdType i = 0; i < grid.point_count(); ++i) {
    read.discs.push_back({grid.point(i), std::fabs(finite_or_zero(radius->GetComponent(i, 0)))});
  }
  return read;
}

Bonds read_bonds(const SeriesFile& file) {
  GridFile grid(file, {}, {"state"});
  Bonds read;
  vtkDataArray* state = grid.cell_array("state");
  for (vtkIdType cell = 0; cell < grid.cell_count(); ++cell) {
    if (code(state, cell) != 0) continue;
    const auto corners = grid.corners(cell);
    if (corners.size() < 2) continue;
    read.intact.push_back({grid.point(corners[0]), grid.point(corners[1])});
  }
  return read;
}

Cracks read_cracks(const SeriesFile& file) {
  GridFile grid(file, {}, {"mode", "aperture_m"});
  Cracks read;
  read.moment = grid.moment();
  if (grid.cell_count() == 0) return read;
  vtkDataArray* mode = grid.cell_array("mode");
  vtkDataArray* aperture = grid.cell_array("aperture_m");
  for (vtkIdType cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = grid.corners(cell);
    if (corners.size() < 2) continue;
    Crack crack;
    crack.line = {grid.point(corners[0]), grid.point(corners[1])};
    crack.mode = code(mode, cell) == shear_code ? CrackMode::shear : CrackMode::tension;
    crack.aperture = std::max(0.0, finite_or_zero(aperture->GetComponent(cell, 0)));
    read.cracks.push_back(crack);
  }
  return read;
}

Flow read_flow(const SeriesFile& file) {
  GridFile grid(file, {}, {"pressure_Pa", "kind"});
  Flow read;
  if (grid.cell_count() == 0) return read;
  vtkDataArray* pressure = grid.cell_array("pressure_Pa");
  vtkDataArray* kind = grid.cell_array("kind");
  for (vtkIdType cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = grid.corners(cell);
    if (corners.size() < 3) continue;
    Domain domain;
    domain.first_corner = static_cast<std::uint32_t>(read.corners.size());
    domain.corner_count = static_cast<std::uint32_t>(corners.size());
    domain.pressure = finite_or_zero(pressure->GetComponent(cell, 0));
    domain.well = code(kind, cell) == 1;
    for (const vtkIdType corner : corners) read.corners.push_back(grid.point(corner));
    read.domains.push_back(domain);
  }
  return read;
}

const SeriesFile* file_of(const Series& series, int number) {
  const auto found = series.find(number);
  return found != series.end() ? &found->second : nullptr;
}

}  // namespace hfrac::viz
