// SPDX-License-Identifier: BSD-3-Clause
// A snapshot of a million discs with six arrays, coded and written to the disk (synced), with noisy numbers, which
// pack worst. `build/bin/bench_output`; the temporary folder may be chosen with TMPDIR.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>

#include "run/files.hpp"
#include "run/vtu_writer.hpp"

namespace {

using namespace hfrac::run;

std::vector<double> noise(size_t count, double scale, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> values(-scale, scale);
  std::vector<double> result(count);
  for (double& value : result) value = values(generator);
  return result;
}

/** What the engine has: discs in rows, with values that look like those of a run to a packer. */
struct Discs {
  explicit Discs(size_t size) : count(size) {
    const auto columns = static_cast<size_t>(std::sqrt(static_cast<double>(size)));
    positions = noise(2 * size, 0.2, 1);
    for (size_t i = 0; i < size; ++i) {
      positions[2 * i] += static_cast<double>(i % columns);
      positions[2 * i + 1] += static_cast<double>(i / columns);
    }
    bonds.resize(size);
    for (size_t i = 0; i < size; ++i) bonds[i] = static_cast<int32_t>(3 + i * 7919 % 4);
  }

  size_t count;
  std::vector<double> positions;
  std::vector<double> radius = noise(count, 0.5, 2);
  std::vector<double> displacement = noise(2 * count, 1e-2, 3);
  std::vector<double> rotation = noise(count, 1e-3, 4);
  std::vector<double> stress = noise(3 * count, 3e7, 5);
  std::vector<int32_t> bonds;
};

VtuGrid grid_of(const Discs& discs) {
  VtuGrid grid;
  grid.positions = discs.positions;
  grid.offsets = even_offsets(discs.count, 1);
  grid.connectivity.resize(discs.count);
  std::iota(grid.connectivity.begin(), grid.connectivity.end(), 0);
  grid.point_data.push_back(floats("radius_m", "m", discs.radius));
  grid.point_data.push_back(floats("displacement_m", "m", in_space(discs.displacement), {"x", "y", "z"}));
  grid.point_data.push_back(floats("rotation_rad", "rad", discs.rotation));
  grid.point_data.push_back(floats("stress_Pa", "Pa", discs.stress, {"xx", "yy", "xy"}));
  grid.point_data.push_back(whole("intact_bonds", discs.bonds));
  grid.point_data.push_back(whole("disc_id", grid.connectivity));
  return grid;
}

void snapshot(benchmark::State& state, Compression compression) {
  const Discs discs(static_cast<size_t>(state.range(0)));
  const auto file = std::filesystem::temp_directory_path() / "hfrac_output_bench.vtu";
  size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = encode(grid_of(discs), Moment{}, compression, static_cast<int>(state.range(1)));
    write_whole(file, text);
    bytes = text.size();
  }
  state.counters["file_MB"] = static_cast<double>(bytes) * 1e-6;
  std::filesystem::remove(file);
}

constexpr int64_t million = 1'000'000;

BENCHMARK_CAPTURE(snapshot, zlib, Compression::zlib)
    ->Args({million, 1})
    ->Args({million, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(snapshot, lz4, Compression::lz4)
    ->Args({million, 1})
    ->Args({million, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(snapshot, none, Compression::none)
    ->Args({million, 1})
    ->Args({million, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
