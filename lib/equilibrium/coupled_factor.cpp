// SPDX-License-Identifier: BSD-3-Clause
#include "equilibrium/coupled_factor.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {

namespace {

constexpr double most_single = 1e5;  // entry, of bonds' about 1, up to which single precision does

}  // namespace

void CoupledFactor::compute(const CoupledSystem& system) {
  ready_ = false;  // until all of it is there: memory may run out on the way
  system.entries(values_);
  if (values_.size() != entries_) {
    entries_ = 0;
    const auto s = system.structure();
    tree_.analyse(s.node_start, s.position, s.graph, s.late, s.places);
    entries_ = values_.size();
  }
  double largest = 0.0;
  for (const double value : values_) largest = std::max(largest, std::abs(value));
  doubled_ = exact_ || !(largest < most_single);
  if (doubled_) {
    coarse_.clear();
    fine_.factorise(tree_, values_, workers_);
  } else {
    fine_.clear();
    coarse_.factorise(tree_, values_, workers_);
  }
  ready_ = true;
}

bool CoupledFactor::refine() {
  exact_ = true;
  return !doubled_;
}

void CoupledFactor::solve(const Vector& right, Vector& x) {
  x = right;
  if (doubled_)
    fine_.solve(tree_, x.data(), workers_);
  else
    coarse_.solve(tree_, x.data(), workers_);
}

// Preconditioned from the right, so that the residual watched is the true one; modified Gram-Schmidt, Givens rotations.
KrylovOutcome solve_preconditioned(const CoupledSystem& system, CoupledFactor& factor,
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
    directions.emplace_back();
    factor.solve(basis.back(), directions.back());
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
