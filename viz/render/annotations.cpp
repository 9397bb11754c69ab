// SPDX-License-Identifier: BSD-3-Clause
#include "annotations.h"

#include <algorithm>
#include <cmath>

#include "number_text.h"

namespace hfrac::viz {
namespace {

constexpr double label_size = 24;
constexpr double tick_size = 21;
constexpr double rise = 0.36;  // of the em: from a text's baseline to the middle of its digits

}  // namespace

void draw_title(Page& page, double unit, double left, const std::string& title,
                const std::string& second_line) {
  const double room = page.width() - left - 30 * unit;
  TextStyle style = title_style(page, title, {34 * unit, palette().ink, true}, room);
  page.text(left, 56 * unit, fitted(page, title, style, room), style);
  style = {25 * unit, palette().faint_ink};
  page.text(left, 94 * unit, fitted(page, second_line, style, room), style);
}

void draw_frame(Page& page, double unit, const View& view) {
  page.outline(view.box, std::max(1.0, 1.6 * unit), palette().frame);
}

void draw_axes(Page& page, double unit, const View& view) {
  draw_frame(page, unit, view);
  const double length = 8 * unit;
  const double thickness = std::max(1.0, 1.6 * unit);
  TextStyle style{tick_size * unit, palette().ink, false, Align::centre};
  const int ticks_x = std::max(2, static_cast<int>(view.box.width / (160 * unit)));
  for (const Tick& tick : round_ticks(view.extent.left, view.extent.left + view.extent.width, ticks_x)) {
    const double x = view.to_page_x(tick.value);
    page.line(x, view.box.bottom(), x, view.box.bottom() + length, thickness, palette().frame);
    page.text(x, view.box.bottom() + length + 24 * unit, tick.text, style);
  }
  page.text(view.box.left + view.box.width / 2, view.box.bottom() + length + 56 * unit, "x (m)",
            {label_size * unit, palette().ink, false, Align::centre});
  style.align = Align::right;
  double widest = 0;
  const int ticks_y = std::max(2, static_cast<int>(view.box.height / (160 * unit)));
  for (const Tick& tick : round_ticks(view.extent.bottom, view.extent.bottom + view.extent.height, ticks_y)) {
    const double y = view.to_page_y(tick.value);
    page.line(view.box.left - length, y, view.box.left, y, thickness, palette().frame);
    page.text(view.box.left - length - 6 * unit, y + rise * style.size, tick.text, style);
    widest = std::max(widest, page.text_width(tick.text, style));
  }
  page.text(view.box.left - length - 16 * unit - widest, view.box.top + view.box.height / 2, "y (m)",
            {label_size * unit, palette().ink, false, Align::centre, true});
}

double draw_scale_bar(Page& page, double unit, double left, double top, double room,
                      double metres_per_pixel) {
  const double metres = round_length(room * metres_per_pixel);
  const double length = metres / metres_per_pixel;
  const double thickness = 4 * unit;
  const double cap = 9 * unit;
  const double y = top + cap;
  page.line(left, y, left + length, y, thickness, palette().ink);
  page.line(left, y - cap, left, y + cap, 3 * unit, palette().ink);
  page.line(left + length, y - cap, left + length, y + cap, 3 * unit, palette().ink);
  const TextStyle style{label_size * unit, palette().ink};
  page.text(left, y + cap + 28 * unit, value_text(metres) + " m", style);
  return y + cap + 40 * unit;
}

void draw_colour_bar(Page& page, double unit, const Box& box, const ColourMap& map, double lowest,
                     double highest, const std::string& label, const std::string& second_label) {
  const TextStyle label_style{label_size * unit, palette().ink};
  const double label_bottom = box.top - 20 * unit;
  page.text(box.left, label_bottom - (second_label.empty() ? 0.0 : 30 * unit), label, label_style);
  page.text(box.left, label_bottom, second_label, {tick_size * unit, palette().faint_ink});
  constexpr int slices = 200;
  for (int i = 0; i < slices; ++i) {
    const double height = box.height / slices;
    page.rectangle({box.left, box.bottom() - (i + 1) * height, box.width, height},
                   map.at((i + 0.5) / slices));
  }
  page.outline(box, std::max(1.0, 1.4 * unit), palette().frame);
  if (!(highest > lowest)) highest = lowest + 1;
  const TextStyle style{tick_size * unit, palette().ink};
  const int wanted = std::max(2, static_cast<int>(box.height / (110 * unit)));
  for (const Tick& tick : round_ticks(lowest, highest, wanted)) {
    const double y = box.bottom() - box.height * (tick.value - lowest) / (highest - lowest);
    page.line(box.right(), y, box.right() + 8 * unit, y, std::max(1.0, 1.6 * unit), palette().frame);
    page.text(box.right() + 16 * unit, y + rise * style.size, tick.text, style);
  }
}

double draw_legend(Page& page, double unit, double left, double top,
                   const std::vector<LegendEntry>& entries) {
  const double pitch = 44 * unit;
  const double sign_width = 40 * unit;
  const TextStyle style{label_size * unit, palette().ink};
  double y = top + pitch / 2;
  for (const LegendEntry& entry : entries) {
    const double middle = left + sign_width / 2;
    switch (entry.sign) {
      case Sign::disc:
        page.circle(middle, y, 15 * unit, entry.rim);
        page.circle(middle, y, 13 * unit, entry.colour);
        break;
      case Sign::hole:
        page.circle(middle, y, 14 * unit, entry.colour);
        break;
      case Sign::line:
        page.line(left, y, left + sign_width, y, 2.4 * unit, entry.colour);
        break;
      case Sign::band:
        page.line(left, y, left + sign_width, y, 7 * unit, entry.colour);
        break;
    }
    page.text(left + sign_width + 16 * unit, y + rise * style.size, entry.text, style);
    y += pitch;
  }
  return y - pitch / 2;
}

double draw_notes(Page& page, double unit, double left, double top, const std::vector<Note>& notes) {
  double y = top;
  for (const Note& note : notes) {
    page.text(left, y + 22 * unit, note.name, {tick_size * unit, palette().faint_ink});
    page.text(left, y + 56 * unit, note.value, {30 * unit, palette().ink});
    y += 84 * unit;
  }
  return y;
}

double draw_note_row(Page& page, double unit, double left, double top, double width,
                     const std::vector<Note>& notes) {
  const double pitch = width / static_cast<double>(std::max<std::size_t>(1, notes.size()));
  for (std::size_t i = 0; i < notes.size(); ++i) {
    const double x = left + static_cast<double>(i) * pitch;
    const auto as_fits = [&](double size, const std::string& content, Colour colour) {
      TextStyle style{size * unit, colour};
      style.size *= std::min(1.0, (pitch - 12 * unit) / std::max(1.0, page.text_width(content, style)));
      return style;
    };
    page.text(x, top + 22 * unit, notes[i].name, as_fits(tick_size, notes[i].name, palette().faint_ink));
    page.text(x, top + 56 * unit, notes[i].value, as_fits(30, notes[i].value, palette().ink));
  }
  return top + 66 * unit;
}

void draw_curve(Page& page, double unit, const Box& box, const Curve& curve, const std::string& time_label) {
  const double lowest =
      curve.values.empty() ? 0.0 : *std::min_element(curve.values.begin(), curve.values.end());
  const double bottom = std::isfinite(lowest) ? std::min(0.0, lowest) : 0.0;
  const double top = (curve.top > bottom ? curve.top : bottom + 1) + 0.04 * (curve.top - bottom);
  const double end = curve.end > 0 ? curve.end : 1;
  const auto at = [&](double time, double value) {
    return Point{box.left + box.width * std::min(1.0, time / end),
                 box.bottom() - box.height * (value - bottom) / (top - bottom)};
  };
  const double thickness = std::max(1.0, 1.6 * unit);
  TextStyle tick{0.9 * tick_size * unit, palette().ink, false, Align::right};
  for (const Tick& mark : round_ticks(bottom, top, std::max(2, static_cast<int>(box.height / (70 * unit))))) {
    const double y = at(0, mark.value).y;
    page.line(box.left, y, box.right(), y, std::max(1.0, 1.2 * unit), palette().grid);
    page.text(box.left - 10 * unit, y + rise * tick.size, mark.text, tick);
  }
  tick.align = Align::centre;
  for (const Tick& mark : round_ticks(0, end, std::max(2, static_cast<int>(box.width / (120 * unit))))) {
    const double x = at(mark.value, 0).x;
    page.line(x, box.bottom(), x, box.bottom() + 6 * unit, thickness, palette().frame);
    page.text(x, box.bottom() + 28 * unit, mark.text, tick);
  }
  page.line(box.left, box.bottom(), box.right(), box.bottom(), thickness, palette().frame);
  page.line(box.left, box.top, box.left, box.bottom(), thickness, palette().frame);
  const TextStyle label{tick_size * unit, palette().ink};
  page.text(box.left, box.top - 16 * unit, curve.label, label);
  page.text(box.right(), box.top - 16 * unit, curve.now,
            {1.2 * tick_size * unit, curve.colour, true, Align::right});
  page.text(box.left + box.width / 2, box.bottom() + 60 * unit, time_label,
            {tick_size * unit, palette().ink, false, Align::centre});
  Point previous;
  bool begun = false;
  for (std::size_t i = 0; i < curve.times.size() && i < curve.values.size(); ++i) {
    if (!std::isfinite(curve.values[i])) continue;
    const Point next = at(curve.times[i], curve.values[i]);
    if (begun && curve.stepped) page.line(previous.x, previous.y, next.x, previous.y, 3 * unit, curve.colour);
    if (begun)
      page.line(curve.stepped ? next.x : previous.x, previous.y, next.x, next.y, 3 * unit, curve.colour);
    previous = next;
    begun = true;
  }
  if (begun) page.circle(previous.x, previous.y, 6 * unit, curve.colour);
}

}  // namespace hfrac::viz
