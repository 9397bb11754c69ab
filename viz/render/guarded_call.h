// SPDX-License-Identifier: BSD-3-Clause
// What every function of the C interface does: one call at a time, no exception out, the reason kept for
// hfrac_viz_last_error.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace hfrac::viz {

// VTK's text cache is shared by the whole process and not guarded.
std::mutex& drawing_mutex();
// Lets other threads draw while it lives, inside a call that only waits.
class DrawingPause {
 public:
  DrawingPause() { drawing_mutex().unlock(); }
  ~DrawingPause() { drawing_mutex().lock(); }
  DrawingPause(const DrawingPause&) = delete;
  DrawingPause& operator=(const DrawingPause&) = delete;
};

void copy_text(const std::string& text, char* buffer, std::int32_t capacity, std::int32_t* needed);

// The last error or note on this thread.
const std::string& last_error();

// Something is not drawn because the run lacks its data: the call gives HFRAC_VIZ_INCOMPLETE and this sentence.
void leave_out(const std::string& sentence);

// Runs `work`, which may throw anything, and returns the status.
std::int32_t call(const std::function<void()>& work) noexcept;

std::string required_text(const char* text, const char* name);

}  // namespace hfrac::viz
