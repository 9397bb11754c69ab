// SPDX-License-Identifier: BSD-3-Clause
#include "movie_reel.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "failure.h"
#include "movie_file.h"
#include "whole_file.h"

namespace hfrac::viz {
namespace {

constexpr std::string_view magic = "hfrac movie piece 1\n";

template <class Number>
void append(std::vector<std::uint8_t>& bytes, Number value) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

// Takes numbers and bytes off the front; whatever is missing makes it fail for good.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    Number value{};
    const std::string_view part = bytes(sizeof value);
    if (good_) std::memcpy(&value, part.data(), sizeof value);
    return value;
  }
  std::string_view bytes(std::size_t count) {
    good_ = good_ && count <= rest_.size();
    if (!good_) return {};
    const std::string_view part = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return part;
  }
  bool good() const { return good_; }
  bool at_end() const { return good_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool good_ = true;
};

}  // namespace

MovieReel::MovieReel(const std::filesystem::path& movie)
    : movie_(movie),
      folder_(movie.parent_path() / std::string(".").append(movie.filename().string()).append(".pieces")) {
  // Not make_folder: a movie goes into a folder that is there.
  std::error_code error;
  std::filesystem::create_directory(folder_, error);
  if (error) fail_writing("cannot write " + movie.string() + ": " + error.message());
}

std::filesystem::path MovieReel::file(int index) const {
  char name[32];
  std::snprintf(name, sizeof name, "%06d.piece", index);
  return folder_ / name;
}

std::optional<MoviePiece> MovieReel::read(int index) const {
  std::ifstream stream(file(index), std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  Reader reader(content);
  if (reader.bytes(magic.size()) != magic) return std::nullopt;
  MoviePiece piece;
  piece.signature = reader.bytes(reader.number<std::uint32_t>());
  piece.frames = reader.number<std::int32_t>();
  const auto count = reader.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && reader.good(); ++i) {
    VideoPacket packet;
    packet.shown = reader.number<std::int64_t>();
    packet.decoded = reader.number<std::int64_t>();
    packet.key = reader.number<std::uint8_t>() != 0;
    const std::string_view data = reader.bytes(reader.number<std::uint32_t>());
    packet.data.assign(data.begin(), data.end());
    piece.packets.push_back(std::move(packet));
  }
  if (!reader.at_end()) return std::nullopt;
  return piece;
}

bool MovieReel::has(int index, const std::string& signature) const {
  const std::optional<MoviePiece> piece = read(index);
  return piece && piece->signature == signature;
}

void MovieReel::put(int index, const MoviePiece& piece) const {
  std::vector<std::uint8_t> bytes(magic.begin(), magic.end());
  append(bytes, static_cast<std::uint32_t>(piece.signature.size()));
  bytes.insert(bytes.end(), piece.signature.begin(), piece.signature.end());
  append(bytes, static_cast<std::int32_t>(piece.frames));
  append(bytes, static_cast<std::uint32_t>(piece.packets.size()));
  for (const VideoPacket& packet : piece.packets) {
    append(bytes, packet.shown);
    append(bytes, packet.decoded);
    append(bytes, static_cast<std::uint8_t>(packet.key ? 1 : 0));
    append(bytes, static_cast<std::uint32_t>(packet.data.size()));
    bytes.insert(bytes.end(), packet.data.begin(), packet.data.end());
  }
  write_whole(file(index), bytes);
}

void MovieReel::assemble(const VideoFormat& format, int count) const {
  const VideoEncoder encoder(format);  // for what the container has to know; all pieces agree in it
  MovieFile movie(movie_, format, encoder);
  std::int64_t first_frame = 0;
  for (int index = 0; index < count; ++index) {
    const std::optional<MoviePiece> piece = read(index);
    if (!piece) fail_reading("a piece of the movie has gone: " + file(index).string());
    for (const VideoPacket& packet : piece->packets) movie.add(packet, first_frame);
    first_frame += piece->frames;
  }
  movie.finish();
}

void MovieReel::remove() const {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace hfrac::viz
