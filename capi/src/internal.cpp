// SPDX-License-Identifier: BSD-3-Clause
#include "internal.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace hfrac::capi {
namespace {

// Length of the longest beginning of `text` of at most `limit` bytes that does not end inside a UTF-8
// character.
std::size_t cut_length(std::string_view text, std::size_t limit) {
  if (text.size() <= limit) return text.size();
  std::size_t length = limit;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
  return length;
}

thread_local ErrorText thread_text;
thread_local const FloatingPointGuard* innermost_guard = nullptr;
thread_local const char thread_mark = 0;  // its address is the thread's

}  // namespace

void ErrorText::set(std::string_view text) noexcept {
  const std::size_t length = cut_length(text, sizeof text_ - 1);
  std::copy_n(text.data(), length, text_);
  text_[length] = '\0';
}

ErrorText& thread_error() noexcept {
  return thread_text;
}

FloatingPointGuard::FloatingPointGuard() noexcept : outer_(innermost_guard) {
  std::fegetenv(&host_);
  std::fesetenv(FE_DFL_ENV);
  innermost_guard = this;
}

FloatingPointGuard::~FloatingPointGuard() {
  innermost_guard = outer_;
  std::fesetenv(&host_);
}

const FloatingPointGuard* FloatingPointGuard::current() noexcept {
  return innermost_guard;
}

std::int32_t status_of(ErrorKind kind) noexcept {
  // In the order of ErrorKind.
  static constexpr std::array statuses = {HFRAC_ERR_ARGUMENT,    HFRAC_ERR_BAD_HANDLE, HFRAC_ERR_STRUCT_SIZE,
                                          HFRAC_ERR_UNKNOWN_KEY, HFRAC_ERR_CASE_FILE,  HFRAC_ERR_MODEL,
                                          HFRAC_ERR_DIVERGED,    HFRAC_ERR_COLLAPSED,  HFRAC_ERR_MEMORY,
                                          HFRAC_ERR_BUSY,        HFRAC_ERR_POISONED,   HFRAC_ERR_EXCHANGE,
                                          HFRAC_ERR_DEVICE,      HFRAC_ERR_FILE,       HFRAC_ERR_INTERNAL};
  static_assert(statuses.size() == static_cast<std::size_t>(ErrorKind::internal) + 1 &&
                statuses[static_cast<std::size_t>(ErrorKind::diverged)] == HFRAC_ERR_DIVERGED &&
                statuses[static_cast<std::size_t>(ErrorKind::busy)] == HFRAC_ERR_BUSY);
  return statuses[static_cast<std::size_t>(kind)];
}

std::int32_t status_of_current_exception(ErrorText& text) noexcept {
  try {
    throw;
  } catch (const Error& error) {
    text.set(error.what());
    return status_of(error.kind());
  } catch (const CallbackError& error) {
    text.set(error.what());
    return HFRAC_ERR_CALLBACK;
  } catch (const std::bad_alloc&) {
    text.set("Out of memory; lower packing.disc_count or free memory.");
    return HFRAC_ERR_MEMORY;
  } catch (const std::exception& error) {
    text.set(error.what());
    return HFRAC_ERR_INTERNAL;
  } catch (...) {
    text.set("An exception that is not the library's own came through.");
    return HFRAC_ERR_INTERNAL;
  }
}

void rethrow_from_host() {
  try {
    throw;
  } catch (const std::exception& error) {
    throw CallbackError("a callback threw: " + std::string(error.what()));
  } catch (...) {
    throw CallbackError("a callback threw what is no std::exception.");
  }
}

void tell(const HandleBase& handle, std::int32_t level, std::string_view text) noexcept {
  if (!handle.listener.hears(level) || handle.in_callback) return;
  try {
    const std::string sentence(text);
    call_host(&handle,
              [&] { return handle.listener.function(handle.listener.user, level, sentence.c_str()); });
  } catch (...) {  // a listener's exception must not become the call's failure
  }
}

void require_handle(const HandleBase* handle) {
  if (handle == nullptr) throw Error(ErrorKind::bad_handle, "sim is NULL; create it with hfrac_sim_create.");
  if (handle->cookie != HandleBase::alive) {
    throw Error(ErrorKind::bad_handle,
                "sim is not a living simulation: never created, or destroyed already.");
  }
}

void require_condition(const HandleBase& handle, Access access) {
  if (handle.poisoned) {
    // The text of the error that did it stays.
    throw Error(ErrorKind::poisoned, std::string(handle.last_error.get()));
  }
  if (access == Access::change && handle.in_callback) {
    throw Error(ErrorKind::busy,
                "This call would change the simulation from inside its own callback; return from it first.");
  }
}

Occupancy::Occupancy(const HandleBase& handle) : handle_(&handle) {
  const void* found = nullptr;
  if (handle.occupant.compare_exchange_strong(found, &thread_mark, std::memory_order_acquire)) return;
  handle_ = nullptr;
  if (found == &thread_mark) return;
  throw Error(ErrorKind::busy,
              "Another thread is in a call of this simulation; one simulation belongs to one thread at a "
              "time. Wait for "
              "that call to return.");
}

Occupancy::~Occupancy() {
  if (handle_ != nullptr) handle_->occupant.store(nullptr, std::memory_order_release);
}

void refuse_null(const char* name) {
  throw Error(ErrorKind::argument, std::string(name) + " is NULL.");
}

void copy_text(std::string_view text, char* buffer, std::int32_t capacity, std::int32_t* needed) {
  if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
  if (capacity > 0) require_not_null(buffer, "buffer");
  if (capacity == 0 && needed == nullptr) {
    throw Error(ErrorKind::argument, "capacity is 0 and needed is NULL: nothing is asked for.");
  }
  if (text.size() >= static_cast<std::size_t>(INT32_MAX))
    throw Error(ErrorKind::internal, "The text is too long.");
  if (capacity > 0) {
    const std::size_t length = cut_length(text, static_cast<std::size_t>(capacity) - 1);
    std::copy_n(text.data(), length, buffer);
    buffer[length] = '\0';
  }
  if (needed != nullptr) *needed = static_cast<std::int32_t>(text.size()) + 1;
}

void require_struct_size(std::int32_t size, const char* name) {
  // All structs are made of 8-byte slots, so another multiple is no size any header has ever had.
  if (size >= 8 && size % 8 == 0 && size <= struct_size_limit) return;
  throw Error(ErrorKind::struct_size, std::string(name) + ".struct_size = " + std::to_string(size) +
                                          " is not the size of that struct; set it to sizeof of the struct, "
                                          "for a definition with hfrac_sim_def_init.");
}

}  // namespace hfrac::capi
