// SPDX-License-Identifier: BSD-3-Clause
// hfrac export: the end of a run as plain tables and, on a reservoir simulator's grid, as Eclipse include files.
//
// The model is built anew from the folder's own case and takes the state the run ended with, so what is written is what the
// engine itself says of it. The state's hash must be the one of summary.json.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/numbers.hpp"
#include "output/host_cells.hpp"
#include "output/tables.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"
#include "run/json_file.hpp"

namespace hfrac::command {
namespace {
namespace fs = std::filesystem;

struct ExportRequest {
  fs::path folder, output;
  std::string cells;  ///< "NXxNY"; empty: by dx, or no grid
  double dx = 0.0;    ///< [m] about, of square cells; 0: by cells, or no grid
};

/** The run's model in the state it ended with. */
run::Simulation rebuild(const fs::path& folder) {
  const auto case_file = folder / "case.toml", state_file = folder / "state.hfrac";
  for (const auto& file : {case_file, state_file})
    if (!fs::exists(file))
      throw BadInput(fmt::format("'{}' holds no finished run: there is no {} in it", folder.string(),
                                 file.filename().string()));
  const GivenParts given(folder);
  const auto definition = load_case(case_file.string(), 0, given);
  hfrac_sim* made = nullptr;
  const int32_t status = hfrac_sim_create(&definition, &made);
  run::Simulation sim(made);
  output::require(status, nullptr);
  const int32_t loaded = hfrac_state_load_file(sim.get(), state_file.c_str());
  if (loaded < 0) throw BadInput(output::error_text(loaded, sim.get()));
  return sim;
}

/** NXxNY, or square cells of about dx: {nx, ny, dx, dy}, the model covered exactly; empty: no grid wanted. */
std::vector<double> grid_of(const ExportRequest& request, const hfrac_sim* sim) {
  const auto definition = output::definition_of(sim);
  double nx = 0.0, ny = 0.0;
  if (!request.cells.empty()) {
    const auto cross = request.cells.find('x');
    int64_t across = 0, along = 0;
    using CLI::detail::lexical_cast;
    if (cross == std::string::npos || !lexical_cast(request.cells.substr(0, cross), across) ||
        !lexical_cast(request.cells.substr(cross + 1), along) || across < 1 || along < 1)
      throw BadInput(fmt::format("--cells {} is no grid; give NXxNY, e.g. 20x20", request.cells));
    nx = static_cast<double>(across);
    ny = static_cast<double>(along);
  } else if (request.dx > 0.0) {
    nx = std::max(1.0, std::round(definition.model_width / request.dx));
    ny = std::max(1.0, std::round(definition.model_height / request.dx));
  } else {
    return {};
  }
  return {nx, ny, definition.model_width / nx, definition.model_height / ny};
}

void check_hash(const fs::path& folder, const hfrac_sim* sim) {
  const auto file = folder / "summary.json";
  if (!fs::exists(file)) return;
  const auto told = run::text_at(run::read_json(file), "state_hash");
  const auto hash = fmt::format("{:016x}", static_cast<uint64_t>(output::state_hash_of(sim)));
  if (!told.empty() && told != hash)
    throw BadInput(
        fmt::format("'{}' does not belong together: summary.json says state hash {}, the state has {}",
                    folder.string(), told, hash));
}

ExitCode write_tables(const ExportRequest& request) {
  const auto sim = rebuild(request.folder);
  check_hash(request.folder, sim.get());
  const auto grid = grid_of(request, sim.get());
  try {
    if (!grid.empty()) output::lay_grid(sim.get(), grid);
  } catch (const output::EngineError& error) {
    throw BadInput(error.what());
  }
  const auto folder = request.output.empty() ? request.folder / "export" : request.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BadInput(fmt::format("cannot make folder '{}': {}", folder.string(), error.message()));
  const auto fractures = output::fractures_of(sim.get());  // before the cracks, so that each knows its own
  output::write_whole(folder / "cracks.csv", output::crack_table(output::cracks_of(sim.get())));
  output::write_whole(folder / "fractures.csv", output::fracture_table(fractures));
  output::write_whole(folder / "discs.csv", output::disc_table(sim.get()));
  output::write_whole(folder / "bonds.csv", output::bond_table(sim.get()));
  output::write_whole(folder / "domains.csv", output::domain_table(sim.get()));
  const bool jointed = !output::integers(sim.get(), HFRAC_JOINT_BOND).empty();
  if (jointed) output::write_whole(folder / "joints.csv", output::joint_table(sim.get()));
  fmt::print("{}: cracks, fractures, discs, bonds, domains{} (.csv)\n", folder.string(),
             jointed ? ", joints" : "");
  if (!grid.empty()) {
    output::write_cells(sim.get(), std::llround(grid[0]), folder);
    fmt::print(
        "{}: cells.csv, permeability.grdecl, multipliers.grdecl: {} x {} cells of {:.6g} m x {:.6g} m\n",
        folder.string(), grid[0], grid[1], grid[2], grid[3]);
  }
  return kGood;
}

}  // namespace

void add_export(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("export", "Write the end of a run as CSV tables and Eclipse include files");
  auto request = std::make_shared<ExportRequest>();
  command->add_option("DIR", request->folder, "Run folder")->required();
  command->add_option("-o,--output", request->output, "Folder to write, DIR/export unless given")
      ->type_name("DIR");
  auto* cells =
      command->add_option("--cells", request->cells, "Cells over the whole model, for cells.csv and GRDECL");
  cells->type_name("NXxNY");
  command->add_option("--dx", request->dx, "Likewise, square cells of about this size [m]")
      ->check(positive_length())
      ->excludes(cells);
  command->callback([request, &action] { action = [request] { return write_tables(*request); }; });
}

}  // namespace hfrac::command
