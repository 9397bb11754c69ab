// SPDX-License-Identifier: BSD-3-Clause
#include "bands.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

#include "failure.h"

namespace hfrac::viz {
namespace {

constexpr int drawn_at_once = 4'000'000;  // [drawn pixel]
constexpr int fewest_rows = 64;           // [pixel]
constexpr int margin = 8;                 // [pixel] OpenGL cuts thick lines off askew at the window's edge

}  // namespace

Image drawn_in_bands(OffscreenWindow* window, int width, int height, int factor,
                     const std::function<void(const PageBand&)>& show) {
  const int most = std::max(fewest_rows, drawn_at_once / (width * factor * factor));
  const int count = (height + most - 1) / most;
  const int rows = (height + count - 1) / count;
  const int drawn_rows = rows + 2 * margin;
  window->SetSize(width * factor, drawn_rows * factor);
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  vtkNew<vtkUnsignedCharArray> pixels;
  for (int low = 0; low < height; low += rows) {
    show({low - margin, drawn_rows});
    const int read = window->GetPixelData(0, 0, width * factor - 1, drawn_rows * factor - 1, 1, pixels, 0);
    if (read == VTK_ERROR ||
        pixels->GetNumberOfValues() != vtkIdType{3} * width * factor * drawn_rows * factor) {
      fail_drawing("the picture cannot be read back from the off-screen window");
    }
    const Image band = reduced(pixels->GetPointer(0), width, drawn_rows, factor);
    const int wanted = std::min(rows, height - low);
    const int first = margin + rows - wanted;
    std::copy(band.row(first), band.row(first + wanted), image.row(height - low - wanted));
  }
  return image;
}

}  // namespace hfrac::viz
