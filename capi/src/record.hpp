// SPDX-License-Identifier: BSD-3-Clause
// An injection record as a field's logger writes it: time, rate and pressure, a row each, as the columns of a table. A row's rate and
// pressure hold until the next row, as an entry of a schedule does.
#pragma once

#include <string>
#include <vector>

#include "options/options.hpp"

namespace hfrac::capi {

struct Record {
  std::vector<double> time;      // s, rising
  std::vector<double> rate;      // m2/s, as long as `time`; empty: not asked for, or not in the file
  std::vector<double> pressure;  // Pa, likewise
};

enum class Wish { none, if_there, must };
struct RecordWishes {
  Wish rate = Wish::if_there;
  Wish pressure = Wish::if_there;
  double thickness = 0.0;  // m, by which a rate in m3/s is divided; 0: not known
};

// A comma-separated table with a line of names; columns in any order and among others, empty lines and lines that begin with # are none:
//   time_s, time_min, time_h, time_d        seconds, minutes, hours, days of model time
//   time                                    ISO 8601 (2026-03-01T08:00:00, with Z or +01:00 or neither); the first row is time 0
//   rate_m2_s                               per metre of thickness (also rate_m2_per_s, and so on)
//   rate_m3_s, rate_m3_min, rate_m3_h, rate_L_s, rate_L_min, rate_bbl_min, rate_gal_min   of the whole thickness
//   pressure_Pa, pressure_kPa, pressure_MPa, pressure_bar, pressure_psi
// or a LAS 2.0 file, whose curves are such columns (record_las.hpp).
// At most 1 000 000 rows. Throws Error(case_file) with file, line, fault and what is allowed.
Record read_record(const std::string& path, const RecordWishes& wishes);

// The record as few entries of the schedule of well 0, after its rate or its pressure. `share` bounds what is lost:
//   rate      the volume injected up to any time differs by at most `share` of all that flowed in and out; over the whole it is
//             the same, to rounding. A row at which the pump starts, stops or turns round (a hundredth of the largest rate) always begins an entry.
//   pressure  differs nowhere by more than `share` of the record's range
// With 0 only rows that repeat the one before are left out.
std::vector<ScheduleEntry> thinned(const Record& record, WellControl control, double share);

}  // namespace hfrac::capi
