// SPDX-License-Identifier: BSD-3-Clause
// hfrac info: what came out of a run, or how far it is.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <string>

#include "command/commands.hpp"
#include "command/summary_text.hpp"
#include "output/checkpoint.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/known_files.hpp"

namespace hfrac::command {
namespace {

/** The first number of the last whole line of the history: a step. -1: there is none. */
int64_t last_step(const std::filesystem::path& folder) {
  const auto file = folder / "history.csv";
  if (!std::filesystem::exists(file)) return -1;
  const auto text = run::read_whole(file);
  const size_t end = text.rfind('\n');
  if (end == std::string::npos || end == 0) return -1;
  const size_t before = text.rfind('\n', end - 1);
  const size_t begin = before == std::string::npos ? 0 : before + 1;
  int64_t step = -1;
  std::from_chars(text.data() + begin, text.data() + end, step);
  return step;
}

/** A run that nobody works on any more still says that it is running: it was killed before it could say otherwise. */
std::string how_it_ended(const std::filesystem::path& folder, const std::string& ended) {
  if (ended == "running") {
    const int64_t step = last_step(folder);
    const auto so_far = step < 0 ? std::string() : fmt::format(", {} steps taken", step);
    if (run::FolderClaim::is_held(folder)) return fmt::format("not yet: it goes on{}", so_far);
    return fmt::format("unfinished: it was killed{}; hfrac resume {} goes on", so_far, folder.string());
  }
  if (ended == "interrupted") return fmt::format("interrupted; hfrac resume {} goes on", folder.string());
  return ended;
}

ExitCode inform(const std::filesystem::path& folder) {
  const auto file = folder / "summary.json";
  if (!std::filesystem::exists(file))
    throw BadInput(fmt::format("'{}' holds no run: there is no summary.json in it", folder.string()));
  try {
    const auto summary = run::read_json(file);
    fmt::print("{}\n{}", folder.string(),
               summary_text(summary, how_it_ended(folder, summary.at("ended").get<std::string>())));
    if (const auto steps = output::CheckpointFolder(folder).steps(); !steps.empty())
      fmt::print("  {:18} after step {}\n", steps.size() == 1 ? "checkpoint" : "checkpoints",
                 steps.size() == 1 ? fmt::to_string(steps[0]) : fmt::format("{} and {}", steps[1], steps[0]));
    const auto& versions = summary.at("versions");
    fmt::print("  {:18} {}\n", "made by", versions.at("build").get<std::string>());
  } catch (const run::ReadError& error) {
    throw BadInput(error.what());
  } catch (const nlohmann::json::exception& error) {  // a member is missing, or of another kind
    throw BadInput(fmt::format("'{}' is not a summary that hfrac wrote: {}", file.string(), error.what()));
  }
  return kGood;
}

ExitCode tell_devices() {
  int32_t count = 0;
  const auto lines = run::devices_of_library(count);
  if (count > 0)
    fmt::print("{}\n", lines);
  else
    fmt::print("no device: {}\n", lines);
  return kGood;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("info", "Show what came out of a run, also while it goes on");
  auto folder = std::make_shared<std::string>();
  auto devices = std::make_shared<bool>(false);
  auto* run_folder = command->add_option("DIR", *folder, "Run folder");
  auto* flag =
      command->add_flag("--devices", *devices, "Instead: the cards that run.device = \"gpu\" can use");
  run_folder->excludes(flag);
  command->callback([folder, devices, &action] {
    if (!*devices && folder->empty()) throw CLI::RequiredError("DIR");
    action = [folder, devices] { return *devices ? tell_devices() : inform(*folder); };
  });
}

}  // namespace hfrac::command
