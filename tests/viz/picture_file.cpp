// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace hfrac::viz_test {
namespace {

bool is_frame(const Pixel& pixel) {
  return std::abs(pixel.red - 150) < 30 && std::abs(pixel.green - 152) < 30 &&
         std::abs(pixel.blue - 160) < 30;
}

}  // namespace

Pixel Picture::at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width || y >= height) throw std::out_of_range("pixel outside the picture");
  const std::uint8_t* pixel = rgb.data() + 3 * (static_cast<std::size_t>(y) * width + x);
  return {pixel[0], pixel[1], pixel[2]};
}

Picture read_picture(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw std::runtime_error("no file " + path.string());
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  if (image->GetNumberOfScalarComponents() != 3)
    throw std::runtime_error("not an RGB picture: " + path.string());
  Picture picture{size[0], size[1],
                  std::vector<std::uint8_t>(3 * static_cast<std::size_t>(size[0]) * size[1])};
  for (int y = 0; y < picture.height; ++y) {
    std::memcpy(picture.rgb.data() + 3 * static_cast<std::size_t>(y) * picture.width,
                image->GetScalarPointer(0, picture.height - 1 - y, 0),
                3 * static_cast<std::size_t>(picture.width));
  }
  return picture;
}

int FramedView::x(double metres) const {
  const double margin = 0.012 * std::max(model_width, model_height);
  return static_cast<int>(std::floor(left + (right - left) * (metres + margin) / (model_width + 2 * margin)));
}

int FramedView::y(double metres) const {
  const double margin = 0.012 * std::max(model_width, model_height);
  return static_cast<int>(
      std::floor(bottom - (bottom - top) * (metres + margin) / (model_height + 2 * margin)));
}

FramedView find_view(const Picture& picture, double model_width, double model_height) {
  FramedView view;
  view.model_width = model_width;
  view.model_height = model_height;
  bool found = false;
  for (int y = 0; y < picture.height; ++y) {
    int run = 0;
    for (int x = 0; x < picture.width; ++x) {
      run = is_frame(picture.at(x, y)) ? run + 1 : 0;
      if (run < picture.width / 3) continue;
      if (!found) view.top = y;
      found = true;
      view.bottom = y;
      view.left = x - run + 1;
      view.right = std::max(view.right, x);
    }
  }
  if (!found) throw std::runtime_error("the picture has no framed view");
  return view;
}

}  // namespace hfrac::viz_test
