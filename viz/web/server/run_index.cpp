// SPDX-License-Identifier: BSD-3-Clause
// A snapshot is named by its step, the number in NAME_NNNNN.vtu, which is the same in all four lists.
#include "web/server/run_index.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <fstream>
#include <map>
#include <sstream>

namespace hfrac::web {
namespace fs = std::filesystem;

namespace {

using json = nlohmann::ordered_json;

constexpr std::array<const char*, 4> kSeries = {"discs", "bonds", "cracks", "flow"};
constexpr std::array<const char*, 7> kTables = {"case.toml",     "history.csv",  "cracks.csv", "events.csv",
                                                "fractures.csv", "summary.json", "report.html"};

struct Snapshot {
  double time = 0.0;
  std::map<std::string, std::string> files;  ///< by series
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/** "discs_00012.vtu" -> 12; -1 if there is no number. */
int64_t step_of(const std::string& file) {
  const size_t underscore = file.rfind('_');
  const size_t dot = file.rfind('.');
  if (underscore == std::string::npos || dot == std::string::npos || dot <= underscore) return -1;
  int64_t step = -1;
  const char* end = file.data() + dot;
  const auto result = std::from_chars(file.data() + underscore + 1, end, step);
  return result.ec == std::errc() && result.ptr == end ? step : -1;
}

void add_series(const fs::path& folder, const std::string& series, std::map<int64_t, Snapshot>& snapshots) {
  const std::string list = text_of(folder / (series + ".pvd"));
  if (list.empty()) return;
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(list.c_str()));
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr) return;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement* entry = collection->GetNestedElement(i);
    const char* file = entry->GetAttribute("file");
    double time = 0.0;
    if (file == nullptr || entry->GetScalarAttribute("timestep", time) == 0) continue;
    const int64_t step = step_of(file);
    if (step < 0) continue;
    snapshots[step].time = time;
    snapshots[step].files[series] = file;
  }
}

json snapshot_list(const fs::path& folder) {
  std::map<int64_t, Snapshot> snapshots;
  for (const char* series : kSeries) add_series(folder, series, snapshots);
  json list = json::array();
  for (const auto& [step, snapshot] : snapshots) {
    if (!snapshot.files.contains("discs")) continue;  // the lists are written one after the other
    list.push_back({{"step", step}, {"time_s", snapshot.time}, {"files", snapshot.files}});
  }
  return list;
}

json file_list(const fs::path& folder) {
  json list = json::array();
  std::error_code error;
  for (const char* name : kTables)
    if (const auto bytes = fs::file_size(folder / name, error); !error)
      list.push_back({{"name", name}, {"bytes", bytes}});
  std::vector<fs::path> pictures;
  for (fs::directory_iterator entry(folder / "pictures", error), end; !error && entry != end;
       entry.increment(error))
    if (entry->is_regular_file(error) && entry->path().filename().string().front() != '.')
      pictures.push_back(entry->path());
  std::sort(pictures.begin(), pictures.end());
  for (const auto& picture : pictures)
    if (const auto bytes = fs::file_size(picture, error); !error)
      list.push_back({{"name", "pictures/" + picture.filename().string()}, {"bytes", bytes}});
  return list;
}

/** A run begins by writing its case, and does so once: the file's own number and moment tell runs apart. */
std::string identity_of(const fs::path& folder) {
  struct stat status {};
  if (::stat((folder / "case.toml").c_str(), &status) != 0) return "";
  return fmt::format("{:x}-{:x}-{:x}", status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
}

int64_t age_of(const fs::path& folder) {
  std::error_code error;
  const auto written = fs::last_write_time(folder / "history.csv", error);
  if (error) return -1;
  const auto age = fs::file_time_type::clock::now() - written;
  return std::max<int64_t>(0, std::chrono::duration_cast<std::chrono::seconds>(age).count());
}

}  // namespace

json describe_run(const fs::path& folder) {
  json summary = json::parse(text_of(folder / "summary.json"), nullptr, false);
  if (!summary.is_object()) summary = nullptr;
  json index;
  index["folder"] = fs::absolute(folder).lexically_normal().filename().string();
  std::error_code error;
  index["there"] = fs::is_directory(folder, error);
  index["identity"] = identity_of(folder);
  index["running"] = summary.is_object() && summary.value("ended", "") == "running";
  index["age_s"] = age_of(folder);
  index["snapshots"] = snapshot_list(folder);
  index["summary"] = std::move(summary);
  index["files"] = file_list(folder);
  return index;
}

}  // namespace hfrac::web
