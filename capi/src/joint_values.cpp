// SPDX-License-Identifier: BSD-3-Clause
#include "joint_values.hpp"

#include "flow/joint_view.hpp"
#include "hfrac/field.h"

namespace hfrac::capi {
namespace {

constexpr struct {
  std::int32_t field;
  double JointView::*value;
} numbers[] = {{HFRAC_JOINT_OPENING, &JointView::opening},
               {HFRAC_JOINT_MECHANICAL_APERTURE, &JointView::mechanical_aperture},
               {HFRAC_JOINT_HYDRAULIC_APERTURE, &JointView::hydraulic_aperture},
               {HFRAC_JOINT_SLIP, &JointView::slip},
               {HFRAC_JOINT_TOTAL_SLIP, &JointView::total_slip},
               {HFRAC_JOINT_NORMAL_STRESS, &JointView::normal_stress},
               {HFRAC_JOINT_SHEAR_STRESS, &JointView::shear_stress},
               {HFRAC_JOINT_PRESSURE, &JointView::pressure}};

constexpr struct {
  std::int32_t field;
  Vec2 JointView::*place;
} places[] = {{HFRAC_JOINT_BEGIN, &JointView::begin}, {HFRAC_JOINT_END, &JointView::end}};

template <class Use>
void each_contact(const Simulation& s, const Use& use) {
  for (const SmoothContact& contact : s.assembly().smooth.contacts)
    use(contact, view_joint(s.assembly(), s.network(), contact));
}

}  // namespace

bool write_joint_values(const Simulation& s, std::int32_t field, double* to) {
  for (const auto& number : numbers) {
    if (number.field != field) continue;
    each_contact(s, [&](const SmoothContact&, const JointView& view) { *to++ = view.*number.value; });
    return true;
  }
  for (const auto& one : places) {
    if (one.field != field) continue;
    each_contact(s, [&](const SmoothContact&, const JointView& view) {
      const Vec2 place = view.*one.place;
      *to++ = place.x;
      *to++ = place.y;
    });
    return true;
  }
  return false;
}

bool write_joint_indices(const Simulation& s, std::int32_t field, std::int32_t* to) {
  if (field != HFRAC_JOINT_NUMBER && field != HFRAC_JOINT_BOND && field != HFRAC_JOINT_CONTACT_STATE)
    return false;
  each_contact(s, [&](const SmoothContact& contact, const JointView& view) {
    *to++ = static_cast<std::int32_t>(field == HFRAC_JOINT_NUMBER ? contact.joint
                                      : field == HFRAC_JOINT_BOND ? contact.bond
                                                                  : static_cast<std::int64_t>(view.state));
  });
  return true;
}

}  // namespace hfrac::capi
