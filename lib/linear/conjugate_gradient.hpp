// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients for the flow matrix of models too large to factorise.
//
// Preconditioned by an incomplete Cholesky factorisation without fill (Meijerink and van der Vorst 1977) that moves what it
// drops onto the diagonal (modified, Gustafsson 1978): exact along chains and trees of open cracks, whose conductance is
// 1e10 times the rock's, and good where pressure spreads over long distances. Flow matrices are M-matrices, so
// the factor exists. Serial and in a fixed order: the same bits on any machine.
#pragma once

#include <vector>

#include "linear/sparse.hpp"

namespace hfrac {

// y = A x of a symmetric matrix by its lower triangle, each column beginning with its diagonal.
void symmetric_product(const SparseMatrix& lower, const Eigen::VectorXd& x, Eigen::VectorXd& y);

class ConjugateGradient {
 public:
  using Matrix = SparseMatrix;

  // `lower` is the lower triangle of a symmetric positive definite matrix, each column beginning with its diagonal. False if
  // a pivot is not positive or not finite.
  [[nodiscard]] bool factorise(const Matrix& lower);

  // Improves x until the residual, scaled by the diagonal, is below `tolerance` of the right-hand side's. Returns the
  // iterations it took, or -1 if `most` were not enough. Leaves the residual in `rhs`.
  int solve(const Matrix& lower, Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance, int most);

 private:
  void precondition(const Matrix& lower, const Eigen::VectorXd& r, Eigen::VectorXd& z) const;

  Eigen::VectorXd
      values_;  // of L D' L^T, on the matrix's pattern: D' on the diagonal, columns of L below, unit diagonal
  Eigen::VectorXd z_, p_;
};

}  // namespace hfrac
