// SPDX-License-Identifier: BSD-3-Clause
// Facets after breakage: what is done near the broken bonds alone leaves, bit for bit, what a look at all bonds does.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <vector>

#include "core/random.hpp"
#include "frac/facets.hpp"
#include "small_case.hpp"
#include "step/simulation.hpp"

namespace facets_update_test {

using namespace testing_unit;

struct Side {
  explicit Side(const Simulation& s) : network(s.network()) {
    facets.begin(s.assembly(), network, s.engine().model.well_places(), s.options());
  }
  Network network;
  Facets facets;
};

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(Vec2 a, Vec2 b) {
  return same(a.x, b.x) && same(a.y, b.y);
}
bool same(const Facet& f, const Facet& g) {
  return f.bond == g.bond && f.left == g.left && f.right == g.right && same(f.normal, g.normal) &&
         same(f.length, g.length) && same(f.way, g.way) && same(f.left_length, g.left_length) &&
         same(f.right_length, g.right_length) && same(f.initial_normal, g.initial_normal) &&
         same(f.initial_shear, g.initial_shear) && same(f.locked, g.locked) &&
         same(f.locked_first, g.locked_first) && same(f.locked_second, g.locked_second) &&
         same(f.middle, g.middle) && f.slot == g.slot &&
         std::equal(std::begin(f.corner), std::end(f.corner), std::begin(g.corner));
}

void expect_same(const Side& p, const Side& q, const Assembly& a) {
  ASSERT_EQ(p.facets.all().size(), q.facets.all().size());
  for (std::size_t k = 0; k < p.facets.all().size(); ++k)
    ASSERT_TRUE(same(p.facets.all()[k], q.facets.all()[k])) << "facet " << k;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    ASSERT_EQ(p.facets.of(e), q.facets.of(e)) << "bond " << e;
    ASSERT_TRUE(same(p.facets.locked_of(e), q.facets.locked_of(e))) << "bond " << e;
    ASSERT_TRUE(same(p.network.facet_opening[e], q.network.facet_opening[e])) << "bond " << e;
  }
  for (std::int64_t d = 0; d < p.network.domain_count(); ++d) {
    ASSERT_EQ(p.facets.fractured(d), q.facets.fractured(d)) << "domain " << d;
    ASSERT_TRUE(same(p.network.facet_offset[d], q.network.facet_offset[d])) << "domain " << d;
  }
  for (std::size_t k = 0; k < p.network.corner_weight.size(); ++k)
    ASSERT_TRUE(same(p.network.corner_weight[k], q.network.corner_weight[k])) << "weight " << k;
}

// A bond to break next: one beside what is broken in two of three cases, so that fractures grow, branch and meet.
std::int64_t choose(Random& random, const Side& of, const Assembly& a) {
  const auto any = [&](std::size_t count) { return random.below(count); };
  if (!of.facets.all().empty() && random.uniform() < 0.67) {
    const Facet& f = of.facets.all()[any(of.facets.all().size())];
    const auto& bonds = of.facets.bonds_of(random.uniform() < 0.5 ? f.left : f.right);
    return bonds[any(bonds.size())];
  }
  return static_cast<std::int64_t>(any(static_cast<std::size_t>(a.bond_count())));
}

TEST(FacetsUpdate, NearBrokenBondsAloneIsTheWholeBitForBit) {
  int most = 0;
  for (int seed = 1; seed <= 3; ++seed) {
    CaseDefinition definition = quiet_case();
    Options& o = definition.options;
    o.model_seed = seed;
    o.stress_sigma_Hmax = 35e6;
    if (seed == 3) {  // a joint that conducts
      JointOptions joint;
      joint.x1 = 15.0;
      joint.y1 = 25.0;
      joint.x2 = 85.0;
      joint.y2 = 35.0;
      joint.state = choice(JointState::smooth_broken);
      joint.aperture = 1e-3;
      definition.joints.push_back(joint);
    }
    const Simulation s(definition, {}, {});
    Assembly a = s.assembly();
    Side near(s), whole(s);
    Random random(static_cast<std::uint64_t>(100 + seed));
    std::vector<std::vector<std::int64_t>> rounds;  // what broke in each
    for (int round = 0; round < 120; ++round) {
      for (std::int64_t i = 0; i < a.disc_count(); ++i) {
        a.ux[i] += 1e-4 * (random.uniform() - 0.5);
        a.uy[i] += 1e-4 * (random.uniform() - 0.5);
      }
      if (round % 40 == 39) {
        // Back to a state before, in which fewer bonds are broken.
        for (std::size_t r = rounds.size() / 2; r < rounds.size(); ++r)
          for (const auto e : rounds[r]) a.intact[e] = 1;
        rounds.resize(rounds.size() / 2);
        for (Side* side : {&near, &whole}) side->facets.update(a, side->network, true);
      } else {
        std::vector<std::int64_t> broken;
        for (int k = 1 + static_cast<int>(3.0 * random.uniform()); k > 0; --k) {
          const auto e = choose(random, near, a);
          if (a.intact[e] == 0 || a.smooth.of(e) != nullptr) continue;
          a.intact[e] = 0;
          broken.push_back(e);
        }
        near.facets.add(a, near.network, broken);
        whole.facets.update(a, whole.network);
        rounds.push_back(broken);
      }
      expect_same(near, whole, a);
      if (HasFatalFailure()) {
        ADD_FAILURE() << "seed " << seed << ", round " << round;
        return;
      }
      most = std::max(most, static_cast<int>(near.facets.all().size()));
    }
  }
  EXPECT_GT(most, 60);
}

}  // namespace facets_update_test
