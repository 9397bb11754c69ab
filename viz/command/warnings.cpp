// SPDX-License-Identifier: BSD-3-Clause
#include "command/warnings.hpp"

#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

constexpr int kMostTold = 5;  // a run that does not come to rest says so at every step

}  // namespace

Warnings::Warnings(output::RunFolder& folder, ProgressLine& line, bool quiet)
    : folder_(folder), line_(line), quiet_(quiet) {}

void Warnings::listen(hfrac_sim_def& definition) {
  definition.log = hear;
  definition.log_user = this;
  definition.log_level = HFRAC_LOG_WARNING;
}

void Warnings::listen(hfrac_sim* sim) {
  sim_ = sim;
  run::require(hfrac_set_log(sim, hear, this, HFRAC_LOG_WARNING), sim);
}

void Warnings::add(const std::string& text) {
  folder_.add_warning(sim_ == nullptr ? 0 : run::state_of(sim_).step, text);
  if (quiet_ || told_ > kMostTold) return;
  line_.end();
  if (told_++ < kMostTold)
    tell("hfrac: warning: {}\n", text);
  else
    tell("hfrac: there are more warnings; summary.json has the first {}\n", output::kMostWarnings);
}

int32_t Warnings::hear(void* warnings, int32_t /*level*/, const char* message) {
  try {
    static_cast<Warnings*>(warnings)->add(message);
  } catch (const std::exception&) {  // it must not pass through the library; a warning is lost
  }
  return 0;
}

}  // namespace hfrac::command
