// SPDX-License-Identifier: BSD-3-Clause
// A synthetic run per test, and calls of the C interface that keep the error text.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "hfrac/viz.h"
#include "synthetic_run.h"

namespace hfrac::viz_test {

struct Result {
  std::int32_t status = 0;
  std::string text;
};

// Of the last call on this thread.
inline std::string last_error() {
  std::array<char, 4000> text{};
  hfrac_viz_last_error(text.data(), text.size(), nullptr);
  return text.data();
}

inline Result result_of(std::int32_t status) {
  return {status, last_error()};
}

class VizTest : public testing::Test {
 protected:
  VizTest() { hfrac_viz_options_init(&options, sizeof options); }

  const std::filesystem::path& folder() const { return temporary_.path(); }
  std::filesystem::path file(const std::string& name) const { return folder() / name; }

  Result render_run(hfrac_viz_progress_fn progress = nullptr, void* user = nullptr) {
    return result_of(hfrac_viz_render_run(folder().c_str(), &options, progress, user));
  }

  Result render_picture(std::int32_t picture, const std::filesystem::path& path) {
    return result_of(hfrac_viz_render_picture(folder().c_str(), picture, path.c_str(), &options));
  }

  Result render_movie(const std::filesystem::path& path) {
    return result_of(hfrac_viz_render_movie(folder().c_str(), path.c_str(), &options, nullptr, nullptr));
  }

  // Files in the folder that a failed or stopped call must not leave behind.
  int leftovers(const std::filesystem::path& where) const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(where)) {
      count += entry.path().extension() == ".tmp" ? 1 : 0;
    }
    return count;
  }

  hfrac_viz_options options;
  SyntheticRun run;

 private:
  TemporaryFolder temporary_;
};

}  // namespace hfrac::viz_test
