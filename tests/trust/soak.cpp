// SPDX-License-Identifier: BSD-3-Clause
// A long run through hfrac.h alone: does memory stay flat, does the balance stay closed?
//   hfrac_soak [--discs N] [--steps M] [--solver explicit|quasi-static] [--mode substep|dynamic|coupled] [--ramp R]
//              [--workers W] [--minutes T] [--state FILE]
// The well's pressure goes up for R steps and down for R, so that there is always something to do. Ten times on the way, and at
// the end, it prints step, memory and balance; exit status 1 if a bound is broken. After T minutes it ends early and says how far
// it came. With a FILE, it saves its state there a hundred times on the way, and goes on from it when called again: a run of many
// hours may be done in parts, whose balance is one and whose memory is looked at part by part.
// Steps are 1 ms: of flow between one rest and the next (substep), of motion (dynamic), of both together (coupled).
//
// Bounds: memory at most 4 MB above that at the first look, or at the last one that found new cracks (contacts come with them, and
// the quasi-static solver analyses its equations anew); fluid missing at most 1e-9 of what the model holds; energy missing at most
// 2 % of the largest of its entries.
#include <hfrac/hfrac.h>
#include <unistd.h>
#include <hfrac/definition.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

hfrac_sim* sim = nullptr;

void require(int32_t status) {
  if (status >= 0) return;
  char text[1024];
  hfrac_last_error(sim, text, sizeof text, nullptr);
  std::fprintf(stderr, "hfrac_soak: %s\n", text);
  std::exit(1);
}

double resident_megabytes() {
  long all = 0, resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &all, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return static_cast<double>(resident * ::sysconf(_SC_PAGESIZE)) / 1048576.0;
}

struct Look {
  long long step, cracks;
  double megabytes, fluid_share, energy_share;
};

Look look() {
  hfrac_sim_state state{};
  state.struct_size = sizeof state;
  require(hfrac_sim_get_state(sim, &state));
  hfrac_balance b{};
  b.struct_size = sizeof b;
  require(hfrac_get_balance(sim, &b));
  const double energy = std::max({std::abs(b.fluid_work), std::abs(b.boundary_work), b.damping, b.fracture,
                                  b.bond_elastic + b.contact_elastic});
  return {static_cast<long long>(state.step), static_cast<long long>(state.crack_count), resident_megabytes(),
          std::abs(b.fluid_error) / std::max(std::abs(b.stored_volume), 1e-3),
          b.energy_checked != 0 ? std::abs(b.energy_error) / energy : 0.0};
}

}  // namespace

int main(int count, char** arguments) {
  long long discs = 500, steps = 2000, ramp = 25, workers = 1;
  double minutes = 1e9;
  bool quasi_static = false;
  std::string mode = "substep", state_file;
  for (int k = 1; k + 1 < count; k += 2) {
    const std::string name = arguments[k];
    if (name == "--discs") discs = std::atoll(arguments[k + 1]);
    if (name == "--steps") steps = std::atoll(arguments[k + 1]);
    if (name == "--ramp") ramp = std::max(1LL, std::atoll(arguments[k + 1]));
    if (name == "--workers") workers = std::atoll(arguments[k + 1]);
    if (name == "--minutes") minutes = std::atof(arguments[k + 1]);
    if (name == "--mode") mode = arguments[k + 1];
    if (name == "--state") state_file = arguments[k + 1];
    if (name == "--solver") quasi_static = std::strcmp(arguments[k + 1], "quasi-static") == 0;
  }
  hfrac::Definition def;
  def.packing_disc_count = discs;
  def.stress_convention = 1;
  def.boundary_kind = 1;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  def.stepping_flow_step = 1e-3;
  def.run_workers = workers;
  def.solver_kind = quasi_static ? 1 : 0;
  require(hfrac_sim_def_set_str(&def, "stepping.mode", mode.c_str()));
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 10.0;
  def.wells[0].pressure = 30e6;
  require(hfrac_sim_create(&def, &sim));

  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto minutes_passed = [start] {
    return std::chrono::duration<double>(Clock::now() - start).count() / 60.0;
  };
  const long long tenth = std::max(1LL, steps / 10), hundredth = std::max(1LL, steps / 100);
  Look first{}, now{};
  int bad = 0;
  if (!state_file.empty() && ::access(state_file.c_str(), F_OK) == 0) {
    require(hfrac_state_load_file(sim, state_file.c_str()));
    now = look();
    std::printf("goes on from step %lld\n", now.step);
  }
  const long long begin = now.step;
  std::printf("%10s %8s %10s %14s %14s\n", "step", "cracks", "memory MB", "fluid missing", "energy missing");
  for (long long step = begin; step < steps; ++step) {
    // Between half and all of what the rock bears.
    const long long phase = step % (2 * ramp);
    const double share = static_cast<double>(std::min(phase, 2 * ramp - phase)) / static_cast<double>(ramp);
    require(hfrac_well_set_pressure(sim, 0, 15e6 + 20e6 * share));
    require(hfrac_step(sim, 1));
    const double passed = minutes_passed();
    const bool over = passed > minutes, end = over || step + 1 == steps;
    if (end || (step + 1) % hundredth == 0) {
      if (!state_file.empty()) require(hfrac_state_save_file(sim, state_file.c_str()));
      if (steps >= 10000) {
        std::fprintf(stderr, "%lld of %lld steps, about %.0f min left\n", step + 1, steps,
                     passed / static_cast<double>(step + 1 - begin) * static_cast<double>(steps - step - 1));
      }
    }
    if (!end && (step + 1) % tenth != 0) continue;
    now = look();
    if (first.step == 0 || now.cracks > first.cracks) first = now;
    std::printf("%10lld %8lld %10.2f %14.2e %14.2e\n", now.step, now.cracks, now.megabytes, now.fluid_share,
                now.energy_share);
    std::fflush(stdout);
    if (now.fluid_share > 1e-9 || now.energy_share > 0.02 || now.megabytes > first.megabytes + 4.0) bad = 1;
    if (over) {
      std::printf("time is up after %lld of %lld steps\n", now.step, steps);
      break;
    }
  }
  hfrac_solver_report work{};
  work.struct_size = sizeof work;
  require(hfrac_sim_get_solver(sim, &work));
  if (quasi_static) {
    std::printf("%lld factors, %lld Newton and %lld Krylov iterations\n",
                static_cast<long long>(work.factors), static_cast<long long>(work.newton_iterations),
                static_cast<long long>(work.linear_iterations));
  }
  std::printf("%lld discs, %s (%s), steps %lld to %lld in %.1f min: memory %+.2f MB since step %lld: %s\n",
              discs, quasi_static ? "quasi-static" : "explicit", mode.c_str(), begin, now.step,
              minutes_passed(), now.megabytes - first.megabytes, first.step,
              bad != 0 ? "a bound is BROKEN" : "all bounds hold");
  hfrac_sim_destroy(&sim);
  return bad;
}
