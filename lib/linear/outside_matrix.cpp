// SPDX-License-Identifier: BSD-3-Clause
#include "linear/outside_matrix.hpp"

#include <numeric>
#include <string>

#include "core/error.hpp"

namespace hfrac {

void OutsideMatrix::share_out(const std::vector<std::int32_t>& entries) {
  size_ = static_cast<std::int64_t>(entries.size());
  const std::int64_t all = std::accumulate(entries.begin(), entries.end(), std::int64_t{0});
  const auto begin_of = [&](std::int64_t rank) {
    std::int64_t row = 0;
    for (std::int64_t before = 0; row < size_ && before * ranks_.size() < all * rank; ++row)
      before += entries[static_cast<std::size_t>(row)];
    return row;
  };
  rows_ = {begin_of(ranks_.rank()), ranks_.rank() + 1 < ranks_.size() ? begin_of(ranks_.rank() + 1) : size_};
}

void OutsideMatrix::prepare(const std::vector<std::int32_t>& row, const std::vector<std::int32_t>& column,
                            const std::vector<double>& value) {
  MatrixRows matrix;
  matrix.kind = static_cast<std::int32_t>(kind_);
  matrix.size = size_;
  matrix.first_row = rows_.first;
  matrix.end_row = rows_.end;
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
                  (kind_ == Kind::flow ? " for the flow step: " : " for the quasi-static step: ") +
                  reasons.data() +
                  (kind_ == Kind::flow ? "; use a smaller stepping.flow_step, or flow.solver = \"auto\""
                                       : "; use a smaller stepping.flow_step, or solver.factor = \"own\""));
}

void OutsideMatrix::release() noexcept {
  if (prepared_ != nullptr) ranks_.solver()->release(ranks_.solver()->user, prepared_);
  prepared_ = nullptr;
}

}  // namespace hfrac
