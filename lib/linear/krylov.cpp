// SPDX-License-Identifier: BSD-3-Clause
#include "linear/krylov.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

constexpr Eigen::Index chunk = 2048;
constexpr std::size_t chunks_worth_sharing = 4;

}  // namespace

void Krylov::orthogonalise(int k, double* column) {
  const auto size = next_.size();
  const auto chunks = static_cast<Eigen::Index>(sums_[0].size());
  team_.share(sums_[0].size() >= chunks_worth_sharing, true, [&](const RankTeam::Member& member) {
    const auto mine_are = member.part(chunks, 1);
    const auto each_chunk = [&](const auto& visit) {
      for (auto c = mine_are.first; c < mine_are.last; ++c)
        visit(c, next_.segment(c * chunk, std::min(chunk, size - c * chunk)));
    };
    const auto part = [&](const Vector& of, Eigen::Index c) {
      return of.segment(c * chunk - first_, std::min(chunk, size - c * chunk));
    };
    const auto sum = [&](int turn) {
      member.gather(sums_[turn].data(), chunks, 1);
      double all = 0.0;
      for (const double s : sums_[turn]) all += s;
      return all;
    };
    each_chunk([&](Eigen::Index c, auto mine) {
      sums_[0][static_cast<std::size_t>(c)] = part(basis_[0], c).dot(mine);
    });
    for (int i = 0; i <= k; ++i) {
      const double along = sum(i % 2);
      if (member.is_first()) column[i] = along;
      const Vector &taken = basis_[static_cast<std::size_t>(i)],
                   &then = basis_[static_cast<std::size_t>(i) + 1];
      each_chunk([&](Eigen::Index c, auto mine) {
        mine -= along * part(taken, c);
        sums_[(i + 1) % 2][static_cast<std::size_t>(c)] =
            i < k ? part(then, c).dot(mine) : mine.squaredNorm();
      });
    }
    const double length = std::sqrt(sum((k + 1) % 2));
    if (member.is_first()) column[k + 1] = length;
    Vector& made = basis_[static_cast<std::size_t>(k) + 1];
    each_chunk([&](Eigen::Index c, auto mine) {
      made.segment(c * chunk - first_, mine.size()) = last_.segment(c * chunk, mine.size()) = mine / length;
    });
    member.gather(last_.data(), size, chunk);
  });
}

void Krylov::gather(Vector& whole) {
  team_.share(false, true,
              [&](const RankTeam::Member& member) { member.gather(whole.data(), whole.size(), chunk); });
}

template <class Part>
Part& Krylov::part_in(std::vector<Part>& set, int k) const {
  if (set.size() <= static_cast<std::size_t>(k)) set.emplace_back();
  Part& part = set[static_cast<std::size_t>(k)];
  part.resize(count_);
  return part;
}

Krylov::Outcome Krylov::solve(const Apply& product, const Apply& precondition, const Vector& right,
                              double tolerance, int most, Vector& x, Digits digits) {
  Outcome outcome;
  x.setZero(right.size());
  const double size = right.norm();
  if (!(size > 0.0)) {
    outcome.converged = size == 0.0;
    return outcome;
  }
  const auto mine = team_.ranks().part(team_.ranks().rank(), right.size(), chunk);
  first_ = mine.first;
  count_ = mine.end - mine.first;
  const bool single = digits == Digits::of_single;
  for (auto& sums : sums_) sums.resize(static_cast<std::size_t>((right.size() + chunk - 1) / chunk));
  last_ = right / size;
  part_in(basis_, 0) = part_of(last_);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
  Vector cosine(most), sine(most), g = Vector::Zero(most + 1);
  g[0] = size;
  int k = 0;
  for (; k < most; ++k) {
    part_in(basis_, k + 1);
    precondition(last_, direction_);
    if (single)
      part_in(single_directions_, k) = part_of(direction_).cast<float>();
    else
      part_in(directions_, k) = part_of(direction_);
    product(direction_, next_);
    orthogonalise(k, h.col(k).data());
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
    outcome.converged = std::abs(g[k + 1]) <= tolerance * size;
    if (outcome.converged || !(left > 0.0) || !std::isfinite(left)) {
      ++k;
      break;
    }
  }
  const Vector y = h.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
  for (int i = 0; i < k; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (single)
      part_of(x) += y[i] * single_directions_[at].cast<double>();
    else
      part_of(x) += y[i] * directions_[at];
  }
  gather(x);
  return outcome;
}

}  // namespace hfrac
