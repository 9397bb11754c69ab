// SPDX-License-Identifier: BSD-3-Clause
// Memory and time of a whole simulation: set-up, then a few steps, undo image and all.
//
//     bench_memory N dry|coupled [STEPS] [WORKERS] [MPA]
//
// The paper's rock around a well in tiled bricks, real time, a millisecond a step, under so much stress (none: 0, where a wave runs into rock
// that has not moved at all). Prints
//
//     hfrac-memory N kind bytes_per_disc bond_updates_per_s | seconds of set-up, of a step, peak, in use before and after a step
//
// bytes_per_disc: the process's peak less that of a process that has done nothing yet, over the discs.
// In use, likewise: after set-up, and after the first step, with the undo image and what a flow solve keeps.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "hole_case.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"

using namespace hfrac;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Of this program alone: getrusage's figure survives exec and may be that of a larger parent.
double status_bytes(const char* what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(what)) return 1024.0 * std::stod(line.substr(6));
  }
  return 0.0;
}
double peak_bytes() {
  return status_bytes("VmHWM:");
}

void measure(std::int64_t count, bool coupled, int steps, int workers, double stress) {
  const double empty = peak_bytes();
  CaseDefinition definition = bench::hole_case(count, workers);
  definition.options.stress_sigma_Hmax = definition.options.stress_sigma_hmin = stress;
  if (!coupled) definition.options.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  const double start = now(), cpu_start = processor_seconds();
  Simulation s(definition, {}, {});
  const double built = now() - start, cpu_built = processor_seconds() - cpu_start;
  const double resident = status_bytes("VmRSS:") - empty;
  double stepped_in = resident;
  const double at = now(), cpu_at = processor_seconds();
  for (int k = 0; k < steps; ++k) {
    s.step();
    if (k == 0) stepped_in = status_bytes("VmRSS:") - empty;
  }
  const double stepped = (now() - at) / std::max(1, steps),
               cpu_stepped = (processor_seconds() - cpu_at) / std::max(1, steps);
  const double bytes = peak_bytes() - empty;
  // Bonds a second over whole steps: on an irregular packing, with all that belongs to a step.
  const double cycles = std::ceil(1e-3 / s.engine().mechanics->step()),
               rate = static_cast<double>(s.assembly().bond_count()) * cycles / std::max(1e-9, stepped);
  std::printf(
      "hfrac-memory %lld %s %.0f %.4g | set-up %.1f s (processor %.1f s), step of %.0f cycles %.2f ms "
      "(processor %.2f ms), %lld bonds, %lld domains, %zu cracks, peak %.0f MB, in use %.0f "
      "and %.0f B a disc\n",
      static_cast<long long>(s.assembly().disc_count()), coupled ? "coupled" : "dry",
      bytes / static_cast<double>(s.assembly().disc_count()), rate, built, cpu_built, cycles, 1e3 * stepped,
      1e3 * cpu_stepped, static_cast<long long>(s.assembly().bond_count()),
      static_cast<long long>(s.network().domain_count()), s.cracks().size(), bytes / 1e6,
      resident / static_cast<double>(s.assembly().disc_count()),
      stepped_in / static_cast<double>(s.assembly().disc_count()));
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const std::string kind = argc > 2 ? argv[2] : "";
  const int steps = argc > 3 ? std::atoi(argv[3]) : 2, workers = argc > 4 ? std::atoi(argv[4]) : 1;
  const double stress = argc > 5 ? 1e6 * std::atof(argv[5]) : 0.0;
  if (count < 1000 || count > 100000000 || (kind != "dry" && kind != "coupled") || steps < 0 || workers < 1) {
    std::fprintf(stderr,
                 "usage: bench_memory N dry|coupled [STEPS] [WORKERS] [MPA]   1 000 to 100 000 000 discs\n");
    return 2;
  }
  try {
    measure(count, kind == "coupled", steps, workers, stress);
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_memory: %s\n", error.what());
    return 1;
  }
  return 0;
}
