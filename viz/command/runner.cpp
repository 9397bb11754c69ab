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
  GivenParts given(request.disc_file, request.bond_file);
  auto definition = load_case(request.case_file, request.workers, given);
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
  forget_given(definition);

  return run_to_end(sim.get(), folder, definition, terms, line, [&] {
    // First the discs, without which the case alone would make another model.
    if (!given.discs.empty())
      output::write_whole(request.folder / "given_discs.csv", output::discs_as_csv(given.discs));
    if (!given.bonds.empty())
      output::write_whole(request.folder / "given_bonds.csv", output::bonds_as_csv(given.bonds));
    given = {};
    folder.open(sim.get());
    claim.keep();
  });
}

}  // namespace hfrac::command
