// SPDX-License-Identifier: BSD-3-Clause
// What a fall-off is read from: time, rate and pressure of a well, as a run folder's history.csv or a field's record has them, and
// where in it the well was shut in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace hfrac::command {

struct InjectionRecord {
  std::vector<double> time;      ///< [s] rising
  std::vector<double> rate;      ///< [m2/s] from this row to the next; empty: not known
  std::vector<double> pressure;  ///< [Pa] at this time

  /** Of the largest rate: less is a pump at rest. */
  static constexpr double still = 0.01;
  /** [m2/s] */
  double largest_rate() const;
};

/** A run folder (its first well), or a record or a case file that names one as hfrac_read_record takes it; rates of the whole thickness [m] are divided by it.
 * Throws BadInput. */
InjectionRecord read_injection(const std::filesystem::path& source, double thickness);

/** The measured pressures as a table, "time_s,pressure_Pa", which is a record again. */
std::string pressures_as_csv(const InjectionRecord& record);

/** That table of the record that a case file names; empty: it names none, or one without pressures. Throws BadInput. */
std::string pressures_of_case(const std::string& case_file);

/** Two pressures over one time. */
struct RecordComparison {
  std::string table;  ///< "series,time_s,pressure_Pa", both thinned to what paper can show
  double mean = 0.0,
         rms =
             0.0;   ///< [Pa] computed less measured at the measured times, between its rows by straight lines
  size_t rows = 0;  ///< of the measured record within the computed time
};
RecordComparison compare_records(const InjectionRecord& measured, const InjectionRecord& computed);

/** The injection before a shut-in and the fall-off after it, as rows of the record. */
struct ShutIn {
  std::size_t begin = 0;  ///< first row of the injection
  std::size_t row = 0;    ///< from this row on the well is shut
  std::size_t end = 0;    ///< one past the fall-off's last row
};

/** At the last row at which the pump stops, or at the first row from `time` [s] on if that is a number. The fall-off ends where fluid goes
 * in or out again. Throws BadInput if there is none. */
ShutIn find_shut_in(const InjectionRecord& record, double time = std::numeric_limits<double>::quiet_NaN());

}  // namespace hfrac::command
