// SPDX-License-Identifier: BSD-3-Clause
// A case file is read over the defaults, so whatever is set before counts only where the file is silent.
#include "command/case_file.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "command/exit_code.hpp"
#include "output/disc_file.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {

namespace {

void require_good(int32_t status) {
  if (status < 0) throw BadInput(run::error_text(status, nullptr));
}

// `hfrac check study.toml` is natural to try.
void require_case(int32_t status, const std::string& file) {
  if (status >= 0) return;
  std::string text = run::error_text(status, nullptr);
  if (text.find(": case is not a known key") != std::string::npos)
    text += fmt::format(
        " A file that names a base case is a study: hfrac sweep {0}, or hfrac match {0} "
        "(docs/studies.md#the-study-file).",
        file);
  throw BadInput(text);
}

int32_t keep_note(void* notes, int32_t /*level*/, const char* message) {
  static_cast<std::vector<std::string>*>(notes)->emplace_back(message);
  return 0;
}

}  // namespace

GivenParts::GivenParts(const std::filesystem::path& disc_file, const std::filesystem::path& bond_file) {
  try {
    if (!disc_file.empty()) discs = output::read_discs(disc_file);
    if (!bond_file.empty()) bonds = output::read_bonds(bond_file);
  } catch (const output::DiscFileError& error) {
    throw BadInput(error.what());
  }
}

void add_given_parts(CLI::App& command, std::filesystem::path& disc_file, std::filesystem::path& bond_file) {
  command.add_option("--discs", disc_file, "Own discs instead of a packing: CSV with x, y, radius, or VTU")
      ->type_name("FILE");
  command
      .add_option(
          "--bonds", bond_file,
          "Which of the own discs are bonded: CSV with disc_0, disc_1, counted from 0; without, all that "
          "are near")
      ->needs("--discs")
      ->type_name("FILE");
}

GivenParts::GivenParts(const std::filesystem::path& run_folder) {
  const auto there = [&](const char* name) {
    const auto file = run_folder / name;
    return std::filesystem::exists(file) ? file : std::filesystem::path();
  };
  *this = GivenParts(there("given_discs.csv"), there("given_bonds.csv"));
}

void forget_given(hfrac_sim_def& definition) {
  definition.given_discs = nullptr;
  definition.given_disc_count = 0;
  definition.given_bonds = nullptr;
  definition.given_bond_count = 0;
}

Definition load_case(const std::string& file, int64_t workers, const GivenParts& given,
                     std::vector<std::string>* notes) {
  Definition definition;
  definition.run_workers = std::clamp<int64_t>(std::thread::hardware_concurrency(), 1, 4);
  if (notes != nullptr) {
    definition.log = keep_note;
    definition.log_user = notes;
  }
  require_case(hfrac_sim_def_load(&definition, file.c_str()), file);
  definition.log = nullptr;
  definition.log_user = nullptr;
  if (workers > 0) definition.run_workers = workers;
  if (!given.discs.empty()) {
    definition.given_discs = given.discs.data();
    definition.given_disc_count = static_cast<int64_t>(given.discs.size() / 3);
  }
  if (!given.bonds.empty()) {
    definition.given_bonds = given.bonds.data();
    definition.given_bond_count = static_cast<int64_t>(given.bonds.size() / 2);
  }
  require_good(hfrac_sim_def_check_file(&definition, file.c_str()));
  return definition;
}

namespace {

/** A size that no rock, fluid or well has, and the power of ten that was forgotten below it. */
struct Least {
  double size;
  const char* power;
};
constexpr Least kPressure = {1e4, "e6"};   // a tenth of the atmosphere's, against MPa
constexpr Least kModulus = {1e6, "e9"};    // softer than rubber, against GPa
constexpr Least kStiffness = {1e6, "e9"};  // N/m of a disc a metre thick, against GN/m
constexpr Least kToughness = {1e3, "e6"};  // Pa m^0.5, against MPa m^0.5
constexpr Least kForce = {1e3, "e6"};      // N, against MN

bool too_small(double value, const Least& least) {
  return value != 0.0 && std::abs(value) < least.size;
}

std::string did_you_mean(double value, const Least& least) {
  return fmt::format("values are in SI units, did you mean {:g}{}?", value, least.power);
}

struct Suspect {
  const char *key, *unit;
  Least least;
};
constexpr std::array<Suspect, 13> suspects = {{{"stress.sigma_Hmax", "Pa", kPressure},
                                               {"stress.sigma_hmin", "Pa", kPressure},
                                               {"fluid.formation_pressure", "Pa", kPressure},
                                               {"initial.well_pressure", "Pa", kPressure},
                                               {"bond.tensile_strength", "Pa", kPressure},
                                               {"bond.shear_strength", "Pa", kPressure},
                                               {"bond.fracture_toughness", "Pa m^0.5", kToughness},
                                               {"fluid.bulk_modulus", "Pa", kModulus},
                                               {"initial.youngs_modulus", "Pa", kModulus},
                                               {"contact.normal_stiffness", "N/m", kStiffness},
                                               {"contact.shear_stiffness", "N/m", kStiffness},
                                               {"bond.normal_stiffness", "N/m", kStiffness},
                                               {"flow.half_aperture_force", "N", kForce}}};

}  // namespace

std::vector<std::string> unlikely_values(const hfrac_sim_def& definition) {
  std::vector<std::string> told;
  const auto look = [&](const std::string& key, double value, const char* unit, const Least& least) {
    if (too_small(value, least))
      told.push_back(
          fmt::format("{} = {:g} {} is very little; {}", key, value, unit, did_you_mean(value, least)));
  };
  for (const Suspect& one : suspects) {
    double value = 0.0;
    run::require(hfrac_sim_def_get_f64(&definition, one.key, &value), nullptr);
    look(one.key, value, one.unit, one.least);
  }
  for (int64_t i = 0; i < definition.well_count; ++i)
    if (definition.wells[i].control != HFRAC_WELL_RATE)
      look(fmt::format("well[{}].pressure", i), definition.wells[i].pressure, "Pa", kPressure);
  for (int64_t i = 0; i < definition.schedule_count; ++i)
    if (definition.schedule[i].control != HFRAC_WELL_RATE)
      look(fmt::format("schedule[{}].value", i), definition.schedule[i].value, "Pa", kPressure);
  return told;
}

void require_likely_targets(const hfrac_targets& t) {
  const auto look = [](const char* option, double value, const char* unit, const Least& least) {
    if (!std::isnan(value) && value > 0.0 && too_small(value, least))
      throw BadInput(fmt::format("{} {:g} is {:g} {}, which no rock has; {}", option, value, value, unit,
                                 did_you_mean(value, least)));
  };
  look("--E", t.modulus, "Pa", kModulus);
  look("--ucs", t.compressive_strength, "Pa", kPressure);
  look("--tension", t.tensile_strength, "Pa", kPressure);
  look("--K", t.toughness, "Pa m^0.5", kToughness);
  constexpr double darcy = 9.869233e-13;  // m2
  if (!std::isnan(t.permeability) && t.permeability > 1e-6)
    throw BadInput(fmt::format(
        "--permeability {:g} is {:g} m2, which no rock has; values are in SI units: {:g} mD are {:.4g} m2",
        t.permeability, t.permeability, t.permeability, t.permeability * 1e-3 * darcy));
}

}  // namespace hfrac::command
