// SPDX-License-Identifier: BSD-3-Clause
#include "lab/loading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hfrac {
namespace {

using End = EquilibriumSolver::End;
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double intact = 1.0 - 1e-12;  // below it no bond breaks
constexpr double longest = 0.2;         // share of the load of the foreseen break that one step may add
constexpr double no_failure = 30.0;     // loads at the first break, beyond which the test is over
constexpr std::size_t most_points = 20000;

void record(LoadingResult& result, const Specimen& specimen, const Loading& loading, double load,
            double excess) {
  const Strain strain = specimen.strain();
  const double stress = loading.stress();
  result.curve.push_back({load, stress, strain.axial, strain.lateral, excess,
                          specimen.cracks_in(CrackMode::tension), specimen.cracks_in(CrackMode::shear)});
  if (stress > result.peak) {
    result.peak = stress;
    result.strain_at_peak = strain.axial;
  }
}

// Rock that softens has equilibria that no way leads to: Newton's method may find one, and then energy came from nowhere.
bool gains_energy(const Specimen& specimen, const Specimen::Account& start) {
  if (specimen.shape().wet) return false;  // a fluid's work is not counted
  const Specimen::Account now = specimen.account();
  return -now.lost_since(start) > 0.02 * (now.taken - start.taken) + 1e-6 * now.stored;
}

LoadingResult follow_softening(Specimen& specimen, const Loading& loading,
                               const std::function<bool()>& interrupt) {
  LoadingResult result;
  double load = 0.0, step = loading.first, even = 0.0;
  std::size_t before = 0;
  bool ran_away = false;
  const auto watch = [&] {
    ran_away = static_cast<std::int64_t>(specimen.cracks().size() - before) > loading.runaway;
    return ran_away || (interrupt && interrupt());
  };
  const auto ended = [&](TestEnd end) {
    result.end = end;
    return result;
  };
  while (result.curve.size() < most_points) {
    if (interrupt && interrupt()) return ended(TestEnd::stopped);
    before = specimen.cracks().size();
    specimen.keep();
    const Specimen::Account start = specimen.account();
    if (loading.most > 0.0) step = std::min(step, loading.most - load);
    EquilibriumSolver::Outcome outcome;
    for (std::size_t broken = before;;) {  // a fluid follows the crack by apply() alone
      loading.apply(load + step);
      outcome = specimen.solve(unlimited, watch);
      if (outcome.end != End::rest || specimen.cracks().size() == broken) break;
      broken = specimen.cracks().size();
    }
    if (outcome.end == End::stopped && !ran_away) return ended(TestEnd::stopped);
    if (outcome.end != End::rest || gains_energy(specimen, start)) {
      specimen.go_back();
      if (even == 0.0) even = loading.soft_step * (load + step);
      if (step > even / 12.0) {
        step *= 0.5;
        continue;
      }
      loading.apply(load + step);
      outcome = specimen.settle(watch);
      if (outcome.end == End::stopped && !ran_away) return ended(TestEnd::stopped);
      if (outcome.end != End::rest)
        return ended(loading.constant || ran_away ? TestEnd::failed : TestEnd::no_equilibrium);
    }
    load += step;
    result.force_ratio = std::max(result.force_ratio, outcome.force_ratio);
    record(result, specimen, loading, load, outcome.excess);
    if (before == 0 && !specimen.cracks().empty()) result.first_crack = loading.stress();
    if (result.curve.back().stress < loading.end_share * result.peak) return ended(TestEnd::failed);
    if (loading.most > 0.0 && load >= loading.most * (1.0 - 1e-12)) return ended(TestEnd::load_reached);
    const double stress = even > 0.0 ? 1.0 : specimen.largest_stress();
    if (stress >= 0.95) {
      if (even == 0.0) even = loading.soft_step * load;
      step = std::min(even, 2.0 * step);
    } else {
      step = stress > 0.0 ? load * std::clamp(0.97 / stress - 1.0, loading.soft_step, 1e6) : load;
    }
  }
  return ended(TestEnd::no_equilibrium);
}

}  // namespace

LoadingResult load_to_failure(Specimen& specimen, const Loading& loading,
                              const std::function<bool()>& interrupt) {
  if (specimen.softens()) return follow_softening(specimen, loading, interrupt);
  LoadingResult result;
  double load = 0.0, step = loading.first, excess = 0.0, load_at_first = 0.0;
  const auto ended = [&](TestEnd end) {
    result.end = end;
    return result;
  };
  bool ran_away = false;
  std::size_t before = 0;
  const auto watch = [&] {
    ran_away = static_cast<std::int64_t>(specimen.cracks().size() - before) > loading.runaway;
    return ran_away || (interrupt && interrupt());
  };
  const auto cut_short = [&] { return ended(ran_away ? TestEnd::failed : TestEnd::stopped); };
  while (result.curve.size() < most_points) {
    before = specimen.cracks().size();
    if (interrupt && interrupt()) return ended(TestEnd::stopped);
    if (loading.most > 0.0) step = std::min(step, loading.most - load);
    loading.apply(load + step);
    auto outcome = specimen.solve(intact, watch);
    if (outcome.end == End::stopped) return cut_short();
    if (outcome.end == End::not_converged) return ended(TestEnd::no_equilibrium);
    const double least = loading.least * (load + step);
    if (outcome.excess > 1.0 + loading.overshoot && step > 1.01 * least) {
      const double share = (1.0 + 0.5 * loading.overshoot - excess) / (outcome.excess - excess);
      step = std::max(least, step * std::clamp(share, 0.05, 0.9));
      continue;
    }
    load += step;
    excess = outcome.excess;
    result.force_ratio = std::max(result.force_ratio, outcome.force_ratio);
    record(result, specimen, loading, load, excess);
    if (excess >= intact) {
      if (result.curve.back().stress >= result.peak)
        result.worst_overshoot = std::max(result.worst_overshoot, excess - 1.0);
      if (specimen.cracks().empty()) {
        result.first_crack = result.curve.back().stress;
        load_at_first = load;
      }
      // Where a fluid follows the crack, its pressure does so only by apply().
      for (std::size_t broken = before;;) {
        outcome = specimen.solve(unlimited, watch);
        if (outcome.end != End::rest || specimen.cracks().size() == broken) break;
        broken = specimen.cracks().size();
        loading.apply(load);
      }
      if (outcome.end == End::stopped) return cut_short();
      if (outcome.end != End::rest)
        return ended(loading.constant ? TestEnd::failed : TestEnd::no_equilibrium);
      result.force_ratio = std::max(result.force_ratio, outcome.force_ratio);
      excess = specimen.largest_excess();
      record(result, specimen, loading, load, excess);
      if (result.curve.back().stress < loading.end_share * result.peak) return ended(TestEnd::failed);
    }
    if (loading.most > 0.0 && load >= loading.most * (1.0 - 1e-12)) return ended(TestEnd::load_reached);
    if (load_at_first > 0.0 && load > no_failure * load_at_first) return ended(TestEnd::load_reached);
    // The next break, if stresses grow with the load; a little beyond it, so that it is a break.
    const double ahead = excess > 0.0 ? load * (1.0 + 0.2 * loading.overshoot - excess) / excess : load;
    const double foreseen = excess > 0.0 ? load / excess : 2.0 * load;
    step = std::clamp(ahead, loading.least * load, std::max(longest * foreseen, loading.least * load));
  }
  return ended(TestEnd::no_equilibrium);
}

}  // namespace hfrac
