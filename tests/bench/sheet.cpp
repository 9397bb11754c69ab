// SPDX-License-Identifier: BSD-3-Clause
// The sheet: the problem on which codes of this kind are compared.
//
// Equal discs on a hexagonal lattice, neighbours bonded, free edges, small random velocities, damping, breakage checked in
// every cycle though nothing breaks, real masses, double precision ("single": but for the bonds' stored geometry). Building it
// is not counted. Prints
//
//     hfrac N cores bonds bond_updates_per_s particle_steps_per_s bytes_per_particle | details
//
// from the fastest of several segments, the fairest figure on a machine that is shared; with one worker by processor time, with
// more by the clock. Bytes are the process's peak, set-up
// included, over the number of discs.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "core/error.hpp"
#include "sheet_model.hpp"

using namespace hfrac;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Seconds of processor time of all threads: on a shared machine the only figure one worker can be judged by.
double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

int run(std::int64_t count, int worker_count, ContactMode mode) {
  const Options options = bench::sheet_options(mode);
  const double begin = now();
  bench::Sheet sheet(count, options);
  Boundary boundary(sheet.model, options);
  Workers workers(worker_count);
  ExplicitSolver solver(sheet.model, boundary, options, workers);
  solver.use_real_masses();
  sheet.stir();
  CrackLog cracks;
  constexpr std::int64_t batch = 20;
  solver.run(batch, cracks);
  const double built = now() - begin;

  // Segments of about a quarter of a second, for about three seconds.
  double one = now();
  solver.run(batch, cracks);
  one = std::max(1e-6, now() - one);
  const auto cycles = batch * std::max<std::int64_t>(1, std::lround(0.25 / one));
  std::vector<double> seconds;
  for (const double start = now(); seconds.size() < 3 || (now() - start < 3.0 && seconds.size() < 40);) {
    const double at = worker_count == 1 ? processor_seconds() : now();
    solver.run(cycles, cracks);
    seconds.push_back(((worker_count == 1 ? processor_seconds() : now()) - at) / static_cast<double>(cycles));
  }
  if (!cracks.empty()) {
    std::fprintf(stderr, "sheet: %zu bonds broke; nothing should\n", cracks.size());
    return 1;
  }
  std::sort(seconds.begin(), seconds.end());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto discs = static_cast<double>(sheet.assembly.disc_count()),
             bonds = static_cast<double>(sheet.assembly.bond_count());
  const double best = seconds.front();
  std::printf(
      "hfrac %lld %d %lld %.4g %.4g %.0f | s/step %.4g (median %.4g of %zu), set-up %.1f s, %s, contacts "
      "%s\n",
      static_cast<long long>(sheet.assembly.disc_count()), worker_count,
      static_cast<long long>(sheet.assembly.bond_count()), bonds / best, discs / best,
      static_cast<double>(usage.ru_maxrss) * 1024.0 / discs, best, seconds[seconds.size() / 2],
      seconds.size(), built, kernel_isa(), mode == ContactMode::parallel ? "parallel" : "after-break");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const int workers = argc > 2 ? std::atoi(argv[2]) : 1;
  bool parallel = true;
  for (int k = 3; k < argc; ++k) {
    if (std::strcmp(argv[k], "after-break") == 0) parallel = false;
  }
  if (count < 16 || count > 5000000 || workers < 1 || workers > 256) {
    std::fprintf(stderr,
                 "usage: sheet N WORKERS [parallel|after-break]   16 to 5 000 000 discs, 1 to 256 "
                 "workers\n");
    return 2;
  }
  try {
    return run(count, workers, parallel ? ContactMode::parallel : ContactMode::after_break);
  } catch (const Error& error) {
    std::fprintf(stderr, "sheet: %s\n", error.what());
    return 1;
  }
}
