// SPDX-License-Identifier: BSD-3-Clause
#include "movie_file.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
}

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "failure.h"
#include "run/files.hpp"

namespace hfrac::viz {
namespace {

std::string reason(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

// The muxer says what it does on the process-wide log; only that can be turned down, and only for everyone.
class QuietLog {
 public:
  QuietLog() : level_(av_log_get_level()) { av_log_set_level(AV_LOG_QUIET); }
  ~QuietLog() { av_log_set_level(level_); }
  QuietLog(const QuietLog&) = delete;
  QuietLog& operator=(const QuietLog&) = delete;

 private:
  int level_;
};

struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct FreeFormat {
  void operator()(AVFormatContext* format) const {
    if (format->pb != nullptr) avio_closep(&format->pb);
    avformat_free_context(format);
  }
};

}  // namespace

struct MovieFile::Parts {
  explicit Parts(const std::filesystem::path& target) : file(target) {}

  WholeFile file;
  std::unique_ptr<AVFormatContext, FreeFormat> format;
  std::unique_ptr<AVPacket, FreePacket> packet;
  AVStream* stream = nullptr;
  AVRational frame_time{};

  void check_written(int result) const {
    if (result >= 0 && format->pb != nullptr) result = std::min(result, format->pb->error);
    if (result < 0) fail_writing("cannot write " + file.target().string() + ": " + reason(result));
  }
};

MovieFile::MovieFile(const std::filesystem::path& target, const VideoFormat& format,
                     const VideoEncoder& encoder)
    : parts_(std::make_unique<Parts>(target)) {
  const QuietLog quiet;
  const bool webp = format.kind == VideoKind::webp;
  AVFormatContext* made = nullptr;
  const char* container = webp ? "webp" : "mp4";
  if (avformat_alloc_output_context2(&made, nullptr, container, parts_->file.working_path().c_str()) < 0 ||
      made == nullptr) {
    fail_drawing(std::string("libavformat cannot write ") + container);
  }
  parts_->format.reset(made);
  parts_->packet.reset(av_packet_alloc());
  parts_->stream = avformat_new_stream(made, nullptr);
  if (parts_->stream == nullptr || !parts_->packet) throw std::bad_alloc();
  parts_->frame_time = encoder.codec()->time_base;
  parts_->stream->time_base = encoder.codec()->time_base;
  parts_->stream->avg_frame_rate = encoder.codec()->framerate;
  avcodec_parameters_from_context(parts_->stream->codecpar, encoder.codec());
  parts_->check_written(avio_open(&made->pb, parts_->file.working_path().c_str(), AVIO_FLAG_WRITE));
  AVDictionary* options = nullptr;
  webp ? av_dict_set(&options, "loop", "0", 0) : av_dict_set(&options, "movflags", "+faststart", 0);
  const int written = avformat_write_header(made, &options);
  av_dict_free(&options);
  parts_->check_written(written);
}

MovieFile::~MovieFile() = default;

void MovieFile::add(const VideoPacket& packet) {
  AVPacket* out = parts_->packet.get();
  const auto size = static_cast<int>(packet.data.size());
  if (av_new_packet(out, size) < 0) throw std::bad_alloc();
  std::memcpy(out->data, packet.data.data(), packet.data.size());
  out->pts = packet.shown;
  out->dts = packet.decoded;
  out->duration = 1;  // without it the last picture would last no time
  out->flags = packet.key ? AV_PKT_FLAG_KEY : 0;
  out->stream_index = parts_->stream->index;
  av_packet_rescale_ts(out, parts_->frame_time, parts_->stream->time_base);
  parts_->check_written(av_interleaved_write_frame(parts_->format.get(), out));
}

void MovieFile::finish() {
  {
    const QuietLog quiet;
    parts_->check_written(av_write_trailer(parts_->format.get()));
    parts_->check_written(avio_closep(&parts_->format->pb));
  }
  parts_->file.commit();
}

}  // namespace hfrac::viz
