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

// The same without the first pipe, and with one from the first pore to the last.
inline SparseMatrix with_a_shortcut(const SparseMatrix& lower) {
  std::vector<Eigen::Triplet<double>> entries;
  bool taken = false;
  for (Eigen::Index k = 0; k < lower.outerSize(); ++k) {
    for (SparseMatrix::InnerIterator entry(lower, k); entry; ++entry) {
      const bool first_pipe = !taken && entry.row() != entry.col();
      taken = taken || first_pipe;
      const auto row = first_pipe ? lower.rows() - 1 : entry.row();
      entries.emplace_back(row, entry.col(), entry.value());
      if (first_pipe) entries.emplace_back(row, row, -entry.value());
    }
  }
  SparseMatrix other(lower.rows(), lower.cols());
  other.setFromTriplets(entries.begin(), entries.end());
  return other;
}

// Cracks that cross, of conductances over three powers of ten, in rock of conductance `rock`.
inline SparseMatrix crossing_cracks(int side, double rock, std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < side * side; ++k) entries.emplace_back(k, k, 1e-6);
  const auto join = [&](int k, int other, bool cracked) {
    const double c = cracked ? std::pow(10.0, -3.0 * random.uniform()) : rock;
    entries.emplace_back(k, k, c);
    entries.emplace_back(other, other, c);
    entries.emplace_back(other, k, -c);
  };
  const auto inside = [side](int at) { return at > side / 8 && at < 7 * side / 8; };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (x + 1 < side) join(y * side + x, y * side + x + 1, y % 20 == 10 && inside(x));
      if (y + 1 < side) join(y * side + x, y * side + x + side, x % 25 == 12 && inside(y));
    }
  }
  SparseMatrix lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace hfrac
