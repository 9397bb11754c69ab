// SPDX-License-Identifier: BSD-3-Clause
// A page drawn band by band, each several times too large and reduced. The window's buffers take over 30 bytes per drawn
// pixel; for a whole page at once the system takes longer to hand out that memory than the picture to draw.
#pragma once

#include <functional>

#include "image.h"
#include "offscreen_window.h"

namespace hfrac::viz {

// Rows of the page, counted up from its lower edge; the outermost bands reach beyond the page.
struct PageBand {
  int bottom = 0;  // [pixel]
  int rows = 0;    // [pixel]
};

// `show` arranges what is in the window so that it shows that band, `factor` drawn pixels to a pixel of the page, and
// renders it.
Image drawn_in_bands(OffscreenWindow* window, int width, int height, int factor,
                     const std::function<void(const PageBand&)>& show);

}  // namespace hfrac::viz
