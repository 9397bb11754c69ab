// SPDX-License-Identifier: BSD-3-Clause
// The pictures themselves: which layers, what around them, where on the page. What becomes of the page, pixels or a
// vector file, is the caller's.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "offscreen_window.h"
#include "page.h"
#include "run/run_folder.hpp"
#include "snapshot.h"

namespace hfrac::viz {

// Gets the finished page, which is gone after it.
using PageSink = std::function<void(Page&)>;

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

// Scenes in order of time, each read when it is asked for.
struct SceneList {
  int count = 0;
  std::function<std::shared_ptr<const Scene>(int)> load;
};

// "step 120, t = 3.4 s"
std::string moment_text(const HistoryPoint& point);

Scene load_scene(const RunFolder& run, const HistoryPoint& point, bool with_bonds, bool with_flow);

void model_picture(const Studio& studio, const Scene& scene, const PageSink& sink);
void stage_picture(const Studio& studio, const Scene& scene, const PageSink& sink);
void growth_picture(const Studio& studio, const SceneList& scenes, const PageSink& sink);
// Throws ReadError if the scene has no domains.
void pressure_picture(const Studio& studio, const Scene& scene, const PageSink& sink);
void aperture_picture(const Studio& studio, const Scene& scene, const PageSink& sink);

// The discs, their bonds and the cracks of a scene, as the pictures of growth and the movie show them.

// `unit_metres`: one design pixel in the view.
void add_growth_layers(const View& view, const Page& page, const RunFolder& run, const Scene& scene,
                       double unit_metres);

}  // namespace hfrac::viz
