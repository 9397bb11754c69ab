// SPDX-License-Identifier: BSD-3-Clause
// The content of the VTU files as plain arrays, checked: every index is in range and every coordinate is
// finite, so that nothing that follows has to ask again.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "run/grid_file.hpp"
#include "run/run_folder.hpp"

namespace hfrac::viz {

using namespace hfrac::run;

struct Segment {
  Point from;
  Point to;
};

struct Disc {
  Point centre;
  double radius = 0;  // [m]
};

struct Discs {
  Moment moment;
  std::vector<Disc> discs;
};

struct Bonds {
  std::vector<Segment> intact;  // between disc centres
};

enum class CrackMode { tension, shear };

struct Crack {
  Segment line;
  CrackMode mode = CrackMode::tension;
  double aperture = 0;   // [m]
  double time = 0;       // [s] of its breaking; 0 if unknown
  std::size_t cell = 0;  // of the file
};

struct Cracks {
  Moment moment;
  std::vector<Crack> cracks;
};

// A bond that holds, and the force across it.
struct BondForce {
  Segment line;
  double normal = 0;  // [N] per thickness, tension positive
};

struct Domain {
  std::uint32_t first_corner = 0;  // in Flow::corners
  std::uint32_t corner_count = 0;
  double pressure = 0;  // [Pa]
  bool well = false;
  std::size_t cell = 0;  // of the file
};

struct Flow {
  std::vector<Domain> domains;
  std::vector<Point> corners;
};

// A value as it can be drawn: 0 for what is no number, or beyond all that is real.
double usable(double value);

// Each throws ReadError if the file is missing or damaged.
Discs read_discs(const SeriesFile& file);
Bonds read_bonds(const SeriesFile& file);
Cracks read_cracks(const SeriesFile& file);
Flow read_flow(const SeriesFile& file);
std::vector<BondForce> read_bond_forces(const SeriesFile& file);
// All bonds, broken ones too, or all contacts of joints: one per cell of the file.
std::vector<Segment> read_lines(const SeriesFile& file);

// The rectangle around places, as they are met.

struct Bounds {
  double left = INFINITY;  // [m]
  double right = -INFINITY;
  double bottom = INFINITY;
  double top = -INFINITY;

  // A circle; a place is one of radius 0.
  void include(Point centre, double radius = 0) {
    left = std::min(left, centre.x - radius);
    right = std::max(right, centre.x + radius);
    bottom = std::min(bottom, centre.y - radius);
    top = std::max(top, centre.y + radius);
  }
  bool empty() const { return !(right >= left); }
  bool meet(const Bounds& other) const {
    return left <= other.right && other.left <= right && bottom <= other.top && other.bottom <= top;
  }
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  Point middle() const { return {(left + right) / 2, (bottom + top) / 2}; }
};

// The run as a whole: what was when, read from the small crack files before anything is drawn.

struct HistoryPoint {
  std::int64_t number = 0;  // of the snapshot
  Moment moment;
  int tensile_cracks = 0;
  int shear_cracks = 0;

  int cracks() const { return tensile_cracks + shear_cracks; }
};

// One point per snapshot of the discs, in order.
std::vector<HistoryPoint> read_history(const RunFolder& run);

// Adds the points of the snapshots that came after the last one of `history`.
void extend_history(const RunFolder& run, std::vector<HistoryPoint>& history);

// The point of one snapshot, -1: of the last. Throws Failure if there is none of that number.
HistoryPoint history_point(const RunFolder& run, std::int64_t number);

// Up to five snapshots (indices into the history) that show how the cracks grew: evenly over the run, as in
// the paper; if the first of them would show no crack, or the cracks stand still in two of them, evenly over
// the growth of the cracks instead.
std::vector<int> growth_stages(const std::vector<HistoryPoint>& history);

}  // namespace hfrac::viz
