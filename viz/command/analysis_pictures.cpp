// SPDX-License-Identifier: BSD-3-Clause
#include "command/analysis_pictures.hpp"

#include <fmt/format.h>
#include <hfrac/viz.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "command/exit_code.hpp"
#include "run/files.hpp"

namespace hfrac::command {
namespace {

constexpr std::size_t kMostPoints = 1500;  // of a curve: more cannot be told apart on paper

/** Every so manyth row. */
std::size_t stride_of(std::size_t rows) {
  return std::max<std::size_t>(1, rows / kMostPoints);
}

std::string record_table(const InjectionRecord& record) {
  const bool rated = !record.rate.empty();
  std::string text = rated ? "series,time_s,pressure_Pa,rate_m2_per_s\n" : "series,time_s,pressure_Pa\n";
  for (std::size_t k = 0; k < record.time.size(); k += stride_of(record.time.size())) {
    fmt::format_to(std::back_inserter(text), ",{},{}", record.time[k], record.pressure[k]);
    text += rated ? fmt::format(",{}\n", record.rate[k]) : "\n";
  }
  return text;
}

/** The pressure, and x dP/dx with the sign that rises while the pressure falls, as "series,x,pressure_Pa,..." */
std::string slope_table(const Analysis& analysis, const std::vector<double>& x, const Slopes& slopes,
                        const std::optional<Closure>& closure, const std::string& names, bool line) {
  std::string text = "series," + names + "\n";
  const auto add = [&](const char* series, double place, double pressure, double slope) {
    const auto cell = [](double value) {
      return std::isnan(value) ? std::string() : fmt::format("{}", value);
    };
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", series, place, cell(pressure), cell(slope));
  };
  for (std::size_t k = 0; k < x.size(); k += stride_of(x.size()))
    add("measured", x[k], analysis.falloff.pressure[k], NAN);
  for (std::size_t k = 0; k < slopes.x.size(); ++k)
    add("measured", slopes.x[k], NAN, slopes.x[k] * slopes.slope[k]);
  if (line && analysis.reading.line) {
    const StraightLine& straight = *analysis.reading.line;
    const double end = closure ? std::min(x.back(), 1.3 * closure->x) : x.back();
    for (int k = 0; k <= 50; ++k) {
      const double place = end * k / 50;
      add("straight line", place, straight.start + straight.slope * place, -straight.slope * place);
    }
  }
  if (closure) {
    const auto at = std::lower_bound(slopes.x.begin(), slopes.x.end(), closure->x);
    const double slope =
        at == slopes.x.end() ? NAN : slopes.slope[static_cast<std::size_t>(at - slopes.x.begin())];
    add("closure", closure->x, closure->pressure, closure->x * slope);
  }
  return text;
}

}  // namespace

std::vector<std::string> draw_analysis(const Analysis& analysis, const InjectionRecord& record,
                                       const std::filesystem::path& picture, const Paper& paper) {
  const std::string ending = picture.extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw BadInput(fmt::format("--picture {}: pictures are .png, .svg or .pdf", picture.string()));
  std::vector<std::string> files;
  const auto draw = [&](const char* what, const std::string& table, const char* title, const char* x_label) {
    auto name = picture;
    name.replace_filename(picture.stem().string() + what);
    const std::string file = name.string() + ending, numbers = name.string() + ".csv";
    run::write_whole(numbers, table);
    auto options = options_for(paper, hfrac_viz_comparison_options_init);
    options.title = title;
    options.x_label = x_label;
    drawing_stopped(hfrac_viz_render_comparison(numbers.c_str(), file.c_str(), &options));
    files.push_back(file);
  };
  draw("-record", record_table(record), "Injection and fall-off", nullptr);
  const FalloffReading& reading = analysis.reading;
  if (reading.over_g.x.empty()) return files;
  std::vector<double> root;
  for (const double since : analysis.falloff.since) root.push_back(std::sqrt(since));
  draw(
      "-g",
      slope_table(analysis, analysis.g, reading.over_g, reading.by_g, "G,pressure_Pa,minus_G_dP/dG_Pa", true),
      "Fall-off over Nolte's G", "G");
  draw("-root",
       slope_table(analysis, root, reading.over_root, reading.by_root,
                   "root,pressure_Pa,minus_root_of_time_dP/d(root)_Pa", false),
       "Fall-off over the square root of time", "square root of the time since shut-in [s^0.5]");
  return files;
}

}  // namespace hfrac::command
