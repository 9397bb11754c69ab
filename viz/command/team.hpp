// SPDX-License-Identifier: BSD-3-Clause
// The processes that mpirun (or Slurm's srun) started together: `mpirun -n 8 hfrac run CASE -o DIR`. All build and step one simulation
// (hfrac/exchange.h); the first writes and speaks, the others follow. Without a launcher, and without libhfrac_mpi, the program is
// alone and needs neither. With --one-model a machine's processes have one model: the first has it, with workers on the cores of all, and the
// others rest.
#pragma once

#ifndef HFRAC_ENABLE_UNSTABLE
#define HFRAC_ENABLE_UNSTABLE
#endif
#include <hfrac/hfrac.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "command/exit_code.hpp"
#include "output/piece_files.hpp"

namespace CLI {
class App;
}

namespace hfrac::command {

/** As the launcher says; 1 without one. */
int processes_started();

/** The flag of a command that runs over them. */
void add_one_model(CLI::App& command, bool& one_model);

class Team {
 public:
  /** Joins the others, if there are any; with `one_model` only the first of each machine has a model, and workers for all of them there.
   * Throws BadInput if the launcher says so, but there is no libhfrac_mpi. */
  explicit Team(bool one_model = false);
  /** Unless done() was called, the others are told that this process has failed. */
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  [[nodiscard]] bool alone() const { return exchange_.size == 1; }
  [[nodiscard]] bool follows() const { return exchange_.rank > 0; }
  /** Has no model: another on this machine has it. Its end is this one's. */
  [[nodiscard]] bool rests() const { return processes_here_ == 0; }
  /** Until the other has come to its end, whatever signals come meanwhile. */
  ExitCode rest();
  /** Workers of the process that has the model, where one by itself would have so many. */
  [[nodiscard]] int64_t workers(int64_t of_one) const {
    return processes_here_ * std::max<int64_t>(1, of_one);
  }
  /** hfrac_sim_create on all of them, with PETSc where the case asks for it. Throws BadInput if there is no libhfrac_petsc. */
  int32_t create(const hfrac_sim_def& definition, hfrac_sim** sim) const;
  /** What the first process has, on all. */
  [[nodiscard]] std::string share(std::string bytes) const;
  /** For files that all of them write. */
  [[nodiscard]] output::Writers writers() const;
  /** All have come to the end. */
  void done();

 private:
  /** The table over all; from then on end_ ends MPI. */
  int32_t join(hfrac_exchange& exchange) const;

  hfrac_exchange exchange_{};
  int32_t processes_here_ = 1;
  mutable int32_t (*end_)(int32_t failed) = nullptr;
};

}  // namespace hfrac::command
