// SPDX-License-Identifier: BSD-3-Clause
#include "movie_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "growth_layers.h"
#include "number_text.h"
#include "quantity.h"
#include "run/files.hpp"
#include "run/table_file.hpp"
#include "sheet.h"

namespace hfrac::viz {
namespace {

constexpr std::size_t most_curve_points = 1500;  // of a curve: more cannot be told apart

// The column takes all the width the view leaves.
constexpr SheetShape movie_shape{1400, 440, 640, true};

void add_point(MovieCurves& curves, double time, double pressure, double cracks) {
  if (!std::isfinite(time)) return;
  curves.time.push_back(time);
  curves.pressure.push_back(pressure);
  curves.cracks.push_back(cracks);
}

// The next of 1, 2, 5 times a power of ten, so that an axis grows in few jumps.
double rounded_up(double value) {
  if (!(value > 0)) return 1;
  double round = round_length(value);
  while (round < value) round = round_length(round * 2.6);
  return round;
}

std::vector<Note> frame_notes(const HistoryPoint& point) {
  std::vector<Note> notes = {{"time", time_text(point.moment.time)}};
  if (point.moment.step >= 0) notes.push_back({"step", count_text(point.moment.step)});
  notes.push_back(
      {"tension / shear", count_text(point.tensile_cracks) + " / " + count_text(point.shear_cracks)});
  return notes;
}

}  // namespace

MovieCurves movie_curves(const RunFolder& run, const std::vector<HistoryPoint>& history, bool live) {
  MovieCurves curves;
  const auto path = run.path / "history.csv";
  const auto table = is_file(path) ? std::optional<TableFile>(path) : std::nullopt;
  if (table && table->rows() > 1) {
    const std::vector<double> time = table->numbers("time_s");
    const std::vector<double> pressure = table->numbers("well_pressure_Pa");
    const std::vector<double> cracks = table->numbers("crack_count");
    for (std::size_t i = 0; i < time.size(); ++i) add_point(curves, time[i], pressure[i], cracks[i]);
  } else {
    for (const HistoryPoint& point : history) {
      const auto& wells = point.moment.well_pressure;
      add_point(curves, point.moment.time, wells.empty() ? std::nan("") : wells.front(), point.cracks());
    }
  }
  curves.end_time = live ? run.planned_time : (curves.time.empty() ? 0.0 : curves.time.back());
  if (live) return curves;
  for (std::size_t i = 0; i < curves.time.size(); ++i) {
    if (std::isfinite(curves.pressure[i]))
      curves.top_pressure = std::max(curves.top_pressure, curves.pressure[i]);
    curves.top_cracks = std::max(curves.top_cracks, curves.cracks[i]);
  }
  return curves;
}

PictureSize movie_size(const Studio& studio, const Discs& discs) {
  return {studio.size.width, sheet_height(studio, whole_model(*studio.run, discs), movie_shape)};
}

void movie_frame(const Studio& studio, const Scene& scene, const MovieCurves& curves, const PageSink& sink) {
  Sheet sheet(studio, whole_model(*studio.run, scene.discs), movie_shape);
  add_growth_layers(sheet.view, sheet.page, *studio.run, scene, sheet.metres(1));
  draw_sheet_title(sheet, *studio.run, "Fracture growth");
  draw_axes(sheet.page, sheet.unit, sheet.view);
  const double unit = sheet.unit;
  const double now = scene.point.moment.time;
  const double below = draw_note_row(sheet.page, unit, sheet.column_left, sheet.column_top,
                                     sheet.column_width, frame_notes(scene.point));

  // What has come until now; the axes' ends are the run's, or as far as it has come.
  std::size_t count = 0;
  const double just_after = now * (1 + 1e-9);
  while (count < curves.time.size() && curves.time[count] <= just_after) ++count;
  double pressure_now =
      scene.point.moment.well_pressure.empty() ? std::nan("") : scene.point.moment.well_pressure.front();
  double top_pressure = curves.top_pressure;
  double top_cracks = curves.top_cracks;
  double highest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(curves.pressure[i])) highest = std::max(highest, curves.pressure[i]);
    if (curves.top_cracks <= 0) top_cracks = std::max(top_cracks, curves.cracks[i]);
  }
  if (!(top_pressure > 0)) top_pressure = rounded_up(highest);
  if (!(curves.top_cracks > 0)) top_cracks = rounded_up(std::max(10.0, top_cracks));
  const double end = curves.end_time > 0 ? std::max(curves.end_time, now) : rounded_up(now);

  const Quantity time = quantity_of("time_s", end);
  const Quantity pressure = quantity_of("well_pressure_Pa", top_pressure);
  const std::string net = studio.run->net_pressures ? ", net" : "";
  std::vector<double> times(curves.time.begin(), curves.time.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<double> pressures(curves.pressure.begin(),
                                curves.pressure.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<double> cracks(curves.cracks.begin(),
                             curves.cracks.begin() + static_cast<std::ptrdiff_t>(count));
  const std::size_t step = std::max<std::size_t>(1, count / most_curve_points);
  for (std::vector<double>* values : {&times, &pressures, &cracks}) {
    std::vector<double> kept;
    for (std::size_t i = 0; i < values->size(); ++i) {
      if (i % step == 0 || i + 1 == values->size()) kept.push_back((*values)[i]);
    }
    *values = std::move(kept);
  }
  for (double& value : times) value *= time.scale;
  for (double& value : pressures) value *= pressure.scale;
  std::vector<Curve> shown;
  if (std::isfinite(pressure_now) &&
      std::any_of(pressures.begin(), pressures.end(), [](double p) { return std::isfinite(p); })) {
    shown.push_back({"well pressure" + net + " (" + pressure.unit + ")", times, pressures, end * time.scale,
                     top_pressure * pressure.scale,
                     value_text(std::round(pressure_now * pressure.scale * 100) / 100), palette().well,
                     false});
  }
  shown.push_back({"cracks", times, cracks, end * time.scale, std::max(1.0, top_cracks),
                   count_text(scene.point.cracks()), palette().tension, true});
  const double first_top = below + 84 * unit;
  const double gap = 96 * unit;
  const auto pieces = static_cast<double>(shown.size());
  const double height = (sheet.column_bottom - first_top - (pieces - 1) * gap) / pieces;
  double top = first_top;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Box box{sheet.column_left + 58 * unit, top, sheet.column_width - 78 * unit, height};
    draw_curve(sheet.page, unit, box, shown[i], i + 1 == shown.size() ? time.label() : "");
    top += height + gap;
  }
  sink(sheet.page);
}

}  // namespace hfrac::viz
