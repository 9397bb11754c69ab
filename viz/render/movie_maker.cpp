// SPDX-License-Identifier: BSD-3-Clause
#include "movie_maker.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "failure.h"
#include "guarded_call.h"
#include "history.h"
#include "movie_file.h"
#include "movie_picture.h"
#include "movie_reel.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

constexpr int highest_frame_rate = 60;  // [1/s]
constexpr int unknown_length_rate = 10;
constexpr int piece_frames = 10;
constexpr std::chrono::milliseconds poll_time{300};
constexpr const char* drawing_version = "1";  // of the frames' look: pieces of another one are not used

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
        live_(options.movie_follow != 0 && run_.going_on) {
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

  void make() {
    if (format_.kind == VideoKind::webp) {
      if (live_) fail_argument("a movie that follows a run ends in .mp4; " + target_.string() + " does not");
      make_at_once();
      return;
    }
    const MovieReel reel(target_);
    int pieces = 0;
    while (true) {
      const bool over = !live_ || !run_.going_on;
      const std::vector<int> frames = frames_so_far(over);
      const auto count = static_cast<int>(frames.size());
      for (; pieces * piece_frames < count && (over || (pieces + 1) * piece_frames <= count); ++pieces) {
        const int first = pieces * piece_frames;
        make_piece(reel, pieces, frames, first, std::min(count, first + piece_frames));
        if (!over) reel.assemble(format_, pieces + 1);  // to be looked at meanwhile
      }
      if (over) break;
      wait(count);
      run_ = open_run(folder_);
      extend_history(run_, history_);
    }
    reel.assemble(format_, pieces);
    reel.remove();
  }

 private:
  // Indices into the history. Of a finished run backwards from the end, so that the last snapshot is always the last
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
    const std::string errors = messages.take_errors();
    if (!errors.empty()) fail_drawing("drawing failed: " + errors);
    return image;
  }

  // All that the frames of a piece depend on.
  std::string signature(const std::vector<int>& frames, int first, int end, const MovieCurves& curves) const {
    std::string text = std::string(drawing_version) + ' ' + std::to_string(format_.width) + 'x' +
                       std::to_string(format_.height) + ' ' + std::to_string(format_.rate) + ' ' +
                       std::to_string(options_.dark) + (live_ ? " live " : " whole ") +
                       std::to_string(curves.end_time);
    if (!live_) text += ' ' + std::to_string(curves.top_pressure) + ' ' + std::to_string(curves.top_cracks);
    text += '\n' + run_.title;
    for (int i = first; i < end; ++i) {
      const int number = history_[frames[i]].number;
      const std::filesystem::path& file = run_.discs.at(number).path;
      std::error_code ignored;
      text += '\n' + std::to_string(number) + ' ' +
              std::to_string(std::filesystem::file_size(file, ignored)) + ' ' +
              std::to_string(std::filesystem::last_write_time(file, ignored).time_since_epoch().count());
    }
    return text;
  }

  void make_piece(const MovieReel& reel, int piece, const std::vector<int>& frames, int first,
                  int end) const {
    const auto count = static_cast<int>(frames.size());
    const MovieCurves curves = movie_curves(run_, history_, live_);
    MoviePiece made{signature(frames, first, end, curves), end - first, {}};
    if (reel.has(piece, made.signature)) return;
    const auto keep = [&](const VideoPacket& packet) { made.packets.push_back(packet); };
    VideoEncoder encoder(format_);
    for (int i = first; i < end; ++i) {
      tell(i, count);
      encoder.add(frame(frames[i], curves), keep);
    }
    encoder.finish(keep);
    reel.put(piece, made);
  }

  void make_at_once() const {
    const std::vector<int> frames = frames_so_far(true);
    const MovieCurves curves = movie_curves(run_, history_, false);
    VideoEncoder encoder(format_);
    MovieFile movie(target_, format_, encoder);
    const auto write = [&](const VideoPacket& packet) { movie.add(packet); };
    for (std::size_t i = 0; i < frames.size(); ++i) {
      tell(static_cast<int>(i), static_cast<int>(frames.size()));
      encoder.add(frame(frames[i], curves), write);
    }
    encoder.finish(write);
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
