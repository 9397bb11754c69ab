// SPDX-License-Identifier: BSD-3-Clause
// A movie file around compressed packets: MP4 with the index in front, or an animated WebP that loops. It appears
// whole or not at all.
#pragma once

#include <filesystem>
#include <memory>

#include "video_encoder.h"

namespace hfrac::viz {

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

}  // namespace hfrac::viz
