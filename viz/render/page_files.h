// SPDX-License-Identifier: BSD-3-Clause
// A page of charts into a file; the ending of its name says which kind.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "chart_page.h"

namespace hfrac::viz {

struct PageContent {
  std::string title;  // of the document
  double height = 0;  // of the page, in its units
  std::function<void(ChartPage&)> fill;
};

struct PagePixels {
  int width = 1600;
  int dots_per_inch = 0;  // noted in the file, 0: not
};

// .png, .svg or .pdf. Throws Failure(HFRAC_ERR_ARGUMENT) for any other ending.
void write_page(const std::filesystem::path& target, const PageContent& content, OffscreenWindow* window,
                const PagePixels& pixels);

}  // namespace hfrac::viz
