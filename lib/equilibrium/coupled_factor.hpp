// SPDX-License-Identifier: BSD-3-Clause
// A sparse factor of the tangent. An older one serves as preconditioner (krylov.hpp): from iteration to iteration the tangent
// changes in few places, so a few products replace a new factor.
//
// The factor is of single precision as long as that does: where pipes conduct more than 1e5 times what rock yields,
// what a fracture stores drowns in the rounding of what passes through it, and where pieces of rock hang on a thread, so does
// what holds them. The first shows in the entries, the second in iterations with a fresh factor.
//
// Ranks share it, each with its part (front_tree.hpp), with the same bits on any number of them. Or it is a solver's from outside, of double
// precision and shared, too.
#pragma once

#include <optional>
#include <vector>

#include "core/workers.hpp"
#include "equilibrium/coupled_system.hpp"
#include "linear/front_tree.hpp"
#include "linear/multifrontal.hpp"
#include "linear/outside_matrix.hpp"

namespace hfrac {

class CoupledFactor {
 public:
  using Vector = CoupledSystem::Vector;

  // Our own; or that of the ranks' solver.
  explicit CoupledFactor(Workers& workers, const Ranks& ranks = {}, bool from_outside = false)
      : workers_(workers), ranks_(ranks) {
    if (from_outside) outside_.emplace(ranks, OutsideMatrix::Kind::tangent);
  }

  // Of the tangent at the last evaluation.
  void compute(const CoupledSystem& system);
  [[nodiscard]] bool ready() const { return ready_; }
  // Solutions have the digits of single precision, and no more.
  [[nodiscard]] bool single() const { return !doubled_; }
  void forget() { ready_ = exact_ = false; }
  // Other pairs of discs are near: the pattern is found anew with the next factor.
  void forget_pattern() { entries_ = 0; }
  // In double precision from the next factor on, until it is forgotten. False: it is already.
  bool refine();
  // x := factor^-1 right
  void solve(const Vector& right, Vector& x);

 private:
  void compute_outside(const CoupledSystem& system);

  // Of a small factor each rank makes all.
  [[nodiscard]] Ranks sharing() const { return tree_.worth_sharing() ? ranks_ : Ranks{}; }

  Workers& workers_;
  Ranks ranks_;
  std::optional<OutsideMatrix> outside_;
  FrontTree tree_;
  Multifrontal<float> coarse_;
  Multifrontal<double> fine_;
  std::vector<float> single_;  // entries, while a factor is made of them
  std::vector<double> values_;
  std::size_t entries_ = 0;  // of the pattern analysed
  bool ready_ = false;
  bool exact_ = false;    // single precision did not do
  bool doubled_ = false;  // the factor at hand is of double precision
};

}  // namespace hfrac
