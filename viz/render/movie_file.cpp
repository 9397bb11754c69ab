// SPDX-License-Identifier: BSD-3-Clause
#include "movie_file.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/log.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <thread>

#include "failure.h"

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

struct FreeCodec {
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

}  // namespace

struct VideoEncoder::Parts {
  std::unique_ptr<AVCodecContext, FreeCodec> codec;
  std::unique_ptr<SwsContext, FreeScaler> scaler;
  std::unique_ptr<AVFrame, FreeFrame> frame;
  std::unique_ptr<AVPacket, FreePacket> packet;
  std::int64_t next_frame = 0;

  void prepare_h264(int rate) const;
  void prepare_webp() const;
  void open(const VideoFormat& format);
  void encode(const AVFrame* input, const Sink& sink) const;
};

void VideoEncoder::Parts::prepare_h264(int rate) const {
  const int* high_definition = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler.get(), high_definition, 1, high_definition, 0, 0, 1 << 16, 1 << 16);
  codec->gop_size = std::max(2, 2 * rate);  // a place to jump to every two seconds
  codec->colorspace = AVCOL_SPC_BT709;
  codec->color_primaries = AVCOL_PRI_BT709;
  codec->color_trc = AVCOL_TRC_BT709;
  codec->color_range = AVCOL_RANGE_MPEG;
  codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_opt_set(codec->priv_data, "preset", "veryfast", 0);
  av_opt_set(codec->priv_data, "tune", "animation", 0);
  av_opt_set(codec->priv_data, "crf", "17", 0);
  // With it, x264's vector code gives other bytes for the same pictures now and then (1 in 6 movies here).
  av_opt_set(codec->priv_data, "mbtree", "0", 0);
}

void VideoEncoder::Parts::prepare_webp() const {
  av_opt_set(codec->priv_data, "lossless", "0", 0);
  av_opt_set(codec->priv_data, "quality", "80", 0);
  av_opt_set(codec->priv_data, "compression_level", "2", 0);
}

void VideoEncoder::Parts::open(const VideoFormat& format) {
  const bool webp = format.kind == VideoKind::webp;
  const char* name = webp ? "libwebp_anim" : "libx264";
  const AVPixelFormat pixels = webp ? AV_PIX_FMT_RGB32 : AV_PIX_FMT_YUV420P;
  const AVCodec* encoder = avcodec_find_encoder_by_name(name);
  if (encoder == nullptr) fail_drawing(std::string("libavcodec was built without ") + name + ": no movie");
  codec.reset(avcodec_alloc_context3(encoder));
  scaler.reset(sws_getContext(format.width, format.height, AV_PIX_FMT_RGB24, format.width, format.height,
                              pixels, SWS_BICUBIC, nullptr, nullptr, nullptr));
  frame.reset(av_frame_alloc());
  packet.reset(av_packet_alloc());
  if (!codec || !scaler || !frame || !packet) throw std::bad_alloc();
  codec->width = format.width;
  codec->height = format.height;
  codec->pix_fmt = pixels;
  codec->time_base = {1, format.rate};
  codec->framerate = {format.rate, 1};
  codec->thread_count = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  codec->log_level_offset = 100;  // says nothing, whatever the process-wide level
  webp ? prepare_webp() : prepare_h264(format.rate);
  const int opened = avcodec_open2(codec.get(), encoder, nullptr);
  if (opened < 0) fail_drawing(std::string("the encoder ") + name + " cannot be opened: " + reason(opened));
  frame->format = codec->pix_fmt;
  frame->width = format.width;
  frame->height = format.height;
  if (av_frame_get_buffer(frame.get(), 0) < 0) throw std::bad_alloc();
}

void VideoEncoder::Parts::encode(const AVFrame* input, const Sink& sink) const {
  const int sent = avcodec_send_frame(codec.get(), input);
  if (sent < 0) fail_drawing("the encoder failed: " + reason(sent));
  while (true) {
    const int received = avcodec_receive_packet(codec.get(), packet.get());
    if (received == AVERROR(EAGAIN) || received == AVERROR_EOF) return;
    if (received < 0) fail_drawing("the encoder failed: " + reason(received));
    VideoPacket out{packet->pts, packet->dts, (packet->flags & AV_PKT_FLAG_KEY) != 0, {}};
    out.data.assign(packet->data, packet->data + packet->size);
    av_packet_unref(packet.get());
    sink(out);
  }
}

VideoEncoder::VideoEncoder(const VideoFormat& format) : parts_(std::make_unique<Parts>()) {
  parts_->open(format);
}

VideoEncoder::~VideoEncoder() = default;

void VideoEncoder::add(const Image& image, const Sink& sink) {
  AVFrame* frame = parts_->frame.get();
  if (image.width != frame->width || image.height != frame->height)
    fail_drawing("a movie's pictures differ in size");
  if (av_frame_make_writable(frame) < 0) throw std::bad_alloc();
  const std::array<const std::uint8_t*, 1> rows = {image.rgb.data()};
  const std::array<int, 1> strides = {3 * image.width};
  sws_scale(parts_->scaler.get(), rows.data(), strides.data(), 0, image.height, frame->data, frame->linesize);
  frame->pts = parts_->next_frame++;
  parts_->encode(frame, sink);
}

void VideoEncoder::finish(const Sink& sink) {
  parts_->encode(nullptr, sink);
}

const AVCodecContext* VideoEncoder::codec() const {
  return parts_->codec.get();
}

const char* movie_encoder_text() {
  return LIBAVCODEC_IDENT;
}

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
