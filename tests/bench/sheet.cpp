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
// more, or on a card ("gpu" for the number of workers), by the clock; with the card's own copy bandwidth beside it. Bytes are the process's peak, set-up
// included, over the number of discs.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "core/device.hpp"
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

// Bytes read and written per second by a card that copies within itself.
double copy_bandwidth(const Device& device) {
  constexpr std::size_t bytes = std::size_t{1} << 30U;
  constexpr int times = 20;
  DeviceArray from(device), to(device);
  from.reserve(bytes);
  to.reserve(bytes);
  device.copy(to.as<void>(), from.as<void>(), bytes, 2);
  const double begin = now();
  device.copy(to.as<void>(), from.as<void>(), bytes, times);
  return 2.0 * static_cast<double>(bytes) * times / (now() - begin);
}

int run(std::int64_t count, int worker_count, ContactMode mode, const Device* device) {
  const Options options = bench::sheet_options(mode);
  const double begin = now();
  bench::Sheet sheet(count, options);
  Boundary boundary(sheet.model, options);
  Workers workers(worker_count);
  ExplicitSolver solver(sheet.model, boundary, options, workers);
  solver.use_device(device);
  solver.let_state_stay();  // as a simulation does
  const bool by_processor_time = worker_count == 1 && device == nullptr;
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
    const double at = by_processor_time ? processor_seconds() : now();
    solver.run(cycles, cracks);
    seconds.push_back(((by_processor_time ? processor_seconds() : now()) - at) / static_cast<double>(cycles));
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
      seconds.size(), built, device != nullptr ? device->name().c_str() : kernel_isa(),
      mode == ContactMode::parallel ? "parallel" : "after-break");
  if (device != nullptr) std::printf("copy %s %.4g B/s\n", device->name().c_str(), copy_bandwidth(*device));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 0;
  const bool on_card = argc > 2 && std::strcmp(argv[2], "gpu") == 0;
  const int workers = argc > 2 && !on_card ? std::atoi(argv[2]) : 1;
  bool parallel = true;
  for (int k = 3; k < argc; ++k) {
    if (std::strcmp(argv[k], "after-break") == 0) parallel = false;
  }
  if (count < 16 || count > 100000000 || workers < 1 || workers > 256) {
    std::fprintf(stderr,
                 "usage: sheet N WORKERS|gpu [parallel|after-break]   16 to 100 000 000 discs, 1 to 256 "
                 "workers, or a card\n");
    return 2;
  }
  try {
    std::string why_none;
    const auto device = on_card ? Device::open_first(why_none) : nullptr;
    if (on_card && device == nullptr) {
      std::fprintf(stderr, "sheet: no device: %s\n", why_none.c_str());
      return 1;
    }
    return run(count, workers, parallel ? ContactMode::parallel : ContactMode::after_break, device.get());
  } catch (const Error& error) {
    std::fprintf(stderr, "sheet: %s\n", error.what());
    return 1;
  }
}
