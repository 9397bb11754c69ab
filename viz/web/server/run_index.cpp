// SPDX-License-Identifier: BSD-3-Clause
// A snapshot is named by its step, the number in NAME_NNNNN.vtu, which is the same in all four lists.
#include "web/server/run_index.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>

#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/series.hpp"
#include "run/views.hpp"

namespace hfrac::web {
namespace fs = std::filesystem;

namespace {

using json = nlohmann::ordered_json;

constexpr std::array<const char*, 8> kTables = {"case.toml",  "history.csv",   "record.csv",   "cracks.csv",
                                                "events.csv", "fractures.csv", "summary.json", "report.html"};

// A damaged list or summary is as none: the page shows what there is.
run::Series series_in(const fs::path& folder, const char* name) {
  try {
    return run::read_series(folder, name);
  } catch (const run::ReadError&) {
    return {};
  }
}

json summary_in(const fs::path& folder) {
  try {
    return run::read_json(folder / "summary.json");
  } catch (const run::ReadError&) {
    return nullptr;
  }
}

json snapshot_list(const fs::path& folder) {
  std::map<int64_t, json> snapshots;
  for (const char* name : run::series_names) {
    for (const auto& [step, file] : series_in(folder, name)) {
      json& snapshot = snapshots[step];
      snapshot["step"] = step;
      snapshot["time_s"] = file.time;
      snapshot["files"][name] = file.path.filename().string();
    }
  }
  json list = json::array();
  for (auto& [step, snapshot] : snapshots)
    if (snapshot["files"].contains("discs"))
      list.push_back(std::move(snapshot));  // lists are written in turn
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

json view_list() {
  json list = json::array();
  for (const auto& view : run::all_views()) {
    list.push_back({{"name", view.name},
                    {"title", view.title},
                    {"label", view.label},
                    {"note", view.note},
                    {"mesh", view.mesh},
                    {"array", view.array},
                    {"how", run::name_of(view.how)},
                    {"component", view.component},
                    {"scale", run::name_of(view.scale)},
                    {"all_values", view.all_values},
                    {"states", view.states}});
  }
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
  json summary = summary_in(folder);
  json index;
  index["folder"] = fs::absolute(folder).lexically_normal().filename().string();
  std::error_code error;
  index["there"] = fs::is_directory(folder, error);
  index["identity"] = identity_of(folder);
  index["running"] = run::text_at(summary, "ended") == "running";
  index["age_s"] = age_of(folder);
  index["snapshots"] = snapshot_list(folder);
  index["summary"] = std::move(summary);
  index["files"] = file_list(folder);
  index["views"] = view_list();
  return index;
}

}  // namespace hfrac::web
