// SPDX-License-Identifier: BSD-3-Clause
// One flow step: nothing is lost or made, both schemes agree, a vapour-filled pore fills before its pressure
// rises, imposed pressures stay.
#include "flow/flow_solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "linear/multigrid_arrays.hpp"
#include "small_case.hpp"
#include "solid/stable_step.hpp"

namespace flow_solver_test {

using namespace testing_unit;

// Rigid rock of equal pipes, one of them wide; pores at the reference pressure.
std::unique_ptr<TestModel> flow_model(FlowScheme scheme, double wide = 1e-3, std::int64_t discs = 400) {
  Options o = dry_options(discs);
  o.flow_scheme = choice(scheme);
  if (discs > 2000) o.packing_method = choice(PackingMethod::tiled);
  auto model = std::make_unique<TestModel>(o, packed(o), std::vector<Hole>{{{10.0, 10.0}, 3.0}});
  TestModel& m = *model;
  m.fill_pores();
  for (std::size_t e = 0; e < m.network.left.size(); ++e) {
    const double w = e == m.network.left.size() / 2 ? wide : 5e-5;
    m.network.aperture[e] = w;
    const double length = m.assembly.radius[m.assembly.first[e]] + m.assembly.radius[m.assembly.second[e]];
    m.network.conductance[e] =
        m.network.left[e] == m.network.right[e] ? 0.0 : w * w * w / (12.0 * o.fluid_viscosity * length);
  }
  return model;
}

void close_outside(TestModel& m) {
  for (std::size_t e = 0; e < m.network.left.size(); ++e) {
    if (m.network.left[e] == 0 || m.network.right[e] == 0) m.network.conductance[e] = 0.0;
  }
}

void set_pressure(TestModel& m, std::int64_t d, double p) {
  m.network.pressure[d] = p;
  if (m.network.stiffness[d] > 0.0)
    m.network.content[d] = content_at(m.network, d, m.options.fluid_bulk_modulus, p);
}

TEST(FlowSolver, KeepsContent) {
  for (const auto scheme : {FlowScheme::implicit_scheme, FlowScheme::explicit_scheme}) {
    const auto model = flow_model(scheme, 1e-4);
    TestModel& m = *model;
    close_outside(m);
    // The well as a pore like the others.
    const auto well = m.well_domains[0];
    m.network.stiffness[well] = m.options.fluid_bulk_modulus / m.network.volume[well];
    Random random(3);
    for (std::int64_t d = 1; d < m.network.domain_count(); ++d)
      set_pressure(m, d, 25e6 + 1e7 * random.uniform());
    const double before = sum(m.network.content) - m.network.content[0];
    FlowSolver flow(m.network, m.options);
    for (int step = 0; step < 10; ++step) flow.advance(m.network, 10.0, {});
    const double after = sum(m.network.content) - m.network.content[0];
    EXPECT_NEAR(after, before, 1e-12 * before);
  }
}

TEST(FlowSolver, BalancesSourcesAndFlowsToTheOutside) {
  for (const auto scheme : {FlowScheme::implicit_scheme, FlowScheme::explicit_scheme}) {
    const auto model = flow_model(scheme, 1e-4);
    TestModel& m = *model;
    const auto well = m.well_domains[0];
    m.network.stiffness[well] = m.options.fluid_bulk_modulus / m.network.volume[well];
    std::vector<double> source(static_cast<std::size_t>(m.network.domain_count()), 0.0);
    source[static_cast<std::size_t>(well)] = 2e-4;
    FlowSolver flow(m.network, m.options);
    double leaked = 0.0, stored = 0.0;
    constexpr double step = 50.0;
    for (int k = 0; k < 40; ++k) {
      flow.advance(m.network, step, source);
      for (std::size_t e = 0; e < m.network.left.size(); ++e) {
        if (m.network.left[e] == 0) leaked -= step * m.network.flow[e];
        if (m.network.right[e] == 0) leaked += step * m.network.flow[e];
      }
    }
    for (std::int64_t d = 1; d < m.network.domain_count(); ++d) stored += m.network.content[d];
    EXPECT_GT(leaked, 0.0);
    EXPECT_NEAR(stored + leaked, 40.0 * step * 2e-4, 1e-12 * 0.4);
    EXPECT_EQ(m.network.pressure[0], 25e6);
  }
}

TEST(FlowSolver, BothSchemesAgree) {
  const auto implicit_owner = flow_model(FlowScheme::implicit_scheme),
             explicit_owner = flow_model(FlowScheme::explicit_scheme);
  TestModel &implicit_model = *implicit_owner, &explicit_model = *explicit_owner;
  const auto well = implicit_model.well_domains[0];
  for (TestModel* m : {&implicit_model, &explicit_model}) m->network.pressure[well] = 35e6;
  FlowSolver implicit_flow(implicit_model.network, implicit_model.options);
  FlowSolver explicit_flow(explicit_model.network, explicit_model.options);
  // Half a minute: pressure is a few pores into the rock. The wide pipe alone limits the explicit step.
  for (int step = 0; step < 200; ++step) {
    implicit_flow.advance(implicit_model.network, 2.0, {});
    explicit_flow.advance(explicit_model.network, 2.0, {});
  }
  double worst = 0.0, raised = 0.0;
  for (std::int64_t d = 1; d < implicit_model.network.domain_count(); ++d) {
    worst =
        std::max(worst, std::abs(implicit_model.network.pressure[d] - explicit_model.network.pressure[d]));
    if (d != well) raised = std::max(raised, implicit_model.network.pressure[d] - 25e6);
  }
  RecordProperty("worst_difference_over_rise", std::to_string(worst / 10e6));
  EXPECT_LT(worst, 0.01 * 10e6);
  EXPECT_GT(raised, 1e6);
}

TEST(FlowSolver, ImposedPressuresStayAndSteadyFlowIsReached) {
  const auto model = flow_model(FlowScheme::implicit_scheme, 5e-5);
  TestModel& m = *model;
  const auto well = m.well_domains[0];
  m.network.pressure[well] = 30e6;
  FlowSolver flow(m.network, m.options);
  for (int step = 0; step < 3; ++step) flow.advance(m.network, 1e12, {});
  EXPECT_EQ(m.network.pressure[well], 30e6);
  EXPECT_EQ(m.network.pressure[0], 25e6);
  std::vector<double> net(static_cast<std::size_t>(m.network.domain_count()), 0.0);
  for (std::size_t e = 0; e < m.network.left.size(); ++e) {
    net[static_cast<std::size_t>(m.network.left[e])] -= m.network.flow[e];
    net[static_cast<std::size_t>(m.network.right[e])] += m.network.flow[e];
  }
  const double through = -net[static_cast<std::size_t>(well)];
  EXPECT_GT(through, 0.0);
  EXPECT_NEAR(net[0], through, 1e-9 * through);
  for (std::int64_t d = 1; d < m.network.domain_count(); ++d) {
    if (d == well) continue;
    EXPECT_LT(std::abs(net[static_cast<std::size_t>(d)]), 1e-9 * through);
    EXPECT_GE(m.network.pressure[d], 25e6 - 1.0);  // no maximum or minimum inside
    EXPECT_LE(m.network.pressure[d], 30e6 + 1.0);
  }
}

TEST(FlowSolver, CavitiesFillBeforeTheirPressureRises) {
  for (const auto scheme : {FlowScheme::implicit_scheme, FlowScheme::explicit_scheme}) {
    const auto model = flow_model(scheme, 1e-4);
    TestModel& m = *model;
    // Pores near the hole have opened by ten times what their fluid can follow.
    std::vector<std::int64_t> opened;
    for (std::int64_t d = 1; d < m.network.domain_count(); ++d) {
      const Vec2 from = m.network.centroid[d] - Vec2{10.0, 14.0};
      if (m.network.kind[d] == DomainKind::rock && dot(from, from) < 2.0) {
        m.network.volume_change[d] = 10.0 * m.network.volume[d] * 25e6 / m.options.fluid_bulk_modulus;
        m.network.pressure[d] = 0.0;
        opened.push_back(d);
      }
    }
    ASSERT_GE(opened.size(), 2u);
    FlowSolver flow(m.network, m.options);
    bool half_full = false;
    for (int step = 0; step < 400; ++step) {
      flow.advance(m.network, 200.0, {});
      for (std::int64_t d = 0; d < m.network.domain_count(); ++d) {
        ASSERT_GE(m.network.pressure[d], 0.0);
        if (m.network.stiffness[d] == 0.0) continue;
        // Pressure and content belong together at all times.
        const double full =
            25e6 + m.network.stiffness[d] * (m.network.content[d] - m.network.volume_change[d]);
        ASSERT_NEAR(m.network.pressure[d], std::max(0.0, full), 1e-3);
        half_full = half_full || (m.network.pressure[d] == 0.0 && m.network.content[d] > 0.0);
      }
    }
    EXPECT_TRUE(half_full);
    for (const auto d : opened) EXPECT_GT(m.network.pressure[d], 0.0) << "domain " << d << " never filled";
  }
}

TEST(FlowSolver, TooManySubCyclesAreRefused) {
  const auto model = flow_model(FlowScheme::explicit_scheme, 0.1);
  TestModel& m = *model;
  FlowSolver flow(m.network, m.options);
  EXPECT_THROW(flow.advance(m.network, 1e6, {}), Error);
}

TEST(FlowSolver, IterativeSolverAgreesWithTheFactorisation) {
  for (const double step : {1e-3, 10.0, 1e5}) {
    const auto direct = flow_model(FlowScheme::implicit_scheme),
               iterative = flow_model(FlowScheme::implicit_scheme);
    direct->options.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::direct);
    iterative->options.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::iterative);
    for (TestModel* m : {direct.get(), iterative.get()}) {
      const auto well = m->well_domains[0];
      m->network.stiffness[well] = 0.0;
      m->network.pressure[well] = 60e6;
      // Some pores empty: which of them fill is part of what is solved for.
      for (std::int64_t d = 1; d < m->network.domain_count(); d += 9) {
        if (d != well) m->network.content[d] = -0.1 * m->network.volume[d];
      }
      FlowSolver flow(m->network, m->options);
      for (int k = 0; k < 3; ++k) flow.advance(m->network, step, {});
    }
    const double injected = sum(direct->network.content);
    for (std::size_t d = 0; d < direct->network.pressure.size(); ++d)
      EXPECT_NEAR(iterative->network.pressure[d], direct->network.pressure[d], 0.06)
          << "domain " << d;  // Pa, of 6e7
    EXPECT_NEAR(sum(iterative->network.content), injected, 1e-8 * std::abs(injected) + 1e-15);
  }
}

// Where both would do, the one that is quicker: conjugate gradients in a short step, the factor in a long one.
TEST(FlowSolver, ChoosesByTheStepWhereBothWouldDo) {
  const auto with = [](const TestModel& rock, FlowMatrixSolver solver, double step, int count = 1) {
    Options o = rock.options;
    o.flow_solver = choice(solver);
    Network n = rock.network;
    Workers workers(count);
    FlowSolver flow(n, o, nullptr, {}, &workers);
    for (int k = 0; k < 2; ++k) flow.advance(n, step, {});
    return n.pressure;
  };
  const auto rock = flow_model(FlowScheme::implicit_scheme, 1e-3, 18000);
  ASSERT_GT(rock->network.domain_count(), 20000);
  ASSERT_LE(rock->network.domain_count(), 60000);
  rock->network.stiffness[rock->well_domains[0]] = 0.0;
  rock->network.pressure[rock->well_domains[0]] = 60e6;
  for (const double step : {1e-3, 10.0}) {
    const auto chosen = with(*rock, FlowMatrixSolver::automatic, step),
               direct = with(*rock, FlowMatrixSolver::direct, step),
               iterative = with(*rock, FlowMatrixSolver::iterative, step);
    ASSERT_NE(direct, iterative) << step;  // in last digits
    EXPECT_EQ(chosen, step < 1.0 ? iterative : direct) << step;
    for (const int count : {2, 3})
      EXPECT_EQ(with(*rock, FlowMatrixSolver::automatic, step, count), chosen) << step << ' ' << count;
    for (std::size_t d = 0; d < direct.size(); ++d) ASSERT_NEAR(iterative[d], direct[d], 0.06) << d;
  }
}

TEST(StableStep, HasTheSameRowsOnAnyNumberOfWorkers) {
  const auto rock = flow_model(FlowScheme::implicit_scheme, 1e-3, 6000);
  const auto discs = static_cast<std::size_t>(rock->assembly.disc_count());
  ASSERT_GE(rock->assembly.tile_count(), 8U);  // fewer are not shared
  const auto rows = [&](Workers* workers) {
    std::vector<double> all(3 * discs, -1.0);
    const std::span<double> x(all.data(), discs), y(all.data() + discs, discs),
        turn(all.data() + 2 * discs, discs);
    stiffness_rows(rock->assembly, rock->network, rock->options, nullptr, x, y, turn, workers);
    return all;
  };
  const auto alone = rows(nullptr);
  for (const int count : {1, 2, 3}) {
    Workers workers(count);
    EXPECT_EQ(rows(&workers), alone) << count;
  }
}

// As users have it: packings at random, cracks that grew there, a step of a millisecond. Without stress pores beside cracks cavitate, so
// that which do is found in rounds.
// Returns the most rounds that a seed took.
int compare_solvers_in_packings(double stress, double well_pressure) {
  int most_rounds = 0;
  for (const std::int64_t seed : {1, 2, 3, 4, 5}) {
    CaseDefinition definition = cracking_case();
    Options& o = definition.options;
    o.model_seed = seed;
    o.packing_disc_count = 2500;
    o.stepping_mode = choice(SteppingMode::dynamic);
    o.stepping_flow_step = 1e-3;
    o.stress_sigma_Hmax = o.stress_sigma_hmin = stress;
    definition.wells[0].pressure = well_pressure;
    Simulation simulation(definition, {}, {});
    for (int k = 0; k < 60 && simulation.cracks().size() < 15; ++k) simulation.step();
    EXPECT_GE(simulation.cracks().size(), 5U) << "seed " << seed;
    Network by_factor = simulation.network(), by_iterations = by_factor;
    EXPECT_GT(by_factor.domain_count(), few_rows) << "or cracks are no level of their own";
    Options direct = o, iterative = o;
    direct.flow_solver = choice(FlowMatrixSolver::direct);
    iterative.flow_solver = choice(FlowMatrixSolver::iterative);
    FlowSolver(by_factor, direct).advance(by_factor, 1e-3, {});
    const int rounds = FlowSolver(by_iterations, iterative).advance(by_iterations, 1e-3, {});
    std::cout << " seed " << seed << ": " << simulation.cracks().size() << " cracks, " << rounds
              << " rounds\n";
    most_rounds = std::max(most_rounds, rounds);
    const auto [least, most] = std::minmax_element(by_factor.pressure.begin(), by_factor.pressure.end());
    for (std::size_t d = 0; d < by_factor.pressure.size(); ++d)
      EXPECT_NEAR(by_iterations.pressure[d], by_factor.pressure[d], 1e-9 * (*most - *least))
          << "domain " << d << ", seed " << seed;
  }
  return most_rounds;
}

TEST(FlowSolver, IterativeSolverFollowsCracksThatGrewInPackingsUnderStress) {
  compare_solvers_in_packings(20e6, 90e6);
}

TEST(FlowSolver, IterativeSolverFindsWhichPoresCavitateInPackingsWithoutStress) {
  EXPECT_GE(compare_solvers_in_packings(0.0, 60e6), 2) << "no pore cavitates: a test of nothing";
}

}  // namespace flow_solver_test
