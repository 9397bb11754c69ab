// SPDX-License-Identifier: BSD-3-Clause
// hfrac calibrate: micro-parameters of rock with given macroscopic properties, as a case file.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "command/case_file.hpp"
#include "command/commands.hpp"
#include "command/interrupt.hpp"
#include "command/progress_line.hpp"
#include "command/standard_streams.hpp"
#include "run/engine_call.hpp"
#include "run/files.hpp"

namespace hfrac::command {
namespace {

struct CalibrateRequest {
  std::string case_file, output;
  hfrac_targets targets{};
  bool slopes = false, quiet = false;
};

struct Quantity {
  const char *name, *unit;
  double scale;
};
constexpr std::array<Quantity, HFRAC_MACRO_COUNT> quantities = {{{"E", "GPa", 1e-9},
                                                                 {"nu", "", 1.0},
                                                                 {"UCS", "MPa", 1e-6},
                                                                 {"tensile strength", "MPa", 1e-6},
                                                                 {"K_Ic", "MPa m^0.5", 1e-6},
                                                                 {"permeability", "mD", 1.0 / 9.869233e-16}}};

void print(const hfrac_sim_def& d, const hfrac_targets& t, const hfrac_calibration& c) {
  const double targets[] = {t.modulus,          t.poisson,   t.compressive_strength,
                            t.tensile_strength, t.toughness, t.permeability};
  fmt::print("  {:18} {:>11} {:>11} {:>9}   {}\n", "", "target", "achieved", "+-", "can be had");
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const Quantity& q = quantities[k];
    if (std::isnan(targets[k])) continue;
    const std::string range = std::isnan(c.lowest[k]) ? ""
                                                      : fmt::format("{:.4g} to {:.4g}", c.lowest[k] * q.scale,
                                                                    c.highest[k] * q.scale);
    fmt::print("  {:18} {:>11.5g} {:>11.5g} {:>9.2g}   {} {}\n", q.name, targets[k] * q.scale,
               c.achieved[k] * q.scale, c.spread[k] * q.scale, range, q.unit);
  }
  fmt::print("  contact.normal_stiffness {:.5g} N/m, shear_stiffness {:.5g} N/m (ratio {:.4f})\n",
             d.contact_normal_stiffness, d.contact_shear_stiffness,
             d.contact_shear_stiffness / d.contact_normal_stiffness);
  fmt::print("  bond.normal_stiffness {:.5g} N/m, shear_stiffness {:.5g} N/m\n", d.bond_normal_stiffness,
             d.bond_shear_stiffness);
  fmt::print("  bond.tensile_strength {:.5g} Pa, shear_strength {:.5g} Pa; packing.disc_count {}\n",
             d.bond_tensile_strength, d.bond_shear_strength, d.packing_disc_count);
  fmt::print("  bond.moment_contribution {:.4g}, open_share {:.4g}; contact.shape {}, friction {:.4g}\n",
             d.bond_moment_contribution, d.bond_open_share, d.contact_shape == 1 ? "flat" : "round",
             d.contact_friction);
  if (c.toughness_coefficient > 0.0) fmt::print("  K_Ic = {:.3f} sigma_c sqrt(R)\n", c.toughness_coefficient);
  if (c.zero_stress_aperture > 0.0)
    fmt::print("  r0 {:.4g} um at the model's disc size\n", c.zero_stress_aperture * 1e6);
  fmt::print("  {} tests in {}; achieved on packings other than those calibrated on\n", c.test_count,
             readable_duration(c.seconds));
}

ExitCode calibrate(CalibrateRequest request) {
  Definition definition;
  if (!request.case_file.empty()) definition = load_case(request.case_file, 0);
  request.targets.plane_slopes = request.slopes ? 1 : 0;
  require_likely_targets(request.targets);
  catch_interrupts();
  ProgressLine line(request.quiet);
  PartsOfWork parts(line, "", 1);  // how many tests it takes is not known beforehand
  auto found = run::sized<hfrac_calibration>();
  const int32_t status = hfrac_calibrate(&definition, &request.targets, show_parts, &parts, &found);
  line.end();
  if (status == HFRAC_STOPPED) {
    tell("hfrac: interrupted; nothing was found yet\n");
    return kInterrupted;
  }
  if (status == HFRAC_ERR_ARGUMENT || status == HFRAC_ERR_MODEL)
    throw BadInput(run::error_text(status, nullptr));
  run::require(status, nullptr);
  print(definition, request.targets, found);
  if (!request.output.empty()) run::write_whole(request.output, run::case_text(definition));
  if (found.reached != 0) return kGood;
  tell("hfrac: {}\n", found.text);
  return kRunFailed;
}

}  // namespace

void add_calibrate(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("calibrate", "Find micro-parameters for a rock's measured properties");
  auto request = std::make_shared<CalibrateRequest>();
  auto& t = request->targets;
  hfrac_targets_init(&t, static_cast<int32_t>(sizeof t));
  command->add_option("CASE", request->case_file, "Case file to start from; else the defaults");
  command->add_option("--E", t.modulus, "Young's modulus in plane strain, Pa");
  command->add_option("--nu", t.poisson, "Poisson's ratio in plane strain");
  command->add_option("--ucs", t.compressive_strength, "Uniaxial compressive strength, Pa");
  command->add_option("--tension", t.tensile_strength, "Direct tensile strength, Pa");
  command->add_option("--K", t.toughness, "Fracture toughness K_Ic, Pa m^0.5");
  command->add_option("--permeability", t.permeability, "Permeability, m2");
  command->add_flag("--slopes", request->slopes,
                    "--E and --nu are the two-dimensional model's slopes E' and nu'");
  command->add_option("--packings", t.packings, "Specimens a value is the mean of")->capture_default_str();
  command->add_option("--discs", t.disc_count, "Discs of elastic specimens")->capture_default_str();
  command->add_option("--strength-discs", t.strength_disc_count, "Discs of the others")
      ->capture_default_str();
  command->add_option("--seed", t.seed, "Seed of the first packing")->capture_default_str();
  command->add_option("-o,--output", request->output, "Write the case with the parameters found")
      ->type_name("FILE");
  command->add_flag("-q,--quiet", request->quiet, "No progress");
  command->footer(
      "Exit code 1: a target cannot be reached; the nearest is printed and written all the same.");
  command->callback([request, &action] { action = [request] { return calibrate(*request); }; });
}

}  // namespace hfrac::command
