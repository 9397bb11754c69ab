// SPDX-License-Identifier: BSD-3-Clause
#include "linear/conjugate_gradient.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

// Share of dropped fill that goes to the diagonal: all of it would leave nothing for rounding.
constexpr double kept_fill = 0.97;

// In units of the diagonal's roots.
double scaled_length(const SparseMatrix& lower, const Eigen::VectorXd& v) {
  double sum = 0.0;
  for (Eigen::Index k = 0; k < v.size(); ++k) sum += v[k] * v[k] / lower.valuePtr()[lower.outerIndexPtr()[k]];
  return std::sqrt(sum);
}

}  // namespace

void symmetric_product(const SparseMatrix& lower, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  const auto n = lower.cols();
  const int* start = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  const double* value = lower.valuePtr();
  y.setZero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double here = x[k];
    double sum = value[start[k]] * here;
    for (int a = start[k] + 1; a < start[k + 1]; ++a) {
      sum += value[a] * x[row[a]];
      y[row[a]] += value[a] * here;
    }
    y[k] += sum;
  }
}

bool ConjugateGradient::factorise(const Matrix& lower) {
  const auto n = lower.cols();
  const int* start = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  values_ = Eigen::Map<const Eigen::VectorXd>(lower.valuePtr(), lower.nonZeros());
  double* value = values_.data();
  for (Eigen::Index k = 0; k < n; ++k) {
    const int begin = start[k], end = start[k + 1];
    const double pivot = value[begin];
    if (!(pivot > 0.0) || !std::isfinite(pivot)) return false;
    // What eliminating unknown k does to the pairs of its neighbours.
    for (int a = begin + 1; a < end; ++a) {
      const double share = value[a] / pivot;
      if (share == 0.0) continue;
      value[start[row[a]]] -= share * value[a];
      for (int b = a + 1; b < end; ++b) {
        const double fill = share * value[b];
        if (fill == 0.0) continue;
        const int* first = row + start[row[a]] + 1;
        const int* last = row + start[row[a] + 1];
        const int* at = std::lower_bound(first, last, row[b]);
        if (at != last && *at == row[b]) {
          value[at - row] -= fill;
        } else {
          value[start[row[a]]] -= kept_fill * fill;
          value[start[row[b]]] -= kept_fill * fill;
        }
      }
    }
    for (int a = begin + 1; a < end; ++a) value[a] /= pivot;
  }
  return true;
}

// z = (L D' L^T)^-1 r
void ConjugateGradient::precondition(const Matrix& lower, const Eigen::VectorXd& r,
                                     Eigen::VectorXd& z) const {
  const auto n = lower.cols();
  const int* start = lower.outerIndexPtr();
  const int* row = lower.innerIndexPtr();
  const double* value = values_.data();
  z = r;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double here = z[k];
    for (int a = start[k] + 1; a < start[k + 1]; ++a) z[row[a]] -= value[a] * here;
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    double sum = z[k] / value[start[k]];
    for (int a = start[k] + 1; a < start[k + 1]; ++a) sum -= value[a] * z[row[a]];
    z[k] = sum;
  }
}

int ConjugateGradient::solve(const Matrix& lower, Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance,
                             int most) {
  for (auto* v : {&z_, &p_}) v->resize(lower.cols());
  const double target = tolerance * scaled_length(lower, rhs);
  Eigen::VectorXd& r = rhs;
  symmetric_product(lower, x, z_);
  r -= z_;
  double product = 0.0;
  for (int iteration = 0; iteration <= most; ++iteration) {
    if (scaled_length(lower, r) <= target) return iteration;
    precondition(lower, r, z_);
    const double next = r.dot(z_);
    if (iteration == 0) {
      p_ = z_;
    } else {
      p_ = z_ + (next / product) * p_;
    }
    product = next;
    Eigen::VectorXd& q = z_;  // whose job is done
    symmetric_product(lower, p_, q);
    const double step = product / p_.dot(q);
    if (!std::isfinite(step)) return -1;
    x += step * p_;
    r -= step * q;
  }
  return -1;
}

}  // namespace hfrac
