// SPDX-License-Identifier: BSD-3-Clause
// Seismic events as QuakeML 1.2, basic event description (Euchner and Schorlemmer 2013): what seismologists' programs read.
//
// A model knows metres and seconds; QuakeML wants latitude, longitude and a date. The reference point is the model's (0, 0), the plane is
// horizontal at one depth, and degrees are metres over the mean radius of the earth (6 371 008.8 m, Moritz 2000), those of longitude over the cosine of the
// reference's latitude too: over a kilometre that is right to some metres away from the poles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run/engine_call.hpp"

namespace hfrac::output {

struct EarthPlace {
  double latitude = 0.0, longitude = 0.0;  ///< [degree] of the model's (0, 0), north and east positive
  double depth = 0.0;                      ///< [m] of its plane
  double azimuth = 90.0;                   ///< [degree] of its x axis, from north clockwise
  int64_t start = 0;                       ///< [s] since 1970-01-01T00:00:00Z, when the model's time is 0
};

/** "2026-05-01T12:00:00Z" as seconds since 1970. Throws std::invalid_argument with what would be right. */
int64_t seconds_of_date(const std::string& date);

/** A QuakeML document of the events that have a magnitude. `name` goes into its identifiers. */
std::string quakeml_text(const std::vector<hfrac_event>& events, const EarthPlace& place,
                         const std::string& name);

}  // namespace hfrac::output
