// SPDX-License-Identifier: BSD-3-Clause
// hfrac lab: standard rock tests on specimens of a case's rock.
#include <fmt/format.h>
#include <hfrac/hfrac.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/drawing.hpp"
#endif
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include <hfrac/viz.h>
#endif

namespace hfrac::command {
namespace {

// A tested specimen as a picture: discs where they came to rest, cracks by mode, as an SVG file.

/** `discs` and `cracks` as hfrac_lab_copy_f64 gives them (5 values a row); `title` stands above. */
std::string specimen_svg(const std::vector<double>& discs, const std::vector<double>& cracks,
                         const std::string& title);

constexpr double page = 900.0, margin = 20.0,
                 heading = 40.0;  // pixels: the longer side of the specimen, around, above
constexpr const char* tension = "#c1272d";
constexpr const char* shear = "#1b5fa8";

std::string plain(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

std::string specimen_svg(const std::vector<double>& discs, const std::vector<double>& cracks,
                         const std::string& title) {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  for (std::size_t k = 0; k + 5 <= discs.size(); k += 5) {
    left = std::min(left, discs[k] - discs[k + 2]);
    right = std::max(right, discs[k] + discs[k + 2]);
    low = std::min(low, discs[k + 1] - discs[k + 2]);
    high = std::max(high, discs[k + 1] + discs[k + 2]);
  }
  const double scale = page / std::max(right - left, high - low);
  const auto x = [&](double at) { return margin + scale * (at - left); };
  const auto y = [&](double at) { return heading + scale * (high - at); };
  std::string svg;
  auto out = std::back_inserter(svg);
  const double width = std::max(2.0 * margin + scale * (right - left), 520.0);
  const double height = heading + margin + scale * (high - low);
  fmt::format_to(
      out,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{:.0f}\" y=\"24\">{}; cracks in <tspan fill=\"{}\">tension</tspan>, <tspan "
      "fill=\"{}\">shear</tspan></text>\n<g fill=\"#e8e2d4\" stroke=\"#9d9585\" stroke-width=\"0.4\">\n",
      width, height, margin, plain(title), tension, shear);
  for (std::size_t k = 0; k + 5 <= discs.size(); k += 5)
    fmt::format_to(out, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>\n", x(discs[k] + discs[k + 3]),
                   y(discs[k + 1] + discs[k + 4]), scale * discs[k + 2]);
  svg += "</g>\n<g stroke-width=\"2\" stroke-linecap=\"round\">\n";
  for (std::size_t k = 0; k + 5 <= cracks.size(); k += 5)
    fmt::format_to(out, "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n",
                   x(cracks[k]), y(cracks[k + 1]), x(cracks[k + 2]), y(cracks[k + 3]),
                   static_cast<int>(cracks[k + 4]) == HFRAC_CRACK_TENSION ? tension : shear);
  svg += "</g>\n</svg>\n";
  return svg;
}

struct TestName {
  const char *word, *value, *unit;
  double scale;  // of the unit, per SI unit
};
/** In the order of enum hfrac_lab_test. */
constexpr std::array<TestName, 9> tests = {{{"elastic", "E (plane strain)", "GPa", 1e-9},
                                            {"tension", "tensile strength", "MPa", 1e-6},
                                            {"uniaxial", "UCS", "MPa", 1e-6},
                                            {"biaxial", "axial strength", "MPa", 1e-6},
                                            {"brazilian", "Brazilian strength", "MPa", 1e-6},
                                            {"centre-crack", "K_Ic", "MPa m^0.5", 1e-6},
                                            {"sent", "K_Ic", "MPa m^0.5", 1e-6},
                                            {"pressurised-crack", "K_Ic", "MPa m^0.5", 1e-6},
                                            {"permeability", "permeability", "mD", 1.0 / 9.869233e-16}}};
constexpr const char* ends[] = {"failed", "load reached", "no equilibrium found beyond this", "interrupted"};

struct LabRequest {
  std::string test, case_file, folder;
  hfrac_lab_spec spec{};
  int64_t packings = 1;
  bool time = false, quiet = false;
};

struct Destroy {
  void operator()(hfrac_lab* lab) const { hfrac_lab_destroy(&lab); }
};
using Lab = std::unique_ptr<hfrac_lab, Destroy>;

std::vector<double> table(const hfrac_lab* lab, int32_t which) {
  int64_t count = 0;
  run::require(hfrac_lab_copy_f64(lab, which, nullptr, 0, &count), nullptr);
  std::vector<double> values(static_cast<std::size_t>(count));
  run::require(hfrac_lab_copy_f64(lab, which, values.data(), count, &count), nullptr);
  return values;
}

std::string describe(const hfrac_lab_report& r, int32_t test, int64_t seed, bool time) {
  const TestName& name = tests[static_cast<std::size_t>(test)];
  std::string text =
      fmt::format("  seed {:<3} {} {:.4g} {}", seed, name.value, r.value * name.scale, name.unit);
  auto out = std::back_inserter(text);
  if (r.plane_modulus > 0.0)
    fmt::format_to(out, ", nu {:.3f} (slopes E' {:.4g} GPa, nu' {:.3f})", r.poisson, r.plane_modulus * 1e-9,
                   r.plane_poisson);
  if (r.peak_stress > 0.0)
    fmt::format_to(out, ", first crack at {:.4g} of {:.4g} MPa", r.first_crack_stress * 1e-6,
                   r.peak_stress * 1e-6);
  if (r.toughness_coefficient > 0.0)
    fmt::format_to(out, ", {:.3f} sigma_c sqrt(R), a {:.4g} m, F {:.3f}", r.toughness_coefficient,
                   r.slit_half_length, r.geometry_factor);
  if (r.zero_stress_aperture > 0.0)
    fmt::format_to(out, ", along x {:.4g}, along y {:.4g} mD, r0 {:.3g} um", r.permeability_x * name.scale,
                   r.permeability_y * name.scale, r.zero_stress_aperture * 1e6);
  fmt::format_to(out, "\n           {}; {} discs, R {:.4g} m, cracks {} tensile {} shear, force ratio {:.0e}",
                 ends[r.end], r.disc_count, r.mean_radius, r.tensile_cracks, r.shear_cracks, r.force_ratio);
  if (time)
    fmt::format_to(out, "\n           packing {:.2f} s, test {:.2f} s, {} sparse factors", r.packing_seconds,
                   r.test_seconds, r.factor_count);
  return text + "\n";
}

/** Mean and standard deviation of a sample. */
std::pair<double, double> mean_and_spread(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / n;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / (n - 1.0))};
}

void write_files(const std::filesystem::path& folder, const hfrac_lab* lab, const std::string& test,
                 int64_t seed, std::string& chart) {
  std::filesystem::create_directories(folder);
  const auto curve = table(lab, HFRAC_LAB_CURVE), opening = table(lab, HFRAC_LAB_OPENING),
             discs = table(lab, HFRAC_LAB_DISCS);
  if (!curve.empty()) {
    std::string text =
        "load,stress_Pa,axial_strain,lateral_strain,stress_over_strength,tensile_cracks,shear_cracks\n";
    double last = -1.0;
    for (std::size_t k = 0; k + 7 <= curve.size(); k += 7) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{:.0f},{:.0f}\n", curve[k], curve[k + 1],
                     curve[k + 2], curve[k + 3], curve[k + 4], curve[k + 5], curve[k + 6]);
      // A chart has one point for each load: the one before breakage.
      if (curve[k] == last) continue;
      last = curve[k];
      fmt::format_to(std::back_inserter(chart), "packing {},{},{},{:.0f}\n", seed, std::abs(curve[k + 2]),
                     curve[k + 1] * 1e-6, curve[k + 5] + curve[k + 6]);
    }
    run::write_whole(folder / fmt::format("{}_{}.csv", test, seed), text);
  }
  if (!opening.empty()) {
    std::string text = "x_m,opening_m,pressure_Pa\n";
    for (std::size_t k = 0; k + 3 <= opening.size(); k += 3)
      fmt::format_to(std::back_inserter(text), "{},{},{}\n", opening[k], opening[k + 1], opening[k + 2]);
    run::write_whole(folder / fmt::format("{}_opening_{}.csv", test, seed), text);
  }
  if (!discs.empty())
    run::write_whole(
        folder / fmt::format("{}_{}.svg", test, seed),
        specimen_svg(discs, table(lab, HFRAC_LAB_CRACKS), fmt::format("{}, packing {}", test, seed)));
}

void draw_curves(const std::filesystem::path& folder, const std::string& test, const std::string& chart) {
  const auto file = folder / fmt::format("{}_curves.csv", test);
  run::write_whole(file, "packing,size of the axial strain (1),stress (MPa),broken bonds (1)\n" + chart);
#ifdef HFRAC_WITH_RENDERER
  hfrac_viz_comparison_options options{};
  hfrac_viz_comparison_options_init(&options, sizeof options);
  const std::string title = fmt::format("hfrac lab {}", test);
  options.title = title.c_str();
  const auto picture = folder / fmt::format("{}_curves.png", test);
  drawing_stopped(hfrac_viz_render_comparison(file.c_str(), picture.c_str(), &options));
#endif
}

ExitCode lab(LabRequest request) {
  Definition definition;
  if (!request.case_file.empty()) definition = load_case(request.case_file, 0);
  for (std::size_t k = 0; k < tests.size(); ++k) {
    if (request.test == tests[k].word) request.spec.test = static_cast<int32_t>(k);
  }
  const TestName& name = tests[static_cast<std::size_t>(request.spec.test)];
  catch_interrupts();
  std::vector<double> values, ratios;  // the value of the test and nu, one of each packing
  std::string chart;
  const int64_t first = request.spec.seed;
  ProgressLine line(request.quiet);
  PartsOfWork parts(line, "packing", request.packings);
  for (int64_t k = 0; k < request.packings; ++k) {
    request.spec.seed = first + k;
    parts.begin(k);
    hfrac_lab* raw = nullptr;
    const int32_t status = hfrac_lab_run(&definition, &request.spec, show_parts, &parts, &raw);
    const Lab one(raw);
    line.end();
    if (status == HFRAC_ERR_ARGUMENT || status == HFRAC_ERR_MODEL)
      throw BadInput(run::error_text(status, nullptr));
    run::require(status, nullptr);
    auto report = run::sized<hfrac_lab_report>();
    run::require(hfrac_lab_get_report(one.get(), &report), nullptr);
    fmt::print("{}", describe(report, request.spec.test, request.spec.seed, request.time));
    if (!request.folder.empty())
      write_files(request.folder, one.get(), request.test, request.spec.seed, chart);
    if (status == HFRAC_STOPPED) {
      tell("hfrac: interrupted in the test of seed {}; what it says is of an unfinished test\n",
           request.spec.seed);
      return kInterrupted;
    }
    values.push_back(report.value * name.scale);
    if (report.plane_modulus > 0.0) ratios.push_back(report.poisson);
  }
  if (request.packings > 1) {
    const auto [mean, spread] = mean_and_spread(values);
    std::string text = fmt::format("{} {:.4g} +- {:.2g} {}", name.value, mean, spread, name.unit);
    if (ratios.size() == values.size()) {
      const auto [ratio, scatter] = mean_and_spread(ratios);
      text += fmt::format(", nu {:.3f} +- {:.2g}", ratio, scatter);
    }
    fmt::print("  mean     {} ({} packings)\n", text, request.packings);
  }
  if (!chart.empty()) draw_curves(request.folder, request.test, chart);
  return kGood;
}

}  // namespace

void add_lab(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("lab", "Test specimens of a case's rock: elasticity, strength, toughness");
  auto request = std::make_shared<LabRequest>();
  hfrac_lab_spec_init(&request->spec, static_cast<int32_t>(sizeof request->spec));
  std::vector<std::string> words;
  words.reserve(tests.size());
  for (const TestName& test : tests) words.emplace_back(test.word);
  command->add_option("TEST", request->test, "What to test")->required()->check(CLI::IsMember(words));
  command->add_option("CASE", request->case_file,
                      "Case file whose contacts, bonds and packing count; else the defaults");
  command->add_option("--discs", request->spec.disc_count, "Discs of the specimen")->capture_default_str();
  command->add_option("--seed", request->spec.seed, "Seed of the first packing")->capture_default_str();
  command->add_option("--packings", request->packings, "Specimens, each of another packing")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--width", request->spec.width, "Of the specimen, in m")->capture_default_str();
  command->add_option("--confining", request->spec.confining, "Stress on the sides (biaxial), in Pa");
  command->add_option("--slit", request->spec.slit_fraction, "Length of the slit over the width")
      ->capture_default_str();
  command->add_option("-o,--output", request->folder, "Write curves (CSV, PNG) and specimens (SVG) there")
      ->type_name("DIR");
  command->add_flag("--time", request->time, "Say how long packing and test took");
  command->add_flag("-q,--quiet", request->quiet, "No progress");
  command->callback([request, &action] { action = [request] { return lab(*request); }; });
}

}  // namespace hfrac::command
