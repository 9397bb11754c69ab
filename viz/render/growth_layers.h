// SPDX-License-Identifier: BSD-3-Clause
// The discs, their bonds and the cracks of a scene, as the pictures of growth and the movie show them.
#pragma once

#include "page.h"
#include "pictures.h"

namespace hfrac::viz {

// `unit_metres`: one design pixel in the view.
void add_growth_layers(const View& view, const Page& page, const RunFolder& run, const Scene& scene,
                       double unit_metres);

}  // namespace hfrac::viz
