// SPDX-License-Identifier: BSD-3-Clause
// How fast the explicit step is, per pass and whole, on the paper's packing, with the machine's triad beside it.
//
// One bond update is: gap, shear and bending of one bond, its contact with friction, breakage test, and its share of the disc
// pass (gathering, damping, integration). "dry" is that and nothing else; "coupled" adds pressures and domains.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "machine.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"

using namespace hfrac;

namespace {

// One model per size, built once: the bonds of the paper's rock around one well, displaced a little.
struct Rock {
  CaseDefinition definition;
  std::unique_ptr<Simulation> simulation;
  Model model;
  std::unique_ptr<Boundary> boundary;
};

Rock& rock(std::int64_t discs) {
  static std::map<std::int64_t, std::unique_ptr<Rock>> models;
  auto& entry = models[discs];
  if (entry) return *entry;
  entry = std::make_unique<Rock>();
  Options& o = entry->definition.options;
  o.packing_disc_count = discs;
  o.packing_residual = discs > 20000 ? 1e-2 : 1e-3;
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.fluid_formation_pressure = 0.0;
  o.flow_scheme = static_cast<std::int64_t>(FlowScheme::implicit_scheme);
  entry->definition.wells.push_back({50.0, 50.0, 8.5, 1e6, 0.0, 0.0, WellControl::pressure});
  entry->simulation = std::make_unique<Simulation>(entry->definition, std::span<const double>{}, Progress{});
  entry->simulation->step();
  entry->model = entry->simulation->model();
  entry->boundary = std::make_unique<Boundary>(entry->model, o);
  return *entry;
}

void step(benchmark::State& state, bool wet) {
  Rock& r = rock(state.range(0));
  Model& m = r.model;
  Options options = r.definition.options;
  if (!wet) options.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  Workers workers(static_cast<int>(state.range(1)));
  ExplicitSolver solver(m, *r.boundary, options, workers);
  solver.set_undrained(wet);
  CrackLog log;
  constexpr std::int64_t cycles = 200;
  for (auto _ : state) solver.run(cycles, log);
  const auto steps = static_cast<double>(state.iterations() * cycles);
  using benchmark::Counter;
  state.counters["bond_updates"] =
      Counter(steps * static_cast<double>(m.assembly.bond_count()), Counter::kIsRate);
  state.counters["disc_steps"] =
      Counter(steps * static_cast<double>(m.assembly.disc_count()), Counter::kIsRate);
  state.SetLabel(kernel_isa());
}

void dry_step(benchmark::State& state) {
  step(state, false);
}
void coupled_step(benchmark::State& state) {
  step(state, true);
}

void flow_solve(benchmark::State& state) {
  Rock& r = rock(state.range(0));
  Model& m = r.model;
  FlowSolver solver(m.network, r.definition.options);
  Network network = m.network;
  for (auto _ : state) solver.advance(network, 1.0, {});
  state.counters["domains"] = static_cast<double>(network.domain_count());
}

void machine_triad(benchmark::State& state) {
  double rate = 0.0;
  for (auto _ : state) rate = std::max(rate, bench::triad(static_cast<std::size_t>(state.range(0)), 3));
  state.counters["bytes"] =
      benchmark::Counter(rate, benchmark::Counter::kDefaults, benchmark::Counter::kIs1000);
}

}  // namespace

BENCHMARK(machine_triad)->Arg(1 << 14)->Arg(1 << 24)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(dry_step)
    ->Args({10000, 1})
    ->Args({10000, 2})
    ->Args({100000, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(coupled_step)
    ->Args({10000, 1})
    ->Args({10000, 2})
    ->Args({100000, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(flow_solve)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
