// SPDX-License-Identifier: BSD-3-Clause
// Names are matched as a whole; anything else in the folder is left alone.
#include "run/known_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <regex>
#include <string>

#include "run/files.hpp"

namespace hfrac::run {
namespace fs = std::filesystem;

namespace {

/** Adds to `files` those in `folder` whose whole name matches. */
void collect(const fs::path& folder, const std::regex& name, std::vector<fs::path>& files) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->is_regular_file(error) && std::regex_match(entry->path().filename().string(), name))
      files.push_back(entry->path());
}

}  // namespace

std::vector<fs::path> files_of_a_run(const fs::path& folder) {
  static const std::string data =
      R"((discs|bonds|cracks|flow|fractures|joints)(_[0-9]{5,}(_[0-9]{4,}\.vtu|\.p?vtu)|\.pvd)|)"
      R"((history|record|cracks|slips|fractures|fracture_lines|events|cells|given_discs|given_bonds)\.csv|(permeability|multipliers)\.grdecl|)"
      R"(summary\.json|case\.toml|state\.hfrac|hfrac_probe|report\.html|paraview_state\.py)";
  static const std::string pictures =
      R"((model|growth|growth_[1-5]|pressure|aperture|views|history|rose|profile|events|catalogue)\.(png|svg|pdf)|)"
      R"(movie\.mp4|(kgd|record)\.(png|svg|pdf|csv))";
  const std::string checkpoints = R"(step_[0-9]{5,}\.checkpoint)";
  const auto with_unfinished = [](const std::string& names) {
    return std::regex("(" + names + R"()|\.()" + names + R"()\.[0-9]+-[0-9]+\.tmp)");
  };
  std::vector<fs::path> files;
  collect(folder, with_unfinished(data), files);
  collect(folder / "checkpoints", with_unfinished(checkpoints), files);
  collect(folder / "pictures", with_unfinished(pictures), files);
  std::sort(files.begin(), files.end());
  return files;
}

void remove_files_of_a_run(const fs::path& folder) {
  for (const auto& file : files_of_a_run(folder)) remove_file(file);
}

void remove_later_files(const fs::path& folder, const std::vector<int64_t>& kept) {
  static const std::regex snapshot(
      R"((?:discs|bonds|cracks|flow|fractures|joints)_([0-9]{5,})(?:_[0-9]{4,}\.vtu|\.p?vtu))"),
      of_the_end(
          R"((slips|fractures|fracture_lines|cells)\.csv|(permeability|multipliers)\.grdecl|\..*\.tmp)");
  for (const auto& file : files_of_a_run(folder)) {
    const std::string name = file.filename().string();
    std::smatch match;
    const bool is_snapshot = std::regex_match(name, match, snapshot);
    if (is_snapshot ? std::find(kept.begin(), kept.end(), std::stoll(match[1])) == kept.end()
                    : std::regex_match(name, of_the_end))
      remove_file(file);
  }
}

FolderClaim::FolderClaim(const fs::path& folder) {
  for (fs::path path = fs::absolute(folder).lexically_normal(); !fs::exists(path);
       path = path.parent_path()) {
    if (path.has_filename()) made_.push_back(path);
    if (path == path.parent_path()) break;
  }
  make_folder(folder);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw WriteError(fmt::format("'{}' is not a folder", folder.string()));
  const auto probe = folder / "hfrac_probe";
  write_whole(probe, std::string_view());
  remove_file(probe);
  lock(folder);
}

// A lock on the folder itself leaves nothing behind. Where a file system knows no locks, there is none.
void FolderClaim::lock(const fs::path& folder) {
  lock_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(lock_);
  throw WriteError(fmt::format("another process is writing a run into '{}'", folder.string()));
}

bool FolderClaim::is_held(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

FolderClaim::~FolderClaim() {
  if (lock_ >= 0) ::close(lock_);
  std::error_code ignored;
  for (const auto& path : made_) fs::remove(path, ignored);  // removes a folder only if it is empty
}

}  // namespace hfrac::run
