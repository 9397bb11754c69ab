// SPDX-License-Identifier: BSD-3-Clause
// Smooth joints: pieces and normals, the law, both solvers, balance, restore, the end of its reach.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "equilibrium/bond_response.hpp"
#include "small_case.hpp"
#include "solid/joints.hpp"
#include "solid/smooth_joints.hpp"
#include "tangent_check.hpp"

namespace smooth_joint_test {

using namespace testing_unit;

JointOptions joint_at(double degrees, double half_length, Vec2 middle, double friction, JointState state) {
  const Vec2 along{std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0)};
  JointOptions joint;
  joint.x1 = middle.x - half_length * along.x;
  joint.y1 = middle.y - half_length * along.y;
  joint.x2 = middle.x + half_length * along.x;
  joint.y2 = middle.y + half_length * along.y;
  joint.friction = friction;
  joint.state = static_cast<std::int64_t>(state);
  return joint;
}

// A dry block of 20 m, cut through by a joint.
struct Cut {
  Options o = dry_options(500);
  JointOptions joint;
  Assembly a;
  CrackLog cracks;
  Cut(double degrees, JointState state, double friction = 0.5, std::int64_t seed = 1) {
    o.model_seed = seed;
    const Discs discs = packed(o);
    ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, o.bond_gap_tolerance);
    joint = joint_at(degrees, 15.0, {10.0, 10.0}, friction, state);
    a = build_assembly(std::move(graph), o);
    apply_joints(a, {joint}, o, cracks);
  }
  [[nodiscard]] Vec2 along() const {
    const Vec2 d{joint.x2 - joint.x1, joint.y2 - joint.y1};
    return (1.0 / std::sqrt(dot(d, d))) * d;
  }
  [[nodiscard]] bool above(std::int64_t i) const {
    return cross(along(), Vec2{a.x[i] - joint.x1, a.y[i] - joint.y1}) > 0.0;
  }
  // The discs on the left of the joint move as one, and those that were left to them.
  void move(Vec2 by) {
    for (std::int32_t i = 0; i < a.disc_count(); ++i) {
      const bool left = above(i) != (a.smooth.moved_over(i) >= 0);
      a.ux[i] = left ? by.x : 0.0;
      a.uy[i] = left ? by.y : 0.0;
    }
  }
};

TEST(SmoothJoint, PiecesAddUpToItsLengthWhateverTheAngle) {
  for (const double degrees : {0.0, 27.0, 63.0, 90.0, 117.0}) {
    const Cut cut(degrees, JointState::smooth_broken);
    double sum = 0.0;
    const Vec2 normal{-cut.along().y, cut.along().x};
    for (const auto& contact : cut.a.smooth.contacts) {
      sum += contact.area;
      EXPECT_NEAR(std::abs(dot(contact.normal, normal)), 1.0, 1e-12);
      if (cut.above(cut.a.first[contact.bond]) != cut.above(cut.a.second[contact.bond])) {
        EXPECT_GT(dot(contact.normal, Vec2{cut.a.dx(contact.bond), cut.a.dy(contact.bond)}), 0.0);
      }
      EXPECT_NEAR(dot(contact.first_arm() - contact.second_arm(),
                      Vec2{cut.a.dx(contact.bond), cut.a.dy(contact.bond)}),
                  cut.a.length(contact.bond) * cut.a.length(contact.bond), 1e-9);
    }
    const double inside = 20.0 / std::max(std::abs(cut.along().x), std::abs(cut.along().y));
    EXPECT_NEAR(sum, inside, 3.0 * cut.a.mean_radius) << degrees;
    EXPECT_LE(sum, inside + 0.5 * cut.a.mean_radius);
    EXPECT_EQ(cut.cracks.size(), cut.a.smooth.contacts.size());
  }
}

// A disc on one bond of its own side belongs to the other, and the joint is led around it; with one bond on either side its contact is idle.
// Pieces still follow each other, and whichever way the halves move each contact opens and slides as they do.
TEST(SmoothJoint, IsLedAroundDiscsOnOneBond) {
  int led = 0, idle = 0;
  for (std::int64_t seed = 1; seed <= 40; ++seed) {
    Cut cut(4.5 * static_cast<double>(seed), JointState::smooth_broken, 0.5, seed);
    const Assembly& a = cut.a;
    const Vec2 normal{-cut.along().y, cut.along().x}, opens = 1e-3 * normal, slides = 1e-3 * cut.along();
    std::vector<int> held(static_cast<std::size_t>(a.disc_count())), crossed(held.size());
    for (std::int64_t e = 0; e < a.bond_count(); ++e)
      for (const auto i : {a.first[e], a.second[e]})
        ++(a.smooth.of(e) != nullptr ? crossed : held)[static_cast<std::size_t>(i)];
    for (const auto& [disc, line] : a.smooth.moved) {
      EXPECT_GE(held[static_cast<std::size_t>(disc)], 2) << seed;
      EXPECT_EQ(line, 0);
    }
    struct Piece {
      double begin, end;
    };
    std::vector<Piece> pieces;
    std::vector<double> on_one_bond;  // where contacts of discs with one bond on either side lie
    for (const auto& c : a.smooth.contacts) {
      const auto i = static_cast<std::size_t>(a.first[c.bond]),
                 j = static_cast<std::size_t>(a.second[c.bond]);
      const double at = dot(Vec2{a.x[i], a.y[i]} + c.first_arm(), cut.along());
      const auto loose = [&](std::size_t d) { return held[d] == 1 && crossed[d] == 1; };
      if (c.area < 0.0101 * a.mean_radius) {
        idle += loose(i) || loose(j) ? 1 : 0;
        continue;
      }
      if (loose(i) || loose(j)) on_one_bond.push_back(at);
      pieces.push_back({at - 0.5 * c.area, at + 0.5 * c.area});
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& p, const Piece& q) { return p.begin < q.begin; });
    const auto is_void = [&](double gap) { return gap > a.mean_radius; };
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const double gap = pieces[k].begin - pieces[k - 1].end;
      EXPECT_TRUE(std::abs(gap) < 0.02 * a.mean_radius || is_void(gap)) << seed << ": " << gap;
    }
    // Only at its ends, or those of its parts, does such a contact bear.
    for (const double at : on_one_bond)
      for (std::size_t k = 1; k + 1 < pieces.size(); ++k)
        if (pieces[k].begin < at && at < pieces[k].end) {
          EXPECT_TRUE(pieces[k + 1].end - pieces[k - 1].begin > 4.0 * a.mean_radius ||
                      is_void(pieces[k].begin - pieces[k - 1].end) ||
                      is_void(pieces[k + 1].begin - pieces[k].end))
              << seed << ", " << at;
        }
    for (const Vec2 by : {opens, slides}) {
      cut.move(by);
      for (const auto& contact : a.smooth.contacts) {
        const SmoothResponse r = smooth_response(a, contact);
        const bool round = cut.above(a.first[contact.bond]) == cut.above(a.second[contact.bond]);
        led += round ? 1 : 0;
        EXPECT_NEAR(r.opening, dot(by, normal), 1e-15) << seed << ", bond " << contact.bond << round;
        EXPECT_NEAR(r.slide, -dot(by, cut.along()), 1e-15) << seed << ", bond " << contact.bond << round;
      }
    }
  }
  EXPECT_GT(led, 0) << "no packing puts what is tested to the test";
  EXPECT_GT(idle, 0) << "nor this";
}

// As where a well took all the discs along it, or another joint all of its bonds.
TEST(SmoothJoint, ThatCrossesNoBondStillLiesBetweenDiscs) {
  const Options o = dry_options(500);
  const Discs discs = packed(o);
  Assembly a =
      build_assembly(build_contact_graph(discs.x, discs.y, discs.radius, {}, o.bond_gap_tolerance), o);
  CrackLog cracks;
  apply_joints(a, {joint_at(0.0, 8.0, {10.0, 50.0}, 0.5, JointState::smooth_broken)}, o, cracks);
  EXPECT_TRUE(a.smooth.empty());
  EXPECT_TRUE(a.smooth.separate({10.0, 49.0}, {10.0, 51.0}));
  EXPECT_FALSE(a.smooth.separate({10.0, 9.0}, {10.0, 11.0}));
}

// The whole point: one half slides over the other without being lifted, and bears its coefficient of friction.
TEST(SmoothJoint, SlidesWithoutDilationAtItsCoefficientOfFriction) {
  for (const double degrees : {0.0, 30.0, 60.0}) {
    Cut cut(degrees, JointState::smooth_broken, 0.5);
    const Vec2 along = cut.along(), normal{-along.y, along.x};
    const double press = 1e-3, slide = 0.3 * cut.a.mean_radius;
    cut.move(-press * normal + slide * along);
    double friction = 0.0, area = 0.0, dissipated = 0.0;
    Vec2 force{};
    for (const auto& contact : cut.a.smooth.contacts) {
      const SmoothResponse r = smooth_response(cut.a, contact);
      const Vec2 tangent{-contact.normal.y, contact.normal.x};
      const double side = dot(contact.normal, normal);  // on the half that moved
      force = force - side * (r.normal * contact.normal + r.shear * tangent);
      area += contact.area;
    }
    const double squeeze = cut.a.smooth.normal_stiffness * press * area;
    EXPECT_NEAR(dot(force, normal), squeeze, 1e-9 * squeeze) << degrees;
    EXPECT_NEAR(dot(force, along), -0.5 * squeeze, 1e-9 * squeeze) << degrees;
    for (const auto& contact : cut.a.smooth.contacts)
      answer_of(cut.a, contact, cut.a.slip[contact.bond], friction);
    const double elastic = 0.5 * squeeze / (cut.a.smooth.shear_stiffness * area);
    dissipated = 0.5 * squeeze * (slide - elastic);
    EXPECT_NEAR(friction, dissipated, 1e-9 * dissipated);
    for (const auto& contact : cut.a.smooth.contacts)
      EXPECT_NEAR(std::abs(cut.a.slip[contact.bond]), slide - elastic, 1e-9 * slide);
  }
}

TEST(SmoothJoint, HoldsToItsStrengthPerArea) {
  Cut cut(30.0, JointState::smooth_bonded, 0.5);
  cut.o.bond_tensile_strength = 2e6;
  cut.o.bond_shear_strength = 5e6;
  cut.a.tensile_per_radius = 2.0 * cut.o.bond_tensile_strength;
  cut.a.shear_per_radius = 2.0 * cut.o.bond_shear_strength;
  const Vec2 along = cut.along(), normal{-along.y, along.x};
  EXPECT_TRUE(cut.cracks.empty());
  const double kn = cut.a.smooth.normal_stiffness, ks = cut.a.smooth.shear_stiffness;
  for (const double share : {0.999, 1.001}) {
    cut.move((share * 2e6 / kn) * normal);
    for (const auto& contact : cut.a.smooth.contacts)
      EXPECT_EQ(view_bond(cut.a, cut.o, contact.bond).tensile_excess >= 1.0, share > 1.0);
    // Mohr and Coulomb: c + mu sigma_n, with 4 MPa on it.
    cut.move((-4e6 / kn) * normal + (share * (5e6 + 0.5 * 4e6) / ks) * along);
    for (const auto& contact : cut.a.smooth.contacts)
      EXPECT_EQ(view_bond(cut.a, cut.o, contact.bond).shear_excess >= 1.0, share > 1.0);
  }
}

TEST(SmoothJoint, TangentIsTheChangeOfForceAndMomentsBalance) {
  for (const JointState state : {JointState::smooth_bonded, JointState::smooth_broken}) {
    for (const double press : {1e-3, 1e-5, -1e-3}) {  // sticking, sliding, open
      Cut cut(50.0, state, 0.5);
      const Vec2 along = cut.along(), normal{-along.y, along.x};
      cut.move(-press * normal + 1e-4 * along);
      const SmoothContact& contact = cut.a.smooth.contacts[3];
      const auto i = cut.a.first[contact.bond], j = cut.a.second[contact.bond];
      cut.a.rotation[i] = 1e-6;
      cut.a.rotation[j] = -2e-6;
      const BondResponse at = respond(cut.a, cut.o, contact.bond);
      expect_tangent(cut.a, cut.o, contact.bond, 1e-9, 1e-5 * cut.o.contact_normal_stiffness);
      // About any point, forces and moments of the pair are in balance, slid as they are.
      const double dx = cut.a.dx(contact.bond) + cut.a.ux[j] - cut.a.ux[i],
                   dy = cut.a.dy(contact.bond) + cut.a.uy[j] - cut.a.uy[i];
      const double turning = dx * at.force[1] - dy * at.force[0] + at.force[2] + at.force[3];
      EXPECT_NEAR(turning, 0.0, 1e-12 * cut.o.contact_normal_stiffness);
    }
  }
}

CaseDefinition cut_case(JointState state, SolverKind solver, double degrees, double friction) {
  CaseDefinition definition = cracking_case();
  Options& o = definition.options;
  o.packing_disc_count = 400;
  o.stress_convention = choice(StressConvention::total);
  o.boundary_kind = choice(BoundaryKind::stress);
  o.flow_scheme = choice(FlowScheme::off);
  o.contact_mode = choice(ContactMode::after_break);
  o.stress_sigma_Hmax = 30e6;
  o.stress_sigma_hmin = 10e6;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.solver_kind = choice(solver);
  o.stepping_force_ratio = 1e-5;
  o.stepping_max_cycles = 40000;
  definition.wells.clear();
  definition.joints = {joint_at(degrees, 25.0, {50.0, 50.0}, friction, state)};
  return definition;
}

// On either side of a joint that slides the rock keeps its neighbours, and across it contacts of the joint bear everything: no disc is to be
// looked at for others, though all bonds that the joint crosses are broken. Where a bond of the rock breaks beside it some are.
TEST(SmoothJoint, LeavesTheRockBesideItWhole) {
  for (const SolverKind kind : {SolverKind::explicit_solver, SolverKind::quasi_static}) {
    CaseDefinition definition = cut_case(JointState::smooth_broken, kind, 45.0, 0.2);
    definition.options.stress_sigma_Hmax = 14e6;
    Simulation s(definition, {}, {});
    set_far_field(s, 30e6, 10e6);
    s.step();
    EXPECT_GT(s.cracks().size(), 10U);
    EXPECT_TRUE(s.model().contact_pairs.cracked.empty());
    EXPECT_TRUE(s.model().contact_pairs.pairs.empty());
    Engine& e = s.engine();
    const SmoothContact& contact = s.assembly().smooth.contacts[8];
    const auto disc = s.assembly().first[contact.bond];
    std::int64_t beside = -1;
    for (std::int64_t b = 0; b < s.assembly().bond_count(); ++b)
      if ((s.assembly().first[b] == disc || s.assembly().second[b] == disc) &&
          s.assembly().smooth.of(b) == nullptr)
        beside = b;
    e.mechanics->break_bond(beside, e.model.cracks);
    e.mechanics->search_contacts(e.model.cracks);
    EXPECT_EQ(s.model().contact_pairs.cracked.size(), 2U);
  }
}

double largest_slide(const Simulation& s) {
  double slide = 0.0;
  farthest_slide(s.assembly(), slide);
  return slide;
}

TEST(SmoothJoint, BothSolversFindTheSameRestAndTheBalanceCloses) {
  double slid[2];
  for (const SolverKind kind : {SolverKind::explicit_solver, SolverKind::quasi_static}) {
    CaseDefinition definition = cut_case(JointState::smooth_broken, kind, 45.0, 0.2);
    definition.options.stress_sigma_Hmax = 14e6;
    Simulation s(definition, {}, {});
    set_far_field(s, 30e6, 10e6);
    s.step();
    EXPECT_TRUE(s.model().clock.at_rest);
    slid[static_cast<int>(kind)] = largest_slide(s);
    const Balance b = s.balance();
    EXPECT_GT(b.friction, 0.0);
    EXPECT_EQ(b.energy_checked, kind == SolverKind::explicit_solver);
    if (b.energy_checked) {
      EXPECT_LE(std::abs(b.energy_error), 2e-3 * std::abs(b.boundary_work));
    }
    double moved = 0.0;  // friction never exceeds its coefficient
    for (const auto& contact : s.assembly().smooth.contacts) {
      const BondView view = view_bond(s.assembly(), s.options(), contact.bond);
      EXPECT_LE(std::abs(view.contact_shear), 0.2 * view.contact_normal * (1.0 + 1e-12));
      moved = std::max(moved, std::abs(s.assembly().slip[contact.bond]));
    }
    EXPECT_GT(moved, 1e-3);
  }
  EXPECT_NEAR(slid[0], slid[1], 0.06 * slid[1]);  // friction remembers the way, and motion overshoots
}

// No discs beside a joint are looked at between cycles, so that several are taken in one pass (temporal_blocking.hpp).
TEST(SmoothJoint, SlidesAlikeInPassesOfSeveralCycles) {
  CaseDefinition definition = cut_case(JointState::smooth_broken, SolverKind::explicit_solver, 45.0, 0.2);
  definition.options.packing_disc_count = 4000;
  definition.options.stepping_force_ratio = 1e-2;
  definition.options.stepping_max_cycles = 2000;
  definition.options.stress_sigma_Hmax = 14e6;
  std::uint64_t hash = 0;
  for (const BlockingShape& shape :
       {BlockingShape{1, 1, 1}, BlockingShape{4, 2, 1}, BlockingShape{8, 2, 2}}) {
    definition.options.run_workers = shape.front;
    Simulation s(definition, {}, {});
    s.engine().mechanics->set_blocking(shape);
    set_far_field(s, 30e6, 10e6);
    s.step();
    EXPECT_TRUE(s.model().contact_pairs.pairs.empty());
    EXPECT_GT(largest_slide(s), 1e-4);
    if (shape.cycles == 1) hash = s.state_hash();
    EXPECT_EQ(s.state_hash(), hash) << shape.cycles;
  }
}

// Contacts as the kernels answer them against the law in scalars, with a largest closure and without: open, sticking, sliding, holding.
TEST(SmoothJoint, KernelsAnswerAsTheLawDoesOnEveryInstructionSet) {
  for (const JointState state : {JointState::smooth_broken, JointState::smooth_bonded}) {
    int open = 0, slides = 0, sticks = 0;
    for (const double most : {0.0, 2e-3}) {
      CaseDefinition definition = cut_case(state, SolverKind::explicit_solver, 30.0, 0.8);
      definition.options.packing_disc_count = 1500;  // several tiles
      definition.joints[0].max_closure = most;
      definition.joints[0].normal_stiffness = definition.joints[0].shear_stiffness = 1e10;
      Simulation s(definition, {}, {});
      Assembly& a = s.engine().model.assembly;
      Random random(7);
      for (const auto& c : a.smooth.contacts) {
        for (const auto d : {a.first[c.bond], a.second[c.bond]}) {
          a.ux[d] += 4e-3 * (random.uniform() - 0.5);
          a.uy[d] += 4e-3 * (random.uniform() - 0.5);
          a.rotation[d] += 1e-4 * (random.uniform() - 0.5);
        }
      }
      const KernelArrays& arrays = s.engine().mechanics->arrays();
      std::vector<BondForce> first(static_cast<std::size_t>(a.bond_count())), forces(first.size());
      kernels_for("baseline")->bond_forces(arrays, first.data());
      for (const char* isa : {"avx2", "avx512"}) {
        if (kernels_for(isa) == nullptr) continue;
        kernels_for(isa)->bond_forces(arrays, forces.data());
        EXPECT_EQ(std::memcmp(first.data(), forces.data(), sizeof(BondForce) * first.size()), 0) << isa;
      }
      for (const auto& c : a.smooth.contacts) {
        double slip = a.slip[c.bond], friction = 0.0;
        const SmoothForces by_law = answer_of(a, c, slip, friction);
        const SmoothForces& found = first[static_cast<std::size_t>(c.bond)];
        const double size = 1e-9 * (1e4 + std::abs(by_law.fx) + std::abs(by_law.fy));
        EXPECT_NEAR(found.fx, by_law.fx, size);
        EXPECT_NEAR(found.fy, by_law.fy, size);
        EXPECT_NEAR(found.moment_i, by_law.moment_i, size * a.mean_radius);
        EXPECT_NEAR(found.moment_j, by_law.moment_j, size * a.mean_radius);
        const double opening = smooth_opening(a, c);
        ++(opening >= 0.0 ? open : (slip != a.slip[c.bond] ? slides : sticks));
      }
      EXPECT_GT(arrays.tile_count, 2);
    }
    EXPECT_GT(open, 3);
    EXPECT_GT(sticks, 3);
    EXPECT_EQ(slides > 3, state == JointState::smooth_broken)
        << open << " open, " << slides << " slide, " << sticks << " stick";
  }
}

TEST(SmoothJoint, IsSmoothWhereTheOldOneIsRough) {
  double slid[2];
  for (const JointState state : {JointState::broken, JointState::smooth_broken}) {
    const Simulation s(cut_case(state, SolverKind::quasi_static, 45.0, 0.0), {}, {});
    const auto& a = s.assembly();
    double sum = 0.0, count = 0.0;
    for (std::int64_t e = 0; e < a.bond_count(); ++e) {
      if (a.joints.joint_of(e) < 0) continue;
      const Vec2 n = a.joint_normal(e);
      const auto i = a.first[e], j = a.second[e];
      sum += std::abs(cross(n, {a.ux[j] - a.ux[i], a.uy[j] - a.uy[i]}));
      count += 1.0;
    }
    slid[state == JointState::broken ? 0 : 1] = sum / count;
  }
  EXPECT_GT(slid[1], 2.0 * slid[0]);
}

TEST(SmoothJoint, GoesOnAfterARestoreBitForBitOnAnyNumberOfWorkers) {
  for (const SolverKind kind : {SolverKind::explicit_solver, SolverKind::quasi_static}) {
    CaseDefinition definition = cut_case(JointState::smooth_bonded, kind, 30.0, 0.3);
    definition.options.bond_tensile_strength = definition.options.bond_shear_strength = 40e6;
    definition.joints[0].tensile_factor = definition.joints[0].shear_factor = 0.1;
    definition.options.stress_sigma_Hmax = 14e6;
    Simulation s(definition, {}, {});
    const std::size_t before = s.cracks().size();
    EXPECT_LT(before, s.assembly().smooth.contacts.size());
    set_far_field(s, 28e6, 10e6);
    s.step();
    EXPECT_GT(s.cracks().size(), before);
    std::vector<std::byte> image(s.image_size());
    s.write_image(image);
    definition.options.run_workers = 3;
    Simulation other(definition, {}, {});
    other.restore(image);
    for (Simulation* each : {&s, &other}) {
      set_far_field(*each, 32e6, 10e6);
      each->step();
    }
    EXPECT_EQ(s.state_hash(), other.state_hash());
    EXPECT_EQ(s.cracks().size(), other.cracks().size());
    for (const auto& crack : s.cracks()) EXPECT_EQ(s.assembly().intact[crack.bond], 0);
    definition.joints[0].friction = 0.4;
    Simulation unlike(definition, {}, {});
    EXPECT_THROW(unlike.restore(image), Error);
  }
}

// In motion, joints and non-bonded contacts push their discs on top of the boundary's load: what is restored is that very state.
TEST(SmoothJoint, WhatPushesItsDiscsIsRestoredWithThem) {
  CaseDefinition definition = cut_case(JointState::smooth_broken, SolverKind::explicit_solver, 30.0, 0.3);
  definition.options.stress_sigma_Hmax = 14e6;
  definition.options.stepping_mode = choice(SteppingMode::dynamic);
  definition.options.stepping_flow_step = 1e-3;
  Simulation s(definition, {}, {});
  set_far_field(s, 28e6, 10e6);
  s.step();
  std::vector<std::byte> image(s.image_size());
  s.write_image(image);
  const auto saved = s.state_hash();
  Simulation other(definition, {}, {});
  other.restore(image);
  EXPECT_EQ(other.state_hash(), saved);
  int asked = 0;  // a step that is interrupted is undone the same way
  ASSERT_TRUE(s.step([&] { return ++asked >= 1; }).stopped);
  EXPECT_EQ(s.state_hash(), saved);
  for (Simulation* each : {&s, &other}) each->step();
  EXPECT_EQ(other.state_hash(), s.state_hash());
}

TEST(SmoothJoint, SlidingPastItsPairsIsRefusedInWords) {
  CaseDefinition definition = cut_case(JointState::smooth_broken, SolverKind::explicit_solver, 45.0, 0.1);
  definition.joints[0] = joint_at(45.0, 90.0, {50.0, 50.0}, 0.1, JointState::smooth_broken);  // right through
  definition.options.stress_sigma_Hmax = 10e6;
  Simulation s(definition, {}, {});
  set_far_field(s, 30e6, 10e6);
  const auto before = s.state_hash();
  try {
    s.step();
    FAIL() << "slid by " << largest_slide(s);
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("joint[0] slid by"), std::string::npos) << text;
    EXPECT_NE(text.find("mean disc radius"), std::string::npos) << text;
  }
  EXPECT_EQ(s.state_hash(), before);
}

// Fluid in a smooth joint that opens it across its own line, obliquely to the contacts: 40 000 s in `steps`.
CaseDefinition fluid_case(SolverKind solver, SteppingMode mode, int steps) {
  CaseDefinition definition = cut_case(JointState::smooth_broken, solver, 30.0, 0.5);
  Options& o = definition.options;
  o.stepping_mode = choice(mode);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.fluid_formation_pressure = 5e6;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 10e6;
  o.flow_permeability = 1e-12;
  o.stepping_flow_step = 4e4 / steps;
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = 8.0;
  well.pressure = 20e6;
  definition.wells = {well};
  return definition;
}

// After all steps, with what must hold whichever way it came about.
double widest_after(const CaseDefinition& definition, int steps) {
  Simulation s(definition, {}, {});
  for (int k = 0; k < steps; ++k) s.step();
  double widest = 0.0, open = 0.0;
  for (const auto& contact : s.assembly().smooth.contacts) {
    const double opening = joint_opening(s.assembly(), contact.bond);
    widest = std::max(widest, opening);
    if (opening <= 0.0) continue;
    open += 1.0;
    EXPECT_NEAR(s.network().aperture[contact.bond],
                std::min(s.network().zero_stress_aperture + opening, s.options().flow_aperture_limit), 1e-12);
  }
  EXPECT_GT(open, 4.0);
  EXPECT_LE(std::abs(s.balance().fluid_error), 1e-12 * std::abs(s.balance().injected));
  return widest;
}

TEST(SmoothJoint, FluidOpensItAlikeInBothSolvers) {
  const auto after_four = [](SolverKind solver) {
    return widest_after(fluid_case(solver, SteppingMode::substep, 4), 4);
  };
  const double direct = after_four(SolverKind::quasi_static);
  EXPECT_NEAR(after_four(SolverKind::explicit_solver), direct, 0.02 * direct);
}

// From rest to rest the fluid flows through the apertures of the rest before, so the joint opens late by the length of a step.
// Solved together, fluid and rock are at once where ever shorter steps lead.
TEST(SmoothJoint, FluidAndRockTogetherComeWhereShortStepsFromRestToRestLead) {
  const double together = widest_after(fluid_case(SolverKind::quasi_static, SteppingMode::coupled, 4), 4);
  double off[3];
  for (int k = 0; k < 3; ++k) {
    const int steps = k == 0 ? 4 : (k == 1 ? 40 : 400);
    off[k] =
        together - widest_after(fluid_case(SolverKind::quasi_static, SteppingMode::substep, steps), steps);
  }
  EXPECT_GT(off[0], 0.5 * together);
  EXPECT_LT(std::abs(off[1]), 0.2 * off[0]);
  EXPECT_LT(std::abs(off[2]), 0.01 * together);
}

}  // namespace smooth_joint_test
