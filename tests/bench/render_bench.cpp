// SPDX-License-Identifier: BSD-3-Clause
// Pictures of 1920 x 1080 with the PNG written. From discs in memory: overviews of models of 10 000 to 12 million discs,
// and a close-up of the largest. From run folders: the same with reading the files and everything around the view, and
// a movie of 60 frames. Needs no display. The counters give the memory the process held at most; it only rises, so run
// one benchmark at a time to see its own (--benchmark_filter).
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "disc_detail.h"
#include "hfrac/viz.h"
#include "image.h"
#include "offscreen_window.h"
#include "page.h"
#include "run/files.hpp"
#include "synthetic_run.h"

namespace {

using namespace hfrac::viz;

constexpr int width = 1920;
constexpr int height = 1080;

// Discs of a hundred sizes that touch, in rows, in a model of 16 to 9.
const Discs& model(std::int64_t count) {
  static std::map<std::int64_t, Discs> models;
  Discs& discs = models[count];
  if (!discs.discs.empty()) return discs;
  const auto columns = static_cast<std::int64_t>(std::sqrt(static_cast<double>(count) * 16 / 9));
  for (std::int64_t i = 0; i < count; ++i) {
    discs.discs.push_back({{static_cast<double>(i % columns) + 0.5, static_cast<double>(i / columns) + 0.5},
                           0.35 + 0.0015 * static_cast<double>(i * 7919 % 100)});
  }
  return discs;
}

Extent extent_of(std::int64_t count, double part) {
  const double columns = std::floor(std::sqrt(static_cast<double>(count) * 16 / 9));
  return {0, 0, columns * part, columns * part * 9 / 16};
}

void note_memory(benchmark::State& state) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["most_memory_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

void draw(benchmark::State& state, double part) {
  const Discs& discs = model(state.range(0));
  const auto window = make_offscreen_window();
  const auto target = std::filesystem::temp_directory_path() / "hfrac_render_bench.png";
  for (auto _ : state) {
    Page page(window, width, height);
    const View view = page.view({0, 0, width, height}, extent_of(state.range(0), part));
    view.renderer->AddActor(discs_in_view(view, discs, palette().disc, palette().disc_rim,
                                          view.metres_per_pixel / page.drawn_pixels()));
    write_whole(target, png(page.draw()));
  }
  note_memory(state);
  std::filesystem::remove(target);
}

void overview(benchmark::State& state) {
  draw(state, 1.0);
}
BENCHMARK(overview)
    ->Arg(10'000)
    ->Arg(1'000'000)
    ->Arg(3'600'000)
    ->Arg(12'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void close_up(benchmark::State& state) {
  draw(state, 0.05);
}
BENCHMARK(close_up)->Arg(3'600'000)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

// A run folder of about so many discs, made once per process.
const std::filesystem::path& folder_of(std::int64_t discs, int snapshots) {
  static std::map<std::pair<std::int64_t, int>, std::unique_ptr<hfrac::viz_test::TemporaryFolder>> folders;
  auto& folder = folders[{discs, snapshots}];
  if (!folder) {
    folder = std::make_unique<hfrac::viz_test::TemporaryFolder>();
    hfrac::viz_test::SyntheticRun run;
    run.columns = static_cast<int>(std::lround(std::sqrt(static_cast<double>(discs))));
    run.snapshots = snapshots;
    hfrac::viz_test::write_run(folder->path(), run);
  }
  return folder->path();
}

void from_files(benchmark::State& state) {
  const std::filesystem::path& folder = folder_of(state.range(0), 1);
  hfrac_viz_view_options options;
  hfrac_viz_view_options_init(&options, sizeof options);
  options.width = width;
  options.height = height;
  const char* view = "discs";
  const std::string target = folder / "view.png";
  for (auto _ : state) {
    if (hfrac_viz_render_views(folder.c_str(), &view, 1, target.c_str(), &options) != HFRAC_OK) {
      state.SkipWithError("no picture");
      break;
    }
  }
  note_memory(state);
}
BENCHMARK(from_files)
    ->Arg(10'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void movie_of_60_frames(benchmark::State& state) {
  const std::filesystem::path& folder = folder_of(state.range(0), 60);
  hfrac_viz_options options;
  hfrac_viz_options_init(&options, sizeof options);
  options.movie_width = width;
  options.movie_height = height;
  const std::string target = folder / "movie.mp4";
  for (auto _ : state) {
    if (hfrac_viz_render_movie(folder.c_str(), target.c_str(), &options, nullptr, nullptr) != HFRAC_OK) {
      state.SkipWithError("no movie");
      break;
    }
  }
  note_memory(state);
}
BENCHMARK(movie_of_60_frames)
    ->Arg(10'000)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
