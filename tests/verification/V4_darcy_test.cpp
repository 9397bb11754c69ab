// SPDX-License-Identifier: BSD-3-Clause
// V4  Steady Darcy flow, radial from a well and linear between two sides.
//
// Formula    radial q = 2 pi k dp / (eta ln(r2 / r1)) and p(r) = p1 - q eta / (2 pi k) ln(r / r1); linear
//            q = k H dp / (eta L), with k the permeability asked for (flow.permeability, 5.6 mD).
// Source     Muskat, The Flow of Homogeneous Fluids through Porous Media; eq. 6 and 8 of the paper.
// Set-up     radial: 100 m x 100 m, 4 000 discs, hole of 7 m in the middle, effective stresses, unstressed
//            rock between walls, outer pores at formation pressure, well at 0.1 MPa net (so small that no
//            aperture answers to it), implicit flow in steps of 1e9 s until steady. k from the slope of
//            pressure against ln r over the domains from r1 = 1.5 hole radii to r2 = 40 m. Three
//            packings. linear: the flow solver on a rigid network of 4 000 discs without a well, sides
//            open, top and bottom closed.
// Tolerance  flow 3 % (mean over packings), pressure rms 3 % of the pressure drop over the range.
#include <gtest/gtest.h>

#include <cmath>

#include "flow/aperture.hpp"
#include "flow/flow_solver.hpp"
#include "rigid_network.hpp"
#include "support.hpp"

namespace V4_darcy {

using namespace verification;

constexpr double darcy_permeability = 5.527e-15, viscosity = 0.3;

// Means over rings of the same width in ln r.
void draw(Curves& curves, const std::string& series, const std::vector<double>& log_radius,
          const std::vector<double>& pressure, double inner) {
  constexpr double width = 0.08;
  std::vector<double> sum(64, 0.0), count(64, 0.0);
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const auto bin = static_cast<std::size_t>(log_radius[k] / width);
    sum[bin] += pressure[k];
    count[bin] += 1.0;
  }
  for (std::size_t bin = 0; bin < sum.size(); ++bin) {
    if (count[bin] == 0.0) continue;
    curves.point(series,
                 {inner * std::exp((static_cast<double>(bin) + 0.5) * width), 1e-3 * sum[bin] / count[bin]});
  }
}

TEST(V4Darcy, RadialFlow) {
  constexpr int packings = 3;
  Curves curves("V4", "Steady radial flow: pressure against the distance from the well",
                "distance from the well's middle (m),net pressure (kPa)");
  double mean_ratio = 0.0, mean_square = 0.0;
  for (int seed = 1; seed <= packings; ++seed) {
    hfrac::Definition def = new_def();
    def.stress_convention = 1;
    def.boundary_kind = 1;
    def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
    def.packing_disc_count = 4000;
    def.model_seed = seed;
    def.flow_permeability = darcy_permeability;
    def.stepping_flow_step = 1e9;
    hfrac_sim_def_set_i64(&def, "well_count", 1);
    def.wells[0].x = def.wells[0].y = 50.0;
    def.wells[0].radius = 7.0;
    def.wells[0].pressure = 1e5;
    Simulation s(def);
    s.step(20);
    const double flow = s.well(0).rate, inner = 1.5 * s.well(0).equivalent_radius, outer = 40.0;
    const auto centre = s.values(HFRAC_DOMAIN_CENTRE), pressure = s.values(HFRAC_DOMAIN_PRESSURE);
    // Pressure against ln r: the line of least squares gives k; rms against the formula's slope.
    std::vector<double> log_radius, value;
    for (std::size_t d = 1; d < pressure.size(); ++d) {
      const double r = std::hypot(centre[2 * d] - 50.0, centre[2 * d + 1] - 50.0);
      if (r <= inner || r >= outer) continue;
      log_radius.push_back(std::log(r / inner));
      value.push_back(pressure[d]);
    }
    const Line line = fit_line(log_radius, value);
    const double measured = -flow * viscosity / (2.0 * pi * line.slope),
                 drop = -line.slope * std::log(outer / inner);
    const double analytic_slope = -flow * viscosity / (2.0 * pi * darcy_permeability);
    const auto count = static_cast<double>(value.size());
    double square = 0.0, level = 0.0;
    for (std::size_t k = 0; k < value.size(); ++k)
      level += (value[k] - analytic_slope * log_radius[k]) / count;
    for (std::size_t k = 0; k < value.size(); ++k)
      square += std::pow((value[k] - level - analytic_slope * log_radius[k]) / drop, 2) / count;
    std::printf("  packing %d: flow %.4e m2/s, k %.4e m2 (%+.1f %%), pressure rms %.2f %% of the drop\n",
                seed, flow, measured, 100.0 * (measured / darcy_permeability - 1.0),
                100.0 * std::sqrt(square));
    draw(curves, "packing " + std::to_string(seed), log_radius, value, inner);
    if (seed == 1) {
      curves.line("formula", inner, outer, [&](double r) {
        return std::vector<double>{1e-3 * (level + analytic_slope * std::log(r / inner))};
      });
    }
    mean_ratio += measured / darcy_permeability / packings;
    mean_square += square / packings;
  }
  report("radial: flow over 2 pi k dp / (eta ln(r2/r1))", mean_ratio, 1.0, 0.03);
  report_absolute("radial: rms of the pressure over the drop", std::sqrt(mean_square), 0.0, 0.03);
}

TEST(V4DarcySmoke, LinearFlow) {
  RigidNetwork rock(4000, 1);
  rock.calibrate(darcy_permeability);
  constexpr double low = 15.0, high = 85.0, drop = 1e5;
  for (std::int64_t d = 1; d < rock.network().domain_count(); ++d) {
    const double x = rock.network().centroid[d].x;
    if (x < low || x > high) rock.impose(d, x < low ? drop : 0.0);
  }
  FlowSolver flow(rock.network(), rock.options());
  for (int step = 0; step < 2; ++step) flow.advance(rock.network(), 1e12, {});
  const double through = rock.flow_across(0.5 * (low + high));
  PlaneFit fit;
  double square = 0.0, count = 0.0;
  for (std::int64_t d = 1; d < rock.network().domain_count(); ++d) {
    const auto at = rock.network().centroid[d];
    if (at.x <= low || at.x >= high) continue;
    fit.add(at.x, at.y, rock.network().pressure[d]);
    square += std::pow((rock.network().pressure[d] - drop * (high - at.x) / (high - low)) / drop, 2);
    count += 1.0;
  }
  report("linear: flow over k H dp / (eta L)",
         through * viscosity / (-fit.plane().by_x * rock.height() * darcy_permeability), 1.0, 0.03);
  report_absolute("linear: rms of the pressure over the drop", std::sqrt(square / count), 0.0, 0.03);
}

}  // namespace V4_darcy
