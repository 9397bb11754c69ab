// SPDX-License-Identifier: BSD-3-Clause
#include "command/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hfrac::command {
namespace {

constexpr double kMegapascal = 1e-6;
constexpr double kPeak = 0.01;  // of the pressure: a fall by less after the largest is no breakdown

/** The largest pressure while fluid goes in, if the pressure falls from it before shut-in. */
std::optional<double> breakdown_of(const InjectionRecord& record, const ShutIn& at) {
  const auto begin = record.pressure.begin() + static_cast<std::ptrdiff_t>(at.begin);
  const auto end = record.pressure.begin() + static_cast<std::ptrdiff_t>(at.row);
  const auto top = std::max_element(begin, end);
  const double lowest = *std::min_element(top, end);
  if (*top - lowest < kPeak * std::abs(*top)) return std::nullopt;
  return *top;
}

/** Mean over time of the second half of the injection. */
double propagation_of(const InjectionRecord& record, const ShutIn& at) {
  const double middle = 0.5 * (record.time[at.begin] + record.time[at.row]);
  double sum = 0.0, length = 0.0;
  for (size_t row = at.begin; row < at.row; ++row) {
    const double from = std::max(record.time[row], middle), part = record.time[row + 1] - from;
    if (part <= 0.0) continue;
    // The row at shut-in may be of the fall-off already.
    sum += part * (row + 1 < at.row ? 0.5 * (record.pressure[row] + record.pressure[row + 1])
                                    : record.pressure[row]);
    length += part;
  }
  return sum / length;
}

nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  if (!value) return nullptr;
  return *value;
}

nlohmann::ordered_json json_of_closure(const std::optional<Closure>& closure, const char* x_name) {
  if (!closure) return nullptr;
  return {{"since_shut_in_s", closure->since}, {x_name, closure->x}, {"pressure_Pa", closure->pressure}};
}

nlohmann::ordered_json json_of_steps(const StepRateReading& reading) {
  if (reading.steps.empty()) return nullptr;
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  for (const RateStep& step : reading.steps)
    steps.push_back({{"begin_s", step.begin},
                     {"end_s", step.end},
                     {"rate_m2_per_s", step.rate},
                     {"pressure_Pa", step.pressure}});
  return {{"extension_pressure_Pa", number_or_null(reading.pressure)},
          {"extension_rate_m2_per_s", number_or_null(reading.rate)},
          {"steps", steps}};
}

std::string closure_words(const char* what, const Closure& closure, const std::string& x,
                          const char* source) {
  return fmt::format("  {:18} {:.3f} MPa, {:.5g} s after shut-in, {} ({})\n", what,
                     closure.pressure * kMegapascal, closure.since, x, source);
}

}  // namespace

Analysis analyse_record(const InjectionRecord& record, const ShutIn& at, const FalloffTerms& terms) {
  Analysis found;
  found.shut_in = at;
  found.injection = terms.injection > 0.0 ? terms.injection : record.time[at.row] - record.time[at.begin];
  if (!record.rate.empty()) {
    found.volume = 0.0;
    for (size_t row = at.begin; row < at.row; ++row)
      *found.volume += record.rate[row] * (record.time[row + 1] - record.time[row]);
  }
  found.breakdown = breakdown_of(record, at);
  if (!found.breakdown)
    found.notes.emplace_back(
        "no breakdown pressure: the pressure does not fall by 1 % from its largest before shut-in");
  found.propagation = propagation_of(record, at);
  found.falloff.injection = found.injection;
  for (size_t row = at.row; row < at.end; ++row) {
    found.falloff.since.push_back(record.time[row] - record.time[at.row]);
    found.falloff.pressure.push_back(record.pressure[row]);
    found.g.push_back(nolte_g(found.falloff.since.back() / found.injection, terms.leak_off));
  }
  found.reading = read_falloff(found.falloff, terms.leak_off);
  found.notes.insert(found.notes.end(), found.reading.notes.begin(), found.reading.notes.end());
  found.step_rate = read_step_rate(record, at);
  if (!found.step_rate.note.empty()) found.notes.push_back(found.step_rate.note);
  return found;
}

std::string words_of(const Analysis& a, const InjectionRecord& record) {
  std::string text;
  const auto add = [&](const char* what, const std::string& words) {
    fmt::format_to(std::back_inserter(text), "  {:18} {}\n", what, words);
  };
  add("injection",
      fmt::format("from {:.6g} to {:.6g} s{}", record.time[a.shut_in.begin], record.time[a.shut_in.row],
                  a.volume ? fmt::format(", {:.4g} m2 per metre of thickness", *a.volume) : ""));
  add("fall-off", fmt::format("{:.6g} s, {} rows", a.falloff.since.back(), a.falloff.since.size()));
  if (a.breakdown) add("breakdown", fmt::format("{:.3f} MPa", *a.breakdown * kMegapascal));
  add("propagation",
      fmt::format("{:.3f} MPa, mean of the second half of the injection", a.propagation * kMegapascal));
  if (a.reading.isip)
    add("ISIP",
        fmt::format("{:.3f} MPa, straight line through the early fall-off to shut-in (Gronseth and Kry 1983)",
                    *a.reading.isip * kMegapascal));
  if (const auto& closure = a.reading.by_g)
    text += closure_words("closure, G", *closure,
                          fmt::format("G = {:.4g}: G dP/dG falls below its line", closure->x),
                          "Nolte 1979, Castillo 1987, Barree et al. 2009");
  if (const auto& closure = a.reading.by_root)
    text +=
        closure_words("closure, root", *closure,
                      fmt::format("sqrt(t) = {:.4g} s^0.5: inflection", closure->x), "Barree et al. 2009");
  if (const auto& closure = a.reading.by_stiffness)
    text += closure_words("closure, stiffness", *closure,
                          fmt::format("G = {:.4g}: the pressure falls faster over G", closure->x),
                          "McClure et al. 2016");
  if (!a.step_rate.steps.empty())
    add("step-rate test", fmt::format("{} steps, {:.4g} to {:.4g} m2/s", a.step_rate.steps.size(),
                                      a.step_rate.steps.front().rate, a.step_rate.steps.back().rate));
  if (a.step_rate.pressure)
    add("extension", fmt::format("{:.3f} MPa at {:.4g} m2/s, where two lines cross (Earlougher 1977)",
                                 *a.step_rate.pressure * kMegapascal, *a.step_rate.rate));
  for (const auto& note : a.notes) text += "  " + note + "\n";
  return text;
}

nlohmann::ordered_json json_of(const Analysis& a, const InjectionRecord& record) {
  const auto& line = a.reading.line;
  return {{"rows", record.time.size()},
          {"injection_begin_s", record.time[a.shut_in.begin]},
          {"shut_in_s", record.time[a.shut_in.row]},
          {"injection_time_s", a.injection},
          {"injected_volume_m2", number_or_null(a.volume)},
          {"fall_off_s", a.falloff.since.back()},
          {"breakdown_pressure_Pa", number_or_null(a.breakdown)},
          {"propagation_pressure_Pa", a.propagation},
          {"isip_Pa", number_or_null(a.reading.isip)},
          {"closure_by_g", json_of_closure(a.reading.by_g, "g")},
          {"closure_by_root_of_time", json_of_closure(a.reading.by_root, "root_of_time_s0.5")},
          {"closure_by_stiffness", json_of_closure(a.reading.by_stiffness, "g")},
          {"slope_over_g_Pa", line ? nlohmann::ordered_json(line->slope) : nlohmann::ordered_json(nullptr)},
          {"step_rate", json_of_steps(a.step_rate)},
          {"notes", a.notes}};
}

}  // namespace hfrac::command
