// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/coupled_factor.hpp"

#include <cmath>

#include "core/error.hpp"

namespace hfrac {

void CoupledFactor::compute(const CoupledSystem& system) {
  ready_ = false;
  const Eigen::Index n = system.size();
  if (static_cast<Eigen::Index>(order_.size()) != n) {
    order_ = system.order();
    place_.assign(static_cast<std::size_t>(n), 0);
    for (Eigen::Index k = 0; k < n; ++k)
      place_[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])] = k;
  }
  system.symmetric_part(list_);
  for (auto& entry : list_) {
    const auto row = place_[static_cast<std::size_t>(entry.row())],
               column = place_[static_cast<std::size_t>(entry.col())];
    entry = {static_cast<int>(std::max(row, column)), static_cast<int>(std::min(row, column)), entry.value()};
  }
  matrix_.resize(n, n);
  matrix_.setFromTriplets(list_.begin(), list_.end());
  factor_.compute(matrix_);
  if (factor_.info() != Eigen::Success)
    throw Error(ErrorKind::diverged,
                "the equations of equilibrium cannot be factorised: part of the model is held by nothing");
  entries_ = static_cast<double>(factor_.matrixL().nestedExpression().nonZeros());
  ready_ = true;
}

CoupledFactor::Vector CoupledFactor::solve(const Vector& right) const {
  Vector permuted(right.size()), x(right.size());
  for (Eigen::Index k = 0; k < right.size(); ++k) permuted[k] = right[order_[static_cast<std::size_t>(k)]];
  const Vector solved = factor_.solve(permuted);
  for (Eigen::Index k = 0; k < right.size(); ++k) x[order_[static_cast<std::size_t>(k)]] = solved[k];
  return x;
}

// Preconditioned from the right, so that the residual watched is the true one; modified Gram-Schmidt, Givens rotations.
KrylovOutcome solve_preconditioned(const CoupledSystem& system, const CoupledFactor& factor,
                                   const CoupledSystem::Vector& right, double tolerance, int most,
                                   CoupledSystem::Vector& x) {
  using Vector = CoupledSystem::Vector;
  KrylovOutcome outcome;
  x.setZero(right.size());
  const double size = right.norm();
  if (!(size > 0.0)) {
    outcome.converged = size == 0.0;
    return outcome;
  }
  std::vector<Vector> basis{right / size}, directions;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
  Vector cosine(most), sine(most), g = Vector::Zero(most + 1), w;
  g[0] = size;
  int k = 0;
  for (; k < most; ++k) {
    directions.push_back(factor.solve(basis.back()));
    system.product(directions.back(), w);
    for (int i = 0; i <= k; ++i) {
      h(i, k) = basis[static_cast<std::size_t>(i)].dot(w);
      w -= h(i, k) * basis[static_cast<std::size_t>(i)];
    }
    h(k + 1, k) = w.norm();
    for (int i = 0; i < k; ++i) {
      const double upper = cosine[i] * h(i, k) + sine[i] * h(i + 1, k);
      h(i + 1, k) = -sine[i] * h(i, k) + cosine[i] * h(i + 1, k);
      h(i, k) = upper;
    }
    const double length = std::hypot(h(k, k), h(k + 1, k));
    if (!(length > 0.0)) break;
    cosine[k] = h(k, k) / length;
    sine[k] = h(k + 1, k) / length;
    const double left = h(k + 1, k);
    h(k, k) = length;
    g[k + 1] = -sine[k] * g[k];
    g[k] *= cosine[k];
    outcome.iterations = k + 1;
    if (std::abs(g[k + 1]) <= tolerance * size) {
      outcome.converged = true;
      ++k;
      break;
    }
    if (!(left > 0.0) || !std::isfinite(left)) {
      ++k;
      break;
    }
    basis.push_back(w / left);
  }
  const Vector y = h.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
  for (int i = 0; i < k; ++i) x += y[i] * directions[static_cast<std::size_t>(i)];
  return outcome;
}

}  // namespace hfrac
