// SPDX-License-Identifier: BSD-3-Clause
// Plane Poiseuille flow of a shear-thinning fluid: the law against the velocity profile integrated, its derivatives against
// differences, and a chain of pipes between two pressures in both solvers of flow.
#include "flow/fluid_law.hpp"

#include <gtest/gtest.h>

#include "equilibrium/coupled_factor.hpp"
#include "equilibrium/coupled_system.hpp"
#include "flow/flow_solver.hpp"
#include "model.hpp"

namespace fluid_law_test {

using namespace testing_unit;

Options gel(double index, double consistency = 2.0, double viscosity = 50.0) {
  Options o;
  o.fluid_viscosity = viscosity;
  o.fluid_consistency = consistency;
  o.fluid_power_index = index;
  return o;
}

TEST(FluidLaw, IsTheIntegralOfTheVelocityProfile) {
  for (const double n : {0.3, 0.5, 0.8}) {
    const Options o = gel(n);
    const FluidLaw law(o);
    for (const double w : {1e-4, 1e-3, 1e-2}) {
      for (const double gradient : {1e2, 1e5, 1e7}) {
        // q = 2 times the integral of y times the rate of shear from the middle to the wall, shear stress G y.
        constexpr int slices = 20000;
        double q = 0.0;
        for (int k = 0; k < slices; ++k) {
          const double y = (k + 0.5) / slices * 0.5 * w, stress = gradient * y;
          q += 2.0 * y * (stress / o.fluid_viscosity + std::pow(stress / o.fluid_consistency, 1.0 / n)) *
               0.5 * w / slices;
        }
        constexpr double length = 0.7;
        const auto flow = law.respond(w, length, gradient * length);
        EXPECT_NEAR(flow.conductance * gradient * length / q, 1.0, 1e-6) << n << " " << w << " " << gradient;
      }
    }
  }
}

TEST(FluidLaw, WithoutConsistencyIsTheCubicLawBitForBit) {
  const Options o;
  const double w = 3.7e-4, length = 1.3;
  const auto flow = FluidLaw(o).respond(w, length, 1e6);
  EXPECT_EQ(flow.conductance, w * w * w / (12.0 * o.fluid_viscosity * length));
  EXPECT_EQ(flow.slope, flow.conductance);
  EXPECT_EQ(flow.by_aperture, 3.0);
}

TEST(FluidLaw, DerivativesAreThoseOfTheFlow) {
  const FluidLaw law(gel(0.4));
  const auto flow = [&](double w, double drop) { return law.respond(w, 0.9, drop).conductance * drop; };
  for (const double drop : {-3e5, 10.0, 2e6}) {
    const double w = 1e-3;
    const auto r = law.respond(w, 0.9, drop);
    EXPECT_NEAR((flow(w, drop * 1.0001) - flow(w, drop * 0.9999)) / (2e-4 * drop) / r.slope, 1.0, 1e-6);
    EXPECT_NEAR((flow(w * 1.0001, drop) - flow(w * 0.9999, drop)) / 2e-4 / flow(w, drop) / r.by_aperture, 1.0,
                1e-6);
  }
}

// Two pores between two imposed pressures: pipes in a row, given flow in the middle, and side by side.
TEST(FluidLaw, AChainOfPipesCarriesWhatItsLawSays) {
  for (const double n : {0.25, 0.5, 0.9}) {
    Options o = gel(n, 20.0, 1e4);
    const FluidLaw law(o);
    Network chain;
    chain.kind.assign(5, DomainKind::rock);
    chain.left = {1, 2, 3, 3};
    chain.right = {2, 3, 4, 4};
    chain.aperture = {1e-3, 4e-4, 6e-4, 2e-4};
    chain.length = {1.0, 0.5, 2.0, 1.0};
    for (std::size_t e = 0; e < 4; ++e)
      chain.conductance.push_back(law.respond(chain.aperture[e], chain.length[e], 0.0).conductance);
    chain.flow.assign(4, 0.0);
    for (auto* values : {&chain.volume_change, &chain.content}) values->assign(5, 0.0);
    chain.volume.assign(5, 1e-3);
    chain.pressure = {0.0, 3e6, 0.0, 0.0, 1e6};
    chain.stiffness = {0.0, 0.0, 1e12, 1e12, 0.0};
    FlowSolver solver(chain, o);
    for (int step = 0; step < 3; ++step) solver.advance(chain, 1e4, {});
    const auto& p = chain.pressure;
    EXPECT_GT(p[2], p[3]);
    for (std::size_t e = 0; e < 4; ++e) {
      const double drop =
          p[static_cast<std::size_t>(chain.left[e])] - p[static_cast<std::size_t>(chain.right[e])];
      const double q = law.respond(chain.aperture[e], chain.length[e], drop).conductance * drop;
      EXPECT_NEAR(chain.flow[e] / q, 1.0, 2e-6) << n << " pipe " << e;
    }
    EXPECT_NEAR(chain.flow[0], chain.flow[2] + chain.flow[3], 1e-6 * chain.flow[0]);
    // The middle two pores by bisection on the flow through all.
    double low = 1e6, high = 3e6;
    const auto drop_for = [&](std::size_t e, double q) {
      double a = 0.0, b = 1e9;
      for (int k = 0; k < 200; ++k) {
        const double middle = 0.5 * (a + b);
        (law.respond(chain.aperture[e], chain.length[e], middle).conductance * middle < q ? a : b) = middle;
      }
      return a;
    };
    for (int k = 0; k < 200; ++k) {
      const double at = 0.5 * (low + high);
      double q = 0.0;
      for (const std::size_t e : {2U, 3U})
        q += law.respond(chain.aperture[e], chain.length[e], at - 1e6).conductance * (at - 1e6);
      (at + drop_for(0, q) + drop_for(1, q) < 3e6 ? low : high) = at;
    }
    EXPECT_NEAR((p[3] - 1e6) / (low - 1e6), 1.0, 1e-5) << n;
  }
}

// The tangent of the coupled equations: a small move changes the residual by what the product says.
TEST(FluidLaw, TheCoupledTangentIsTheDerivative) {
  Options o = dry_options(60);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.fluid_consistency = 0.5;
  o.fluid_power_index = 0.5;
  o.fluid_viscosity = 10.0;
  TestModel m(o, packed(o));
  m.fill_pores();
  m.network.zero_stress_aperture = 1e-4;
  Random random(7);
  for (std::int64_t d = 1; d < m.network.domain_count(); ++d) {
    m.network.pressure[d] = 25e6 + 1e7 * random.uniform();
    m.network.content[d] = content_at(m.network, d, o.fluid_bulk_modulus, m.network.pressure[d]);
  }
  Workers team(1);
  Facets facets;
  CoupledSystem system(m.assembly, m.network, *m.boundary, m.solver->non_bonded_contacts(), m.options, team,
                       facets);
  system.begin(10.0, {});
  system.evaluate();
  const CoupledSystem::Vector before = system.residual();
  CoupledSystem::Vector x = CoupledSystem::Vector::Zero(before.size()), predicted;
  for (std::int64_t d = 1; d < m.network.domain_count(); ++d)
    x[3 * m.assembly.disc_count() + d] = 1e-7 * (random.uniform() - 0.5);
  system.product(x, predicted);
  system.move(x, 1.0);
  system.evaluate();
  const CoupledSystem::Vector change = before - system.residual();
  EXPECT_LT((change - predicted).norm(), 1e-4 * predicted.norm());
}

}  // namespace fluid_law_test
