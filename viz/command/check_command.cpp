// SPDX-License-Identifier: BSD-3-Clause
// hfrac check: is the case file good, and what would be built from it?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/run_size.hpp"
#include "command/standard_streams.hpp"
#include "run/text.hpp"

namespace hfrac::command {
namespace {

// Entries of a well's schedule, and when the first and the last begin [s].
struct Driven {
  int64_t entries = 0;
  double first = 0.0, last = 0.0;
};
Driven schedule_of(const hfrac_sim_def& definition, int64_t well) {
  Driven found;
  for (int64_t k = 0; k < definition.schedule_count; ++k) {
    const auto& entry = definition.schedule[k];
    if (entry.well == well)
      found = {found.entries + 1, found.entries == 0 ? entry.time : found.first, entry.time};
  }
  return found;
}

std::string place_of(const hfrac_well_def& well) {
  std::string place = fmt::format("({:g}, {:g}) m, radius {:g} m", well.x, well.y, well.radius);
  if (well.fluid_area > 0.0) place += fmt::format(", fluid in {:g} m2", well.fluid_area);
  return place;
}

std::string start_line(const hfrac_well_def& well) {
  const std::string place = place_of(well);
  if (well.control == HFRAC_WELL_RATE) return fmt::format("{}, takes {:g} m2/s", place, well.rate);
  if (well.control == HFRAC_WELL_RAMP)
    return fmt::format("{}, pressure rises by {:g} MPa per sub-step to {:g} MPa", place,
                       well.ramp_per_step * 1e-6, well.pressure * 1e-6);
  return fmt::format("{}, held at {:g} MPa", place, well.pressure * 1e-6);
}

std::string well_line(const hfrac_sim_def& definition, int64_t i) {
  const auto& well = definition.wells[i];
  const Driven by = schedule_of(definition, i);
  if (by.entries == 0) return start_line(well);
  const std::string schedule =
      by.entries == 1 ? fmt::format("its schedule's only entry")
                      : fmt::format("a schedule of {} entries, the last at {:g} s", by.entries, by.last);
  if (by.first > 0.0) return fmt::format("{}, from {:g} s on {}", start_line(well), by.first, schedule);
  return fmt::format("{}, {}", place_of(well), schedule);
}

std::string length_line(const hfrac_sim_def& definition) {
  if (const double end = definition.stepping_end_time; end > 0.0) {
    double last = 0.0;
    for (int64_t i = 0; i < definition.well_count; ++i)
      last = std::max(last, schedule_of(definition, i).last);
    return fmt::format("until {:g} s of model time{}", end,
                       last > end ? fmt::format(", before the schedule's last entry at {:g} s", last) : "");
  }
  const char* kind = definition.stepping_mode != 0 ? "steps" : "sub-steps";
  return fmt::format("{} {} of {:g} s", definition.stepping_steps, kind, definition.stepping_flow_step);
}

ExitCode check(const std::string& file) {
  std::vector<std::string> notes;
  const auto definition = load_case(file, 0, {}, &notes);
  fmt::print("{}: good\n", file);
  if (definition.title[0] != '\0') fmt::print("  title      {}\n", run::printable(definition.title));
  fmt::print("  model      {:g} m x {:g} m, about {} discs, porosity {:g}\n", definition.model_width,
             definition.model_height, definition.packing_disc_count, definition.packing_porosity);
  double fine = 0.0, coarsest = 0.0;
  if (definition.given_discs == nullptr &&
      hfrac_sim_def_disc_radii(&definition, &fine, &coarsest) == HFRAC_OK)
    fmt::print(
        "  discs      {}\n",
        coarsest > fine
            ? fmt::format("mean radius {:.3g} m where fractures go, up to {:.3g} m outwards", fine, coarsest)
            : fmt::format("mean radius {:.3g} m", fine));
  fmt::print("  stresses   {}\n", definition.stress_convention == 0 ? "total" : "effective");
  fmt::print(
      "  far field  sigma_Hmax {:g} MPa along x, sigma_hmin {:g} MPa along y, formation pressure {:g} MPa\n",
      definition.stress_sigma_Hmax * 1e-6, definition.stress_sigma_hmin * 1e-6,
      definition.fluid_formation_pressure * 1e-6);
  for (int64_t i = 0; i < definition.well_count; ++i)
    fmt::print("  well {}     {}\n", i, well_line(definition, i));
  if (definition.well_count == 0) fmt::print("  wells      none\n");
  for (const auto& note : notes) fmt::print("  record     {}\n", note);
  fmt::print("  run        {}, a snapshot every {}\n", length_line(definition), definition.output_every);
  const RunSize size = size_of_run(definition, -1);
  fmt::print("  writes     {}, unless it ends earlier\n", size_text(size));
  fmt::print("  memory     about {}\n", memory_text(size));
  for (const auto& text : unlikely_values(definition)) tell("hfrac: warning: {}: {}\n", file, text);
  return kGood;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("check", "Say whether a case file is good and what it would build");
  auto file = std::make_shared<std::string>();
  command->add_option("CASE", *file, "Case file (TOML)")->required();
  command->callback([file, &action] { action = [file] { return check(*file); }; });
}

}  // namespace hfrac::command
