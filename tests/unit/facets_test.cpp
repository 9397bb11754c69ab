// SPDX-License-Identifier: BSD-3-Clause
// Facets of fractures: breaking a bond changes nothing while the fluid's pressure is what the rock bears.
#include "frac/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "equilibrium/bond_response.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"

namespace hfrac {
namespace {

CaseDefinition confined(double stress) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.packing_disc_count = 600;
  o.contact_mode = static_cast<std::int64_t>(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = 16e9;
  o.contact_shear_stiffness = o.bond_shear_stiffness = 5.6e9;
  o.contact_friction = 5.0;
  o.bond_tensile_strength = o.bond_shear_strength = 1e9;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = stress;
  o.fluid_formation_pressure = 2e6;
  o.stepping_mode = static_cast<std::int64_t>(SteppingMode::coupled);
  o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  o.fracture_law = static_cast<std::int64_t>(FractureLaw::facet);
  return definition;
}

CaseDefinition with_hole(double radius) {
  CaseDefinition definition = confined(20e6);
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = radius;
  well.pressure = 2e6;
  definition.wells.push_back(well);
  return definition;
}

// Every inner bond in turn, broken at the initial equilibrium.
template <class Visit>
void each_facet(const Simulation& s, const Options& o, const Visit& visit) {
  Assembly a = s.assembly();
  Network n = s.network();
  for (std::size_t e = 0; e < a.first.size(); e += 7) {
    if (n.kind[n.left[e]] != DomainKind::rock || n.kind[n.right[e]] != DomainKind::rock) continue;
    Facets facets;
    facets.begin(a, n, {}, o);
    a.intact[e] = 0;
    facets.update(a, n);
    ASSERT_EQ(facets.all().size(), 1U);
    visit(facets, facets.all()[0], a, n);
    a.intact[e] = 1;
    facets.update(a, n);
  }
}

TEST(Facets, ClosedTransmitsWhatTheBondBore) {
  const CaseDefinition definition = confined(20e6);
  const Simulation s(definition, {}, {});
  int seen = 0;
  each_facet(
      s, definition.options, [&](const Facets& facets, const Facet& f, const Assembly& a, const Network& n) {
        ++seen;
        const BondResponse r = respond(a, definition.options, n, facets, f);
        EXPECT_LT(r.gap, 0.0);  // below the stress it bears
        const Vec2 bore = facets.initial_force(f.bond) - (n.pressure[f.left] * facets.part(f.bond, true) +
                                                          n.pressure[f.right] * facets.part(f.bond, false));
        const double size = f.initial_normal;
        EXPECT_NEAR(r.force[0], bore.x, 1e-9 * size);
        EXPECT_NEAR(r.force[1], bore.y, 1e-9 * size);
      });
  EXPECT_GT(seen, 50);
}

TEST(Facets, OpensAtTheInitialStressWithoutAJump) {
  const CaseDefinition definition = confined(20e6);
  const Simulation s(definition, {}, {});
  each_facet(s, definition.options, [&](const Facets& facets, const Facet& f, const Assembly& a, Network& n) {
    const double left = n.pressure[f.left], right = n.pressure[f.right];
    n.pressure[f.left] = n.pressure[f.right] = f.initial_normal / f.length;
    EXPECT_NEAR(facets.opening(a, n, f), 0.0, 1e-12);
    n.pressure[f.left] = n.pressure[f.right] = f.initial_normal / f.length + 1e6;
    // The half discs at the face give way by 1 MPa over the contact's stiffness.
    EXPECT_NEAR(facets.opening(a, n, f), 1e6 * f.length / 16e9, 1e-9);
    n.pressure[f.left] = left;
    n.pressure[f.right] = right;
  });
}

// Round a hole the hoop stress is twice the far field's less the fluid's, and what acts on its wall is the fluid.
TEST(HoledPlate, BearsWhatKirschSays) {
  const HoledPlate plate{20e6, 20e6, {{{50.0, 50.0}, 3.0, 2e6}}};
  const auto wall = plate.at({53.0, 50.0});
  EXPECT_NEAR(wall.xx, 2e6, 1.0);
  EXPECT_NEAR(wall.yy, 38e6, 1.0);
  EXPECT_NEAR(plate.at({350.0, 50.0}).yy, 20e6, 2e3);
  const HoledPlate uneven{30e6, 20e6, {{{0.0, 0.0}, 3.0, 2e6}}};
  EXPECT_NEAR(uneven.at({3.0, 0.0}).yy, 28e6, 1.0);  // 3 sigma_yy - sigma_xx - p
  EXPECT_NEAR(uneven.at({0.0, 3.0}).xx, 68e6, 1.0);
  EXPECT_NEAR(uneven.at({0.0, 3.0}).yy, 2e6, 1.0);
}

// A hole and its slots under the confining stress hold rock as if nothing were cut, whatever shape the hole has: no slot stands open.
TEST(Facets, StayShutAtTheConfiningStress) {
  for (int seed = 1; seed <= 4; ++seed) {
    CaseDefinition definition = with_hole(6.0);
    definition.options.model_seed = seed;
    definition.options.fracture_perforation_length = 12.0;
    definition.options.stepping_flow_step = 100.0;
    const auto widest = [&](double pressure) {
      definition.wells[0].pressure = pressure;
      Simulation s(definition, {}, {});
      for (int k = 0; k < 10; ++k) s.step();
      double most = -1.0;
      for (const Facet& f : s.engine().facets.all())
        most = std::max(most, s.engine().facets.opening(s.assembly(), s.network(), f));
      return most;
    };
    const double shut = widest(20e6), open = widest(21e6);
    std::printf(" seed %d: widest %.3f mm at 20 MPa, %.3f mm at 21 MPa\n", seed, 1e3 * shut, 1e3 * open);
    EXPECT_LT(shut, 0.02 * open);
    EXPECT_GT(open, 1e-3);
  }
}

// Slots of the length asked for, to either side of the hole, no farther off their line than a disc.
TEST(Facets, SlotsAreCutOnBothSides) {
  CaseDefinition definition = with_hole(6.0);
  definition.options.fracture_perforation_length = 12.0;
  const Simulation s(definition, {}, {});
  const double radius = s.wells()[0].place.equivalent_radius, disc = s.assembly().mean_radius;
  double reach[2] = {0.0, 0.0};
  for (const Facet& f : s.engine().facets.all()) {
    EXPECT_TRUE(f.slot);
    EXPECT_LT(std::abs(f.middle.y - 50.0), 2.0 * disc);
    double& side = reach[f.middle.x > 50.0 ? 1 : 0];
    side = std::max(side, std::abs(f.middle.x - 50.0));
  }
  for (const double r : reach) {
    EXPECT_GT(r, radius + 12.0 - 2.0 * disc);
    EXPECT_LT(r, radius + 12.0 + 2.0 * disc);
  }
}

// Slots release the force that Kirsch's plate bears where they are, wherever between the discs of the wall the hole's pores end.
TEST(Facets, ReleaseTheForceOfThePlate) {
  constexpr double hmin = 20e6, difference = 10e6;
  double square = 0.0;
  int sides = 0;
  for (int seed = 1; seed <= 4; ++seed) {
    CaseDefinition definition = with_hole(6.0);
    definition.options.model_seed = seed;
    definition.options.stress_sigma_Hmax = hmin + difference;
    definition.options.fracture_perforation_length = 12.0;
    const Simulation s(definition, {}, {});
    const double a = s.wells()[0].place.equivalent_radius;
    for (const double side : {1.0, -1.0}) {
      double across = 0.0, covered = 0.0, to = 0.0;
      for (const Facet& f : s.engine().facets.all()) {
        if (side * (f.middle.x - 50.0) < 0.0) continue;
        const double up = f.normal.y > 0.0 ? 1.0 : -1.0;
        across += up * (f.initial_normal * f.normal.y + f.initial_shear * f.normal.x);
        covered += up * f.normal.y * f.length;
        for (const double length : {f.left_length, f.right_length})
          to = std::max(to, std::abs(f.middle.x - 50.0) + length);
      }
      // Of the difference alone: its hoop stress from the circle of the hole to the slot's end.
      const double wanted = 0.5 * difference * (std::pow(a, 4) / std::pow(to, 3) - a * a / to);
      const double off = (across - hmin * covered - wanted) / (hmin * covered);
      square += off * off;
      ++sides;
    }
  }
  EXPECT_LT(std::sqrt(square / sides),
            0.008);  // 0.006; 0.010 without what lies between the wall's contacts and its circle
}

// E' that is not given is the packing's own: near what its laboratory test says, undrained; and what is measured acts as if it were given.
TEST(Facets, MeasureThePlaneModulusThatIsNotGiven) {
  CaseDefinition definition = with_hole(6.0);
  definition.options.bond_fracture_toughness = 5e6;
  definition.options.bond_tensile_strength = 20e6;
  definition.options.bond_shear_strength = 60e6;
  Simulation measured(definition, {}, {});
  const double modulus = measured.setup().plane_modulus;
  EXPECT_NEAR(modulus, 18.6e9, 0.1 * 18.6e9);  // docs/verification/kgd-random.md: 1.3 of the drained one
  EXPECT_EQ(measured.options().fracture_plane_modulus, modulus);
  definition.options.fracture_plane_modulus = modulus;
  Simulation given(definition, {}, {});
  EXPECT_EQ(given.setup().plane_modulus, modulus);
  measured.step();
  given.step();
  EXPECT_EQ(measured.state_hash(), given.state_hash());
}

// A fracture that grows from slots: its fluid is accounted for, and a simulation put back to an image goes on with the same bits.
TEST(Facets, GrowWithoutLosingFluidAndGoOnFromAnImage) {
  CaseDefinition definition = with_hole(6.0);
  Options& o = definition.options;
  o.fracture_perforation_length = 4.0;
  o.fracture_plane_modulus = 18.6e9;
  o.bond_fracture_toughness = 5e6;
  o.bond_tensile_strength = 20e6;
  o.bond_shear_strength = 60e6;
  o.fluid_viscosity = 0.01;
  o.stepping_flow_step = 5.0;
  o.stop_extent_fraction = 1.0;
  definition.wells[0].control = WellControl::rate;
  definition.wells[0].rate = 3e-2;
  Simulation s(definition, {}, {});
  while (s.cracks().size() < 12 && s.time() < 500.0) s.step();
  ASSERT_GE(s.cracks().size(), 12U);
  const Balance balance = s.balance();
  EXPECT_LT(std::abs(balance.fluid_error), 1e-12 * balance.injected);
  // The volume that it is said to have is what its pores gained since their first bond broke.
  double gained = 0.0, before = 0.0;
  for (std::int64_t d = 0; d < s.network().domain_count(); ++d) {
    if (!s.engine().facets.fractured(d) || s.network().kind[d] != DomainKind::rock) continue;
    gained += s.network().volume_change[d];
    before += s.network().facet_offset[d];
  }
  const double volume = s.fractures()[0].volume;
  std::printf(" volume %.6f m2, its pores gained %.6f m2\n", volume, gained - before);
  EXPECT_NEAR(volume, gained - before, 0.01 * volume);
  std::vector<std::byte> image(s.image_size());
  s.write_image(image);
  const auto go_on = [](Simulation& of) {
    for (int k = 0; k < 4; ++k) of.step();
    return of.state_hash();
  };
  const auto cracks = s.cracks().size();
  const auto hash = go_on(s);
  EXPECT_GT(s.cracks().size(), cracks);
  s.restore(image);
  EXPECT_EQ(go_on(s), hash);
  Simulation other(definition, {}, {});
  other.restore(image);
  EXPECT_EQ(go_on(other), hash);
}

// On one bond a disc at the hole's wall is a cantilever, which the stress that the slot releases pries off, and the wall with it. In
// these packings the straightest way leaves such a disc, and one that is no steeper does not.
TEST(Facets, SlotsLeaveDiscsTwoBondsWhereTheyAreNoSteeperForIt) {
  CaseDefinition definition = with_hole(4.3);
  definition.options.fracture_perforation_length = 2.6;
  for (const std::int64_t seed : {2, 13}) {
    definition.options.model_seed = seed;
    const Simulation s(definition, {}, {});
    const Assembly& a = s.assembly();
    std::vector<int> bonds(static_cast<std::size_t>(a.disc_count()));
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      bonds[a.first[e]] += a.intact[e];
      bonds[a.second[e]] += a.intact[e];
    }
    ASSERT_GE(s.cracks().size(), 2U);
    for (const auto& crack : s.cracks()) {
      EXPECT_GE(bonds[a.first[crack.bond]], 2) << "seed " << seed;
      EXPECT_GE(bonds[a.second[crack.bond]], 2) << "seed " << seed;
    }
  }
}

// Two stages, each with its own perforations; a third as the options say of all.
TEST(Facets, AreCutAsEachWellsPerforationsSay) {
  CaseDefinition definition = with_hole(5.0);
  Options& o = definition.options;
  o.packing_disc_count = 3000;
  o.fracture_perforation_length = 3.0;
  o.fracture_perforation_azimuth = 0.5 * std::numbers::pi;
  definition.wells.resize(3, definition.wells[0]);
  definition.wells[0].x = 22.0;
  definition.wells[2].x = 78.0;
  definition.wells[0].perforation_length = 7.0;  // along x
  definition.wells[1].perforation_length = 7.0;
  definition.wells[1].perforation_azimuth = 0.25 * std::numbers::pi;
  Simulation s(definition, {}, {});
  const auto sums =
      [&](std::size_t
              well) {  // of the facets around a well: of their middles' distances from it along x and y, and their product
        double xx = 0.0, yy = 0.0, xy = 0.0, far = 0.0;
        for (const Facet& f : s.engine().facets.all()) {
          const Vec2 from = f.middle - Vec2{definition.wells[well].x, definition.wells[well].y};
          if (norm(from) > 14.0) continue;
          xx += from.x * from.x;
          yy += from.y * from.y;
          xy += from.x * from.y;
          far = std::max(far, norm(from));
        }
        return std::array{0.5 * std::atan2(2.0 * xy, xx - yy), far};
      };
  EXPECT_NEAR(sums(0)[0], 0.0, 0.15);
  EXPECT_NEAR(sums(1)[0], 0.25 * std::numbers::pi, 0.15);
  EXPECT_NEAR(std::abs(sums(2)[0]), 0.5 * std::numbers::pi, 0.15);
  EXPECT_NEAR(sums(0)[1] - sums(2)[1], 4.0, 2.0);  // a disc's diameter
}

TEST(Facets, AreRefusedWhereTheyAreNotKnown) {
  CaseDefinition definition = confined(20e6);
  definition.options.stepping_mode = static_cast<std::int64_t>(SteppingMode::substep);
  EXPECT_ANY_THROW(Simulation(definition, {}, {}));
  definition = confined(20e6);
  definition.options.fracture_law = static_cast<std::int64_t>(FractureLaw::bond);
  definition.options.fracture_perforation_length = 1.0;
  EXPECT_ANY_THROW(Simulation(definition, {}, {}));
  definition.options.fracture_perforation_length = 0.0;
  definition.options.rock_biot_coefficient = 0.5;
  EXPECT_ANY_THROW(Simulation(definition, {}, {}));  // contacts push with what the rock's pores do
  definition = confined(20e6);
  definition.options.rock_biot_coefficient = 0.1;
  EXPECT_ANY_THROW(Simulation(definition, {}, {}));  // below the packing's porosity
  definition.options.rock_porosity = 0.2;
  EXPECT_ANY_THROW(Simulation(definition, {}, {}));
}

// Pores store what fluid and grains do, and push with alpha times their pressure; a well's are not rock.
TEST(Rock, OfGivenPorosityAndBiotCoefficient) {
  CaseDefinition definition = with_hole(6.0);
  const Simulation before(definition, {}, {});
  definition.options.rock_biot_coefficient = 0.4;
  definition.options.rock_porosity = 0.01;
  definition.options.rock_grain_modulus = 45e9;
  const Simulation s(definition, {}, {});
  const Network &n = s.network(), &packing = before.network();
  double pores = 0.0, voids = 0.0, storing = 0.0;
  for (std::size_t d = 1; d < n.kind.size(); ++d) {
    if (n.kind[d] == DomainKind::well) {
      EXPECT_EQ(n.volume[d], packing.volume[d]);
      EXPECT_EQ(n.storing[d], n.volume[d]);
      continue;
    }
    pores += n.volume[d];
    voids += packing.volume[d];
    storing += n.storing[d];
    for (auto k = 2 * n.corner_start[d]; k < 2 * n.corner_start[d + 1]; ++k)
      EXPECT_NEAR(n.corner_weight[k], 0.4 * packing.corner_weight[k], 1e-12);
  }
  const double area = pores / 0.01, fluid = definition.options.fluid_bulk_modulus;
  EXPECT_NEAR(n.porosity_share, pores / voids, 1e-12);
  EXPECT_GT(voids / area, 0.08);
  EXPECT_LT(voids / area, 0.2);
  EXPECT_NEAR(storing / fluid / area, 0.01 / fluid + 0.39 / 45e9, 1e-18);
}

}  // namespace
}  // namespace hfrac
