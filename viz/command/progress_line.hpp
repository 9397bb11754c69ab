// SPDX-License-Identifier: BSD-3-Clause
// Progress for a person: on a terminal one line that changes, in a log a plain line every few seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace hfrac::command {

class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { end(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /** Whether a line shown now would be printed; ask first where making the text costs. */
  bool due() const;
  /** Shows `text` if it is due. */
  void show(const std::string& text);
  /** Shows `text` in any case. */
  void show_now(const std::string& text);
  /** Leaves the changing line, so that other text can follow. */
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point next_;
};

/** "12 s", "3 min", "2.5 h". */
std::string readable_duration(double seconds);

/** Work of `whole` parts of about the same length: "packing 2 of 6, 40 s so far, about 3 min left". */
class PartsOfWork {
 public:
  PartsOfWork(ProgressLine& line, std::string part_name, int64_t whole);
  /** Begins part `part`, counted from 0. */
  void begin(int64_t part) { part_ = part; }
  void show(const char* what);

 private:
  using Clock = std::chrono::steady_clock;
  ProgressLine& line_;
  std::string part_name_;
  int64_t whole_, part_ = 0;
  Clock::time_point start_ = Clock::now();
};

/** For hfrac_progress_fn; the user's pointer is a PartsOfWork. Stops when the user interrupts. */
int32_t show_parts(void* parts, double share, const char* what);

}  // namespace hfrac::command
