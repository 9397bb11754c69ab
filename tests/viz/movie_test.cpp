// SPDX-License-Identifier: BSD-3-Clause
// The movie as a player sees it.
#include <gtest/gtest.h>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "file_text.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

using Movie = VizTest;

struct Decoded {
  int frames = 0;
  int width = 0;
  int height = 0;
  std::string codec;
  AVPixelFormat format = AV_PIX_FMT_NONE;
  double seconds = 0;
  int darkest = 255;
  int lightest = 0;
  std::vector<double> light;  // mean of each frame
};

Decoded decode(const std::filesystem::path& path) {
  Decoded decoded;
  AVFormatContext* format = nullptr;
  if (avformat_open_input(&format, path.c_str(), nullptr, nullptr) < 0) return decoded;
  avformat_find_stream_info(format, nullptr);
  const AVCodec* codec = nullptr;
  const int stream = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
  AVCodecContext* context = avcodec_alloc_context3(codec);
  avcodec_parameters_to_context(context, format->streams[stream]->codecpar);
  avcodec_open2(context, codec, nullptr);
  decoded.codec = codec->name;
  decoded.seconds = static_cast<double>(format->duration) / AV_TIME_BASE;
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  bool more = true;
  while (more) {
    more = av_read_frame(format, packet) >= 0;
    avcodec_send_packet(context, more ? packet : nullptr);
    av_packet_unref(packet);
    while (avcodec_receive_frame(context, frame) >= 0) {
      ++decoded.frames;
      decoded.width = frame->width;
      decoded.height = frame->height;
      decoded.format = static_cast<AVPixelFormat>(frame->format);
      double sum = 0;
      for (int y = 0; y < frame->height; ++y) {
        for (int x = 0; x < frame->width; ++x) {
          const int light = frame->data[0][y * frame->linesize[0] + x];
          decoded.darkest = std::min(decoded.darkest, light);
          decoded.lightest = std::max(decoded.lightest, light);
          sum += light;
        }
      }
      decoded.light.push_back(sum / (frame->width * frame->height));
    }
  }
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&context);
  avformat_close_input(&format);
  return decoded;
}

TEST_F(Movie, HasEverySnapshotAsAFrameOfH264) {
  run.snapshots = 9;
  write_run(folder(), run);
  options.movie_width = 640;
  options.movie_height = 480;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Result result = render_movie(file("movie.mp4"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Decoded decoded = decode(file("movie.mp4"));
  EXPECT_EQ(decoded.frames, 9);
  EXPECT_EQ(decoded.width, 640);
  EXPECT_EQ(decoded.height, 480);
  EXPECT_EQ(decoded.codec, "h264");
  EXPECT_EQ(decoded.format, AV_PIX_FMT_YUV420P);
  EXPECT_LE(decoded.seconds, 12.0);
  EXPECT_LT(decoded.darkest, 60);
  EXPECT_GT(decoded.lightest, 220);
}

TEST_F(Movie, IndexIsInFront) {
  write_run(folder(), run);
  options.movie_width = 320;
  ASSERT_EQ(render_movie(file("movie.mp4")).status, HFRAC_OK);
  std::ifstream stream(file("movie.mp4"), std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  ASSERT_NE(content.find("moov"), std::string::npos);
  EXPECT_LT(content.find("moov"), content.find("mdat"));
}

TEST_F(Movie, LeavesSnapshotsOutOnlyWhenThereAreTooMany) {
  run.snapshots = 130;
  run.columns = 8;
  write_run(folder(), run);
  options.movie_width = 320;
  options.movie_height = 240;
  options.movie_seconds = 1;
  ASSERT_EQ(render_movie(file("movie.mp4")).status, HFRAC_OK);
  const Decoded decoded = decode(file("movie.mp4"));
  EXPECT_LE(decoded.frames, 60);
  EXPECT_GE(decoded.frames, 40);
  EXPECT_LE(decoded.seconds, 1.1);
}

TEST_F(Movie, AnimatedWebPHasAFramePerSnapshotAndLoops) {
  run.snapshots = 4;
  write_run(folder(), run);
  options.movie_width = 320;
  const Result result = render_movie(file("movie.webp"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const std::string content = file_text(file("movie.webp"));
  EXPECT_EQ(content.substr(0, 4), "RIFF");
  EXPECT_EQ(content.substr(8, 4), "WEBP");
  const std::size_t animation = content.find("ANIM");
  ASSERT_NE(animation, std::string::npos);
  EXPECT_EQ(content.substr(animation + 12, 2), std::string(2, '\0'));  // loops for ever
  int frames = 0;
  for (std::size_t at = content.find("ANMF"); at != std::string::npos; at = content.find("ANMF", at + 4))
    ++frames;
  EXPECT_EQ(frames, 4);
}

// Stops at a share of the work; tells where it began.
struct Stopper {
  double stop_at = 2;
  double first = -1;
  static std::int32_t told(void* user, double fraction, const char*) {
    auto& self = *static_cast<Stopper*>(user);
    if (self.first < 0) self.first = fraction;
    return fraction >= self.stop_at ? 1 : 0;
  }
};

class LongMovie : public VizTest {
 protected:
  LongMovie() {
    run.snapshots = 34;
    run.columns = 10;
    options.movie_width = 320;
  }
  std::int32_t render(const std::string& name, Stopper& stopper) {
    return hfrac_viz_render_movie(folder().c_str(), file(name).c_str(), &options, Stopper::told, &stopper);
  }
};

TEST_F(LongMovie, AStoppedOneLeavesNothingAndTwoAreTheSameBytes) {
  write_run(folder(), run);
  Stopper half{0.8};
  ASSERT_EQ(render("movie.mp4", half), HFRAC_STOPPED);
  EXPECT_FALSE(std::filesystem::exists(file("movie.mp4")));
  EXPECT_EQ(leftovers(folder()), 0);
  Stopper first, second;
  ASSERT_EQ(render("movie.mp4", first), HFRAC_OK);
  ASSERT_EQ(render("again.mp4", second), HFRAC_OK);
  EXPECT_EQ(file_text(file("movie.mp4")), file_text(file("again.mp4")));
  const Decoded decoded = decode(file("movie.mp4"));
  EXPECT_EQ(decoded.frames, 34);
  EXPECT_NE(decoded.light.front(), decoded.light.back());
}

// Whether the run goes on while it is followed, or was over before: the same movie.
TEST_F(LongMovie, FollowedLateIsTheSameBytes) {
  write_run(folder(), run);
  std::string summary = file_text(file("summary.json"));
  summary.insert(1, "\"planned\": {\"time_s\": 90, \"snapshots\": 40}, ");
  std::ofstream(file("summary.json"), std::ios::binary) << summary;
  options.movie_follow = 1;
  Stopper never, neither;
  ASSERT_EQ(render("over.mp4", never), HFRAC_OK);
  std::string running = summary;
  running.replace(running.find("all steps taken"), 15, "running");
  std::ofstream(file("summary.json"), std::ios::binary) << running;
  std::thread follower([&] { EXPECT_EQ(render("meanwhile.mp4", neither), HFRAC_OK); });
  while (!std::filesystem::exists(file("meanwhile.mp4")))
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::ofstream(file("summary.new"), std::ios::binary) << summary;
  std::filesystem::rename(file("summary.new"), file("summary.json"));
  follower.join();
  EXPECT_EQ(file_text(file("over.mp4")), file_text(file("meanwhile.mp4")));
}

TEST_F(LongMovie, FollowsARunToItsEnd) {
  write_run(folder(), run);
  const auto replace = [&](const std::string& name, const std::string& content) {
    std::ofstream(file(name + ".new"), std::ios::binary) << content;
    std::filesystem::rename(file(name + ".new"), file(name));
  };
  const std::string discs = file_text(file("discs.pvd"));
  const std::string summary = file_text(file("summary.json"));
  std::string running = summary;
  running.replace(running.find("all steps taken"), 15, "running");
  running.insert(1, "\"planned\": {\"time_s\": 90, \"snapshots\": 40}, ");
  const std::size_t cut = discs.find("    <DataSet timestep=\"30\"");  // the first twelve
  ASSERT_NE(cut, std::string::npos);
  replace("discs.pvd", discs.substr(0, cut) + "  </Collection>\n</VTKFile>\n");
  replace("summary.json", running);

  options.movie_follow = 1;
  std::atomic<std::int32_t> status{1};
  Stopper never;
  std::thread follower([&] { status = render("movie.mp4", never); });
  while (!std::filesystem::exists(file("movie.mp4")) && status == 1) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(decode(file("movie.mp4")).frames, 10);  // what there is, already to be looked at
  // Others may draw while it waits.
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("meanwhile.png")).status, HFRAC_OK);
  replace("discs.pvd", discs);
  replace("summary.json", summary);
  follower.join();
  EXPECT_EQ(status, HFRAC_OK);
  EXPECT_EQ(decode(file("movie.mp4")).frames, 34);
}

TEST_F(LongMovie, FollowingIsForMp4) {
  write_run(folder(), run);
  std::string running = file_text(file("summary.json"));
  running.replace(running.find("all steps taken"), 15, "running");
  std::ofstream(file("summary.json"), std::ios::binary) << running;
  options.movie_follow = 1;
  EXPECT_EQ(render_movie(file("movie.webp")).status, HFRAC_ERR_ARGUMENT);
}

}  // namespace
}  // namespace hfrac::viz_test
