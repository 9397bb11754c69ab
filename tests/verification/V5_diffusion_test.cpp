// SPDX-License-Identifier: BSD-3-Clause
// V5  One-dimensional diffusion of pressure into rigid rock.
//
// Formula    p(x, t) = p1 erfc(x / (2 sqrt(D t))) with D = k K_f / (eta phi).
// Source     Carslaw and Jaeger, Conduction of Heat in Solids, section 2.5; eq. 6 and 8 of the paper.
// Set-up     The flow solver on the rigid network of 4 000 and of 8 000 discs in 100 m x 100 m,
//            calibrated to 5.6 mD, closed all round; the domains with centre left of x0 = 10 m are held
//            at p1 = 1 MPa from t = 0. phi is the network's own: pore volume over polygon area right of
//            x0. Implicit steps, 400 to each time. Pressure averaged over the domains in bins of 2 m, by
//            pore volume; x is measured from where the imposed domains end.
// Tolerance  rms over the bins 2 % of p1, at three times (2 sqrt(D t) from 10 m to 30 m); 1 000 discs, whose pores are as large as
//            the bins, 4 %.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flow/flow_solver.hpp"
#include "rigid_network.hpp"
#include "support.hpp"

namespace V5_diffusion {

using namespace verification;

constexpr double permeability = 5.527e-15, imposed = 1e6, x0 = 10.0, bin_width = 2.0;

// Mean abscissa of the imposed domains that feed free ones: where x begins.
double front_of(const Network& n) {
  double moment = 0.0, weight = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    if (n.conductance[e] == 0.0 || (n.stiffness[l] == 0.0) == (n.stiffness[r] == 0.0)) continue;
    const auto fixed = n.stiffness[l] == 0.0 ? l : r;
    moment += n.conductance[e] * n.centroid[fixed].x;
    weight += n.conductance[e];
  }
  return moment / weight;
}

void diffuse(std::int64_t discs, double tolerance) {
  RigidNetwork rock(discs, 1);
  rock.calibrate(permeability);
  Network& n = rock.network();
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    if (n.centroid[d].x < x0) rock.impose(d, imposed);
  }
  const double front = front_of(n), phi = rock.porosity(x0, 100.0);
  const double diffusivity =
      permeability * rock.options().fluid_bulk_modulus / (rock.options().fluid_viscosity * phi);
  std::printf("  porosity of the network %.4f, diffusivity %.3e m2/s, front at %.2f m\n", phi, diffusivity,
              front);
  FlowSolver flow(n, rock.options());
  Curves curves("V5", "Pressure over that imposed, spreading into rock from x = 0",
                "x (m),with 1 000 discs,with 4 000 discs,with 8 000 discs");
  const auto panel = [&](double x, double value) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return std::vector<double>{x, discs == 1000 ? value : none, discs == 4000 ? value : none,
                               discs == 8000 ? value : none};
  };
  if (discs == 1000) {  // once, in every panel, before what is measured
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
    const double until = 0.25 * length * length / diffusivity;
    constexpr int steps = 400;
    const double step = (until - time) / steps;
    for (int k = 0; k < steps; ++k) flow.advance(n, step, {});
    time = until;
    double square = 0.0, worst = 0.0;
    int bins = 0;
    for (double from = x0 + bin_width; from < 95.0; from += bin_width) {
      double pressure = 0.0, analytic = 0.0, volume = 0.0, middle = 0.0;
      for (std::int64_t d = 1; d < n.domain_count(); ++d) {
        const double x = n.centroid[d].x;
        if (x < from || x >= from + bin_width) continue;
        pressure += n.volume[d] * n.pressure[d] / imposed;
        analytic += n.volume[d] * std::erfc((x - front) / length);
        middle += n.volume[d] * (x - front);
        volume += n.volume[d];
      }
      if (analytic / volume < 1e-3) break;  // the pressure has not come so far
      const double error = (pressure - analytic) / volume;
      curves.point("2 sqrt(D t) = " + std::to_string(static_cast<int>(length)) + " m",
                   panel(middle / volume, pressure / volume));
      square += error * error;
      worst = std::max(worst, std::abs(error));
      ++bins;
    }
    const double rms = std::sqrt(square / bins);
    std::printf("  t %.3e s, %d bins, the worst %.2f %% of p1\n", time, bins, 100.0 * worst);
    report_absolute("rms over p1, 2 sqrt(D t) = " + std::to_string(static_cast<int>(length)) + " m", rms, 0.0,
                    tolerance);
  }
}

TEST(V5DiffusionSmoke, FewDiscsFollowTheErrorFunction) {
  diffuse(1000, 0.04);
}
TEST(V5Diffusion, FollowsTheErrorFunction) {
  diffuse(4000, 0.02);
}
TEST(V5Diffusion, FollowsItMoreCloselyWithSmallerDiscs) {
  diffuse(8000, 0.02);
}

}  // namespace V5_diffusion
