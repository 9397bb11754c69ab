// SPDX-License-Identifier: BSD-3-Clause
// Keeps the log of slips (model/slip_log.hpp).
#pragma once

#include "model/model.hpp"

namespace hfrac {

// Logs what smooth joints slipped since their last entries. `step` and `time` [s]: of now; `duration` [s]: of the increment that ends now.
void log_slips(Model& model, std::int64_t step, double time, double duration);

// After the log was read from an image: CountedSlip::logged, so that the log alone is state.
void count_logged_slips(Model& model);

}  // namespace hfrac
