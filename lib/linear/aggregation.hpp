// SPDX-License-Identifier: BSD-3-Clause
// Which rows of a symmetric matrix are merged into one, for the next coarser level of multigrid.hpp, and the sums of their equations
// (Notay 2010, Electron. Trans. Numer. Anal. 37, 123-146). All of it follows from the matrix alone, whoever does it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "linear/sparse.hpp"

namespace hfrac {

// Both triangles by rows, without the diagonal.
struct SymmetricRows {
  std::vector<std::int32_t> start, column;
  UnfilledVector value, diagonal;
  std::vector<double> inside;  // of merged rows: the largest entry by which they were joined, positive

  [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(diagonal.size()); }
  // Of the lower triangle, each column beginning with its diagonal.
  void assign(const SparseMatrix& lower);
};

// The rows that have the same number, ascending; negative: in no part.
class RowsByPart {
 public:
  RowsByPart() = default;
  RowsByPart(const std::vector<std::int32_t>& part, std::int32_t parts);
  [[nodiscard]] std::span<const std::int32_t> of(std::int32_t part) const {
    const auto p = static_cast<std::size_t>(part);
    return std::span(row_).subspan(static_cast<std::size_t>(first_[p]),
                                   static_cast<std::size_t>(first_[p + 1] - first_[p]));
  }
  // All of them, part by part, and where each part begins.
  [[nodiscard]] const std::vector<std::int32_t>& rows() const { return row_; }
  [[nodiscard]] const std::vector<std::int32_t>& first() const { return first_; }

 private:
  std::vector<std::int32_t> first_, row_;
};

// Of rows first to last - 1, those that hardly depend on others get -1 in `number`, the others 0.
void mark_the_joined(const SymmetricRows& rows, std::int64_t first, std::int64_t last,
                     std::vector<std::int32_t>& number);
// Numbers all that were marked 0. Returns how many there are.
std::int32_t number_the_joined(std::vector<std::int32_t>& number);

// Joins each row with the one that it is most strongly joined to among those still alone; who finds none alone joins that one's
// pair. Rows for which `pair` is -1 keep it. Returns how many pairs there are.
std::int32_t join_in_pairs(const SymmetricRows& rows, std::vector<std::int32_t>& pair);

// The sums of the equations of rows that have the same number in `part`, of which there are `parts`. place: work space.
void merge_rows(const SymmetricRows& rows, const std::vector<std::int32_t>& part, std::int32_t parts,
                std::vector<std::int32_t>& place, SymmetricRows& merged);

}  // namespace hfrac
