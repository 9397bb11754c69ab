// SPDX-License-Identifier: BSD-3-Clause
// V16  One-dimensional conduction of heat.
//
// Formula    T(x, t) = T0 + (T1 - T0) erfc(x / (2 sqrt(kappa t))), kappa = lambda / (rho c).
// Source     Carslaw and Jaeger, Conduction of Heat in Solids, section 2.5.
// Set-up     Through hfrac.h: a dry block of 2 000, 4 000 and 8 000 discs in 100 m x 100 m, insulated; discs with centre
//            left of 10 m are held 100 K colder from t = 0. lambda is thermal.conductivity; rho c is the discs' own, by their
//            areas over that of the model right of 20 m. 200 steps to each time. Temperature averaged over the discs in
//            bins of 2 m by heat capacity; x counts from the middle between the last held disc and the first free one, mean
//            over the contacts between them.
// Tolerance  rms over the bins 1 % of T1 - T0 at three times (2 sqrt(kappa t) from 10 m to 30 m) from 4 000 discs on, 2 % at 2 000;
//            heat from held discs and heat stored the same to 1e-9.
#include <limits>

#include "heat_support.hpp"

namespace V16_conduction {

using namespace verification;

constexpr double start = 523.15, step_down = -100.0, x0 = 10.0, bin_width = 2.0;

void conduct(int64_t discs, int64_t seed, double tolerance) {
  hfrac::Definition def = warm_block(discs, seed);
  def.thermal_mode = 2;  // transport
  def.thermal_rock_temperature = start;
  HostedSimulation sim(def);
  const auto position = sim.values(HFRAC_DISC_POSITION), radius = sim.values(HFRAC_DISC_RADIUS);
  const std::size_t n = radius.size();
  std::vector<double> x(n), capacity(n), temperature(n, start);
  std::vector<int32_t> held(n, 0);
  double heat = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = position[2 * i];
    capacity[i] = def.disc_density * def.thermal_specific_heat * pi * radius[i] * radius[i];
    if (x[i] > 20.0) heat += capacity[i];
    if (x[i] >= x0) continue;
    held[i] = 1;
    temperature[i] = start + step_down;
  }
  sim.set(temperature);
  sim.hold(held);
  int64_t count = 0;
  sim.check(hfrac_field_copy_i32(sim, HFRAC_BOND_DISCS, nullptr, 0, &count));
  std::vector<int32_t> pairs(static_cast<std::size_t>(count));
  sim.check(hfrac_field_copy_i32(sim, HFRAC_BOND_DISCS, pairs.data(), count, &count));
  double front = 0.0, contacts = 0.0;
  for (std::size_t e = 0; e < pairs.size(); e += 2) {
    const auto i = static_cast<std::size_t>(pairs[e]), j = static_cast<std::size_t>(pairs[e + 1]);
    if (held[i] == held[j]) continue;
    front += held[i] != 0 ? x[i] : x[j];
    contacts += 1.0;
  }
  front /= contacts;
  const double rho_c = heat / (80.0 * 100.0), kappa = def.thermal_conductivity / rho_c;
  std::printf("  %lld discs: rho c %.4g J/(m3 K), kappa %.3e m2/s, front at %.2f m\n",
              static_cast<long long>(discs), rho_c, kappa, front);
  Curves curves("V16", "Conduction of heat: cooling over that at x = 0",
                "x (m),with 2 000 discs,with 4 000 discs,with 8 000 discs");
  const auto panel = [&](double place, double value) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return std::vector<double>{place, discs == 2000 ? value : none, discs == 4000 ? value : none,
                               discs == 8000 ? value : none};
  };
  if (discs == 2000) {  // once, in every panel, before what is measured
    for (const double length : {10.0, 20.0, 30.0}) {
      curves.line("formula for " + std::to_string(static_cast<int>(length)) + " m", 0.0, 60.0,
                  [&](double at) {
                    const double value = std::erfc(at / length);
                    return std::vector<double>{value, value, value};
                  });
    }
  }
  double time = 0.0;
  for (const double length : {10.0, 20.0, 30.0}) {
    const double until = 0.25 * length * length / kappa;
    constexpr int steps = 200;
    for (int k = 0; k < steps; ++k) {
      sim.check(hfrac_step_prepare(sim));
      sim.check(hfrac_step_do(sim, (until - time) / steps));
      sim.check(hfrac_step_finalize(sim));
    }
    time = until;
    temperature = sim.values(HFRAC_DISC_TEMPERATURE);
    double square = 0.0;
    int bins = 0;
    for (double from = x0 + bin_width; from < 95.0; from += bin_width) {
      double measured = 0.0, analytic = 0.0, weight = 0.0, at = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        if (x[i] < from || x[i] >= from + bin_width) continue;
        measured += capacity[i] * (temperature[i] - start) / step_down;
        analytic += capacity[i] * std::erfc((x[i] - front) / length);
        at += capacity[i] * (x[i] - front);
        weight += capacity[i];
      }
      if (analytic / weight < 1e-3) break;
      curves.point("2 sqrt(kappa t) = " + std::to_string(static_cast<int>(length)) + " m",
                   panel(at / weight, measured / weight));
      square += (measured - analytic) * (measured - analytic) / (weight * weight);
      ++bins;
    }
    const double rms = std::sqrt(square / bins);
    std::printf("  t %.3e s, %d bins\n", time, bins);
    report_absolute("rms over the step, 2 sqrt(kappa t) = " + std::to_string(static_cast<int>(length)) + " m",
                    rms, 0.0, tolerance);
  }
  const hfrac_heat balance = sim.heat();
  std::printf("  heat: stored %.6g, from held discs %.6g, set %.6g, error %.1e J/m\n", balance.stored,
              balance.held, balance.host, balance.error);
  report_absolute("heat lost over that from held discs", balance.error / balance.held, 0.0, 1e-9);
  EXPECT_GT(std::abs(balance.held), 0.1 * std::abs(balance.host));
}

TEST(V16Conduction, FollowsTheErrorFunction) {
  conduct(4000, 1, 0.01);
}
TEST(V16ConductionSmoke, FollowsItWithFewDiscs) {
  conduct(2000, 1, 0.02);
}
TEST(V16Conduction, ConvergesWithDiscSize) {
  conduct(8000, 1, 0.01);
}

}  // namespace V16_conduction
