// SPDX-License-Identifier: BSD-3-Clause
// What engineers plot of a run: pressures and rates, cracks, the fracture's size, volumes, energies; all
// against time.
#include <algorithm>
#include <array>
#include <cmath>

#include "charts.h"
#include "fitted_text.h"

namespace hfrac::viz {
namespace {

constexpr double joule_per_megajoule = 1e6;

// The unit of time that keeps the axis short.
struct TimeUnit {
  double seconds;
  const char* name;
};

TimeUnit unit_for(double longest) {
  static constexpr std::array<TimeUnit, 5> units = {
      {{2 * 86400.0, "d"}, {2 * 3600.0, "h"}, {600.0, "min"}, {0.1, "s"}, {0, "ms"}}};
  static constexpr std::array<double, 5> sizes = {86400.0, 3600.0, 60.0, 1.0, 1e-3};
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (longest >= units[i].seconds) return {sizes[i], units[i].name};
  }
  return {1.0, "s"};
}

// Fills panels with columns of the history.
class Plotter {
 public:
  explicit Plotter(const TableFile& history) : history_(history), time_(history.numbers("time_s")) {
    double longest = 0;
    for (const double time : time_) longest = std::isfinite(time) ? std::max(longest, time) : longest;
    const TimeUnit unit = unit_for(longest);
    for (double& time : time_) time /= unit.seconds;
    x_label_ = std::string("time (") + unit.name + ")";
  }

  Panel panel(const char* title) const { return {title, x_label_, {}, false, false}; }

  ChartSeries series(const char* column, const char* name, const char* unit, Colour colour,
                     double scale = 1.0) const {
    ChartSeries series{name, unit, colour, time_, history_.numbers(column)};
    for (double& value : series.y) value *= scale;
    return series;
  }

  std::vector<std::string> wells() const {
    std::vector<std::string> names = {"well"};
    for (int i = 1; history_.has("well_" + std::to_string(i) + "_pressure_Pa"); ++i) {
      names.push_back("well_" + std::to_string(i));
    }
    return names;
  }

 private:
  const TableFile& history_;
  std::vector<double> time_;
  std::string x_label_;
};

// Linear axes hide everything after a first surge; with one, tenfold steps show both.
bool surges(const std::vector<ChartSeries>& all) {
  std::vector<double> values;
  for (const ChartSeries& series : all) {
    for (const double value : series.y) {
      if (value < 0) return false;
      if (value > 0) values.push_back(value);
    }
  }
  if (values.size() < 3) return false;
  std::sort(values.begin(), values.end());
  return values.back() > 30 * values[values.size() / 2];
}

Colour well_colour(std::size_t index) {
  const std::array<Colour, 4> colours = {palette().well, palette().bond, palette().disc_rim, palette().shear};
  return colours[index % colours.size()];
}

Panel well_panel(const Plotter& plot, bool pressure, bool net) {
  Panel panel = plot.panel(pressure ? (net ? "Well pressure above the formation's" : "Well pressure")
                                    : "Injection rate");
  const std::vector<std::string> wells = plot.wells();
  for (std::size_t i = 0; i < wells.size(); ++i) {
    const std::string name = wells.size() > 1 ? "well " + std::to_string(i + 1) : "";
    const std::string column = wells[i] + (pressure ? "_pressure_Pa" : "_rate_m2_per_s");
    panel.series.push_back(plot.series(column.c_str(), name.c_str(), pressure ? "MPa" : "m\xC2\xB2/s",
                                       well_colour(i), pressure ? 1 / pascal_per_megapascal : 1.0));
  }
  panel.logarithmic = !pressure && surges(panel.series);
  return panel;
}

Panel crack_panel(const Plotter& plot) {
  Panel panel = plot.panel("Cracks");
  panel.whole_numbers = true;
  panel.series = {plot.series("tensile_cracks", "in tension", "", palette().tension),
                  plot.series("shear_cracks", "in shear", "", palette().shear)};
  for (ChartSeries& series : panel.series) series.stepped = true;
  return panel;
}

Panel fracture_panel(const Plotter& plot) {
  Panel panel = plot.panel("Longest fracture");
  panel.series = {
      plot.series("fracture_length_m", "length", "m", palette().tension),
      plot.series("fracture_width_m", "largest width", "mm", palette().pull, millimetres_per_metre)};
  panel.series.back().right = true;
  return panel;
}

Panel volume_panel(const Plotter& plot) {
  Panel panel = plot.panel("Fluid, per metre of thickness");
  panel.series = {plot.series("injected_volume_m2", "injected", "m\xC2\xB2", palette().water),
                  plot.series("fracture_volume_m2", "in fractures", "m\xC2\xB2", palette().tension),
                  plot.series("leaked_volume_m2", "leak-off", "m\xC2\xB2", palette().pull)};
  panel.series.back().right = true;
  return panel;
}

Panel energy_panel(const Plotter& plot) {
  Panel panel = plot.panel("Energy, per metre of thickness");
  const double scale = 1 / joule_per_megajoule;
  panel.series = {plot.series("fluid_work_J_per_m", "work of the fluid", "MJ/m", palette().water, scale),
                  plot.series("bond_elastic_J_per_m", "bonds", "MJ/m", palette().bond, scale),
                  plot.series("damping_J_per_m", "damped", "MJ/m", palette().frame, scale),
                  plot.series("fracture_J_per_m", "cracks", "MJ/m", palette().shear, scale)};
  return panel;
}

}  // namespace

void put_heading(ChartPage& page, const std::string& title, const std::string& second_line) {
  constexpr double room = ChartPage::width - 2 * 96;
  const TextStyle style = title_style(page, title, {32, palette().ink, true}, room);
  page.text(96, 56, fitted(page, title, style, room), style);
  const TextStyle faint{23, palette().faint_ink};
  page.text(96, 92, fitted(page, second_line, faint, room), faint);
}

void put_heading(ChartPage& page, const RunFolder& run, const std::string& what) {
  put_heading(page, run.title.empty() ? what : run.title, run.title.empty() ? "" : what);
}

void fill_history(ChartPage& page, const ChartData& data) {
  const Plotter plot(*data.history);
  put_heading(page, *data.run, "The run against time");
  const std::array<Panel, 6> panels = {well_panel(plot, true, data.run->net_pressures),
                                       well_panel(plot, false, false),
                                       crack_panel(plot),
                                       fracture_panel(plot),
                                       volume_panel(plot),
                                       energy_panel(plot)};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = i % 2 == 0 ? 120 : 926;
    const std::size_t row = i / 2;
    page.panel({left, 210 + 410 * static_cast<double>(row), 554, 256}, panels[i]);
  }
}

}  // namespace hfrac::viz
