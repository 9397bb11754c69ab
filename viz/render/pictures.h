// SPDX-License-Identifier: BSD-3-Clause
// The pictures themselves: which layers, what around them, where on the page.
#pragma once

#include <string>
#include <vector>

#include "history.h"
#include "image.h"
#include "offscreen_window.h"
#include "run_folder.h"

namespace hfrac::viz {

struct PictureSize {
  int width = 1600;  // [pixel]
  int height = 0;    // [pixel] 0: as the model's shape asks
};

// What every picture of a run needs.
struct Studio {
  OffscreenWindow* window = nullptr;
  const RunFolder* run = nullptr;
  PictureSize size;
};

// A snapshot with what is wanted of it.
struct Scene {
  HistoryPoint point;
  Discs discs;
  Bonds bonds;
  Cracks cracks;
  Flow flow;
};

// "step 120, t = 3.4 s"
std::string moment_text(const HistoryPoint& point);

Scene load_scene(const RunFolder& run, const HistoryPoint& point, bool with_bonds, bool with_flow);

Image model_picture(const Studio& studio, const Scene& scene);
Image stage_picture(const Studio& studio, const Scene& scene);
Image growth_picture(const Studio& studio, const std::vector<Scene>& scenes);
// Throws Failure(HFRAC_VIZ_ERR_READ) if the scene has no domains.
Image pressure_picture(const Studio& studio, const Scene& scene);
Image aperture_picture(const Studio& studio, const Scene& scene);

}  // namespace hfrac::viz
