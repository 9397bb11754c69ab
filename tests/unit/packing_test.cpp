// SPDX-License-Identifier: BSD-3-Clause
// The packing: fills what it is asked to fill, at rest, inside the box, the same for the same seed.
#include "geom/packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model.hpp"

namespace {

using namespace testing_unit;

PackingOptions small_packing() {
  PackingOptions p;
  p.width = 30.0;
  p.height = 20.0;
  p.count = 600;
  return p;
}

TEST(Packing, HasThePorosityAndTheSizesAskedFor) {
  const PackingOptions asked = small_packing();
  const Packing p = pack_discs(asked);
  ASSERT_EQ(p.radius.size(), 600u);
  double solid = 0.0, radii = 0.0;
  for (const double r : p.radius) {
    solid += pi * r * r;
    radii += r;
  }
  EXPECT_NEAR(1.0 - solid / (asked.width * asked.height), asked.porosity, 1e-12);
  EXPECT_NEAR(p.mean_radius, radii / 600.0, 1e-12);
  const auto [least, most] = std::minmax_element(p.radius.begin(), p.radius.end());
  // Radii sit in the middle of 600 equal parts of the range.
  EXPECT_NEAR(*most / *least, 2.7, 0.006);
  EXPECT_LE(*most / *least, 2.7);
}

TEST(Packing, IsAtRestInsideTheBox) {
  PackingOptions asked = small_packing();
  for (const double residual : {1e-3, 1e-5}) {
    asked.residual = residual;
    const Packing p = pack_discs(asked);
    EXPECT_LE(p.residual, residual);
    EXPECT_GT(p.residual, 0.0);
    // Sides give way like discs do: by a few mean overlaps at most.
    const double give = 10.0 * p.mean_overlap * p.mean_radius;
    EXPECT_LT(p.mean_overlap, 0.03);
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      EXPECT_GT(p.x[i] - p.radius[i], -give);
      EXPECT_LT(p.x[i] + p.radius[i], asked.width + give);
      EXPECT_GT(p.y[i] - p.radius[i], -give);
      EXPECT_LT(p.y[i] + p.radius[i], asked.height + give);
    }
  }
}

TEST(Packing, DependsOnTheSeedAlone) {
  PackingOptions asked = small_packing();
  const Packing one = pack_discs(asked), again = pack_discs(asked);
  EXPECT_TRUE(same_bits(one.x, again.x));
  EXPECT_TRUE(same_bits(one.y, again.y));
  EXPECT_TRUE(same_bits(one.radius, again.radius));
  asked.seed = 2;
  const Packing other = pack_discs(asked);
  EXPECT_FALSE(same_bits(one.x, other.x));
  // Another arrangement of the same discs.
  Array<double> sizes = one.radius, other_sizes = other.radius;
  std::sort(sizes.begin(), sizes.end());
  std::sort(other_sizes.begin(), other_sizes.end());
  EXPECT_TRUE(same_bits(sizes, other_sizes));
}

TEST(Packing, HasTheCoordinationOfAJammedPacking) {
  Options o;
  o.packing_disc_count = 2000;
  for (std::int64_t seed = 1; seed <= 3; ++seed) {
    o.model_seed = seed;
    const Discs discs = packed(o);
    const ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, 0.05);
    const double coordination =
        2.0 * static_cast<double>(graph.first.size()) / static_cast<double>(graph.x.size());
    EXPECT_GT(coordination, 4.3) << "seed " << seed;
    EXPECT_LT(coordination, 4.5) << "seed " << seed;
  }
}

TEST(Packing, CanBeStopped) {
  double last = -1.0;
  int calls = 0;
  const Packing p = pack_discs(small_packing(), [&](double done) {
    EXPECT_GE(done, 0.0);
    EXPECT_LE(done, 1.0);
    last = done;
    return ++calls == 2;
  });
  EXPECT_EQ(calls, 2);
  EXPECT_GT(p.residual, 1e-4);
  EXPECT_GE(last, 0.0);
}

TEST(HilbertOrder, IsAPermutationThatKeepsNeighboursNear) {
  const Discs discs = square_lattice(16, 16, 0.5);
  const auto order = hilbert_order(discs.x, discs.y);
  std::vector<char> seen(256, 0);
  double way = 0.0;
  for (std::size_t k = 0; k < 256; ++k) {
    seen[static_cast<std::size_t>(order[k])] = 1;
    if (k > 0)
      way += std::hypot(discs.x[order[k]] - discs.x[order[k - 1]], discs.y[order[k]] - discs.y[order[k - 1]]);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 256);
  EXPECT_LT(way / 255.0, 1.1);  // a Hilbert curve steps from site to neighbouring site
}

}  // namespace
