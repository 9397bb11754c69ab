// SPDX-License-Identifier: BSD-3-Clause
// The hfrac program: chooses a subcommand, turns failures into one sentence and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "command/commands.hpp"
#include "command/guide.hpp"
#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"

namespace {

using namespace hfrac::command;

std::string version_text() {
  int32_t abi = 0;
  hfrac::run::require(hfrac_abi_version(&abi), nullptr);
  return fmt::format("{}, ABI {}", hfrac::run::build_of_library(), abi);
}

int complain(const char* text, ExitCode code) {
  const std::string place = guide_place(text);
  tell("hfrac: {}{}\n", text, place.empty() ? place : fmt::format(" ({})", place));
  return code;
}

/** CLI11 says of a word that it does not know only that a subcommand is required. */
void refuse_unknown_command(const CLI::App& program, int argument_count, char** arguments) {
  if (argument_count < 2 || arguments[1][0] == '-') return;
  std::vector<std::string> names;
  for (const auto* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), arguments[1]) != names.end()) return;
  throw BadInput(
      fmt::format("there is no command '{}'; the commands are {}", arguments[1], fmt::join(names, ", ")));
}

int run_program(int argument_count, char** arguments) {
  CLI::App program("Hydraulic fracturing with bonded discs.", "hfrac");
  program.footer(
      "Exit codes: 0 good, 1 the run failed, 2 bad usage or case file, 3 the rock fell apart, 130 "
      "interrupted.");
  program.set_version_flag("--version", version_text);
  program.require_subcommand(1);
  Action action;
  add_new(program, action);
  add_pack(program, action);
  add_run(program, action);
  add_resume(program, action);
  add_check(program, action);
  add_export(program, action);
  add_info(program, action);
  add_catalogue(program, action);
  add_analyse(program, action);
  add_dfn(program, action);
  add_studies(program, action);
  add_options(program, action);
  add_view(program, action);
  add_lab(program, action);
  add_calibrate(program, action);
#ifdef HFRAC_WITH_RENDERER
  add_render(program, action);
  add_plot(program, action);
  add_report(program, action);
#endif
  refuse_unknown_command(program, argument_count, arguments);
  ExitCode code = kGood;
  try {
    program.parse(argument_count, arguments);
    code = action();
  } catch (const CLI::ParseError& error) {
    std::ostringstream results, complaints;
    code = program.exit(error, results, complaints) == 0 ? kGood : kBadInput;
    fmt::print("{}", results.str());
    tell_text(complaints.str());
  }
  if (code == kGood) flush_results();
  return code;
}

}  // namespace

int main(int argument_count, char** arguments) {
  reserve_standard_streams();
  try {
    return run_program(argument_count, arguments);
  } catch (const BadInput& error) {
    return complain(error.what(), kBadInput);
  } catch (const hfrac::run::EngineError& error) {
    return complain(error.what(), error.status() == HFRAC_ERR_COLLAPSED ? kCollapsed : kRunFailed);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kRunFailed);
  } catch (const std::exception& error) {
    return complain(error.what(), kRunFailed);
  }
}
