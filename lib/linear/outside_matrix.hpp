// SPDX-License-Identifier: BSD-3-Clause
// Linear equations given to a solver from outside the library (hfrac/linear_solver.h: PETSc, or a host's own).
//
// Every rank gives the entries of its share of the rows and gets all of the solution, so what the solver makes of the matrix is
// spread over the ranks. Before each call ranks tell each other that they are there, and after it whether it went well: a solver may
// wait for a rank without looking whether it has gone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ranks.hpp"

namespace hfrac {

// As hfrac_matrix and hfrac_linear_solver.
struct MatrixRows {
  std::int32_t struct_size = sizeof(MatrixRows), kind = 0;
  std::int64_t size = 0, first_row = 0, end_row = 0, count = 0;
  const std::int32_t *row = nullptr, *column = nullptr;
  const double* value = nullptr;
};

struct OutsideSolver {
  void* user = nullptr;
  std::int32_t (*prepare)(void* user, const MatrixRows* matrix, void** prepared) = nullptr;
  std::int32_t (*solve)(void* user, void* prepared, const double* right, double* x, double tolerance,
                        std::int32_t* iterations) = nullptr;
  std::int32_t (*release)(void* user, void* prepared) = nullptr;
  std::int32_t (*reason)(void* user, char* text, std::int64_t size) = nullptr;
};

class OutsideMatrix {
 public:
  enum class Kind : std::int32_t { flow = 1, tangent = 2 };

  // `ranks` have a solver.
  OutsideMatrix(const Ranks& ranks, Kind kind) : ranks_(ranks), kind_(kind) {}
  OutsideMatrix(const OutsideMatrix&) = delete;
  OutsideMatrix& operator=(const OutsideMatrix&) = delete;
  ~OutsideMatrix() { release(); }

  // Rows of a rank.
  struct Rows {
    std::int64_t first = 0, end = 0;
    [[nodiscard]] bool hold(std::int64_t row) const { return row >= first && row < end; }
  };
  // This rank's share of rows with so many entries each, about as many for every rank.
  void share_out(const std::vector<std::int32_t>& entries);
  [[nodiscard]] Rows rows() const { return rows_; }

  // Entries of this rank's rows; with empty lists of places those of the call before. Throw Error(diverged) on all ranks if it fails on one.
  void prepare(const std::vector<std::int32_t>& row, const std::vector<std::int32_t>& column,
               const std::vector<double>& value);
  // Returns iterations.
  int solve(const double* right, double* x, double tolerance);

 private:
  void release() noexcept;
  void agree(std::int32_t status, const char* what) const;

  Ranks ranks_;
  Kind kind_;
  std::int64_t size_ = 0;
  Rows rows_;
  void* prepared_ = nullptr;
};

}  // namespace hfrac
