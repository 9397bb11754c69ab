// SPDX-License-Identifier: BSD-3-Clause
// GMRES (Saad and Schultz 1986) for a matrix known by its products, preconditioned from the right by a factor of it or of one like
// it, so that the residual watched is the true one. Modified Gram-Schmidt, Givens rotations.
//
// Ranks and their workers share the vectors by chunks of fixed length; what a rank keeps of the directions is its own chunks alone. A dot
// product is the sum over chunks in order, whoever made them, so results do not depend on the number of either; taking away one direction
// and the product with the next go in one pass. Products and preconditioners take whole vectors, on all ranks.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/rank_team.hpp"

namespace hfrac {

class Krylov {
 public:
  using Vector = Eigen::VectorXd;
  using Apply = std::function<void(const Vector& to, Vector& result)>;

  explicit Krylov(Workers& workers, const Ranks& ranks = {}) : team_(workers, ranks) {}

  struct Outcome {
    int iterations = 0;
    bool converged = false;
  };
  // What `precondition` gives is of double precision, or has no more digits than single precision and is kept in it, in half of the memory.
  enum class Digits { of_double, of_single };
  // Solves A x = right to |A x - right| <= tolerance |right|, from x = 0; `product` gives A x, `precondition` about A^-1 x.
  Outcome solve(const Apply& product, const Apply& precondition, const Vector& right, double tolerance,
                int most, Vector& x, Digits digits = Digits::of_double);
  // Gives the memory of its vectors back, two an iteration of the longest solve so far: while a factor is made there is other use for it.
  void forget() {
    basis_.clear();
    directions_.clear();
    single_directions_.clear();
  }

 private:
  // Takes from `next` what it has along basis[0] to basis[k], noting how much in column[0..k], and its length then in
  // column[k + 1]; that over its length becomes basis[k + 1], whole in `last`.
  void orthogonalise(int k, double* column);
  // All of a vector of which each rank has its part.
  void gather(Vector& whole);
  [[nodiscard]] auto part_of(Vector& whole) const { return whole.segment(first_, count_); }

  // The k-th of a set of parts of a vector.
  template <class Part>
  Part& part_in(std::vector<Part>& set, int k) const;

  RankTeam team_;
  Eigen::Index first_ = 0, count_ = 0;      // this rank's part of a vector
  std::vector<Vector> basis_, directions_;  // of them that part
  std::vector<Eigen::VectorXf> single_directions_;
  Vector next_, last_, direction_;
  std::vector<double> sums_[2];  // of chunks, in turns
};

}  // namespace hfrac
