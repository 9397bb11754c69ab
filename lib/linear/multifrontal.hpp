// SPDX-License-Identifier: BSD-3-Clause
// A sparse L U factor of a matrix with symmetric pattern, by dense fronts (Duff and Reid 1983).
//
// A front is the sum of its entries of the matrix and of what its children left over; its pivots are eliminated and the rest is
// handed to its parent. Nearly all work is in products of dense blocks, which is why this is several times faster than a
// factor by scattered columns. Rows are exchanged within a front's pivots only, so what is stored follows from the pattern
// alone and is found once (front_tree.hpp).
//
// Real is float or double. A factor that only preconditions needs no more digits than it gains per iteration, and in single
// precision it takes half the time and memory. Every number is found by the same operations in the same order on any number of workers,
// and of ranks, which have a part of the factor each (FrontTree::share_out): where a front's child is another's, its owner sends what it left over, and
// on the way back all learn what is solved above subtrees. Of a rank's workers the first alone talks.
#pragma once

#include <atomic>
#include <exception>
#include <vector>

#include "core/array.hpp"
#include "core/ranks.hpp"
#include "core/workers.hpp"
#include "linear/dense_kernels.hpp"
#include "linear/front_tree.hpp"

namespace hfrac {

template <class Real>
class Multifrontal {
 public:
  // Over ranks, all of them, with a tree that was shared out among them. Throws Error(exchange) where another no longer answers.
  void factorise(const FrontTree& tree, const std::vector<Real>& values, Workers& workers,
                 const Ranks& ranks = {});
  // Overwrites x, the right side, with the solution, on every rank.
  void solve(const FrontTree& tree, double* x, Workers& workers, const Ranks& ranks = {});
  // Gives the memory back.
  void clear() { *this = {}; }
  Multifrontal() = default;
  Multifrontal& operator=(Multifrontal&& other) noexcept;

 private:
  using Front = FrontTree::Front;
  struct Bench {  // a worker's own work space
    Array<Real> front, stack, pivots, boundary;
  };
  void prepare(const FrontTree& tree, const Workers& workers);
  void tidy();
  Real* leftover(const Front& front, Bench& bench) {
    return (front.kept ? kept_.data() : bench.stack.data()) + front.leftover;
  }
  void assemble(const FrontTree& tree, const Front& front, const std::vector<Real>& values, Real* w,
                Bench& bench, std::int64_t first, std::int64_t last);
  void store(const Front& front, const Real* w, Real* left, std::int64_t first, std::int64_t last);
  void factorise_below(const FrontTree& tree, const Front& front, const std::vector<Real>& values,
                       Bench& bench);
  void factorise_top(const FrontTree& tree, const Front& front, const std::vector<Real>& values,
                     Workers& workers, int worker);
  // Over ranks: in a task, words() by the first worker, whose failure the task's end tells, and a barrier.
  template <class Words>
  void talk(Workers& workers, int worker, const Ranks& ranks, const Words& words);
  template <class Place>
  void hand_up(const FrontTree& tree, const Front& front, const Ranks& ranks, const Place& place);
  void tell_solved(const FrontTree& tree, const Front& front, const Ranks& ranks);
  void tell_all_solved(const FrontTree& tree, const Ranks& ranks);
  void gather(const FrontTree& tree, const Front& front, const double* x, Real* pivots, Real* boundary) const;
  void forward_below(const FrontTree& tree, const Front& front, const double* x, Bench& bench);
  void forward_top(const FrontTree& tree, const Front& front, const double* x, Workers& workers, int worker);
  void backward_below(const FrontTree& tree, const Front& front, Bench& bench);
  void backward_top(const FrontTree& tree, const Front& front, Workers& workers, int worker);

  const DenseKernels<Real>* dense_ = nullptr;
  Array<Real> columns_, rows_;  // the factor
  // While it is made: what subtrees and the fronts above them left over, and the front above subtrees that is worked on.
  Array<Real> kept_, top_;
  Array<Real> carried_;  // right sides handed from front to parent
  Array<Real> solution_;
  std::vector<std::int32_t> swaps_;
  std::vector<Bench> benches_;
  std::atomic<std::int32_t> next_{0};  // subtree to take
  std::exception_ptr failure_;         // of the first worker, of the task at hand
};

extern template class Multifrontal<float>;
extern template class Multifrontal<double>;

}  // namespace hfrac
