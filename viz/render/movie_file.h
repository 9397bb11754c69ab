// SPDX-License-Identifier: BSD-3-Clause
// A movie, picture by picture: an MP4 file with H.264 inside, or an animated WebP if the name ends in .webp.
#pragma once

#include <filesystem>
#include <memory>

#include "image.h"

namespace hfrac::viz {

class MovieFile {
 public:
  // Even width and height [pixel]. Throws Failure.
  MovieFile(const std::filesystem::path& target, int width, int height, int frames_per_second);
  ~MovieFile();  // without finish(): nothing is left of it
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  void add(const Image& image);
  // Ends the file and gives it its name.
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

// Name and version of the encoder.
const char* movie_encoder_text();

}  // namespace hfrac::viz
