// SPDX-License-Identifier: BSD-3-Clause
#include "linear/outside_matrix.hpp"

#include <string>

#include "core/error.hpp"

namespace hfrac {

void OutsideMatrix::prepare(std::int64_t size, const std::vector<std::int32_t>& row,
                            const std::vector<std::int32_t>& column, const std::vector<double>& value) {
  const Rows mine = rows(size);
  MatrixRows matrix;
  matrix.kind = static_cast<std::int32_t>(kind_);
  matrix.size = size;
  matrix.first_row = mine.first;
  matrix.end_row = mine.end;
  matrix.count = static_cast<std::int64_t>(value.size());
  // A rank without entries has to say, too, that places are new.
  static constexpr std::int32_t nowhere = 0;
  const bool known = row.empty() && prepared_ != nullptr;
  if (!known) {
    matrix.row = row.empty() ? &nowhere : row.data();
    matrix.column = column.empty() ? &nowhere : column.data();
  }
  matrix.value = value.data();
  static_cast<void>(ranks_.any(false));
  agree(ranks_.solver()->prepare(ranks_.solver()->user, &matrix, &prepared_), "take the matrix");
}

int OutsideMatrix::solve(const double* right, double* x, double tolerance) {
  std::int32_t iterations = 0;
  static_cast<void>(ranks_.any(false));
  agree(ranks_.solver()->solve(ranks_.solver()->user, prepared_, right, x, tolerance, &iterations), "solve");
  return iterations;
}

void OutsideMatrix::agree(std::int32_t status, const char* what) const {
  if (!ranks_.any(status != 0)) return;
  // The text of the lowest rank that failed is everybody's.
  std::vector<char> reason;
  if (status != 0) {
    reason.resize(512);
    ranks_.solver()->reason(ranks_.solver()->user, reason.data(), static_cast<std::int64_t>(reason.size()));
    reason.back() = '\0';
  }
  const std::vector<char> reasons = ranks_.gather(reason);
  throw Error(ErrorKind::diverged,
              std::string("the linear solver from outside could not ") + what +
                  (kind_ == Kind::flow ? " of the flow step: " : " of the quasi-static step: ") +
                  reasons.data() +
                  (kind_ == Kind::flow
                       ? "; use a smaller stepping.flow_step, or flow.solver = \"auto\""
                       : "; use a smaller stepping.flow_step, or solver.factor = \"own\""));
}

void OutsideMatrix::release() noexcept {
  if (prepared_ != nullptr) ranks_.solver()->release(ranks_.solver()->user, prepared_);
  prepared_ = nullptr;
}

}  // namespace hfrac
