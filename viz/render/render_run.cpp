// SPDX-License-Identifier: BSD-3-Clause
#include "render_run.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "colour.h"
#include "failure.h"
#include "movie_maker.h"
#include "page.h"
#include "paraview_script.h"
#include "pictures.h"
#include "run/files.hpp"
#include "snapshot.h"
#include "vtk_messages.h"

namespace hfrac::viz {
namespace {

// Everything drawing needs, alive for one call.
struct Workshop {
  Workshop(const std::filesystem::path& folder, const hfrac_viz_options& wanted)
      : options(wanted), run(open_run(folder)), window(make_offscreen_window()) {}

  Studio studio() const { return {window, &run, {options.width, options.height}}; }
  std::string title() const { return run.title.empty() ? "hfrac" : run.title; }

  // The snapshot asked for, or if none was, the first or the last.
  HistoryPoint first_or_chosen() const {
    return history_point(run, options.snapshot < 0 ? run.discs.begin()->first : options.snapshot);
  }
  HistoryPoint last_or_chosen() const { return history_point(run, options.snapshot); }

  hfrac_viz_options options;
  RunFolder run;
  vtkSmartPointer<OffscreenWindow> window;
};

// Kept once they are read; but of a large model, of which each takes as much memory as some of its fields, one at a time.
SceneList stage_scenes(const Workshop& shop) {
  constexpr std::size_t most_kept = 5'000'000;  // discs, of all scenes
  const std::vector<HistoryPoint> history = read_history(shop.run);
  const std::vector<int> stages = growth_stages(history);
  auto kept = std::make_shared<std::vector<std::shared_ptr<const Scene>>>(stages.size());
  return {static_cast<int>(stages.size()), [&shop, history, stages, kept](int i) {
            auto& place = (*kept)[static_cast<std::size_t>(i)];
            if (place) return place;
            auto scene = std::make_shared<const Scene>(
                load_scene(shop.run, history[stages[static_cast<std::size_t>(i)]], true, true));
            if (scene->discs.discs.size() * stages.size() <= most_kept) place = scene;
            return scene;
          }};
}

// The movie's picture of one snapshot, with the curves and axes it has there.
void frame_picture(const Workshop& shop, const PageSink& sink) {
  const MovieCurves curves = movie_curves(shop.run, read_history(shop.run), false);
  movie_frame(shop.studio(), load_scene(shop.run, shop.last_or_chosen(), false, false), curves, sink);
}

void single_picture(const Workshop& shop, int picture, const PageSink& sink) {
  const auto scene = [&](const HistoryPoint& point, bool with_bonds) {
    return load_scene(shop.run, point, with_bonds, true);
  };
  switch (picture) {
    case HFRAC_VIZ_MODEL:
      return model_picture(shop.studio(), scene(shop.first_or_chosen(), true), sink);
    case HFRAC_VIZ_STAGE:
      return stage_picture(shop.studio(), scene(shop.last_or_chosen(), true), sink);
    case HFRAC_VIZ_GROWTH:
      return growth_picture(shop.studio(), stage_scenes(shop), sink);
    case HFRAC_VIZ_PRESSURE:
      return pressure_picture(shop.studio(), scene(shop.last_or_chosen(), false), sink);
    case HFRAC_VIZ_APERTURE:
      return aperture_picture(shop.studio(), scene(shop.last_or_chosen(), false), sink);
    case HFRAC_VIZ_MOVIE:
      return frame_picture(shop, sink);
    default:
      fail_argument("no such picture: " + std::to_string(picture));
  }
}

using Draw = std::function<void(const PageSink& sink)>;

// One drawing into a file per ending; what VTK complains about meanwhile makes it fail.
void save(const Workshop& shop, const std::filesystem::path& stem, const std::vector<std::string>& endings,
          const Draw& draw) {
  std::vector<std::vector<std::uint8_t>> contents;
  VtkMessages messages;
  draw([&](Page& page) {
    for (const std::string& ending : endings)
      contents.push_back(page_content(page, ending, shop.title(), shop.options.dots_per_inch));
  });
  messages.demand_none();
  for (std::size_t i = 0; i < endings.size(); ++i) write_whole(stem.string() + endings[i], contents[i]);
}

std::vector<std::string> endings_of(int formats) {
  std::vector<std::string> endings;
  if ((formats & HFRAC_VIZ_PNG) != 0) endings.emplace_back(".png");
  if ((formats & HFRAC_VIZ_SVG) != 0) endings.emplace_back(".svg");
  if ((formats & HFRAC_VIZ_PDF) != 0) endings.emplace_back(".pdf");
  return endings;
}

void tell(const Progress& progress, double fraction, const std::string& what) {
  if (progress && progress(fraction, what)) throw Stopped{};
}

}  // namespace

void render_picture(const std::filesystem::path& folder, int picture, const std::filesystem::path& target,
                    const hfrac_viz_options& options) {
  const std::string ending = picture_ending(target);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const Workshop shop(folder, options);
  std::filesystem::path stem = target;
  save(shop, stem.replace_extension(), {ending},
       [&](const PageSink& sink) { single_picture(shop, picture, sink); });
}

void render_movie(const std::filesystem::path& folder, const std::filesystem::path& target,
                  const hfrac_viz_options& options, const Progress& progress) {
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  make_movie(folder, target, options, progress);
}

void render_run(const std::filesystem::path& folder, const hfrac_viz_options& options,
                const Progress& progress) {
  constexpr double pictures_share = 0.3;  // of the time, the movie takes the rest
  constexpr double most_pictures = 9;
  tell(progress, 0.0, "reading");
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const Workshop shop(folder, options);
  const std::vector<std::string> endings = endings_of(options.formats);
  const std::filesystem::path target = folder / "pictures";
  make_folder(target);
  write_whole(shop.run.path / "paraview_state.py", paraview_script(shop.run));
  const auto wanted = [&](int pictures) { return (options.pictures & pictures) != 0; };
  const bool movie = wanted(HFRAC_VIZ_MOVIE);
  int done = 0;
  const auto picture = [&](const std::string& name, const Draw& draw) {
    tell(progress, (movie ? pictures_share : 1.0) * done++ / most_pictures, name);
    save(shop, target / name, endings, draw);
  };
  const auto single = [&](const char* name, int kind) {
    picture(name, [&](const PageSink& sink) { single_picture(shop, kind, sink); });
  };
  if (wanted(HFRAC_VIZ_MODEL)) single("model", HFRAC_VIZ_MODEL);
  if (wanted(HFRAC_VIZ_STAGE | HFRAC_VIZ_GROWTH)) {
    const SceneList scenes = stage_scenes(shop);
    for (int i = 0; i < scenes.count && wanted(HFRAC_VIZ_STAGE); ++i) {
      picture("growth_" + std::to_string(i + 1),
              [&](const PageSink& sink) { stage_picture(shop.studio(), *scenes.load(i), sink); });
    }
    if (wanted(HFRAC_VIZ_GROWTH))
      picture("growth", [&](const PageSink& sink) { growth_picture(shop.studio(), scenes, sink); });
  }
  if (wanted(HFRAC_VIZ_PRESSURE) && !shop.run.flow.empty()) single("pressure", HFRAC_VIZ_PRESSURE);
  if (wanted(HFRAC_VIZ_APERTURE)) single("aperture", HFRAC_VIZ_APERTURE);
  if (movie) {
    make_movie(folder, target / "movie.mp4", options, [&](double fraction, const std::string& what) {
      return progress && progress(pictures_share + (1 - pictures_share) * fraction, what);
    });
  }
  tell(progress, 1.0, "done");
}

}  // namespace hfrac::viz
