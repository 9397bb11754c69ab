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
// All bonds, broken ones too, one per cell of the file.
std::vector<Segment> read_bond_lines(const SeriesFile& file);
// An array of the discs, `components` values per disc.
std::vector<double> read_disc_array(const SeriesFile& file, const char* name, std::size_t components);

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
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  Point middle() const { return {(left + right) / 2, (bottom + top) / 2}; }
};

}  // namespace hfrac::viz
