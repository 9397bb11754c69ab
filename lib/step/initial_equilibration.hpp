// SPDX-License-Identifier: BSD-3-Clause
// From a model that nothing loads to one at rest under the far field, with fluid in its pores and everything counted from there.
#pragma once

#include "build/build_model.hpp"
#include "step/engine.hpp"
#include "step/packed_model.hpp"

namespace hfrac {

// `at_rest`: a model of the same making that came to rest before, whose state is taken instead.
void equilibrate(Engine& engine, const Progress& progress, SetupReport& report,
                 const PackedModel* at_rest = nullptr);

// Contents, apertures, solvers and the ledger begin here. `wells` as given; returns the rock's permeability over that of a uniform
// gradient (host/cell_report.hpp).
double begin_run(Engine& engine, const std::vector<WellOptions>& wells, SetupReport& report);

}  // namespace hfrac
