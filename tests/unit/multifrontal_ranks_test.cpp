// SPDX-License-Identifier: BSD-3-Clause
// A factor that ranks share, each with its part of it: the bits of one rank alone, and no rank that waits for one that has gone. Ranks are
// threads here.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../rank_threads.hpp"
#include "core/error.hpp"
#include "grid_matrix.hpp"
#include "linear/front_tree.hpp"
#include "linear/multifrontal.hpp"

namespace multifrontal_ranks_test {
using namespace hfrac;
using grid_matrix::GridMatrix;
using rank_threads::Meeting;

FrontTree tree_of(const GridMatrix& m, int rank = 0, int ranks = 1) {
  FrontTree tree;
  tree.analyse(m.node_start, m.position, m.graph, std::vector<char>(m.position.size(), 0), m.each_place(),
               rank, ranks);
  return tree;
}

// The entries that a rank has of all.
template <class Real>
std::vector<Real> own_values(const FrontTree& tree, const GridMatrix& m) {
  std::vector<Real> values;
  for (std::size_t k = 0; k < tree.wanted.size(); ++k)
    if (tree.wanted[k]) values.push_back(static_cast<Real>(m.values[k]));
  return values;
}

Ranks ranks_of(Meeting& meeting, int rank, int size) {
  Exchange table;
  table.size = size;
  meeting.fill<Message>(table, rank);
  return Ranks(table);
}

template <class Real>
void expect_the_bits_of_one(std::int32_t across) {
  const GridMatrix square(across);
  const FrontTree whole = tree_of(square);
  ASSERT_TRUE(whole.worth_sharing());
  Workers alone(1);
  Multifrontal<Real> factor;
  factor.factorise(whole, std::vector<Real>(square.values.begin(), square.values.end()), alone);
  std::vector<double> wanted = square.right;
  factor.solve(whole, wanted.data(), alone);
  std::vector<double> rest = square.right;
  for (std::size_t k = 0; k < square.places.size(); ++k)
    rest[static_cast<std::size_t>(square.places[k].row)] -=
        square.values[k] * wanted[static_cast<std::size_t>(square.places[k].column)];
  for (const double left : rest) ASSERT_LT(std::abs(left), 1e-4);
  for (const int size : {2, 3, 4, 7}) {
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(size));
    Meeting meeting(size);
    meeting.run([&](std::int32_t rank) {
      Workers workers(rank % 2 + 1);
      const Ranks ranks = ranks_of(meeting, rank, size);
      const FrontTree tree = tree_of(square, rank, size);
      const auto values = own_values<Real>(tree, square);
      numbers[static_cast<std::size_t>(rank)] = tree.columns + tree.rows;
      Multifrontal<Real> of_ranks;
      for (int twice = 0; twice < 2; ++twice) of_ranks.factorise(tree, values, workers, ranks);
      std::vector<double> x = square.right;
      of_ranks.solve(tree, x.data(), workers, ranks);
      EXPECT_EQ(x, wanted) << "rank " << rank << " of " << size;
    });
    // Each number is on one rank, and none has much more than its share.
    std::int64_t all = 0;
    for (const auto of_rank : numbers) {
      all += of_rank;
      EXPECT_LT(static_cast<double>(of_rank), 1.3 * static_cast<double>(whole.columns + whole.rows) / size);
    }
    EXPECT_EQ(all, whole.columns + whole.rows);
  }
}

TEST(MultifrontalRanks, HaveTheBitsOfOneInSinglePrecision) {
  expect_the_bits_of_one<float>(70);
}

TEST(MultifrontalRanks, HaveTheBitsOfOneInDoublePrecision) {
  expect_the_bits_of_one<double>(50);
}

TEST(MultifrontalRanks, EndWhereOneHasFailed) {
  const GridMatrix square(60);
  constexpr int size = 3;
  Meeting meeting(size);
  meeting.run([&](std::int32_t rank) {
    Workers workers(2);
    const Ranks ranks = ranks_of(meeting, rank, size);
    const FrontTree tree = tree_of(square, rank, size);
    if (rank == 1) {
      ranks.fail("no memory");
      return;
    }
    Multifrontal<float> factor;
    try {
      factor.factorise(tree, own_values<float>(tree, square), workers, ranks);
      std::vector<double> x = square.right;
      factor.solve(tree, x.data(), workers, ranks);
      ADD_FAILURE() << "rank " << rank << " found a solution without the others";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::exchange);
    }
  });
}

}  // namespace multifrontal_ranks_test
