// SPDX-License-Identifier: BSD-3-Clause
#include "snapshot.h"

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "run/grid_file.hpp"

namespace hfrac::viz {

namespace {

constexpr int shear_code = 2;  // in `state` of bonds and `mode` of cracks

int code(double value) {
  return value > 0 && value < 100 ? static_cast<int>(std::lround(value)) : 0;
}

// visit(cell, line) for each cell with two corners.
template <class Visit>
void visit_lines(const GridFile& grid, const Visit& visit) {
  const std::vector<Point> points = grid.points();
  const GridFile::Cells cells = grid.cells();
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    if (const auto corners = cells.of(cell); corners.size() >= 2)
      visit(cell, Segment{points[corners[0]], points[corners[1]]});
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
  const std::vector<double> state = grid.cell_array("state");
  visit_lines(grid, [&](std::size_t cell, const Segment& line) {
    if (code(state[cell]) == 0) read.intact.push_back(line);
  });
  return read;
}

Cracks read_cracks(const SeriesFile& file) {
  const GridFile grid(file);
  Cracks read;
  read.moment = grid.moment();
  const std::vector<double> mode = grid.cell_array("mode");
  const std::vector<double> aperture = grid.cell_array("aperture_m");
  std::vector<double> time(grid.cell_count());
  if (grid.has_cell_array("time_s")) time = grid.cell_array("time_s");
  visit_lines(grid, [&](std::size_t cell, const Segment& line) {
    const CrackMode kind = code(mode[cell]) == shear_code ? CrackMode::shear : CrackMode::tension;
    read.cracks.push_back({line, kind, std::max(0.0, usable(aperture[cell])), usable(time[cell]), cell});
  });
  return read;
}

std::vector<BondForce> read_bond_forces(const SeriesFile& file) {
  const GridFile grid(file);
  std::vector<BondForce> read;
  const std::vector<double> state = grid.cell_array("state");
  const std::vector<double> normal = grid.cell_array("normal_force_N");
  visit_lines(grid, [&](std::size_t cell, const Segment& line) {
    if (code(state[cell]) == 0) read.push_back({line, usable(normal[cell])});
  });
  return read;
}

std::vector<Segment> read_lines(const SeriesFile& file) {
  const GridFile grid(file);
  std::vector<Segment> lines(grid.cell_count());
  visit_lines(grid, [&](std::size_t cell, const Segment& line) { lines[cell] = line; });
  return lines;
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

namespace {

constexpr int stage_count = 5;

HistoryPoint read_point(const RunFolder& run, std::int64_t number, const SeriesFile& discs) {
  HistoryPoint point;
  point.number = number;
  point.moment.time = discs.time;
  const SeriesFile* file = file_of(run.cracks, number);
  if (file == nullptr) {
    point.moment = GridFile(discs).moment();
    return point;
  }
  const Cracks read = read_cracks(*file);
  point.moment = read.moment;
  for (const Crack& crack : read.cracks) {
    ++(crack.mode == CrackMode::shear ? point.shear_cracks : point.tensile_cracks);
  }
  return point;
}

// Strictly rising indices that end at `last`, as near to the wanted ones as that allows.
void spread(std::vector<int>& stages, int last) {
  for (std::size_t i = stages.size(); i-- > 0;) {
    const int room = static_cast<int>(stages.size() - 1 - i);
    const int above = i + 1 < stages.size() ? stages[i + 1] - 1 : last;
    stages[i] = std::min({stages[i], above, last - room});
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    stages[i] = std::max(stages[i], i == 0 ? 0 : stages[i - 1] + 1);
  }
}

std::vector<int> even_in_time(int last) {
  std::vector<int> stages;
  for (int k = 1; k <= stage_count; ++k) {
    stages.push_back(static_cast<int>(std::lround(static_cast<double>(last) * k / stage_count)));
  }
  return stages;
}

std::vector<int> even_in_growth(const std::vector<HistoryPoint>& history, int first_count, int final_count) {
  std::vector<int> stages;
  for (int k = 1; k <= stage_count; ++k) {
    const double wanted = first_count + static_cast<double>(final_count - first_count) * k / stage_count;
    const auto reached = std::find_if(history.begin(), history.end(),
                                      [&](const HistoryPoint& point) { return point.cracks() >= wanted; });
    stages.push_back(static_cast<int>(reached - history.begin()));
  }
  stages.back() = static_cast<int>(history.size()) - 1;
  return stages;
}

}  // namespace

std::vector<HistoryPoint> read_history(const RunFolder& run) {
  std::vector<HistoryPoint> history;
  extend_history(run, history);
  return history;
}

void extend_history(const RunFolder& run, std::vector<HistoryPoint>& history) {
  const auto first = history.empty() ? run.discs.begin() : run.discs.upper_bound(history.back().number);
  for (auto found = first; found != run.discs.end(); ++found) {
    history.push_back(read_point(run, found->first, found->second));
  }
}

HistoryPoint history_point(const RunFolder& run, std::int64_t number) {
  if (number < 0) number = run.discs.rbegin()->first;
  const SeriesFile* discs = file_of(run.discs, number);
  if (discs == nullptr) fail_argument("the run has no snapshot " + std::to_string(number));
  return read_point(run, number, *discs);
}

std::vector<int> growth_stages(const std::vector<HistoryPoint>& history) {
  const int last = static_cast<int>(history.size()) - 1;
  std::vector<int> stages;
  if (last < stage_count) {  // too few to choose from
    for (int i = 0; i <= last; ++i) stages.push_back(i);
    return stages;
  }
  stages = even_in_time(last);
  const int first_count = history.front().cracks();
  const int final_count = history.back().cracks();
  if (final_count <= first_count) return stages;
  bool grows = history[stages.front()].cracks() > first_count;
  for (std::size_t i = 1; i < stages.size(); ++i) {
    grows = grows && history[stages[i]].cracks() > history[stages[i - 1]].cracks();
  }
  if (grows) return stages;
  stages = even_in_growth(history, first_count, final_count);
  spread(stages, last);
  return stages;
}

}  // namespace hfrac::viz
