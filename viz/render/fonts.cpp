// SPDX-License-Identifier: BSD-3-Clause
#include "fonts.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace hfrac::viz {
namespace {

bool readable(const char* path) {
  return path[0] != 0 && ::access(path, R_OK) == 0;
}

}  // namespace

std::string font_file(bool bold) {
  const char* file = bold && readable(HFRAC_VIZ_BOLD_FONT) ? HFRAC_VIZ_BOLD_FONT : HFRAC_VIZ_FONT;
  return readable(file) ? file : "";
}

void set_font(vtkTextProperty* property, bool bold, double size, Colour colour) {
  const std::string file = font_file(bold);
  if (!file.empty()) {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
    property->SetBold(0);
  } else {  // VTK's own, without Greek letters
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
  }
  property->SetFontSize(std::max(4, static_cast<int>(std::lround(size))));
  property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

}  // namespace hfrac::viz
