// SPDX-License-Identifier: BSD-3-Clause
// What the C interface costs: a copy of all positions against memcpy of as many bytes, a borrowed view, images of the state.
//   bench_interface [--benchmark_...]     at 10 000 and 100 000 discs (tiled packing; building them takes a while)
#include <benchmark/benchmark.h>
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <cstring>
#include <map>
#include <vector>

namespace {

hfrac_sim* sim_of(std::int64_t discs) {
  static std::map<std::int64_t, hfrac_sim*> made;
  hfrac_sim*& sim = made[discs];
  if (sim != nullptr) return sim;
  hfrac::Definition def;
  hfrac_sim_def_set_str(&def, "packing.method", "tiled");
  def.packing_disc_count = discs;
  def.packing_residual = 1e-2;
  def.stepping_force_ratio = 1e-2;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 30e6;
  hfrac_sim_create(&def, &sim);
  return sim;
}

void copy_positions(benchmark::State& state) {
  hfrac_sim* const sim = sim_of(state.range(0));
  std::int64_t count = 0;
  hfrac_field_copy_f64(sim, HFRAC_DISC_POSITION, nullptr, 0, &count);
  std::vector<double> to(static_cast<std::size_t>(count));
  for (auto _ : state) {
    hfrac_field_copy_f64(sim, HFRAC_DISC_POSITION, to.data(), count, &count);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * count * 8);
}

void memcpy_as_many(benchmark::State& state) {
  hfrac_sim* const sim = sim_of(state.range(0));
  std::int64_t count = 0;
  hfrac_field_copy_f64(sim, HFRAC_DISC_POSITION, nullptr, 0, &count);
  std::vector<double> from(static_cast<std::size_t>(count), 1.0), to(from.size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(std::memcpy(to.data(), from.data(), 8 * to.size()));
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * count * 8);
}

void borrow_view(benchmark::State& state) {
  hfrac_sim* const sim = sim_of(state.range(0));
  const void* data = nullptr;
  std::int64_t count = 0, epoch = 0;
  for (auto _ : state) {
    hfrac_field_view(sim, HFRAC_DISC_POSITION, &data, &count, &epoch);
    benchmark::DoNotOptimize(data);
  }
}

void save_state(benchmark::State& state) {
  hfrac_sim* const sim = sim_of(state.range(0));
  std::int64_t size = 0;
  hfrac_state_size(sim, &size);
  std::vector<char> image(static_cast<std::size_t>(size));
  for (auto _ : state) hfrac_state_save(sim, image.data(), size, &size);
  state.SetBytesProcessed(state.iterations() * size);
}

void restore_state(benchmark::State& state) {
  hfrac_sim* const sim = sim_of(state.range(0));
  std::int64_t size = 0;
  hfrac_state_size(sim, &size);
  std::vector<char> image(static_cast<std::size_t>(size));
  hfrac_state_save(sim, image.data(), size, &size);
  for (auto _ : state) hfrac_state_restore(sim, image.data(), size);
  state.SetBytesProcessed(state.iterations() * size);
}

BENCHMARK(copy_positions)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);
BENCHMARK(memcpy_as_many)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);
BENCHMARK(borrow_view)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kNanosecond);
BENCHMARK(save_state)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(restore_state)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
