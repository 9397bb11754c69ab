// SPDX-License-Identifier: BSD-3-Clause
// V11: a hydraulic fracture driven by a viscous fluid at constant rate, in plane strain (KGD).
//
// Source     Adachi and Detournay (2002), zero toughness: l = 0.6152 (E' Q^3 / (12 eta))^(1/6) t^(2/3),
//            w0^2 = 2.1 (12 eta Q / E')^(1/2) l, w0 p0 = 0.62 (12 eta Q E')^(1/2). E' is the undrained one, E'_u: the rock is tight
//            for the seconds the fracture takes (Detournay and Cheng 1993; kgd_model.hpp).
// Set-up     kgd_model.hpp; 0.01 m2/s of 0.1 Pa s, quasi-static solver, mode coupled. Time: the well stores fluid before and
//            while the fracture grows, so l^(3/2) is fitted against time and its slope compared; Q is what left the well.
// Tolerance  Prefactors of l, w0 and w0 p0: 25 %. Exponent of l in w0: 10 %, over the last doubling of l on the largest sheet. On
//            the small sheet of the smoke variant the fracture is a few holes long, and the exponent is printed, not held.
#include <gtest/gtest.h>

#include <cstdio>

#include "kgd_model.hpp"
#include "support.hpp"

namespace V11_kgd {

using verification::fit_line;
using verification::KgdCase;
using verification::KgdModel;

struct Kgd {
  double length, width, product;  // measured over analytic
  double width_exponent, last;    // of w0 ~ l^n: over the whole run, and over the last doubling of l
};

Kgd run(int columns, double side = 80.0) {
  KgdCase c;
  c.columns = columns;
  c.side = side;
  KgdModel model(c);
  auto& s = model.simulation();
  std::vector<double> time, length, width, pressure;
  double injected = 0.0, first_injected = 0.0, first_content = 0.0, content = 0.0;
  const auto well = static_cast<std::size_t>(s.wells()[0].place.domain);
  // From four discs beyond the hole until the boundary, at 0.42 of the side, comes near.
  const double begin = s.wells()[0].place.equivalent_radius + 4.0 * model.disc_radius();
  while (model.half_length() < 0.2 * c.side) {
    s.step();
    const double l = model.half_length();
    if (l < begin) continue;
    injected = s.wells()[0].injected;
    content = s.network().content[well];
    if (time.empty()) {
      first_injected = injected;
      first_content = content;
    }
    time.push_back(s.time());
    length.push_back(l);
    width.push_back(model.width());
    pressure.push_back(model.net_pressure());
  }
  const auto [drained, E, porosity] = model.moduli();
  const double eta = KgdModel::slit * c.viscosity;
  std::printf("  E' %.2f GPa drained, %.2f GPa undrained (porosity %.4f)\n", 1e-9 * drained, 1e-9 * E,
              porosity);
  const double Q = ((injected - first_injected) - (content - first_content)) / (time.back() - time.front());
  std::vector<double> grown, log_l, log_w;
  double width_ratio = 0.0, product_ratio = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    grown.push_back(std::pow(length[k], 1.5));
    log_l.push_back(std::log(length[k]));
    log_w.push_back(std::log(width[k]));
    width_ratio += width[k] / std::sqrt(2.1 * std::sqrt(12.0 * eta * Q / E) * length[k]);
    product_ratio += width[k] * pressure[k] / (0.62 * std::sqrt(12.0 * eta * Q * E));
  }
  // Time counts from where the line through l^(3/2) begins.
  const double begun = -fit_line(time, grown).offset / fit_line(time, grown).slope;
  verification::Curves curves(
      "V11", "KGD fracture dominated by viscosity",
      "time since its start (s),half length (m),width at the well (mm),net pressure (MPa)");
  for (std::size_t k = 0; k < time.size(); ++k)
    curves.point(std::to_string(columns) + " columns in " + std::to_string(std::lround(side)) + " m",
                 {time[k] - begun, length[k], 1e3 * width[k], 1e-6 * pressure[k]});
  if ((columns == 40 && side == 80.0) || side > 200.0) {  // Q differs by a few per cent
    curves.line(side > 200.0 ? "Adachi and Detournay at the Q of 240 m" : "Adachi and Detournay", 0.5,
                time.back() - begun, [&](double t) {
                  const double l = 0.6152 * std::pow(E * Q * Q * Q / (12.0 * eta), 1.0 / 6.0) *
                                   std::pow(t, 2.0 / 3.0),
                               w = std::sqrt(2.1 * std::sqrt(12.0 * eta * Q / E) * l);
                  return std::vector<double>{l, 1e3 * w, 1e-6 * 0.62 * std::sqrt(12.0 * eta * Q * E) / w};
                });
  }
  const auto n = static_cast<double>(time.size());
  const double slope = std::pow(0.6152, 1.5) * std::pow(E * Q * Q * Q / (12.0 * eta), 0.25);
  std::vector<double> last_l, last_w;
  for (std::size_t k = 0; k < length.size(); ++k) {
    if (length[k] < 0.5 * length.back()) continue;
    last_l.push_back(log_l[k]);
    last_w.push_back(log_w[k]);
  }
  const Kgd result{std::pow(fit_line(time, grown).slope / slope, 2.0 / 3.0), width_ratio / n,
                   product_ratio / n, fit_line(log_l, log_w).slope, fit_line(last_l, last_w).slope};
  std::printf(
      "  %d columns, %.0f m, %d states, l %.1f to %.1f m, Q %.4f m2/s: l %.3f, w0 %.3f, w0 p0 %.3f of "
      "analytic, w0 ~ "
      "l^%.3f, over the last doubling l^%.3f (0.5)\n",
      columns, side, static_cast<int>(time.size()), length.front(), length.back(), Q, result.length,
      result.width, result.product, result.width_exponent, result.last);
  return result;
}

void hold(const Kgd& kgd) {
  verification::report("l over the formula's", kgd.length, 1.0, 0.25);
  verification::report("w0 over the formula's", kgd.width, 1.0, 0.25);
  verification::report("w0 p0 over the formula's", kgd.product, 1.0, 0.25);
}

TEST(V11KgdSmoke, ViscosityDominatedGrowth) {
  hold(run(40));
}

// Finer sheets: what is left of the error is not resolution.
TEST(V11KgdLong, PrefactorsHardlyDependOnTheSheet) {
  const Kgd coarse = run(40);
  for (const int columns : {60, 80}) {
    const Kgd fine = run(columns);
    verification::report("l over the coarse sheet's", fine.length / coarse.length, 1.0, 0.05);
    verification::report("w0 over the coarse sheet's", fine.width / coarse.width, 1.0, 0.05);
    verification::report("w0 p0 over the coarse sheet's", fine.product / coarse.product, 1.0, 0.05);
  }
}

// Longer fractures from the same hole: what misses the exponent on small sheets is the hole.
TEST(V11KgdLong, TheWidthsExponentComesToOneHalf) {
  double before = 1.0;
  for (const int columns : {40, 80, 120}) {
    const Kgd kgd = run(columns, 2.0 * columns);
    EXPECT_LT(kgd.width_exponent, before);
    before = kgd.width_exponent;
    if (columns < 120) continue;
    verification::report("exponent of l in w0, last doubling", kgd.last, 0.5, 0.10);
    hold(kgd);
  }
}

}  // namespace V11_kgd
