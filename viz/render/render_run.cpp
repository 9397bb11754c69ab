// SPDX-License-Identifier: BSD-3-Clause
#include "render_run.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "colour.h"
#include "failure.h"
#include "history.h"
#include "movie_maker.h"
#include "paraview_script.h"
#include "pictures.h"
#include "vtk_messages.h"
#include "whole_file.h"

namespace hfrac::viz {
namespace {

// Everything drawing needs, alive for one call.
struct Workshop {
  Workshop(const std::filesystem::path& folder, const hfrac_viz_options& wanted)
      : options(wanted), run(open_run(folder)), history(read_history(run)), window(make_offscreen_window()) {}

  Studio studio(int width, int height) const { return {window, &run, {width, height}}; }
  Studio studio() const { return studio(options.width, options.height); }

  // The history's point of the snapshot asked for; `fallback` if none was.
  const HistoryPoint& chosen(const HistoryPoint& fallback) const {
    if (options.snapshot < 0) return fallback;
    for (const HistoryPoint& point : history) {
      if (point.number == options.snapshot) return point;
    }
    fail_argument("the run has no snapshot " + std::to_string(options.snapshot));
  }

  hfrac_viz_options options;
  RunFolder run;
  std::vector<HistoryPoint> history;
  vtkSmartPointer<OffscreenWindow> window;
};

std::vector<Scene> stage_scenes(const Workshop& shop) {
  std::vector<Scene> scenes;
  for (const int stage : growth_stages(shop.history)) {
    scenes.push_back(load_scene(shop.run, shop.history[stage], true, true));
  }
  return scenes;
}

// Draws one picture; what VTK complains about meanwhile makes it fail.
template <class Draw>
Image drawn(const Draw& draw) {
  VtkMessages messages;
  Image image = draw();
  const std::string errors = messages.take_errors();
  if (!errors.empty()) fail_drawing("drawing failed: " + errors);
  return image;
}

Image single_picture(const Workshop& shop, int picture) {
  const HistoryPoint& last = shop.chosen(shop.history.back());
  switch (picture) {
    case HFRAC_VIZ_MODEL:
      return model_picture(shop.studio(),
                           load_scene(shop.run, shop.chosen(shop.history.front()), true, true));
    case HFRAC_VIZ_STAGE:
      return stage_picture(shop.studio(), load_scene(shop.run, last, true, true));
    case HFRAC_VIZ_GROWTH:
      return growth_picture(shop.studio(), stage_scenes(shop));
    case HFRAC_VIZ_PRESSURE:
      return pressure_picture(shop.studio(), load_scene(shop.run, last, false, true));
    case HFRAC_VIZ_APERTURE:
      return aperture_picture(shop.studio(), load_scene(shop.run, last, false, true));
    default:
      fail_argument("no such picture: " + std::to_string(picture));
  }
}

void save(const std::filesystem::path& target, int dots_per_inch, const Image& image) {
  write_whole(target, png(image, dots_per_inch));
}

void write_script(const RunFolder& run) {
  const std::string text = paraview_script(run);
  write_whole(run.path / "paraview_state.py",
              {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void tell(const Progress& progress, double fraction, const std::string& what) {
  if (progress && progress(fraction, what)) throw Stopped{};
}

}  // namespace

void render_picture(const std::filesystem::path& folder, int picture, const std::filesystem::path& target,
                    const hfrac_viz_options& options) {
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const Workshop shop(folder, options);
  save(target, options.dots_per_inch, drawn([&] { return single_picture(shop, picture); }));
}

void render_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                  const hfrac_viz_options& options, const Progress& progress) {
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  make_movie(folder, target, options, progress);
}

void render_run(const std::filesystem::path& folder, const hfrac_viz_options& options,
                const Progress& progress) {
  constexpr double pictures_share = 0.3;  // of the time, the movie takes the rest
  tell(progress, 0.0, "reading");
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const Workshop shop(folder, options);
  const std::filesystem::path target = folder / "pictures";
  make_folder(target);
  write_script(shop.run);
  const bool movie = (options.pictures & HFRAC_VIZ_MOVIE) != 0;
  int done = 0;
  const auto picture = [&](const char* name, const auto& draw) {
    tell(progress, (movie ? pictures_share : 1.0) * done++ / 9.0, name);
    save(target / name, options.dots_per_inch, drawn(draw));
  };
  if ((options.pictures & HFRAC_VIZ_MODEL) != 0) {
    picture("figure3.png", [&] { return single_picture(shop, HFRAC_VIZ_MODEL); });
  }
  if ((options.pictures & (HFRAC_VIZ_STAGE | HFRAC_VIZ_GROWTH)) != 0) {
    const std::vector<Scene> scenes = stage_scenes(shop);
    for (std::size_t i = 0; i < scenes.size() && (options.pictures & HFRAC_VIZ_STAGE) != 0; ++i) {
      const std::string name = "growth_" + std::to_string(i + 1) + ".png";
      picture(name.c_str(), [&] { return stage_picture(shop.studio(), scenes[i]); });
    }
    if ((options.pictures & HFRAC_VIZ_GROWTH) != 0) {
      picture("growth.png", [&] { return growth_picture(shop.studio(), scenes); });
    }
  }
  if ((options.pictures & HFRAC_VIZ_PRESSURE) != 0 && !shop.run.flow.empty()) {
    picture("pressure.png", [&] { return single_picture(shop, HFRAC_VIZ_PRESSURE); });
  }
  if ((options.pictures & HFRAC_VIZ_APERTURE) != 0) {
    picture("aperture.png", [&] { return single_picture(shop, HFRAC_VIZ_APERTURE); });
  }
  if (movie) {
    make_movie(folder, target / "movie.mp4", options, [&](double fraction, const std::string& what) {
      return progress && progress(pictures_share + (1 - pictures_share) * fraction, what);
    });
  }
  tell(progress, 1.0, "done");
}

}  // namespace hfrac::viz
