// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string_view>

namespace hfrac::viz {

namespace {

// Sums of `factor` drawn rows first, then of `factor` neighbours in them: the first loop runs over whole vectors.
template <unsigned factor>
void reduce(const std::uint8_t* bottom_up_rgb, Image& image) {
  const std::size_t row = static_cast<std::size_t>(image.width) * factor * 3;
  std::vector<std::uint16_t> sums(row);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* source =
        bottom_up_rgb + static_cast<std::size_t>(image.height - 1 - y) * factor * row;
    for (std::size_t i = 0; i < row; ++i) {
      unsigned sum = 0;
      for (unsigned k = 0; k < factor; ++k) sum += source[k * row + i];
      sums[i] = static_cast<std::uint16_t>(sum);
    }
    const std::uint16_t* from = sums.data();
    std::uint8_t* target = image.row(y);
    for (int x = 0; x < image.width; ++x, from += 3 * factor, target += 3) {
      for (unsigned colour = 0; colour < 3; ++colour) {
        unsigned sum = factor * factor / 2;
        for (unsigned k = 0; k < factor; ++k) sum += from[3 * k + colour];
        target[colour] = static_cast<std::uint8_t>(sum / (factor * factor));
      }
    }
  }
}

}  // namespace

Image reduced(const std::uint8_t* bottom_up_rgb, int width, int height, int factor) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  static constexpr std::array reductions = {reduce<1>, reduce<2>, reduce<3>};
  reductions[static_cast<std::size_t>(std::clamp(factor, 1, 3) - 1)](bottom_up_rgb, image);
  return image;
}

// PNG (W3C 2003) by libdeflate: a signature and four chunks around one packed block, written here because libpng packs
// by zlib only, which takes as long as drawing the picture. Rows are not filtered: drawings are flat areas that repeat,
// and the differences between neighbours, which help photographs, pack worse.

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int packing_level = 3;  // of 12: beyond it files get few percent smaller in twice the time

void put_number(Bytes& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

// Its length, its name and content, and their CRC.
void put_chunk(Bytes& file, std::string_view name, std::span<const std::uint8_t> content) {
  put_number(file, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), content.begin(), content.end());
  put_number(file, libdeflate_crc32(0, file.data() + begin, file.size() - begin));
}

Bytes header_of(const Image& image) {
  Bytes header;
  put_number(header, static_cast<std::uint32_t>(image.width));
  put_number(header, static_cast<std::uint32_t>(image.height));
  for (const int value : {8, 2, 0, 0, 0})
    header.push_back(static_cast<std::uint8_t>(value));  // 8 bits of R, G, B
  return header;
}

Bytes size_on_paper(int dots_per_inch) {
  constexpr double metres_per_inch = 0.0254;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / metres_per_inch));
  Bytes size;
  put_number(size, per_metre);
  put_number(size, per_metre);
  size.push_back(1);  // the unit is the metre
  return size;
}

Bytes packed_rows(const Image& image) {
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  Bytes rows((row + 1) * static_cast<std::size_t>(image.height));  // a byte before each: its filter, 0
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(rows.data() + (row + 1) * static_cast<std::size_t>(y) + 1, image.row(y), row);
  }
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(packing_level), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes packed(libdeflate_zlib_compress_bound(compressor.get(), rows.size()));
  packed.resize(
      libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), packed.data(), packed.size()));
  return packed;
}

}  // namespace

std::vector<std::uint8_t> png(const Image& image, int dots_per_inch) {
  const Bytes packed = packed_rows(image);
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  file.reserve(packed.size() + 100);
  put_chunk(file, "IHDR", header_of(image));
  if (dots_per_inch > 0) put_chunk(file, "pHYs", size_on_paper(dots_per_inch));
  put_chunk(file, "IDAT", packed);
  put_chunk(file, "IEND", {});
  return file;
}

}  // namespace hfrac::viz
