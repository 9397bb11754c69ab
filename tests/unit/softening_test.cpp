// SPDX-License-Identifier: BSD-3-Clause
// Bonds that soften by a fracture energy: the law of one, energy in motion, tangents, images, and what is refused.
#include "solid/softening.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "small_case.hpp"
#include "tangent_check.hpp"

namespace softening_test {

using namespace testing_unit;

Options soft_options() {
  Options o = dry_options(9);
  o.contact_mode = choice(ContactMode::after_break);
  o.bond_normal_stiffness = 16e9;
  o.bond_shear_stiffness = 5.6e9;
  o.bond_tensile_strength = 10e6;
  o.bond_shear_strength = 15e6;
  o.bond_fracture_energy = 50e3;
  return o;
}

// One bond of a small square lattice, whose second disc is moved and turned; what it comes to is kept.
struct OneBond {
  explicit OneBond(const Options& given = soft_options()) : model(given, square_lattice(3, 3, 0.5)) {
    while (std::abs(a.dy(bond)) > 0.0) ++bond;  // along x
    area = 2.0 * a.bond_radius(bond);
  }

  BondView go(double open, double across, double turned) {
    const auto j = a.second[bond];
    a.ux[j] = open;
    a.uy[j] = across;
    a.rotation[j] = turned;
    model.solver->evaluate();
    return view_bond(a, model.options, bond);
  }

  // Work done on the bond along a straight way from rest, by the trapezoidal rule.
  double work_to(double open, double across, double turned, int steps) {
    double work = 0.0, u = 0.0, s = 0.0, b = 0.0;
    BondView before = go(0.0, 0.0, 0.0);
    for (int k = 1; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const BondView now = go(share * open, share * across, share * turned);
      work += 0.5 * (now.bond_normal + before.bond_normal) * (now.gap - u) +
              0.5 * (now.bond_shear + before.bond_shear) * (now.shear - s) +
              0.5 * (now.bond_moment + before.bond_moment) * (share * turned - b);
      u = now.gap;
      s = now.shear;
      b = share * turned;
      before = now;
    }
    return work;
  }

  TestModel model;
  Assembly& a = model.assembly;
  const Options& o = model.options;
  std::int64_t bond = 0;
  double area = 0.0;
};

TEST(Softening, TractionFallsLinearlyAndUnloadsToTheOrigin) {
  OneBond one;
  const double peak = one.o.bond_tensile_strength * one.area, start = peak / one.o.bond_normal_stiffness,
               end = 2.0 * one.o.bond_fracture_energy / one.o.bond_tensile_strength;
  double farthest = 0.0;
  for (const double w : {0.5 * start, start, 1.5 * start, 0.3 * end, 0.6 * end, 0.2 * end, 0.9 * end}) {
    const BondView view = one.go(w, 0.0, 0.0);
    farthest = std::max(farthest, w);
    const double line =
        farthest <= start ? one.o.bond_normal_stiffness * farthest : peak * (end - farthest) / (end - start);
    EXPECT_NEAR(view.bond_normal, line * w / farthest, 1e-9 * peak) << w;
    EXPECT_NEAR(view.tensile_excess, farthest / end, 1e-9);
    EXPECT_FALSE(view.breaks());
  }
  // Pressure is borne whole, tension after it by what is left.
  EXPECT_NEAR(one.go(-start, 0.0, 0.0).bond_normal, -peak, 1e-9 * peak);
  EXPECT_NEAR(one.go(0.5 * end, 0.0, 0.0).bond_normal, peak * (end - farthest) / (end - start) * 0.5 / 0.9,
              1e-9 * peak);
  EXPECT_TRUE(one.go(1.0001 * end, 0.0, 0.0).breaks());
  EXPECT_EQ(one.go(0.1 * end, 0.0, 0.0).bond_normal, 0.0);
}

TEST(Softening, BeginWhereBrittleOnesBreak) {
  OneBond one;
  // Bending counts in the extreme fibre (eq. 21); shear has its own strength.
  const double start = one.o.bond_tensile_strength * one.area / one.o.bond_normal_stiffness,
               radius = 0.5 * one.area;
  one.go(0.5 * start, 0.0, 0.499 * start / radius);
  EXPECT_EQ(one.a.softening.start[one.bond], 0.0);
  one.go(0.5 * start, 0.0, 0.501 * start / radius);
  EXPECT_GT(one.a.softening.start[one.bond], 0.0);
  OneBond other;
  const double slide = one.o.bond_shear_strength * one.area / one.o.bond_shear_stiffness;
  other.go(0.0, 0.999 * slide, 0.0);
  EXPECT_EQ(other.a.softening.start[other.bond], 0.0);
  other.go(0.0, 1.001 * slide, 0.0);
  EXPECT_GT(other.a.softening.start[other.bond], 0.0);
}

TEST(Softening, TakesTheEnergyGivenWhateverTheWay) {
  const struct {
    const char* name;
    double open, across, turned;
  } ways[] = {{"tension", 0.02, 0.0, 0.0},
              {"shear", 0.0, 0.05, 0.0},
              {"bending", 0.0, 0.0, 0.1},
              {"tension and shear", 0.02, 0.01, 0.0},
              {"all", 0.01, -0.01, 0.03}};
  for (const auto& way : ways) {
    OneBond one;
    const double given = one.o.bond_fracture_energy * one.area;
    const double work = one.work_to(way.open, way.across, way.turned, 20000);
    EXPECT_TRUE(view_bond(one.a, one.o, one.bond).breaks()) << way.name;
    EXPECT_NEAR(work / given, 1.0, 1e-3) << way.name;
    EXPECT_NEAR(energy_taken(one.a, one.o, one.bond) / given, 1.0, 1e-9) << way.name;
    std::printf("  %s: work over G_c A %.5f\n", way.name, work / given);
  }
  // Round about: half in tension, back, the rest in shear. What it takes is kept by the state alone.
  OneBond one;
  double work = one.work_to(0.006, 0.0, 0.0, 5000);
  const double half = energy_taken(one.a, one.o, one.bond);
  EXPECT_GT(half, 0.1 * one.o.bond_fracture_energy * one.area);
  EXPECT_LT(half, 0.9 * one.o.bond_fracture_energy * one.area);
  work -= view_bond(one.a, one.o, one.bond).bond_energy;  // given back on the way to rest
  work += one.work_to(0.0, 0.05, 0.0, 20000);
  EXPECT_NEAR(work / (one.o.bond_fracture_energy * one.area), 1.0, 1e-3);
}

TEST(Softening, OfABondThatStoresMoreIsSteep) {
  Options o = soft_options();
  o.bond_shear_strength = 60e6;  // stores 4 times 80 kJ/m2
  OneBond one(o);
  const double slide = o.bond_shear_strength / o.bond_shear_stiffness;
  const double stored = 0.5 * o.bond_shear_stiffness * slide * slide;
  EXPECT_GT(stored, o.bond_fracture_energy);
  EXPECT_NEAR(one.work_to(0.0, 0.05, 0.0, 20000) / (steepest_softening * stored), 1.0, 1e-3);
}

TEST(Softening, TangentIsThatOfTheForces) {
  OneBond one;
  const double start = one.o.bond_tensile_strength * one.area / one.o.bond_normal_stiffness;
  const auto check = [&](const char* name, double open, double across, double turned) {
    SCOPED_TRACE(name);
    const auto j = one.a.second[one.bond];
    one.a.ux[j] = open;
    one.a.uy[j] = across;
    one.a.rotation[j] = turned;
    expect_tangent(one.a, one.o, one.bond, 1e-8, 1e-4 * one.o.bond_normal_stiffness);
  };
  check("begins, pulled", 2.0 * start, 0.7 * start, 0.5 * start);
  check("begins, sheared", 0.3 * start, 8.0 * start, -0.5 * start);
  check("begins, bent under pressure", -0.2 * start, 0.1 * start, 4.0 * start);
  one.go(2.0 * start, 0.5 * start, 0.0);
  check("goes on", 3.0 * start, -0.9 * start, 0.8 * start);
  check("unloads", 1.0 * start, 0.3 * start, 0.2 * start);
  check("is pressed and slides on", -0.5 * start, 6.0 * start, 0.2 * start);
  check("is gone", 30.0 * start, 6.0 * start, 0.2 * start);
}

// Damage, motion and breaking between two cycles: a block torn apart in real motion, without damping.
double energy_drift(double energy, double safety) {
  Options o = soft_options();
  o.packing_disc_count = 300;
  o.bond_fracture_energy = energy;
  o.stepping_safety = safety;
  TestModel m(o, packed(o));
  m.solver->use_real_masses();
  m.solver->set_damping(0.0);
  double kinetic = 0.0;
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.vy[i] = (m.assembly.y[i] > 10.0 ? 1.0 : -1.0) * 8.0;
    kinetic += 0.5 * m.assembly.mass(i) * 64.0;
  }
  CrackLog log;
  double worst = 0.0;
  for (int look = 0; look < 40; ++look) {
    m.solver->run(std::llround(40.0 / safety), log);
    const double now = m.solver->kinetic_energy() + m.elastic_energy() + m.solver->energies().fracture +
                       m.solver->energies().friction + energy_taken(m.assembly, m.options);
    worst = std::max(worst, std::abs(now / kinetic - 1.0));
  }
  EXPECT_GT(log.size(), 20U);
  for (const auto& crack : log)
    EXPECT_GE(crack.energy, 0.999 * energy * 2.0 * m.assembly.bond_radius(crack.bond));
  std::printf("  G_c %.3g J/m2, safety %.1f: %zu cracks, energy off by %.2e of all\n", energy, safety,
              log.size(), worst);
  return worst;
}

TEST(Softening, LosesNoEnergyInMotion) {
  const double brittle = energy_drift(0.0, 0.8), soft = energy_drift(30e3, 0.8);
  EXPECT_LT(soft, brittle);
  EXPECT_LT(energy_drift(30e3, 0.2), 0.25 * soft);
}

CaseDefinition soft_case() {
  CaseDefinition definition = cracking_case();
  Options& o = definition.options;
  o.packing_disc_count = 600;
  make_linear(o);
  o.bond_tensile_strength = 20e6;
  o.bond_shear_strength = 40e6;
  o.bond_fracture_energy = 100e3;
  return definition;
}

struct Way {
  SteppingMode mode;
  SolverKind kind;
};

CaseDefinition soft_case(const Way& way) {
  CaseDefinition definition = soft_case();
  definition.options.solver_kind = choice(way.kind);
  definition.options.stepping_mode = choice(way.mode);
  if (way.mode != SteppingMode::substep) definition.options.stepping_flow_step = 5e-3;
  return definition;
}

// Any number of workers, and a run from an image, have the same bits.
void expect_state(const Way& way) {
  CaseDefinition definition = soft_case(way);
  std::uint64_t hash = 0;
  for (const int workers : {1, 3}) {
    definition.options.run_workers = workers;
    Simulation sim(definition, {}, {});
    for (int k = 0; k < 2; ++k) sim.step();
    std::vector<std::byte> image(sim.image_size());
    sim.write_image(image);
    const auto before = sim.state_hash();
    const auto& start = sim.engine().model.assembly.softening.start;
    EXPECT_TRUE(std::any_of(start.begin(), start.end(), [](double w) { return w > 0.0; }));
    sim.step();
    const auto after = sim.state_hash();
    EXPECT_NE(after, before);
    EXPECT_TRUE(hash == 0 || after == hash) << workers;
    hash = after;
    Simulation other(definition, {}, {});
    for (Simulation* any : {&sim, &other}) {
      any->restore(image);
      EXPECT_EQ(any->state_hash(), before);
      any->step();
      EXPECT_EQ(any->state_hash(), after);
    }
  }
}

TEST(Softening, IsPartOfTheState) {
  expect_state({SteppingMode::substep, SolverKind::explicit_solver});
  expect_state({SteppingMode::substep, SolverKind::quasi_static});
}

TEST(SofteningSlow, IsPartOfTheState) {
  expect_state({SteppingMode::dynamic, SolverKind::explicit_solver});
  expect_state({SteppingMode::coupled, SolverKind::quasi_static});
}

// What is off goes with the length of a cycle: kinetic energy is that of half a cycle before.
TEST(Softening, BalancesEnergyInSteps) {
  const auto error = [](SteppingMode mode, double safety) {
    CaseDefinition definition = soft_case({mode, SolverKind::explicit_solver});
    definition.options.stepping_safety = safety;
    Simulation sim(definition, {}, {});
    for (int k = 0; k < 3; ++k) sim.step();
    const Balance b = balance_of(sim.engine());
    EXPECT_GT(b.fracture, 0.03 * b.fluid_work);
    std::printf("  safety %.1f: %zu cracks, energy error %.2e of the fluid's work\n", safety,
                sim.engine().model.cracks.size(), b.energy_error / b.fluid_work);
    return std::abs(b.energy_error / b.fluid_work);
  };
  for (const SteppingMode mode : {SteppingMode::substep, SteppingMode::dynamic}) {
    const double fine = error(mode, 0.2);
    EXPECT_LT(fine, 1e-3);
    EXPECT_LT(fine, 0.5 * error(mode, 0.8));
  }
}

TEST(Softening, LogsWhatABondBoreAndTook) {
  OneBond one;
  one.go(0.0011, 0.0, 0.0);
  one.go(0.02, 0.0, 0.0);
  CrackLog log;
  one.model.solver->break_bond(one.bond, log);
  ASSERT_EQ(log.size(), 1U);
  EXPECT_NEAR(log[0].normal_force, one.o.bond_tensile_strength * one.area, 1.0);
  EXPECT_NEAR(log[0].energy, one.o.bond_fracture_energy * one.area, 1e-6 * log[0].energy);
  EXPECT_EQ(log[0].mode, CrackMode::tension);
  EXPECT_EQ(one.model.solver->energies().fracture, 0.0);  // none was left to release
}

// Smooth joints keep their own law beside bonds that soften; flat contacts and temperature go with it.
TEST(Softening, GoesWithJointsFlatContactsAndTemperature) {
  CaseDefinition definition = soft_case();
  Options& o = definition.options;
  o.contact_shape = choice(ContactShape::flat);
  o.thermal_mode = choice(ThermalMode::uniform);
  o.stepping_safety = 0.4;
  JointOptions joint;
  joint.state = choice(JointState::smooth_bonded);
  joint.x1 = 20.0;
  joint.x2 = 80.0;
  joint.y1 = joint.y2 = 65.0;
  definition.joints = {joint};
  Simulation sim(definition, {}, {});
  for (int k = 0; k < 2; ++k) sim.step();
  const Assembly& a = sim.engine().model.assembly;
  ASSERT_FALSE(a.smooth.empty());
  for (const auto& contact : a.smooth.contacts) EXPECT_EQ(a.softening.start[contact.bond], 0.0);
  EXPECT_GT(energy_taken(a, o), 0.0);
  const Balance b = balance_of(sim.engine());
  EXPECT_LT(std::abs(b.energy_error), 3e-3 * b.fluid_work);
}

TEST(Softening, IsRefusedWhereItMeansNothing) {
  const auto refused = [](const auto& change, const std::string& word) {
    CaseDefinition definition = soft_case();
    change(definition);
    try {
      validate(definition);
      ADD_FAILURE() << "not refused: " << word;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  validate(soft_case());
  refused([](CaseDefinition& c) { c.options.bond_fracture_toughness = 50e6; }, "bond.fracture_toughness");
  refused([](CaseDefinition& c) { c.options.bond_toughness_reference_radius = 1.0; }, "reference_radius");
  refused([](CaseDefinition& c) { c.options.fracture_law = choice(FractureLaw::facet); }, "fracture.law");
  refused([](CaseDefinition& c) { c.options.bond_smallest_fragment = 2; }, "smallest_fragment");
  refused([](CaseDefinition& c) { c.options.bond_shear_strength = 0.0; }, "bond.shear_strength");
  refused(
      [](CaseDefinition& c) {
        c.options.thermal_mode = choice(ThermalMode::uniform);
        c.options.thermal_parameters = choice(ThermalParameters::table);
      },
      "thermal.parameters");
  refused(
      [](CaseDefinition& c) {
        c.joints.emplace_back();
        c.joints[0].x1 = 30.0;
        c.joints[0].x2 = 50.0;
        c.joints[0].y1 = c.joints[0].y2 = 30.0;
      },
      "joint[0]");
  // Discs too large for the energy.
  CaseDefinition definition = soft_case();
  definition.options.bond_fracture_energy = 10e3;
  try {
    const Simulation sim(definition, {}, {});
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    const std::string text = error.what();
    for (const char* word : {"bond.fracture_energy = 10000 J/m2", "largest bond radius", "smaller discs"})
      EXPECT_NE(text.find(word), std::string::npos) << text;
  }
}

}  // namespace softening_test
