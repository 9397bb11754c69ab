// SPDX-License-Identifier: BSD-3-Clause
// The page's server: reads a run folder, writes nothing, listens on 127.0.0.1 only.
//
//   GET /KEY/                      the page; viewer.js and viewer.css beside it; without the last slash: sent there
//   GET /KEY/api/run               what there is to show (run_index.hpp)
//   GET /KEY/api/history?from=N    history.csv from byte N to its last whole line
//   GET /KEY/api/record            a field's pressures beside the first well's, "time_s,pressure_Pa"; empty: there are none
//   GET /KEY/api/grid?file=F       a VTU file as a message (grid.hpp); &arrays=A,B: only these
//   GET /KEY/api/values?file=F&of=points|cells&index=I    all values of one disc, crack, bond or domain
//   GET /KEY/files/F               a file of the run, to be saved
//
// Answers are whole: ranges are not served. Everything else is 404, other methods 405, other hosts 403 (guards.hpp). Errors are one sentence of text.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace hfrac::web {

class PageServer {
 public:
  /** `measured`: a field's pressures, "time_s,pressure_Pa"; empty: those of the run's record.csv, if it has one. */
  explicit PageServer(std::filesystem::path folder, std::string measured = {});
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  ~PageServer();

  /** Takes `port` of 127.0.0.1, any free one for 0. False if it cannot be had. */
  bool bind(int port);

  /** Where the page is; valid after bind. */
  std::string address() const;

  /** Answers until stop() is called from another thread, once, at any time after the thread of serve() was made. */
  void serve();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hfrac::web
