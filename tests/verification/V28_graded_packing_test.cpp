// SPDX-License-Identifier: BSD-3-Clause
// V28  A packing of discs that are four times as large at its sides as in its middle is one rock.
//
// Formula    E', nu', porosity and permeability do not depend on place: a plane assembly of discs whose bonds have stiffnesses in N/m per
//            metre of thickness has no length but its radii, so a zone of coarser discs of the same spread is the same rock. For
//            flow r0 goes with the cube root of the mean radius (k = C r0^3 / R).
// Source     Dimensional analysis; Potyondy and Cundall (2004), section 3.3 (bonded assemblies do not depend on disc size but for
//            their toughness).
// Set-up     100 m x 100 m, 3 000 discs, packing.coarsening 4: fine within 10 m of the middle line y = 50 m, coarsest from some 23 m on.
//            Linear rock (16e9 and 5.6e9 N/m), dry, stress boundary, 1 MPa along y: each layer bears that stress, so strain along y is
//            layer by layer that of its E'. Strains by least squares over displacements between x = 15 and 85 m, fine: |y - 50| < 10 m,
//            coarse: 25 to 44 m. E' and nu' of the whole block (inner 70 %) against uniform packings of 3 000 discs. Flow along x through
//            a rigid network between bands of imposed pressure: all layers have the same gradient, so flow per height is layer by layer
//            that of its permeability.
// Tolerance  Means over four packings: strain 3 %, E' 3 %, nu' 0.02, porosity 0.01, permeability 10 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "flow/flow_solver.hpp"
#include "rigid_network.hpp"
#include "support.hpp"

namespace V28_graded_packing {

using namespace verification;

constexpr double middle = 50.0, side_margin = 15.0;  // m

enum Zone : std::size_t { fine, coarse, zones };

// The zone of a place, `zones`: of neither.
std::size_t zone_of(double x, double y) {
  if (x < side_margin || x > 100.0 - side_margin) return zones;
  const double away = std::abs(y - middle);
  if (away < 10.0) return fine;
  return away > 25.0 && away < 44.0 ? coarse : zones;
}
constexpr std::array<double, 2> zone_area = {70.0 * 20.0, 70.0 * 38.0};  // m2

hfrac::Definition block(int64_t discs, int64_t seed, double coarsening) {
  hfrac::Definition def = new_def();
  def.flow_scheme = 2;
  def.solver_kind = 1;
  def.packing_disc_count = discs;
  def.packing_coarsening = coarsening;
  def.packing_fine_half_length = 100.0;
  def.packing_fine_half_width = 10.0;
  def.model_seed = seed;
  def.contact_mode = 1;
  def.contact_normal_stiffness = def.bond_normal_stiffness = 16e9;
  def.contact_shear_stiffness = def.bond_shear_stiffness = 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  return def;
}

// Strain along y of the fine zone over that of the coarse one, under stress along y.
double strain_ratio(hfrac::Definition def) {
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 1e6;
  const auto before = verification::Simulation(def).values(HFRAC_DISC_POSITION);
  def.stress_sigma_Hmax = 2e6;  // along x, which the turned model's layers cross
  const auto displacement = moved(before, verification::Simulation(def).values(HFRAC_DISC_POSITION));
  std::array<hfrac::PlaneFit, zones> fit;
  for (std::size_t i = 0; i < before.size(); i += 2) {
    const auto zone = zone_of(before[i + 1], before[i]);
    if (zone < zones) fit.at(zone).add(before[i], before[i + 1], displacement[i]);
  }
  return fit[fine].plane().by_x / fit[coarse].plane().by_x;
}

struct Flow {
  std::array<double, zones> porosity{}, permeability{};  // 1, over that asked for
};
Flow flow_by_zone(int64_t discs, int64_t seed, double coarsening) {
  hfrac::Options o = RigidNetwork::options_of(discs, seed);
  o.packing_coarsening = coarsening;
  o.packing_fine_half_length = 100.0;
  o.packing_fine_half_width = 10.0;
  RigidNetwork rock(o);
  rock.calibrate(o.flow_permeability);
  auto& n = rock.network();
  constexpr double drop = 1e5;
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    const double x = n.centroid[d].x;
    if (x < 8.0 || x > 92.0) rock.impose(d, x < 8.0 ? drop : 0.0);
  }
  hfrac::FlowSolver solver(n, rock.options());
  for (int step = 0; step < 2; ++step) solver.advance(n, 1e12, {});
  Flow flow;
  std::array<double, zones> pores{}, area{}, through{};
  std::array<hfrac::PlaneFit, zones> fit;
  for (std::int64_t d = 1; d < n.domain_count(); ++d) {
    const auto at = n.centroid[d];
    const auto zone = zone_of(at.x, at.y);
    if (zone == zones) continue;
    pores.at(zone) += n.volume[d];
    area.at(zone) += rock.area(d);
    fit.at(zone).add(at.x, at.y, n.pressure[d]);
  }
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    if (n.left[e] == 0 || n.right[e] == 0) continue;
    const auto from = n.centroid[n.left[e]], to = n.centroid[n.right[e]];
    const auto zone = zone_of(0.5 * (from.x + to.x), 0.5 * (from.y + to.y));
    if (zone < zones) through.at(zone) += n.flow[e] * (to.x - from.x);
  }
  for (std::size_t zone = 0; zone < zones; ++zone) {
    flow.porosity.at(zone) = pores.at(zone) / area.at(zone);
    flow.permeability.at(zone) = -through.at(zone) / zone_area.at(zone) * o.fluid_viscosity /
                                 fit.at(zone).plane().by_x / o.flow_permeability;
  }
  return flow;
}

void compare(int64_t discs, int64_t packings, double coarsening, double tolerance) {
  double strain = 0.0, modulus = 0.0, poisson = 0.0;
  Flow mean;
  const auto share = 1.0 / static_cast<double>(packings);
  for (int64_t seed = 1; seed <= packings; ++seed) {
    hfrac::Definition turned = block(discs, seed, coarsening);
    turned.packing_fine_azimuth = 0.5 * pi;
    const double ratio = strain_ratio(turned);
    const Elasticity whole = elasticity(block(discs, seed, coarsening), 1e6),
                     plain = elasticity(block(discs, seed, 1.0), 1e6);
    const Flow flow = flow_by_zone(discs, seed, coarsening), as_uniform = flow_by_zone(discs, seed, 1.0);
    hfrac::Definition same = turned;
    same.packing_coarsening = 1.0;
    std::printf(
        "  seed %lld: strain fine over coarse %.3f, E' over uniform %.3f, nu' less uniform %+.3f, porosity "
        "%.3f and %.3f, permeability %.3f and %.3f\n    uniform packing, same zones: strain %.3f, "
        "permeability "
        "%.3f and %.3f\n",
        static_cast<long long>(seed), ratio, whole.modulus / plain.modulus, whole.poisson - plain.poisson,
        flow.porosity[fine], flow.porosity[coarse], flow.permeability[fine], flow.permeability[coarse],
        strain_ratio(same), as_uniform.permeability[fine], as_uniform.permeability[coarse]);
    strain += share * ratio;
    modulus += share * whole.modulus / plain.modulus;
    poisson += share * (whole.poisson - plain.poisson);
    for (std::size_t zone = 0; zone < zones; ++zone) {
      mean.porosity.at(zone) += share * flow.porosity.at(zone);
      mean.permeability.at(zone) += share * flow.permeability.at(zone);
    }
  }
  report("strain of the fine zone over the coarse one's", strain, 1.0, tolerance);
  report("E' over that of uniform packings", modulus, 1.0, tolerance);
  report_absolute("nu' less that of uniform packings", poisson, 0.0, 0.02);
  report_absolute("porosity of the fine zone less the coarse one's",
                  mean.porosity[fine] - mean.porosity[coarse], 0.0, 0.01);
  report("permeability of the fine zone over the coarse one's",
         mean.permeability[fine] / mean.permeability[coarse], 1.0, 0.1);
  report("permeability of the fine zone over that asked for", mean.permeability[fine], 1.0, 0.1);
}

// One small packing: its scatter is that of the few discs in each zone.
TEST(V28GradedPackingSmoke, IsOneRock) {
  compare(1500, 1, 4.0, 0.08);
}

TEST(V28GradedPacking, IsOneRockInTheMeanOfPackings) {
  compare(3000, 4, 4.0, 0.03);
}

TEST(V28GradedPackingLong, IsOneRockInTheMeanOfMorePackings) {
  compare(8000, 8, 8.0, 0.03);
}

}  // namespace V28_graded_packing
