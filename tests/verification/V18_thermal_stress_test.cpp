// SPDX-License-Identifier: BSD-3-Clause
// V18  Thermal stress of a constrained block.
//
// Formula    in fixed walls       sigma = 2 K alpha dT, with K the area stiffness of plane strain, 2 K = E / ((1 + nu) (1 - 2 nu)) (alpha
//                                 in the plane; 1 + nu times the rock's own gives E alpha_rock dT / (1 - 2 nu))
//            free                 strain alpha dT, no stress
//            hot circle in a      p = E' alpha dT / 2 (1 - a^2 / b^2), E' = E / (1 - nu^2): radial stress inside radius a of a free disc of
//            cold block           radius b
// Source     Timoshenko and Goodier, Theory of Elasticity, chapter 13.
// Set-up     2 000 discs, quasi-static, through hfrac.h. E and nu are measured on the same block: fits of displacement under two far
//            fields (V2). (a) walls fixed, linear set, +50 K at alpha 1e-5; (b) the paper's set, where contact and bond
//            together resist being squeezed; (c) the free block under a stress boundary; (d) discs within 15 m of the middle +50 K in
//            a free block, b from the area of the model.
// Tolerance  (a), (b) 3 % of 2 K (alpha dT - strain), strain what the walls' own contacts let the block grow, at most 20 % of alpha dT;
//            (c) strain 1e-3, change of stress 5e-3 of E' alpha dT; (d) 5 %, mean within 10 m.
#include "heat_support.hpp"

namespace V18_thermal_stress {

using namespace verification;

constexpr double alpha = 1e-5, rise = 50.0, start = 523.15, load = 20e6;

hfrac::Definition warm_def(int32_t contact_mode) {
  hfrac::Definition def = warm_block(2000, 1);
  def.packing_residual = 1e-5;
  def.thermal_mode = 1;
  def.thermal_rock_temperature = start;
  def.thermal_expansion = alpha;
  def.contact_mode = contact_mode;
  if (contact_mode == 1) {  // the linear set of the model's description
    def.bond_normal_stiffness = 16e9;
    def.bond_shear_stiffness = 5.6e9;
  }
  return def;
}

// Strains of the inner part of the block.
std::array<double, 2> strains(const HostedSimulation& sim, const std::vector<double>& from) {
  return inner_strain(sim.values(HFRAC_DISC_POSITION), moved(from, sim.values(HFRAC_DISC_DISPLACEMENT)));
}

struct Elastic {
  double area, plane;  // Pa: 2 K, and E' = E / (1 - nu^2)
};

// Pressed from `load` alike to `load` and half as much more along x (and alike).
Elastic measure(hfrac::Definition def) {
  def.boundary_kind = 0;
  def.thermal_mode = 0;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = load;
  HostedSimulation sim(def);
  sim.check(hfrac_step(sim, 1));
  const auto from = sim.values(HFRAC_DISC_DISPLACEMENT);
  const double more = 0.5 * load;
  sim.check(hfrac_set_far_field(sim, load + more, load + more));
  sim.check(hfrac_step(sim, 1));
  const auto alike = strains(sim, from);
  sim.check(hfrac_set_far_field(sim, load + more, load));
  sim.check(hfrac_step(sim, 1));
  const auto along = strains(sim, from);
  const double area = -more / (0.5 * (alike[0] + alike[1]));
  return {area, -more / along[0]};  // sigma_x alone in plane strain: eps_x = sigma_x (1 - nu^2) / E
}

double wall_stress(const HostedSimulation& sim) {
  double sum = 0.0;
  for (int32_t w = 0; w < 4; ++w) {
    hfrac_wall_state wall{};
    wall.struct_size = sizeof wall;
    sim.check(hfrac_wall_get(sim, w, &wall));
    sum += 0.25 * wall.stress;
  }
  return sum;
}

void in_fixed_walls(int32_t contact_mode, const char* what) {
  hfrac::Definition def = warm_def(contact_mode);
  const Elastic rock = measure(def);
  HostedSimulation sim(def);
  const double before = wall_stress(sim);
  const auto from = sim.values(HFRAC_DISC_DISPLACEMENT);
  sim.check(hfrac_set_temperature(sim, start + rise));
  sim.check(hfrac_step(sim, 1));
  const auto given_way = strains(sim, from);
  const double strain = 0.5 * (given_way[0] + given_way[1]), stress = wall_stress(sim) - before;
  std::printf("  the walls' contacts let the block grow by %.1f %% of alpha dT\n",
              100.0 * strain / (alpha * rise));
  report(what, stress, rock.area * (alpha * rise - strain), 0.03);
  EXPECT_LT(std::abs(strain), 0.2 * alpha * rise);
  hfrac_balance balance{};
  balance.struct_size = sizeof balance;
  sim.check(hfrac_get_balance(sim, &balance));
  EXPECT_GT(sim.heat().thermal_work, 0.0);
  EXPECT_EQ(balance.energy_checked, 0);
}

TEST(V18ThermalStressSmoke, InFixedWallsLinearSet) {
  in_fixed_walls(1, "(a) stress on fixed walls, linear set, Pa");
}
TEST(V18ThermalStress, InFixedWallsPaperSet) {
  in_fixed_walls(0, "(b) stress on fixed walls, the paper's set, Pa");
}

TEST(V18ThermalStress, FreeBlockJustGrows) {
  hfrac::Definition def = warm_def(1);
  def.boundary_kind = 0;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = load;
  HostedSimulation sim(def);
  sim.check(hfrac_step(sim, 1));
  const auto from = sim.values(HFRAC_DISC_DISPLACEMENT), before = sim.values(HFRAC_DISC_STRESS);
  sim.check(hfrac_set_temperature(sim, start + rise));
  sim.check(hfrac_step(sim, 1));
  const auto grown = strains(sim, from);
  report("(c) strain of a free block along x", grown[0], alpha * rise, 1e-3);
  report("(c) strain of a free block along y", grown[1], alpha * rise, 1e-3);
  double largest = 0.0;
  const auto after = sim.values(HFRAC_DISC_STRESS);
  for (std::size_t k = 0; k < after.size(); ++k) largest = std::max(largest, std::abs(after[k] - before[k]));
  std::printf("  (c) largest change of stress of a disc %.3g Pa\n", largest);
  EXPECT_LT(largest, 5e-3 * 14e9 * alpha * rise);
}

TEST(V18ThermalStress, HotCircleInAColdBlock) {
  hfrac::Definition def = warm_def(1);
  const Elastic rock = measure(def);
  def.boundary_kind = 0;
  def.thermal_mode = 2;
  def.thermal_conductivity = 1e-6;  // nothing flows
  HostedSimulation sim(def);
  const auto position = sim.values(HFRAC_DISC_POSITION);
  const std::size_t n = position.size() / 2;
  constexpr double a = 15.0;
  std::vector<double> temperature(n, start), distance(n);
  for (std::size_t i = 0; i < n; ++i) {
    distance[i] = std::hypot(position[2 * i] - 50.0, position[2 * i + 1] - 50.0);
    if (distance[i] < a) temperature[i] = start + rise;
  }
  sim.set(temperature);
  sim.check(hfrac_step(sim, 1));
  const auto stress = sim.values(HFRAC_DISC_STRESS), radius = sim.values(HFRAC_DISC_RADIUS);
  Curves curves("V18", "Stress about a hot circle of 15 m, 50 K warmer",
                "distance from the middle (m),stress (MPa)");
  constexpr double ring_width = 2.0;  // m, of the figure's means
  std::array<std::array<double, 3>, 25> rings{};
  double inside = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double mean = 0.5 * (stress[3 * i] + stress[3 * i + 1]), w = radius[i] * radius[i];
    const double cx = (position[2 * i] - 50.0) / distance[i], cy = (position[2 * i + 1] - 50.0) / distance[i];
    const double radial =
        stress[3 * i] * cx * cx + stress[3 * i + 1] * cy * cy + 2.0 * stress[3 * i + 2] * cx * cy;
    const auto ring = static_cast<std::size_t>(distance[i] / ring_width);
    if (ring < rings.size()) {
      rings[ring][0] += 1e-6 * w * radial;
      rings[ring][1] += 1e-6 * w * (2.0 * mean - radial);
      rings[ring][2] += w;
    }
    if (distance[i] >= 10.0) continue;
    inside += w * mean;
    weight += w;
  }
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * ring_width;
    curves.point("radial", {middle, rings[k][0] / rings[k][2]});
    curves.point("around", {middle, rings[k][1] / rings[k][2]});
  }
  const double b = 100.0 / std::sqrt(pi);
  std::printf("  E' %.4g Pa\n", rock.plane);
  report("(d) pressure inside a hot circle, Pa", inside / weight,
         0.5 * rock.plane * alpha * rise * (1.0 - a * a / (b * b)), 0.05);
}

}  // namespace V18_thermal_stress
