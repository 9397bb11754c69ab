// SPDX-License-Identifier: BSD-3-Clause
#include "page_content.h"

#include "failure.h"
#include "png_file.h"

namespace hfrac::viz {

std::string picture_ending(const std::filesystem::path& target) {
  const std::string ending = target.extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf") {
    fail_argument("'" + target.string() + "' ends neither in .png, .svg nor .pdf");
  }
  return ending;
}

std::vector<std::uint8_t> page_content(Page& page, const std::string& ending, const std::string& title,
                                       int dots_per_inch) {
  if (ending == ".pdf") return page.pdf(title, dots_per_inch);
  if (ending == ".png") return png(page.draw(), dots_per_inch);
  const std::string text = page.svg(title);
  return {text.begin(), text.end()};
}

}  // namespace hfrac::viz
