// SPDX-License-Identifier: BSD-3-Clause
// What is behind `hfrac_sim *`.
#pragma once

#include <memory>

#include "hfrac/sim.h"
#include "internal.hpp"

namespace hfrac {
class Simulation;
}

struct hfrac_sim : hfrac::capi::HandleBase {
  hfrac_sim();
  ~hfrac_sim();  // in sim.cpp, where Simulation is complete

  std::unique_ptr<hfrac::Simulation> simulation;
  hfrac_progress_fn progress = nullptr;
  void* progress_user = nullptr;
  double progress_seconds = 0.0;
};
