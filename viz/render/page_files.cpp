// SPDX-License-Identifier: BSD-3-Clause
#include "page_files.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "failure.h"
#include "page_content.h"
#include "png_file.h"
#include "run/files.hpp"
#include "svg_text.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

// VTK's exporters write a file of that name; what they complain about makes them fail.
template <class Write>
void export_whole(const std::filesystem::path& target, const Write& write) {
  WholeFile file(target);
  VtkMessages messages;
  write(file.working_path());
  messages.demand_none();
  std::error_code missing;
  if (std::filesystem::file_size(file.working_path(), missing) == 0 || missing) {
    fail_writing("cannot write " + target.string());
  }
  file.commit();
}

void mend(const std::filesystem::path& path) {
  std::stringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << mended_svg(content.str(), palette().paper);
  file.close();
  if (!file) fail_writing("cannot write " + path.string());
}

Image page_image(const PageContent& content, OffscreenWindow* window, int width) {
  const int factor = width <= 2700 ? 3 : width <= 5400 ? 2 : 1;
  VtkMessages messages;
  // Whole pixels in both directions, whatever the width.
  const double height = std::round(content.height * width / ChartPage::width) * ChartPage::width / width;
  ChartPage page(window, height, static_cast<double>(width) * factor / ChartPage::width);
  content.fill(page);
  Image image = page.draw(factor);
  messages.demand_none();
  return image;
}

}  // namespace

void write_page(const std::filesystem::path& target, const PageContent& content, OffscreenWindow* window,
                const PagePixels& pixels) {
  const std::string ending = picture_ending(target);
  if (ending == ".png") {
    write_whole(target, png(page_image(content, window, pixels.width), pixels.dots_per_inch));
  } else if (ending == ".svg") {
    export_whole(target, [&](const std::filesystem::path& path) {
      ChartPage page(window, content.height, 1.0);
      content.fill(page);
      page.write_svg(path, content.title);
      mend(path);
    });
  } else {
    export_whole(target, [&](const std::filesystem::path& path) {
      ChartPage page(window, content.height, 1.0);
      content.fill(page);
      page.write_pdf(path, content.title);
    });
  }
}

}  // namespace hfrac::viz
