// SPDX-License-Identifier: BSD-3-Clause
// Reading the table of a comparison: rows with the same series and x are runs of different packings, so their
// mean is drawn, with their standard deviation as its spread.
#include "comparison.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <system_error>

#include "charts.h"
#include "failure.h"
#include "number_text.h"
#include "run/text.hpp"

namespace hfrac::viz {

namespace {

constexpr std::size_t most_panels = 6;
constexpr std::size_t most_series = 12;
constexpr std::string_view spread_ending = "_spread";

bool as_number(const std::string& text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

void finish(ComparedPoint& point, const std::vector<double>& given) {
  double sum = 0;
  for (const double value : point.values) sum += value;
  const auto count = static_cast<double>(point.values.size());
  point.mean = sum / count;
  point.spread = std::nan("");
  double squares = 0;
  for (const double value : point.values) squares += (value - point.mean) * (value - point.mean);
  if (point.values.size() > 1) point.spread = std::sqrt(squares / (count - 1));
  if (given.empty()) return;
  double largest = 0;
  for (const double one : given) largest = std::max(largest, one);
  point.spread = largest;
}

ComparedPanel panel_of(const TableFile& table, const std::string& column) {
  const std::vector<std::string>& names = table.names();
  const std::vector<std::string> series = table.words(names[0]);
  const std::vector<double> x = table.numbers(names[1]);
  const std::vector<double> y = table.numbers(column);
  const std::string spread_column = column + std::string(spread_ending);
  const std::vector<double> spread =
      table.has(spread_column) ? table.numbers(spread_column) : std::vector<double>(table.rows(), NAN);
  struct Cell {
    ComparedPoint point;
    std::vector<double> given;
  };
  std::vector<std::string> order;
  std::map<std::string, std::map<double, Cell>> cells;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    if (cells.count(series[i]) == 0) order.push_back(series[i]);
    Cell& cell = cells[series[i]][x[i]];
    cell.point.x = x[i];
    cell.point.values.push_back(y[i]);
    if (std::isfinite(spread[i])) cell.given.push_back(std::fabs(spread[i]));
  }
  ComparedPanel panel{column, {}};
  for (const std::string& name : order) {
    ComparedSeries one{name, static_cast<double>(panel.series.size()), false, {}};
    double value = 0;
    if (as_number(name, value)) {
      one.order = value;
      one.number = true;
      one.name = quantity_text(names[0], value);
    }
    for (auto& [place, cell] : cells[name]) {
      finish(cell.point, cell.given);
      one.points.push_back(std::move(cell.point));
    }
    panel.series.push_back(std::move(one));
  }
  const bool numbers = std::all_of(panel.series.begin(), panel.series.end(),
                                   [](const ComparedSeries& one) { return one.number; });
  if (numbers) {
    std::stable_sort(panel.series.begin(), panel.series.end(),
                     [](const ComparedSeries& a, const ComparedSeries& b) { return a.order < b.order; });
  }
  return panel;
}

}  // namespace

Comparison read_comparison(const std::filesystem::path& path) {
  const TableFile table(path);
  const std::vector<std::string>& names = table.names();
  if (names.size() < 3) {
    fail_reading(path.string() + " needs three columns at least: series, x and a quantity; it has " +
                 std::to_string(names.size()));
  }
  Comparison comparison;
  comparison.series_label = quantity_of(names[0], 0).name;
  comparison.x_column = names[1];
  for (std::size_t i = 2; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (name.ends_with(spread_ending) && table.has(name.substr(0, name.size() - spread_ending.size()))) {
      comparison.given_spread = true;
      continue;
    }
    comparison.panels.push_back(panel_of(table, name));
    const ComparedPanel& panel = comparison.panels.back();
    if (panel.series.empty()) {
      fail_reading(path.string() + " has no line with numbers in '" + names[1] + "' and '" + name + "'");
    }
    if (panel.series.size() > most_series) {
      fail_reading(path.string() + " has " + std::to_string(panel.series.size()) +
                   " series; more than 12 cannot be told apart");
    }
    for (const ComparedSeries& series : panel.series) {
      for (const ComparedPoint& point : series.points) {
        comparison.most_runs = std::max(comparison.most_runs, static_cast<int>(point.values.size()));
      }
    }
  }
  if (comparison.panels.size() > most_panels) {
    fail_reading(path.string() + " has " + std::to_string(comparison.panels.size()) +
                 " quantities; a page holds 6");
  }
  return comparison;
}

// The page of a comparison: a legend in rows under the heading, then a panel per quantity. Few points become dots
// with error bars over the single runs, long curves a line in its band.

namespace {

constexpr double legend_top = 136;
constexpr double legend_row = 36;
constexpr double legend_left = 130;
constexpr double legend_right = 1560;
constexpr double panel_room = 150;      // of a panel's box: title above it, labels below
constexpr std::size_t most_marks = 40;  // points of a series that are drawn one by one
constexpr double letter_width = 0.62;   // of the em, for the size of the legend before there is a page

struct Grid {
  int columns;
  int rows;
  double box_width;
  double box_height;
};

Grid grid_of(std::size_t panels) {
  if (panels == 1) return {1, 1, 1420, 620};
  return {2, static_cast<int>((panels + 1) / 2), 590, 440};
}

struct LegendItem {
  std::string name;
  Colour colour;
  double width;
};

double estimated(const std::string& name) {
  return 44 + letter_width * 20 * static_cast<double>(name.size()) + 26;
}

// Where numbers order the series their colours do too; otherwise colours that stay apart for every eye (Okabe and
// Ito 2008).
Colour series_colour(std::size_t index, std::size_t count, bool ordered) {
  if (ordered && count > 3) {
    const double share = static_cast<double>(index) / static_cast<double>(count - 1);
    return series_map().at(share);
  }
  return categorical(index);
}

bool ordered(const ComparedPanel& panel) {
  return std::all_of(panel.series.begin(), panel.series.end(),
                     [](const ComparedSeries& s) { return s.number; });
}

std::vector<LegendItem> legend_of(const Comparison& comparison) {
  const ComparedPanel& panel = comparison.panels.front();
  std::vector<LegendItem> items;
  if (panel.series.size() == 1 && panel.series.front().name.empty()) return items;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const std::string& name = panel.series[i].name;
    items.push_back({name, series_colour(i, panel.series.size(), ordered(panel)), estimated(name)});
  }
  return items;
}

// Rows of the legend, its heading first.
int legend_rows(const Comparison& comparison) {
  const std::vector<LegendItem> items = legend_of(comparison);
  if (items.empty()) return 0;
  int rows = 1;
  double x = legend_left + estimated(comparison.series_label);
  for (const LegendItem& item : items) {
    if (x + item.width > legend_right) {
      ++rows;
      x = legend_left;
    }
    x += item.width;
  }
  return rows;
}

double panels_top(const Comparison& comparison) {
  return legend_top + legend_rows(comparison) * legend_row + 76;
}

void put_legend(ChartPage& page, const Comparison& comparison) {
  const std::vector<LegendItem> items = legend_of(comparison);
  if (items.empty()) return;
  double x = legend_left;
  double y = legend_top + 10;
  page.text(x, y, comparison.series_label, {20, palette().faint_ink});
  x += page.text_width(comparison.series_label, {20, palette().faint_ink}) + 30;
  for (const LegendItem& item : items) {
    if (x + item.width > legend_right) {
      x = legend_left;
      y += legend_row;
    }
    page.line({{x, y - 8}, {x + 32, y - 8}}, 4, item.colour);
    page.dot({x + 16, y - 8}, 7, item.colour);
    page.text(x + 42, y, item.name, {20, palette().ink});
    x += item.width;
  }
}

double largest_x(const ComparedPanel& panel) {
  double largest = 0;
  for (const ComparedSeries& series : panel.series) {
    for (const ComparedPoint& point : series.points) largest = std::max(largest, std::fabs(point.x));
  }
  return largest;
}

double largest_y(const ComparedPanel& panel) {
  double largest = 0;
  for (const ComparedSeries& series : panel.series) {
    for (const ComparedPoint& point : series.points) {
      for (const double value : point.values) largest = std::max(largest, std::fabs(value));
    }
  }
  return largest;
}

void add_series(Panel& panel, const ComparedSeries& series, Colour colour, double x_scale, double y_scale,
                bool stepped) {
  const bool marks = series.points.size() <= most_marks;
  ChartSeries runs{"", "", mixed(colour, palette().paper, 0.62), {}, {}};
  runs.dots = true;
  runs.dot_radius = 4;
  ChartSeries line{"", "", colour, {}, {}};
  line.banded = !marks;
  line.stepped = stepped;
  for (const ComparedPoint& point : series.points) {
    line.x.push_back(point.x * x_scale);
    line.y.push_back(point.mean * y_scale);
    line.spread.push_back(point.spread * y_scale);
    if (!marks || point.values.size() < 2) continue;
    for (const double value : point.values) {
      runs.x.push_back(point.x * x_scale);
      runs.y.push_back(value * y_scale);
    }
  }
  ChartSeries means = line;
  means.dots = true;
  means.stepped = false;
  means.dot_radius = 7;
  means.spread.clear();
  if (!runs.x.empty()) panel.series.push_back(std::move(runs));
  panel.series.push_back(std::move(line));
  if (marks) panel.series.push_back(std::move(means));
}

bool has_marks(const Comparison& comparison) {
  for (const ComparedPanel& panel : comparison.panels) {
    for (const ComparedSeries& series : panel.series) {
      if (series.points.size() <= most_marks) return true;
    }
  }
  return false;
}

std::string how_drawn(const Comparison& comparison) {
  if (comparison.given_spread) return "Bars and bands: the spread given in the table.";
  if (comparison.most_runs < 2) return "";
  const std::string means = "Means of up to " + std::to_string(comparison.most_runs) + " runs; ";
  return means + (has_marks(comparison) ? "bars: their standard deviation; faint dots: single runs."
                                        : "bands: their standard deviation.");
}

double comparison_height(const Comparison& comparison) {
  const Grid grid = grid_of(comparison.panels.size());
  return panels_top(comparison) + grid.rows * (grid.box_height + panel_room) + 10;
}

void fill_comparison(ChartPage& page, const Comparison& comparison, const std::string& title,
                     const std::string& x_label) {
  put_heading(page, title, how_drawn(comparison));
  put_legend(page, comparison);
  const Grid grid = grid_of(comparison.panels.size());
  const double top = panels_top(comparison);
  // A count stays what it is until the next crack.
  const bool over_time = comparison.x_column == "step" || comparison.x_column == "time_s";
  for (std::size_t i = 0; i < comparison.panels.size(); ++i) {
    const ComparedPanel& compared = comparison.panels[i];
    const Quantity x = quantity_of(comparison.x_column, largest_x(compared));
    const Quantity y = quantity_of(compared.column, largest_y(compared));
    Panel panel;
    const std::string letter =
        comparison.panels.size() > 1 ? std::string("(") + static_cast<char>('a' + i) + ") " : "";
    std::string name = y.name;
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    panel.title = letter + name;
    panel.unit = y.unit;
    panel.x_label = x_label.empty() ? x.label() : x_label;
    panel.whole_numbers = compared.column.ends_with("crack_count") || compared.column.ends_with("cracks");
    for (std::size_t k = 0; k < compared.series.size(); ++k) {
      add_series(panel, compared.series[k], series_colour(k, compared.series.size(), ordered(compared)),
                 x.scale, y.scale, panel.whole_numbers && over_time);
    }
    const double left = i % 2 == 0 || grid.columns == 1 ? 130 : 960;
    const int row = static_cast<int>(i) / grid.columns;
    page.panel({left, top + row * (grid.box_height + panel_room), grid.box_width, grid.box_height}, panel);
  }
}

std::string printable_or(const char* text, const char* otherwise) {
  return text != nullptr && text[0] != 0 ? printable(text) : otherwise;
}

}  // namespace

void render_comparison(const std::filesystem::path& table, const std::filesystem::path& target,
                       const hfrac_viz_comparison_options& options) {
  const Comparison comparison = read_comparison(table);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  const std::string title = printable_or(options.title, "Runs compared");
  const std::string x_label = printable_or(options.x_label, "");
  const PageContent content{title, comparison_height(comparison),
                            [&](ChartPage& page) { fill_comparison(page, comparison, title, x_label); }};
  write_page(target, content, window, {options.width, options.dots_per_inch});
}

}  // namespace hfrac::viz
