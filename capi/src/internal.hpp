// SPDX-License-Identifier: BSD-3-Clause
// What every function of the C interface is wrapped in.
//
// - guarded: for calls without a simulation; guarded_sim: for calls on one. Both turn exceptions into status
// codes, keep
//   the text for hfrac_last_error, and give the library a floating-point environment of its own: a Fortran
//   host that traps on overflow must not be killed by a test for overflow in here, and a host that flushes
//   denormals must not change results. The host's environment, flags included, is back when the call returns.
// - call_host: the reverse, around the host's callbacks.
// - copy_text, read_struct, write_struct: the rules for texts and for structs that may be of another size
// than ours.
#pragma once

#include <atomic>
#include <cfenv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "hfrac/base.h"

namespace hfrac::capi {

// A text that can be stored when memory has run out, and needs no destructor at the end of a thread.
class ErrorText {
 public:
  void set(std::string_view text) noexcept;
  std::string_view get() const noexcept { return text_; }

 private:
  char text_[1024] = "";
};

// The text of the last failed call on this thread that had no simulation.
ErrorText& thread_error() noexcept;

// The default environment - nearest rounding, no traps, denormals kept - for as long as the guard lives.
class FloatingPointGuard {
 public:
  FloatingPointGuard() noexcept;
  ~FloatingPointGuard();
  FloatingPointGuard(const FloatingPointGuard&) = delete;
  FloatingPointGuard& operator=(const FloatingPointGuard&) = delete;

  // The guard entered last on this thread; nullptr outside the library.
  static const FloatingPointGuard* current() noexcept;
  const std::fenv_t& host() const noexcept { return host_; }

 private:
  std::fenv_t host_;
  const FloatingPointGuard* outer_;
};

// What hfrac_sim has in common with any handle to come: proof that it is one, its last error, its condition.
// Who is told what happens.
struct Listener {
  hfrac_log_fn function = nullptr;
  void* user = nullptr;
  std::int32_t level = 0;
  [[nodiscard]] bool hears(std::int32_t what) const { return function != nullptr && what <= level; }
};

struct HandleBase {
  static constexpr std::uint64_t alive = 0x68667261635f7369;  // "hfrac_si"

  HandleBase() = default;
  HandleBase(const HandleBase&) = delete;
  HandleBase& operator=(const HandleBase&) = delete;
  // Volatile, so that the compiler keeps the store though nothing may read it any more.
  ~HandleBase() { const_cast<volatile std::uint64_t&>(cookie) = 0; }

  std::uint64_t cookie = alive;
  mutable ErrorText last_error;
  mutable bool in_callback = false;
  Listener listener;
  bool poisoned = false;
  mutable std::atomic<const void*> occupant = nullptr;  // the thread that is in a call, as its own mark
};

// A thread in a call of a handle. A callback's calls are on the same thread and stay inside; another thread's are refused:
// Error(busy).
class Occupancy {
 public:
  explicit Occupancy(const HandleBase& handle);
  ~Occupancy();
  Occupancy(const Occupancy&) = delete;
  Occupancy& operator=(const Occupancy&) = delete;
  void give_up() { handle_ = nullptr; }  // the handle goes away

 private:
  const HandleBase* handle_;  // nullptr: entered from inside
};

// Status code of the exception being handled; its text goes to `text`. Only inside a catch block.
std::int32_t status_of_current_exception(ErrorText& text) noexcept;

// One for one HFRAC_ERR_*.
std::int32_t status_of(ErrorKind kind) noexcept;

template <class Function>
std::int32_t run_to_status(Function&& function) {
  if constexpr (std::is_void_v<std::invoke_result_t<Function>>) {
    std::forward<Function>(function)();
    return HFRAC_OK;
  } else {
    return std::forward<Function>(function)();
  }
}

// Runs `function`, which returns nothing or a status.
template <class Function>
std::int32_t guarded(Function&& function) noexcept {
  const FloatingPointGuard guard;
  try {
    return run_to_status(std::forward<Function>(function));
  } catch (...) {
    return status_of_current_exception(thread_error());
  }
}

// What a call may do to a simulation. Reading is allowed from inside its own callbacks; changing gives
// HFRAC_ERR_BUSY.
enum class Access { read, change };

// Hands `text` to the handle's listener if it hears that level and is not itself on the line. What it throws is dropped.
void tell(const HandleBase& handle, std::int32_t level, std::string_view text) noexcept;

// Throws Error(bad_handle) unless `handle` is one of ours and alive.
void require_handle(const HandleBase* handle);
// Throws Error(poisoned) or Error(busy) if the handle's condition forbids the call.
void require_condition(const HandleBase& handle, Access access);

// Runs `function` on a handle. Errors of the library itself or of memory while changing leave a state that
// cannot be known: the handle is poisoned. Errors of arguments and divergence leave it as it was, and whoever
// throws them sees to that.
template <class Handle, class Function>
std::int32_t guarded_sim(Handle* handle, Access access, Function&& function) noexcept {
  const FloatingPointGuard guard;
  std::optional<Occupancy> inside;
  try {
    require_handle(handle);
    inside.emplace(*handle);
  } catch (...) {
    return status_of_current_exception(thread_error());
  }
  try {
    require_condition(*handle, access);
    return run_to_status(std::forward<Function>(function));
  } catch (...) {
    const std::int32_t status = status_of_current_exception(handle->last_error);
    if constexpr (!std::is_const_v<Handle>) {
      const bool unknown_state =
          status == HFRAC_ERR_INTERNAL || status == HFRAC_ERR_MEMORY || status == HFRAC_ERR_POISONED;
      if (access == Access::change && unknown_state) handle->poisoned = true;
    }
    tell(*handle, HFRAC_LOG_ERROR, handle->last_error.get());
    return status;
  }
}

// Most functions that take `hfrac_sim *` change it, those that take `const hfrac_sim *` read it.
template <class Handle, class Function>
std::int32_t guarded_sim(Handle* handle, Function&& function) noexcept {
  constexpr Access access = std::is_const_v<Handle> ? Access::read : Access::change;
  return guarded_sim(handle, access, std::forward<Function>(function));
}

// A host's callback threw. The engine undoes the step that it interrupted.
class CallbackError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
// What a host's callback threw, as that. Only inside a catch block.
[[noreturn]] void rethrow_from_host();

// Calls the host back in the host's own floating-point environment. With a handle, changing it meanwhile is
// refused. Throws CallbackError if the callback throws.
template <class Function>
auto call_host(const HandleBase* handle, Function&& function) {
  struct Scope {
    explicit Scope(const HandleBase* h) : handle(h) {
      if (handle != nullptr) handle->in_callback = true;
      std::fegetenv(&ours);
      if (FloatingPointGuard::current() != nullptr) std::fesetenv(&FloatingPointGuard::current()->host());
    }
    ~Scope() {
      std::fesetenv(&ours);
      if (handle != nullptr) handle->in_callback = false;
    }
    const HandleBase* handle;
    std::fenv_t ours;
  };
  const Scope scope(handle);
  try {
    return std::forward<Function>(function)();
  } catch (...) {
    rethrow_from_host();
  }
}

// Throws Error(argument) "name is NULL."
[[noreturn]] void refuse_null(const char* name);
inline void require_not_null(const void* pointer, const char* name) {
  if (pointer == nullptr) refuse_null(name);
}

// Copies `text` with its final 0, cut between characters if too long. Throws Error(argument) if there is no
// room to copy to, or nothing was asked for.
void copy_text(std::string_view text, char* buffer, std::int32_t capacity, std::int32_t* needed);

// Larger than any struct of this interface will ever be; a struct_size above is garbage, not a newer caller.
inline constexpr std::int32_t struct_size_limit = 65536;

// Throws Error(struct_size) unless `size` can be that of a struct whose first member is an int32_t
// struct_size.
void require_struct_size(std::int32_t size, const char* name);

// A caller's struct seen at this library's size: what an older caller does not know keeps `defaults`; what a
// newer one has beyond must be zero.
template <class Struct>
Struct read_struct(const Struct* from, const Struct& defaults, const char* name) {
  static_assert(std::is_trivially_copyable_v<Struct>);
  require_not_null(from, name);
  std::int32_t size = 0;
  std::memcpy(&size, from, sizeof size);  // all of *from may be shorter than Struct
  require_struct_size(size, name);
  const auto given = static_cast<std::size_t>(size);
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  for (std::size_t i = sizeof(Struct); i < given; ++i) {
    if (bytes[i] != 0) {
      throw Error(ErrorKind::struct_size, std::string(name) +
                                              " was compiled against a newer header and uses a member this "
                                              "library does not know; update the library.");
    }
  }
  Struct full = defaults;
  std::memcpy(&full, from, given < sizeof(Struct) ? given : sizeof(Struct));
  full.struct_size = sizeof(Struct);
  return full;
}

// The way back: fills a caller's struct as far as the caller knows it; `struct_size` stays the caller's.
template <class Struct>
void write_struct(Struct* to, const Struct& full, const char* name) {
  static_assert(std::is_trivially_copyable_v<Struct>);
  require_not_null(to, name);
  std::int32_t size = 0;
  std::memcpy(&size, to, sizeof size);
  require_struct_size(size, name);
  const auto given = static_cast<std::size_t>(size);
  auto* bytes = reinterpret_cast<unsigned char*>(to);
  std::memcpy(bytes, &full, given < sizeof(Struct) ? given : sizeof(Struct));
  if (given > sizeof(Struct)) std::memset(bytes + sizeof(Struct), 0, given - sizeof(Struct));
  std::memcpy(bytes, &size, sizeof size);
}

// What an init function does: `size` is the struct's in the caller.
template <class Struct>
void put_defaults(Struct* to, std::int32_t size, const Struct& defaults, const char* name) {
  require_not_null(to, name);
  require_struct_size(size, name);
  to->struct_size = size;
  write_struct(to, defaults, name);
}

}  // namespace hfrac::capi
