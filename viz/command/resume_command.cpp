// SPDX-License-Identifier: BSD-3-Clause
// hfrac resume: goes on with a run that was killed, interrupted or failed, as if nothing had happened.
//
// The model is built anew from the folder's case.toml, which gives the same one bit for bit; the state comes from the newest
// checkpoint that is whole; what the folder holds of later steps is taken away. Without a checkpoint the run starts from
// its beginning again. All that is known to be needed is looked at before anything in the folder is changed.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/interrupt.hpp"
#include "command/numbers.hpp"
#include "command/run_to_end.hpp"
#include "command/standard_streams.hpp"
#include "command/summary_text.hpp"
#include "command/warnings.hpp"
#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/known_files.hpp"

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

struct ResumeRequest {
  fs::path folder;
  int64_t steps = -1;   ///< steps in all; -1: as the run was asked for
  int64_t workers = 0;  ///< 0: as the run was asked for
  bool quiet = false;
  bool one_model = false;  ///< for all processes of a machine
};

nlohmann::ordered_json summary_in(const fs::path& folder) {
  const auto file = folder / "summary.json";
  if (!fs::exists(file)) {
    throw BadInput(
        fmt::format("'{}' holds no run that had begun: there is no summary.json in it; start it with hfrac "
                    "run",
                    folder.string()));
  }
  try {
    return run::read_json(file);
  } catch (const run::ReadError& error) {
    throw BadInput(error.what());
  }
}

/** Whether the run came to its end by itself. */
bool is_complete(const std::string& ended) {
  return ended != "running" && ended != "interrupted" && !ended.starts_with("failed");
}

/** Restores it; of another case, in words. */
void require_image_of(hfrac_sim* sim, const output::Checkpoint& checkpoint, const fs::path& folder) {
  const int32_t status =
      hfrac_state_restore(sim, checkpoint.image.data(), static_cast<int64_t>(checkpoint.image.size()));
  if (status == HFRAC_ERR_ARGUMENT) {
    throw BadInput(fmt::format("the checkpoint after step {} does not belong to '{}': {}", checkpoint.step,
                               (folder / "case.toml").string(), output::error_text(status, sim)));
  }
  output::require(status, sim);
}

ExitCode go_on(const ResumeRequest& request, const Team& team) {
  const fs::path& folder = request.folder;
  std::string ended;
  output::RunTerms terms;
  const auto summary = summary_in(folder);
  try {
    ended = summary.at("ended").get<std::string>();
    terms = output::terms_of(summary);
    output::warnings_of(summary, 0);  // that they can be read
  } catch (const nlohmann::json::exception&) {
    throw BadInput(
        fmt::format("'{}' does not say what the run was asked for: it is of an older hfrac, or was changed",
                    (folder / "summary.json").string()));
  }
  if (is_complete(ended) && request.steps < 0) {
    if (!request.quiet && !team.follows())
      fmt::print("{}: the run is complete ({}); nothing to do\n", folder.string(), ended);
    return kGood;
  }
  if (request.steps >= 0) terms.steps = request.steps;

  const GivenParts given(folder);
  auto definition = load_case((folder / "case.toml").string(), request.workers, given);
  if (request.one_model) definition.run_workers = team.workers(definition.run_workers);
  catch_interrupts();
  if (team.follows()) return follow(std::move(definition), folder, terms.steps, team);
  const output::FolderClaim claim(folder);
  std::vector<std::string> damaged;
  auto checkpoint = output::CheckpointFolder(folder).newest(damaged);
  for (const auto& text : damaged) tell("hfrac: {}\n", text);
  if (!checkpoint && !request.quiet) fmt::print("no checkpoint: the run starts from its beginning again\n");
  if (checkpoint && terms.steps >= 0 && checkpoint->step > terms.steps) {
    throw BadInput(
        fmt::format("--steps {} lies before the checkpoint after step {}; take the steps with hfrac run",
                    terms.steps, checkpoint->step));
  }

  ProgressLine line(request.quiet);
  output::RunFolder run(folder, terms, team.writers());
  Warnings warnings(run, line, request.quiet);
  for (const auto& text : unlikely_values(definition)) warnings.add(text);
  const auto sim = build_model(definition, (folder / "case.toml").string(), team, line, warnings);
  if (!sim) {
    tell("hfrac: interrupted during the initial equilibration; nothing was changed\n");
    return kInterrupted;
  }
  if (checkpoint) require_image_of(sim.get(), *checkpoint, folder);
  {  // Its image, a fifth of the model's memory, is kept no longer than it is needed.
    std::string image = checkpoint ? std::exchange(checkpoint->image, {}) : std::string();
    if (!team.alone()) restore(sim.get(), std::move(image), team);
  }
  lay_grid(sim.get(), terms);
  if (checkpoint) {
    for (const auto& warning : output::warnings_of(summary, checkpoint->step))
      run.add_warning(warning.step, warning.text);
  }
  forget_given(definition);
  const auto code = run_to_end(sim.get(), run, definition, terms, team, line, [&] {
    if (checkpoint) {
      run.go_on_from(sim.get(), *checkpoint);
    } else {
      run.open(sim.get());
      output::remove_later_files(folder, {0});
    }
  });
  if (!request.quiet) print_result(folder, code == kGood || code == kInterrupted);
  return code;
}

}  // namespace

void add_resume(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("resume", "Go on with a run that was killed, interrupted or failed");
  auto request = std::make_shared<ResumeRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  command->add_option("--steps", request->steps, "Go on to this step, also beyond the end of a complete run")
      ->check(count_number());
  command->add_option("--workers", request->workers, "Worker threads; results do not depend on it")
      ->check(CLI::Range(1, 256));
  add_one_model(*command, request->one_model);
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] {
    action = [request] {
      Team team(request->one_model);
      if (team.rests()) return team.rest();
      const auto code = go_on(*request, team);
      if (code == kGood || code == kInterrupted) team.done();
      return code;
    };
  });
}

}  // namespace hfrac::command
