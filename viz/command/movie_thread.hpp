// SPDX-License-Identifier: BSD-3-Clause
// `hfrac run --movie`: a thread that draws the movie's frames while the run goes on, out of the files the run writes.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

namespace hfrac::command {

class MovieThread {
 public:
  /** Starts once the run's first snapshot is there; the movie is DIR/pictures/movie.mp4. */
  explicit MovieThread(const std::filesystem::path& folder);
  ~MovieThread();
  MovieThread(const MovieThread&) = delete;
  MovieThread& operator=(const MovieThread&) = delete;

  /** The run's summary says how it ended: draws the rest. Gives why there is no movie, empty if there is one. */
  std::string finish();

 private:
  std::filesystem::path folder_;
  std::atomic<bool> give_up_{false};
  std::string failure_;
  std::thread thread_;
};

}  // namespace hfrac::command
