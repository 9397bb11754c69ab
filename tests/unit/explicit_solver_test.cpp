// SPDX-License-Identifier: BSD-3-Clause
// Newton's law, cycle by cycle: energy is kept without damping, rest is found with it, and the number of
// workers changes no bit.
#include "solid/explicit_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "model.hpp"

namespace explicit_solver_test {

using namespace testing_unit;

struct Velocities {
  Array<double> x, y, spin;
};

Velocities velocities(const TestModel& m) {
  return {m.assembly.vx, m.assembly.vy, m.assembly.spin};
}

// Half of sum m v- v+ over the velocities half a step before and after: with the elastic energy between them,
// what the leap-frog keeps exactly as long as forces are linear.
double kinetic_between(const TestModel& m, const Velocities& before) {
  double energy = 0.0;
  for (std::size_t i = 0; i < before.x.size(); ++i) {
    energy += 0.5 * m.assembly.mass(i) * (before.x[i] * m.assembly.vx[i] + before.y[i] * m.assembly.vy[i]) +
              0.5 * m.assembly.inertia(i) * before.spin[i] * m.assembly.spin[i];
  }
  return energy;
}

TEST(ExplicitSolver, KeepsEnergyWithoutDamping) {
  Options o = dry_options(400);
  o.contact_mode = choice(ContactMode::after_break);
  TestModel m(o, packed(o));
  m.solver->use_real_masses();
  m.solver->set_damping(0.0);
  EXPECT_EQ(m.solver->step(), m.solver->real_step());
  m.shake(1e-7, 4);
  CrackLog log;
  double first = 0.0, worst = 0.0, largest_kinetic = 0.0;
  for (int look = 0; look <= 100; ++look) {
    const double elastic = m.elastic_energy();
    const Velocities before = velocities(m);
    m.solver->run(1, log);
    const double kinetic = kinetic_between(m, before), energy = elastic + kinetic;
    if (look == 0) first = energy;
    worst = std::max(worst, std::abs(energy / first - 1.0));
    largest_kinetic = std::max(largest_kinetic, kinetic);
    m.solver->run(19, log);
  }
  RecordProperty("energy_drift", std::to_string(worst));
  EXPECT_LT(worst, 1e-6);                   // V13 of physics.md, over 2 000 cycles
  EXPECT_GT(largest_kinetic, 0.2 * first);  // it did move
  EXPECT_TRUE(log.empty());
}

TEST(ExplicitSolver, KeepsMomentum) {
  Options o = dry_options(300);
  TestModel m(o, packed(o));
  m.solver->use_real_masses();
  m.solver->set_damping(0.0);
  m.shake(1e-5, 8);
  CrackLog log;
  m.solver->run(500, log);
  double px = 0.0, py = 0.0, size = 0.0;
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    px += m.assembly.mass(i) * m.assembly.vx[i];
    py += m.assembly.mass(i) * m.assembly.vy[i];
    size += m.assembly.mass(i) * std::abs(m.assembly.vx[i]);
  }
  EXPECT_LT(std::abs(px), 1e-10 * size);
  EXPECT_LT(std::abs(py), 1e-10 * size);
}

TEST(ExplicitSolver, FindsRestUnderLoad) {
  Options o = dry_options(400);
  o.stress_sigma_Hmax = 2e7;
  o.stress_sigma_hmin = 1e7;
  TestModel m(o, packed(o));
  m.boundary->set_load(m.assembly, 1.0);
  CrackLog log;
  const auto outcome = m.solver->relax(1e-4, 50000, log);
  EXPECT_TRUE(outcome.at_rest);
  EXPECT_LE(outcome.force_ratio, 1e-4);
  EXPECT_EQ(m.solver->total_cycles(), outcome.cycles);
  // Work of a constant load that is put on at once: twice the energy stored, the other half damped away.
  const double stored = m.elastic_energy(), work = m.boundary->load_work(m.assembly);
  EXPECT_NEAR(
      work,
      stored + m.solver->energies().damping + m.solver->energies().friction + m.solver->kinetic_energy(),
      1e-2 * work);
}

struct Ran {
  Ran(const Options& o, int workers) : model(o, packed(o), {{{10.0, 10.0}, 3.0}}, workers) {}
  TestModel model;
  CrackLog log;
};

std::unique_ptr<Ran> run_with(int workers) {
  Options o = dry_options(900);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.boundary_kind = choice(BoundaryKind::walls);
  o.stress_convention = choice(StressConvention::effective);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 1e7;
  o.bond_tensile_strength = 4e6;
  o.bond_shear_strength = 2e7;
  auto ran = std::make_unique<Ran>(o, workers);
  TestModel& m = ran->model;
  m.boundary->set_load(m.assembly, 1.0);
  m.fill_pores();
  m.solver->set_undrained(true);
  m.network.pressure[m.well_domains[0]] = 3e7;
  m.solver->run(300, ran->log);
  return ran;
}

TEST(ExplicitSolver, GivesTheSameBitsWithAnyNumberOfWorkers) {
  const auto one = run_with(1);
  ASSERT_FALSE(one->log.empty());
  for (const int workers : {2, 3}) {
    const auto more = run_with(workers);
    EXPECT_TRUE(same_bits(one->model.assembly.ux, more->model.assembly.ux)) << workers;
    EXPECT_TRUE(same_bits(one->model.assembly.uy, more->model.assembly.uy)) << workers;
    EXPECT_TRUE(same_bits(one->model.assembly.rotation, more->model.assembly.rotation)) << workers;
    EXPECT_TRUE(same_bits(one->model.assembly.vx, more->model.assembly.vx)) << workers;
    EXPECT_TRUE(same_bits(one->model.assembly.slip, more->model.assembly.slip)) << workers;
    EXPECT_TRUE(same_bits(one->model.assembly.intact, more->model.assembly.intact)) << workers;
    EXPECT_TRUE(same_bits(one->model.network.pressure, more->model.network.pressure)) << workers;
    EXPECT_EQ(one->model.solver->energies().damping, more->model.solver->energies().damping);
    EXPECT_EQ(one->model.solver->energies().friction, more->model.solver->energies().friction);
    EXPECT_EQ(one->model.solver->energies().fluid, more->model.solver->energies().fluid);
    EXPECT_EQ(one->model.solver->energies().fracture, more->model.solver->energies().fracture);
    ASSERT_EQ(one->log.size(), more->log.size());
    for (std::size_t c = 0; c < one->log.size(); ++c) {
      EXPECT_EQ(one->log[c].bond, more->log[c].bond);
      EXPECT_EQ(one->log[c].cycle, more->log[c].cycle);
      EXPECT_EQ(one->log[c].normal_force, more->log[c].normal_force);
    }
  }
}

TEST(ExplicitSolver, SaysSoWhenForcesAreNoNumbers) {
  Options o = dry_options(300);
  TestModel m(o, packed(o));
  m.assembly.ux[5] = std::nan("");
  CrackLog log;
  EXPECT_THROW(m.solver->run(20, log), Error);
}

TEST(ExplicitSolver, CanBeInterrupted) {
  Options o = dry_options(300);
  TestModel m(o, packed(o));
  m.shake(1e-4, 2);
  CrackLog log;
  int asked = 0;
  const auto outcome = m.solver->run(100000, log, [&] { return ++asked == 3; });
  EXPECT_TRUE(outcome.stopped);
  EXPECT_LT(outcome.cycles, 1000);
}

}  // namespace explicit_solver_test
