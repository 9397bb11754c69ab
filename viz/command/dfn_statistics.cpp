// SPDX-License-Identifier: BSD-3-Clause
#include "command/dfn_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "command/dfn_random.hpp"
#include "command/exit_code.hpp"
#include "run/text.hpp"

namespace hfrac::command {
namespace {

constexpr double kFarthest = 1e6;        // m, as of a joint's ends
constexpr size_t kMostTraces = 100'000;  // of a file that a case reads

struct Key {
  const char* name;
  double FractureSet::*member;
  double lowest, highest;
  const char* unit;
};
constexpr std::array<Key, 9> kKeys = {{{"direction", &FractureSet::direction, -360.0, 360.0, " degrees"},
                                       {"concentration", &FractureSet::concentration, 0.0, 1e4, ""},
                                       {"p21", &FractureSet::p21, 0.0, 1e3, " 1/m"},
                                       {"exponent", &FractureSet::exponent, 0.0, 10.0, ""},
                                       {"median", &FractureSet::median, 0.0, kFarthest, " m"},
                                       {"deviation", &FractureSet::deviation, 0.0, 5.0, ""},
                                       {"shortest", &FractureSet::shortest, 0.0, kFarthest, " m"},
                                       {"longest", &FractureSet::longest, 0.0, kFarthest, " m"},
                                       {"t", &FractureSet::t_share, 0.0, 1.0, ""}}};

bool is_lognormal(const FractureSet& set) {
  return set.median > 0.0;
}

/** Share of a lognormal law below `length`. */
double lognormal_below(const FractureSet& set, double length) {
  if (length <= 0.0) return 0.0;
  return 0.5 * std::erfc(-std::log(length / set.median) / (set.deviation * std::numbers::sqrt2));
}

double drawn_length(const FractureSet& set, Dice& dice) {
  if (is_lognormal(set)) {
    for (;;) {
      const double length = set.median * std::exp(set.deviation * dice.normal());
      if (length >= set.shortest && length <= set.longest) return length;
    }
  }
  const double share = dice.uniform(), power = 1.0 - set.exponent;
  if (power == 0.0) return set.shortest * std::pow(set.longest / set.shortest, share);
  const double low = std::pow(set.shortest, power), high = std::pow(set.longest, power);
  return std::pow(low + share * (high - low), 1.0 / power);
}

Trace around(Place middle, double angle, double length, int32_t set) {
  const double x = 0.5 * length * std::cos(angle), y = 0.5 * length * std::sin(angle);
  return {{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}, set};
}

/** Ends a trace on the nearest earlier one that it meets on the way from `middle`; false if it meets none. */
bool end_on_nearest(Trace& trace, Place middle, const std::vector<Trace>& earlier) {
  std::optional<double> nearest;  // shares of the way along the trace
  const double length = length_of(trace);
  const double own = std::hypot(middle.x - trace.from.x, middle.y - trace.from.y) / length;
  for (const Trace& other : earlier) {
    const auto at = meeting(trace, other);
    if (at && (!nearest || std::abs(*at - own) < std::abs(*nearest - own))) nearest = at;
  }
  if (!nearest) return false;
  const Place end{trace.from.x + *nearest * (trace.to.x - trace.from.x),
                  trace.from.y + *nearest * (trace.to.y - trace.from.y)};
  (*nearest > own ? trace.to : trace.from) = end;
  return true;
}

Trace drawn_trace(const NetworkPlan& plan, const FractureSet& set, int32_t number, bool first,
                  const std::vector<Trace>& earlier, Dice& dice) {
  for (;;) {
    const double angle = set.direction * std::numbers::pi / 180.0 + 0.5 * dice.von_mises(set.concentration);
    Place middle{plan.frame.left, plan.frame.bottom};
    middle.x += plan.frame.width * dice.uniform();
    middle.y += plan.frame.height * dice.uniform();
    double length = drawn_length(set, dice);
    const bool through = first && plan.through.has_value();
    if (through) {
      middle = *plan.through;
      length = set.longest < kFarthest ? set.longest : set.median;
    }
    auto trace = clipped(around(middle, angle, length, number), plan.frame);
    if (!trace) continue;  // on the frame, out of it
    if (set.t_share > 0.0 && dice.uniform() < set.t_share && !through)
      end_on_nearest(*trace, middle, earlier);
    if (length_of(*trace) > 0.0) return *trace;
  }
}

}  // namespace

void check_set(const FractureSet& set, const std::string& name) {
  for (const Key& key : kKeys) {
    const double value = set.*key.member;
    if (value >= key.lowest && value <= key.highest) continue;
    throw BadInput(fmt::format("{}: {} = {} is outside {} to {}{}", name, key.name, value, key.lowest,
                               key.highest, key.unit));
  }
  if (!(set.p21 > 0.0))
    throw BadInput(fmt::format(
        "{}: p21 = {} 1/m makes no traces; give the length of traces per area, above 0 to 1000 1/m", name,
        set.p21));
  if (set.shortest > set.longest)
    throw BadInput(fmt::format("{}: shortest = {} m is above longest = {} m; swap them", name, set.shortest,
                               set.longest));
  if (is_lognormal(set)) {
    if (!(set.deviation > 0.0))
      throw BadInput(
          fmt::format("{}: deviation = {}; a lognormal law needs the standard deviation of the logarithm of "
                      "the lengths, above 0 "
                      "to 5",
                      name, set.deviation));
    const double inside = lognormal_below(set, set.longest) - lognormal_below(set, set.shortest);
    if (inside < 1e-3)
      throw BadInput(
          fmt::format("{}: of the lognormal law with median = {} m only {:.1g} lies between shortest = {} m "
                      "and longest = {} m; "
                      "bring the median between them",
                      name, set.median, inside, set.shortest, set.longest));
  } else if (!(set.shortest > 0.0)) {
    throw BadInput(
        fmt::format("{}: shortest = {} m; a power law needs lengths above 0 to 1e6 m, as shortest and "
                    "longest (a lognormal law: "
                    "median and deviation)",
                    name, set.shortest));
  }
}

FractureSet set_of(const std::string& text, size_t number) {
  const std::string name = fmt::format("set {}", number);
  FractureSet set;
  bool longest_given = false, exponent_given = false;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    const size_t sign = std::min(item.find('='), item.size());
    const std::string word = item.substr(0, sign);
    const auto* key = std::find_if(kKeys.begin(), kKeys.end(), [&](const Key& k) { return word == k.name; });
    if (key == kKeys.end()) {
      std::string names;
      for (const Key& k : kKeys) names += std::string(names.empty() ? "" : ", ") + k.name;
      throw BadInput(fmt::format("{}: '{}' is not NAME=NUMBER with one of the names {}", name,
                                 run::printable(item), names));
    }
    const auto value = run::number_in<double>(std::string_view(item).substr(std::min(sign + 1, item.size())));
    if (!value || !std::isfinite(*value))
      throw BadInput(fmt::format("{}: '{}' is not a number from {} to {}{}", name, run::printable(item),
                                 key->lowest, key->highest, key->unit));
    set.*key->member = *value;
    longest_given = longest_given || word == "longest";
    exponent_given = exponent_given || word == "exponent";
  }
  if (is_lognormal(set) && exponent_given)
    throw BadInput(
        fmt::format("{}: has both exponent and median; give exponent, shortest and longest for a power law, "
                    "or median and deviation "
                    "for a lognormal one",
                    name));
  if (is_lognormal(set) && !longest_given) set.longest = kFarthest;
  check_set(set, name);
  return set;
}

double longer_share(const FractureSet& set, double length) {
  if (length <= set.shortest) return 1.0;
  if (length >= set.longest) return 0.0;
  if (is_lognormal(set)) {
    const double below = lognormal_below(set, set.shortest), all = lognormal_below(set, set.longest);
    return (all - lognormal_below(set, length)) / (all - below);
  }
  const double power = 1.0 - set.exponent;
  if (power == 0.0) return std::log(set.longest / length) / std::log(set.longest / set.shortest);
  const double high = std::pow(set.longest, power);
  return (high - std::pow(length, power)) / (high - std::pow(set.shortest, power));
}

std::vector<Trace> make_network(const NetworkPlan& plan) {
  const double area = plan.frame.width * plan.frame.height;
  Dice dice(plan.seed);
  std::vector<Trace> traces;
  std::vector<double> reached(plan.sets.size(), 0.0);  // m
  for (bool going_on = true; going_on;) {
    going_on = false;
    for (size_t k = 0; k < plan.sets.size(); ++k) {
      const FractureSet& set = plan.sets[k];
      if (reached[k] >= set.p21 * area) continue;
      if (traces.size() == kMostTraces)
        throw BadInput(
            fmt::format("set {}: p21 = {} 1/m takes more than {} traces, which no case reads; P21 {:.4g} 1/m "
                        "are reached with them: "
                        "lower p21 or raise shortest",
                        k + 1, set.p21, kMostTraces, reached[k] / area));
      traces.push_back(drawn_trace(plan, set, static_cast<int32_t>(k), reached[k] == 0.0, traces, dice));
      reached[k] += length_of(traces.back());
      going_on = true;
    }
  }
  return traces;
}

}  // namespace hfrac::command
