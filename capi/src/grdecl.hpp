// SPDX-License-Identifier: BSD-3-Clause
// The host's cells as an Eclipse include file (GRDECL).
#pragma once

#include <cstdint>
#include <string>

#include "step/host_state.hpp"

namespace hfrac::capi {

struct GrdeclRequest {
  std::int32_t kind;  // enum hfrac_grdecl_kind
  std::int64_t layers;
  double porosity;      // of the rock, 0: the network's
  double permeability;  // m2, of the rock, 0: the network's
};

// Throws Error(argument) if a value is out of range, Error(file) if the file cannot be written.
void write_grdecl(const Simulation& simulation, const std::string& path, Upscaling rule,
                  const GrdeclRequest& request);

}  // namespace hfrac::capi
