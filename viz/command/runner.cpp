// SPDX-License-Identifier: BSD-3-Clause
// The order of a run: read the case, claim the folder, build the model, and only then touch an earlier run's
// files. Whatever goes wrong before that point leaves the disk as it was.
#include "command/runner.hpp"

#include <fmt/format.h>

#include <vector>

#include "command/case_file.hpp"
#include "command/interrupt.hpp"
#include "command/numbers.hpp"
#include "command/progress_line.hpp"
#include "command/run_size.hpp"
#include "command/run_to_end.hpp"
#include "command/standard_streams.hpp"
#include "command/unlikely_values.hpp"
#include "command/warnings.hpp"
#include "output/disc_file.hpp"
#include "output/run_folder.hpp"
#include "run/files.hpp"
#include "run/known_files.hpp"

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
  require_grid(request.grid);
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
  const auto size = size_of_run(definition, request.steps);
  if (!request.no_space_check) require_room(size, request.folder);
  output::FolderClaim claim(request.folder);
  catch_interrupts();

  ProgressLine line(request.quiet);
  const output::RunTerms terms{request.steps, request.grid, request.movie};
  output::RunFolder folder(request.folder, terms);
  Warnings warnings(folder, line, request.quiet);
  for (const auto& text : unlikely_values(definition)) warnings.add(text);
  if (!request.quiet) tell("hfrac: will write {}\n", size_text(size));
  const auto sim = build_model(definition, request.case_file, line, warnings);
  if (!sim) {
    tell("hfrac: interrupted during the initial equilibration; nothing was written\n");
    return kInterrupted;
  }
  lay_grid(sim.get(), terms);
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
