// SPDX-License-Identifier: BSD-3-Clause
// In which order workers may make the rows of a sparse factor together.
//
// A row needs the rows beneath it in the elimination tree alone (Liu 1990). So the tree is cut into subtrees of like work, which workers
// take as they come; and whoever makes the last row that one above them waits for makes that one as well, and so on to the top. Where it
// is cut follows from the matrix alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace hfrac {

class Subtrees {
 public:
  // parent: of each row, a later one; -1: none. work: of each row, in any unit.
  void cut(const std::vector<std::int32_t>& parent, const std::vector<double>& work);
  // Of all rows.
  [[nodiscard]] double work() const { return work_; }

  // Before each time that rows are made.
  void begin();
  // Calls make(row) for rows that wait for none, until all are taken: every worker once, or one alone.
  template <class Make>
  void take(const Make& make) {
    for (auto t = std::atomic_ref(next_)++; t < count(); t = std::atomic_ref(next_)++) {
      const auto subtree = rows(t);
      for (const auto row : subtree) make(row);
      for (const auto row : subtree) climb(row, make);
    }
  }

 private:
  // Subtrees, those of the most work first. Several small ones count as one.
  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(start_.size()) - 1; }
  // The rows of one, ascending.
  [[nodiscard]] std::span<const std::int32_t> rows(std::int32_t subtree) const {
    const auto k = static_cast<std::size_t>(subtree);
    return std::span(rows_).subspan(static_cast<std::size_t>(start_[k]),
                                    static_cast<std::size_t>(start_[k + 1] - start_[k]));
  }
  // What waits above for that row, as far as it waits for nothing else any more.
  template <class Make>
  void climb(std::int32_t row, const Make& make) {
    for (auto above = above_[static_cast<std::size_t>(row)]; above >= 0;
         above = above_[static_cast<std::size_t>(above)]) {
      if (--std::atomic_ref(waits_[static_cast<std::size_t>(above)]) > 0) return;
      make(above);
    }
  }

  std::vector<std::int32_t> rows_, start_{0};
  std::vector<std::int32_t> above_;        // by row: that above the subtrees which waits for it; -1: none
  std::vector<std::int32_t> all_, waits_;  // by row: for how many it waits in all, and still
  std::int32_t next_ = 0;
  double work_ = 0.0;
};

}  // namespace hfrac
