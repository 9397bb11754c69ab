// SPDX-License-Identifier: BSD-3-Clause
#include "step/slips.hpp"

#include <cmath>

namespace hfrac {

void log_slips(Model& m, std::int64_t step, double time, double duration) {
  const SmoothJoints& smooth = m.assembly.smooth;
  if (smooth.empty()) return;
  // Found from the log itself, so that the log alone is state.
  std::vector<double> logged(smooth.contacts.size(), 0.0);
  for (const Slip& slip : m.slips)
    logged[static_cast<std::size_t>(smooth.place[static_cast<std::size_t>(slip.bond)])] += slip.slip;
  const double least = logged_slip * 2.0 * m.assembly.mean_radius;
  for (std::size_t k = 0; k < logged.size(); ++k) {
    const double more = smooth.contacts[k].slip - logged[k];
    if (std::abs(more) >= least) m.slips.push_back({smooth.contacts[k].bond, step, time, duration, more});
  }
}

}  // namespace hfrac
