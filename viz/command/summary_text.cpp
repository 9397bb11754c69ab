// SPDX-License-Identifier: BSD-3-Clause
// Lengths in the unit a person thinks in: metres for a fracture, millimetres for its width, MPa for
// pressures.
#include "command/summary_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "run/json_file.hpp"

namespace hfrac::command {
namespace {

using json = nlohmann::ordered_json;

constexpr size_t kWarningsShown = 3;

/** A number of the summary; NaN, which JSON writes as null, stays NaN. */
double number(const json& part, const char* key) {
  const auto& value = part.at(key);
  return value.is_null() ? std::nan("") : value.get<double>();
}

std::string line(const char* what, const std::string& value) {
  return fmt::format("  {:18} {}\n", what, value);
}

/** `error` as a share of `whole`, where there is a whole. */
std::string share(double error, double whole) {
  return whole > 0.0 ? fmt::format(" ({:.2g} of it)", std::abs(error) / whole) : std::string();
}

/** The largest of the energies, against which an error is judged. */
double energy_scale(const json& balance) {
  double scale = 0.0;
  for (const char* key :
       {"fluid_work_J_per_m", "boundary_work_J_per_m", "damping_J_per_m", "fracture_J_per_m"})
    scale = std::max(scale, std::abs(number(balance, key)));
  return scale;
}

}  // namespace

std::string summary_text(const json& summary) {
  return summary_text(summary, summary.at("ended").get<std::string>());
}

std::string summary_text(const json& summary, const std::string& ended) {
  const auto& state = summary.at("state");
  const auto& balance = summary.at("balance");
  const auto& longest = summary.at("longest_fracture");
  std::string text;
  if (const auto title = summary.at("title").get<std::string>(); !title.empty()) text += line("title", title);
  text += line("ended", ended);
  text += line("steps", fmt::format("{} ({:g} s of model time, {} snapshots, {} of wall time)",
                                    state.at("step").get<int64_t>(), number(state, "time_s"),
                                    summary.at("snapshots").get<int64_t>(),
                                    readable_duration(number(summary, "wall_seconds"))));
  if (const auto restless = summary.at("steps_not_at_rest").get<int64_t>(); restless > 0)
    text += line("not at rest", fmt::format("{} steps ended before their mechanics came to rest", restless));
  size_t told = 0;
  const auto warnings = summary.value("warnings", json::array());
  for (const auto& warning : warnings) {
    if (told++ == kWarningsShown) {
      text += line("", fmt::format("and {} more in summary.json", warnings.size() - kWarningsShown));
      break;
    }
    text += line("warning", warning.at("text").get<std::string>());
  }
  text += line("discs, bonds", fmt::format("{}, {}", state.at("disc_count").get<int64_t>(),
                                           state.at("bond_count").get<int64_t>()));
  text += line(
      "cracks",
      fmt::format("{} ({} in tension, {} in shear, {} during the initial equilibration)",
                  state.at("crack_count").get<int64_t>(), state.at("tensile_cracks").get<int64_t>(),
                  state.at("shear_cracks").get<int64_t>(), state.at("equilibration_cracks").get<int64_t>()));
  text += line("longest fracture", fmt::format("{:.4g} m long, {:.4g} mm wide", number(longest, "length_m"),
                                               number(longest, "width_m") * 1e3));
  text += line("fracture volume", fmt::format("{:.4g} m2", number(summary, "fracture_volume_m2")));
  if (const auto joints = summary.find("joints"); joints != summary.end())
    text += line("smooth joints",
                 fmt::format("{:.4g} m, of it {:.4g} m slipped and {:.4g} m open; largest slip {:.4g} mm",
                             number(*joints, "length_m"), number(*joints, "slipped_length_m"),
                             number(*joints, "open_length_m"), number(*joints, "largest_slip_m") * 1e3));
  int index = 0;
  for (const auto& well : summary.at("wells"))
    text += line(fmt::format("well {}", index++).c_str(),
                 fmt::format("{:.4g} MPa, {:.4g} m2 injected", number(well, "pressure_Pa") * 1e-6,
                             number(well, "injected_volume_m2")));
  const double fluid_error = number(balance, "fluid_error_m2"),
               injected = number(balance, "injected_volume_m2");
  text += line("fluid",
               fmt::format("injected {:.4g}, stored {:.4g}, leaked {:.4g}, missing {:.2g} m2{}", injected,
                           number(balance, "stored_volume_m2"), number(balance, "leaked_volume_m2"),
                           fluid_error, share(fluid_error, std::abs(injected))));
  const double energy_error = number(balance, "energy_error_J_per_m");
  text += line(
      "energy",
      std::isnan(energy_error)
          ? "not checked: the quasi-static solver counts what the works leave over as damping"
          : fmt::format("missing {:.2g} J/m{}", energy_error, share(energy_error, energy_scale(balance))));
  text += line("state hash", summary.at("state_hash").get<std::string>());
  return text;
}

namespace {

void print_table(const std::filesystem::path& folder, bool complete) {
  const auto summary = run::read_json(folder / "summary.json");
  fmt::print("{}", summary_text(summary));
  if (!complete) return;
  fmt::print(
      "  {:18} {}: discs.pvd, bonds.pvd, cracks.pvd, flow.pvd, fractures.pvd (ParaView), history.csv, "
      "cracks.csv,\n",
      "files", folder.string());
  fmt::print("  {:18} fractures.csv, fracture_lines.csv, events.csv, summary.json, case.toml\n", "");
#ifdef HFRAC_WITH_RENDERER
  fmt::print("  {:18} hfrac render {}\n", "pictures", folder.string());
#endif
}

}  // namespace

// The result of a run is its folder, and the exit code speaks of that: a workflow that is told of a failure removes it.
void print_result(const std::filesystem::path& folder, bool complete) {
  try {
    print_table(folder, complete);
    flush_results();
  } catch (const std::exception& error) {
    drop_results();
    tell("hfrac: '{}' is written, but what is in it cannot be told: {}\n", folder.string(), error.what());
  }
}

}  // namespace hfrac::command
