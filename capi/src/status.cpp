// SPDX-License-Identifier: BSD-3-Clause
// Status codes as sentences, and the text of the last error.
#include "hfrac/base.h"
#include "internal.hpp"
#include "sim_handle.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

struct StatusText {
  std::int32_t status;
  const char* text;
};

#define HFRAC_STATUS_ROW(name, value, text) {value, text},
constexpr StatusText status_texts[] = {HFRAC_STATUS_LIST(HFRAC_STATUS_ROW)};
#undef HFRAC_STATUS_ROW

}  // namespace

std::int32_t hfrac_status_text(std::int32_t status, char* buffer, std::int32_t capacity,
                               std::int32_t* needed) {
  return guarded([&] {
    for (const auto& row : status_texts) {
      if (row.status == status) return copy_text(row.text, buffer, capacity, needed);
    }
    throw Error(ErrorKind::argument,
                "status = " + std::to_string(status) + " is not a status code of this library.");
  });
}

// Asking for the last error must not replace it, so faults of this call itself are told by the status alone.
std::int32_t hfrac_last_error(const hfrac_sim* sim, char* buffer, std::int32_t capacity,
                              std::int32_t* needed) {
  const FloatingPointGuard guard;
  ErrorText unused;
  try {
    if (sim == nullptr) {
      copy_text(thread_error().get(), buffer, capacity, needed);
      return HFRAC_OK;
    }
    require_handle(sim);
    const Occupancy inside(*sim);
    copy_text(sim->last_error.get(), buffer, capacity, needed);
    return HFRAC_OK;
  } catch (...) {
    return status_of_current_exception(unused);
  }
}
