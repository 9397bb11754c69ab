// SPDX-License-Identifier: BSD-3-Clause
// hfrac run: the command line of a run, and what is said when it is over.
#include <fmt/format.h>

#include <filesystem>

#include "command/commands.hpp"
#include "command/numbers.hpp"
#include "command/runner.hpp"
#include "command/standard_streams.hpp"
#include "command/summary_text.hpp"
#include "run/json_file.hpp"

namespace hfrac::command {

namespace {

void print_table(const std::filesystem::path& folder, bool complete) {
  const auto summary = run::read_json(folder / "summary.json");
  fmt::print("{}", summary_text(summary));
  if (!complete) return;
  fmt::print("  {:18} {}: discs.pvd, bonds.pvd, cracks.pvd, flow.pvd (ParaView), history.csv, cracks.csv,\n",
             "files", folder.string());
  fmt::print("  {:18} fractures.csv, events.csv, summary.json, case.toml\n", "");
#ifdef HFRAC_WITH_RENDERER
  fmt::print("  {:18} hfrac render {}\n", "pictures", folder.string());
#endif
}

}  // namespace

// The result of a run is its folder, and the exit code speaks of that: a workflow that is told of a failure removes it.
void print_result(const std::filesystem::path& folder, bool complete) {
  try {
    print_table(folder, complete);
    flush_results();
  } catch (const std::exception& error) {
    drop_results();
    tell("hfrac: '{}' is written, but what is in it cannot be told: {}\n", folder.string(), error.what());
  }
}

namespace {

ExitCode run(const RunRequest& request) {
  const auto code = carry_out(request);
  if (!request.quiet && std::filesystem::exists(request.folder / "summary.json"))
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
  command
      ->add_option("--discs", request->disc_file,
                   "Own discs instead of a packing: CSV with x, y, radius, or VTU")
      ->type_name("FILE");
  command
      ->add_option(
          "--bonds", request->bond_file,
          "Which of the own discs are bonded: CSV with disc_0, disc_1, counted from 0; without, all that "
          "are near")
      ->needs("--discs")
      ->type_name("FILE");
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
  command->add_flag("--overwrite", request->overwrite, "Remove the files of an earlier run in DIR first");
#ifdef HFRAC_WITH_RENDERER
  command->add_flag("--movie", request->movie, "Draw DIR/pictures/movie.mp4 while the run goes on");
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return run(*request); }; });
}

}  // namespace hfrac::command
