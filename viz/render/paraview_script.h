// SPDX-License-Identifier: BSD-3-Clause
// A Python script for ParaView that opens a run as the pictures look.
#pragma once

#include <string>

#include "run/run_folder.hpp"

namespace hfrac::viz {
using namespace hfrac::run;

// It finds the run beside itself, so the folder may be moved.
std::string paraview_script(const RunFolder& run);

}  // namespace hfrac::viz
