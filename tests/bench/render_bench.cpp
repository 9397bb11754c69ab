// SPDX-License-Identifier: BSD-3-Clause
// Pictures of 1920 x 1080 with the PNG written, from discs in memory: overviews of models of 10 000 to 3.6 million
// discs, and a close-up of the largest. Needs no display. The counters give the memory the process held at most.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "disc_detail.h"
#include "image.h"
#include "offscreen_window.h"
#include "page.h"
#include "whole_file.h"

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
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["most_memory_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
  std::filesystem::remove(target);
}

void overview(benchmark::State& state) {
  draw(state, 1.0);
}
BENCHMARK(overview)
    ->Arg(10'000)
    ->Arg(1'000'000)
    ->Arg(3'600'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void close_up(benchmark::State& state) {
  draw(state, 0.05);
}
BENCHMARK(close_up)->Arg(3'600'000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
