// SPDX-License-Identifier: BSD-3-Clause
// Coupled stepping on a card or on workers: rock with flow around a well, as bench_memory's, flow by conjugate gradients.
//
//     bench_card N gpu|cpu [WORKERS [STEPS]]
//
// Prints
//
//     coupled N device disc_cycles_per_s flow_step_s step_s | details
//
// disc_cycles_per_s: of 400 cycles in real time with pores that answer, nothing else. flow_step_s: of one flow step, matrix and
// hierarchy (the processor's) included. step_s: of a whole step of a millisecond with all that belongs to it. Each the least of STEPS, 3 unless
// given. WORKERS, 1 unless given, do what the processor does.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/error.hpp"
#include "hole_case.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"

using namespace hfrac;

namespace {

template <class Work>
double seconds_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void measure(std::int64_t count, bool on_card, int workers, int steps) {
  CaseDefinition definition = bench::hole_case(count, workers);
  Options& o = definition.options;
  o.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::iterative);
  o.run_device = static_cast<std::int64_t>(on_card ? RunDevice::gpu : RunDevice::cpu);
  double built = 0.0;
  std::optional<Simulation> sim;
  built = seconds_of([&] { sim.emplace(definition, std::span<const double>{}, Progress{}); });
  sim->step();
  double step = 1e300, flow = 1e300, cycles = 1e300;
  for (int k = 0; k < steps; ++k) step = std::min(step, seconds_of([&] { sim->step(); }));
  Engine& e = sim->engine();
  for (int k = 0; k < steps; ++k)
    flow =
        std::min(flow, seconds_of([&] { e.flow->advance(e.model.network, o.stepping_flow_step, e.source); }));
  constexpr std::int64_t many = 400;
  CrackLog cracks;
  for (int k = 0; k < steps; ++k)
    cycles = std::min(cycles, seconds_of([&] { e.mechanics->run(many, cracks); }));
  const auto discs = sim->assembly().disc_count();
  std::printf("coupled %lld %s %.4g %.4g %.4g | %lld pores, set-up %.1f s, %zu cracks\n",
              static_cast<long long>(discs), on_card ? e.device->name().c_str() : kernel_isa(),
              static_cast<double>(discs * many) / cycles, flow, step,
              static_cast<long long>(sim->network().domain_count()), built, cracks.size());
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const bool on_card = argc > 2 && std::strcmp(argv[2], "gpu") == 0;
  const int workers = argc > 3 ? std::atoi(argv[3]) : 1, steps = argc > 4 ? std::atoi(argv[4]) : 3;
  if (argc < 3 || (!on_card && std::strcmp(argv[2], "cpu") != 0) || count < 1000 || count > 5000000 ||
      workers < 1 || steps < 1) {
    std::fprintf(stderr, "usage: bench_card N gpu|cpu [WORKERS [STEPS]]   1 000 to 5 000 000 discs\n");
    return 2;
  }
  try {
    measure(count, on_card, workers, steps);
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_card: %s\n", error.what());
    return 1;
  }
}
