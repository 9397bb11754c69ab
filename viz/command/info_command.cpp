// SPDX-License-Identifier: BSD-3-Clause
// hfrac info: what came out of a run, or how far it is.
#include <fmt/format.h>

#include <filesystem>

#include "command/commands.hpp"
#include "command/summary_text.hpp"
#include "output/checkpoint.hpp"
#include "output/safe_file.hpp"

namespace hfrac::command {
namespace {

ExitCode inform(const std::filesystem::path& folder) {
  const auto file = folder / "summary.json";
  if (!std::filesystem::exists(file))
    throw BadInput(fmt::format("'{}' holds no run: there is no summary.json in it", folder.string()));
  try {
    const auto summary = nlohmann::json::parse(output::read_whole(file));
    fmt::print("{}\n{}", folder.string(), summary_text(summary));
    if (const auto steps = output::CheckpointFolder(folder).steps(); !steps.empty())
      fmt::print("  {:18} after step {}\n", steps.size() == 1 ? "checkpoint" : "checkpoints",
                 steps.size() == 1 ? fmt::to_string(steps[0]) : fmt::format("{} and {}", steps[1], steps[0]));
    const auto& versions = summary.at("versions");
    fmt::print("  {:18} {}, VTK {}\n", "made by", versions.at("build").get<std::string>(),
               versions.at("vtk").get<std::string>());
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(fmt::format("'{}' is not a summary that hfrac wrote: {}", file.string(), error.what()));
  }
  return kGood;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("info", "Show what came out of a run, also while it goes on");
  auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "Run folder")->required();
  command->callback([folder, &action] { action = [folder] { return inform(*folder); }; });
}

}  // namespace hfrac::command
