// SPDX-License-Identifier: BSD-3-Clause
// What every function of the C interface does: arguments checked, one call at a time, no exception out, the
// reason into the caller's buffer.
#pragma once

#include <cstdint>
#include <exception>
#include <mutex>
#include <new>
#include <string>

#include "failure.h"
#include "hfrac/viz.h"
#include "render_run.h"
#include "vtk_messages.h"

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
// Whether this thread is inside a call.
bool& inside_call();

void copy_text(const std::string& text, char* buffer, std::int32_t capacity, std::int32_t* needed);

struct InsideCall {
  InsideCall() { inside_call() = true; }
  ~InsideCall() { inside_call() = false; }
  InsideCall(const InsideCall&) = delete;
  InsideCall& operator=(const InsideCall&) = delete;
};

// Runs `work`, which may throw anything, and returns the status; `text` gets the reason.
template <class Work>
std::int32_t guarded(std::string& text, const Work& work) {
  try {
    if (inside_call()) {
      text = "called from inside a progress callback of the renderer";
      return HFRAC_ERR_BUSY;
    }
    const std::lock_guard lock(drawing_mutex());
    const InsideCall inside;
    VtkMessages messages;
    work();
    return HFRAC_OK;
  } catch (const Stopped&) {
    return HFRAC_STOPPED;
  } catch (const Failure& failure) {
    text = failure.what();
    return failure.status();
  } catch (const std::bad_alloc&) {
    return HFRAC_ERR_MEMORY;
  } catch (const std::exception& error) {
    text = error.what();
    return HFRAC_ERR_INTERNAL;
  } catch (...) {
    text = "an error without a description";
    return HFRAC_ERR_INTERNAL;
  }
}

// As above, with the text copied to the caller.
template <class Work>
std::int32_t call(char* error, std::int32_t capacity, std::int32_t* needed, const Work& work) noexcept {
  try {
    std::string text;
    const std::int32_t status = guarded(text, work);
    if (status == HFRAC_ERR_MEMORY) text = "out of memory";
    copy_text(text, error, capacity, needed);
    return status;
  } catch (...) {
    copy_text({}, error, capacity, needed);
    return HFRAC_ERR_MEMORY;
  }
}

std::string required_text(const char* text, const char* name);
void check_range(const char* name, int value, int lowest, int highest, bool zero_allowed = false);
Progress wrapped(hfrac_viz_progress_fn progress, void* user);

}  // namespace hfrac::viz
