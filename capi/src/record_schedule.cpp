// SPDX-License-Identifier: BSD-3-Clause
// Thinning a record. An entry of a schedule is a straight piece of the volume injected over time. The whole record is one piece at first;
// a piece off which the volume lies by more than is allowed is divided at the row farthest from it (Ramer 1972; Douglas and Peucker
// 1973), which is a change of rate where there is one. Pieces begin and end on the record's own volume, so nothing adds up.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "record.hpp"

namespace hfrac::capi {
namespace {

constexpr double still = 0.01;  // of the largest rate: less is a pump at rest
constexpr int most_halvings =
    40;  // divisions at the farthest row; further ones at the middle bound the time for any record

class Entries {
 public:
  explicit Entries(WellControl control) : control_(control) {}
  // One that repeats the one before is none.
  void add(double time, double value) {
    if (list_.empty() || list_.back().value != value)
      list_.push_back({0, time, value, static_cast<std::int64_t>(control_)});
  }
  std::vector<ScheduleEntry> take() { return std::move(list_); }

 private:
  WellControl control_;
  std::vector<ScheduleEntry> list_;
};

class Volume {
 public:
  Volume(const Record& record, double share) : time_(record.time), rate_(record.rate) {
    injected_.assign(time_.size(), 0.0);
    double flowed = 0.0;  // in and out
    for (std::size_t k = 1; k < time_.size(); ++k) {
      const double part = rate_[k - 1] * (time_[k] - time_[k - 1]);
      injected_[k] = injected_[k - 1] + part;
      flowed += std::abs(part);
    }
    allowed_ = share * flowed;
    for (const double rate : rate_) largest_ = std::max(largest_, std::abs(rate));
  }

  // Adds the rows between `first` and `end`, and `end`, at which pieces end.
  void divide(std::size_t first, std::size_t end, int depth, std::vector<std::size_t>& ends) const {
    const Farthest row = farthest(first, end);
    if (row.distance > allowed_) {
      const std::size_t at = depth < most_halvings ? row.row : std::midpoint(first, end);
      divide(first, at, depth + 1, ends);
      divide(at, end, depth + 1, ends);
    } else {
      ends.push_back(end);
    }
  }

  // Whether the pump starts, stops or turns round at this row; with nothing allowed, whether its rate changes at all.
  [[nodiscard]] bool turns(std::size_t row) const {
    return way(row) != way(row - 1) || (allowed_ == 0.0 && rate_[row] != rate_[row - 1]);
  }

  // Of the piece from one row to another [m2/s]: to the last bit what the rows say where they agree.
  [[nodiscard]] double value(std::size_t first, std::size_t end) const {
    return agree(first, end) ? rate_[first] : mean_rate(first, end);
  }

 private:
  struct Farthest {
    std::size_t row = 0;
    double distance = 0.0;  // m2
  };
  [[nodiscard]] Farthest farthest(std::size_t first, std::size_t end) const {
    Farthest found{first, 0.0};
    if (agree(first, end)) return found;
    const double mean = mean_rate(first, end);
    for (std::size_t k = first + 1; k < end; ++k) {
      const double off = std::abs(injected_[k] - injected_[first] - mean * (time_[k] - time_[first]));
      if (off > found.distance) found = {k, off};
    }
    return found;
  }
  [[nodiscard]] bool agree(std::size_t first, std::size_t end) const {
    return std::all_of(rate_.begin() + static_cast<std::ptrdiff_t>(first),
                       rate_.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](double rate) { return rate == rate_[first]; });
  }
  [[nodiscard]] double mean_rate(std::size_t first, std::size_t end) const {
    return (injected_[end] - injected_[first]) / (time_[end] - time_[first]);
  }
  [[nodiscard]] int way(std::size_t row) const {
    return rate_[row] > still * largest_ ? 1 : rate_[row] < -still * largest_ ? -1 : 0;
  }

  const std::vector<double>&time_, &rate_;
  std::vector<double> injected_;  // m2, up to each row
  double allowed_ = 0.0, largest_ = 0.0;
};

std::vector<ScheduleEntry> thinned_rates(const Record& record, double share) {
  const Volume volume(record, share);
  const std::size_t last = record.time.size() - 1;
  std::vector<std::size_t> ends{0};
  for (std::size_t row = 1; row <= last; ++row)
    if (row == last || volume.turns(row)) volume.divide(ends.back(), row, 0, ends);
  Entries entries(WellControl::rate);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    entries.add(record.time[ends[k]], volume.value(ends[k], ends[k + 1]));
  entries.add(record.time[last], record.rate[last]);
  return entries.take();
}

std::vector<ScheduleEntry> thinned_pressures(const Record& record, double share) {
  Entries entries(WellControl::pressure);
  const auto [lowest, highest] = std::minmax_element(record.pressure.begin(), record.pressure.end());
  const double allowed = share * (*highest - *lowest);
  for (std::size_t row = 0; row < record.time.size();) {
    double least = record.pressure[row], most = least;
    std::size_t end = row + 1;
    for (; end < record.time.size(); ++end) {
      const double next = record.pressure[end];
      if (std::max(most, next) - std::min(least, next) > 2.0 * allowed) break;
      least = std::min(least, next);
      most = std::max(most, next);
    }
    entries.add(record.time[row], least == most ? least : 0.5 * (least + most));
    row = end;
  }
  return entries.take();
}

}  // namespace

std::vector<ScheduleEntry> thinned(const Record& record, WellControl control, double share) {
  return control == WellControl::rate ? thinned_rates(record, share) : thinned_pressures(record, share);
}

}  // namespace hfrac::capi
