// SPDX-License-Identifier: BSD-3-Clause
#include "step/slips.hpp"

#include <cmath>

namespace hfrac {

void log_slips(Model& m, std::int64_t step, double time, double duration) {
  auto& smooth = m.assembly.smooth;
  if (m.slips.empty()) m.slips.reserve(smooth.contacts.size());  // most slid in the set-up
  for (std::size_t k = 0; k < smooth.contacts.size(); ++k) {
    const auto bond = smooth.contacts[k].bond;
    const double least = logged_slip * 2.0 * m.assembly.mean_radius_of(bond);
    const double more = m.assembly.slip[bond] - smooth.counted[k].logged;
    if (std::abs(more) < least) continue;
    m.slips.push_back({bond, step, time, duration, more});
    smooth.counted[k].logged += more;
  }
}

void count_logged_slips(Model& m) {
  auto& smooth = m.assembly.smooth;
  for (auto& slip : smooth.counted) slip.logged = 0.0;
  for (const Slip& slip : m.slips) smooth.counted[smooth.place_of(*smooth.of(slip.bond))].logged += slip.slip;
}

}  // namespace hfrac
