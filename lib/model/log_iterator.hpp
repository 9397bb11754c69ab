// SPDX-License-Identifier: BSD-3-Clause
// Goes over a log whose records are put together when they are read.
#pragma once

#include <cstddef>
#include <iterator>

namespace hfrac {

template <class Log>
class LogIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = typename Log::value_type;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = value_type;

  LogIterator(const Log* log, std::size_t at) : log_(log), at_(at) {}
  value_type operator*() const { return (*log_)[at_]; }
  LogIterator& operator++() {
    ++at_;
    return *this;
  }
  LogIterator operator++(int) { return {log_, at_++}; }
  bool operator==(const LogIterator&) const = default;

 private:
  const Log* log_;
  std::size_t at_;
};

}  // namespace hfrac
