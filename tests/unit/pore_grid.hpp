// SPDX-License-Identifier: BSD-3-Clause
// The matrix of pores on a grid, for tests of what solves flow.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "linear/sparse.hpp"

namespace hfrac {

// Pores on a square grid, joined to four neighbours each: rock of random conductance (1, standard deviation of its logarithm 1),
// `storage` of each pore, and a crack of conductance `crack` along half of the middle row. Held at 0 left of the first column.
inline SparseMatrix grid(int side, double storage, double crack, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < side * side; ++k) entries.emplace_back(k, k, storage + (k % side == 0 ? 1.0 : 0.0));
  const auto join = [&](int k, int other, double c) {
    entries.emplace_back(k, k, c);
    entries.emplace_back(other, other, c);
    entries.emplace_back(other, k, -c);
  };
  const auto rock = [&] { return std::exp(2.0 * std::sqrt(3.0) * (random.uniform() - 0.5)); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int k = y * side + x;
      const bool cracked = y == side / 2 && x > side / 4 && x < 3 * side / 4;
      if (x + 1 < side) join(k, k + 1, cracked ? crack : rock());
      if (y + 1 < side) join(k, k + side, rock());
    }
  }
  SparseMatrix lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace hfrac
