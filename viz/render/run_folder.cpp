// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "failure.h"
#include "xml_tree.h"

namespace hfrac::viz {
namespace {

namespace fs = std::filesystem;

// "discs_00012.vtu" -> 12; -1 if there is no number
int snapshot_number(const fs::path& file) {
  const std::string stem = file.stem().string();
  std::size_t first = stem.size();
  while (first > 0 && std::isdigit(static_cast<unsigned char>(stem[first - 1])) != 0) --first;
  if (first == stem.size() || stem.size() - first > 9) return -1;
  return std::stoi(stem.substr(first));
}

Series read_series(const fs::path& folder, const std::string& kind) {
  Series series;
  const fs::path path = folder / (kind + ".pvd");
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return series;
  const std::unique_ptr<XmlElement> root = read_xml(path);
  const XmlElement* collection = root->child("Collection");
  if (collection == nullptr) fail_reading(path.string() + " is not a ParaView collection");
  int position = 0;
  for (const auto& entry : collection->children) {
    const std::string file = entry->attribute("file");
    if (file.empty()) continue;
    SeriesFile listed{folder / file, static_cast<double>(position)};
    const std::string time = entry->attribute("timestep");
    double seconds = 0;
    const auto [end, error] = std::from_chars(time.data(), time.data() + time.size(), seconds);
    if (error == std::errc() && std::isfinite(seconds)) listed.time = seconds;
    const int number = snapshot_number(listed.path);
    series[number >= 0 ? number : position] = std::move(listed);
    ++position;
  }
  return series;
}

double positive_number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return 0;
  const double value = found->get<double>();
  return std::isfinite(value) && value > 0 ? value : 0;
}

double number(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return 0;
  const double value = found->get<double>();
  return std::isfinite(value) ? value : 0;
}

std::string text(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Everything in it is optional; only a file that is no JSON at all is an error.
void read_summary(RunFolder& run) {
  const fs::path path = run.path / "summary.json";
  std::ifstream file(path);
  if (!file) return;
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (summary.is_discarded()) fail_reading(path.string() + " is not valid JSON");
  if (!summary.is_object()) return;
  run.title = text(summary, "title");
  run.net_pressures = text(summary, "stress_convention") == "effective";
  const auto model = summary.find("model");
  if (model != summary.end() && model->is_object()) {
    run.model_width = positive_number(*model, "width_m");
    run.model_height = positive_number(*model, "height_m");
  }
  run.going_on = text(summary, "ended") == "running";
  const auto planned = summary.find("planned");
  if (planned != summary.end() && planned->is_object()) {
    run.planned_time = positive_number(*planned, "time_s");
    run.planned_snapshots = static_cast<int>(std::min(1e6, positive_number(*planned, "snapshots")));
  }
  const auto wells = summary.find("wells");
  if (wells == summary.end() || !wells->is_array()) return;
  for (const nlohmann::json& well : *wells) {
    if (!well.is_object()) continue;
    run.wells.push_back({number(well, "x_m"), number(well, "y_m"), positive_number(well, "radius_m")});
  }
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
  return run;
}

}  // namespace hfrac::viz
