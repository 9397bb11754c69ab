// SPDX-License-Identifier: BSD-3-Clause
// The rock beyond the model: the plane around a hole, its answer on the discs, and simulations with boundary.kind infinite.
#include "solid/exterior.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <string>

#include "core/error.hpp"
#include "core/plane_fit.hpp"
#include "equilibrium/coupled_system.hpp"
#include "model.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"

namespace exterior_test {

using namespace testing_unit;
using Complex = std::complex<double>;

constexpr PlaneElasticity rock{14e9, 0.25};
const double shear = rock.modulus / (2.0 * (1.0 + rock.poisson));

std::vector<Vec2> circle(std::size_t points, double radius) {
  std::vector<Vec2> rim;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = 2.0 * pi * static_cast<double>(k) / static_cast<double>(points);
    rim.push_back({radius * std::cos(t), radius * std::sin(t)});
  }
  return rim;
}

// Fields that decay from a circle of radius 1 (Muskhelishvili): the potentials z^-k, one at a time. Displacement times 2 G, and what of
// the force has passed from angle 0 on.
struct Mode {
  int power;
  bool phi;
  [[nodiscard]] Complex displacement(double angle) const {
    const Complex z = std::polar(1.0, angle);
    const double kappa = 3.0 - 4.0 * rock.poisson / (1.0 + rock.poisson);
    if (!phi) return -std::conj(std::pow(z, -power));
    return kappa * std::pow(z, -power) + z * std::conj(static_cast<double>(power) * std::pow(z, -power - 1));
  }
  [[nodiscard]] Complex force(double angle) const {
    const Complex z = std::polar(1.0, angle);
    if (!phi) return std::conj(std::pow(z, -power));
    return std::pow(z, -power) - z * std::conj(static_cast<double>(power) * std::pow(z, -power - 1));
  }
  // Half of traction times displacement around the rim.
  [[nodiscard]] double energy() const {
    constexpr int pieces = 2000;
    double sum = 0.0;
    for (int k = 0; k < pieces; ++k) {
      const double t = 2.0 * pi * (k + 0.5) / pieces, half = pi / pieces;
      const Complex traction = Complex(0.0, -1.0) * (force(t + half) - force(t - half));
      sum += 0.5 * (traction * std::conj(displacement(t))).real();
    }
    return std::abs(sum) / (2.0 * shear);
  }
};

TEST(InfinitePlane, AnswersAsTheFormulasForACircleSay) {
  const auto rim = circle(64, 1.0);
  const Eigen::MatrixXd k = infinite_plane_stiffness(rim, {}, rock);
  for (int power = 1; power <= 4; ++power) {
    for (const bool phi : {false, true}) {
      const Mode mode{power, phi};
      Eigen::VectorXd u(k.rows());
      for (std::size_t p = 0; p < rim.size(); ++p) {
        const Complex at = mode.displacement(std::atan2(rim[p].y, rim[p].x)) / (2.0 * shear);
        u.segment<2>(2 * static_cast<Eigen::Index>(p)) << at.real(), at.imag();
      }
      EXPECT_NEAR(0.5 * u.dot(k * u) / mode.energy(), 1.0, 0.003) << power << phi;
    }
  }
}

TEST(InfinitePlane, ResistsATurnAndHardlyAShift) {
  constexpr double radius = 3.0;
  const auto rim = circle(48, radius);
  const Eigen::MatrixXd k = infinite_plane_stiffness(rim, {}, rock);
  Eigen::VectorXd turn(k.rows()), shift = Eigen::VectorXd::Zero(k.rows());
  for (Eigen::Index p = 0; p < k.rows() / 2; ++p) {
    const Vec2 at = rim[static_cast<std::size_t>(p)];
    turn.segment<2>(2 * p) << -at.y, at.x;
    shift[2 * p] = 1.0;
  }
  EXPECT_NEAR(turn.dot(k * turn) / (4.0 * pi * shear * radius * radius), 1.0, 1e-3);
  // The force F that moves a rigid disc by one metre against rest at the distance R is 8 pi G (1 - nu) / ((3 - 4 nu) ln(R / a)), about.
  const double nu = rock.poisson / (1.0 + rock.poisson),
               by_log = 8.0 * pi * shear * (1.0 - nu) / (3.0 - 4.0 * nu);
  const double logarithm = by_log / shift.dot(k * shift);
  EXPECT_GT(logarithm, std::log(1e3));
  EXPECT_LT(logarithm, 1.1 * std::log(1e6));
}

TEST(InfinitePlane, IsSymmetricAndPositive) {
  std::vector<Vec2> square;
  for (int side = 0; side < 4; ++side) {
    const Vec2 from[4] = {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}};
    for (int k = 0; k < 10; ++k)
      square.push_back(from[side] + (k / 10.0) * (from[(side + 1) % 4] - from[side]));
  }
  const Eigen::MatrixXd k = infinite_plane_stiffness(square, {}, rock);
  EXPECT_EQ((k - k.transpose()).cwiseAbs().maxCoeff(), 0.0);
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
  EXPECT_GT(values[0], 0.0);
  EXPECT_EQ(infinite_plane_stiffness({{0, 0}, {1, 0}, {0.2, 0.1}, {0, 1}}, {0.5, 0.6}, rock).size(), 0);
}

struct Held : TestModel {
  explicit Held(Options o) : TestModel(o, packed(o), {{{10.0, 10.0}, 3.0}}) {
    boundary->engage(std::make_unique<Exterior>(assembly, network, rock));
    solver->refresh_stiffness();
    boundary->set_load(assembly, 1.0);
  }
  std::vector<double> forces() {
    boundary->answer(assembly);
    std::vector<double> f;
    for (const auto i : boundary->edge()) {
      const Vec2 on = boundary->load_on(i);
      f.push_back(on.x);
      f.push_back(on.y);
    }
    return f;
  }
};

TEST(Exterior, ForcesAreTheGradientOfItsEnergy) {
  Held m(dry_options(800));
  m.shake(1e-3, 5);
  const auto force = m.forces();
  const auto edge = m.boundary->edge();
  constexpr double step = 1e-4;
  for (std::size_t k = 0; k < edge.size(); k += 7) {
    for (int axis = 0; axis < 2; ++axis) {
      double& u = axis == 0 ? m.assembly.ux[edge[k]] : m.assembly.uy[edge[k]];
      u += step;
      const double up = m.boundary->exterior_energy(m.assembly);
      u -= 2.0 * step;
      const double down = m.boundary->exterior_energy(m.assembly);
      u += step;
      EXPECT_NEAR(force[2 * k + static_cast<std::size_t>(axis)], -(up - down) / (2.0 * step),
                  1e-6 * rock.modulus * m.assembly.mean_radius);
    }
  }
}

TEST(Exterior, ATurnOfAllDiscsIsOneOfThePlane) {
  Held m(dry_options(800));
  constexpr double angle = 1e-6;
  double area = 0.0;  // of the rim, by its points
  const auto& points = m.boundary->exterior()->points();
  for (std::size_t p = 0; p < points.size(); ++p)
    area += 0.5 * cross(points[p], points[(p + 1) % points.size()]);
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.ux[i] = -angle * m.assembly.y[i];
    m.assembly.uy[i] = angle * m.assembly.x[i];
  }
  m.boundary->answer(m.assembly);
  double moment = 0.0;
  for (const auto i : m.boundary->edge())
    moment += cross({m.assembly.x[i] - 10.0, m.assembly.y[i] - 10.0}, m.boundary->load_on(i));
  // A square resists as a circle of somewhat more than its area.
  EXPECT_NEAR(-moment / (4.0 * shear * area * angle), 1.1, 0.1);
}

TEST(Exterior, TheStableStepKnowsItsStiffness) {
  Held m(dry_options(800));
  std::vector<double> x(m.assembly.x.size(), 0.0), y = x;
  m.boundary->exterior()->add_stiffness(x, y);
  // Rows of the stiffness, found by moving one disc after the other.
  const auto edge = m.boundary->edge();
  std::vector<double> rows(2 * edge.size(), 0.0);
  for (const auto i : edge) {
    for (double* u : {&m.assembly.ux[i], &m.assembly.uy[i]}) {
      *u = 1.0;
      const auto force = m.forces();
      *u = 0.0;
      for (std::size_t k = 0; k < rows.size(); ++k) rows[k] += std::abs(force[k]);
    }
  }
  for (std::size_t k = 0; k < edge.size(); ++k) {
    EXPECT_LE(rows[2 * k], x[edge[k]] * (1.0 + 1e-9));
    EXPECT_LE(rows[2 * k + 1], y[edge[k]] * (1.0 + 1e-9));
    EXPECT_GT(rows[2 * k], 0.1 * x[edge[k]]);
  }
}

// Linear rock with a hole of 12 m in 60 m, pressed by 5 MPa more than at first.
CaseDefinition holed(SolverKind solver, BoundaryKind kind) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.model_width = o.model_height = 60.0;
  o.packing_disc_count = 900;
  o.boundary_kind = choice(kind);
  o.contact_mode = choice(ContactMode::after_break);
  o.bond_normal_stiffness = 16e9;
  o.bond_shear_stiffness = 5.6e9;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.stress_sigma_Hmax = 12e6;
  o.stress_sigma_hmin = 8e6;
  o.fluid_formation_pressure = 4e6;
  o.flow_permeability = 1e-18;
  o.solver_kind = choice(solver);
  o.stepping_flow_step = 1e-3;
  o.stepping_force_ratio = 1e-7;
  o.solver_tolerance = 1e-9;
  o.stepping_max_cycles = 400000;
  WellOptions well;
  well.x = well.y = 30.0;
  well.radius = 12.0;
  well.pressure = 9e6;
  definition.wells.push_back(well);
  return definition;
}

// Largest difference of displacement over the largest displacement, but for a shift and a turn: nothing says where a model without rock beyond lies.
double difference(const Assembly& a, const Assembly& b) {
  PlaneFit along_x, along_y;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    along_x.add(a.x[i], a.y[i], a.ux[i] - b.ux[i]);
    along_y.add(a.x[i], a.y[i], a.uy[i] - b.uy[i]);
  }
  const auto x = along_x.plane(), y = along_y.plane();
  const double turn = 0.5 * (y.by_x - x.by_y);
  double sum_x = 0.0, sum_y = 0.0;
  const auto discs = static_cast<double>(a.disc_count());
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    sum_x += (a.ux[i] - b.ux[i] + turn * a.y[i]) / discs;
    sum_y += (a.uy[i] - b.uy[i] - turn * a.x[i]) / discs;
  }
  double off = 0.0, largest = 0.0;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    off = std::max(off, std::hypot(a.ux[i] - b.ux[i] + turn * a.y[i] - sum_x,
                                   a.uy[i] - b.uy[i] - turn * a.x[i] - sum_y));
    largest = std::max(largest, std::hypot(a.ux[i], a.uy[i]));
  }
  return off / largest;
}

TEST(InfiniteRock, BothSolversFindTheSameRest) {
  Simulation moved(holed(SolverKind::explicit_solver, BoundaryKind::infinite), {}, {}),
      solved(holed(SolverKind::quasi_static, BoundaryKind::infinite), {}, {});
  EXPECT_LT(difference(moved.assembly(), solved.assembly()), 1e-4);
  moved.step();
  solved.step();
  EXPECT_TRUE(moved.model().clock.at_rest);
  EXPECT_LT(difference(moved.assembly(), solved.assembly()), 1e-4);
  const Balance balance = moved.balance();
  EXPECT_LT(std::abs(balance.energy_error), 0.01 * balance.fluid_work);
  // What the rock beyond holds counts: 2 % and more of the energy.
  EXPECT_GT(moved.engine().boundary->exterior_energy(moved.assembly()), 0.02 * balance.fluid_work);
}

TEST(InfiniteRock, BearsNothingOfTheFarFieldAlone) {
  CaseDefinition with = holed(SolverKind::quasi_static, BoundaryKind::infinite),
                 without = holed(SolverKind::quasi_static, BoundaryKind::stress);
  with.wells.clear();
  without.wells.clear();
  Simulation infinite(with, {}, {}), plain(without, {}, {});
  // What differs is the disc at the lower left corner, where springs hold a model without rock beyond: they bear the moment of its loads.
  EXPECT_LT(difference(infinite.assembly(), plain.assembly()), 2e-3);
  EXPECT_LT(infinite.engine().boundary->exterior_energy(infinite.assembly()),
            1e-6 * infinite.balance().bond_elastic);
  EXPECT_NEAR(infinite.setup().exterior_poisson_ratio, 0.2, 0.15);
  EXPECT_GT(infinite.setup().exterior_modulus, 10e9);
  // More of it strains the rock beyond, too.
  set_far_field(infinite, 14e6, 9e6);
  set_far_field(plain, 14e6, 9e6);
  const double before = infinite.balance().bond_elastic;
  infinite.step();
  plain.step();
  EXPECT_LT(difference(infinite.assembly(), plain.assembly()), 0.02);
  EXPECT_LT(infinite.engine().boundary->exterior_energy(infinite.assembly()),
            1e-3 * (infinite.balance().bond_elastic - before));
}

TEST(InfiniteRock, ResultsDependNeitherOnWorkersNorOnRestoring) {
  for (const auto solver : {SolverKind::explicit_solver, SolverKind::quasi_static}) {
    std::uint64_t hash = 0;
    for (const int workers : {1, 2, 3}) {
      CaseDefinition definition = holed(solver, BoundaryKind::infinite);
      definition.options.packing_disc_count = 700;  // two tiles
      definition.options.run_workers = workers;
      definition.options.stepping_force_ratio = 1e-4;
      definition.options.bond_tensile_strength = definition.options.bond_shear_strength = 4e6;
      definition.options.initial_broken_fraction = 1.0;
      Simulation sim(definition, {}, {});
      sim.step();
      std::vector<std::byte> image(sim.image_size());
      sim.write_image(image);
      const auto before = sim.state_hash();
      sim.step();
      const auto after = sim.state_hash();
      if (workers > 1) {
        EXPECT_EQ(after, hash) << workers;
      }
      hash = after;
      sim.restore(image);
      EXPECT_EQ(sim.state_hash(), before);
      sim.step();
      EXPECT_EQ(sim.state_hash(), after);
      if (workers > 1) continue;
      Simulation other(definition, {}, {});
      other.restore(image);
      other.step();
      EXPECT_EQ(other.state_hash(), after);
      EXPECT_FALSE(sim.cracks().empty());
    }
  }
}

TEST(InfiniteRock, ItsTangentIsTheChangeOfTheResidual) {
  CaseDefinition definition = holed(SolverKind::quasi_static, BoundaryKind::infinite);
  Simulation sim(definition, {}, {});
  Engine& e = sim.engine();
  Model& m = e.model;
  Facets facets;
  CoupledSystem system(m.assembly, m.network, *e.boundary, e.mechanics->non_bonded_contacts(), sim.options(),
                       *e.workers, facets);
  system.begin(1e-3, {});
  system.evaluate();
  Random random(7);
  CoupledSystem::Vector x(system.size()), y;
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = 1e-7 * (random.uniform() - 0.5);
  const std::int64_t discs = m.assembly.disc_count();
  for (std::int64_t d = 0; d < m.network.domain_count(); ++d) {
    if (m.network.stiffness[d] == 0.0) x[3 * discs + d] = 0.0;
  }
  // The tractions that go with the displacements: those that leave nothing in their rows.
  const auto tractions = static_cast<Eigen::Index>(e.boundary->exterior()->size());
  x.tail(tractions).setZero();
  system.product(x, y);
  const double scale =
      sim.options().contact_normal_stiffness / (m.assembly.mean_radius * m.assembly.mean_radius);
  const Eigen::MatrixXd& compliance = e.boundary->exterior()->compliance();
  const Eigen::VectorXd in_rows = y.tail(tractions);
  x.tail(tractions) = compliance.llt().solve(in_rows) / scale;
  system.product(x, y);
  EXPECT_LT(y.tail(tractions).cwiseAbs().maxCoeff(), 1e-9 * x.cwiseAbs().maxCoeff());
  const CoupledSystem::Vector before = system.residual();
  system.move(x, 1.0);
  system.evaluate();
  const CoupledSystem::Vector change = before - system.residual();
  EXPECT_LT((change - y).cwiseAbs().maxCoeff(), 1e-4 * y.cwiseAbs().maxCoeff());
  // And the list of its entries is the same matrix.
  std::vector<double> values;
  system.entries(values, 0, system.size());
  std::vector<MatrixPlace> places;
  system.structure().each_place([&](MatrixPlace place) { places.push_back(place); });
  CoupledSystem::Vector by_entries = CoupledSystem::Vector::Zero(x.size());
  system.move(x, -1.0);
  system.evaluate();
  system.entries(values, 0, system.size());
  system.product(x, y);
  for (std::size_t k = 0; k < values.size(); ++k)
    by_entries[places[k].row] += values[k] * x[places[k].column];
  EXPECT_LT((by_entries - y).cwiseAbs().maxCoeff(), 1e-9 * y.cwiseAbs().maxCoeff());
}

// Rock between the rim and where the pores have the formation's pressure is a resistance in series.
TEST(InfiniteRock, FluidHasFartherToGo) {
  const auto rate = [](double distance) {
    CaseDefinition definition = holed(SolverKind::quasi_static, BoundaryKind::infinite);
    definition.options.flow_permeability = 1e-12;
    definition.options.fluid_bulk_modulus = 1e9;
    definition.options.stepping_mode = choice(SteppingMode::coupled);
    definition.options.stepping_flow_step = 1e9;
    definition.options.boundary_flow_distance = distance;
    Simulation sim(definition, {}, {});
    sim.step();
    sim.step();
    return sim.wells()[0].rate;
  };
  constexpr double distance = 1000.0, drop = 5e6, viscosity = 0.3;
  const double radius = 60.0 / std::sqrt(pi);
  const double beyond = std::log(distance / radius) * viscosity / (2.0 * pi * 1e-12);  // Pa s/m2
  EXPECT_NEAR((drop / rate(distance) - drop / rate(0.0)) / beyond, 1.0, 0.02);
}

TEST(InfiniteRock, RefusesWhatDoesNotGoTogether) {
  const auto why = [](const auto& change, BoundaryKind kind = BoundaryKind::infinite) {
    CaseDefinition definition = holed(SolverKind::quasi_static, kind);
    change(definition.options);
    try {
      validate(definition);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto expect = [&](const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  EXPECT_EQ(why([](Options&) {}), "");
  expect(why([](Options& o) { o.boundary_exterior_modulus = 1e9; }, BoundaryKind::stress),
         "beyond the model");
  expect(why([](Options& o) { o.boundary_exterior_poisson_ratio = 0.2; }), "both are measured");
  expect(why([](Options& o) { o.boundary_flow_distance = 500.0; }, BoundaryKind::walls),
         "is for boundary.kind");
  expect(why([](Options& o) { o.boundary_flow_distance = 20.0; }), "is not beyond the model");
  expect(why([](Options& o) {
           o.boundary_flow_distance = 500.0;
           o.flow_outer = choice(OuterPores::closed);
         }),
         "no fluid passes");
  expect(why([](Options& o) { o.packing_disc_count = 1000000; }), "more than its");
}

}  // namespace exterior_test
