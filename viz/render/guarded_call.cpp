// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_call.h"

#include <algorithm>
#include <cstring>

namespace hfrac::viz {

std::mutex& drawing_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool& inside_call() {
  thread_local bool inside = false;
  return inside;
}

void copy_text(const std::string& text, char* buffer, std::int32_t capacity, std::int32_t* needed) {
  if (needed != nullptr) *needed = static_cast<std::int32_t>(text.size() + 1);
  if (buffer == nullptr || capacity <= 0) return;
  std::size_t length = std::min(text.size(), static_cast<std::size_t>(capacity) - 1);
  // Do not cut a UTF-8 letter in two.
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
    --length;
  std::memcpy(buffer, text.data(), length);
  buffer[length] = 0;
}

std::string required_text(const char* text, const char* name) {
  if (text == nullptr || text[0] == 0) fail_argument(std::string(name) + " is NULL or empty");
  return text;
}

void check_range(const char* name, int value, int lowest, int highest, bool zero_allowed) {
  if ((value >= lowest && value <= highest) || (zero_allowed && value == 0)) return;
  fail_argument(std::string(name) + " is " + std::to_string(value) + "; allowed: " + std::to_string(lowest) +
                " to " + std::to_string(highest) + (zero_allowed ? ", or 0" : ""));
}

Progress wrapped(hfrac_viz_progress_fn progress, void* user) {
  if (progress == nullptr) return {};
  return [progress, user](double fraction, const std::string& what) {
    return progress(user, fraction, what.c_str()) != 0;
  };
}

}  // namespace hfrac::viz
