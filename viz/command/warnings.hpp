// SPDX-License-Identifier: BSD-3-Clause
// What the library warns of, on its way to the terminal and to summary.json, from where `hfrac info` and the report take it.
#pragma once

#include <hfrac/hfrac.h>

#include <string>

#include "command/progress_line.hpp"
#include "output/run_folder.hpp"

namespace hfrac::command {

class Warnings {
 public:
  Warnings(output::RunFolder& folder, ProgressLine& line, bool quiet);

  /** Has the library tell its warnings while it builds from `definition`. */
  void listen(hfrac_sim_def& definition);
  /** And while `sim` runs; this object must outlive that. */
  void listen(hfrac_sim* sim);

  void add(const std::string& text);

 private:
  static int32_t hear(void* warnings, int32_t level, const char* message);

  output::RunFolder& folder_;
  ProgressLine& line_;
  bool quiet_;
  int told_ = 0;  ///< on the terminal
  const hfrac_sim* sim_ = nullptr;
};

}  // namespace hfrac::command
