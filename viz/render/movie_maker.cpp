// SPDX-License-Identifier: BSD-3-Clause
#include "movie_maker.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "failure.h"
#include "guarded_call.h"
#include "history.h"
#include "movie_file.h"
#include "movie_picture.h"
#include "vtk_messages.h"

namespace hfrac::viz {
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
