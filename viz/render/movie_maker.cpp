// SPDX-License-Identifier: BSD-3-Clause
#include "movie_maker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>

#include "failure.h"
#include "guarded_call.h"
#include "movie_file.h"
#include "number_text.h"
#include "pictures.h"
#include "run/files.hpp"
#include "run/table_file.hpp"
#include "sheet.h"
#include "snapshot.h"
#include "vtk_messages.h"

namespace hfrac::viz {

namespace {

constexpr std::size_t most_curve_points = 1500;  // of a curve: more cannot be told apart

// The column takes all the width the view leaves.
constexpr SheetShape movie_shape{1400, 440, 640, true};

void add_point(MovieCurves& curves, double time, double pressure, double cracks) {
  if (!std::isfinite(time)) return;
  curves.time.push_back(time);
  curves.pressure.push_back(pressure);
  curves.cracks.push_back(cracks);
}

// The next of 1, 2, 5 times a power of ten, so that an axis grows in few jumps.
double rounded_up(double value) {
  if (!(value > 0)) return 1;
  double round = round_length(value);
  while (round < value) round = round_length(round * 2.6);
  return round;
}

std::vector<Note> frame_notes(const HistoryPoint& point) {
  std::vector<Note> notes = {{"time", time_text(point.moment.time)}};
  if (point.moment.step >= 0) notes.push_back({"step", count_text(point.moment.step)});
  notes.push_back(
      {"tension / shear", count_text(point.tensile_cracks) + " / " + count_text(point.shear_cracks)});
  return notes;
}

}  // namespace

MovieCurves movie_curves(const RunFolder& run, const std::vector<HistoryPoint>& history, bool live) {
  MovieCurves curves;
  const auto path = run.path / "history.csv";
  const auto table = is_file(path) ? std::optional<TableFile>(path) : std::nullopt;
  if (table && table->rows() > 1) {
    const std::vector<double> time = table->numbers("time_s");
    const std::vector<double> pressure = table->numbers("well_pressure_Pa");
    const std::vector<double> cracks = table->numbers("crack_count");
    for (std::size_t i = 0; i < time.size(); ++i) add_point(curves, time[i], pressure[i], cracks[i]);
  } else {
    for (const HistoryPoint& point : history) {
      const auto& wells = point.moment.well_pressure;
      add_point(curves, point.moment.time, wells.empty() ? std::nan("") : wells.front(), point.cracks());
    }
  }
  curves.end_time = live ? run.planned_time : (curves.time.empty() ? 0.0 : curves.time.back());
  if (live) return curves;
  for (std::size_t i = 0; i < curves.time.size(); ++i) {
    if (std::isfinite(curves.pressure[i]))
      curves.top_pressure = std::max(curves.top_pressure, curves.pressure[i]);
    curves.top_cracks = std::max(curves.top_cracks, curves.cracks[i]);
  }
  return curves;
}

PictureSize movie_size(const Studio& studio, const Discs& discs) {
  return {studio.size.width, sheet_height(studio, whole_model(*studio.run, discs), movie_shape)};
}

void movie_frame(const Studio& studio, const Scene& scene, const MovieCurves& curves, const PageSink& sink) {
  Sheet sheet(studio, whole_model(*studio.run, scene.discs), movie_shape);
  add_growth_layers(sheet.view, sheet.page, *studio.run, scene, sheet.metres(1));
  draw_sheet_title(sheet, *studio.run, "Fracture growth");
  draw_axes(sheet.page, sheet.unit, sheet.view);
  const double unit = sheet.unit;
  const double now = scene.point.moment.time;
  const double below = draw_note_row(sheet.page, unit, sheet.column_left, sheet.column_top,
                                     sheet.column_width, frame_notes(scene.point));

  // What has come until now; the axes' ends are the run's, or as far as it has come.
  std::size_t count = 0;
  const double just_after = now * (1 + 1e-9);
  while (count < curves.time.size() && curves.time[count] <= just_after) ++count;
  double pressure_now =
      scene.point.moment.well_pressure.empty() ? std::nan("") : scene.point.moment.well_pressure.front();
  double top_pressure = curves.top_pressure;
  double top_cracks = curves.top_cracks;
  double highest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(curves.pressure[i])) highest = std::max(highest, curves.pressure[i]);
    if (curves.top_cracks <= 0) top_cracks = std::max(top_cracks, curves.cracks[i]);
  }
  if (!(top_pressure > 0)) top_pressure = rounded_up(highest);
  if (!(curves.top_cracks > 0)) top_cracks = rounded_up(std::max(10.0, top_cracks));
  const double end = curves.end_time > 0 ? std::max(curves.end_time, now) : rounded_up(now);

  const Quantity time = quantity_of("time_s", end);
  const Quantity pressure = quantity_of("well_pressure_Pa", top_pressure);
  const std::string net = studio.run->net_pressures ? ", net" : "";
  std::vector<double> times(curves.time.begin(), curves.time.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<double> pressures(curves.pressure.begin(),
                                curves.pressure.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<double> cracks(curves.cracks.begin(),
                             curves.cracks.begin() + static_cast<std::ptrdiff_t>(count));
  const std::size_t step = std::max<std::size_t>(1, count / most_curve_points);
  for (std::vector<double>* values : {&times, &pressures, &cracks}) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < values->size(); ++i) {
      if (i % step == 0 || i + 1 == values->size()) kept.push_back((*values)[i]);
    }
    *values = std::move(kept);
  }
  for (double& value : times) value *= time.scale;
  for (double& value : pressures) value *= pressure.scale;
  std::vector<Curve> shown;
  if (std::isfinite(pressure_now) &&
      std::any_of(pressures.begin(), pressures.end(), [](double p) { return std::isfinite(p); })) {
    shown.push_back({"well pressure" + net + " (" + pressure.unit + ")", times, pressures, end * time.scale,
                     top_pressure * pressure.scale,
                     value_text(std::round(pressure_now * pressure.scale * 100) / 100), palette().well,
                     false});
  }
  shown.push_back({"cracks", times, cracks, end * time.scale, std::max(1.0, top_cracks),
                   count_text(scene.point.cracks()), palette().tension, true});
  const double first_top = below + 84 * unit;
  const double gap = 96 * unit;
  const auto pieces = static_cast<double>(shown.size());
  const double height = (sheet.column_bottom - first_top - (pieces - 1) * gap) / pieces;
  double top = first_top;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Box box{sheet.column_left + 58 * unit, top, sheet.column_width - 78 * unit, height};
    draw_curve(sheet.page, unit, box, shown[i], i + 1 == shown.size() ? time.label() : "");
    top += height + gap;
  }
  sink(sheet.page);
}

namespace {

constexpr int highest_frame_rate = 60;  // [1/s]
constexpr int unknown_length_rate = 10;
constexpr int piece_frames = 10;  // while a run goes on
constexpr std::chrono::milliseconds poll_time{300};

// A run of `count` snapshots in so many seconds: every stride-th one is a frame.
struct Pace {
  int stride = 1;
  int rate = unknown_length_rate;

  Pace(int count, int seconds) {
    if (count <= 0) return;
    const int most = seconds * highest_frame_rate;
    stride = std::max(1, (count + most - 1) / most);
    const int frames = (count + stride - 1) / stride;
    rate = std::clamp((frames + seconds - 1) / seconds, 2, highest_frame_rate);
  }
};

class MovieMaker {
 public:
  MovieMaker(const std::filesystem::path& folder, const std::filesystem::path& target,
             const hfrac_viz_options& options, const Progress& progress)
      : folder_(folder),
        target_(target),
        options_(options),
        progress_(progress),
        window_(make_offscreen_window()),
        run_(open_run(folder)),
        live_(options.movie_follow != 0) {
    extend_history(run_, history_);
    const int count = live_ ? run_.planned_snapshots : static_cast<int>(history_.size());
    pace_ = Pace(count, options.movie_seconds);
    format_.kind = target.extension() == ".webp" ? VideoKind::webp : VideoKind::h264;
    format_.rate = pace_.rate;
    const Discs first = read_discs(run_.discs.at(history_.front().number));
    const PictureSize size = movie_size({nullptr, &run_, {options.movie_width, options.movie_height}}, first);
    format_.width = size.width;
    format_.height = size.height;
  }

  // The packets of the whole movie are kept, a few megabytes. One that follows a run is encoded in pieces that can be decoded
  // by themselves, since an encoder holds frames back, and written anew after each of them.
  void make() {
    if (format_.kind == VideoKind::webp && live_)
      fail_argument("a movie that follows a run ends in .mp4; " + target_.string() + " does not");
    std::vector<VideoPacket> packets;
    for (int drawn = 0;;) {
      const bool over = !live_ || !run_.going_on;
      const std::vector<int> frames = frames_so_far(over);
      const auto count = static_cast<int>(frames.size());
      while (drawn < count && (over || drawn + piece_frames <= count)) {
        const int end = live_ ? std::min(count, drawn + piece_frames) : count;
        encode(frames, drawn, end, packets);
        drawn = end;
        if (!over) write(packets);
      }
      if (over) break;
      wait(count);
      run_ = open_run(folder_);
      extend_history(run_, history_);
    }
    write(packets);
  }

 private:
  // Indices into the history. Of a whole run backwards from the end, so that the last snapshot is always the last
  // picture; of a running one forwards.
  std::vector<int> frames_so_far(bool over) const {
    const auto count = static_cast<int>(history_.size());
    std::vector<int> frames;
    const int first = live_ ? 0 : (count - 1) % pace_.stride;
    for (int index = first; index < count; index += pace_.stride) frames.push_back(index);
    if (over && frames.back() != count - 1) frames.push_back(count - 1);
    return frames;
  }

  void tell(int frame, int count) const {
    const int total = live_ && run_.going_on ? std::max(count, run_.planned_snapshots / pace_.stride) : count;
    const double share = total > 0 ? std::min(1.0, static_cast<double>(frame) / total) : 0.0;
    if (progress_ && progress_(share, target_.filename().string())) throw Stopped{};
  }

  void wait(int frames) const {
    tell(frames, frames);
    const DrawingPause pause;
    std::this_thread::sleep_for(poll_time);
  }

  Image frame(int index, const MovieCurves& curves) const {
    VtkMessages messages;
    const Studio studio{window_, &run_, {format_.width, format_.height}};
    Image image;
    movie_frame(studio, load_scene(run_, history_[index], false, false), curves,
                [&](Page& page) { image = page.draw(); });
    messages.demand_none();
    return image;
  }

  void encode(const std::vector<int>& frames, int first, int end, std::vector<VideoPacket>& packets) const {
    const MovieCurves curves = movie_curves(run_, history_, live_);
    const auto keep = [&](VideoPacket packet) {
      packet.shown += first;
      packet.decoded += first;
      packets.push_back(std::move(packet));
    };
    VideoEncoder encoder(format_);
    for (int i = first; i < end; ++i) {
      tell(i, static_cast<int>(frames.size()));
      encoder.add(frame(frames[i], curves), keep);
    }
    encoder.finish(keep);
  }

  void write(const std::vector<VideoPacket>& packets) const {
    const VideoEncoder encoder(format_);  // for what the container has to know
    MovieFile movie(target_, format_, encoder);
    for (const VideoPacket& packet : packets) movie.add(packet);
    movie.finish();
  }

  std::filesystem::path folder_;
  std::filesystem::path target_;
  hfrac_viz_options options_;
  const Progress& progress_;
  vtkSmartPointer<OffscreenWindow> window_;
  RunFolder run_;
  bool live_;
  std::vector<HistoryPoint> history_;
  Pace pace_{0, 1};
  VideoFormat format_;
};

}  // namespace

void make_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                const hfrac_viz_options& options, const Progress& progress) {
  MovieMaker(folder, target, options, progress).make();
}

}  // namespace hfrac::viz
