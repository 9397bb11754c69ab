// SPDX-License-Identifier: BSD-3-Clause
// The library that runs, which may be another than the one a host was compiled against.
#include <string>

#include "core/device.hpp"
#include "hfrac/base.h"
#include "internal.hpp"
#include "options/number_text.hpp"
#include "solid/kernels.hpp"

#define HFRAC_TEXT_OF(x) #x
#define HFRAC_TEXT(x) HFRAC_TEXT_OF(x)

#ifndef HFRAC_BUILD_TYPE
#define HFRAC_BUILD_TYPE "unknown"
#endif

using namespace hfrac::capi;

namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
constexpr const char* compiler = "gcc " __VERSION__;
#else
constexpr const char* compiler = "unknown compiler";
#endif

}  // namespace

std::int32_t hfrac_version(std::int32_t* major, std::int32_t* minor, std::int32_t* patch) {
  return guarded([&] {
    require_not_null(major, "major");
    require_not_null(minor, "minor");
    require_not_null(patch, "patch");
    *major = HFRAC_VERSION_MAJOR;
    *minor = HFRAC_VERSION_MINOR;
    *patch = HFRAC_VERSION_PATCH;
  });
}

std::int32_t hfrac_abi_version(std::int32_t* abi) {
  return guarded([&] {
    require_not_null(abi, "abi");
    *abi = HFRAC_ABI_VERSION;
  });
}

std::int32_t hfrac_devices(std::int32_t* count, char* buffer, std::int32_t capacity, std::int32_t* needed) {
  return guarded([&] {
    require_not_null(count, "count");
    const hfrac::DeviceList list = hfrac::list_devices();
    std::string text = list.why_none;
    for (const auto& device : list.devices) {
      constexpr double gib = 1024.0 * 1024.0 * 1024.0;
      text += (text.empty() ? "" : "\n") + device.name + ", " +
              hfrac::rounded_text(static_cast<double>(device.memory_bytes) / gib) + " GiB";
    }
    copy_text(text, buffer, capacity, needed);
    *count = static_cast<std::int32_t>(list.devices.size());
  });
}

std::int32_t hfrac_build_info(char* buffer, std::int32_t capacity, std::int32_t* needed) {
  return guarded([&] {
    const std::string text = "hfrac " HFRAC_TEXT(HFRAC_VERSION_MAJOR) "." HFRAC_TEXT(
                                 HFRAC_VERSION_MINOR) "." HFRAC_TEXT(HFRAC_VERSION_PATCH) ", " +
                             std::string(compiler) + ", " HFRAC_BUILD_TYPE ", kernels " + hfrac::kernel_isa();
    copy_text(text, buffer, capacity, needed);
  });
}
