// SPDX-License-Identifier: BSD-3-Clause
// Progress goes to standard error, so that standard output holds results only.
#include "command/progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <utility>

#include "command/interrupt.hpp"
#include "command/standard_streams.hpp"

namespace hfrac::command {
namespace {

using namespace std::chrono_literals;
constexpr auto kTerminalPause = 150ms;  ///< between two changes of the line
constexpr auto kLogPause = 5000ms;      ///< between two lines of a log

/** As much of `text` as one line of the terminal holds: a line that wraps cannot be replaced. */
std::string one_line(const std::string& text) {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return text;
  return text.substr(0, size.ws_col - 1u);
}

}  // namespace

ProgressLine::ProgressLine(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), next_(Clock::now()) {
  if (!terminal_) next_ += kLogPause;
}

bool ProgressLine::due() const {
  return !quiet_ && Clock::now() >= next_;
}

void ProgressLine::show(const std::string& text) {
  if (due()) show_now(text);
}

void ProgressLine::show_now(const std::string& text) {
  if (quiet_) return;
  next_ = Clock::now() + (terminal_ ? kTerminalPause : kLogPause);
  if (terminal_)
    tell("\r{}\033[K", one_line(text));
  else
    tell("{}\n", text);
  line_open_ = terminal_;
}

void ProgressLine::end() {
  if (line_open_) tell_text("\n");
  line_open_ = false;
}

std::string readable_duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

PartsOfWork::PartsOfWork(ProgressLine& line, std::string part_name, int64_t whole)
    : line_(line), part_name_(std::move(part_name)), whole_(whole) {}

void PartsOfWork::show(const char* what) {
  if (!line_.due()) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string text = what;
  if (whole_ > 1) text += fmt::format(", {} {} of {}", part_name_, part_ + 1, whole_);
  text += fmt::format(", {} so far", readable_duration(seconds));
  // What a part takes is known once one is done; the one under way counts as half done.
  if (part_ > 0) {
    const auto done = static_cast<double>(part_) + 0.5, all = static_cast<double>(whole_);
    text += fmt::format(", about {} left", readable_duration(seconds / done * (all - done)));
  }
  line_.show_now(text);
}

int32_t show_parts(void* parts, double /*share*/, const char* what) {
  static_cast<PartsOfWork*>(parts)->show(what);
  return interrupted() ? 1 : 0;
}

}  // namespace hfrac::command
