// SPDX-License-Identifier: BSD-3-Clause
#include "command/run_to_end.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "command/interrupt.hpp"
#include "command/step_loop.hpp"
#include "output/host_cells.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/movie_thread.hpp"
#include "command/standard_streams.hpp"
#endif

namespace hfrac::command {
namespace {

int32_t show_setup(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(
      fmt::format("set-up {:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

ExitCode report_failure(const output::RunFolder& folder, const std::string& why) {
  tell("hfrac: the run failed: {}\n", why);
  tell("hfrac: {} complete snapshot(s) in '{}' stay readable\n", folder.snapshots(), folder.path().string());
  return kRunFailed;
}

#ifdef HFRAC_WITH_RENDERER
/** A run without its movie is still a good run. */
void report_movie(const std::string& failure) {
  if (!failure.empty()) tell("hfrac: the run is complete, but there is no movie: {}\n", failure);
}
#endif

/** The state is safe by then, so `hfrac export` can write the cells once there is room for them. */
bool write_cells(hfrac_sim* sim, const output::RunFolder& folder, const output::RunTerms& terms) {
  if (terms.grid.empty()) return true;
  try {
    output::write_cells(sim, std::llround(terms.grid[0]), folder.path());
    return true;
  } catch (const std::runtime_error& error) {
    tell("hfrac: the run is complete, but its cells are not written: {}\n", error.what());
    return false;
  }
}

ExitCode take_steps_to_end(hfrac_sim* sim, output::RunFolder& folder, const hfrac_sim_def& definition,
                           const output::RunTerms& terms, ProgressLine& line) {
#ifdef HFRAC_WITH_RENDERER
  std::optional<MovieThread> movie;
  if (terms.movie) movie.emplace(folder.path());
#endif
  const auto why = take_steps(sim, folder, definition, terms.steps, line);
  // Before the snapshot of the interruption, which an uninterrupted run would not have.
  if (why.interrupted) save_checkpoint(sim, folder, line);
  folder.finish(sim, why.text);
  line.end();
  if (!write_cells(sim, folder, terms)) return kRunFailed;
#ifdef HFRAC_WITH_RENDERER
  if (movie) report_movie(movie->finish());
#endif
  if (!why.interrupted) return kGood;
  tell("hfrac: interrupted; everything up to the last whole step is in '{0}'; hfrac resume {0}\n",
       folder.path().string());
  return kInterrupted;
}

}  // namespace

Simulation build_model(Definition definition, const std::string& case_file, ProgressLine& line,
                       Warnings& warnings) {
  warnings.listen(definition);
  definition.progress = show_setup;
  definition.progress_user = &line;
  hfrac_sim* sim = nullptr;
  const int32_t status = hfrac_sim_create(&definition, &sim);
  Simulation simulation(sim);
  line.end();
  if (status == HFRAC_STOPPED) return nullptr;
  if (status == HFRAC_ERR_MODEL || status == HFRAC_ERR_ARGUMENT)
    throw BadInput(fmt::format("{}: {}", case_file, output::error_text(status, nullptr)));
  if (status == HFRAC_ERR_COLLAPSED)
    throw output::EngineError(status, fmt::format("{}: {}", case_file, output::error_text(status, nullptr)));
  output::require(status, nullptr);
  warnings.listen(sim);
  return simulation;
}

void lay_grid(hfrac_sim* sim, const output::RunTerms& terms) {
  if (terms.grid.empty()) return;
  try {
    output::lay_grid(sim, terms.grid);
  } catch (const output::EngineError& error) {
    throw BadInput(fmt::format("--grid: {}", error.what()));
  }
  if (output::grid_covers_model(sim)) return;
  const auto definition = output::definition_of(sim);
  throw BadInput(
      fmt::format("--grid: no cell covers any of the model, which reaches from (0, 0) to ({:g}, {:g}) m; "
                  "leave X0 Y0 out to have the "
                  "grid in its middle",
                  definition.model_width, definition.model_height));
}

ExitCode run_to_end(hfrac_sim* sim, output::RunFolder& folder, const hfrac_sim_def& definition,
                    const output::RunTerms& terms, ProgressLine& line, const std::function<void()>& begin) {
  try {
    begin();
    return take_steps_to_end(sim, folder, definition, terms, line);
  } catch (const output::FileError& error) {
    line.end();
    folder.note_failure(sim, error.what());
    return report_failure(folder, error.what());
  } catch (const output::EngineError& error) {
    line.end();
    save_checkpoint(sim, folder, line);  // the engine is back at its last good step
    folder.finish_failed(sim, error.what());
    report_failure(folder, error.what());
    return error.status() == HFRAC_ERR_COLLAPSED ? kCollapsed : kRunFailed;
  }
}

}  // namespace hfrac::command
