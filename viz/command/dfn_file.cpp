// SPDX-License-Identifier: BSD-3-Clause
#include "command/dfn_file.hpp"

#include <fmt/format.h>
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <filesystem>
#include <iterator>

#include "command/exit_code.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"

namespace hfrac::command {
namespace {

std::string as_table(const std::vector<Trace>& traces, const std::string& remark) {
  std::string text = fmt::format("# {}\nFID,START_X,START_Y,END_X,END_Y,SET\n", remark);
  for (size_t k = 0; k < traces.size(); ++k) {
    const Trace& t = traces[k];
    fmt::format_to(std::back_inserter(text), "{},{:.4f},{:.4f},{:.4f},{:.4f},{}\n", k, t.from.x, t.from.y,
                   t.to.x, t.to.y, t.set + 1);
  }
  return text;
}

/** RFC 7946 but for its coordinates, which are metres of the model. */
std::string as_geojson(const std::vector<Trace>& traces) {
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [\n";
  for (size_t k = 0; k < traces.size(); ++k) {
    const Trace& t = traces[k];
    fmt::format_to(
        std::back_inserter(text),
        "{{\"type\": \"Feature\", \"properties\": {{\"FID\": {}, \"SET\": {}}}, \"geometry\": "
        "{{\"type\": \"LineString\", \"coordinates\": [[{:.4f}, {:.4f}], [{:.4f}, {:.4f}]]}}}}{}\n",
        k, t.set + 1, t.from.x, t.from.y, t.to.x, t.to.y, k + 1 < traces.size() ? "," : "");
  }
  return text + "]}\n";
}

}  // namespace

void write_traces(const std::string& path, const std::vector<Trace>& traces, const std::string& remark) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".csv" && ending != ".geojson" && ending != ".json")
    throw BadInput(fmt::format("--output {}: traces are written as .csv, .geojson or .json", path));
  run::write_whole(path, ending == ".csv" ? as_table(traces, remark) : as_geojson(traces));
}

std::vector<Trace> read_traces(const std::string& path) {
  Definition definition;
  if (hfrac_sim_def_add_traces(&definition, path.c_str()) < 0) throw BadInput(run::error_text(-1, nullptr));
  std::vector<Trace> traces;
  for (int64_t k = 0; k < definition.joint_count; ++k) {
    const hfrac_joint_def& joint = definition.joints[k];
    traces.push_back({{joint.x1, joint.y1}, {joint.x2, joint.y2}, 0});
  }
  return traces;
}

}  // namespace hfrac::command
