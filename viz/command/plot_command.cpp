// SPDX-License-Identifier: BSD-3-Clause
// hfrac plot: the curves of a run, from its tables, or of several runs against each other.
#include <fmt/format.h>
#include <hfrac/hfrac.h>
#include <hfrac/viz.h>
#include <CLI/CLI.hpp>
#include <hfrac/definition.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command/commands.hpp"
#include "command/drawing.hpp"
#include "command/exit_code.hpp"
#include "command/injection_record.hpp"
#include "command/interrupt.hpp"
#include "command/kgd_plot.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"
#include "run/fields.hpp"
#include "run/files.hpp"
#include "run/json_file.hpp"
#include "run/table_file.hpp"
#include "run/text.hpp"

namespace hfrac::command {
namespace {

// `hfrac plot --compare`: a table out of several run folders, or one that is there, and its picture.

// What one run contributes to a comparison: options out of its case file, results out of its summary, history and
// fracture table.

/** A finished or running run. Reading throws BadInput with the file and what is wrong in it. */
class ComparedRun {
 public:
  explicit ComparedRun(std::filesystem::path folder);

  /** An option of the case by its key, "title" included, as text that a table holds. */
  std::string option(const std::string& key) const;

  /** A result at the end of the run by one of our names, or a number of summary.json by its path, "setup.coordination". */
  double result(const std::string& name) const;

  /** A column of history.csv by one of our names or its own. */
  std::vector<double> course(const std::string& name) const;

 private:
  double initiation_pressure() const;

  std::filesystem::path folder_;
};

struct CompareRequest {
  std::vector<std::string> sources;     ///< run folders, or a single .csv file; empty: nothing to compare
  std::string x;                        ///< key of an option, or "step" or "time": the course of the runs
  std::vector<std::string> quantities;  ///< up to 6
  std::string series;                   ///< key of an option; empty: one series
  std::string target = "comparison.png";
  std::string title;
};

using json = nlohmann::ordered_json;

/** A name for `--y`: where it stands in summary.json and in history.csv; empty: not there. */
struct Name {
  std::string_view name;
  std::string_view path;    ///< in summary.json; "*" in it: the largest of all fractures
  std::string_view course;  ///< column of history.csv
  std::string_view column;  ///< in the table of the comparison
};

constexpr std::array<Name, 15> quantity_names = {{
    {"cracks", "state.crack_count", "crack_count", "crack_count"},
    {"tensile-cracks", "state.tensile_cracks", "tensile_cracks", "tensile_cracks"},
    {"shear-cracks", "state.shear_cracks", "shear_cracks", "shear_cracks"},
    {"length", "longest_fracture.length_m", "fracture_length_m", "fracture_length_m"},
    {"width", "longest_fracture.width_m", "fracture_width_m", "largest_fracture_width_m"},
    {"extent", "fractures.*.extent_m", "", "fracture_extent_m"},
    {"reach", "fractures.*.reach_m", "", "fracture_reach_m"},
    {"wings", "fractures.*.wings", "", "fracture_wings"},
    {"volume", "fracture_volume_m2", "fracture_volume_m2", "fracture_volume_m2"},
    {"injected", "balance.injected_volume_m2", "injected_volume_m2", "injected_volume_m2"},
    {"leak-off", "balance.leaked_volume_m2", "leaked_volume_m2", "leaked_volume_m2"},
    {"tip", "state.tip_distance_m", "tip_distance_m", "tip_distance_m"},
    {"pressure", "wells.0.pressure_Pa", "well_pressure_Pa", "well_pressure_Pa"},
    {"rate", "wells.0.rate_m2_per_s", "well_rate_m2_per_s", "well_rate_m2_per_s"},
    {"initiation-pressure", "", "", "initiation_pressure_Pa"},
}};

/** What can be asked for with `--y`, one line per name. */
std::string quantity_help() {
  std::string text;
  for (const Name& one : quantity_names) {
    const std::string where = one.path.empty()
                                  ? "well pressure at the first crack after the initial equilibration"
                                  : std::string(one.path);
    text += fmt::format("  {:20} {}{}\n", one.name, where, one.course.empty() ? "" : "; also over time");
  }
  return text + "  or any number of summary.json by its path, any column of history.csv over time\n";
}

const Name* find_name(const std::string& wanted) {
  const auto* found = std::find_if(quantity_names.begin(), quantity_names.end(),
                                   [&](const Name& one) { return one.name == wanted; });
  return found != quantity_names.end() ? found : nullptr;
}

[[noreturn]] void refuse_name(const std::string& name, const std::filesystem::path& file) {
  throw BadInput(
      fmt::format("'{}' is no number in '{}'; the names are\n{}", name, file.string(), quantity_help()));
}

/** The number at a path; "*" in it: the largest of all items of a list. NaN if there is none. */
double number_at(const json& summary, std::string_view path) {
  const size_t star = path.find(".*.");
  if (star == std::string_view::npos) return run::number_at(summary, path);
  const json* list = run::member(summary, path.substr(0, star));
  if (list == nullptr || !list->is_array()) return std::nan("");
  double largest = 0.0;  // no fracture: nothing long, nothing wide
  for (const json& one : *list) {
    const double value = run::number_at(one, path.substr(star + 3));
    if (std::isnan(value)) return value;
    largest = std::max(largest, value);
  }
  return largest;
}

/** What `read` gives of a run's file; damage is BadInput. */
template <class Read>
auto of_run(const std::filesystem::path& folder, const char* name, const Read& read) {
  const auto file = folder / name;
  if (!run::is_file(file))
    throw BadInput(fmt::format("'{}' is not a run folder: it has no {}", folder.string(), name));
  try {
    return read(file);
  } catch (const run::ReadError& error) {
    throw BadInput(error.what());
  }
}

json summary_of(const std::filesystem::path& folder) {
  return of_run(folder, "summary.json", [](const auto& file) { return run::read_json(file); });
}

/** A column of history.csv; empty if there is none of that name. */
std::vector<double> history_column(const std::filesystem::path& folder, std::string_view column) {
  return of_run(folder, "history.csv", [&](const auto& file) {
    const run::TableFile table(file);
    return table.has(column) ? table.numbers(column) : std::vector<double>();
  });
}

ComparedRun::ComparedRun(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::string ComparedRun::option(const std::string& key) const {
  const std::string file = (folder_ / "case.toml").string();
  Definition definition;
  if (hfrac_sim_def_load(&definition, file.c_str()) < 0) throw BadInput(run::error_text(-1, nullptr));
  if (key == "title") {
    std::string title = run::printable(definition.title);
    std::replace(title.begin(), title.end(), ',', ';');  // the table has no quotes
    return title;
  }
  double value = 0.0;
  if (const int32_t status = hfrac_sim_def_get_f64(&definition, key.c_str(), &value); status < 0)
    throw BadInput(run::error_text(status, nullptr));
  return fmt::format("{}", value);
}

double ComparedRun::result(const std::string& name) const {
  if (name == "initiation-pressure") return initiation_pressure();
  const Name* known = find_name(name);
  const double value =
      number_at(summary_of(folder_), known != nullptr ? known->path : std::string_view(name));
  if (std::isnan(value)) refuse_name(name, folder_ / "summary.json");
  return value;
}

std::vector<double> ComparedRun::course(const std::string& name) const {
  const Name* known = find_name(name);
  auto values = history_column(folder_, known != nullptr ? known->course : std::string_view(name));
  if (values.empty()) refuse_name(name, folder_ / "history.csv");
  return values;
}

/** Pressure in the first well in the step whose cracks are the first ones; NaN if none came. */
double ComparedRun::initiation_pressure() const {
  const auto cracks = history_column(folder_, "crack_count");
  const auto pressure = history_column(folder_, "well_pressure_Pa");
  for (size_t i = 1; i < cracks.size() && i < pressure.size(); ++i)
    if (cracks[i] > cracks[0]) return pressure[i];
  return std::nan("");
}

/** Column of the table for an option: its key with its unit, "bond.tensile_strength_Pa". */
std::string option_column(const std::string& key) {
  if (key == "title") return key;
  int32_t count = 0;
  run::require(hfrac_option_count(&count), nullptr);
  // Keys of wells are not in the table of options; their units are those of hfrac_well_def.
  static constexpr std::array<std::array<std::string_view, 2>, 6> well_units = {{{"].x", "m"},
                                                                                 {"].y", "m"},
                                                                                 {"].radius", "m"},
                                                                                 {"].pressure", "Pa"},
                                                                                 {"].ramp_per_step", "Pa"},
                                                                                 {"].rate", "m2/s"}}};
  for (const auto& [end, unit] : well_units)
    if (key.starts_with("well[") && key.ends_with(end)) return key + run::unit_ending(unit);
  for (int32_t i = 0; i < count; ++i) {
    auto option = run::sized<hfrac_option_info>();
    run::require(hfrac_option_at(i, &option), nullptr);
    if (key == option.key) return key + run::unit_ending(option.unit);
  }
  return key;
}

/** Column of the table for a result or, `over_time`, for a course. */
std::string result_column(const std::string& name, bool over_time) {
  const Name* known = find_name(name);
  if (known == nullptr) return over_time ? name : name.substr(name.rfind('.') + 1);
  return std::string(known->column);
}

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

/** Draws the picture, and writes the table beside it if it was made from runs. Throws BadInput or std::runtime_error. */
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
  auto options = options_for(paper, hfrac_viz_comparison_options_init);
  options.title = request.title.empty() ? nullptr : request.title.c_str();
  drawing_stopped(hfrac_viz_render_comparison(table.c_str(), request.target.c_str(), &options));
}

struct PlotRequest {
  std::string folder;
  Paper paper;
  bool quiet = false;
  bool kgd = false;     ///< the profile beside the plane-strain solution
  std::string record;   ///< of a field, beside the run
  double offset = 0.0;  ///< Pa, of the record
  CompareRequest compare;
};

ExitCode compare(const PlotRequest& request) {
  if (request.paper.svg || request.paper.pdf)
    throw BadInput("with --compare the ending of --output says which kind of file");
  draw_comparison(request.compare, request.paper);
  if (!request.quiet) fmt::print("{}\n", request.compare.target);
  return kGood;
}

/** A table and its picture in the run's folder of pictures: NAME.csv, NAME.png and what else is asked for. */
void draw_beside(const PlotRequest& request, const std::string& name, const std::string& title,
                 const std::string& table, bool svg) {
  const fs::path folder = fs::path(request.folder) / "pictures";
  run::make_folder(folder);
  CompareRequest drawn;
  drawn.sources = {(folder / (name + ".csv")).string()};
  drawn.title = title;
  run::write_whole(drawn.sources.front(), table);
  for (const auto& [wanted, ending] : {std::pair{true, ".png"}, {svg, ".svg"}, {request.paper.pdf, ".pdf"}}) {
    if (!wanted) continue;
    drawn.target = (folder / name).string() + ending;
    draw_comparison(drawn, request.paper);
    if (!request.quiet) fmt::print("{}\n", drawn.target);
  }
}

ExitCode plot_kgd(const PlotRequest& request) {
  std::string table;
  try {
    table = kgd_table(request.folder);
  } catch (const run::ReadError& error) {
    throw BadInput(error.what());
  }
  draw_beside(request, "kgd", "Along the fracture, beside the plane-strain solution", table,
              request.paper.svg);
  return kGood;
}

/** A field's pressure beside that of the run's first well; how far apart they are is told. The report shows the SVG file. */
ExitCode plot_record(const PlotRequest& request) {
  const InjectionRecord computed = read_injection(request.folder, 1.0);
  InjectionRecord measured = read_injection(request.record, 1.0);
  for (double& pressure : measured.pressure) pressure += request.offset;
  const RecordComparison both = compare_records(measured, computed);
  if (both.rows == 0)
    throw BadInput(fmt::format("'{}' has no row between {:g} and {:g} s, the times of '{}'", request.record,
                               computed.time.front(), computed.time.back(), request.folder));
  draw_beside(request, "record", "Measured and computed pressure", both.table, true);
  if (!request.quiet)
    fmt::print("computed less measured: {:.3g} MPa in the mean, {:.3g} MPa rms, over {} rows of the record\n",
               1e-6 * both.mean, 1e-6 * both.rms, both.rows);
  return kGood;
}

ExitCode plot(const PlotRequest& request) {
  if (!request.compare.sources.empty()) return compare(request);
  if (request.folder.empty()) throw BadInput("plot needs a run folder, or --compare and several");
  if (request.kgd) return plot_kgd(request);
  if (!request.record.empty()) return plot_record(request);
  const auto options = options_for(request.paper, hfrac_viz_chart_options_init);
  catch_interrupts();
  ProgressLine line(request.quiet);
  const int32_t status = hfrac_viz_render_charts(request.folder.c_str(), &options, show_drawing, &line);
  line.end();
  if (drawing_stopped(status)) {
    tell("hfrac: interrupted; the charts finished so far stay\n");
    return kInterrupted;
  }
  if (!request.quiet) fmt::print("charts are in {}/pictures\n", request.folder);
  return kGood;
}

}  // namespace

void add_plot(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("plot", "Draw the curves of a run into DIR/pictures, or compare runs");
  auto request = std::make_shared<PlotRequest>();
  auto* folder = command->add_option("DIR", request->folder, "Run folder");
  add_paper_options(*command, request->paper);
  add_format_options(*command, request->paper);
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command
      ->add_flag("--kgd", request->kgd,
                 "Only the profile along the fracture while it is driven, beside the "
                 "plane-strain solution of the same volume (KGD)")
      ->needs(folder);
  auto* record =
      command
          ->add_option(
              "--record", request->record,
              "Only the pressure of a field's record (CSV or LAS file) beside the run's, and how far "
              "apart they are")
          ->needs(folder);
  command
      ->add_option(
          "--record-offset", request->offset,
          "Added to the record's pressures [Pa]: the formation's, where they count from the well at rest, or "
          "the weight of the fluid's column, where they were read at the wellhead")
      ->needs(record);
  add_compare_options(*command, request->compare, folder);
  command->callback([request, &action] { action = [request] { return plot(*request); }; });
}

}  // namespace hfrac::command
