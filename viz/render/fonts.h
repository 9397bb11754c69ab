// SPDX-License-Identifier: BSD-3-Clause
// The letters of pictures and charts: DejaVu where it is installed, VTK's own otherwise.
#pragma once

#include <vtkTextProperty.h>

#include "colour.h"

namespace hfrac::viz {

// Makes a text property bold or not, `size` drawn pixels high, in a colour.
void set_font(vtkTextProperty* property, bool bold, double size, Colour colour);

}  // namespace hfrac::viz
