// SPDX-License-Identifier: BSD-3-Clause
#include "run/views.hpp"

#include <algorithm>
#include <array>

namespace hfrac::run {
std::span<const NamedView> all_views() {
  using enum Combination;
  using enum ColourScale;
  constexpr std::string_view stress = "stress_Pa", moved = "displacement_m";
  constexpr std::string_view compression = "compression positive", since = "since equilibration";

  // name, title, label, note, mesh, array, how, component, scale, all values, smoothed, states
  static constexpr auto views = std::to_array<NamedView>({
      {"discs", "Discs and cracks", "", "cracks by mode", "", ""},
      {"bonds", "Bonds and cracks", "", "intact bonds over the discs, cracks by mode", "", ""},
      {"forces", "Forces across bonds", "", "force chains: width by force, colour by sign", "", ""},
      {"crack-time", "Cracks by time", "broken at", "", "cracks", "time_s", component, 0, narrow, true},
      {"aperture", "Crack aperture", "aperture", "", "cracks", "aperture_m", component, 0, narrow, true},
      {"crack-pressure", "Pressure in cracks", "pressure in cracks", "", "cracks", "pressure_Pa", component,
       0, narrow, true},
      {"pressure", "Fluid pressure", "pressure", "", "flow", "pressure_Pa", component, 0, pressure, true},
      {"displacement", "Displacement", "displacement", since, "discs", moved, length},
      {"displacement-x", "Displacement along x", "displacement x", since, "discs", moved, component, 0,
       two_ways},
      {"displacement-y", "Displacement along y", "displacement y", since, "discs", moved, component, 1,
       two_ways},
      {"rotation", "Rotation of the discs", "rotation", "anticlockwise positive", "discs", "rotation_rad",
       component, 0, two_ways},
      {"stress", "Mean stress", "mean stress", compression, "discs", stress, mean, 0, two_ways, false, true},
      {"stress-xx", "Stress along x", "stress xx", compression, "discs", stress, component, 0, two_ways,
       false, true},
      {"stress-yy", "Stress along y", "stress yy", compression, "discs", stress, component, 1, two_ways,
       false, true},
      {"stress-xy", "Shear stress", "stress xy", "", "discs", stress, component, 2, two_ways, false, true},
      {"shear", "Largest shear stress", "largest shear", "", "discs", stress, shear, 0, magnitude, false,
       true},
      {"intact-bonds", "Intact bonds", "intact bonds", "", "discs", "intact_bonds", component, 0, magnitude,
       true},
      {"temperature", "Temperature", "temperature", "of the discs", "discs", "temperature_K"},
      {"fluid-temperature", "Temperature of the fluid", "temperature", "of the domains", "flow",
       "temperature_K"},
      {"joint-aperture", "Hydraulic aperture of joints", "aperture", "hydraulic", "joints",
       "hydraulic_aperture_m", component, 0, narrow},
      {"joint-slip", "Slip of joints", "slip", "positive: left-lateral", "joints", "slip_m", component, 0,
       two_ways},
      {"joint-pressure", "Pressure in joints", "pressure in joints", "", "joints", "pressure_Pa", component,
       0, narrow, true},
      {"joint-state",
       "State of joints",
       "state",
       "",
       "joints",
       "state",
       component,
       0,
       states,
       true,
       false,
       {"holds", "sticks", "slips", "open"}},
  });
  return views;
}

const NamedView* view_of(std::string_view name) {
  for (const NamedView& view : all_views())
    if (view.name == name) return &view;
  return nullptr;
}

std::string_view name_of(ColourScale scale) {
  constexpr std::array<std::string_view, 5> names = {"magnitude", "two-ways", "narrow", "pressure", "states"};
  return names.at(static_cast<size_t>(scale));
}

std::string_view name_of(Combination how) {
  constexpr std::array<std::string_view, 4> names = {"component", "length", "mean", "shear"};
  return names.at(static_cast<size_t>(how));
}

}  // namespace hfrac::run
