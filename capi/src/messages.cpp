// SPDX-License-Identifier: BSD-3-Clause
// Sentences are only put together if somebody hears them.
#include "messages.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "step/simulation.hpp"

namespace hfrac::capi {
namespace {

// K that a tip of law bond asks for under confining stress, over bond.fracture_toughness: a bond ahead feels the mean stress over a disc,
// so it breaks at K_Ic + 0.8 sigma' sqrt(R) (docs/verification/kgd-random.md, "With contacts and planes"). 1 where that does not apply.
double excess_of_tips(const Simulation& s) {
  const Options& o = s.options();
  if (FractureLaw{o.fracture_law} != FractureLaw::bond || o.bond_fracture_toughness <= 0.0 ||
      FlowScheme{o.flow_scheme} == FlowScheme::off || s.wells().empty()) {
    return 1.0;
  }
  const bool total = StressConvention{o.stress_convention} == StressConvention::total;
  const double borne = o.stress_sigma_hmin - (total ? o.fluid_formation_pressure : 0.0);
  return 1.0 + 0.8 * std::max(0.0, borne) * std::sqrt(s.engine_as_is().model.assembly.mean_radius) /
                   o.bond_fracture_toughness;
}

}  // namespace

Listener listener_of(hfrac_log_fn function, void* user, std::int64_t level) {
  if (function == nullptr) return {};
  if (level < HFRAC_LOG_ERROR || level > HFRAC_LOG_DETAIL) {
    throw Error(ErrorKind::argument,
                "log level " + std::to_string(level) +
                    " is outside 1 (errors) to 4 (every step); see enum hfrac_log_level.");
  }
  return {function, user, static_cast<std::int32_t>(level)};
}

void tell_setup(const hfrac_sim& sim) {
  const Simulation& s = *sim.simulation;
  const SetupReport& setup = s.setup();
  if (sim.listener.hears(HFRAC_LOG_INFO)) {
    tell(sim, HFRAC_LOG_INFO,
         "built in " + rounded_text(setup.setup_seconds) +
             " s: " + number_text(s.engine_as_is().model.assembly.disc_count()) + " discs of mean radius " +
             rounded_text(s.engine_as_is().model.assembly.mean_radius) + " m, " +
             number_text(s.engine_as_is().model.assembly.bond_count()) + " bonds, " +
             std::to_string(s.wells().size()) + " wells");
    if (s.engine_as_is().model.assembly.sizes.graded())
      tell(sim, HFRAC_LOG_INFO,
           "graded packing: " + number_text(setup.fine_discs) + " of " + number_text(setup.packed) +
               " discs are within " + rounded_text(s.engine_as_is().model.assembly.sizes.half_width) +
               " m of where fractures go, with that mean radius; the coarsest have " +
               rounded_text(setup.coarsest_radius) + " m");
    if (s.options().bond_fracture_toughness > 0.0)
      tell(sim, HFRAC_LOG_INFO,
           FractureLaw{s.options().fracture_law} == FractureLaw::facet
               ? "broken bonds are facets of fractures, which grow at bond.fracture_toughness"
               : "broken bonds are contacts (fracture.law = \"bond\"), with strengths by "
                 "bond.fracture_toughness");
  }
  if (!setup.device.empty()) tell(sim, HFRAC_LOG_INFO, "cycles run on " + setup.device);
  if (!sim.listener.hears(HFRAC_LOG_WARNING)) return;
  if (!setup.why_no_device.empty())
    tell(sim, HFRAC_LOG_WARNING,
         "run.device = \"auto\": cycles run on the processor, since " + setup.why_no_device);
  const Options& o = s.options();
  if (s.engine_as_is().model.assembly.sizes.graded() && o.bond_fracture_toughness <= 0.0 &&
      o.bond_toughness_reference_radius <= 0.0) {
    tell(sim, HFRAC_LOG_WARNING,
         "bonds of fine and coarse discs are equally strong, so the rock's toughness goes with the root of "
         "their radius; give bond.fracture_toughness");
  }
  if (const double excess = excess_of_tips(s); excess > 1.25) {
    tell(sim, HFRAC_LOG_WARNING,
         "with fracture.law = \"bond\" a tip asks for about " + rounded_text(excess) +
             " times bond.fracture_toughness under this stress, so fractures are too short and at too high a "
             "pressure; fracture.law = \"facet\" asks for the toughness alone");
  }
  if (setup.cracks > setup.broken_joints) {
    tell(sim, HFRAC_LOG_WARNING,
         number_text(setup.cracks - setup.broken_joints) +
             " bonds broke before injection, while the model came to rest under the far field");
  }
  if (setup.joints_left_out > 0) {
    tell(sim, HFRAC_LOG_WARNING,
         number_text(setup.joints_left_out) + " of " + number_text(setup.joints) +
             " joints are left out: shorter than two discs of mean radius " +
             rounded_text(s.engine_as_is().model.assembly.mean_radius) + " m, or outside the rock");
  }
  if (!s.engine_as_is().model.clock.at_rest) {
    tell(sim, HFRAC_LOG_WARNING,
         "the model did not come to rest under the far field: force ratio " +
             rounded_text(setup.force_ratio) + "; raise stepping.max_cycles");
  }
}

void tell_step(const hfrac_sim& sim, std::size_t cracks_before) {
  if (!sim.listener.hears(HFRAC_LOG_WARNING)) return;
  const Simulation& s = *sim.simulation;
  const std::string step = "step " + number_text(s.engine_as_is().model.clock.step);
  if (!s.engine_as_is().model.clock.at_rest) {
    tell(sim, HFRAC_LOG_WARNING,
         step + " did not come to rest: force ratio " +
             rounded_text(s.engine_as_is().model.clock.force_ratio));
  }
  const std::size_t cracks = s.cracks().size();
  if (cracks > cracks_before) {
    tell(sim, HFRAC_LOG_INFO,
         step + ", " + rounded_text(s.time()) + " s: " + std::to_string(cracks - cracks_before) +
             " new cracks, " + std::to_string(cracks) + " in all");
  }
  if (sim.listener.hears(HFRAC_LOG_DETAIL)) {
    tell(sim, HFRAC_LOG_DETAIL,
         step + ", " + rounded_text(s.time()) + " s: force ratio " +
             rounded_text(s.engine_as_is().model.clock.force_ratio) + ", " +
             number_text(s.engine_as_is().model.clock.cycles) + " cycles so far");
  }
}

}  // namespace hfrac::capi
