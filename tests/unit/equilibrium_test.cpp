// SPDX-License-Identifier: BSD-3-Clause
// The quasi-static solver's parts: tangents against differences, the order of elimination, the linear solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "couple/simulation.hpp"
#include "equilibrium/coupled_factor.hpp"
#include "equilibrium/coupled_system.hpp"
#include "equilibrium/dense_kernels.hpp"
#include "equilibrium/dissection.hpp"
#include "equilibrium/multifrontal.hpp"
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
    a.intact.assign(1, intact ? 1 : 0);
    a.slip = {1e-5};
    a.tensile_per_radius = a.shear_per_radius = 1e12;
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

TEST(Dissection, SeparatesAndOrdersEveryNodeOnce) {
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
  std::vector<char> late(position.size(), 0);
  late[5] = late[900] = 1;
  const Dissection cuts = dissect(position, graph, late);
  auto sorted = cuts.order;
  std::sort(sorted.begin(), sorted.end());
  for (std::int32_t k = 0; k < side * side; ++k) ASSERT_EQ(sorted[static_cast<std::size_t>(k)], k);
  EXPECT_EQ(cuts.order[cuts.order.size() - 2], 5);
  EXPECT_EQ(cuts.order.back(), 900);
  // Nodes touch only their own part, parts below and parts above.
  std::vector<std::size_t> part(position.size());
  for (std::size_t f = 0; f < cuts.parts.size(); ++f) {
    for (auto k = cuts.parts[f].first; k < cuts.parts[f].last; ++k)
      part[static_cast<std::size_t>(cuts.order[static_cast<std::size_t>(k)])] = f;
  }
  const auto above = [&](std::size_t low, std::size_t high) {
    while (low < high) low = static_cast<std::size_t>(cuts.parts[low].parent);
    return low == high;
  };
  for (std::size_t node = 0; node < position.size(); ++node) {
    for (auto k = graph.start[node]; k < graph.start[node + 1]; ++k) {
      const auto other = part[static_cast<std::size_t>(graph.neighbour[static_cast<std::size_t>(k)])];
      EXPECT_TRUE(above(std::min(part[node], other), std::max(part[node], other)));
    }
  }
}

// Three unknowns a node on a grid, unsymmetric, with a diagonal that asks for exchanges.
TEST(Multifrontal, SolvesWithAnyInstructionSetAlike) {
  const std::int32_t side = 20;
  std::vector<Vec2> position;
  Adjacency graph;
  std::vector<std::int32_t> node_start{0};
  std::vector<MatrixPlace> places;
  std::vector<double> values;
  Random random(3);
  graph.start.push_back(0);
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      const std::int32_t node = y * side + x;
      position.push_back({static_cast<double>(x), static_cast<double>(y)});
      node_start.push_back(3 * (node + 1));
      for (const auto& [dx, dy] :
           {std::pair{0, -1}, std::pair{-1, 0}, std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}}) {
        if (x + dx < 0 || x + dx >= side || y + dy < 0 || y + dy >= side) continue;
        const std::int32_t other = (y + dy) * side + x + dx;
        if (other != node) graph.neighbour.push_back(other);
        for (std::int32_t r = 0; r < 3; ++r) {
          for (std::int32_t c = 0; c < 3; ++c) {
            places.push_back({3 * node + r, 3 * other + c});
            const double big = other == node && r == (c + 1) % 3 ? 8.0 : 0.0;  // beside the diagonal
            values.push_back(big + random.uniform() - 0.5);
          }
        }
      }
      graph.start.push_back(static_cast<std::int32_t>(graph.neighbour.size()));
    }
  }
  std::vector<char> late(position.size(), 0);
  late[17] = 1;
  Multifrontal factor;
  factor.analyse(node_start, position, graph, late, places);
  factor.factorise(values);
  std::vector<double> right(static_cast<std::size_t>(3 * side * side)), x;
  for (auto& value : right) value = random.uniform() - 0.5;
  x = right;
  factor.solve(x.data());
  std::vector<double> back(right.size(), 0.0);
  for (std::size_t k = 0; k < places.size(); ++k)
    back[static_cast<std::size_t>(places[k].row)] +=
        values[k] * x[static_cast<std::size_t>(places[k].column)];
  for (std::size_t k = 0; k < back.size(); ++k) EXPECT_NEAR(back[k], right[k], 1e-11);
}

TEST(DenseKernels, GiveTheSameBitsOnEveryInstructionSet) {
  const std::int64_t m = 77, p = 41;
  Random random(5);
  Array<double> front(static_cast<std::size_t>(m * m));
  for (auto& value : front) value = random.uniform() - 0.5;
  std::vector<Array<double>> results;
  for (const char* name : {"baseline", "avx2", "avx512"}) {
    const DenseKernels* kernels = dense_kernels_for(name);
    if (kernels == nullptr) continue;
    Array<double> w = front;
    std::vector<std::int32_t> swaps(static_cast<std::size_t>(p));
    kernels->factor_front(w.data(), m, p, m, swaps.data());
    Array<double> x(static_cast<std::size_t>(m), 1.0);
    kernels->forward(w.data(), m, p, swaps.data(), x.data(), x.data() + p);
    kernels->backward(w.data(), w.data() + p * m, m, p, x.data(), x.data() + p);
    w.insert(w.end(), x.begin(), x.end());
    results.push_back(w);
  }
  for (const auto& result : results) EXPECT_TRUE(result == results.front());
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
      definition.options.bond_tensile_strength = 1e12;
    }
    CrackedModel model(definition);
    // Open to the test's hands; the simulation is not used afterwards.
    auto& assembly = const_cast<Assembly&>(model.s.assembly());
    auto& network = const_cast<Network&>(model.s.network());
    auto& boundary = const_cast<Boundary&>(model.s.boundary());
    const LooseContacts& loose = model.s.solver().loose_contacts();
    for (std::size_t e = 50; e < 60; ++e) assembly.intact[e] = 0.0;
    CoupledSystem system(assembly, network, boundary, loose, model.s.options());
    system.begin(1e-3, {});
    system.evaluate();
    Random random(7);
    CoupledSystem::Vector x(system.size()), y;
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = random.uniform() - 0.5;
    for (std::int64_t d = 0; d < network.domain_count(); ++d) {
      if (network.stiffness[d] == 0.0)
        x[3 * assembly.disc_count() + d] = 0.0;  // imposed pressures do not move
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
