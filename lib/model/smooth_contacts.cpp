// SPDX-License-Identifier: BSD-3-Clause
#include "model/smooth_contacts.hpp"

#include <algorithm>

namespace hfrac {

bool crosses(Vec2 from, Vec2 to, Vec2 p, Vec2 q) {
  const Vec2 along = to - from, bond = q - p;
  const auto apart = [](double a, double b) { return (a > 0.0) != (b > 0.0); };
  return apart(cross(along, p - from), cross(along, q - from)) &&
         apart(cross(bond, from - p), cross(bond, to - p));
}

bool SmoothJoints::separate(Vec2 p, Vec2 q) const {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const Line& line) { return crosses(line.from, line.to, p, q); });
}

void SmoothJoints::read_state(const Array<std::uint8_t>& intact, const Array<double>& slip) {
  for (auto& contact : contacts) {
    contact.holds = intact[contact.bond] != 0;
    contact.slip = slip[contact.bond];
  }
}

void SmoothJoints::write_state(Array<std::uint8_t>& intact, Array<double>& slip) const {
  for (const auto& contact : contacts) {
    intact[contact.bond] = contact.holds ? 1 : 0;
    slip[contact.bond] = contact.slip;
  }
}

}  // namespace hfrac
