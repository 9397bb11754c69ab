// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.h"

#include <algorithm>
#include <cmath>

#include "run/grid_file.hpp"

namespace hfrac::viz {
namespace {

constexpr int shear_code = 2;  // in `state` of bonds and `mode` of cracks

int code(double value) {
  return value > 0 && value < 100 ? static_cast<int>(std::lround(value)) : 0;
}

}  // namespace

double usable(double value) {
  constexpr double largest = 1e30;  // than any real value, and still a number that can be reckoned with
  return std::fabs(value) < largest ? value : 0.0;
}

Discs read_discs(const SeriesFile& file) {
  const GridFile grid(file);
  Discs read;
  read.moment = grid.moment();
  const std::vector<Point> points = grid.points();
  const std::vector<double> radius = grid.point_array("radius_m");
  read.discs.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    read.discs.push_back({points[i], std::fabs(usable(radius[i]))});
  return read;
}

Bonds read_bonds(const SeriesFile& file) {
  const GridFile grid(file);
  Bonds read;
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  const std::vector<double> state = grid.cell_array("state");
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = cells.of(cell);
    if (code(state[cell]) != 0 || corners.size() < 2) continue;
    read.intact.push_back({points[corners[0]], points[corners[1]]});
  }
  return read;
}

Cracks read_cracks(const SeriesFile& file) {
  const GridFile grid(file);
  Cracks read;
  read.moment = grid.moment();
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  const std::vector<double> mode = grid.cell_array("mode");
  const std::vector<double> aperture = grid.cell_array("aperture_m");
  std::vector<double> time(grid.cell_count());
  if (grid.has_cell_array("time_s")) time = grid.cell_array("time_s");
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = cells.of(cell);
    if (corners.size() < 2) continue;
    Crack crack;
    crack.line = {points[corners[0]], points[corners[1]]};
    crack.mode = code(mode[cell]) == shear_code ? CrackMode::shear : CrackMode::tension;
    crack.aperture = std::max(0.0, usable(aperture[cell]));
    crack.time = usable(time[cell]);
    crack.cell = cell;
    read.cracks.push_back(crack);
  }
  return read;
}

std::vector<BondForce> read_bond_forces(const SeriesFile& file) {
  const GridFile grid(file);
  std::vector<BondForce> read;
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  const std::vector<double> state = grid.cell_array("state");
  const std::vector<double> normal = grid.cell_array("normal_force_N");
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = cells.of(cell);
    if (code(state[cell]) != 0 || corners.size() < 2) continue;
    read.push_back({{points[corners[0]], points[corners[1]]}, usable(normal[cell])});
  }
  return read;
}

std::vector<Segment> read_bond_lines(const SeriesFile& file) {
  const GridFile grid(file);
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  std::vector<Segment> lines(grid.cell_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = cells.of(cell);
    if (corners.size() >= 2) lines[cell] = {points[corners[0]], points[corners[1]]};
  }
  return lines;
}

std::vector<double> read_disc_array(const SeriesFile& file, const char* name, std::size_t components) {
  const GridFile grid(file);
  std::vector<double> values = grid.point_array(name, components);
  for (double& value : values) value = usable(value);
  return values;
}

Flow read_flow(const SeriesFile& file) {
  const GridFile grid(file);
  Flow read;
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  const std::vector<double> pressure = grid.cell_array("pressure_Pa");
  const std::vector<double> kind = grid.cell_array("kind");
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto corners = cells.of(cell);
    if (corners.size() < 3) continue;
    Domain domain;
    domain.first_corner = static_cast<std::uint32_t>(read.corners.size());
    domain.corner_count = static_cast<std::uint32_t>(corners.size());
    domain.pressure = usable(pressure[cell]);
    domain.well = code(kind[cell]) == 1;
    domain.cell = cell;
    for (const std::uint32_t corner : corners) read.corners.push_back(points[corner]);
    read.domains.push_back(domain);
  }
  return read;
}

}  // namespace hfrac::viz
