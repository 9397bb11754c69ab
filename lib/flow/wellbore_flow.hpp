// SPDX-License-Identifier: BSD-3-Clause
// How a wellbore's rate divides among its clusters at the pressures of their holes, by the end of an increment of `duration` seconds:
//
//     S (p_b - p_b0) + dt sum q_i = dt Q,      p_b - p_i = drop_i(q_i)          (model/wellbore.hpp)
//
// or, of a wellbore held at a pressure, p_b as given. The left side rises with p_b, so Newton's method between two bounds finds it. What the
// flow solver and the tangent of the coupled equations need is how the rates answer to the holes' pressures,
//     d q_i / d p_j = -g_i (i = j) + g_i g_j dt / (S + dt sum g),       g_i = 1 / drop_i'(q_i):
// symmetric, and 0 for a single cluster without storage.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/wellbore.hpp"

namespace hfrac {

class WellboreFlow {
 public:
  // As the wellbore stands when the increment begins. The pressure does not fall below `floor` [Pa]: a pump that takes out more gets less.
  void begin(const Wellbore& wellbore, double duration, double floor);
  // Of the pressures of the clusters' holes [Pa].
  void solve(std::span<const double> pressure);
  // Rates answer by their chords q_i / dp_i from now to the next solve, where those are steeper.
  void answer_by_chords(std::span<const double> pressure);
  [[nodiscard]] double rate(std::size_t cluster) const { return answer_[cluster].rate; }
  [[nodiscard]] double pressure() const { return pressure_; }
  // d q_i / d p_j [m2/(Pa s)], at the last solve.
  [[nodiscard]] double by_pressure(std::size_t i, std::size_t j) const;
  // The increment is kept: pressure, content, what was pumped, rates.
  void keep(Wellbore& wellbore) const;

 private:
  // Volume that has gone out or is stored less that of the pump, at the pressure [m2]; answers of the clusters with it.
  double surplus(double pressure, std::span<const double> hole);
  // At which both sides agree, of a wellbore that is not held.
  double balanced_pressure(std::span<const double> hole);
  const Wellbore* wellbore_ = nullptr;
  double duration_ = 0.0, floor_ = 0.0, start_ = 0.0, pressure_ = 0.0;
  bool held_ = false;
  double shared_ = 0.0;  // dt / (S + dt sum g), Pa s/m2; 0: held
  std::vector<WellFriction::Response> answer_;
};

}  // namespace hfrac
