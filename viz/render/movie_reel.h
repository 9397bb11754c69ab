// SPDX-License-Identifier: BSD-3-Clause
// The finished pieces of a movie that is not finished yet.
//
// A movie is encoded in pieces of a few frames that can be decoded by themselves, each in a file of its own in a folder
// beside the movie. A render that was killed finds them again and goes on behind the last; the movie is then put
// together by copying, without encoding anything anew. A piece carries a signature of all it was drawn from, so that a
// changed run, size or style is never mixed with an old one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "video_encoder.h"

namespace hfrac::viz {

struct MoviePiece {
  std::string signature;
  int frames = 0;
  std::vector<VideoPacket> packets;
};

class MovieReel {
 public:
  // Makes the folder `.NAME.pieces` beside the movie. Throws Failure(HFRAC_VIZ_ERR_WRITE).
  explicit MovieReel(const std::filesystem::path& movie);

  // Whether piece `index` is there, whole, and of that signature.
  bool has(int index, const std::string& signature) const;
  void put(int index, const MoviePiece& piece) const;
  // Puts the first `count` pieces together. Throws Failure.
  void assemble(const VideoFormat& format, int count) const;
  // Removes all pieces and the folder.
  void remove() const;

 private:
  std::filesystem::path file(int index) const;
  std::optional<MoviePiece> read(int index) const;

  std::filesystem::path movie_;
  std::filesystem::path folder_;
};

}  // namespace hfrac::viz
