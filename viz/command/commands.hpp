// SPDX-License-Identifier: BSD-3-Clause
// The subcommands. Each adds itself to the command line and leaves in `action` what to do if it is chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "command/exit_code.hpp"

namespace hfrac::command {

/** What the chosen subcommand does; gives the exit code. */
using Action = std::function<ExitCode()>;

void add_new(CLI::App& program, Action& action);
void add_pack(CLI::App& program, Action& action);
void add_run(CLI::App& program, Action& action);
void add_resume(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_export(CLI::App& program, Action& action);
void add_info(CLI::App& program, Action& action);
void add_lab(CLI::App& program, Action& action);
void add_calibrate(CLI::App& program, Action& action);
void add_analyse(CLI::App& program, Action& action);
void add_catalogue(CLI::App& program, Action& action);
void add_dfn(CLI::App& program, Action& action);
void add_studies(CLI::App& program, Action& action);
void add_options(CLI::App& program, Action& action);
void add_view(CLI::App& program, Action& action);
void add_render(CLI::App& program, Action& action);
void add_plot(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);

}  // namespace hfrac::command
