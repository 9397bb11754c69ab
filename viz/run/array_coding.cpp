// SPDX-License-Identifier: BSD-3-Clause
// Sizes are 32 bits wide, as header_type in the file's first tag says: number of blocks, size of a block, size
// of the last one, packed size of each. Without packing: the number of bytes.
#include "run/array_coding.hpp"

#include <libdeflate.h>
#include <lz4.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <stdexcept>
#include <vector>

#include "run/text.hpp"
#include "run/threads.hpp"

namespace hfrac::run {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

constexpr size_t kBlockSize = 1U << 17U;  // [byte] larger ones pack no better
constexpr int kLevel = 1;
constexpr size_t kAhead =
    2;  // [byte] base64 goes by threes, so that the last three of a block may want two of the next

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

/** Packs block after block. */
class Packer {
 public:
  explicit Packer(Compression compression) {
    if (compression != Compression::zlib) return;
    zlib_.reset(libdeflate_alloc_compressor(kLevel));
    if (!zlib_) throw std::bad_alloc();
  }

  size_t most(size_t size) const {
    return zlib_ ? libdeflate_zlib_compress_bound(zlib_.get(), size)
                 : static_cast<size_t>(LZ4_compressBound(static_cast<int>(size)));
  }

  /** The packed size. */
  size_t pack(std::span<const std::byte> block, std::span<std::byte> room) {
    size_t size = 0;
    if (zlib_)
      size = libdeflate_zlib_compress(zlib_.get(), block.data(), block.size(), room.data(), room.size());
    else
      size = static_cast<size_t>(LZ4_compress_default(
          reinterpret_cast<const char*>(block.data()), reinterpret_cast<char*>(room.data()),
          static_cast<int>(block.size()), static_cast<int>(room.size())));
    if (size == 0) throw std::logic_error("a block of an array could not be packed");
    return size;
  }

 private:
  std::unique_ptr<libdeflate_compressor, FreeCompressor> zlib_;
};

/** A block of an array and what stands for it in the file before base64. */
struct Piece {
  size_t array;
  RawBytes block;
  std::string coded = {};
  size_t size = 0;  ///< of what is coded
  size_t at = 0;    ///< how much of its array is coded before it
};

/** Codes the blocks that come to one thread. */
class Coder {
 public:
  Coder(Compression compression, std::span<const RawBytes> arrays)
      : compression_(compression), arrays_(arrays) {}

  void code(Piece& piece) {
    RawBytes bytes = piece.block;
    if (compression_ != Compression::none) {
      if (!packer_) packer_.emplace(compression_);
      room_.resize(packer_->most(kBlockSize));
      bytes = RawBytes(room_).first(packer_->pack(piece.block, room_));
    } else if (piece.block.data() == arrays_[piece.array].data()) {
      // Size and numbers are one run here, unlike those of packed arrays.
      const auto size = static_cast<uint32_t>(arrays_[piece.array].size());
      add(piece.coded, std::as_bytes(std::span(&size, 1)));
    }
    add(piece.coded, bytes);
    piece.size = piece.coded.size();
  }

 private:
  static void add(std::string& text, RawBytes bytes) {
    text.reserve(text.size() + bytes.size() + kAhead);
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }

  Compression compression_;
  std::span<const RawBytes> arrays_;
  std::optional<Packer> packer_;
  std::vector<std::byte> room_;
};

/** The blocks of all arrays. Without packing an empty array has one, too, for its size. */
std::vector<Piece> cut(std::span<const RawBytes> arrays, Compression compression) {
  std::vector<Piece> pieces;
  for (size_t i = 0; i < arrays.size(); ++i) {
    const RawBytes bytes = arrays[i];
    if (bytes.size() > UINT32_MAX) throw std::runtime_error("an array of a snapshot is larger than 4 GB");
    if (bytes.empty() && compression == Compression::none) pieces.push_back({i, bytes});
    for (size_t at = 0; at < bytes.size(); at += kBlockSize)
      pieces.push_back({i, bytes.subspan(at, std::min(kBlockSize, bytes.size() - at))});
  }
  return pieces;
}

constexpr size_t round_up(size_t size) {
  return (size + 2) / 3 * 3;
}

constexpr std::array<std::string_view, 4> names = {"vtkZLibDataCompressor", "vtkLZ4DataCompressor", "",
                                                   "vtkLZMADataCompressor"};

}  // namespace

std::string_view compressor_name(Compression compression) {
  return names.at(static_cast<size_t>(compression));
}

std::optional<Compression> compression_named(std::string_view name) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Compression>(found - names.begin());
}

std::string with_coded_arrays(std::span<const std::string> words, std::span<const RawBytes> arrays,
                              Compression compression, int workers) {
  auto pieces = cut(arrays, compression);
  std::vector<Coder> coders;
  for (int k = 0; k < std::max(workers, 1); ++k) coders.emplace_back(compression, arrays);
  share_out(workers, pieces.size(), [&](size_t worker, size_t i) { coders[worker].code(pieces[i]); });

  std::vector<std::vector<uint32_t>> sizes;  // what stands before packed blocks
  for (const RawBytes bytes : arrays)
    sizes.push_back({0, static_cast<uint32_t>(kBlockSize), static_cast<uint32_t>(bytes.size() % kBlockSize)});
  std::vector<size_t> length(arrays.size());
  for (size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    piece.at = length[piece.array];
    length[piece.array] += piece.size;
    ++sizes[piece.array][0];
    sizes[piece.array].push_back(static_cast<uint32_t>(piece.size));
    if (i + 1 < pieces.size() && pieces[i + 1].array == piece.array)
      piece.coded.append(pieces[i + 1].coded, 0, kAhead);
  }

  const bool packed = compression != Compression::none;
  size_t whole = 0;
  for (const auto& word : words) whole += word.size();
  for (size_t k = 0; k < arrays.size(); ++k)
    whole += base64_length(length[k]) + (packed ? base64_length(sizes[k].size() * sizeof(uint32_t)) : 0);
  std::string text;
  text.reserve(whole);
  std::vector<size_t> place(arrays.size());
  for (size_t k = 0; k < words.size(); ++k) {
    text += words[k];
    if (k == arrays.size()) break;
    if (packed) append_base64(text, std::as_bytes(std::span(sizes[k])));
    place[k] = text.size();
    text.append(base64_length(length[k]), '=');
  }
  share_out(workers, pieces.size(), [&](size_t, size_t i) {
    const Piece& piece = pieces[i];
    const size_t begin = round_up(piece.at),
                 end = std::min(round_up(piece.at + piece.size), length[piece.array]);
    if (begin < end)
      put_base64(text.data() + place[piece.array] + base64_length(begin),
                 std::as_bytes(std::span(piece.coded)).subspan(begin - piece.at, end - begin));
  });
  return text;
}

}  // namespace hfrac::run
