// SPDX-License-Identifier: BSD-3-Clause
// The quasi-static solver's parts: tangents against differences, the order of elimination, the linear solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "equilibrium/coupled_factor.hpp"
#include "equilibrium/coupled_system.hpp"
#include "flow/aperture.hpp"
#include "grid_matrix.hpp"
#include "linear/dense_kernels.hpp"
#include "linear/dissection.hpp"
#include "linear/krylov.hpp"
#include "linear/multifrontal.hpp"
#include "linear/separator.hpp"
#include "small_case.hpp"
#include "step/simulation.hpp"
#include "tangent_check.hpp"

namespace equilibrium_test {

using namespace testing_unit;
using grid_matrix::GridMatrix;

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
    a.part_first_bond = {0, 1};
    a.tile_first_pair = {1, 1};
    a.geometry.lay_out(a.part_first_bond);
    a.geometry.put(0, 0, {1.6, 1.2, 2.0, 1.2, 0.8});
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

// Open, pressed at one edge from either side of touching, and pressed all along; sliding and sticking.
TEST(BondResponse, AFlatContactsTangentIsTheChangeOfForceAndItsForceThatOfTheEnergy) {
  for (const double friction : {0.0, 0.01, 10.0}) {
    for (const double gap : {3e-4, 1e-5, -1e-4, -3e-4, -3e-3}) {
      Pair pair(false, gap);
      pair.o.contact_shape = choice(ContactShape::flat);
      pair.o.contact_friction = friction;
      expect_tangent(pair.a, pair.o, 0, 1e-8, 1e-4 * pair.o.contact_normal_stiffness);
      if (friction > 0.0) continue;
      for (int k = 0; k < 4; ++k) {
        const double step = 1e-8, force = respond(pair.a, pair.o, 0).force[k];
        *pair.unknown(k) += step;
        const double up = view_bond(pair.a, pair.o, 0).contact_energy;
        *pair.unknown(k) -= 2.0 * step;
        const double down = view_bond(pair.a, pair.o, 0).contact_energy;
        *pair.unknown(k) += step;
        EXPECT_NEAR(force, (up - down) / (2.0 * step), 1e-8 * pair.o.contact_normal_stiffness)
            << gap << " " << k;
      }
    }
  }
}

// Turned by more than it is pressed, it bears h q / 4 at its edge, and a moment of a third of the lever less (statics of a wedge).
TEST(BondResponse, AFlatContactBearsAMomentAndARoundOneNone) {
  Pair pair(false, -1e-3);
  EXPECT_EQ(view_bond(pair.a, pair.o, 0).contact_moment, 0.0);
  pair.o.contact_shape = choice(ContactShape::flat);
  pair.a.rotation = {0.0, 2e-3};
  const BondView v = view_bond(pair.a, pair.o, 0);
  const double k = pair.o.contact_normal_stiffness, radius = 0.8;
  double force = 0.0, moment = 0.0;  // of 4000 springs side by side
  for (int s = 0; s < 4000; ++s) {
    const double at = radius * ((s + 0.5) / 2000.0 - 1.0), deep = -(v.gap + 2e-3 * at);
    if (deep <= 0.0) continue;
    force += k / 4000.0 * deep;
    moment -= k / 4000.0 * deep * at;
  }
  EXPECT_NEAR(v.contact_normal, force, 1e-5 * force);
  EXPECT_NEAR(v.contact_moment, moment, 1e-5 * moment);
  EXPECT_GT(moment, 0.0);
}

// One node of weight 3 faces two of weight 1; beside them one of weight 1 faces two of weight 3.
TEST(Separator, IsTheLightestSetThatTouchesEveryCrossing) {
  std::vector<char> left, right;
  lightest_cover({3, 1}, {1, 1, 3, 3}, {{0, 0}, {0, 1}, {1, 2}, {1, 3}}, left, right);
  EXPECT_EQ(left, (std::vector<char>{0, 1}));
  EXPECT_EQ(right, (std::vector<char>{1, 1, 0, 0}));
  // Chains, where the greedy way has to be taken back: left k faces right k and k + 1.
  const std::int32_t n = 50;
  std::vector<Crossing> crossings;
  for (std::int32_t k = 0; k < n; ++k) {
    crossings.push_back({k, k + 1});
    crossings.push_back({k, k});
  }
  const std::vector<std::int32_t> ones(n, 1), more(n + 1, 1);
  lightest_cover(ones, more, crossings, left, right);
  EXPECT_EQ(std::count(left.begin(), left.end(), 1) + std::count(right.begin(), right.end(), 1), n);
  for (const auto& c : crossings)
    EXPECT_TRUE(left[static_cast<std::size_t>(c.left)] != 0 || right[static_cast<std::size_t>(c.right)] != 0);
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
  const Dissection cuts = dissect(position, graph, std::vector<std::int32_t>(position.size(), 1), late);
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

template <class Real>
std::vector<double> solution(const GridMatrix& m, int workers, double& error) {
  std::vector<char> late(m.position.size(), 0);
  late[17] = 1;
  FrontTree tree;
  tree.analyse(m.node_start, m.position, m.graph, late, m.each_place());
  Workers team(workers);
  Multifrontal<Real> factor;
  factor.factorise(tree, std::vector<Real>(m.values.begin(), m.values.end()), team);
  std::vector<double> x = m.right, back(m.right.size(), 0.0);
  factor.solve(tree, x.data(), team);
  for (std::size_t k = 0; k < m.places.size(); ++k)
    back[static_cast<std::size_t>(m.places[k].row)] +=
        m.values[k] * x[static_cast<std::size_t>(m.places[k].column)];
  error = 0.0;
  for (std::size_t k = 0; k < back.size(); ++k) error = std::max(error, std::abs(back[k] - m.right[k]));
  return x;
}

// Small: one worker does all. Large: subtrees are shared out, and columns of the fronts above them.
TEST(Multifrontal, SolvesInBothPrecisionsWithTheSameBitsOnAnyNumberOfWorkers) {
  for (const std::int32_t side : {20, 60}) {
    const GridMatrix m(side);
    double error = 0.0;
    const auto fine = solution<double>(m, 1, error);
    EXPECT_LT(error, 1e-11);
    const auto coarse = solution<float>(m, 1, error);
    EXPECT_LT(error, 1e-3);
    for (const int workers : {2, 3, 8}) {
      EXPECT_EQ(solution<double>(m, workers, error), fine) << workers;
      EXPECT_EQ(solution<float>(m, workers, error), coarse) << workers;
    }
  }
}

template <class Real>
Array<Real> dense_results(const DenseKernels<Real>& kernels) {
  const std::int64_t m = 77, p = 41, ld = 80;
  const auto size = [](std::int64_t n) { return static_cast<std::size_t>(n); };
  Random random(5);
  Array<Real> w(size(ld * m), Real(0));
  for (std::int64_t c = 0; c < m; ++c) {
    for (std::int64_t r = 0; r < m; ++r) w[size(r + c * ld)] = static_cast<Real>(random.uniform() - 0.5);
  }
  std::vector<std::int32_t> swaps(size(p));
  kernels.factor_front(w.data(), m, p, ld, swaps.data());
  for (std::int64_t c = 0; c < m; ++c) {
    for (std::int64_t r = m; r < ld; ++r) EXPECT_EQ(w[size(r + c * ld)], Real(0));
  }
  Array<Real> columns(size(m * p + dense_slack)), rows(size(p * (m - p) + dense_slack));
  for (std::int64_t c = 0; c < p; ++c) std::copy_n(w.data() + c * ld, m, columns.data() + c * m);
  for (std::int64_t c = p; c < m; ++c) std::copy_n(w.data() + c * ld, p, rows.data() + (c - p) * p);
  Array<Real> x(size(p + dense_slack), Real(1)), y(size(m - p + dense_slack), Real(1));
  kernels.forward(columns.data(), m, p, swaps.data(), x.data());
  kernels.below(columns.data(), m, p, x.data(), y.data(), 0, m - p);
  kernels.right(rows.data(), p, m - p, y.data(), x.data(), 0, p);
  kernels.backward(columns.data(), m, p, x.data());
  w.insert(w.end(), x.begin(), x.begin() + p);
  w.insert(w.end(), y.begin(), y.begin() + (m - p));
  return w;
}

TEST(DenseKernels, GiveTheSameBitsOnEveryInstructionSet) {
  const DenseTable* baseline = dense_kernels_for("baseline");
  for (const char* name : {"avx2", "avx512"}) {
    const DenseTable* table = dense_kernels_for(name);
    if (table == nullptr) continue;
    EXPECT_TRUE(dense_results(table->single_precision) == dense_results(baseline->single_precision)) << name;
    EXPECT_TRUE(dense_results(table->double_precision) == dense_results(baseline->double_precision)) << name;
  }
}

// A cracked, pressurised model with flow: everything the equations hold.
struct CrackedModel {
  Simulation s;
  explicit CrackedModel(CaseDefinition definition) : s(std::move(definition), {}, {}) {
    for (int k = 0; k < 3; ++k) s.step();
  }
};

// From the well's wall into the rock: closes by Bandis, dilates, conducts by its own aperture.
JointOptions conducting_joint() {
  JointOptions joint;
  joint.x1 = 50.0;
  joint.y1 = 50.0;
  joint.x2 = 90.0;
  joint.y2 = 65.0;
  joint.state = static_cast<std::int64_t>(JointState::smooth_broken);
  joint.normal_stiffness = 1e10;
  joint.shear_stiffness = 1e9;
  joint.max_closure = joint.aperture = 1e-3;
  joint.friction = 0.2;
  joint.dilation_angle = 0.1;
  joint.dilation_slip = 1.0;
  return joint;
}

TEST(CoupledSystem, ProductIsTheChangeOfTheResidual) {
  for (const int number : {0, 1, 2, 3, 5}) {
    const bool walls = number % 2 == 0, planes = number == 2 || number == 3, joint = number > 3;
    CaseDefinition definition = cracking_case();
    definition.options.packing_disc_count = 400;
    definition.wells[0].radius = 12.0;
    definition.options.stepping_flow_step = 1e-3;
    if (planes)
      definition.options.flow_fracture_aperture = static_cast<std::int64_t>(FractureAperture::plane);
    // A contact that slid sits on the kink between sliding and sticking; BondResponse has a test of its own.
    definition.options.contact_shear_stiffness = 0.0;
    if (!walls) {
      definition.options.boundary_kind = choice(BoundaryKind::stress);
      definition.options.stress_sigma_Hmax = definition.options.stress_sigma_hmin = 5e6;
      definition.options.bond_tensile_strength = 1e12;
    }
    if (joint) definition.joints.push_back(conducting_joint());
    CrackedModel model(definition);
    // Open to the test's hands; the simulation is not used afterwards.
    auto& assembly = const_cast<Assembly&>(model.s.assembly());
    auto& network = const_cast<Network&>(model.s.network());
    auto& boundary = *model.s.engine().boundary;
    const NonBondedContacts& loose = model.s.engine().mechanics->non_bonded_contacts();
    for (std::size_t e = 50; e < 60; ++e) assembly.intact[e] = 0.0;
    Workers team(2);
    Facets facets;
    CoupledSystem system(assembly, network, boundary, loose, model.s.options(), team, facets);
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
    EXPECT_LT((change - y).norm(), 1e-3 * y.norm())
        << (walls ? "walls" : "stress boundary") << (planes ? ", apertures of planes" : "")
        << (joint ? ", a joint" : "");
  }
}

TEST(CoupledFactor, SolvesTheTangent) {
  CaseDefinition definition = cracking_case();
  definition.options.packing_disc_count = 400;
  definition.wells[0].radius = 12.0;
  CrackedModel model(definition);
  auto& assembly = const_cast<Assembly&>(model.s.assembly());
  auto& network = const_cast<Network&>(model.s.network());
  auto& boundary = *model.s.engine().boundary;
  Workers team(2);
  Facets facets;
  CoupledSystem system(assembly, network, boundary, model.s.engine().mechanics->non_bonded_contacts(),
                       model.s.options(), team, facets);
  system.begin(1e-3, {});
  system.evaluate();
  CoupledFactor factor(team);
  factor.compute(system);
  Random random(11);
  CoupledSystem::Vector right(system.size()), x, y;
  for (Eigen::Index k = 0; k < right.size(); ++k) right[k] = random.uniform() - 0.5;
  const auto outcome =
      Krylov(team).solve([&](const auto& in, auto& out) { system.product(in, out); },
                         [&](const auto& in, auto& out) { factor.solve(in, out); }, right, 1e-10, 200, x);
  EXPECT_TRUE(outcome.converged);
  system.product(x, y);
  EXPECT_LT((y - right).norm(), 2e-10 * right.norm());
}

}  // namespace equilibrium_test
