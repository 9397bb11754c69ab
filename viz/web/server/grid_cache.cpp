// SPDX-License-Identifier: BSD-3-Clause
#include "web/server/grid_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "web/server/averages.hpp"

namespace hfrac::web {

std::shared_ptr<const Grid> GridCache::get(const std::filesystem::path& file) {
  const std::scoped_lock lock(mutex_);
  std::error_code error;
  const auto written = std::filesystem::last_write_time(file, error);
  if (error) throw GridError(fmt::format("'{}' is not there any more", file.string()));

  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.file == file; });
  if (found != entries_.end() && found->written == written) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().grid;
  }
  if (found != entries_.end()) {
    held_ -= found->bytes;
    entries_.erase(found);
  }
  auto grid = averaged(read_grid(file), kMostDrawn);
  const size_t bytes = grid->bytes();
  entries_.push_front({file, written, grid, bytes});
  held_ += bytes;
  while (held_ > limit_ && entries_.size() > 1) {
    held_ -= entries_.back().bytes;
    entries_.pop_back();
  }
  return grid;
}

}  // namespace hfrac::web
