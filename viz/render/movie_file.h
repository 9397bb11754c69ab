// SPDX-License-Identifier: BSD-3-Clause
// Pictures into compressed packets by libav, H.264 for movies, animated WebP for small ones; and packets into a movie file:
// MP4 with the index in front, or an animated WebP that loops.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "image.h"

struct AVCodecContext;

namespace hfrac::viz {

// A compressed piece of the stream; times are in frames.
struct VideoPacket {
  std::int64_t shown = 0;    // presentation time
  std::int64_t decoded = 0;  // decoding time, not after `shown`
  bool key = false;          // decoding may start here
  std::vector<std::uint8_t> data;
};

enum class VideoKind { h264, webp };

struct VideoFormat {
  VideoKind kind = VideoKind::h264;
  int width = 0;   // [pixel]
  int height = 0;  // [pixel]
  int rate = 0;    // frames per second
};

class VideoEncoder {
 public:
  using Sink = std::function<void(const VideoPacket&)>;

  // Throws Failure(HFRAC_VIZ_ERR_DRAW), as all below do.
  explicit VideoEncoder(const VideoFormat& format);
  ~VideoEncoder();
  VideoEncoder(const VideoEncoder&) = delete;
  VideoEncoder& operator=(const VideoEncoder&) = delete;

  void add(const Image& image, const Sink& sink);
  // What the encoder still holds back. Nothing may be added afterwards.
  void finish(const Sink& sink);

  // What a container has to know of the stream.
  const AVCodecContext* codec() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// A movie file around packets. It appears whole or not at all.
class MovieFile {
 public:
  // `encoder`: one with the stream's format; it is not kept. Throws Failure, as all below do.
  MovieFile(const std::filesystem::path& target, const VideoFormat& format, const VideoEncoder& encoder);
  ~MovieFile();
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  // In order of decoding.
  void add(const VideoPacket& packet);
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Name and version of the encoder library.
const char* movie_encoder_text();

}  // namespace hfrac::viz
