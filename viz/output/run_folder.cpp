// SPDX-License-Identifier: BSD-3-Clause
// The order of writing is the order of trust: first the data, then the lists that name them, last the
// summary.
#include "output/run_folder.hpp"

#include <fmt/format.h>

#include <utility>

#include "output/tables.hpp"
#include "run/files.hpp"
#include "run/known_files.hpp"
#include "run/snapshot_grids.hpp"

namespace hfrac::output {

RunFolder::RunFolder(std::filesystem::path folder, RunTerms terms, Writers writers)
    : folder_(std::move(folder)),
      start_(std::chrono::steady_clock::now()),
      pieces_(folder_, std::move(writers)),
      discs_(folder_, "discs"),
      bonds_(folder_, "bonds"),
      cracks_(folder_, "cracks"),
      flow_(folder_, "flow"),
      fractures_(folder_, "fractures"),
      joints_(folder_, "joints") {
  course_.terms = std::move(terms);
}

void RunFolder::take_pieces(hfrac_sim* sim) {
  for (auto* series : {&discs_, &bonds_, &flow_}) series->in_pieces(definition_of(sim).output_pieces);
}

void RunFolder::open(hfrac_sim* sim) {
  take_pieces(sim);
  write_whole(folder_ / "case.toml", case_text(definition_of(sim)));
  write_whole(folder_ / "history.csv", history_header(sim) + history_row(sim));
  snapshot(sim);
  begun_ = true;
}

void RunFolder::go_on_from(hfrac_sim* sim, const Checkpoint& checkpoint) {
  take_pieces(sim);
  snapshots_ = checkpoint.snapshots;
  std::vector<int64_t> steps;
  for (const auto& entry : snapshots_) steps.push_back(entry.step);
  // First the lists, so that none names what is taken away.
  for (auto* series : {&discs_, &bonds_, &cracks_, &flow_, &fractures_}) series->go_on_from(snapshots_);
  const SnapshotFrame frame(sim);
  if (frame.jointed) joints_.go_on_from(snapshots_);
  remove_later_files(folder_, steps);
  cut_history(checkpoint.step);
  CheckpointFolder(folder_).remove_after(checkpoint.step);
  course_.snapshots = static_cast<int64_t>(snapshots_.size());
  course_.steps_not_at_rest = checkpoint.steps_not_at_rest;
  earlier_seconds_ = checkpoint.wall_seconds;
  last_checkpoint_step_ = checkpoint.step;
  write_logs(frame);
  write_summary(frame);
  begun_ = true;
}

// A kill inside a write may have left part of a line at the end.
void RunFolder::cut_history(int64_t step) const {
  const auto file = folder_ / "history.csv";
  std::string text = read_whole(file);
  size_t end = text.find('\n');
  for (int64_t row = 0; row <= step && end != std::string::npos; ++row) {
    const std::string begin = std::to_string(row) + ",";
    if (text.compare(end + 1, begin.size(), begin) != 0) break;
    end = text.find('\n', end + 1);
    if (row < step || end == std::string::npos) continue;
    text.resize(end + 1);
    write_whole(file, text);
    return;
  }
  fail_reading(fmt::format("'{}' lacks lines of steps 0 to {}, so the run cannot go on where it was",
                           file.string(), step));
}

void RunFolder::checkpoint(hfrac_sim* sim) {
  Checkpoint checkpoint;
  checkpoint.step = state_of(sim).step;
  if (checkpoint.step == last_checkpoint_step_) return;
  checkpoint.snapshots = snapshots_;
  checkpoint.steps_not_at_rest = course_.steps_not_at_rest;
  checkpoint.wall_seconds = wall_seconds();
  checkpoint.image = state_image(sim);
  sync_file(folder_ / "history.csv");  // a checkpoint never is ahead of what it stands on
  CheckpointFolder(folder_).write(checkpoint);
  last_checkpoint_step_ = checkpoint.step;
}

void RunFolder::add_warning(int64_t step, std::string text) {
  if (course_.warnings.size() < kMostWarnings) course_.warnings.push_back({step, std::move(text)});
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
  std::vector<std::vector<hfrac_fracture_point>> lines;
  for (const auto& fracture : frame.fractures) lines.push_back(run::line_of(sim, fracture.index));
  write_whole(folder_ / "fracture_lines.csv", line_table(lines));
  write_whole(folder_ / "events.csv", event_table(events_of(frame.cracks, run::slips_of(sim), nullptr)));
  write_whole(folder_ / "state.hfrac", state_image(sim));
  write_summary(frame);
}

void RunFolder::finish_failed(hfrac_sim* sim, const std::string& why) noexcept {
  if (!begun_) return;
  pieces_.go_alone();
  try {
    finish(sim, "failed: " + why);
  } catch (...) {
    note_failure(sim, why);
  }
}

void RunFolder::note_failure(hfrac_sim* sim, const std::string& why) noexcept {
  if (!begun_) return;
  try {
    course_.ended = "failed: " + why;
    write_summary(SnapshotFrame(sim));
  } catch (...) {  // the disk may still be full; the caller tells the user in any case
  }
}

void RunFolder::write_series(const SnapshotFrame& frame) {
  const int64_t step = frame.state.step;
  const bool due = snapshots_.empty() || step != snapshots_.back().step;
  const SnapshotEntry entry{step, frame.state.time};
  const auto definition = definition_of(frame.sim);
  const auto text_of = [&](const run::VtuGrid& grid) {
    return encode(grid, frame.moment, static_cast<Compression>(definition.output_compression),
                  static_cast<int>(definition.run_workers));
  };
  if (definition.output_pieces > 1) {
    const auto lists = pieces_.write(frame, due);
    if (!due) return;
    discs_.add(entry, lists.discs);
    bonds_.add(entry, lists.bonds);
    flow_.add(entry, lists.flow);
  } else {
    if (!due) return;
    discs_.add(entry, text_of(disc_grid(frame)));
    bonds_.add(entry, text_of(bond_grid(frame)));
    flow_.add(entry, text_of(flow_grid(frame)));
  }
  fractures_.add(entry, text_of(fracture_grid(frame)));
  if (frame.jointed) joints_.add(entry, text_of(joint_grid(frame)));
  cracks_.add(entry, text_of(crack_grid(frame)));
  write_logs(frame);
  snapshots_.push_back(entry);
  ++course_.snapshots;
}

// A model without smooth joints has no slips.csv.
void RunFolder::write_logs(const SnapshotFrame& frame) {
  write_whole(folder_ / "cracks.csv", crack_table(frame.cracks));
  if (const auto slips = run::slips_of(frame.sim); !slips.empty())
    write_whole(folder_ / "slips.csv", slip_table(slips));
}

double RunFolder::wall_seconds() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  return earlier_seconds_ + elapsed.count();
}

void RunFolder::write_summary(const SnapshotFrame& frame) {
  course_.wall_seconds = wall_seconds();
  write_whole(folder_ / "summary.json", make_summary(frame, course_).dump(2) + "\n");
}

}  // namespace hfrac::output
