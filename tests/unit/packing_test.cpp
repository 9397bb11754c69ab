// SPDX-License-Identifier: BSD-3-Clause
// The packing: fills what it is asked to fill, at rest, inside the box, the same for the same seed.
#include "geom/packing.hpp"

#include "core/workers.hpp"
#include "geom/relaxation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../thread_sanitizer.hpp"
#include "model.hpp"

namespace packing_test {

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

TEST(Packing, IsTheSameOnAnyNumberOfWorkers) {
  PackingOptions asked;
  asked.count = 5000;
  asked.brick = 1000;
  asked.residual = 3e-2;
  for (const auto method : {PackingMethod::relaxed, PackingMethod::tiled, PackingMethod::growth}) {
    asked.method = method;
    const Packing alone = pack_discs(asked);
    for (const int count : thread_sanitizer::numbers({1, 2, 5}, {3})) {
      Workers workers(count);
      const Packing p = pack_discs(asked, {}, &workers);
      EXPECT_TRUE(same_bits(p.x, alone.x) && same_bits(p.y, alone.y) && same_bits(p.radius, alone.radius))
          << count << " workers, method " << static_cast<int>(method);
      EXPECT_EQ(p.residual, alone.residual);
      EXPECT_EQ(p.mean_overlap, alone.mean_overlap);
    }
  }
}

TEST(Packing, StopsOnAnyWorker) {
  PackingOptions asked;
  asked.count = 6000;
  asked.brick = 1000;
  asked.method = PackingMethod::tiled;
  for (const double when : {0.02, 0.2, 0.55}) {
    Workers workers(3);
    double last = 0.0;
    (void)pack_discs(
        asked,
        [&](double done) {
          last = done;
          return done >= when;
        },
        &workers);
    EXPECT_GE(last, when);
    EXPECT_LT(last, when + 0.5);
  }
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

double coordination_of(const Packing& p) {
  const ContactGraph graph = build_contact_graph(p.x, p.y, p.radius, {}, 0.05);
  return 2.0 * static_cast<double>(graph.first.size()) / static_cast<double>(graph.x.size());
}

// Tiled and grown packings against relaxed ones: as full, as well connected, as little overlap left, inside the box.
TEST(Packing, IsAsDenseAndConnectedHoweverItIsMade) {
  PackingOptions asked;
  asked.count = 4000;
  asked.brick = 1000;
  const Packing reference = pack_discs(asked);
  for (const auto method : {PackingMethod::tiled, PackingMethod::growth}) {
    asked.method = method;
    const Packing p = pack_discs(asked);
    double solid = 0.0;
    for (const double r : p.radius) solid += pi * r * r;
    EXPECT_NEAR(1.0 - solid / (asked.width * asked.height), asked.porosity, 1e-12);
    EXPECT_NEAR(static_cast<double>(p.x.size()), 4000.0, 8.0);
    EXPECT_NEAR(p.mean_radius / reference.mean_radius, 1.0, 0.005);
    EXPECT_NEAR(coordination_of(p) / coordination_of(reference), 1.0, 0.015);
    EXPECT_LT(p.mean_overlap, 1.5 * reference.mean_overlap) << static_cast<int>(method);
    const double give = 20.0 * p.mean_overlap * p.mean_radius;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      EXPECT_GT(std::min(p.x[i], p.y[i]) - p.radius[i], -give);
      EXPECT_LT(std::max(p.x[i], p.y[i]) + p.radius[i], asked.width + give);
    }
    const Packing again = pack_discs(asked);
    EXPECT_TRUE(same_bits(p.x, again.x));
    EXPECT_TRUE(same_bits(p.radius, again.radius));
  }
}

TEST(Packing, BricksAreNotCopiesOfEachOther) {
  PackingOptions asked;
  asked.count = 4000;
  asked.brick = 1000;
  asked.method = PackingMethod::tiled;
  const Packing p = pack_discs(asked);
  // Discs of a quarter that have a twin, equal in size and place, in the quarter beside it.
  std::size_t twins = 0, quarter = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    if (p.x[i] > 50.0 || p.y[i] > 50.0) continue;
    ++quarter;
    for (std::size_t j = 0; j < p.x.size(); ++j) {
      twins += p.radius[j] == p.radius[i] &&
                       std::hypot(p.x[j] - p.x[i] - 50.0, p.y[j] - p.y[i]) < 0.5 * p.mean_radius
                   ? 1
                   : 0;
    }
  }
  EXPECT_GT(quarter, 900u);
  EXPECT_LT(static_cast<double>(twins), 0.5 * static_cast<double>(quarter));
}

TEST(Relaxation, JoinsOppositeSidesOfAPeriodicBox) {
  // Two discs that overlap across the side of the box only.
  const Array<double> radius{1.0, 1.0};
  Array<double> x{0.2, 9.0}, y{5.0, 5.0};
  const auto report = relax_overlaps({10.0, 10.0, true}, radius, x, y, {}, 1e-8, 1000);
  EXPECT_TRUE(report.at_rest);
  const double around = std::abs(x[1] - x[0]);
  EXPECT_GT(std::min(around, 10.0 - around), 2.0 - 1e-5);
  EXPECT_NEAR(0.5 * (x[0] + x[1]), 4.6, 1e-12);  // the pair's middle stays
  // One of them held: the other makes all the way.
  x = {0.2, 9.0};
  relax_overlaps({10.0, 10.0, true}, radius, x, y, {1, 0}, 1e-8, 1000);
  EXPECT_EQ(x[0], 0.2);
  EXPECT_LT(x[1], 8.2 + 1e-5);
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

// Rows and columns that touch, in the middle of a box that holds no whole number of rows.
TEST(Packing, SquareIsAGridOfEqualDiscs) {
  PackingOptions asked;
  asked.width = 10.0;
  asked.height = 9.0;
  asked.count = 90;
  asked.method = PackingMethod::square;
  const Packing p = pack_discs(asked);
  ASSERT_EQ(p.x.size(), 90U);
  EXPECT_DOUBLE_EQ(p.mean_radius, 0.5);
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    EXPECT_EQ(p.radius[i], 0.5);
    EXPECT_NEAR(p.x[i] - 0.5, std::round(p.x[i] - 0.5), 1e-12);
    EXPECT_NEAR(p.y[i] - 0.5, std::round(p.y[i] - 0.5), 1e-12);
  }
  asked.height = 9.6;
  const Packing loose = pack_discs(asked);
  const auto [low, high] = std::minmax_element(loose.y.begin(), loose.y.end());
  EXPECT_NEAR(*low + *high, 9.6, 1e-12);
  EXPECT_GE(*low, 0.5);
}

}  // namespace packing_test
