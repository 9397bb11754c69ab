// SPDX-License-Identifier: BSD-3-Clause
// The equations of a flow step, row by row: of a domain that is solved for, 1 / stiffness and what its pipes conduct in the step on the
// diagonal, less what each of them conducts beside it (backward Euler of eq. 6 and 8).
//
// A row is made of its own domain's pipes alone, in their order, so that workers share rows and nobody adds into another one's. What a
// domain gains by the flows found is added up in the same way.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/workers.hpp"
#include "linear/aggregation.hpp"
#include "linear/sparse.hpp"
#include "model/network.hpp"

namespace hfrac {

class FlowMatrix {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;
  // nothing: of the explicit scheme, which has no equations and asks for outflow() alone; lower: lower() is asked for, too.
  enum class Layout { nothing, rows, lower };
  // `joined`: pairs of domains that no pipe joins, but a wellbore.
  FlowMatrix(const Network& network, const std::vector<Pair>& joined, Layout layout, Workers* workers);

  // Which domains are solved for, and what the rows of the others weigh.
  struct Unknowns {
    const std::vector<char>& cavitated;  // 1: stays at the floor
    double imposed_weight;
  };
  // `source`: m2/s into each domain, or empty.
  void assemble(const Network& network, double step, const std::vector<double>& source,
                const Unknowns& unknowns, Eigen::VectorXd& rhs);
  // On the diagonal, and between the two of a pair given by its number in `joined`; to either row where that is solved for.
  void add(std::int32_t domain, double value) { rows_.diagonal[static_cast<std::size_t>(domain)] += value; }
  void add_to_pair(std::size_t pair, double value);

  // Two pipes between the same two domains are two entries of a row. The pattern never changes.
  [[nodiscard]] const SymmetricRows& rows() const { return rows_; }
  // The same as a lower triangle, each column beginning with its diagonal.
  const SparseMatrix& lower();
  [[nodiscard]] const SparseMatrix& pattern() const { return lower_; }
  // Until they are assembled again.
  void forget_values();

  // gain: m2 per domain, by the network's flows in `step`.
  void add_up_flows(const Network& network, double step, std::vector<double>& gain) const;

  // How many domains depend on others in such a step: those whose pipes bring more than a quarter of what they store, pressure for pressure.
  [[nodiscard]] std::int64_t joined(const Network& network, double step) const;
  // What flows out of a domain [m2/s].
  [[nodiscard]] double outflow(const Network& network, std::int32_t domain) const;

  // Calls task(first, last) for parts of n items, each once, by whoever there is.
  template <class Task>
  void share(std::size_t n, const Task& task) const {
    share_items(workers_, static_cast<std::int64_t>(n), [&](std::int64_t first, std::int64_t last) {
      task(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
    });
  }

 private:
  void lay_out_lower();

  Workers* workers_;
  SymmetricRows rows_;
  std::vector<std::int32_t> pipe_;                                    // by entry; -1: a wellbore
  std::vector<std::pair<std::int32_t, std::int32_t>> place_of_pair_;  // its two entries
  SparseMatrix lower_;
  std::vector<std::int32_t> lower_place_;  // of an entry, in lower_'s values; -1: above the diagonal
};

}  // namespace hfrac
