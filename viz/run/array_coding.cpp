// SPDX-License-Identifier: BSD-3-Clause
// Sizes are 32 bits wide, as header_type in the file's first tag says: number of blocks, size of a block, size
// of the last one, packed size of each. Without packing: the number of bytes.
#include "run/array_coding.hpp"

#include <libdeflate.h>
#include <lz4.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "run/text.hpp"

namespace hfrac::run {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

constexpr size_t kBlockSize = 1U << 17U;  // [byte] larger ones pack no better
constexpr int kLevel = 1;

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

void append_packed(std::string& text, std::span<const std::byte> bytes, Compression compression) {
  const size_t blocks = (bytes.size() + kBlockSize - 1) / kBlockSize;
  std::vector<uint32_t> sizes = {static_cast<uint32_t>(blocks), static_cast<uint32_t>(kBlockSize),
                                 static_cast<uint32_t>(bytes.size() % kBlockSize)};
  Packer packer(compression);
  std::vector<std::byte> packed(blocks * packer.most(kBlockSize));
  size_t end = 0;
  for (size_t i = 0; i < blocks; ++i) {
    const auto block = bytes.subspan(i * kBlockSize, std::min(kBlockSize, bytes.size() - i * kBlockSize));
    const size_t size = packer.pack(block, std::span(packed).subspan(end));
    sizes.push_back(static_cast<uint32_t>(size));
    end += size;
  }
  append_base64(text, std::as_bytes(std::span(sizes)));
  append_base64(text, std::span(packed).first(end));
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

void append_coded(std::string& text, std::span<const std::byte> bytes, Compression compression) {
  if (bytes.size() > UINT32_MAX) throw std::runtime_error("an array of a snapshot is larger than 4 GB");
  if (compression != Compression::none) return append_packed(text, bytes, compression);
  // Size and numbers are one run here, unlike those of packed arrays.
  std::vector<std::byte> plain(sizeof(uint32_t) + bytes.size());
  const auto size = static_cast<uint32_t>(bytes.size());
  std::memcpy(plain.data(), &size, sizeof size);
  if (!bytes.empty()) std::memcpy(plain.data() + sizeof size, bytes.data(), bytes.size());
  append_base64(text, plain);
}

}  // namespace hfrac::run
