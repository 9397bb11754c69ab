// SPDX-License-Identifier: BSD-3-Clause
#include "command/compare.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "command/drawing.hpp"
#include "command/run_quantities.hpp"
#include "run/files.hpp"

namespace hfrac::command {
namespace {

namespace fs = std::filesystem;

constexpr size_t most_rows_per_run = 400;  ///< of a course: more cannot be told apart on paper

/** One run against its step or time. */
void add_course(const ComparedRun& run, const CompareRequest& request, const std::string& series,
                std::string& table) {
  const auto x = run.course(request.x == "time" ? "time_s" : "step");
  std::vector<std::vector<double>> columns;
  for (const auto& name : request.quantities) columns.push_back(run.course(name));
  const size_t stride = std::max<size_t>(1, (x.size() + most_rows_per_run - 1) / most_rows_per_run);
  for (size_t i = 0; i < x.size(); ++i) {
    if (i % stride != 0 && i + 1 != x.size()) continue;
    auto out = std::back_inserter(table);
    fmt::format_to(out, "{},{}", series, x[i]);
    for (const auto& column : columns) fmt::format_to(out, ",{}", column.at(i));
    table += '\n';
  }
}

/** One run as one point. A quantity it does not have (no crack: no initiation) is an empty cell. */
void add_end(const ComparedRun& run, const CompareRequest& request, const std::string& series,
             std::string& table) {
  table += series + "," + run.option(request.x);
  for (const auto& name : request.quantities) {
    const double value = run.result(name);
    table += std::isnan(value) ? std::string(",") : fmt::format(",{}", value);
  }
  table += '\n';
}

std::string table_of(const CompareRequest& request) {
  const bool over_time = request.x == "step" || request.x == "time";
  std::string table = request.series.empty() ? "series" : option_column(request.series);
  table += request.x == "step" ? ",step" : request.x == "time" ? ",time_s" : "," + option_column(request.x);
  for (const auto& name : request.quantities) table += "," + result_column(name, over_time);
  table += '\n';
  for (const auto& source : request.sources) {
    const ComparedRun run(source);
    const std::string series = request.series.empty() ? "" : run.option(request.series);
    over_time ? add_course(run, request, series, table) : add_end(run, request, series, table);
  }
  return table;
}

}  // namespace

void add_compare_options(CLI::App& command, CompareRequest& request, CLI::Option* folder) {
  auto* compare =
      command.add_option("--compare", request.sources,
                         "Several runs in one picture: their folders, or one CSV file with columns "
                         "series, x, quantities (units in the names)");
  compare->excludes(folder);
  const auto only_with_compare = [&](CLI::Option* option) { option->needs(compare); };
  only_with_compare(command.add_option(
      "--x", request.x, "Option on the x axis, e.g. well[0].pressure; or step, time: courses of the runs"));
  only_with_compare(
      command.add_option("--y", request.quantities, "Quantities, a panel each:\n" + quantity_help())
          ->delimiter(','));
  only_with_compare(command.add_option(
      "--series", request.series,
      "Option whose values make the curves, or title; runs equal in it and in x (packings) are averaged"));
  only_with_compare(command
                        .add_option("-o,--output", request.target,
                                    "Picture: .png, .svg or .pdf; the table goes beside it as .csv")
                        ->capture_default_str());
  only_with_compare(command.add_option("--title", request.title, "Heading of the picture"));
}

void draw_comparison(const CompareRequest& request, const Paper& paper) {
  fs::path table = request.sources.front();
  const bool made = table.extension() == ".csv";
  if (made && request.sources.size() > 1) throw BadInput("--compare takes one CSV file, or run folders");
  if (!made) {
    if (request.x.empty() || request.quantities.empty())
      throw BadInput("--compare of run folders needs --x and --y; the names for --y are\n" + quantity_help());
    const std::string content = table_of(request);
    table = fs::path(request.target).replace_extension(".csv");
    run::write_whole(table, content);
  }
  hfrac_viz_comparison_options options{};
  hfrac_viz_comparison_options_init(&options, sizeof options);
  if (paper.pixels() > 0) options.width = paper.pixels();
  options.dots_per_inch = paper.dots_per_inch();
  options.dark = paper.dark ? 1 : 0;
  options.title = request.title.empty() ? nullptr : request.title.c_str();
  drawing_stopped(hfrac_viz_render_comparison(table.c_str(), request.target.c_str(), &options));
}

}  // namespace hfrac::command
