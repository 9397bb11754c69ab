// SPDX-License-Identifier: BSD-3-Clause
#include "view_spec.h"

#include <array>
#include <charconv>
#include <system_error>

#include "failure.h"

namespace hfrac::viz {
namespace {

struct Named {
  const char* name;
  int kind;
  const char* what;
};

constexpr std::array<Named, 13> named = {
    {{"discs", HFRAC_VIZ_VIEW_DISCS, "discs, cracks by mode"},
     {"bonds", HFRAC_VIZ_VIEW_BONDS, "intact bonds over the discs, cracks by mode"},
     {"forces", HFRAC_VIZ_VIEW_FORCES, "force chains: width by force, colour by sign"},
     {"crack-time", HFRAC_VIZ_VIEW_CRACK_TIME, "cracks by the time they broke at"},
     {"aperture", HFRAC_VIZ_VIEW_APERTURE, "cracks by aperture"},
     {"pressure", HFRAC_VIZ_VIEW_PRESSURE, "fluid pressure in the domains"},
     {"displacement", HFRAC_VIZ_VIEW_DISPLACEMENT, "of the discs since the initial equilibration"},
     {"rotation", HFRAC_VIZ_VIEW_ROTATION, "of the discs since the initial equilibration"},
     {"stress", HFRAC_VIZ_VIEW_STRESS, "mean stress, smoothed"},
     {"stress-xx", HFRAC_VIZ_VIEW_STRESS_XX, "normal stress along x, smoothed"},
     {"stress-yy", HFRAC_VIZ_VIEW_STRESS_YY, "normal stress along y, smoothed"},
     {"stress-xy", HFRAC_VIZ_VIEW_STRESS_XY, "shear stress, smoothed"},
     {"temperature", HFRAC_VIZ_VIEW_TEMPERATURE, "if the run has one"}}};

}  // namespace

ViewSpec view_of_kind(int kind) {
  for (const Named& one : named) {
    if (one.kind == kind) return {kind, "", "", 0};
  }
  fail_argument("no such view: " + std::to_string(kind));
}

ViewSpec view_named(const std::string& name) {
  for (const Named& one : named) {
    if (name == one.name) return {one.kind, "", "", 0};
  }
  ViewSpec spec{array_view, name, "", 0};
  if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
    spec.file = name.substr(0, colon);
    spec.array = name.substr(colon + 1);
    if (spec.file != "discs" && spec.file != "flow" && spec.file != "cracks" && spec.file != "bonds") {
      fail_argument("'" + spec.file + "' in '" + name + "' is none of discs, flow, cracks, bonds");
    }
  }
  if (const std::size_t open = spec.array.find('['); open != std::string::npos) {
    const char* const first = spec.array.data() + open + 1;
    const char* const last = spec.array.data() + spec.array.size();
    const auto [end, error] = std::from_chars(first, last, spec.component);
    if (error != std::errc() || end + 1 != last || *end != ']' || spec.component < 0) {
      fail_argument("'" + name + "' does not end with the number of a component, [0] the first");
    }
    spec.array.resize(open);
  }
  if (spec.array.empty()) fail_argument("'" + name + "' names no view and no array");
  return spec;
}

std::string view_names() {
  std::string text;
  for (const Named& one : named) {
    std::string name = std::string("  ") + one.name;
    name.resize(16, ' ');
    text += name + one.what + "\n";
  }
  return text + "  or an array of the snapshot's files: radius_m, displacement_m[1], flow:volume_m2, ...\n";
}

}  // namespace hfrac::viz
