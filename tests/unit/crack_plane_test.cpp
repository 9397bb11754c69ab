// SPDX-License-Identifier: BSD-3-Clause
// The local plane of a crack, and bonds that stay because a disc would come loose.
#include "model/crack_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "flow/aperture.hpp"
#include "small_case.hpp"

namespace crack_plane_test {

using namespace testing_unit;

Options plane_options(std::int64_t discs) {
  Options o = dry_options(discs);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.flow_fracture_aperture = static_cast<std::int64_t>(FractureAperture::plane);
  o.flow_aperture_limit = 0.1;
  return o;
}

// Breaks every bond across a level line and moves what is above up.
struct Split {
  TestModel model;
  double level = 0.0;
  std::vector<std::size_t> broken;
  explicit Split(double width) : model(plane_options(1500), packed(plane_options(1500))) {
    auto& a = model.assembly;
    const auto [low, high] = std::minmax_element(a.y.begin(), a.y.end());
    level = 0.5 * (*low + *high);
    for (std::size_t e = 0; e < a.first.size(); ++e) {
      if ((a.y[a.first[e]] - level) * (a.y[a.second[e]] - level) >= 0.0) continue;
      a.intact[e] = 0;
      broken.push_back(e);
    }
    for (std::size_t i = 0; i < a.x.size(); ++i) a.uy[i] = a.y[i] > level ? width : 0.0;
    model.network.planes.refresh(model.network, a);
  }
  [[nodiscard]] double opening(std::size_t e) const {
    return CrackPlanes::opening(*model.network.planes.of(e), model.assembly, e);
  }
};

TEST(CrackPlane, OpensAsTheFacesMoveApartInARandomPacking) {
  const double width = 2e-3;
  Split split(width);
  ASSERT_GT(split.broken.size(), 40U);
  double mean = 0.0, gaps = 0.0, lowest = width;
  for (const auto e : split.broken) {
    ASSERT_NE(split.model.network.planes.of(e), nullptr);
    mean += split.opening(e) / static_cast<double>(split.broken.size());
    lowest = std::min(lowest, split.opening(e));
    gaps += view_bond(split.model.assembly, split.model.options, static_cast<std::int64_t>(e)).gap /
            static_cast<double>(split.broken.size());
  }
  EXPECT_NEAR(mean / width, 1.0, 0.08);
  EXPECT_GT(lowest / width, 0.5);
  EXPECT_LT(gaps / width, 0.85);  // what the bonds' own gaps make of it
  EXPECT_EQ(split.model.network.planes.of(0) != nullptr, split.model.assembly.intact[0] == 0);
}

// All pipes in a row are as long as the model is wide, and resist as a slit of that width does.
TEST(CrackPlane, PipesInARowConductLikeASlit) {
  const double width = 2e-3;
  Split split(width);
  Network& n = split.model.network;
  n.zero_stress_aperture = 1e-6;
  update_apertures(n, split.model.assembly, split.model.options);
  double length = 0.0, resistance = 0.0, pairs = 0.0, from = 1e9, to = 0.0;
  for (const auto e : split.broken) {
    if (n.left[e] == 0 || n.right[e] == 0) continue;
    length += pipe_length(n, split.model.assembly, e);
    resistance += pipe_length(n, split.model.assembly, e) / std::pow(n.aperture[e], 3);
    pairs += split.model.assembly.pipe_length(static_cast<std::int64_t>(e));
    for (const auto d : {n.left[e], n.right[e]}) {
      from = std::min(from, n.centroid[static_cast<std::size_t>(d)].x);
      to = std::max(to, n.centroid[static_cast<std::size_t>(d)].x);
    }
  }
  EXPECT_NEAR(length / (to - from), 1.0, 0.1);
  EXPECT_GT(pairs / (to - from), 1.2);  // R_i + R_j
  EXPECT_NEAR(std::cbrt((to - from) / resistance) / width, 1.0, 0.1);
}

TEST(CrackPlane, ARigidRotationOpensNothing) {
  Split split(0.0);
  auto& a = split.model.assembly;
  const double turn = 1e-4;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    a.ux[i] = -turn * a.y[i];
    a.uy[i] = turn * a.x[i];
    a.rotation[i] = turn;
  }
  for (const auto e : split.broken) EXPECT_NEAR(split.opening(e), 0.0, 1e-12 * a.mean_radius);
}

// Planes are a function of which bonds are broken: step by step, back again, or at once gives the same bits.
TEST(CrackPlane, FollowsTheStateWhateverTheWay) {
  Split split(0.0);
  auto& a = split.model.assembly;
  auto& n = split.model.network;
  const auto planes = [&](const CrackPlanes& of) {
    std::vector<double> values;
    for (std::size_t e = 0; e < a.first.size(); ++e) {
      const CrackPlane* plane = of.of(e);
      const CrackPlane p = plane != nullptr ? *plane : CrackPlane{};
      for (const double v : {p.normal.x, p.normal.y, p.by_first, p.by_second, p.shrinks, p.length})
        values.push_back(v);
    }
    return values;
  };
  const auto all = planes(n.planes);
  CrackPlanes stepwise;
  for (const auto e : split.broken) a.intact[e] = 1;
  stepwise.begin(n, a);
  Random random(3);
  auto order = split.broken;
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  for (const auto e : order) {
    a.intact[e] = 0;
    stepwise.refresh(n, a);
  }
  EXPECT_EQ(planes(stepwise), all);
  for (std::size_t k = 0; k < order.size(); k += 2) a.intact[order[k]] = 1;
  stepwise.refresh(n, a);
  CrackPlanes fresh;
  fresh.begin(n, a);
  EXPECT_EQ(planes(stepwise), planes(fresh));
}

// A disc between two faces that lost its bonds, pressed on both: no pipe beside it may be shut.
TEST(Fragments, TheLastBondOfADiscStays) {
  Options o = plane_options(400);
  o.bond_smallest_fragment = 2;
  TestModel m(o, square_lattice(20, 20, 0.5));
  std::vector<std::int64_t> bonds;
  for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
    for (const auto i : {m.assembly.first[e], m.assembly.second[e]}) {
      if (std::abs(m.assembly.x[i] - 10.5) < 0.1 && std::abs(m.assembly.y[i] - 10.5) < 0.1)
        bonds.push_back(e);
    }
  }
  ASSERT_EQ(bonds.size(), 4U);
  CrackLog log;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_FALSE(m.solver->stays(bonds[k]));
    m.solver->break_bond(bonds[k], log);
  }
  EXPECT_TRUE(m.solver->stays(bonds[3]));
  o.bond_smallest_fragment = 1;
  TestModel free(o, square_lattice(20, 20, 0.5));
  for (std::size_t k = 0; k < 3; ++k) free.solver->break_bond(bonds[k], log);
  EXPECT_FALSE(free.solver->stays(bonds[3]));
}

// By motion, on one worker or several: no disc loses its last bond, and the bits are the same.
TEST(Fragments, MotionKeepsThemToo) {
  std::uint64_t hash = 0;
  for (const int workers : {1, 3}) {
    CaseDefinition definition = cracking_case();
    definition.options.bond_smallest_fragment = 2;
    definition.options.run_workers = workers;
    Simulation s(definition, {}, {});
    for (int k = 0; k < 4; ++k) s.step();
    ASSERT_GT(s.cracks().size(), 5U);
    std::vector<int> bonds(static_cast<std::size_t>(s.assembly().disc_count()), 0);
    for (std::int64_t e = 0; e < s.assembly().bond_count(); ++e) {
      if (s.assembly().intact[e] == 0) continue;
      ++bonds[static_cast<std::size_t>(s.assembly().first[e])];
      ++bonds[static_cast<std::size_t>(s.assembly().second[e])];
    }
    EXPECT_GT(*std::min_element(bonds.begin(), bonds.end()), 0);
    if (workers > 1) {
      EXPECT_EQ(s.state_hash(), hash);
    }
    hash = s.state_hash();
  }
}

// Rock under total stresses of 15 and 10 MPa in discs of 0.8 m, with K_Ic = 5 MPa m^0.5: damped motion broke all of it.
CaseDefinition deep_case(double toughness, std::int64_t discs) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.model_seed = 2;
  o.packing_disc_count = discs;
  o.contact_mode = choice(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = 16e9;
  o.contact_shear_stiffness = o.bond_shear_stiffness = 5.6e9;
  o.bond_tensile_strength = 10e6;
  o.bond_shear_strength = 40e6;
  o.bond_fracture_toughness = toughness;
  o.fracture_law = choice(FractureLaw::bond);  // strengths by the toughness
  o.stress_sigma_Hmax = 15e6;
  o.stress_sigma_hmin = 10e6;
  o.fluid_formation_pressure = 5e6;
  o.fluid_bulk_modulus = 2.2e9;
  o.fluid_viscosity = 0.01;
  o.flow_permeability = 1e-17;
  o.solver_kind = choice(SolverKind::quasi_static);
  o.stepping_mode = choice(SteppingMode::coupled);
  o.solver_smallest_step = 1e-2;
  o.solver_pressure_change = 0.3;
  o.solver_strength_overshoot = 0.1;
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = discs > 2000 ? 1.65 : 4.0;
  well.control = WellControl::rate;
  well.rate = 1e-3;
  definition.wells.push_back(well);
  return definition;
}

TEST(SetUp, DoesNotBreakRockThatBearsItsStress) {
  const Simulation s(deep_case(5e6, 4000), {}, {});
  EXPECT_LT(s.setup().cracks, 10);
  EXPECT_TRUE(s.model().clock.at_rest);
}

// Nor does the first step: a bond of an outermost disc broke then, and its dead load had no equilibrium.
TEST(SetUp, LeavesAnEdgeThatHolds) {
  Simulation s(deep_case(5e6, 4000), {}, {});
  EXPECT_FALSE(s.step().stopped);
  EXPECT_LT(s.cracks().size(), 10U);
}

TEST(SetUp, RefusesRockThatDoesNotInWords) {
  try {
    const Simulation s(deep_case(2e5, 1500), {}, {});
    FAIL() << "stands with " << s.setup().cracks << " cracks";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::collapsed);
    EXPECT_NE(text.find("initial.broken_fraction"), std::string::npos) << text;
    EXPECT_NE(text.find("does not bear the far field"), std::string::npos) << text;
    EXPECT_NE(text.find("bond.tensile_strength"), std::string::npos) << text;
  }
}

}  // namespace crack_plane_test
