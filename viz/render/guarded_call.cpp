// SPDX-License-Identifier: BSD-3-Clause
#include "guarded_call.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

#include "failure.h"
#include "render_run.h"
#include "run/engine_call.hpp"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

struct CallState {
  bool inside = false;
  std::string text;  // of the last error, or of what was left out
};

CallState& state() {
  thread_local CallState of_thread;
  return of_thread;
}

struct InsideCall {
  InsideCall() { state().inside = true; }
  ~InsideCall() { state().inside = false; }
  InsideCall(const InsideCall&) = delete;
  InsideCall& operator=(const InsideCall&) = delete;
};

std::int32_t failed(std::int32_t status, const char* text) {
  state().text = text;
  return status;
}

std::int32_t guarded(const std::function<void()>& work) {
  if (state().inside) return failed(HFRAC_ERR_BUSY, "called from inside a progress callback of the renderer");
  state().text.clear();
  try {
    const std::lock_guard lock(drawing_mutex());
    const InsideCall inside;
    VtkMessages messages;
    work();
    if (!state().text.empty()) return HFRAC_VIZ_INCOMPLETE;
    return HFRAC_OK;
  } catch (const Stopped&) {
    return HFRAC_STOPPED;
  } catch (const Failure& failure) {
    return failed(failure.status(), failure.what());
  } catch (const ReadError& error) {
    return failed(HFRAC_VIZ_ERR_READ, error.what());
  } catch (const WriteError& error) {
    return failed(HFRAC_VIZ_ERR_WRITE, error.what());
  } catch (const EngineError& error) {
    return failed(error.status(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(HFRAC_ERR_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(HFRAC_ERR_INTERNAL, error.what());
  }
}

}  // namespace

std::mutex& drawing_mutex() {
  static std::mutex mutex;
  return mutex;
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

const std::string& last_error() {
  return state().text;
}

void leave_out(const std::string& sentence) {
  std::string& text = state().text;
  if (!text.empty()) text += "; ";
  text += sentence;
}

std::int32_t call(const std::function<void()>& work) noexcept {
  try {
    return guarded(work);
  } catch (const std::bad_alloc&) {
    return HFRAC_ERR_MEMORY;
  } catch (...) {
    return HFRAC_ERR_INTERNAL;
  }
}

std::string required_text(const char* text, const char* name) {
  if (text == nullptr || text[0] == 0) fail_argument(std::string(name) + " is NULL or empty");
  return text;
}

}  // namespace hfrac::viz
