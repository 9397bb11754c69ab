// SPDX-License-Identifier: BSD-3-Clause
// Reading the pressure after a shut-in: instantaneous shut-in pressure and closure.
//
// While a fracture is open and fluid leaks off by Carter's law, its pressure is a straight line over Nolte's (1979) time
//   G = 4 / pi (g(d) - g(0)),  d = time since shut-in / time of injection
//   g = 4/3 ((1 + d)^1.5 - d^1.5)                              little leaks off while it grows
//   g = (1 + d) asin((1 + d)^-0.5) + d^0.5                     most of it leaks off
// so G dP/dG is a straight line through the origin (Castillo 1987; Barree, Barree and Craig 2009). Closure is read in three ways:
//   where G dP/dG falls below that line for good (the same);
//   where pressure over the square root of time has its inflection (the same);
//   where the pressure begins to fall faster over G, since a fracture stiffens as its faces meet (McClure, Jung, Cramer and Sharma 2016).
// They need not agree, and a record need not hold them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hfrac::command {

enum class LeakOff { little, most };

/** G of a dimensionless time since shut-in. */
double nolte_g(double since, LeakOff leak_off);

struct Falloff {
  double injection = 0.0;        ///< [s] how long fluid went in
  std::vector<double> since;     ///< [s] since shut-in, rising, from 0 on
  std::vector<double> pressure;  ///< [Pa]
};

/** A straight line: pressure at x = 0, and its slope. */
struct StraightLine {
  double start = 0.0;  ///< [Pa]
  double slope = 0.0;  ///< [Pa] over x
};

/** Slopes of the pressure over a coordinate, found around each place by least squares. */
struct Slopes {
  std::vector<double> x, slope, error;  ///< error: standard deviation of the slope
};

struct Closure {
  double since = 0.0;     ///< [s] since shut-in
  double x = 0.0;         ///< G, or the square root of time [s^0.5]
  double pressure = 0.0;  ///< [Pa]
};

struct FalloffReading {
  std::optional<double> isip;  ///< [Pa]
  std::optional<Closure> by_g, by_root, by_stiffness;
  std::optional<StraightLine> line;  ///< of the pressure over G before closure
  Slopes over_g, over_root;          ///< dP/dG, dP/d(sqrt t)
  std::vector<std::string> notes;    ///< why something is not there
};

FalloffReading read_falloff(const Falloff& falloff, LeakOff leak_off);

}  // namespace hfrac::command
