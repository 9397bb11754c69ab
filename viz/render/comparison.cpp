// SPDX-License-Identifier: BSD-3-Clause
// Reading the table of a comparison: rows with the same series and x are runs of different packings, so their
// mean is drawn, with their standard deviation as its spread.
#include "comparison.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <system_error>

#include "failure.h"
#include "quantity.h"

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

}  // namespace hfrac::viz
