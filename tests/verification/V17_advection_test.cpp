// SPDX-License-Identifier: BSD-3-Clause
// V17  Heat carried by a fluid and conducted by the rock (Ogata and Banks).
//
// Formula    T = T0 + (T1 - T0) / 2 [ erfc((x - v t) / (2 sqrt(D t))) + exp(v x / D) erfc((x + v t) / (2 sqrt(D t))) ]
//            v = q c_f / C, D = lambda / C; q the flow per area, c_f heat per volume of fluid, C that of rock with fluid.
// Source     Ogata and Banks 1961, USGS Professional Paper 411-A.
// Set-up     The heat solver on the rigid network of 4 000 and 8 000 discs in 100 m x 100 m, closed above and below; steady flow
//            from the domains left of 8 m to those right of 92 m. Discs left of 10 m are held 100 K colder from t = 0.
//            q is measured, the flow through the middle over the height. 400 steps until v t = 30 m. Three speeds: v x / D = 5, 20
//            and 60 at x = 40 m. Bins of 2 m; x counts as in V16.
//            Upwinding spreads a front like a dispersivity of half the way from pore to pore along the flow (backward Euler
//            adds v dt / 2), and flow through a packing has a dispersion of its own. So the dispersivity a for which D + a v
//            fits best is measured too.
// Tolerance  rms over the bins 2 % of T1 - T0 with the rock's own D where it rules (v x / D = 5). Beyond, 2 % with D + a v (missed by
//            4 000 discs at v x / D = 60, which is printed and not checked), a below the mean disc diameter, and less with
//            smaller discs.
#include "flow/flow_solver.hpp"
#include "heat/heat_solver.hpp"
#include "heat_support.hpp"
#include "rigid_network.hpp"

namespace V17_advection {

using namespace verification;

constexpr double x0 = 10.0, bin_width = 2.0, drop = -100.0;

double ogata_banks(double x, double v, double d, double t) {
  const double width = 2.0 * std::sqrt(d * t), far = (x + v * t) / width;
  // exp(v x / D) erfc(z) without overflow: erfc(z) ~ exp(-z^2) / (z sqrt(pi)) for large z.
  const double second = far < 5.0 ? std::exp(v * x / d) * std::erfc(far)
                                  : std::exp(v * x / d - far * far) / (far * std::sqrt(pi)) *
                                        (1.0 - 0.5 / (far * far) + 0.75 / (far * far * far * far));
  return 0.5 * (std::erfc((x - v * t) / width) + second);
}

struct Outcome {
  double rms, fitted, dispersivity, diameter;  // shares of the step; m
};

struct Bin {
  std::vector<double> x, weight;
  double at = 0.0, all = 0.0, measured = 0.0;
  [[nodiscard]] double analytic(double v, double d, double t) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += weight[k] * ogata_banks(x[k], v, d, t);
    return sum / all;
  }
};

double rms_of(const std::vector<Bin>& bins, double v, double d, double t) {
  double square = 0.0;
  for (const auto& bin : bins) square += std::pow(bin.measured - bin.analytic(v, d, t), 2.0);
  return std::sqrt(square / static_cast<double>(bins.size()));
}

// A front of cold water through the rock.
Outcome carry(std::int64_t discs, double peclet) {
  RigidNetwork rock(discs, 1);
  rock.calibrate(5.527e-15);
  Network& n = rock.network();
  Assembly& a = rock.assembly();
  Options o = rock.options();
  o.thermal_mode = static_cast<std::int64_t>(ThermalMode::transport);
  const auto domains = static_cast<std::size_t>(n.domain_count());
  for (std::size_t d = 1; d < domains; ++d) {
    if (n.centroid[d].x < 8.0) rock.impose(static_cast<std::int64_t>(d), 1e6);
    if (n.centroid[d].x > 92.0) rock.impose(static_cast<std::int64_t>(d), 0.0);
  }
  FlowSolver flow(n, o);
  for (int k = 0; k < 2; ++k) flow.advance(n, 1e13, {});

  // Heat per area of rock with fluid, right of 20 m.
  double heat = 0.0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    if (a.x[i] > 20.0) heat += a.mass(static_cast<std::int64_t>(i)) * o.thermal_specific_heat;
  }
  const double fluid = o.thermal_fluid_density * o.thermal_fluid_specific_heat;
  for (std::size_t d = 1; d < domains; ++d) {
    if (n.centroid[d].x > 20.0) heat += n.volume[d] * fluid;
  }
  const double both = heat / (80.0 * 100.0), diffusivity = o.thermal_conductivity / both;
  // The speed wanted; flow is proportional to pressure.
  const double speed = peclet * diffusivity / 40.0;
  const double scale = speed * both / fluid / (rock.flow_across(50.0) / rock.height());
  for (auto& q : n.flow) q *= scale;
  // Rigid and steady: contents stay.
  std::fill(n.content.begin(), n.content.end(), 0.0);

  HeatNetwork network = build_heat_network(a, n, o);
  HeatSolver solver(a, n, network, o);
  HeatState state;
  const double start = o.thermal_rock_temperature;
  state.disc.assign(a.x.size(), start);
  state.felt = state.disc;
  state.fluid.assign(domains, start);
  state.held.assign(a.x.size(), 0);
  double front = 0.0, contacts = 0.0, way = 0.0, ways = 0.0;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    if (a.x[i] >= x0) continue;
    state.held[i] = 1;
    state.disc[i] = start + drop;
  }
  for (std::size_t d = 1; d < domains; ++d) {
    if (n.centroid[d].x < x0) state.fluid[d] = start + drop;
  }
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
    const auto l = static_cast<std::size_t>(n.left[e]), r = static_cast<std::size_t>(n.right[e]);
    if (l != 0 && r != 0) {
      const double along = n.centroid[r].x - n.centroid[l].x;
      way += n.flow[e] * along * std::abs(along);
      ways += n.flow[e] * along;
    }
    if (state.held[i] == state.held[j]) continue;
    front += state.held[i] != 0 ? a.x[i] : a.x[j];
    contacts += 1.0;
  }
  front /= contacts;
  const double time = 30.0 / speed;
  constexpr int steps = 400;
  const double before = solver.stored(state);
  for (int k = 0; k < steps; ++k) solver.advance(state, {}, time / steps);
  std::printf(
      "  %lld discs, v %.3e m/s, D %.3e m2/s; half the way from pore to pore %.2f m, v dt / 2 %.2f m\n",
      static_cast<long long>(discs), speed, diffusivity, 0.5 * way / ways, 0.5 * speed * time / steps);

  std::vector<Bin> bins;
  for (double from = x0 + bin_width; from < 80.0; from += bin_width) {
    Bin bin;
    for (std::size_t i = 0; i < a.x.size(); ++i) {
      if (a.x[i] < from || a.x[i] >= from + bin_width) continue;
      const double w = network.capacity[i];
      bin.x.push_back(a.x[i] - front);
      bin.weight.push_back(w);
      bin.measured += w * (state.disc[i] - start) / drop;
      bin.at += w * (a.x[i] - front);
      bin.all += w;
    }
    bin.measured /= bin.all;
    bin.at /= bin.all;
    if (bin.measured < 1e-3) break;
    bins.push_back(std::move(bin));
  }
  Outcome out{rms_of(bins, speed, diffusivity, time), 1.0, 0.0, 2.0 * a.mean_radius};
  for (double length = 0.0; length < 5.0; length += 0.02) {
    const double rms = rms_of(bins, speed, diffusivity + length * speed, time);
    if (rms < out.fitted) out = {out.rms, rms, length, out.diameter};
  }
  Curves curves("V17-" + std::to_string(static_cast<int>(peclet)),
                "Heat carried by a fluid: cooling over that at x = 0 when v t = 30 m",
                "x (m),share of the step");
  const std::string with = std::to_string(discs) + " discs";
  for (const auto& bin : bins) curves.point(with, {bin.at, bin.measured});
  curves.line("Ogata and Banks for " + with, 0.0, 70.0,
              [&](double x) { return std::vector<double>{ogata_banks(x, speed, diffusivity, time)}; });
  curves.line("with the dispersion found for " + with, 0.0, 70.0, [&](double x) {
    return std::vector<double>{ogata_banks(x, speed, diffusivity + out.dispersivity * speed, time)};
  });
  std::printf(
      "  v x / D = %.0f: rms %.2f %% of the step; with a dispersivity of %.2f m %.2f %%; over %zu bins\n",
      peclet, 100.0 * out.rms, out.dispersivity, 100.0 * out.fitted, bins.size());
  // Nothing is colder than what comes in, nor warmer than what was there.
  EXPECT_GE(*std::min_element(state.disc.begin(), state.disc.end()), start + drop - 1e-6);
  EXPECT_LE(*std::max_element(state.fluid.begin(), state.fluid.end()), start + 1e-6);
  EXPECT_LT(solver.stored(state), before);
  return out;
}

TEST(V17AdvectionSmoke, FollowsOgataAndBanksWhereConductionRules) {
  report_absolute("v x / D = 5: rms over the step", carry(4000, 5.0).rms, 0.0, 0.02);
}
TEST(V17Advection, DispersesFrontsByLessThanADisc) {
  const Outcome slow = carry(4000, 20.0), fast = carry(4000, 60.0), finer = carry(8000, 60.0);
  for (const auto& one : {slow, fast, finer})
    report_absolute("dispersivity over the mean disc diameter", one.dispersivity / one.diameter, 0.0, 1.0);
  report_absolute("v x / D = 20: rms with that dispersivity", slow.fitted, 0.0, 0.02);
  report_absolute("v x / D = 60, 8 000 discs: the same", finer.fitted, 0.0, 0.02);
  EXPECT_LT(finer.dispersivity, fast.dispersivity);
  EXPECT_LT(finer.rms, fast.rms);
}

}  // namespace V17_advection
