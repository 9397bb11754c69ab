// SPDX-License-Identifier: BSD-3-Clause
// V6  The state around a seeping well, by the continuum and by the discs.
//
// Formula    Eq. 1-3, steady: div grad p = 0, and the stresses in equilibrium with it. What a well of higher pressure adds.
// Source     The continuum solver, held to the ring's solution in V6_consolidation_test.cpp.
// Set-up     6 000 discs of the linear set in 100 m x 100 m, a well of 7 m, sigma_Hmax = sigma_hmin = 45 MPa, p0 = 25 MPa. Once made with
//            initial.state = "seepage" and the well at 35 MPa; once from uniform pressure, the well brought to 35 MPa and the
//            network left to seep, twenty steps of 1e9 s. Pressures by domain; radial and hoop stresses (effective, from disc.stress times
//            the disc's area over its cell) as means over rings, less those of the same rock before.
// Tolerance  Pressures: rms 3 % of the 10 MPa (the packing's permeability is not uniform). Stresses: 5 % of the 10 MPa, 8 % next to the
//            hole (from 1.3 to 2 radii), as in V3.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rock/biot_solver.hpp"
#include "support.hpp"

namespace V6_seepage {

using namespace hfrac;

constexpr double excess = 10e6;  // [Pa]

hfrac::Definition rock_with_well() {
  hfrac::Definition def = verification::new_def();
  def.packing_disc_count = 6000;
  def.contact_mode = 1;
  def.bond_normal_stiffness = 16e9;
  def.bond_shear_stiffness = 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.flow_half_aperture_force = 1e15;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 45e6;
  def.stepping_force_ratio = 1e-6;
  def.stepping_max_cycles = 200000;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 7.0;
  def.wells[0].pressure = 25e6;
  return def;
}

struct Ring {
  double radial = 0.0, hoop = 0.0, area = 0.0;
};
std::vector<Ring> rings(verification::Simulation& rock) {
  const auto place = rock.values(HFRAC_DISC_POSITION), stress = rock.values(HFRAC_DISC_STRESS),
             radius = rock.values(HFRAC_DISC_RADIUS);
  const double solid = 1.0 - rock.setup().porosity;
  std::vector<Ring> all(9);
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double x = place[2 * i] - 50.0, y = place[2 * i + 1] - 50.0, r = std::hypot(x, y);
    const auto k = static_cast<std::size_t>(r / 5.0);
    if (k >= all.size()) continue;
    const double xx = stress[3 * i], yy = stress[3 * i + 1], xy = stress[3 * i + 2];
    const double radial = (xx * x * x + yy * y * y + 2.0 * xy * x * y) / (r * r),
                 area = radius[i] * radius[i] / solid;
    all[k].radial += area * radial;
    all[k].hoop += area * (xx + yy - radial);
    all[k].area += area;
  }
  for (auto& ring : all) {
    ring.radial /= ring.area;
    ring.hoop /= ring.area;
  }
  return all;
}

TEST(V6Seepage, DiscsTakeOverTheContinuumsState) {
  hfrac::Definition def = rock_with_well();
  verification::Simulation before(def);
  const auto old_rings = rings(before);
  const double radius = before.well(0).equivalent_radius;

  def.initial_state = 1;
  def.initial_well_pressure = 25e6 + excess;
  verification::Simulation seeping(def);
  EXPECT_EQ(seeping.well(0).pressure, 25e6 + excess);
  const auto handed = seeping.values(HFRAC_DOMAIN_PRESSURE), volume = seeping.values(HFRAC_DOMAIN_VOLUME);
  const auto new_rings = rings(seeping);

  before.ramp(0, 25e6 + excess, excess);
  for (int k = 0; k < 20; ++k) before.step_for(1e9);
  const auto own = before.values(HFRAC_DOMAIN_PRESSURE);
  double square = 0.0, all = 0.0;
  for (std::size_t d = 1; d < own.size(); ++d) {
    square += volume[d] * (handed[d] - own[d]) * (handed[d] - own[d]);
    all += volume[d];
  }
  const double rms = std::sqrt(square / all) / excess;
  verification::report_absolute("pressure handed over, against the network's own: rms", rms, 0.0, 0.03);

  BiotMaterial m;  // the stresses do not depend on E
  m.poissons_ratio = 0.186;
  BiotSolver continuum(plate_mesh(100.0, 100.0, {50.0, 50.0}, radius, 64, 32), m,
                       {{RockSide::left, SideMotion::free, true},
                        {RockSide::right, SideMotion::free, true},
                        {RockSide::top, SideMotion::free, true},
                        {RockSide::bottom, SideMotion::free, true},
                        {RockSide::well, SideMotion::free, true}});
  continuum.set_pressure(RockSide::well, excess);
  continuum.set_stress(RockSide::well, {excess, excess, 0.0});
  continuum.load_steady();
  std::vector<Ring> analytic(9);
  for (std::size_t e = 0; e < continuum.mesh().element.size(); ++e) {
    for (int g = 0; g < 16; ++g) {
      const double s = -0.75 + 0.5 * (g % 4), t = -0.75 + 0.5 * (g / 4);
      const auto at = continuum.sample(e, s, t);
      const double x = at.place.x - 50.0, y = at.place.y - 50.0, r = std::hypot(x, y);
      const auto k = static_cast<std::size_t>(r / 5.0);
      if (k >= analytic.size()) continue;
      const double radial = (at.total.xx * x * x + at.total.yy * y * y + 2.0 * at.total.xy * x * y) / (r * r);
      const double weight = r * r;  // elements grow with the distance
      analytic[k].radial += weight * (radial - at.pressure);
      analytic[k].hoop += weight * (at.total.xx + at.total.yy - radial - at.pressure);
      analytic[k].area += weight;
    }
  }
  for (std::size_t k = 2; k < analytic.size(); ++k) {
    const double tolerance = k == 2 ? 0.08 : 0.05;
    const double radial = new_rings[k].radial - old_rings[k].radial,
                 hoop = new_rings[k].hoop - old_rings[k].hoop;
    const double wanted_radial = analytic[k].radial / analytic[k].area,
                 wanted_hoop = analytic[k].hoop / analytic[k].area;
    const std::string ring =
        std::to_string(5 * k) + " to " + std::to_string(5 * k + 5) + " m, over the excess";
    verification::report_absolute("radial stress " + ring, radial / excess, wanted_radial / excess,
                                  tolerance);
    verification::report_absolute("hoop stress " + ring, hoop / excess, wanted_hoop / excess, tolerance);
  }
}

// A finite time lies between the untouched rock and the steady state, and comes near the latter.
TEST(V6Seepage, GrowsWithTime) {
  hfrac::Definition def = rock_with_well();
  def.packing_disc_count = 2000;
  def.stepping_force_ratio = 1e-3;
  def.initial_state = 1;
  def.initial_well_pressure = 25e6 + excess;
  const auto mean_excess = [&](double seconds) {
    def.initial_seepage_time = seconds;
    verification::Simulation rock(def);
    const auto pressure = rock.values(HFRAC_DOMAIN_PRESSURE), volume = rock.values(HFRAC_DOMAIN_VOLUME);
    double sum = 0.0, all = 0.0;
    for (std::size_t d = 1; d < pressure.size(); ++d) {
      sum += volume[d] * (pressure[d] - 25e6);
      all += volume[d];
    }
    return sum / all / excess;
  };
  const double early = mean_excess(1e5), later = mean_excess(3e6), late = mean_excess(1e9),
               steady = mean_excess(0.0);
  std::printf("  mean excess after 1e5, 3e6, 1e8 s and without end: %.4f, %.4f, %.4f, %.4f\n", early, later,
              late, steady);
  EXPECT_LT(early, later);
  EXPECT_LT(later, 0.95 * steady);
  verification::report("mean excess after 1e9 s over that without end", late / steady, 1.0, 1e-3);
}

TEST(V6Seepage, IsRefusedWhereItHasNoMeaning) {
  const auto text_of = [](hfrac::Definition def) -> std::string {
    try {
      const verification::Simulation rock(def);
    } catch (const std::exception& fault) {
      return fault.what();
    }
    return "";
  };
  hfrac::Definition def = rock_with_well();
  def.packing_disc_count = 1000;
  def.initial_state = 1;
  def.initial_well_pressure = 30e6;
  double refused = 0.0;
  hfrac::Definition dry = def;
  dry.flow_scheme = 2;
  refused += text_of(dry).find("needs flow") != std::string::npos ? 1.0 : 0.0;
  hfrac::Definition none = def;
  none.well_count = 0;
  refused += text_of(none).find("around one well, the case has 0") != std::string::npos ? 1.0 : 0.0;
  hfrac::Definition empty = def;
  empty.initial_well_pressure = -1.0;
  refused += text_of(empty).find("below zero absolute pressure") != std::string::npos ? 1.0 : 0.0;
  hfrac::Definition tight = def;
  tight.flow_permeability = 0.0;
  tight.initial_seepage_time = 10.0;
  refused += text_of(tight).find("needs flow.permeability") != std::string::npos ? 1.0 : 0.0;
  verification::report_absolute("cases without a meaning refused with the reason", refused, 4.0, 0.0);
}

}  // namespace V6_seepage
