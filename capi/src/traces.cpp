// SPDX-License-Identifier: BSD-3-Clause
#include "traces.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "text_file.hpp"
#include "trace_list.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::size_t most_traces = 100'000;
constexpr double farthest = 1e6;  // m, as of a joint's ends

bool is_geojson(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return ending == ".geojson" || ending == ".json";
}

}  // namespace

void TraceList::refuse(const std::string& fault) const {
  throw Error(ErrorKind::case_file, printable(path_, 400) + ":" + std::to_string(line) + ": " + part + fault);
}

void TraceList::check_coordinate(double value, std::string_view name, std::string_view shown) const {
  if (std::abs(value) <= farthest) return;
  refuse(std::string(name) + " = " + printable(shown) + " is not a number from -1e6 to 1e6 m.");
}

void TraceList::add(Vec2 from, Vec2 to) {
  if (joints_.size() == most_traces)
    refuse("more than " + std::to_string(most_traces) + " traces; leave out the shortest.");
  if (from.x == to.x && from.y == to.y) refuse("the trace has no length: both ends are at the same place.");
  joints_.push_back(like_);
  joints_.back().x1 = from.x;
  joints_.back().y1 = from.y;
  joints_.back().x2 = to.x;
  joints_.back().y2 = to.y;
}

std::string beside(const std::string& case_file, const std::string& path) {
  const std::filesystem::path given(path);
  return given.is_absolute() ? path : (std::filesystem::path(case_file).parent_path() / given).string();
}

std::vector<JointOptions> read_traces(const std::string& path, const JointOptions& like) {
  const bool geojson = is_geojson(path);
  const std::string text = read_text_file(path, geojson ? geojson_limits : trace_table_limits);
  std::string_view content = text;
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);  // some programs begin UTF-8 so
  TraceList traces(path, like);
  geojson ? read_geojson(content, traces) : read_csv(content, traces);
  return traces.take();
}

}  // namespace hfrac::capi
