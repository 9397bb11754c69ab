// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients, preconditioned by multigrid, for the flow matrix of models too large to factorise.
//
// Workers share the vectors by groups of rows of fixed length; a scalar product is the sum over groups in order, whoever made them. So
// the bits do not depend on their number, nor, as every rank solves for itself, on that of ranks.
#pragma once

#include <vector>

#include "core/workers.hpp"
#include "linear/multigrid.hpp"
#include "linear/sparse.hpp"

namespace hfrac {

// y = A x of a symmetric matrix by its lower triangle, each column beginning with its diagonal.
void symmetric_product(const SparseMatrix& lower, const Eigen::VectorXd& x, Eigen::VectorXd& y);

class ConjugateGradient {
 public:
  // Without workers on the calling thread alone.
  explicit ConjugateGradient(Workers* workers = nullptr) : workers_(workers) {}

  // `lower` is the lower triangle of a symmetric positive definite matrix, each column beginning with its diagonal. False if
  // an entry of the diagonal is not positive or not finite.
  [[nodiscard]] bool prepare(const SparseMatrix& lower) { return multigrid_.prepare(lower); }

  // Improves x until the residual, scaled by the diagonal, is below `tolerance` of the right-hand side's. Returns the
  // iterations it took, or -1 if `most` were not enough. Leaves the residual in `rhs`.
  int solve(Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance, int most);

 private:
  using Sums = std::vector<double>;  // of groups
  // Of each group the sum term(first row, rows); total() is known to all behind the next barrier.
  template <class Term>
  void add_up(const Workers::Member& member, Sums& sums, const Term& term);
  static double total(const Sums& sums);

  Workers* workers_;
  Workers alone_{1};
  Multigrid multigrid_;
  Eigen::VectorXd z_, p_;
  Sums sums_, other_sums_;
};

}  // namespace hfrac
