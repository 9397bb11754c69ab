// SPDX-License-Identifier: BSD-3-Clause
// The order of a run: read the case, claim the folder, build the model, and only then touch an earlier run's
// files. Whatever goes wrong before that point leaves the disk as it was.
#include "command/runner.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "command/case_file.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/step_loop.hpp"
#include "output/disc_file.hpp"
#include "output/host_cells.hpp"
#include "output/known_files.hpp"
#include "output/run_folder.hpp"
#include "output/safe_file.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/movie_thread.hpp"
#endif

namespace hfrac::command {
namespace {

struct DestroySimulation {
  void operator()(hfrac_sim* sim) const { hfrac_sim_destroy(&sim); }
};
using Simulation = std::unique_ptr<hfrac_sim, DestroySimulation>;

int32_t show_setup(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("set-up {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

void refuse_earlier_run(const RunRequest& request) {
  if (request.overwrite) return;
  const auto files = output::files_of_a_run(request.folder);
  if (!files.empty())
    throw BadInput(fmt::format(
        "'{}' already holds {} file(s) of a run, e.g. {}; choose another folder or say --overwrite",
        request.folder.string(), files.size(), files.front().filename().string()));
}

/** Builds the model; no simulation if the user interrupted. */
Simulation build(hfrac_sim_def definition, ProgressLine& line) {
  definition.progress = show_setup;
  definition.progress_user = &line;
  hfrac_sim* sim = nullptr;
  const int32_t status = hfrac_sim_create(&definition, &sim);
  Simulation simulation(sim);
  line.end();
  if (status == HFRAC_STOPPED) return nullptr;
  if (status == HFRAC_ERR_MODEL || status == HFRAC_ERR_ARGUMENT)
    throw BadInput(output::error_text(status, nullptr));
  output::require(status, nullptr);
  return simulation;
}

void report_failure(const output::RunFolder& folder, const std::string& why) {
  fmt::print(stderr, "hfrac: the run failed: {}\n", why);
  fmt::print(stderr, "hfrac: {} complete snapshot(s) in '{}' stay readable\n", folder.snapshots(),
             folder.path().string());
}

#ifdef HFRAC_WITH_RENDERER
/** A run without its movie is still a good run. */
void report_movie(const std::string& failure) {
  if (!failure.empty())
    fmt::print(stderr, "hfrac: the run is complete, but there is no movie: {}\n", failure);
}
#endif

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
  refuse_earlier_run(request);
  output::FolderClaim claim(request.folder);
  catch_interrupts();

  ProgressLine line(request.quiet);
  output::RunFolder folder(request.folder);
  const auto sim = build(definition, line);
  if (!sim) {
    fmt::print(stderr, "hfrac: interrupted during the set-up; nothing was written\n");
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

  try {
    folder.open(sim.get());
    claim.keep();
    if (!discs.empty()) output::write_whole(request.folder / "given_discs.csv", output::discs_as_csv(discs));
    if (!bonds.empty()) output::write_whole(request.folder / "given_bonds.csv", output::bonds_as_csv(bonds));
    discs = {};
    bonds = {};
#ifdef HFRAC_WITH_RENDERER
    std::optional<MovieThread> movie;
    if (request.movie) movie.emplace(request.folder);
#endif
    const auto why = take_steps(sim.get(), folder, definition, request.steps, line);
    if (!request.grid.empty()) output::write_cells(sim.get(), std::llround(request.grid[0]), request.folder);
    folder.finish(sim.get(), why.text);
    line.end();
#ifdef HFRAC_WITH_RENDERER
    if (movie) report_movie(movie->finish());
#endif
    if (!why.interrupted) return kGood;
    fmt::print(stderr, "hfrac: interrupted; everything up to the last whole step is in '{}'\n",
               request.folder.string());
    return kInterrupted;
  } catch (const output::FileError& error) {
    line.end();
    folder.note_failure(sim.get(), error.what());
    report_failure(folder, error.what());
  } catch (const output::EngineError& error) {
    line.end();
    folder.finish_failed(sim.get(), error.what());
    report_failure(folder, error.what());
  }
  return kRunFailed;
}

}  // namespace hfrac::command
