// SPDX-License-Identifier: BSD-3-Clause
// The grids shown last, kept decoded: going back and forth in time then reads no file twice.
#pragma once

#include <list>
#include <mutex>

#include "web/server/grid.hpp"

namespace hfrac::web {

class GridCache {
 public:
  /** Keeps grids of up to `limit` bytes in all, the one read last always. */
  explicit GridCache(size_t limit) : limit_(limit) {}

  /** The grid in `file`, read if it is not kept or if the file has changed since. Safe to call from several
   * threads; files are read one at a time. Throws GridError. */
  std::shared_ptr<const Grid> get(const std::filesystem::path& file);

 private:
  struct Entry {
    std::filesystem::path file;
    std::filesystem::file_time_type written;
    std::shared_ptr<const Grid> grid;
    size_t bytes;
  };

  std::mutex mutex_;
  std::list<Entry> entries_;  ///< the one used last in front
  size_t limit_;
  size_t held_ = 0;
};

}  // namespace hfrac::web
