// SPDX-License-Identifier: BSD-3-Clause
#include "image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstring>
#include <span>

#include "failure.h"

namespace hfrac::viz {
namespace {

constexpr std::size_t after_header = 33;  // signature 8, IHDR chunk 25

void put_big_endian(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

// The CRC of PNG chunks: polynomial 0xEDB88320, reflected.
std::uint32_t chunk_check(std::span<const std::uint8_t> bytes) {
  std::uint32_t check = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) {
    check ^= byte;
    for (int bit = 0; bit < 8; ++bit) check = (check >> 1) ^ ((check & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~check;
}

// Puts a pHYs chunk, pixels per metre, after the header; VTK writes none.
void note_size(std::vector<std::uint8_t>& file, int dots_per_inch) {
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dots_per_inch / 0.0254));
  std::vector<std::uint8_t> named = {'p', 'H', 'Y', 's'};
  put_big_endian(named, per_metre);
  put_big_endian(named, per_metre);
  named.push_back(1);  // the unit is the metre
  std::vector<std::uint8_t> chunk;
  put_big_endian(chunk, static_cast<std::uint32_t>(named.size() - 4));
  chunk.insert(chunk.end(), named.begin(), named.end());
  put_big_endian(chunk, chunk_check(named));
  file.insert(file.begin() + after_header, chunk.begin(), chunk.end());
}

}  // namespace

Image reduced(const std::uint8_t* bottom_up_rgb, int width, int height, int factor) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  const std::size_t source_row = static_cast<std::size_t>(width) * factor * 3;
  const unsigned count = static_cast<unsigned>(factor * factor);
  std::vector<unsigned> sums(static_cast<std::size_t>(width) * 3);
  for (int y = 0; y < height; ++y) {
    std::memset(sums.data(), 0, sums.size() * sizeof(unsigned));
    for (int sub_row = 0; sub_row < factor; ++sub_row) {
      const std::uint8_t* source =
          bottom_up_rgb + (static_cast<std::size_t>(height - 1 - y) * factor + sub_row) * source_row;
      for (int x = 0; x < width; ++x) {
        for (int sub_column = 0; sub_column < factor; ++sub_column) {
          sums[3 * x] += source[0];
          sums[3 * x + 1] += source[1];
          sums[3 * x + 2] += source[2];
          source += 3;
        }
      }
    }
    std::uint8_t* target = image.row(y);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      target[i] = static_cast<std::uint8_t>((sums[i] + count / 2) / count);
    }
  }
  return image;
}

std::vector<std::uint8_t> png(const Image& image, int dots_per_inch) {
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(image.width, image.height, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height; ++y) {  // VTK counts rows from the bottom
    std::memcpy(pixels->GetScalarPointer(0, image.height - 1 - y, 0), image.row(y),
                static_cast<std::size_t>(image.width) * 3);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(pixels);
  writer->SetCompressionLevel(1);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* content = writer->GetResult();
  if (content == nullptr || content->GetNumberOfValues() == 0)
    fail_drawing("the picture cannot be coded as PNG");
  const std::uint8_t* first = content->GetPointer(0);
  std::vector<std::uint8_t> file(first, first + content->GetNumberOfValues());
  if (dots_per_inch > 0) note_size(file, dots_per_inch);
  return file;
}

}  // namespace hfrac::viz
