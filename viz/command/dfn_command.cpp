// SPDX-License-Identifier: BSD-3-Clause
// hfrac dfn: a discrete fracture network from statistics, or what one that is there is like; in words and as a picture.
#include <fmt/format.h>
#ifdef HFRAC_WITH_RENDERER
#include <hfrac/viz.h>
#endif

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "command/commands.hpp"
#include "command/dfn_file.hpp"
#include "command/dfn_statistics.hpp"
#include "command/numbers.hpp"
#include "run/files.hpp"
#ifdef HFRAC_WITH_RENDERER
#include "command/drawing.hpp"
#endif

namespace hfrac::command {
namespace {

struct DfnRequest {
  std::vector<std::string> sets;
  std::vector<double> size;     ///< [m] width, height
  std::vector<double> through;  ///< [m] x, y
  uint64_t seed = 1;
  double touching = 1e-3;  ///< [m]
  std::string output, description, picture;
  bool quiet = false;
#ifdef HFRAC_WITH_RENDERER
  Paper paper;
#endif
};

/** The model's rectangle, if one is given. */
std::optional<Frame> frame_of(const DfnRequest& request) {
  if (request.size.empty()) return std::nullopt;
  return Frame{0.0, 0.0, request.size.front(), request.size.back()};
}

void say(const DfnRequest& request, const std::vector<Trace>& traces, const Frame& frame) {
  const Description d = describe(traces, request.touching);
  const double area = frame.width * frame.height;
  fmt::print("  {:12} {}, {:.5g} m in {:g} m x {:g} m\n", "traces", d.count, d.length, frame.width,
             frame.height);
  if (d.count == 0) return;
  if (area > 0.0)
    fmt::print("  {:12} P21 {:.4g} 1/m, P20 {:.4g} 1/m2\n", "density", d.length / area,
               static_cast<double>(d.count) / area);
  fmt::print("  {:12} {:.4g} to {:.4g} m, median {:.4g} m, mean {:.4g} m\n", "lengths", d.shortest, d.longest,
             d.median, d.mean);
  fmt::print(
      "  {:12} mean {:.0f} degrees from x, by length; alignment {:.2f} (1: parallel, 0: all ways alike)\n",
      "directions", d.direction * 180.0 / std::numbers::pi, d.alignment);
  fmt::print("  {:12} {} crossings (X), {} ends on another trace (T)\n", "meetings", d.crossings, d.t_ends);
}

void say_reached(const NetworkPlan& plan, const std::vector<Trace>& traces) {
  const double area = plan.frame.width * plan.frame.height;
  for (size_t k = 0; k < plan.sets.size(); ++k) {
    int64_t count = 0;
    double length = 0.0;
    for (const Trace& trace : traces) {
      if (trace.set != static_cast<int32_t>(k)) continue;
      ++count;
      length += length_of(trace);
    }
    fmt::print("  {:12} {} traces, P21 {:.4g} 1/m of {:g} asked\n", fmt::format("set {}", k + 1), count,
               length / area, plan.sets[k].p21);
  }
}

#ifdef HFRAC_WITH_RENDERER
/** How many traces are expected to be at least as long, by the statistics, at lengths spread evenly in their logarithm. */
struct GivenCurve {
  std::vector<double> lengths, counts;  ///< [m], 1

  GivenCurve(const NetworkPlan& plan, const std::vector<Trace>& traces) {
    if (plan.sets.empty() || traces.empty()) return;
    std::vector<double> numbers(plan.sets.size(), 0.0);
    double shortest = INFINITY, longest = 0.0;
    for (const Trace& trace : traces) {
      numbers[static_cast<size_t>(trace.set)] += 1.0;
      shortest = std::min(shortest, length_of(trace));
      longest = std::max(longest, length_of(trace));
    }
    for (const FractureSet& set : plan.sets)
      longest = std::max(longest, std::min(set.longest, 2.0 * longest));
    constexpr int points = 200;
    for (int i = 0; i <= points; ++i) {
      const double length = shortest * std::pow(longest / shortest, static_cast<double>(i) / points);
      double count = 0.0;
      for (size_t k = 0; k < numbers.size(); ++k) count += numbers[k] * longer_share(plan.sets[k], length);
      if (count < 0.5) break;  // less than one trace
      lengths.push_back(length);
      counts.push_back(count);
    }
  }
};

void draw(const DfnRequest& request, const NetworkPlan& plan, const std::vector<Trace>& traces,
          const std::string& target) {
  std::vector<double> ends;
  std::vector<int32_t> sets;
  for (const Trace& trace : traces) {
    ends.insert(ends.end(), {trace.from.x, trace.from.y, trace.to.x, trace.to.y});
    sets.push_back(trace.set);
  }
  const GivenCurve given(plan, traces);
  auto options = options_for(request.paper, hfrac_viz_trace_options_init);
  options.left = plan.frame.left;
  options.bottom = plan.frame.bottom;
  options.frame_width = plan.frame.width;
  options.frame_height = plan.frame.height;
  options.given_lengths = given.lengths.data();
  options.given_counts = given.counts.data();
  options.given_points = static_cast<int64_t>(given.lengths.size());
  drawing_stopped(hfrac_viz_render_traces(ends.data(), sets.data(), static_cast<int64_t>(traces.size()),
                                          target.c_str(), &options));
  if (!request.quiet) fmt::print("  {:12} {}\n", "picture", target);
}
#endif

void show(const DfnRequest& request, const NetworkPlan& plan, const std::vector<Trace>& traces,
          const std::string& file) {
  if (!request.quiet) {
    fmt::print("{}\n", file);
    say(request, traces, plan.frame);
    say_reached(plan, traces);
  }
#ifdef HFRAC_WITH_RENDERER
  if (traces.empty()) return;
  draw(request, plan, traces,
       request.picture.empty() ? std::filesystem::path(file).replace_extension(".png").string()
                               : request.picture);
#endif
}

void require_positive(const std::vector<double>& numbers, const char* name) {
  for (const double number : numbers)
    if (!(number > 0.0 && number <= 1e6))
      throw BadInput(fmt::format("{} {} is outside 0 to 1e6 m", name, number));
}

ExitCode make(const DfnRequest& request) {
  if (request.output.empty())
    throw BadInput(
        "dfn needs --output FILE.csv or FILE.geojson for the traces of its --set, or --describe FILE");
  NetworkPlan plan;
  plan.frame = frame_of(request).value_or(Frame{0.0, 0.0, 100.0, 100.0});
  plan.seed = request.seed;
  for (size_t k = 0; k < request.sets.size(); ++k) plan.sets.push_back(set_of(request.sets[k], k + 1));
  if (!request.through.empty()) {
    plan.through = Place{request.through[0], request.through[1]};
    if (!(plan.through->x > 0.0 && plan.through->x < plan.frame.width && plan.through->y > 0.0 &&
          plan.through->y < plan.frame.height))
      throw BadInput(fmt::format("--through {} {} m does not lie in the model of {:g} m x {:g} m",
                                 plan.through->x, plan.through->y, plan.frame.width, plan.frame.height));
  }
  const std::vector<Trace> traces = make_network(plan);
  std::string remark =
      fmt::format("hfrac dfn --seed {} --size {:g} {:g}", plan.seed, plan.frame.width, plan.frame.height);
  if (plan.through) remark += fmt::format(" --through {:g} {:g}", plan.through->x, plan.through->y);
  for (const auto& set : request.sets) remark += " --set " + set;
  write_traces(request.output, traces, remark);
  show(request, plan, traces, request.output);
  return kGood;
}

ExitCode dfn(const DfnRequest& request) {
  require_positive(request.size, "--size");
  if (request.description.empty()) return make(request);
  if (!request.output.empty()) throw BadInput("dfn takes --describe FILE or --output FILE, not both");
  NetworkPlan plan;
  const std::vector<Trace> traces = read_traces(request.description);
  plan.frame = frame_of(request).value_or(frame_around(traces));
  show(request, plan, traces, request.description);
  return kGood;
}

}  // namespace

void add_dfn(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "dfn", "Make traces of natural fractures from statistics, or describe those of a file");
  auto request = std::make_shared<DfnRequest>();
  auto* set = command->add_option("--set", request->sets,
                                  "A set, once for each, as NAME=NUMBER,...: direction (degrees from x), "
                                  "concentration (von Mises; 0: any direction), "
                                  "p21 (length per area, 1/m), exponent, shortest, longest (power law, m) or "
                                  "median, deviation (lognormal, m and "
                                  "of the logarithm), t (share that ends on an earlier trace it meets)");
  set->take_all()->allow_extra_args(false);
  command->add_option("--size", request->size, "Width and height of the model in metres; 100 100")
      ->expected(1, 2);
  command
      ->add_option("--through", request->through,
                   "X Y in metres that the first trace of each set goes through: a well")
      ->expected(2);
  command->add_option("--seed", request->seed, "Whole number; another one gives another network")
      ->check(count_number())
      ->capture_default_str();
  command->add_option("-o,--output", request->output, "File of the traces, .csv or .geojson")->needs(set);
  command->add_option("--describe", request->description, "Traces that are there, .csv or .geojson")
      ->excludes(set);
  command
      ->add_option("--touching", request->touching,
                   "Metres within which an end counts as lying on another trace")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
#ifdef HFRAC_WITH_RENDERER
  command->add_option("--picture", request->picture,
                      "Picture, .png, .svg or .pdf; left out: the traces' file with .png");
  add_paper_options(*command, request->paper);
#endif
  command->add_flag("-q,--quiet", request->quiet, "Print nothing unless something goes wrong");
  command->callback([request, &action] { action = [request] { return dfn(*request); }; });
}

}  // namespace hfrac::command
