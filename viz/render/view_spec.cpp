// SPDX-License-Identifier: BSD-3-Clause
#include "view_spec.h"

#include <charconv>
#include <system_error>

#include "failure.h"

namespace hfrac::viz {

std::string ViewSpec::component_text() const {
  std::string text;
  if (component > 0) text.append("[").append(std::to_string(component)).append("]");
  return text;
}

ViewSpec view_named(const std::string& name) {
  ViewSpec spec;
  if (const NamedView* view = view_of(name)) {
    spec.title = view->title;
    if (view->mesh.empty()) {
      spec.drawing = name;
      return spec;
    }
    spec.label = view->label;
    spec.note = view->note;
    spec.array = view->array;
    spec.file = view->mesh;
    spec.how = view->how;
    spec.component = view->component;
    spec.scale = view->scale;
    spec.all_values = view->all_values;
    spec.smoothed = view->smoothed;
    spec.by_width = view->array == "aperture_m";
    return spec;
  }
  spec.array = name;
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
  for (const NamedView& view : all_views()) {
    std::string line = "  " + std::string(view.name);
    line.resize(21, ' ');
    line += view.title;
    if (!view.note.empty()) line.append(": ").append(view.note);
    text += line + "\n";
  }
  return text + "  or an array of the snapshot's files: radius_m, displacement_m[1], flow:volume_m2, ...\n";
}

}  // namespace hfrac::viz
