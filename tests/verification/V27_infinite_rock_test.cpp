// SPDX-License-Identifier: BSD-3-Clause
// V27  Rock without end around a small model (boundary.kind = "infinite").
//
// Formula    Lame: a pressure p in a hole of radius a moves the rock by u_r = p a^2 / (2 G r) in a plane without end.
//            Sneddon (1946): a crack of half length a opens by an area of 2 pi p a^2 / E'.
// Set-up     Random packings, linear rock (contacts only after a break), 10 MPa all round for the hole and none for the slit, a fluid that gives (1 MPa) in rock that lets nothing through,
//            so that pores hold no pressure of their own. A large packing, and its middle cut out as a model of its own, disc by disc the same: what
//            the two do differently is what the boundary makes of the rock that is missing. Hole: edge at 3 radii, of 10 in the large one.
//            Slit of cut bonds: edge at 1.5 half lengths, of 6 in the large one. The large one has rock beyond too. E' and nu are what the models
//            measure themselves.
// Measured   hole: mean of u_r r over the discs between 1.2 and 2 radii. Slit: area of the opening. Both over the large model's and over the formula.
//            The same with kind stress, for what the missing rock is worth.
// Tolerance  Over the large model's: 2 % in the mean of three packings. Over the formula, what discs of this size do: 7 % (hole) and 13 % (slit, as V7).
// Page       docs/verification/V27.md
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/plane_fit.hpp"
#include "geom/packing.hpp"
#include "model.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V27_infinite_rock {

using namespace hfrac;
using verification::pi;

constexpr double pressure = 1e6;  // Pa, above the far field in slits, 0 elsewhere
constexpr int packings = 3;

CaseDefinition linear_rock(double side, std::int64_t discs, std::int64_t seed, BoundaryKind kind,
                           double stress = 0.0) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.model_width = o.model_height = side;
  o.model_seed = seed;
  o.packing_disc_count = discs;
  o.boundary_kind = static_cast<std::int64_t>(kind);
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.bond_normal_stiffness = 16e9;
  o.bond_shear_stiffness = 5.6e9;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = stress;
  o.fluid_formation_pressure = 0.0;
  o.fluid_bulk_modulus = 1e6;
  o.flow_permeability = 1e-24;
  o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  o.stepping_flow_step = 1e-6;
  return definition;
}

// Discs of a packing in the middle square of `side`, x, y, radius each.
std::vector<double> middle_of(const Packing& packing, double whole, double side) {
  std::vector<double> discs;
  const double corner = 0.5 * (whole - side);
  for (std::size_t i = 0; i < packing.x.size(); ++i) {
    const double x = packing.x[i] - corner, y = packing.y[i] - corner;
    if (x < 0.0 || x > side || y < 0.0 || y > side) continue;
    discs.insert(discs.end(), {x, y, packing.radius[i]});
  }
  return discs;
}

struct Elastic {
  double modulus, shear;  // Pa: E', G
};
Elastic rock_of(const Simulation& sim) {
  const double modulus = sim.setup().exterior_modulus, nu = sim.setup().exterior_poisson_ratio;
  return {modulus, 0.5 * modulus * (1.0 - nu)};  // E' = 2 G / (1 - nu)
}

// Area [m2] that the hole's pressure acts on the rim of: what the pore would gain if all places grew by their own size, halved.
double area_of_hole(const Simulation& sim) {
  const Network& n = sim.network();
  const Assembly& a = sim.assembly();
  const auto d = sim.wells()[0].place.domain;
  double area = 0.0;
  for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
    const auto i = n.corner_disc[k];
    area += 0.5 * (n.corner_weight[2 * k] * a.x[i] + n.corner_weight[2 * k + 1] * a.y[i]);
  }
  return area;
}

// Mean of u_r r [m2] of the discs around the hole, from what the well's pressure does.
double push_of_hole(Simulation& sim, double radius) {
  const Assembly& a = sim.assembly();
  const Array<double> x = a.ux, y = a.uy;
  sim.step(sim.loads(), 1e-6);
  const Vec2 centre{0.5 * sim.options().model_width, 0.5 * sim.options().model_height};
  double sum = 0.0, count = 0.0;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    const Vec2 from = Vec2{a.x[i], a.y[i]} - centre;
    const double r = std::hypot(from.x, from.y);
    if (r < 1.2 * radius || r > 2.0 * radius) continue;
    sum += (a.ux[i] - x[i]) * from.x + (a.uy[i] - y[i]) * from.y;
    count += 1.0;
  }
  return sum / count;
}

// Area [m2] by which a slit of half length `half` in the middle, cut into rock at rest, is pressed open.
double opening_of_slit(Simulation& sim, double half) {
  Model& m = sim.engine().model;
  Assembly& a = m.assembly;
  Network& n = m.network;
  const Vec2 centre{0.5 * sim.options().model_width, 0.5 * sim.options().model_height};
  std::vector<std::pair<double, std::size_t>> slit;  // along it from the middle, and the bond
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    const auto i = a.first[e], j = a.second[e];
    if ((a.y[i] - centre.y) * (a.y[j] - centre.y) >= 0.0) continue;
    const double x = a.x[i] + (a.x[j] - a.x[i]) * (centre.y - a.y[i]) / (a.y[j] - a.y[i]);
    if (std::abs(x - centre.x) > half) continue;
    slit.emplace_back(x - centre.x, e);
    a.intact[e] = 0;
    for (const auto d : {n.left[e], n.right[e]}) {
      n.stiffness[d] = 0.0;
      n.pressure[d] = pressure;
    }
  }
  sim.step(sim.loads(), 1e-6);
  std::sort(slit.begin(), slit.end());
  double area = 0.0;
  for (std::size_t k = 0; k < slit.size(); ++k) {
    const double from = k == 0 ? -half : 0.5 * (slit[k - 1].first + slit[k].first),
                 to = k + 1 == slit.size() ? half : 0.5 * (slit[k].first + slit[k + 1].first);
    const auto i = a.first[slit[k].second], j = a.second[slit[k].second];
    area += (to - from) * (a.uy[j] - a.uy[i]) * (a.y[j] > a.y[i] ? 1.0 : -1.0);
  }
  return area;
}

struct Ratios {
  double infinite = 0.0, stress = 0.0, formula = 0.0;  // over the large model; formula: infinite over it
};

void print(const char* what, std::int64_t seed, const Ratios& r, std::size_t discs) {
  std::printf(
      "  %s, packing %lld, %zu discs: over the large model's %.4f (infinite), %.4f (stress); over the "
      "formula %.4f\n",
      what, static_cast<long long>(seed), discs, r.infinite, r.stress, r.formula);
  std::fflush(stdout);
}

// Edge at 3 hole radii in the small model, at 10 in the large one.
Ratios lame(std::int64_t discs, std::int64_t seed) {
  constexpr double radius = 5.0, whole = 20.0 * radius, side = 6.0 * radius;
  const auto with_hole = [&](double width, BoundaryKind kind) {
    CaseDefinition definition = linear_rock(width, discs, seed, kind, 10e6);
    WellOptions well;
    well.x = well.y = 0.5 * width;
    well.radius = radius;
    well.pressure = pressure;
    definition.wells = {well};
    return definition;
  };
  const auto middle =
      middle_of(pack_discs(packing_options(with_hole(whole, BoundaryKind::stress).options)), whole, side);
  Simulation large(with_hole(whole, BoundaryKind::infinite), {}, {}),
      small(with_hole(side, BoundaryKind::infinite), middle, {}),
      control(with_hole(side, BoundaryKind::stress), middle, {});
  const double far = push_of_hole(large, radius), near = push_of_hole(small, radius);
  const Ratios r{near / far, push_of_hole(control, radius) / far,
                 near / (pressure * area_of_hole(small) / (2.0 * pi * rock_of(large).shear))};
  print("hole", seed, r, middle.size() / 3);
  return r;
}

// Edge at 1.5 half lengths in the small model, at 6 in the large one.
Ratios sneddon(std::int64_t discs, std::int64_t seed) {
  constexpr double half = 10.0, whole = 12.0 * half, side = 3.0 * half;
  const auto middle =
      middle_of(pack_discs(packing_options(linear_rock(whole, discs, seed, BoundaryKind::stress).options)),
                whole, side);
  Simulation large(linear_rock(whole, discs, seed, BoundaryKind::infinite), {}, {}),
      small(linear_rock(side, discs, seed, BoundaryKind::infinite), middle, {}),
      control(linear_rock(side, discs, seed, BoundaryKind::stress), middle, {});
  const double far = opening_of_slit(large, half), near = opening_of_slit(small, half);
  const Ratios r{near / far, opening_of_slit(control, half) / far,
                 near / (2.0 * pi * pressure * half * half / rock_of(large).modulus)};
  print("slit", seed, r, middle.size() / 3);
  return r;
}

template <class Case>
void hold(const char* what, const Case& run, std::int64_t discs, int count, double of_formula) {
  Ratios mean;
  for (int seed = 1; seed <= count; ++seed) {
    const Ratios one = run(discs, seed);
    mean.infinite += one.infinite / count;
    mean.stress += one.stress / count;
    mean.formula += one.formula / count;
  }
  verification::report(std::string(what) + ": infinite over the large model", mean.infinite, 1.0, 0.02);
  std::printf("  %s: kind stress over the large model %.4f in the mean\n", what, mean.stress);
  EXPECT_GT(std::abs(mean.stress - 1.0), 3.0 * std::abs(mean.infinite - 1.0)) << what;
  verification::report(std::string(what) + ": infinite over the formula", mean.formula, 1.0, of_formula);
}

TEST(V27InfiniteRockSmoke, AHoleThreeRadiiFromTheEdge) {
  hold("hole", lame, 5000, 1, 0.13);
}

TEST(V27InfiniteRock, AHoleThreeRadiiFromTheEdge) {
  hold("hole", lame, 10000, packings, 0.07);
}

TEST(V27InfiniteRock, ASlitOneAndAHalfHalfLengthsFromTheEdge) {
  hold("slit", sneddon, 10000, packings, 0.13);
}

}  // namespace V27_infinite_rock
