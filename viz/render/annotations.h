// SPDX-License-Identifier: BSD-3-Clause
// What stands around a view: title, axes, scale bar, colour bar, legend, notes, small curves. Sizes are in
// units of `unit`, 1/1600 of a picture's width or as the caller sets it, so that pages of any size look
// alike.
#pragma once

#include <string>
#include <vector>

#include "colour.h"
#include "fitted_text.h"
#include "page.h"

namespace hfrac::viz {

// Two lines at the top left; the second may be empty.
void draw_title(Page& page, double unit, double left, const std::string& title,
                const std::string& second_line);

// A frame with ticks in metres at the left and the lower edge.
void draw_axes(Page& page, double unit, const View& view);
// A frame only.
void draw_frame(Page& page, double unit, const View& view);

// A round length at the view's scale, at most `room` pixels long; its text below. Returns the y below it.
double draw_scale_bar(Page& page, double unit, double left, double top, double room, double metres_per_pixel);

// Upright, values to its right; `label` above, may be two lines. Values are in the label's unit.
void draw_colour_bar(Page& page, double unit, const Box& box, const ColourMap& map, double lowest,
                     double highest, const std::string& label, const std::string& second_label);

enum class Sign { disc, line, band, hole };
struct LegendEntry {
  Sign sign = Sign::disc;
  Colour colour;
  Colour rim;
  std::string text;
};
// Returns the y below it.
double draw_legend(Page& page, double unit, double left, double top, const std::vector<LegendEntry>& entries);

struct Note {
  std::string name;
  std::string value;
};
// Lines of a faint name and a value below it. Returns the y below them.
double draw_notes(Page& page, double unit, double left, double top, const std::vector<Note>& notes);

// The same beside each other, evenly over `width`.
double draw_note_row(Page& page, double unit, double left, double top, double width,
                     const std::vector<Note>& notes);

// A curve of a quantity over time, as far as it has come.
struct Curve {
  std::string label;
  std::vector<double> times;   // in the axis' unit
  std::vector<double> values;  // in the label's unit
  double end = 1;              // of the time axis
  double top = 1;   // of the other axis; it starts at 0, or at the lowest value if that is negative
  std::string now;  // the last value, as written beside the label
  Colour colour;
  bool stepped = false;
};
// `box`: of the plot itself; its label stands above, `time_label` below it.
void draw_curve(Page& page, double unit, const Box& box, const Curve& curve, const std::string& time_label);

}  // namespace hfrac::viz
