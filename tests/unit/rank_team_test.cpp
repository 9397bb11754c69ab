// SPDX-License-Identifier: BSD-3-Clause
// Linear equations that ranks solve together: the bits of one rank alone, whatever the number of ranks and workers, and no rank that
// waits for one that has gone. Ranks are threads here.
#include <gtest/gtest.h>

#include <atomic>
#include <utility>
#include <vector>

#include "../rank_threads.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "linear/conjugate_gradient.hpp"
#include "linear/krylov.hpp"
#include "pore_grid.hpp"

namespace rank_team_test {
using namespace hfrac;
using rank_threads::Meeting;

constexpr PassRules rules{1e-6, 1e-11, 20, 2000};

Ranks ranks_of(Meeting& meeting, int rank, int size) {
  Exchange table;
  table.size = size;
  meeting.fill<Message>(table, rank);
  return Ranks(table);
}

Eigen::VectorXd random_vector(Eigen::Index size, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd x(size);
  for (auto& value : x) value = random.uniform() - 0.5;
  return x;
}

// Two matrices of one pattern, one after the other, one of another, and one of cracks that are a level as they are; the second from the solution of the first.
std::vector<Eigen::VectorXd> solutions(const std::vector<SparseMatrix>& matrices, Workers& workers,
                                       const Ranks& ranks) {
  ConjugateGradient solver(&workers, nullptr, ranks);
  std::vector<Eigen::VectorXd> found;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(matrices[0].cols());
  for (const auto& lower : matrices) {
    EXPECT_TRUE(solver.prepare(lower));
    EXPECT_TRUE(solver.settle(random_vector(x.size(), 5), x, rules));
    found.push_back(x);
    Eigen::VectorXd once = Eigen::VectorXd::Zero(x.size());
    EXPECT_GT(solver.solve(random_vector(x.size(), 7), once, 1e-9, 500), 0);
    found.push_back(once);
  }
  return found;
}

TEST(RankTeam, SolvesFlowWithTheBitsOfOneRank) {
  // Of some numbers of ranks none, one and two levels are shared.
  const std::vector<std::pair<int, std::vector<int>>> cases{{100, {2, 3}}, {160, {2, 3, 5}}, {300, {3}}};
  for (const auto& [side, sizes] : cases) {
    const std::vector<SparseMatrix> matrices{grid(side, 1e-3, 1e6, 1), grid(side, 1.0, 1e2, 2),
                                             with_a_shortcut(grid(side, 1e-2, 1e4, 3)),
                                             crossing_cracks(side, 1e-10, 4)};
    Workers one(1);
    const auto alone = solutions(matrices, one, {});
    for (const int size : sizes) {
      Meeting meeting(size);
      meeting.run([&, ranks = size, columns = side](std::int32_t rank) {
        Workers workers(1 + rank % 2);
        const auto found = solutions(matrices, workers, ranks_of(meeting, rank, ranks));
        for (std::size_t k = 0; k < alone.size(); ++k)
          EXPECT_TRUE((found[k].array() == alone[k].array()).all())
              << "rank " << rank << " of " << ranks << ", side " << columns << ", solution " << k;
      });
    }
  }
}

// Preconditioned by the diagonal in single precision, so that many vectors are kept, and in single precision they are the same.
TEST(RankTeam, SolvesByGmresWithTheBitsOfOneRank) {
  const SparseMatrix lower = grid(150, 1.0, 1e2);
  const Eigen::VectorXd diagonal = lower.diagonal(), right = random_vector(lower.cols(), 11);
  const auto solve = [&](Workers& workers, const Ranks& ranks) {
    Eigen::VectorXd found[2];
    Krylov krylov(workers, ranks);
    for (const auto digits : {Krylov::Digits::of_double, Krylov::Digits::of_single}) {
      Eigen::VectorXd& x = found[digits == Krylov::Digits::of_single];
      const auto outcome =
          krylov.solve([&](const auto& in, auto& out) { symmetric_product(lower, in, out); },
                       [&](const auto& in, auto& out) {
                         out = in.cwiseQuotient(diagonal).template cast<float>().template cast<double>();
                       },
                       right, 1e-4, 120, x, digits);
      EXPECT_TRUE(outcome.converged);
      EXPECT_GT(outcome.iterations, 10);
      krylov.forget();
    }
    EXPECT_TRUE((found[0].array() == found[1].array()).all());
    return found[0];
  };
  Workers one(1);
  const Eigen::VectorXd alone = solve(one, {});
  for (const int size : {2, 7, 16}) {  // of 11 chunks, so that some ranks have none
    Meeting meeting(size);
    meeting.run([&](std::int32_t rank) {
      Workers workers(1 + rank % 3);
      const Eigen::VectorXd x = solve(workers, ranks_of(meeting, rank, size));
      EXPECT_TRUE((x.array() == alone.array()).all()) << "rank " << rank << " of " << size;
    });
  }
}

TEST(RankTeam, EndsWhereARankHasFailed) {
  const SparseMatrix lower = grid(130, 1e-3, 1e6);
  constexpr int size = 3;
  for (const int workers_of_each : {1, 2}) {
    Meeting meeting(size);
    std::atomic<int> told{0};
    meeting.run([&](std::int32_t rank) {
      const Ranks ranks = ranks_of(meeting, rank, size);
      if (rank == 1) return ranks.fail("its memory is full");
      Workers workers(workers_of_each);
      ConjugateGradient solver(&workers, nullptr, ranks);
      EXPECT_TRUE(solver.prepare(lower));
      Eigen::VectorXd x = Eigen::VectorXd::Zero(lower.cols());
      try {
        static_cast<void>(solver.settle(random_vector(x.size(), 5), x, rules));
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::exchange);
        EXPECT_NE(std::string(error.what()).find("rank 1 has failed: its memory is full"), std::string::npos);
        ++told;
      }
    });
    EXPECT_EQ(told, size - 1);
  }
}

// Whose part a row is by arithmetic is whose part it is by the list of parts.
TEST(Ranks, KnowWhoseARowIs) {
  for (const int size : {1, 2, 3, 5, 8, 13}) {
    Exchange table;
    table.size = size;
    const Ranks ranks(table);
    for (const std::int64_t n : {1, 7, 64, 100, 1031}) {
      for (const std::int64_t grain : {1, 3, 64}) {
        std::int64_t all = 0;
        for (int rank = 0; rank < size; ++rank) {
          const auto part = ranks.part(rank, n, grain);
          EXPECT_EQ(part.first, all);
          for (auto i = part.first; i < part.end; ++i) EXPECT_EQ(ranks.owner(i, n, grain), rank);
          all = part.end;
        }
        EXPECT_EQ(all, n);
      }
    }
  }
}

}  // namespace rank_team_test
