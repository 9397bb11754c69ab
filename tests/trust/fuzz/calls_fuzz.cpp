// SPDX-License-Identifier: BSD-3-Clause
// Sequences of calls, right and wrong ones: each two bytes of the input are a call and its argument. Whatever the order, a
// call ends with a status of the list; handles that were destroyed are NULL again; a failed call of kind ARGUMENT changes no
// state.
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "host_calls.hpp"

namespace {

using fuzz::demand;
using fuzz::number;

constexpr const char* keys[] = {"model.width",
                                "packing.disc_count",
                                "stress.sigma_Hmax",
                                "well[0].pressure",
                                "well[7].rate",
                                "bond.tensile_strength",
                                "title",
                                "nonsense",
                                "well[99].x",
                                "",
                                "stepping.mode",
                                "solver.kind",
                                "flow.scheme",
                                "boundary.kind",
                                "run.workers",
                                "thermal.mode",
                                "thermal.outer",
                                "joint[0].x1"};

constexpr const char* words[] = {"walls",    "quasi-static", "transport", "coupled",
                                 "explicit", "dynamic",      "uniform"};

// Instead of a packing, which would take most of the time.
std::vector<double> lattice() {
  std::vector<double> discs;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 8; ++i)
      discs.insert(discs.end(), {6.0 * (1 + 2 * i + j % 2), 6.0 * (1 + 1.7320508 * j), 6.0});
  }
  return discs;
}

struct Host {
  hfrac::Definition def;
  std::array<hfrac_sim*, 2> sims{};
  std::vector<unsigned char> image;
  int built = 0;
};

int32_t stop_sometimes(void* count, double, const char*) {
  return ++*static_cast<int*>(count) % 7 == 0 ? 1 : 0;
}

int64_t hash_of(const hfrac_sim* sim) {
  int64_t hash = 0;
  return hfrac_state_hash(sim, &hash) == HFRAC_OK ? hash : 0;
}

// What keeps a build short, whatever was set before.
void make_small(hfrac_sim_def& def) {
  def.stepping_max_cycles = 30;
  if (def.run_workers > 3) def.run_workers = 2;
  if (def.stepping_flow_step > 1.0) def.stepping_flow_step = 1.0;
}

void call(Host& host, std::uint8_t what, std::uint8_t pick) {
  hfrac_sim*& sim = host.sims[pick & 1U];
  const auto argument = static_cast<std::uint8_t>(pick >> 1U);
  const int64_t before = sim != nullptr ? hash_of(sim) : 0;
  static int progress_count = 0;
  int32_t status = HFRAC_OK;
  int64_t count = 0, next = 0;
  char text[40];
  const int kind = what % 60;
  switch (kind) {
    case 0:
      if (sim != nullptr || host.built > 3) break;
      ++host.built;
      make_small(host.def);
      status = hfrac_sim_create(&host.def, &sim);
      demand((status == HFRAC_OK) == (sim != nullptr));
      return;
    case 1:
      status = hfrac_sim_destroy(&sim);
      demand(status == HFRAC_OK && sim == nullptr);
      return;
    case 2:
      status = hfrac_sim_def_set_f64(&host.def, keys[argument % std::size(keys)], number(what));
      break;
    case 3:
      status =
          hfrac_sim_def_set_i64(&host.def, keys[argument % std::size(keys)], static_cast<int64_t>(what) - 3);
      break;
    case 4:
      status = hfrac_sim_def_set_str(&host.def, keys[argument % std::size(keys)],
                                     words[argument / std::size(keys) % std::size(words)]);
      break;
    case 5:
      status = hfrac_sim_def_check(&host.def);
      break;
    case 6:
      status = hfrac_step(sim, argument % 4 == 3 ? -1 : argument % 3);
      break;
    case 7: {
      double reached = 0.0;
      int32_t reason = 0;
      hfrac_sim_state state{};
      state.struct_size = sizeof state;
      if (hfrac_sim_get_state(sim, &state) != HFRAC_OK) break;
      status = hfrac_advance(sim, argument % 5 == 0 ? number(argument) * 0.0 : state.time + 1e-2, &reached,
                             &reason);
      break;
    }
    case 8:
      status = hfrac_step_prepare(sim);
      break;
    case 9:
      status = hfrac_step_do(sim, number(argument) > 1.0 ? 1e-2 : number(argument));
      break;
    case 10:
      status = hfrac_step_finalize(sim);
      break;
    case 11:
      status = hfrac_step_reject(sim);
      break;
    case 12:
      if (hfrac_state_size(sim, &count) != HFRAC_OK) break;
      host.image.resize(static_cast<std::size_t>(count));
      status = hfrac_state_save(sim, host.image.data(), argument % 8 == 0 ? count - 1 : count, &count);
      break;
    case 13:
      status = hfrac_state_restore(sim, host.image.empty() ? nullptr : host.image.data(),
                                   static_cast<int64_t>(host.image.size()) - (argument % 8 == 0 ? 1 : 0));
      break;
    case 14:
      status = hfrac_well_set_pressure(sim, argument % 3 - 1, number(what));
      break;
    case 15:
      status = hfrac_well_set_ramp(sim, argument % 3 - 1, number(argument), number(what));
      break;
    case 16:
      status = hfrac_well_set_rate(sim, argument % 3 - 1, number(argument) * 1e-4);
      break;
    case 17:
      status = hfrac_set_far_field(sim, number(argument), number(what));
      break;
    case 18:
      status = hfrac_set_formation_pressure(sim, number(argument));
      break;
    case 19: {
      std::array<double, 64> values{};
      status = hfrac_field_copy_f64(sim, argument, argument % 2 == 0 ? values.data() : nullptr, 64, &count);
      break;
    }
    case 20: {
      std::array<int32_t, 64> values{};
      status = hfrac_field_copy_i32(sim, argument, values.data(), argument % 3 == 0 ? -1 : 64, &count);
      break;
    }
    case 21: {
      std::array<hfrac_crack, 4> cracks{};
      status = hfrac_cracks_since(sim, argument % 4 - 1, argument % 5 == 0 ? 12 : sizeof(hfrac_crack),
                                  cracks.data(), 4, &count, &next);
      break;
    }
    case 22: {
      std::array<hfrac_fracture, 4> fractures{};
      status = hfrac_fractures(sim, sizeof(hfrac_fracture), fractures.data(), argument % 6 - 1, &count);
      break;
    }
    case 23: {
      hfrac_balance balance{};
      balance.struct_size = argument % 4 == 0 ? argument : static_cast<int32_t>(sizeof balance);
      if (balance.struct_size <= static_cast<int32_t>(sizeof balance))
        status = hfrac_get_balance(sim, &balance);
      break;
    }
    case 24:
      status = hfrac_last_error(sim, text, argument % 41, nullptr);
      break;
    case 25:
      status = hfrac_set_progress(sim, argument % 2 == 0 ? stop_sometimes : nullptr, &progress_count,
                                  number(argument));
      break;
    case 26: {
      hfrac_grid grid{};
      grid.struct_size = sizeof grid;
      grid.nx = argument % 6;
      grid.ny = 3;
      grid.dx = grid.dy = number(what) > 1e6 ? 20.0 : number(what) + 10.0;
      grid.angle = number(argument);
      status = hfrac_set_grid(sim, &grid);
      break;
    }
    case 27: {
      std::array<hfrac_cell, 64> cells{};
      status = hfrac_grid_cells(sim, argument % 4, sizeof(hfrac_cell), cells.data(), 64, &count);
      break;
    }
    case 28:
      status = hfrac_status_text(static_cast<int8_t>(pick), text, sizeof text, nullptr);
      break;
    case 29:
      status = hfrac_sim_def_get_str(&host.def, keys[argument % std::size(keys)], text, sizeof text, nullptr);
      break;
    default:
      status = fuzz::host_call(sim, host.def, kind - 30, argument, number(what));
  }
  demand(status != HFRAC_ERR_INTERNAL);
  demand(status == HFRAC_ERR_INTERNAL || (status >= HFRAC_ERR_COLLAPSED && status <= HFRAC_STOP_CONDITION));
  if (status == HFRAC_ERR_ARGUMENT && sim != nullptr) demand(hash_of(sim) == before);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Host host;
  host.def.stress_convention = 1;
  host.def.boundary_kind = 1;
  host.def.stress_sigma_Hmax = host.def.stress_sigma_hmin = 0.0;
  host.def.stepping_flow_step = 1e-2;
  hfrac_sim_def_set_i64(&host.def, "well_count", 1);
  host.def.wells[0].x = host.def.wells[0].y = 50.0;
  host.def.wells[0].radius = 14.0;
  host.def.wells[0].pressure = 60e6;
  static const std::vector<double> discs = lattice();
  host.def.given_discs = discs.data();
  host.def.given_disc_count = static_cast<int64_t>(discs.size() / 3);
  for (std::size_t k = 0; k + 2 <= size && k < 80; k += 2) call(host, data[k], data[k + 1]);
  for (auto& sim : host.sims) demand(hfrac_sim_destroy(&sim) == HFRAC_OK);
  return 0;
}
