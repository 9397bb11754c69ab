// SPDX-License-Identifier: BSD-3-Clause
// The letters of pictures and charts: DejaVu where it is installed, VTK's own otherwise.
#pragma once

#include <vtkTextProperty.h>

#include <string>

#include "colour.h"

namespace hfrac::viz {

// The font's file; empty where there is none.
std::string font_file(bool bold);

// Makes a text property bold or not, `size` drawn pixels high, in a colour.
void set_font(vtkTextProperty* property, bool bold, double size, Colour colour);

}  // namespace hfrac::viz
