// SPDX-License-Identifier: BSD-3-Clause
// hfrac analyse: what an injection and its fall-off say of the fracture - breakdown, propagation, shut-in pressure, closure, extension -
// from a run's history or a field's record, in words, as JSON and as pictures.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "command/analysis.hpp"
#include "command/commands.hpp"
#include "command/numbers.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/analysis_pictures.hpp"
#include "command/drawing.hpp"
#endif

namespace hfrac::command {
namespace {

struct AnalyseRequest {
  std::string source, output;
  double shut_in = NAN;         ///< [s]
  double injection_time = 0.0;  ///< [s]
  double thickness = 0.0;       ///< [m]; 0: not given
  std::string leak_off = "little";
  bool quiet = false;
#ifdef HFRAC_WITH_RENDERER
  std::string picture;
  Paper paper;
#endif
};

ExitCode analyse(const AnalyseRequest& request) {
  const InjectionRecord record =
      read_injection(request.source, request.thickness > 0.0 ? request.thickness : 1.0);
  const FalloffTerms terms{request.leak_off == "most" ? LeakOff::most : LeakOff::little,
                           request.injection_time};
  const Analysis analysis = analyse_record(record, find_shut_in(record, request.shut_in), terms);
  if (!request.quiet) fmt::print("{}\n{}", request.source, words_of(analysis, record));
  if (!request.quiet && request.thickness == 0.0 && !record.rate.empty() &&
      !std::filesystem::is_directory(request.source))
    fmt::print("  {:18} 1 m is taken where rates are of the whole thickness; --thickness M gives it\n",
               "thickness");
  if (!request.output.empty()) run::write_whole(request.output, json_of(analysis, record).dump(2) + "\n");
#ifdef HFRAC_WITH_RENDERER
  if (!request.picture.empty())
    for (const auto& file : draw_analysis(analysis, record, request.picture, request.paper))
      if (!request.quiet) fmt::print("  {:18} {}\n", "picture", file);
#endif
  return kGood;
}

}  // namespace

void add_analyse(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "analyse", "Read breakdown, shut-in and closure pressure from a run or a field's record");
  auto request = std::make_shared<AnalyseRequest>();
  command
      ->add_option(
          "SOURCE", request->source,
          "Run folder (its first well), or a .csv file with columns such as time_s, rate_L_s, pressure_MPa")
      ->required();
  command->add_option("-o,--output", request->output, "JSON file of all that was read");
  command->add_option("--shut-in", request->shut_in,
                      "Seconds at which the well was shut in; left out: the last time the rate falls to 0");
  command
      ->add_option("--injection-time", request->injection_time,
                   "Seconds that the fracture grew before shut-in, for G; left out: as long as fluid went "
                   "in. Breakdown late "
                   "in the injection makes it shorter")
      ->check(CLI::Range(1e-3, 1e9));
  command
      ->add_option("--thickness", request->thickness,
                   "Metres that rates of the whole thickness are divided by; 1 otherwise")
      ->check(CLI::Range(1e-6, 1e6));
  command
      ->add_option("--leak-off", request->leak_off,
                   "How much leaks off while fluid goes in, for the G function: little or most")
      ->check(CLI::IsMember({"little", "most"}))
      ->capture_default_str();
#ifdef HFRAC_WITH_RENDERER
  command->add_option("--picture", request->picture,
                      "Pictures, .png, .svg or .pdf: NAME-record, NAME-g and NAME-root beside NAME");
  add_paper_options(*command, request->paper);
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return analyse(*request); }; });
}

}  // namespace hfrac::command
