// SPDX-License-Identifier: BSD-3-Clause
// hfrac view: a run in the browser. The program serves until it is interrupted.
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "command/commands.hpp"
#include "command/injection_record.hpp"
#include "command/interrupt.hpp"
#include "command/standard_streams.hpp"
#include "web/server/page_server.hpp"

namespace hfrac::command {
namespace {

struct ViewPageRequest {
  std::string folder;
  std::string record;  ///< of a field, beside the run's pressure; empty: the run's own, if it has one
  int port = 8020;
  bool no_open = false;
};

/** Asks the desktop, if there is one, to show the page; whether it did is not our concern. */
void open_browser(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string program = "xdg-open";
  std::string argument = address;
  const std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, "xdg-open", nullptr, nullptr, arguments.data(), environ);
}

ExitCode view(const ViewPageRequest& request) {
  std::error_code error;
  if (!std::filesystem::is_directory(request.folder, error))
    throw BadInput(fmt::format("there is no folder '{}'", request.folder));

  std::string measured;
  if (!request.record.empty()) measured = pressures_as_csv(read_injection(request.record, 1.0));
  web::PageServer server(request.folder, measured);
  if (!server.bind(request.port))
    throw BadInput(
        request.port == 0
            ? std::string("no port of 127.0.0.1 is free")
            : fmt::format("port {} of 127.0.0.1 is in use or not yours to take; choose another with "
                          "--port, or --port 0 for any that is free",
                          request.port));
  catch_interrupts();
  fmt::print("{}\n", server.address());
  flush_results();
  if (isatty(STDERR_FILENO) != 0)
    tell("The page shows '{}' as long as this program runs; Ctrl-C ends it.\n", request.folder);
  if (!request.no_open) open_browser(server.address());

  std::thread answering([&server] { server.serve(); });
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server.stop();
  answering.join();
  return kGood;
}

}  // namespace

void add_view(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("view", "Show a run in the browser, also while it goes on");
  auto request = std::make_shared<ViewPageRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  command->add_option(
      "--record", request->record,
      "A field's record (CSV or LAS file), its pressure beside that of the first well; otherwise "
      "that of the schedule_file of the run's case");
  command->add_option("--port", request->port, "Port of 127.0.0.1 to serve at; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_flag("--no-open", request->no_open, "Print the address only, open no browser");
  command->callback([request, &action] { action = [request] { return view(*request); }; });
}

}  // namespace hfrac::command
