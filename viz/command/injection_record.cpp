// SPDX-License-Identifier: BSD-3-Clause
#include "command/injection_record.hpp"

#include <fmt/format.h>
#include <hfrac/hfrac.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "command/exit_code.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"
#include "run/table_file.hpp"

namespace hfrac::command {
namespace {

InjectionRecord history_of(const std::filesystem::path& folder) {
  const auto file = folder / "history.csv";
  if (!run::is_file(file))
    throw BadInput(fmt::format("'{}' is not a run folder: it has no history.csv", folder.string()));
  try {
    const run::TableFile table(file);
    InjectionRecord record{table.numbers("time_s"), table.numbers("well_rate_m2_per_s"),
                           table.numbers("well_pressure_Pa")};
    // A row tells the rate of the step before it; moved up it holds until the next row.
    if (!record.rate.empty()) {
      record.rate.erase(record.rate.begin());
      record.rate.push_back(record.rate.empty() ? 0.0 : record.rate.back());
    }
    return record;
  } catch (const run::ReadError& error) {
    throw BadInput(error.what());
  }
}

/** Pressures may be NaN, rates none. */
InjectionRecord rows_of_field(const std::string& file, double thickness) {
  int64_t count = 0;
  const auto read = [&](double* rows) {
    if (hfrac_read_record(file.c_str(), thickness, rows, count, &count) < 0)
      throw BadInput(run::error_text(-1, nullptr) + " (docs/records.md#the-table)");
  };
  read(nullptr);
  std::vector<double> rows(3 * static_cast<size_t>(count));
  read(rows.data());
  InjectionRecord record;
  for (size_t k = 0; k + 2 < rows.size(); k += 3) {
    record.time.push_back(rows[k]);
    record.rate.push_back(rows[k + 1]);
    record.pressure.push_back(rows[k + 2]);
  }
  if (count > 0 && std::isnan(record.rate.front())) record.rate.clear();
  return record;
}

InjectionRecord table_of_field(const std::string& file, double thickness) {
  auto record = rows_of_field(file, thickness);
  if (record.time.empty())
    throw BadInput(fmt::format("no well of '{}' has a schedule_file, which would be its record", file));
  if (std::isnan(record.pressure.front()))
    throw BadInput(
        fmt::format("'{}' has no column of pressure (pressure_Pa, pressure_kPa, pressure_MPa or "
                    "pressure_bar), which is what is "
                    "analysed",
                    file));
  return record;
}

}  // namespace

double InjectionRecord::largest_rate() const {
  double largest = 0.0;
  for (const double one : rate) largest = std::max(largest, std::abs(one));
  return largest;
}

InjectionRecord read_injection(const std::filesystem::path& source, double thickness) {
  std::error_code error;
  auto record = std::filesystem::is_directory(source, error) ? history_of(source)
                                                             : table_of_field(source.string(), thickness);
  for (size_t k = 0; k < record.time.size(); ++k)
    if (!std::isfinite(record.pressure[k]) || (!record.rate.empty() && !std::isfinite(record.rate[k])))
      throw BadInput(fmt::format("'{}' has no pressure or rate at {:g} s", source.string(), record.time[k]));
  if (record.time.size() < 2)
    throw BadInput(
        fmt::format("'{}' has {} rows; an injection has two at least", source.string(), record.time.size()));
  return record;
}

ShutIn find_shut_in(const InjectionRecord& record, double time) {
  const size_t rows = record.time.size();
  const double least = InjectionRecord::still * record.largest_rate();
  const auto pumps = [&](size_t row) { return record.rate.empty() || record.rate[row] > least; };
  ShutIn found;
  if (!std::isnan(time)) {
    const auto at = std::lower_bound(record.time.begin(), record.time.end(), time);
    found.row = static_cast<size_t>(at - record.time.begin());
    if (found.row == 0 || found.row == rows)
      throw BadInput(fmt::format("--shut-in {:g} s is not inside the record, {:g} to {:g} s", time,
                                 record.time.front(), record.time.back()));
  } else {
    if (record.rate.empty())
      throw BadInput(
          "the record has no column of rate; say with --shut-in SECONDS when the well was shut in");
    for (size_t row = 1; row < rows; ++row)
      if (pumps(row - 1) && !pumps(row)) found.row = row;
    if (found.row == 0)
      throw BadInput(
          "the record has no shut-in: its rate never falls from above to below a hundredth of the largest; "
          "--shut-in SECONDS says where it is");
  }
  found.begin = found.row;
  while (found.begin > 0 && pumps(found.begin - 1)) --found.begin;
  if (found.begin == found.row)
    throw BadInput(
        fmt::format("nothing is injected before {:g} s, where --shut-in is", record.time[found.row]));
  found.end = found.row + 1;
  while (found.end < rows && (record.rate.empty() || std::abs(record.rate[found.end]) <= least)) ++found.end;
  return found;
}

std::string pressures_as_csv(const InjectionRecord& record) {
  std::string table = "time_s,pressure_Pa\n";
  for (size_t k = 0; k < record.time.size(); ++k)
    fmt::format_to(std::back_inserter(table), "{},{}\n", record.time[k], record.pressure[k]);
  return table;
}

std::string pressures_of_case(const std::string& case_file) {
  const auto record = rows_of_field(case_file, 1.0);
  const bool none = record.time.empty() || std::isnan(record.pressure.front());
  return none ? std::string() : pressures_as_csv(record);
}

RecordComparison compare_records(const InjectionRecord& measured, const InjectionRecord& computed) {
  RecordComparison both;
  both.table = "series,time_s,pressure_Pa\n";
  constexpr size_t most_points = 1500;
  for (const auto& [name, record] : {std::pair{"measured", &measured}, {"computed", &computed}}) {
    const size_t stride = std::max<size_t>(1, record->time.size() / most_points);
    for (size_t k = 0; k < record->time.size(); k += stride)
      both.table += fmt::format("{},{},{}\n", name, record->time[k], record->pressure[k]);
  }
  for (size_t k = 0; k < measured.time.size(); ++k) {
    const double time = measured.time[k];
    if (time < computed.time.front() || time > computed.time.back()) continue;
    const auto after = std::lower_bound(computed.time.begin(), computed.time.end(), time);
    const auto j = static_cast<size_t>(after - computed.time.begin());
    double pressure = computed.pressure[j];
    if (j > 0) {
      const double share = (time - computed.time[j - 1]) / (computed.time[j] - computed.time[j - 1]);
      pressure = (1.0 - share) * computed.pressure[j - 1] + share * pressure;
    }
    const double off = pressure - measured.pressure[k];
    both.mean += off;
    both.rms += off * off;
    ++both.rows;
  }
  if (both.rows > 0) {
    both.mean /= static_cast<double>(both.rows);
    both.rms = std::sqrt(both.rms / static_cast<double>(both.rows));
  }
  return both;
}

}  // namespace hfrac::command
