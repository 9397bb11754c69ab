// SPDX-License-Identifier: BSD-3-Clause
// Any text as a case file: refused with a sentence and nothing changed, or taken; then what is written of it is the same
// definition when it is read again.
#include <hfrac/hfrac.h>
#include <sys/mman.h>
#include <unistd.h>
#include <hfrac/definition.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

void demand(bool good) {
  if (!good) std::abort();
}

hfrac::Definition fresh() {
  return {};
}

// A file in memory, since the library reads files only.
int32_t load(hfrac_sim_def& def, const void* text, std::size_t size) {
  const int file = ::memfd_create("case.toml", MFD_CLOEXEC);
  demand(file >= 0 && ::write(file, text, size) == static_cast<::ssize_t>(size));
  const int32_t status = hfrac_sim_def_load(&def, ("/proc/self/fd/" + std::to_string(file)).c_str());
  ::close(file);
  return status;
}

std::string text_of(const hfrac_sim_def& def) {
  int32_t needed = 0;
  demand(hfrac_sim_def_write(&def, nullptr, 0, &needed) == HFRAC_OK);
  std::string text(static_cast<std::size_t>(needed), '\0');
  demand(hfrac_sim_def_write(&def, text.data(), needed, &needed) == HFRAC_OK);
  text.pop_back();
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hfrac::Definition def = fresh();
  const hfrac_sim_def before = def;
  if (load(def, data, size) != HFRAC_OK) {
    char text[2048];
    demand(hfrac_last_error(nullptr, text, sizeof text, nullptr) == HFRAC_OK && text[0] != '\0');
    demand(std::memcmp(&def, &before, sizeof def) == 0);
    return 0;
  }
  hfrac_sim_def_check(&def);
  const std::string written = text_of(def);
  hfrac::Definition again = fresh();
  demand(load(again, written.data(), written.size()) == HFRAC_OK);
  demand(text_of(again) == written);
  return 0;
}
