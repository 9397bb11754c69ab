// SPDX-License-Identifier: BSD-3-Clause
// The log of slips from C.
#include "hfrac/slip.h"

#include <algorithm>
#include <string>

#include "internal.hpp"
#include "items.hpp"
#include "sim_handle.hpp"
#include "solid/shear_modulus.hpp"
#include "step/simulation.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

hfrac_slip describe(const Simulation& s, std::int64_t id, double shear_modulus) {
  const Slip& slip = s.model().slips[static_cast<std::size_t>(id)];
  const Assembly& a = s.assembly();
  const SmoothContact& contact = *a.smooth.of(slip.bond);
  const auto i = a.first[static_cast<std::size_t>(slip.bond)];
  hfrac_slip to{};
  to.id = id;
  to.bond = slip.bond;
  to.disc[0] = i;
  to.disc[1] = a.second[static_cast<std::size_t>(slip.bond)];
  to.joint = contact.joint;
  to.step = slip.step;
  to.time = slip.time;
  to.duration = slip.duration;
  to.position[0] = a.x[static_cast<std::size_t>(i)] + contact.first_arm().x;
  to.position[1] = a.y[static_cast<std::size_t>(i)] + contact.first_arm().y;
  to.normal[0] = contact.normal.x;
  to.normal[1] = contact.normal.y;
  to.length = contact.area;
  to.slip = slip.slip;
  to.distance = a.length(slip.bond);
  to.shear_modulus = shear_modulus;
  return to;
}

}  // namespace

int32_t hfrac_slips_since(hfrac_sim* sim, int64_t cursor, int32_t slip_size, hfrac_slip* buffer,
                          int64_t capacity, int64_t* count, int64_t* next) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    require_item_size(slip_size, "slip_size");
    const Simulation& s = *sim->simulation;
    const auto there = static_cast<std::int64_t>(s.model().slips.size());
    if (cursor < 0 || cursor > there) {
      throw Error(ErrorKind::argument, "cursor = " + std::to_string(cursor) + " is outside 0 to " +
                                           std::to_string(there) + ", the slips there are.");
    }
    if (buffer == nullptr) {
      *count = there - cursor;
      if (next != nullptr) *next = cursor;
      return;
    }
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    const std::int64_t taken = std::min(capacity, there - cursor);
    const double modulus = taken > 0 ? mean_field_shear_modulus(s.assembly(), s.options()) : 0.0;
    for (std::int64_t k = 0; k < taken; ++k) put_item(buffer, k, slip_size, describe(s, cursor + k, modulus));
    *count = taken;
    if (next != nullptr) *next = cursor + taken;
  });
}
