// SPDX-License-Identifier: BSD-3-Clause
// The log of broken bonds. It only grows.
//
// What joints broke before anything moved has nothing to tell but its bond, and thousands of joints break tens of thousands of bonds:
// such records at the log's beginning are kept short, and whoever reads gets a whole one.
#pragma once

#include <cstdint>
#include <vector>

#include "model/log_iterator.hpp"

namespace hfrac {

enum class CrackMode : std::int32_t { tension = 1, shear = 2 };

struct Crack {
  std::int64_t bond = 0;
  std::int64_t step = 0;      // 0: during the initial equilibration
  std::int64_t cycle = 0;     // mechanical cycle since creation
  double time = 0.0;          // s
  double normal_force = 0.0;  // N at failure, tension positive; of a bond that softened: where it began to
  double shear_force = 0.0;   // N, likewise
  double energy = 0.0;        // J/m, elastic, of the bond at failure; what softening took with it
  double released = 0.0;      // J/m, lost by bond and contact together; for the balance of its step
  CrackMode mode = CrackMode::tension;
  std::int32_t fracture = -1;  // when last found
};

class CrackLog {
 public:
  using value_type = Crack;

  [[nodiscard]] std::size_t size() const { return from_start_.size() + broken_.size(); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Crack operator[](std::size_t c) const {
    if (c >= from_start_.size()) return broken_[c - from_start_.size()];
    Crack crack;
    crack.bond = from_start_[c].bond;
    crack.mode = CrackMode::shear;
    crack.fracture = from_start_[c].fracture;
    return crack;
  }
  [[nodiscard]] Crack front() const { return (*this)[0]; }
  [[nodiscard]] LogIterator<CrackLog> begin() const { return {this, 0}; }
  [[nodiscard]] LogIterator<CrackLog> end() const { return {this, size()}; }

  // Of a bond that broke since this log was made or loaded, not of one that a joint broke.
  [[nodiscard]] Crack& back() { return broken_.back(); }
  [[nodiscard]] Crack& since_start(std::size_t c) { return broken_[c - from_start_.size()]; }
  void set_fracture(std::size_t c, std::int32_t fracture) {
    (c < from_start_.size() ? from_start_[c].fracture : since_start(c).fracture) = fracture;
  }

  void push_back(const Crack& crack) { broken_.push_back(crack); }
  void append(const std::vector<Crack>& cracks) {
    broken_.insert(broken_.end(), cracks.begin(), cracks.end());
  }
  // Of bonds that joints broke; before any other breaks.
  void reserve_from_start(std::size_t count) { from_start_.reserve(count); }
  void push_from_start(std::int64_t bond) { from_start_.push_back({static_cast<std::int32_t>(bond), -1}); }
  // As it was read from an image.
  void load(const Crack& crack) {
    if (broken_.empty() && is_plain(crack))
      push_from_start(crack.bond);
    else
      push_back(crack);
  }
  // To no more than there are.
  void cut(std::size_t count) {
    broken_.resize(count > from_start_.size() ? count - from_start_.size() : 0);
    if (count < from_start_.size()) from_start_.resize(count);
  }
  void clear() { cut(0); }

 private:
  struct FromStart {
    std::int32_t bond, fracture;
  };
  [[nodiscard]] static bool is_plain(const Crack& c) {
    return c.step == 0 && c.cycle == 0 && c.time == 0.0 && c.normal_force == 0.0 && c.shear_force == 0.0 &&
           c.energy == 0.0 && c.released == 0.0 && c.mode == CrackMode::shear;
  }
  std::vector<FromStart> from_start_;
  std::vector<Crack> broken_;
};

}  // namespace hfrac
