// SPDX-License-Identifier: BSD-3-Clause
// The order of writing is the order of trust: first the data, then the lists that name them, last the
// summary.
#include "output/run_folder.hpp"

#include <utility>

#include "output/safe_file.hpp"
#include "output/tables.hpp"

namespace hfrac::output {

RunFolder::RunFolder(std::filesystem::path folder)
    : folder_(std::move(folder)),
      start_(std::chrono::steady_clock::now()),
      discs_(folder_, "discs"),
      bonds_(folder_, "bonds"),
      cracks_(folder_, "cracks"),
      flow_(folder_, "flow") {}

void RunFolder::open(hfrac_sim* sim) {
  write_whole(folder_ / "case.toml", case_text(definition_of(sim)));
  write_whole(folder_ / "history.csv", history_header(wells_of(sim).size()) + history_row(sim));
  snapshot(sim);
}

void RunFolder::record_step(hfrac_sim* sim) {
  append_whole(folder_ / "history.csv", history_row(sim));
  if (state_of(sim).at_rest == 0) ++course_.steps_not_at_rest;
}

void RunFolder::snapshot(hfrac_sim* sim) {
  const SnapshotFrame frame(sim);
  write_series(frame);
  write_summary(frame);
}

void RunFolder::finish(hfrac_sim* sim, const std::string& why_ended) {
  course_.ended = why_ended;
  const SnapshotFrame frame(sim);
  write_series(frame);
  write_whole(folder_ / "fractures.csv", fracture_table(frame.fractures));
  write_whole(folder_ / "events.csv", event_table(events_of(frame.cracks, nullptr)));
  write_summary(frame);
}

void RunFolder::finish_failed(hfrac_sim* sim, const std::string& why) noexcept {
  try {
    finish(sim, "failed: " + why);
  } catch (...) {
    note_failure(sim, why);
  }
}

void RunFolder::note_failure(hfrac_sim* sim, const std::string& why) noexcept {
  try {
    course_.ended = "failed: " + why;
    write_summary(SnapshotFrame(sim));
  } catch (...) {  // the disk may still be full; the caller tells the user in any case
  }
}

void RunFolder::write_series(const SnapshotFrame& frame) {
  const int64_t step = frame.state.step;
  if (step == last_snapshot_step_) return;
  const double time = frame.state.time;
  discs_.add(step, time, disc_vtu(frame));
  bonds_.add(step, time, bond_vtu(frame));
  flow_.add(step, time, flow_vtu(frame));
  cracks_.add(step, time, crack_vtu(frame));
  write_whole(folder_ / "cracks.csv", crack_table(frame.cracks));
  last_snapshot_step_ = step;
  ++course_.snapshots;
}

void RunFolder::write_summary(const SnapshotFrame& frame) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  course_.wall_seconds = elapsed.count();
  write_whole(folder_ / "summary.json", make_summary(frame, course_).dump(2) + "\n");
}

}  // namespace hfrac::output
