// SPDX-License-Identifier: BSD-3-Clause
// The log of what smooth joints slipped. It only grows.
//
// A contact gets an entry once its slip has gone on by `logged_slip` since its last one, and no more than one for each increment
// of a step. So the entries of a contact sum up to its slip, to within that, however short the increments are, and how long the log can
// grow is ruled by how far joints slip and not by how long a run takes.
#pragma once

#include <cstdint>
#include <vector>

#include "model/log_iterator.hpp"

namespace hfrac {

// Of the mean disc diameter. With a shear modulus of 30 GPa a single contact that slipped so far lost some 0.3 MPa of shear
// stress (of the order G slip / length, Kanamori and Anderson 1975), at the lower end of what earthquakes lose.
inline constexpr double logged_slip = 1e-5;

struct Slip {
  std::int64_t bond = 0;
  std::int64_t step = 0;  // 0: during the initial equilibration
  double time = 0.0;      // s, at the end of the increment in which it was found
  double duration = 0.0;  // s, of that increment
  double slip = 0.0;      // m, since the contact's last entry; sign as Assembly::slip
};

// What the entries of an increment have in common is kept once.
class SlipLog {
 public:
  using value_type = Slip;

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] Slip operator[](std::size_t k) const {
    const Entry& entry = entries_[k];
    const Increment& at = increments_[static_cast<std::size_t>(entry.increment)];
    return {entry.bond, at.step, at.time, at.duration, entry.slip};
  }
  [[nodiscard]] LogIterator<SlipLog> begin() const { return {this, 0}; }
  [[nodiscard]] LogIterator<SlipLog> end() const { return {this, size()}; }

  void push_back(const Slip& slip) {
    const Increment at{slip.step, slip.time, slip.duration};
    if (increments_.empty() || increments_.back() != at) increments_.push_back(at);
    entries_.push_back(
        {static_cast<std::int32_t>(slip.bond), static_cast<std::int32_t>(increments_.size() - 1), slip.slip});
  }
  void load(const Slip& slip) { push_back(slip); }
  void reserve(std::size_t count) { entries_.reserve(count); }
  // To no more than there are.
  void cut(std::size_t count) {
    entries_.resize(count);
    increments_.resize(empty() ? 0 : static_cast<std::size_t>(entries_.back().increment) + 1);
  }
  void clear() { cut(0); }

 private:
  struct Increment {
    std::int64_t step;
    double time, duration;
    bool operator==(const Increment&) const = default;
  };
  struct Entry {
    std::int32_t bond, increment;
    double slip;
  };
  std::vector<Increment> increments_;
  std::vector<Entry> entries_;
};

}  // namespace hfrac
