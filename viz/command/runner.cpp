// SPDX-License-Identifier: BSD-3-Clause
// The order of a run: read the case, claim the folder, build the model, and only then touch an earlier run's
// files. Whatever goes wrong before that point leaves the disk as it was.
#include "command/runner.hpp"

#include <fmt/format.h>

#include <vector>

#include "command/case_file.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/run_to_end.hpp"
#include "command/standard_streams.hpp"
#include "output/disc_file.hpp"
#include "output/host_cells.hpp"
#include "output/known_files.hpp"
#include "output/run_folder.hpp"
#include "output/safe_file.hpp"

namespace hfrac::command {
namespace {

void refuse_earlier_run(const RunRequest& request) {
  if (request.overwrite) return;
  const auto files = output::files_of_a_run(request.folder);
  if (!files.empty())
    throw BadInput(fmt::format(
        "'{}' already holds {} file(s) of a run, e.g. {}; choose another folder or say --overwrite",
        request.folder.string(), files.size(), files.front().filename().string()));
}

}  // namespace

ExitCode carry_out(const RunRequest& request) {
  std::vector<double> discs;
  std::vector<int64_t> bonds;
  try {
    if (!request.disc_file.empty()) discs = output::read_discs(request.disc_file);
    if (!request.bond_file.empty()) bonds = output::read_bonds(request.bond_file);
  } catch (const output::DiscFileError& error) {
    throw BadInput(error.what());
  }
  auto definition = load_case(request.case_file, request.workers, discs, bonds);
  if (request.checkpoint_every >= 0.0) definition.output_checkpoint_every = request.checkpoint_every;
  if (request.checkpoint_steps >= 0) definition.output_checkpoint_steps = request.checkpoint_steps;
  refuse_earlier_run(request);
  output::FolderClaim claim(request.folder);
  catch_interrupts();

  ProgressLine line(request.quiet);
  const output::RunTerms terms{request.steps, request.grid, request.movie};
  output::RunFolder folder(request.folder, terms);
  const auto sim = build_model(definition, line);
  if (!sim) {
    tell("hfrac: interrupted during the initial equilibration; nothing was written\n");
    return kInterrupted;
  }
  try {
    if (!request.grid.empty()) output::lay_grid(sim.get(), request.grid);
  } catch (const output::EngineError& error) {
    throw BadInput(fmt::format("--grid: {}", error.what()));
  }
  output::remove_files_of_a_run(request.folder);
  definition.given_discs = nullptr;  // the model has its own copy
  definition.given_disc_count = 0;
  definition.given_bonds = nullptr;
  definition.given_bond_count = 0;

  return run_to_end(sim.get(), folder, definition, terms, line, [&] {
    // First the discs, without which the case alone would make another model.
    if (!discs.empty()) output::write_whole(request.folder / "given_discs.csv", output::discs_as_csv(discs));
    if (!bonds.empty()) output::write_whole(request.folder / "given_bonds.csv", output::bonds_as_csv(bonds));
    discs = {};
    bonds = {};
    folder.open(sim.get());
    claim.keep();
  });
}

}  // namespace hfrac::command
