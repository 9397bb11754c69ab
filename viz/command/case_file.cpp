// SPDX-License-Identifier: BSD-3-Clause
// A case file is read over the defaults, so whatever is set before counts only where the file is silent.
#include "command/case_file.hpp"

#include <algorithm>
#include <thread>

#include "command/exit_code.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

void require_good(int32_t status) {
  if (status < 0) throw BadInput(run::error_text(status, nullptr));
}

}  // namespace

Definition load_case(const std::string& file, int64_t workers, const std::vector<double>& discs,
                     const std::vector<int64_t>& bonds) {
  Definition definition;
  definition.run_workers = std::clamp<int64_t>(std::thread::hardware_concurrency(), 1, 4);
  require_good(hfrac_sim_def_load(&definition, file.c_str()));
  if (workers > 0) definition.run_workers = workers;
  if (!discs.empty()) {
    definition.given_discs = discs.data();
    definition.given_disc_count = static_cast<int64_t>(discs.size() / 3);
  }
  if (!bonds.empty()) {
    definition.given_bonds = bonds.data();
    definition.given_bond_count = static_cast<int64_t>(bonds.size() / 2);
  }
  require_good(hfrac_sim_def_check_file(&definition, file.c_str()));
  return definition;
}

}  // namespace hfrac::command
