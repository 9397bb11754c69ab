// SPDX-License-Identifier: BSD-3-Clause
// The factor of flow matrices: the bits of the plain algorithm (Eigen's SimplicialLDLT), whatever the pattern.
#include "linear/symmetric_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <atomic>
#include <vector>

#include "core/random.hpp"
#include "core/workers.hpp"
#include "pore_grid.hpp"

namespace symmetric_factor_test {
using namespace hfrac;

Eigen::MatrixXd columns(Eigen::Index rows, Random& random) {
  Eigen::MatrixXd rhs(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i) {
    rhs(i, 0) = random.uniform() < 0.5 ? 0.0 : random.uniform() - 0.5;
    rhs(i, 1) = random.uniform() * 1e7;
  }
  return rhs;
}

void expect_the_bits_of_eigen(const SparseMatrix& lower, SymmetricFactor& factor, Random& random) {
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> plain(lower);
  ASSERT_EQ(factor.succeeded(), plain.info() == Eigen::Success);
  if (!factor.succeeded()) return;
  const Eigen::MatrixXd rhs = columns(lower.cols(), random), x = factor.solve(rhs), wanted = plain.solve(rhs);
  for (Eigen::Index i = 0; i < x.size(); ++i) ASSERT_EQ(x.data()[i], wanted.data()[i]) << i;
}

TEST(SymmetricFactor, HasTheBitsOfThePlainAlgorithmOnPores) {
  Workers two(2), five(5);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Random random(seed);
    for (const std::int32_t across : {1, 2, 7, 30, 90}) {
      SymmetricFactor factor;
      for (const double crack : {1.0, 1e8}) {
        const auto lower = grid(across, 1e-3, crack, seed);
        if (crack == 1.0) factor.analyse(lower);
        for (Workers* workers : {static_cast<Workers*>(nullptr), &two, &five}) {
          ASSERT_TRUE(factor.factorise(lower, workers)) << across;
          expect_the_bits_of_eigen(lower, factor, random);
        }
      }
    }
  }
}

// Each row once, and not before those beneath it: of any tree, also of one that is a chain, or of none.
TEST(SymmetricFactor, RowsWaitForThoseBeneathThem) {
  Workers workers(3);
  for (const std::int32_t n : {0, 1, 2, 50, 3000}) {
    for (const std::int32_t reach : {1, 2, 20, 100000}) {
      Random random(static_cast<std::uint64_t>(n + reach));
      std::vector<std::int32_t> parent, beneath(static_cast<std::size_t>(n), 0);
      std::vector<double> work;
      for (std::int32_t k = 0; k < n; ++k) {
        const auto up = k + 1 + static_cast<std::int32_t>(random.uniform() * reach);
        parent.push_back(up < n ? up : -1);
        work.push_back(random.uniform() + (k + 10 > n ? n : 0));
        if (up < n) ++beneath[static_cast<std::size_t>(up)];
      }
      Subtrees subtrees;
      subtrees.cut(parent, work);
      for (int round = 0; round < 3; ++round) {
        std::vector<std::atomic<std::int32_t>> made(static_cast<std::size_t>(n)), made_beneath(made.size());
        std::atomic<bool> in_turn{true};
        subtrees.begin();
        workers.run([&](int) {
          subtrees.take([&](std::int32_t row) {
            const auto k = static_cast<std::size_t>(row);
            if (made_beneath[k] != beneath[k] || made[k]++ != 0) in_turn = false;
            if (parent[k] >= 0) ++made_beneath[static_cast<std::size_t>(parent[k])];
          });
        });
        EXPECT_TRUE(in_turn) << n << ", " << reach;
        for (const auto& times : made) ASSERT_EQ(times, 1) << n << ", " << reach;
      }
    }
  }
}

// Any pattern, also a full one and one that falls into pieces; not positive definite either.
TEST(SymmetricFactor, HasTheBitsOfThePlainAlgorithmOnAnyPattern) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const auto n = static_cast<std::int32_t>(1 + 120 * random.uniform());
    const double density = seed % 10 == 0 ? 1.0 : 0.3 * random.uniform() * random.uniform();
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int32_t j = 0; j < n; ++j) {
      entries.emplace_back(j, j, seed % 3 == 0 ? random.uniform() - 0.5 : 5.0 + random.uniform());
      for (std::int32_t i = 0; i < n; ++i)  // above the diagonal nothing is looked at
        if (i != j && random.uniform() < density) entries.emplace_back(i, j, random.uniform() - 0.5);
    }
    SparseMatrix lower(n, n);
    lower.setFromTriplets(entries.begin(), entries.end());
    SymmetricFactor factor(lower);
    expect_the_bits_of_eigen(lower, factor, random);
  }
}

TEST(SymmetricFactor, SaysWhereAPivotIsZero) {
  SparseMatrix lower(2, 2);
  lower.insert(0, 0) = 1.0;
  lower.insert(1, 0) = 1.0;
  lower.insert(1, 1) = 1.0;
  lower.makeCompressed();
  EXPECT_FALSE(SymmetricFactor(lower).succeeded());
  lower.coeffRef(1, 1) = 2.0;
  EXPECT_TRUE(SymmetricFactor(lower).succeeded());
}

}  // namespace symmetric_factor_test
