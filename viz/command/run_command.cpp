// SPDX-License-Identifier: BSD-3-Clause
// hfrac run: the command line of a run, and what is said when it is over.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/exit_code.hpp"
#include "command/injection_record.hpp"
#include "command/interrupt.hpp"
#include "command/numbers.hpp"
#include "command/progress_line.hpp"
#include "command/run_size.hpp"
#include "command/run_to_end.hpp"
#include "command/standard_streams.hpp"
#include "command/summary_text.hpp"
#include "command/warnings.hpp"
#include "output/disc_file.hpp"
#include "output/run_folder.hpp"
#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/known_files.hpp"

namespace hfrac::command {

namespace {

// A run from case file to finished folder.

/** What the user asked for. */
struct RunRequest {
  std::string case_file;
  std::filesystem::path folder;
  std::filesystem::path disc_file;  ///< the user's own discs; empty: packed as the case says
  std::filesystem::path bond_file;  ///< which of those discs are bonded; empty: all that are near
  std::vector<double> grid;         ///< of a reservoir simulator (output/host_cells.hpp); empty: none
  int64_t steps = -1;               ///< steps to take; -1: as the case says
  int64_t workers = 0;              ///< 0: as the case says
  double checkpoint_every = -1.0;   ///< [s] of wall time; -1: as the case says
  int64_t checkpoint_steps = -1;    ///< -1: as the case says
  bool overwrite = false;
  bool quiet = false;
  bool movie = false;  ///< draw it while the run goes on
  bool no_space_check = false;
  bool one_model = false;  ///< for all processes of a machine
};

/** Runs it. Failures that leave something readable are told here; others are thrown. */
ExitCode carry_out(const RunRequest& request, const Team& team);

void refuse_earlier_run(const RunRequest& request) {
  if (request.overwrite) return;
  const auto files = output::files_of_a_run(request.folder);
  if (!files.empty())
    throw BadInput(fmt::format(
        "'{}' already holds {} file(s) of a run, e.g. {}; choose another folder or say --overwrite",
        request.folder.string(), files.size(), files.front().filename().string()));
}

ExitCode carry_out(const RunRequest& request, const Team& team) {
  require_grid(request.grid);
  GivenParts given(request.disc_file, request.bond_file);
  std::vector<std::string> notes;
  auto definition = load_case(request.case_file, request.workers, given, &notes);
  if (request.one_model) definition.run_workers = team.workers(definition.run_workers);
  if (request.checkpoint_every >= 0.0) definition.output_checkpoint_every = request.checkpoint_every;
  if (request.checkpoint_steps >= 0) definition.output_checkpoint_steps = request.checkpoint_steps;
  catch_interrupts();
  if (team.follows()) return follow(std::move(definition), request.folder, request.steps, team);
  refuse_earlier_run(request);
  const auto size = size_of_run(definition, request.steps);
  if (!request.no_space_check) require_room(size, request.folder);
  output::FolderClaim claim(request.folder);

  ProgressLine line(request.quiet);
  const output::RunTerms terms{request.steps, request.grid, request.movie};
  output::RunFolder folder(request.folder, terms, team.writers());
  Warnings warnings(folder, line, request.quiet);
  for (const auto& text : unlikely_values(definition)) warnings.add(text);
  if (!request.quiet)
    for (const auto& note : notes) tell("hfrac: {}\n", note);
  if (!request.quiet) tell("hfrac: will write {}\n", size_text(size));
  const auto sim = build_model(definition, request.case_file, team, line, warnings);
  if (!sim) {
    tell("hfrac: interrupted during the initial equilibration; nothing was written\n");
    return kInterrupted;
  }
  const std::string measured = pressures_of_case(request.case_file);
  restore(sim.get(), {}, team);
  lay_grid(sim.get(), terms);
  output::remove_files_of_a_run(request.folder);
  forget_given(definition);

  return run_to_end(sim.get(), folder, definition, terms, team, line, [&] {
    // First the discs, without which the case alone would make another model.
    if (!given.discs.empty())
      output::write_whole(request.folder / "given_discs.csv", output::discs_as_csv(given.discs));
    if (!given.bonds.empty())
      output::write_whole(request.folder / "given_bonds.csv", output::bonds_as_csv(given.bonds));
    given = {};
    if (!measured.empty()) output::write_whole(request.folder / "record.csv", measured);
    folder.open(sim.get());
    claim.keep();
  });
}

ExitCode run(const RunRequest& request) {
  Team team(request.one_model);
  if (team.rests()) return team.rest();
  const auto code = carry_out(request, team);
  if (code == kGood || code == kInterrupted) team.done();
  if (!request.quiet && !team.follows() && std::filesystem::exists(request.folder / "summary.json"))
    print_result(request.folder, code == kGood || code == kInterrupted);
  return code;
}

}  // namespace

void add_run(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("run", "Run a case and write a run folder");
  auto request = std::make_shared<RunRequest>();
  command->add_option("CASE", request->case_file, "Case file (TOML)")->required();
  command->add_option("-o,--output", request->folder, "Run folder to write; made if it is not there")
      ->required()
      ->type_name("DIR");
  add_given_parts(*command, request->disc_file, request->bond_file);
  command
      ->add_option("--grid", request->grid,
                   "Cells of a reservoir simulator, for cells.csv and Eclipse include files: NX NY DX DY [X0 "
                   "Y0 [DEGREES]] in m; "
                   "in the middle of the model without X0 Y0")
      ->expected(4, 100)  // how many it takes is said in words
      ->type_name("NUMBERS");
  command->add_option("--steps", request->steps, "Take this many steps, whatever the case says")
      ->check(count_number());
  command->add_option("--workers", request->workers, "Worker threads; results do not depend on it")
      ->check(CLI::Range(1, 256));
  command
      ->add_option("--checkpoint-every", request->checkpoint_every,
                   "Seconds of wall time between checkpoints, for hfrac resume; 0: none by time")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("SECONDS");
  command
      ->add_option("--checkpoint-steps", request->checkpoint_steps,
                   "Steps between checkpoints; 0: none by steps")
      ->check(count_number())
      ->type_name("STEPS");
  command->add_flag("--no-space-check", request->no_space_check,
                    "Begin even if the disk has no room for all that the case asks for");
  add_one_model(*command, request->one_model);
  command->add_flag("--overwrite", request->overwrite, "Remove the files of an earlier run in DIR first");
#ifdef HFRAC_WITH_RENDERER
  command->add_flag("--movie", request->movie, "Draw DIR/pictures/movie.mp4 while the run goes on");
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return run(*request); }; });
}

}  // namespace hfrac::command
