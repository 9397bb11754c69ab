// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients preconditioned by multigrid: right whatever conducts how well, in iterations that hardly grow with the
// model, with the same bits on any number of workers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "core/random.hpp"
#include "linear/conjugate_gradient.hpp"
#include "linear/symmetric_factor.hpp"
#include "pore_grid.hpp"

namespace conjugate_gradient_test {
using namespace hfrac;

Eigen::VectorXd from(const SparseMatrix& lower, Eigen::Index row) {
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(lower.cols());
  rhs[row] = 1.0;
  return rhs;
}

Eigen::VectorXd from_the_middle(const SparseMatrix& lower) {
  return from(lower, lower.cols() / 2);
}

int solve(const SparseMatrix& lower, Eigen::VectorXd& x, Workers* workers = nullptr, Eigen::Index row = -1) {
  ConjugateGradient solver(workers);
  if (!solver.prepare(lower)) return -2;
  const Eigen::VectorXd rhs = row < 0 ? from_the_middle(lower) : from(lower, row);
  x = Eigen::VectorXd::Zero(lower.cols());
  return solver.solve(rhs, x, 1e-12, 1000);
}

TEST(ConjugateGradient, AgreesWithTheFactorWhateverIsStoredAndHoweverWellACrackConducts) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const double storage : {1e2, 1.0, 1e-3, 0.0}) {
      for (const double crack : {1.0, 1e4, 1e8}) {
        const auto lower = grid(90, storage, crack, seed);
        Eigen::VectorXd x;
        const int iterations = solve(lower, x);
        EXPECT_GE(iterations, 1) << storage << ' ' << crack << ' ' << seed;
        EXPECT_LE(iterations, 60) << storage << ' ' << crack << ' ' << seed;
        const SymmetricFactor factor(lower);
        const Eigen::VectorXd exact = factor.solve(from_the_middle(lower));
        EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff())
            << storage << ' ' << crack << ' ' << seed;
      }
    }
  }
}

// Rock at rest under one pressure [Pa]: differences are rounding, and so are changes.
TEST(ConjugateGradient, SettlesWhereAllPressuresAreAlike) {
  constexpr PassRules rules{1e-6, 1e-11, 20, 20000};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    for (const double storage : {1e2, 1.0, 1e-3}) {
      const auto lower = grid(90, storage, 1e4, seed);
      const Eigen::VectorXd alike = Eigen::VectorXd::Constant(lower.cols(), 25e6),
                            rhs = lower.selfadjointView<Eigen::Lower>() * alike;
      Eigen::VectorXd x = alike;
      ConjugateGradient solver;
      ASSERT_TRUE(solver.prepare(lower));
      EXPECT_TRUE(solver.settle(rhs, x, rules)) << storage << ' ' << seed;
      EXPECT_LE((x - alike).cwiseAbs().maxCoeff(), 1e-11 * 25e6) << storage << ' ' << seed;
    }
  }
}

// Where storage rules, the residual alone says how far off pressures are: one pass will do, and what it promises is so.
TEST(ConjugateGradient, KnowsByStorageThatOnePassWillDo) {
  constexpr PassRules one{1e-9, 1e-8, 1, 20000}, many{1e-9, 1e-8, 20, 20000};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    for (const double storage : {1e6, 1e3, 1e-3}) {
      const auto lower = grid(90, storage, 1.0, seed);
      const Eigen::VectorXd rhs = from_the_middle(lower), exact = SymmetricFactor(lower).solve(rhs);
      const double range = exact.maxCoeff() - exact.minCoeff();
      ConjugateGradient solver;
      ASSERT_TRUE(solver.prepare(lower));
      Eigen::VectorXd x = Eigen::VectorXd::Zero(lower.cols());
      EXPECT_EQ(solver.settle(rhs, x, one), storage >= 1e3) << storage << ' ' << seed;
      EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), (storage >= 1e3 ? one.settled : 1e-3) * range) << storage;
      EXPECT_TRUE(solver.settle(rhs, x, many)) << storage << ' ' << seed;
      EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), one.settled * range) << storage << ' ' << seed;
    }
  }
}

// Of a row that depends on others as much as on itself nothing is known.
TEST(ConjugateGradient, BoundsTheErrorOfEveryMatrixItBounds) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const double storage : {1e3, 1.0, 1e-3}) {
      const auto lower = grid(40, storage, 1e4, seed);
      Multigrid multigrid;
      ASSERT_TRUE(multigrid.prepare(lower));
      const Eigen::VectorXd rhs = from_the_middle(lower), exact = SymmetricFactor(lower).solve(rhs);
      const Eigen::VectorXd guess = exact + 1e-3 * exact.cwiseProduct(Eigen::VectorXd::Random(exact.size()));
      Eigen::VectorXd product;
      symmetric_product(lower, guess, product);
      const Eigen::VectorXd diagonal = Eigen::MatrixXd(lower).diagonal();
      const double length = (rhs - product).cwiseQuotient(diagonal.cwiseSqrt()).norm();
      EXPECT_GE(multigrid.error_bound().at(length, guess.cwiseAbs().maxCoeff()),
                (guess - exact).cwiseAbs().maxCoeff());
    }
  }
  ErrorBound none;
  none.take(1.0, 1.0);
  EXPECT_TRUE(std::isinf(none.at(1.0, 1.0)));
  EXPECT_EQ(none.length_for(1.0), 0.0);
}

// As many rows and entries, elsewhere: two pores joined over the model instead of side by side.
TEST(ConjugateGradient, NoticesAMatrixOfAnotherPattern) {
  const auto side_by_side = grid(30, 0.1, 1e4), across = with_a_shortcut(side_by_side);
  ASSERT_EQ(across.nonZeros(), side_by_side.nonZeros());
  ConjugateGradient solver, fresh;
  ASSERT_TRUE(solver.prepare(side_by_side) && solver.prepare(across) && fresh.prepare(across));
  Eigen::VectorXd rhs = from_the_middle(across), x = Eigen::VectorXd::Zero(across.cols()), y = x;
  ASSERT_GT(solver.solve(rhs, x, 1e-12, 1000), 0);
  ASSERT_GT(fresh.solve(rhs, y, 1e-12, 1000), 0);
  EXPECT_TRUE((x.array() == y.array()).all());
  const Eigen::VectorXd exact = SymmetricFactor(across).solve(rhs);
  EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff());
}

TEST(ConjugateGradient, NeedsHardlyMoreIterationsForAModelSixteenTimesAsLarge) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Eigen::VectorXd x;
    const int small = solve(grid(80, 0.0, 1e6, seed), x), large = solve(grid(320, 0.0, 1e6, seed), x);
    EXPECT_GT(small, 0);
    EXPECT_LE(large, 1.5 * small) << seed;
  }
}

TEST(ConjugateGradient, HasTheSameBitsOnAnyNumberOfWorkers) {
  for (const double storage : {3.0, 1e-3}) {
    const auto lower = grid(140, storage, 1e5);
    Eigen::VectorXd alone;
    ASSERT_GT(solve(lower, alone), 0);
    for (const int count : {1, 2, 3, 5}) {
      Workers workers(count);
      Eigen::VectorXd x;
      ASSERT_GT(solve(lower, x, &workers), 0);
      EXPECT_TRUE((x.array() == alone.array()).all()) << count << " workers, storage " << storage;
    }
  }
}

// Rock that conducts a millionth of its cracks and less. Where it hardly depends on its pores, all there is to solve for are the cracks.
TEST(ConjugateGradient, FollowsCracksInRockThatHardlyConducts) {
  constexpr int side = 100, seeds = 20;
  constexpr Eigen::Index in_a_crack = side * side / 2 + side / 2, in_rock = side * side / 2;
  struct Limit {
    double rock;
    Eigen::Index from;
    int iterations;
  };
  for (const auto& [rock, source, limit] :
       {Limit{0.0, in_a_crack, 3}, Limit{1e-10, in_a_crack, 3}, Limit{1e-10, in_rock, 3},
        Limit{1e-6, in_a_crack, 100}, Limit{1e-6, in_rock, 60}}) {
    int all = 0, most = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const SparseMatrix lower = crossing_cracks(side, rock, seed);
      Eigen::VectorXd x;
      const int iterations = solve(lower, x, nullptr, source);
      EXPECT_GT(iterations, 0) << rock;
      all += iterations;
      most = std::max(most, iterations);
      if (seed > 3) continue;
      const Eigen::VectorXd exact = SymmetricFactor(lower).solve(from(lower, source));
      EXPECT_LE((x - exact).cwiseAbs().maxCoeff(), 1e-6 * exact.cwiseAbs().maxCoeff()) << rock;
    }
    std::cout << "rock " << rock << ": " << static_cast<double>(all) / seeds << " iterations on the mean of "
              << seeds << " draws, at most " << most << '\n';
    EXPECT_LE(all, limit * seeds) << "iterations on the mean over draws; rock " << rock;
  }
}

// A colour's rows do not depend on each other, colours stand in order within their group, and a pore network takes few of them.
TEST(Multigrid, PutsRowsOfAGroupInOrderOfColours) {
  const auto lower = grid(70, 0.1, 1e4);
  Multigrid multigrid;
  ASSERT_TRUE(multigrid.prepare(lower));
  for (std::size_t at = 0; at < multigrid.arrays().size(); ++at) {
    const LevelArrays& l = multigrid.arrays()[at];
    const auto& order = multigrid.level(at).order;
    std::vector<int> colour(static_cast<std::size_t>(l.rows), -1);
    const std::int64_t groups = (l.rows + row_group - 1) / row_group;
    ASSERT_EQ(l.colour_start[l.group_colour[groups]], l.rows);
    for (std::int64_t g = 0; g < groups; ++g) {
      EXPECT_EQ(l.colour_start[l.group_colour[g]], g * row_group);
      EXPECT_LE(l.group_colour[g + 1] - l.group_colour[g], at == 0 ? 4 : 12);
      for (auto c = l.group_colour[g]; c < l.group_colour[g + 1]; ++c) {
        EXPECT_LT(l.colour_start[c], l.colour_start[c + 1]);
        for (auto i = l.colour_start[c]; i < l.colour_start[c + 1]; ++i) {
          colour[static_cast<std::size_t>(i)] = c;
          EXPECT_EQ(order[static_cast<std::size_t>(i)] / row_group, g) << "a row left its group";
        }
      }
    }
    for (std::int64_t i = 0; i < l.rows; ++i) {
      const auto of = [&](int k) { return colour[static_cast<std::size_t>(l.column[k])]; };
      const int mine = colour[static_cast<std::size_t>(i)];
      for (auto k = l.start[i]; k < l.upper[i]; ++k) EXPECT_LT(of(k), mine);
      for (auto k = l.upper[i]; k < l.outer[i]; ++k) EXPECT_GT(of(k), mine);
      for (auto k = l.outer[i]; k < l.start[i + 1]; ++k) EXPECT_NE(l.column[k] / row_group, i / row_group);
    }
  }
}

// Conjugate gradients need a preconditioner that is symmetric and positive.
void expect_symmetric_and_positive(const SparseMatrix& lower) {
  Multigrid multigrid;
  ASSERT_TRUE(multigrid.prepare(lower));
  Workers team(1);
  Random random(9);
  const auto rows = static_cast<std::size_t>(lower.cols());
  for (int draw = 0; draw < 3; ++draw) {
    std::vector<double> a(rows), b(rows), to_a(rows), to_b(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      a[i] = random.uniform() - 0.5;
      b[i] = random.uniform() - 0.5;
    }
    RankTeam(team).share(false, false, [&](const RankTeam::Member& member) {
      multigrid.precondition(member, a.data(), to_a.data());
      multigrid.precondition(member, b.data(), to_b.data());
    });
    double ab = 0.0, ba = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      ab += a[i] * to_b[i];
      ba += b[i] * to_a[i];
      aa += a[i] * to_a[i];
      bb += b[i] * to_b[i];
    }
    EXPECT_GT(aa, 0.0);
    EXPECT_GT(bb, 0.0);
    EXPECT_LE(std::abs(ab - ba), 1e-12 * std::sqrt(aa * bb));
  }
}

TEST(Multigrid, IsSymmetricAndPositive) {
  expect_symmetric_and_positive(grid(90, 1e-3, 1e6));
}

// Whether they are solved for by their inverse or by their factor, be they few or many.
TEST(Multigrid, IsSoWhereCracksAreALevelAsTheyAre) {
  struct Size {
    int side;
    std::int64_t least, most;  // rows of the second level
  };
  for (const auto& [side, least, most] :
       {Size{50, 100, 200}, Size{100, 201, few_rows}, Size{250, few_rows + 1, 8000}}) {
    const SparseMatrix lower = crossing_cracks(side, 1e-10, 3);
    Multigrid multigrid;
    ASSERT_TRUE(multigrid.prepare(lower));
    ASSERT_GE(multigrid.arrays().size(), 2U) << side;
    const LevelArrays& cracks = multigrid.arrays()[1];
    EXPECT_GE(cracks.rows, least) << side;
    EXPECT_LE(cracks.rows, most) << side;
    EXPECT_EQ(multigrid.arrays()[0].share, 1.0);
    for (std::int64_t row = 0; row < cracks.rows; ++row)
      EXPECT_EQ(multigrid.arrays()[0].first[row + 1] - multigrid.arrays()[0].first[row], 1);
    expect_symmetric_and_positive(lower);
  }
}

TEST(ConjugateGradient, RefusesAMatrixThatIsNotPositive) {
  auto lower = grid(8, 1.0, 1.0);
  ConjugateGradient solver;
  ASSERT_TRUE(solver.prepare(lower));
  lower.coeffRef(7, 7) = -1.0;
  EXPECT_FALSE(solver.prepare(lower));
  lower.coeffRef(7, 7) = NAN;
  EXPECT_FALSE(solver.prepare(lower));
}

}  // namespace conjugate_gradient_test
