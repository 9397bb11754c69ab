// SPDX-License-Identifier: BSD-3-Clause
#include "linear/conjugate_gradient.hpp"

#include <cmath>

namespace hfrac {
namespace {

constexpr std::int64_t rows_worth_sharing = 8 * Multigrid::group;

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

template <class Term>
void ConjugateGradient::add_up(const Workers::Member& member, Sums& sums, const Term& term) {
  Multigrid::each_group(member, multigrid_.rows(), [&](std::int64_t first, std::int64_t end) {
    sums[static_cast<std::size_t>(first / Multigrid::group)] = term(first, end - first);
  });
}

double ConjugateGradient::total(const Sums& sums) {
  double all = 0.0;
  for (const double s : sums) all += s;
  return all;
}

int ConjugateGradient::solve(Eigen::VectorXd& rhs, Eigen::VectorXd& x, double tolerance, int most) {
  const auto rows = multigrid_.rows();
  const bool shared = workers_ != nullptr && rows >= rows_worth_sharing;
  Workers& team = shared ? *workers_ : alone_;
  z_.resize(rows);
  p_.setZero(rows);
  for (auto* sums : {&sums_, &other_sums_})
    sums->resize(static_cast<std::size_t>((rows + Multigrid::group - 1) / Multigrid::group));
  Eigen::VectorXd& r = rhs;
  const Eigen::Map<const Eigen::VectorXd> diagonal(multigrid_.diagonal().data(), rows);
  // In units of the diagonal's roots.
  const auto squared_length = [&](std::int64_t first, std::int64_t count) {
    return (r.segment(first, count).array().square() / diagonal.segment(first, count).array()).sum();
  };
  double target = 0.0, product = 1.0, far = 0.0;
  team.share(shared, [&](const Workers::Member& member) {
    add_up(member, other_sums_, squared_length);
    multigrid_.multiply(member, x.data(), z_.data());
    add_up(member, sums_, [&](std::int64_t first, std::int64_t count) {
      r.segment(first, count) -= z_.segment(first, count);
      return squared_length(first, count);
    });
  });
  target = tolerance * std::sqrt(total(other_sums_));
  for (int iteration = 0; iteration <= most; ++iteration) {
    if (std::sqrt(total(sums_)) <= target) return iteration;
    team.share(shared, [&](const Workers::Member& member) {
      multigrid_.precondition(member, r.data(), z_.data());
      add_up(member, sums_, [&](std::int64_t first, std::int64_t count) {
        return r.segment(first, count).dot(z_.segment(first, count));
      });
      member.barrier();
      const double along = total(sums_), kept = along / product;
      Multigrid::each_group(member, rows, [&](std::int64_t first, std::int64_t end) {
        auto p = p_.segment(first, end - first);
        p = z_.segment(first, end - first) + kept * p;
      });
      member.barrier();
      Eigen::VectorXd& q = z_;  // whose job is done
      multigrid_.multiply(member, p_.data(), q.data());
      add_up(member, other_sums_, [&](std::int64_t first, std::int64_t count) {
        return p_.segment(first, count).dot(q.segment(first, count));
      });
      member.barrier();
      const double step = along / total(other_sums_);
      add_up(member, sums_, [&](std::int64_t first, std::int64_t count) {
        x.segment(first, count) += step * p_.segment(first, count);
        r.segment(first, count) -= step * q.segment(first, count);
        return squared_length(first, count);
      });
      if (member.number == 0) {  // the others have read the product before two barriers
        product = along;
        far = step;
      }
    });
    if (!std::isfinite(far)) return -1;
  }
  return -1;
}

}  // namespace hfrac
