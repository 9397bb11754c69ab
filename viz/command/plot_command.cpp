// SPDX-License-Identifier: BSD-3-Clause
// hfrac plot: the curves of a run, from its tables, or of several runs against each other.
#include <fmt/format.h>
#include <hfrac/viz.h>

#include "command/commands.hpp"
#include "command/compare.hpp"
#include "command/drawing.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"

namespace hfrac::command {
namespace {

struct PlotRequest {
  std::string folder;
  Paper paper;
  bool quiet = false;
  CompareRequest compare;
};

ExitCode compare(const PlotRequest& request) {
  if (request.paper.svg || request.paper.pdf)
    throw BadInput("with --compare the ending of --output says which kind of file");
  draw_comparison(request.compare, request.paper);
  if (!request.quiet) fmt::print("{}\n", request.compare.target);
  return kGood;
}

ExitCode plot(const PlotRequest& request) {
  if (!request.compare.sources.empty()) return compare(request);
  if (request.folder.empty()) throw BadInput("plot needs a run folder, or --compare and several");
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
  add_compare_options(*command, request->compare, folder);
  command->callback([request, &action] { action = [request] { return plot(*request); }; });
}

}  // namespace hfrac::command
