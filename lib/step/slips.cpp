// SPDX-License-Identifier: BSD-3-Clause
#include "step/slips.hpp"

#include <cmath>

namespace hfrac {

void log_slips(Model& m, std::int64_t step, double time, double duration) {
  for (auto& contact : m.assembly.smooth.contacts) {
    const double least = logged_slip * 2.0 * m.assembly.mean_radius_of(contact.bond);
    const double more = contact.slip - contact.slip_logged;
    if (std::abs(more) < least) continue;
    m.slips.push_back({contact.bond, step, time, duration, more});
    contact.slip_logged += more;
  }
}

void count_logged_slips(Model& m) {
  for (auto& contact : m.assembly.smooth.contacts) contact.slip_logged = 0.0;
  for (const Slip& slip : m.slips) m.assembly.smooth.of(slip.bond)->slip_logged += slip.slip;
}

}  // namespace hfrac
