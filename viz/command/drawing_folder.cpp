// SPDX-License-Identifier: BSD-3-Clause
#include "command/drawing_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

bool may_write(const fs::path& folder) {
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

void link_files(const fs::path& from, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.is_regular_file())
      fs::create_symlink(fs::canonical(entry.path()), to / entry.path().filename());
}

}  // namespace

DrawingFolder::DrawingFolder(const fs::path& run) : path_(run) {
  const fs::path drawn = run / "pictures";
  std::error_code error;
  if (!fs::is_directory(run, error) || may_write(fs::exists(drawn, error) ? drawn : run)) return;
  std::string name = (fs::temp_directory_path() / "hfrac-report-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw fs::filesystem_error("cannot make a folder to draw in", name,
                               std::error_code(errno, std::generic_category()));
  path_ = name;
  own_ = true;
  fs::create_directory(path_ / "pictures");
  link_files(run, path_);
  if (fs::exists(drawn, error)) link_files(drawn, path_ / "pictures");
}

DrawingFolder::~DrawingFolder() {
  std::error_code ignored;
  if (own_) fs::remove_all(path_, ignored);
}

}  // namespace hfrac::command
