// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_folder.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/snapshot_grids.hpp"
#include "run/text.hpp"

namespace hfrac::run {
namespace {

namespace fs = std::filesystem;

double finite_at(const nlohmann::ordered_json& object, std::string_view path) {
  const double value = number_at(object, path);
  return std::isfinite(value) ? value : 0.0;
}

double positive_at(const nlohmann::ordered_json& object, std::string_view path) {
  return std::max(0.0, finite_at(object, path));
}

// Everything in it is optional; only a file that is no JSON object is an error.
void read_summary(RunFolder& run) {
  const fs::path path = run.path / "summary.json";
  if (std::error_code ignored; !fs::exists(path, ignored)) return;
  const auto summary = read_json(path);
  run.title = text_at(summary, "title");
  run.net_pressures = text_at(summary, "stress_convention") == "effective";
  run.model_width = positive_at(summary, "model.width_m");
  run.model_height = positive_at(summary, "model.height_m");
  run.going_on = text_at(summary, "ended") == "running";
  run.planned_time = positive_at(summary, "planned.time_s");
  run.planned_snapshots = static_cast<int>(std::min(1e6, positive_at(summary, "planned.snapshots")));
  const auto* wells = member(summary, "wells");
  if (wells == nullptr || !wells->is_array()) return;
  for (const auto& well : *wells)
    run.wells.push_back({finite_at(well, "x_m"), finite_at(well, "y_m"), positive_at(well, "radius_m"),
                         positive_at(well, "asked_radius_m")});
}

}  // namespace

RunFolder open_run(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) fail_reading("there is no folder " + folder.string());
  RunFolder run;
  run.path = folder;
  // Before the lists: a run writes its data, then the lists, last the summary. Whoever reads the other way round never
  // takes a run for over and misses its last snapshots.
  read_summary(run);
  run.discs = read_series(folder, "discs");
  if (run.discs.empty()) {
    fail_reading(folder.string() + " is not a run folder: discs.pvd is missing or lists no snapshots");
  }
  run.bonds = read_series(folder, "bonds");
  run.cracks = read_series(folder, "cracks");
  run.flow = read_series(folder, "flow");
  run.joints = read_series(folder, "joints");
  return run;
}

RunFolder run_in_memory(hfrac_sim* sim) {
  const SnapshotFrame frame(sim);
  const auto definition = definition_of(sim);
  RunFolder run;
  run.title = printable(definition.title);
  run.net_pressures = definition.stress_convention != 0;
  run.model_width = definition.model_width;
  run.model_height = definition.model_height;
  for (const auto& well : frame.wells)
    run.wells.push_back({well.x, well.y, well.equivalent_radius, well.radius});
  const auto hold = [&](Series& series, const char* name, std::string vtu) {
    series[frame.moment.step] = {fs::path("the simulation") / name, frame.moment.time,
                                 std::make_shared<const std::string>(std::move(vtu))};
  };
  hold(run.discs, "discs", encode(disc_grid(frame), frame.moment, Compression::none));
  hold(run.bonds, "bonds", encode(bond_grid(frame), frame.moment, Compression::none));
  hold(run.cracks, "cracks", encode(crack_grid(frame), frame.moment, Compression::none));
  hold(run.flow, "flow", encode(flow_grid(frame), frame.moment, Compression::none));
  if (frame.jointed) hold(run.joints, "joints", encode(joint_grid(frame), frame.moment, Compression::none));
  return run;
}

}  // namespace hfrac::run
