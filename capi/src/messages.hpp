// SPDX-License-Identifier: BSD-3-Clause
// What a listener hears of building and stepping.
#pragma once

#include <cstddef>

#include "sim_handle.hpp"

namespace hfrac::capi {

// Throws Error(argument) for a level that is none.
Listener listener_of(hfrac_log_fn function, void* user, std::int64_t level);

// After the simulation was built: what was made, and what is doubtful about it.
void tell_setup(const hfrac_sim& sim);
// After a whole step that found `cracks_before` cracks.
void tell_step(const hfrac_sim& sim, std::size_t cracks_before);

}  // namespace hfrac::capi
