// SPDX-License-Identifier: BSD-3-Clause
// The quasi-static solver's parts: tangents against differences, the order of elimination, the linear solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "couple/simulation.hpp"
#include "equilibrium/coupled_factor.hpp"
#include "equilibrium/coupled_system.hpp"
#include "equilibrium/dissection.hpp"
#include "flow/aperture.hpp"
#include "small_case.hpp"

namespace {

using namespace testing_unit;

// Two discs of unlike size, some way apart and turned.
struct Pair {
  Assembly a;
  Options o;
  explicit Pair(bool intact, double gap) {
    a.x = {0.0, 1.6};
    a.y = {0.0, 1.2};
    a.radius = {1.2, 0.8};
    a.ux = {0.0, 0.8 * gap + 2e-4};
    a.uy = {1e-4, 0.6 * gap};
    a.rotation = {2e-4, -1e-4};
    a.first = {0};
    a.second = {1};
    a.dx = {1.6};
    a.dy = {1.2};
    a.length = {2.0};
    a.arm = {1.2};
    a.bond_radius = {0.8};
    a.intact = {intact ? 1.0 : 0.0};
    a.slip = {1e-5};
    a.tensile_capacity = {1e12};
    a.shear_capacity = {1e12};
  }
  double* unknown(int k) {
    switch (k) {
      case 0:
        return &a.ux[1];
      case 1:
        return &a.uy[1];
      case 2:
        return &a.rotation[0];
      default:
        return &a.rotation[1];
    }
  }
};

TEST(BondResponse, TangentIsTheChangeOfForce) {
  for (const bool intact : {true, false}) {
    for (const double gap : {-3e-4, -3e-3, 2e-4}) {  // sliding, sticking, open
      Pair pair(intact, gap);
      const BondResponse at = respond(pair.a, pair.o, 0);
      for (int k = 0; k < 4; ++k) {
        const double step = 1e-7;
        *pair.unknown(k) += step;
        const BondResponse up = respond(pair.a, pair.o, 0);
        *pair.unknown(k) -= 2.0 * step;
        const BondResponse down = respond(pair.a, pair.o, 0);
        *pair.unknown(k) += step;
        for (int row = 0; row < 4; ++row) {
          const double difference = (up.force[row] - down.force[row]) / (2.0 * step);
          EXPECT_NEAR(at.tangent[4 * row + k], difference, 2e-5 * pair.o.contact_normal_stiffness)
              << "intact " << intact << " gap " << gap << " row " << row << " column " << k;
        }
      }
    }
  }
}

TEST(BondResponse, ForcesAreTheKernels) {
  for (const bool intact : {true, false}) {
    for (const double gap : {-3e-3, -1e-4, 2e-4}) {
      Pair pair(intact, gap);
      const BondResponse r = respond(pair.a, pair.o, 0);
      const BondView view = view_bond(pair.a, pair.o, 0);
      EXPECT_DOUBLE_EQ(r.normal, view.normal_force());
      EXPECT_NEAR(r.shear, view.shear_force(), 1e-9 * pair.o.contact_normal_stiffness);
      EXPECT_DOUBLE_EQ(r.gap, view.gap);
    }
  }
}

TEST(Dissection, OrdersEveryNodeOnceAndKeepsFactorsSmall) {
  // A square grid of 64 x 64 nodes.
  const std::int32_t side = 64;
  std::vector<Vec2> position;
  Adjacency graph;
  graph.start.push_back(0);
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      position.push_back({static_cast<double>(x), static_cast<double>(y)});
      for (const auto& [dx, dy] : {std::pair{-1, 0}, std::pair{1, 0}, std::pair{0, -1}, std::pair{0, 1}}) {
        if (x + dx >= 0 && x + dx < side && y + dy >= 0 && y + dy < side)
          graph.neighbour.push_back((y + dy) * side + x + dx);
      }
      graph.start.push_back(static_cast<std::int32_t>(graph.neighbour.size()));
    }
  }
  const auto order = dissect(position, graph, 0);
  auto sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::int32_t k = 0; k < side * side; ++k) ASSERT_EQ(sorted[static_cast<std::size_t>(k)], k);

  const auto fill = [&](const std::vector<std::int32_t>& by) {
    std::vector<std::int32_t> place(by.size());
    for (std::size_t k = 0; k < by.size(); ++k)
      place[static_cast<std::size_t>(by[k])] = static_cast<std::int32_t>(k);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int32_t node = 0; node < side * side; ++node) {
      entries.emplace_back(node, node, 5.0);
      for (auto k = graph.start[static_cast<std::size_t>(node)];
           k < graph.start[static_cast<std::size_t>(node) + 1]; ++k) {
        const auto p = place[static_cast<std::size_t>(node)],
                   q = place[static_cast<std::size_t>(graph.neighbour[static_cast<std::size_t>(k)])];
        if (p > q) entries.emplace_back(p, q, -1.0);
      }
    }
    Eigen::SparseMatrix<double> matrix(side * side, side * side);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> f(
        matrix);
    return f.matrixL().nestedExpression().nonZeros();
  };
  std::vector<std::int32_t> row_by_row(order.size());
  std::iota(row_by_row.begin(), row_by_row.end(), 0);
  EXPECT_LT(fill(order), 2 * fill(row_by_row) / 5);
}

// A cracked, pressurised model with flow: everything the equations hold.
struct CrackedModel {
  Simulation s;
  explicit CrackedModel(CaseDefinition definition) : s(std::move(definition), {}, {}) {
    for (int k = 0; k < 3; ++k) s.step();
  }
};

TEST(CoupledSystem, ProductIsTheChangeOfTheResidual) {
  for (const bool walls : {true, false}) {
    CaseDefinition definition = cracking_case();
    definition.options.packing_disc_count = 400;
    definition.wells[0].radius = 12.0;
    definition.options.stepping_flow_step = 1e-3;
    // A contact that slid sits on the kink between sliding and sticking; BondResponse has a test of its own.
    definition.options.contact_shear_stiffness = 0.0;
    if (!walls) {
      definition.options.boundary_kind = choice(BoundaryKind::stress);
      definition.options.stress_sigma_H = definition.options.stress_sigma_h = 5e6;
      definition.options.bond_tensile_strength = 100e6;
    }
    CrackedModel model(definition);
    ASSERT_GT(model.s.cracks().size(), 0U);
    // Open to the test's hands; the simulation is not used afterwards.
    auto& assembly = const_cast<Assembly&>(model.s.assembly());
    auto& network = const_cast<Network&>(model.s.network());
    auto& boundary = const_cast<Boundary&>(model.s.boundary());
    const LooseContacts& loose = model.s.solver().loose_contacts();
    CoupledSystem system(assembly, network, boundary, loose, model.s.options());
    system.begin(1e-3, {});
    system.evaluate();
    Random random(7);
    CoupledSystem::Vector x(system.size()), y;
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = random.uniform() - 0.5;
    for (std::int64_t d = 0; d < network.domain_count(); ++d) {
      if (network.stiffness[d] == 0.0) x[3 * assembly.disc_count() + d] = 0.0;  // imposed pressures do not move
    }
    x *= 1e-7;
    system.product(x, y);
    const CoupledSystem::Vector before = system.residual();
    system.move(x, 1.0);
    system.evaluate();
    const CoupledSystem::Vector change = before - system.residual();
    EXPECT_LT((change - y).norm(), 1e-3 * y.norm()) << (walls ? "walls" : "stress boundary");
  }
}

TEST(CoupledFactor, SolvesTheTangent) {
  CaseDefinition definition = cracking_case();
  definition.options.packing_disc_count = 400;
  definition.wells[0].radius = 12.0;
  CrackedModel model(definition);
  auto& assembly = const_cast<Assembly&>(model.s.assembly());
  auto& network = const_cast<Network&>(model.s.network());
  auto& boundary = const_cast<Boundary&>(model.s.boundary());
  CoupledSystem system(assembly, network, boundary, model.s.solver().loose_contacts(), model.s.options());
  system.begin(1e-3, {});
  system.evaluate();
  CoupledFactor factor;
  factor.compute(system);
  Random random(11);
  CoupledSystem::Vector right(system.size()), x, y;
  for (Eigen::Index k = 0; k < right.size(); ++k) right[k] = random.uniform() - 0.5;
  const auto outcome = solve_preconditioned(system, factor, right, 1e-10, 200, x);
  EXPECT_TRUE(outcome.converged);
  system.product(x, y);
  EXPECT_LT((y - right).norm(), 2e-10 * right.norm());
}

}  // namespace
