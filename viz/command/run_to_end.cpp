// SPDX-License-Identifier: BSD-3-Clause
#include "command/run_to_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "command/interrupt.hpp"

#include "output/host_cells.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/movie_thread.hpp"
#include "command/standard_streams.hpp"
#endif

namespace hfrac::command {

// One step at a time, so that the history has a line for each.

namespace {

constexpr double kCallbackSeconds = 0.1;
constexpr int64_t kForever = std::numeric_limits<int64_t>::max();

/** When a run ends by itself. */
struct Limits {
  int64_t steps;
  double time;
};

Limits limits_of(const hfrac_sim_def& definition, int64_t steps) {
  const double never = std::numeric_limits<double>::infinity();
  if (steps >= 0) return {steps, never};
  if (definition.stepping_end_time > 0.0) return {kForever, definition.stepping_end_time};
  return {definition.stepping_steps, never};
}

/** The progress line, made from the state after the last step. */
class StepReport {
 public:
  StepReport(ProgressLine& line, Limits limits, const hfrac_sim_state& from)
      : line_(line), limits_(limits), start_(Clock::now()), from_step_(from.step), from_time_(from.time) {}

  void after_step(hfrac_sim* sim) {
    const auto state = output::state_of(sim);
    const auto wells = output::wells_of(sim);
    step_start_ = Clock::now();
    const double elapsed = seconds_since(start_);
    const double speed = elapsed > 0.0 ? static_cast<double>(state.step - from_step_) / elapsed : 0.0;
    text_ = limits_.steps == kForever ? fmt::format("step {}", state.step)
                                      : fmt::format("step {}/{}", state.step, limits_.steps);
    text_ += fmt::format("  {:.6g} s  {} cracks", state.time, state.crack_count);
    if (!wells.empty()) text_ += fmt::format("  well {:.4g} MPa", wells.front().pressure * 1e-6);
    text_ += fmt::format("  {:.3g} steps/s  at most {} left", speed,
                         readable_duration(seconds_left(state, elapsed)));
    line_.show(text_);
  }

  /** A long step must not look like a dead one. */
  void within_step() {
    if (!line_.due()) return;
    const double seconds = seconds_since(step_start_);
    line_.show(seconds < 2.0 ? text_
                             : fmt::format("{}  in this step since {}", text_, readable_duration(seconds)));
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  double seconds_left(const hfrac_sim_state& state, double elapsed) const {
    const double done = limits_.steps == kForever ? (state.time - from_time_) / (limits_.time - from_time_)
                                                  : static_cast<double>(state.step - from_step_) /
                                                        static_cast<double>(limits_.steps - from_step_);
    return done > 0.0 ? elapsed * (1.0 - done) / done : 0.0;
  }

  ProgressLine& line_;
  Limits limits_;
  Clock::time_point start_;
  Clock::time_point step_start_ = start_;
  int64_t from_step_;  ///< where this process took over
  double from_time_;   ///< [s]
  std::string text_ = "first step";
};

int32_t while_stepping(void* report, double, const char*) {
  static_cast<StepReport*>(report)->within_step();
  return interrupted() ? 1 : 0;
}

/** When a checkpoint is due: so many seconds or so many steps after the last one, whichever comes first. */
class CheckpointClock {
 public:
  CheckpointClock(const hfrac_sim_def& definition, int64_t step)
      : seconds_(definition.output_checkpoint_every),
        steps_(definition.output_checkpoint_steps),
        last_step_(step),
        last_time_(Clock::now()) {}

  bool due(int64_t step) {
    const std::chrono::duration<double> passed = Clock::now() - last_time_;
    if ((seconds_ <= 0.0 || passed.count() < seconds_) && (steps_ <= 0 || step - last_step_ < steps_))
      return false;
    last_step_ = step;
    last_time_ = Clock::now();
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_;
  int64_t steps_;
  int64_t last_step_;
  Clock::time_point last_time_;
};

/** Takes the callback out again however the loop is left. */
class Callback {
 public:
  Callback(hfrac_sim* sim, StepReport& report, double seconds) : sim_(sim) {
    output::require(hfrac_set_progress(sim, while_stepping, &report, seconds), sim);
  }
  Callback(const Callback&) = delete;
  Callback& operator=(const Callback&) = delete;
  ~Callback() { hfrac_set_progress(sim_, nullptr, nullptr, kCallbackSeconds); }

 private:
  hfrac_sim* sim_;
};

/** Why a run ended. */
struct EndOfRun {
  std::string text;  ///< for the summary
  bool interrupted = false;
};

/** Writes a checkpoint. If that fails, the run goes on: it says so and nothing else is lost. */
void save_checkpoint(hfrac_sim* sim, output::RunFolder& folder, ProgressLine& line) {
  try {
    folder.checkpoint(sim);
  } catch (const std::exception& error) {  // a full disk, or memory that does not hold the image
    line.end();
    tell("hfrac: no checkpoint, the earlier ones stand: {}\n", error.what());
  }
}

/** Steps `sim` to the end of the run and writes into `folder` on the way, checkpoints as the definition says included; without one, `pieces` of
 * snapshots. `steps` >= 0 replaces the case's length. */
EndOfRun take_steps(hfrac_sim* sim, output::RunFolder* folder, output::PieceFiles* pieces,
                    const hfrac_sim_def& definition, int64_t steps, const Team& team, ProgressLine& line) {
  const auto limits = limits_of(definition, steps);
  auto state = output::state_of(sim);
  StepReport report(line, limits, state);
  // Several processes stop together: the library asks all of them, in every step.
  const Callback callback(sim, report, team.alone() ? kCallbackSeconds : 0.0);
  CheckpointClock checkpoint(definition, state.step);
  for (;;) {
    if (team.alone() && interrupted()) return {"interrupted", true};
    if (state.stop_reason == HFRAC_REASON_EXTENT)
      return {
          "a crack tip reached stop.extent_fraction of the model: what follows would be the boundary's "
          "doing"};
    if (state.stop_reason == HFRAC_REASON_CRACKS) return {"stop.cracks reached"};
    if (state.time >= limits.time) return {"end time reached"};
    if (state.step >= limits.steps) return {"all steps taken"};

    const int64_t before = state.step;
    const int32_t status = hfrac_step(sim, 1);
    output::require(status, sim);
    state = output::state_of(sim);
    if (state.step == before) return {"interrupted", true};
    const bool shown = state.step / definition.output_every != before / definition.output_every;
    if (folder == nullptr) {
      if (shown) pieces->follow(sim);
      continue;
    }
    folder->record_step(sim);
    if (shown) folder->snapshot(sim);
    if (checkpoint.due(state.step)) save_checkpoint(sim, *folder, line);
    report.after_step(sim);
  }
}

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
                           const output::RunTerms& terms, const Team& team, ProgressLine& line) {
#ifdef HFRAC_WITH_RENDERER
  std::optional<MovieThread> movie;
  if (terms.movie) movie.emplace(folder.path());
#endif
  const auto why = take_steps(sim, &folder, nullptr, definition, terms.steps, team, line);
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

Simulation build_model(Definition definition, const std::string& case_file, const Team& team,
                       ProgressLine& line, Warnings& warnings) {
  warnings.listen(definition);
  definition.progress = show_setup;
  definition.progress_user = &line;
  hfrac_sim* sim = nullptr;
  const int32_t status = team.create(definition, &sim);
  Simulation simulation(sim);
  line.end();
  if (status == HFRAC_STOPPED) return nullptr;
  if (status == HFRAC_ERR_MODEL || status == HFRAC_ERR_ARGUMENT || status == HFRAC_ERR_FILE)
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
                    const output::RunTerms& terms, const Team& team, ProgressLine& line,
                    const std::function<void()>& begin) {
  try {
    begin();
    return take_steps_to_end(sim, folder, definition, terms, team, line);
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

bool restore(hfrac_sim* sim, std::string image, const Team& team) {
  const auto all = team.share(std::move(image));
  if (!all.empty())
    output::require(hfrac_state_restore(sim, all.data(), static_cast<int64_t>(all.size())), sim);
  return !all.empty();
}

// The same snapshots in the same order as the first one, of which RunFolder has the hand.
ExitCode follow(Definition definition, const std::filesystem::path& folder, int64_t steps, const Team& team) {
  ProgressLine line(true);
  definition.log = nullptr;  // the first one's to tell
  definition.progress = show_setup;
  definition.progress_user = &line;
  hfrac_sim* sim = nullptr;
  const int32_t status = team.create(definition, &sim);
  const Simulation simulation(sim);
  if (status == HFRAC_STOPPED) return kInterrupted;
  if (status != HFRAC_OK) return kRunFailed;
  try {
    output::PieceFiles pieces(folder, team.writers());
    if (!restore(sim, {}, team)) pieces.follow(sim);
    const auto why = take_steps(sim, nullptr, &pieces, definition, steps, team, line);
    pieces.follow(sim);
    return why.interrupted ? kInterrupted : kGood;
  } catch (const std::runtime_error&) {
    return kRunFailed;  // as the first one says
  }
}

}  // namespace hfrac::command
