// SPDX-License-Identifier: BSD-3-Clause
#include "flow/wellbore_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hfrac {
namespace {

constexpr int most_rounds_of_pressure = 200;

}  // namespace

void WellboreFlow::begin(const Wellbore& wellbore, double duration, double floor) {
  wellbore_ = &wellbore;
  duration_ = duration;
  floor_ = floor;
  start_ = pressure_ = wellbore.pressure;
  answer_.assign(wellbore.clusters.size(), {0.0, 0.0});
}

double WellboreFlow::surplus(double pressure, std::span<const double> hole) {
  const Wellbore& w = *wellbore_;
  double sum = w.storage * (pressure - start_) - duration_ * w.rate, slope = 0.0;
  for (std::size_t k = 0; k < hole.size(); ++k) {
    answer_[k] = w.clusters[k].friction.respond(pressure - hole[k]);
    sum += duration_ * answer_[k].rate;
    slope += answer_[k].slope;
  }
  const double all = w.storage + duration_ * slope;
  shared_ = all > 0.0 ? duration_ / all : 0.0;
  return sum;
}

double WellboreFlow::balanced_pressure(std::span<const double> hole) {
  const Wellbore& w = *wellbore_;
  if (hole.size() == 1 && w.storage == 0.0) return hole[0] + w.clusters[0].friction.drop(w.rate);
  double low = *std::min_element(hole.begin(), hole.end()),
         high = *std::max_element(hole.begin(), hole.end());
  if (w.storage > 0.0) {
    low = std::min(low, start_);
    high = std::max(high, start_);
  }
  double most = 1.0;
  for (const auto& cluster : w.clusters) most = std::max(most, cluster.friction.drop(std::abs(w.rate)));
  low -= most;
  high += most;
  double p = std::clamp(pressure_, low, high);
  for (int k = 0; k < most_rounds_of_pressure; ++k) {
    const double off = surplus(p, hole);
    (off > 0.0 ? high : low) = p;
    if (off == 0.0) break;
    double next = p - off * shared_ / duration_;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == p || high - low <= 2.0 * std::numeric_limits<double>::epsilon() * std::abs(p)) break;
    p = next;
  }
  return p;
}

void WellboreFlow::solve(std::span<const double> hole) {
  const Wellbore& w = *wellbore_;
  pressure_ = w.held ? w.pressure : balanced_pressure(hole);
  held_ = w.held || pressure_ < floor_;
  pressure_ = std::max(pressure_, floor_);
  surplus(pressure_, hole);
  if (held_) shared_ = 0.0;
  if (held_ || w.storage > 0.0) return;
  // Without storage all that is pumped goes out: what rounding leaves, through the cluster that takes most.
  double left = w.rate;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < answer_.size(); ++k) {
    left -= answer_[k].rate;
    if (std::abs(answer_[k].rate) > std::abs(answer_[largest].rate)) largest = k;
  }
  answer_[largest].rate += left;
}

void WellboreFlow::answer_by_chords(std::span<const double> hole) {
  double slope = 0.0;
  for (std::size_t k = 0; k < hole.size(); ++k) {
    const double drop = pressure_ - hole[k];
    if (drop != 0.0) answer_[k].slope = std::max(answer_[k].slope, answer_[k].rate / drop);
    slope += answer_[k].slope;
  }
  const double all = wellbore_->storage + duration_ * slope;
  shared_ = held_ || !(all > 0.0) ? 0.0 : duration_ / all;
}

double WellboreFlow::by_pressure(std::size_t i, std::size_t j) const {
  return (i == j ? -answer_[i].slope : 0.0) + answer_[i].slope * answer_[j].slope * shared_;
}

void WellboreFlow::keep(Wellbore& w) const {
  double out = 0.0;
  for (std::size_t k = 0; k < answer_.size(); ++k) {
    w.clusters[k].rate = answer_[k].rate;
    out += duration_ * answer_[k].rate;
  }
  const double before = w.content;
  double pumped = duration_ * w.rate;
  if (held_) {
    w.content = w.storage * (pressure_ - w.start_pressure);
    pumped = out + w.content - before;
  } else if (w.storage > 0.0) {
    w.content += pumped - out;
  }
  w.pressure = !held_ && w.storage > 0.0 ? w.start_pressure + w.content / w.storage : pressure_;
  w.pumped += pumped;
  w.taken += pumped;
}

}  // namespace hfrac
