// SPDX-License-Identifier: BSD-3-Clause
#include "command/step_rate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "command/least_squares.hpp"

namespace hfrac::command {
namespace {

constexpr double kSameRate = 0.04;      // of the largest rate: less is no step
constexpr double kShortestStep = 0.02;  // of the injection's time
constexpr std::size_t kFewestSteps = 4;
constexpr double kFlatter = 0.8;  // of the first line's slope: the second line is flatter than that

/** The rows at which the rate changes and stays changed for three rows, or to the end. */
std::vector<std::size_t> step_rows(const InjectionRecord& record, const ShutIn& shut_in) {
  const double same = kSameRate * record.largest_rate();
  std::vector<std::size_t> rows{shut_in.begin};
  double sum = record.rate[shut_in.begin], count = 1.0;
  for (std::size_t row = shut_in.begin + 1; row < shut_in.row; ++row) {
    bool changed = true;
    for (std::size_t next = row; next < std::min(row + 3, shut_in.row); ++next)
      changed = changed && std::abs(record.rate[next] - sum / count) > same;
    if (changed) {
      rows.push_back(row);
      sum = count = 0.0;
    }
    sum += record.rate[row];
    count += 1.0;
  }
  rows.push_back(shut_in.row);
  return rows;
}

RateStep rate_step(const InjectionRecord& record, std::size_t first, std::size_t end) {
  RateStep step{record.time[first], record.time[end], 0.0, 0.0};
  double volume = 0.0, sum = 0.0, count = 0.0;
  for (std::size_t row = first; row < end; ++row)
    volume += record.rate[row] * (record.time[row + 1] - record.time[row]);
  step.rate = volume / (step.end - step.begin);
  for (std::size_t row = first + 1; row <= end;
       ++row) {  // the row of the next step is the last of this one's pressures
    if (record.time[row] < step.end - 0.1 * (step.end - step.begin)) continue;
    sum += record.pressure[row];
    count += 1.0;
  }
  step.pressure = sum / count;
  return step;
}

}  // namespace

StepRateReading read_step_rate(const InjectionRecord& record, const ShutIn& shut_in) {
  StepRateReading reading;
  if (record.rate.empty()) return reading;
  const auto rows = step_rows(record, shut_in);
  const double shortest = kShortestStep * (record.time[shut_in.row] - record.time[shut_in.begin]);
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const RateStep step = rate_step(record, rows[k], rows[k + 1]);
    if (step.end - step.begin < shortest) continue;  // on the way from one step to the next
    if (!reading.steps.empty() && step.rate <= reading.steps.back().rate) break;
    reading.steps.push_back(step);
  }
  const std::size_t count = reading.steps.size();
  if (count < kFewestSteps) {
    reading.steps.clear();
    return reading;
  }
  std::vector<double> rates, pressures;
  for (const RateStep& step : reading.steps) {
    rates.push_back(step.rate);
    pressures.push_back(step.pressure);
  }
  const RowSums sums(rates, pressures);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t split = 2; split + 2 <= count; ++split) {
    const FittedLine before = sums.line(0, split), after = sums.line(split, count);
    if (before.slope <= 0.0 || after.slope >= kFlatter * before.slope) continue;
    const double rate = (after.at_zero - before.at_zero) / (before.slope - after.slope);
    const bool between = rate >= rates[split - 2] && rate <= rates[split + 1];
    if (!between || before.squares + after.squares >= least) continue;
    least = before.squares + after.squares;
    reading.rate = rate;
    reading.pressure = before.at_zero + before.slope * rate;
    reading.slope_before = before.slope;
    reading.slope_after = after.slope;
  }
  if (!reading.pressure)
    reading.note =
        "no pressure of extension: the pressures at the ends of the steps lie on no two lines of which the "
        "second is "
        "flatter by a fifth";
  return reading;
}

}  // namespace hfrac::command
