// SPDX-License-Identifier: BSD-3-Clause
// hfrac pack: a model packed, brought to rest and kept, for runs that name it (packing.file).
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/interrupt.hpp"
#include "command/numbers.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "command/team.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

struct PackRequest {
  std::string case_file, model_file;
  std::filesystem::path disc_file, bond_file;  ///< the user's own; empty: packed as the case says
  int64_t workers = 0;                         ///< 0: as the case says
  int64_t seed = -1;                           ///< -1: as the case says
  bool quiet = false;
};

int32_t show_packing(void* line, double fraction, const char* what) {
  static_cast<ProgressLine*>(line)->show(fmt::format("{:3.0f} %  {}", fraction * 100.0, what ? what : ""));
  return interrupted() ? 1 : 0;
}

int32_t tell_while_packing(void* line, int32_t /*level*/, const char* message) {
  static_cast<ProgressLine*>(line)->end();
  tell("hfrac: warning: {}\n", message);
  return 0;
}

ExitCode pack(const PackRequest& request) {
  if (processes_started() > 1)
    throw BadInput(
        "hfrac pack is the work of one process and its --workers; start it without mpirun, and the runs that "
        "begin from its file with it");
  const auto start = std::chrono::steady_clock::now();
  const GivenParts given(request.disc_file, request.bond_file);
  auto definition = load_case(request.case_file, request.workers, given);
  if (request.seed >= 0) definition.model_seed = request.seed;
  for (const auto& text : unlikely_values(definition)) tell("hfrac: warning: {}\n", text);
  catch_interrupts();
  ProgressLine line(request.quiet);
  definition.progress = show_packing;
  definition.progress_user = &line;
  definition.log = tell_while_packing;
  definition.log_user = &line;
  definition.log_level = HFRAC_LOG_WARNING;
  const int32_t status = hfrac_pack(&definition, request.model_file.c_str());
  line.end();
  if (status == HFRAC_STOPPED) {
    tell("hfrac: interrupted; nothing was written\n");
    return kInterrupted;
  }
  if (status == HFRAC_ERR_MODEL || status == HFRAC_ERR_ARGUMENT)
    throw BadInput(fmt::format("{}: {}", request.case_file, run::error_text(status, nullptr)));
  run::require(status, nullptr);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (!request.quiet)
    tell(
        "hfrac: packed and brought to rest in {}; {:.1f} MB in '{}'; cases begin from it with packing.file\n",
        readable_duration(took.count()),
        1e-6 * static_cast<double>(std::filesystem::file_size(request.model_file)), request.model_file);
  return kGood;
}

}  // namespace

void add_pack(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "pack", "Pack a case's model and bring it to rest once, in a file that many runs begin from");
  auto request = std::make_shared<PackRequest>();
  command->add_option("CASE", request->case_file, "Case file (TOML)")->required();
  command->add_option("-o,--output", request->model_file, "Model file to write, for packing.file of cases")
      ->required()
      ->type_name("MODEL");
  add_given_parts(*command, request->disc_file, request->bond_file);
  command->add_option("--seed", request->seed, "Seed of the packing, in place of the case's model.seed")
      ->check(count_number());
  command->add_option("--workers", request->workers, "Worker threads; results do not depend on it")
      ->check(CLI::Range(1, 256));
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return pack(*request); }; });
}

}  // namespace hfrac::command
