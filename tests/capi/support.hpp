// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the C interface share: definitions, texts, and files that vanish.
#pragma once

#include <hfrac/hfrac.h>
#include <unistd.h>
#include <hfrac/definition.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace testing_capi {

inline hfrac::Definition new_def() {
  return {};
}

// A definition that hfrac_sim_def_check accepts: one well in the middle, stresses above the formation's
// pressure.
inline hfrac::Definition sound_def() {
  hfrac::Definition def = new_def();
  def.stress_sigma_Hmax = 40e6;
  def.stress_sigma_hmin = 30e6;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = 50.0;
  def.wells[0].y = 50.0;
  def.wells[0].radius = 6.0;
  def.wells[0].pressure = 45e6;
  return def;
}

inline std::string last_error(const hfrac_sim* sim = nullptr) {
  char text[2048];
  return hfrac_last_error(sim, text, sizeof text, nullptr) == HFRAC_OK ? text : "hfrac_last_error failed";
}

// The definition as text, "" on error.
inline std::string written(const hfrac_sim_def& def) {
  int32_t needed = 0;
  if (hfrac_sim_def_write(&def, nullptr, 0, &needed) != HFRAC_OK) return "";
  std::string text(static_cast<std::size_t>(needed), '\0');
  if (hfrac_sim_def_write(&def, text.data(), needed, nullptr) != HFRAC_OK) return "";
  text.pop_back();
  return text;
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern =
        (std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : std::string("/tmp")) + "/hfrac_XXXXXX";
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file() const { return path_ + "/case.toml"; }
  std::string write(const std::string& text) const {
    std::ofstream(file(), std::ios::binary) << text;
    return file();
  }
  void write(const std::string& text, const std::string& name) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
  }

 private:
  std::string path_;
};

}  // namespace testing_capi
