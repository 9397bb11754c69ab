// SPDX-License-Identifier: BSD-3-Clause
// Every number has its unit in its name. The state hash is a text, since 64 bits do not fit a JSON reader's
// double.
#include "output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/columns.hpp"
#include "output/stimulation.hpp"
#include "output/tables.hpp"

namespace hfrac::output {
namespace {

using json = nlohmann::ordered_json;

json setup_part(const hfrac_setup_report& setup) {
  return {{"mean_radius_m", setup.mean_radius},
          {"porosity", setup.porosity},
          {"packing_residual", setup.packing_residual},
          {"coordination", setup.coordination},
          {"packed_discs", setup.packed_discs},
          {"removed_in_wells", setup.removed_in_wells},
          {"removed_floaters", setup.removed_floaters},
          {"removed_crossings", setup.removed_crossings},
          {"strength_factor", setup.strength_factor},
          {"zero_stress_aperture_m", setup.zero_stress_aperture},
          {"permeability_m2", setup.permeability},
          {"equilibration_force_ratio", setup.equilibration_force_ratio},
          {"packing_seconds", setup.packing_seconds},
          {"setup_seconds", setup.setup_seconds},
          {"coarsest_radius_m", setup.coarsest_radius},
          {"fine_discs", setup.fine_discs},
          {"plane_modulus_Pa", setup.plane_modulus}};
}

json state_part(const hfrac_sim_state& state) {
  json part;
  part["step"] = state.step;
  part["time_s"] = state.time;
  part["cycles"] = state.cycles;
  part["at_rest"] = state.at_rest != 0;
  part["force_ratio"] = state.force_ratio;
  part["crack_count"] = state.crack_count;
  part["tensile_cracks"] = state.tensile_cracks;
  part["shear_cracks"] = state.shear_cracks;
  part["equilibration_cracks"] = state.equilibration_cracks;
  part["disc_count"] = state.disc_count;
  part["bond_count"] = state.bond_count;
  part["domain_count"] = state.domain_count;
  part["mechanical_step_s"] = state.mechanical_step;
  part["tip_distance_m"] = state.tip_distance;
  part["stop_reason"] = state.stop_reason;
  return part;
}

// NaN, an error that is not checked, becomes null.
json balance_part(const hfrac_balance& balance) {
  json part;
  const auto add = [&](const char* name, double value) { part[name] = value; };
  energy_columns(balance, add);
  add("injected_volume_m2", balance.injected_volume);
  fluid_columns(balance, add);
  return part;
}

json joint_part(const JointMeasure& joints) {
  json part = {{"length_m", joints.length}, {"slip_counted_m", kSlipped}};
  joint_columns(joints, [&](std::string_view name, double value) {
    part[std::string(name.substr(name.find('_') + 1))] = value;
  });
  return part;
}

json well_part(const hfrac_well_state& well) {
  return {{"x_m", well.x},
          {"y_m", well.y},
          {"radius_m", well.equivalent_radius},
          {"asked_radius_m", well.radius},
          {"pressure_Pa", well.pressure},
          {"target_pressure_Pa", well.target_pressure},
          {"rate_m2_per_s", well.rate},
          {"injected_volume_m2", well.injected_volume}};
}

json fracture_part(const hfrac_fracture& fracture) {
  json part;
  fracture_columns(fracture, [&](const char* name, const auto& value) { part[name] = value; });
  return part;
}

/** Where the case means to end, as far as it says: what a movie of a running case plans its axes by. */
json planned_part(const hfrac_sim_def& definition) {
  if (definition.stepping_end_time > 0.0) return {{"time_s", definition.stepping_end_time}};
  const int64_t every = std::max<int64_t>(1, definition.output_every);
  return {{"time_s", static_cast<double>(definition.stepping_steps) * definition.stepping_flow_step},
          {"steps", definition.stepping_steps},
          {"snapshots", 1 + (definition.stepping_steps + every - 1) / every}};
}

}  // namespace

std::vector<Warning> warnings_of(const nlohmann::ordered_json& summary, int64_t last) {
  std::vector<Warning> warnings;
  for (const auto& one : summary.value("warnings", nlohmann::ordered_json::array())) {
    const auto step = one.at("step").get<int64_t>();
    if (step > 0 && step <= last) warnings.push_back({step, one.at("text").get<std::string>()});
  }
  return warnings;
}

RunTerms terms_of(const nlohmann::ordered_json& summary) {
  const auto& request = summary.at("request");
  return {request.at("steps").get_ref<const json::number_integer_t&>(),
          request.at("grid").get<std::vector<double>>(), request.at("movie").get<bool>()};
}

json make_summary(const SnapshotFrame& frame, const RunCourse& course) {
  const auto definition = definition_of(frame.sim);
  const auto longest = measure(frame.fractures);
  int32_t abi = 0;
  require(hfrac_abi_version(&abi), nullptr);

  json summary;
  summary["title"] = definition.title;
  summary["stress_convention"] = definition.stress_convention == 0 ? "total" : "effective";
  summary["ended"] = course.ended;
  summary["wall_seconds"] = course.wall_seconds;
  summary["snapshots"] = course.snapshots;
  summary["steps_not_at_rest"] = course.steps_not_at_rest;
  summary["warnings"] = json::array();
  for (const auto& warning : course.warnings)
    summary["warnings"].push_back({{"step", warning.step}, {"text", warning.text}});
  summary["request"] = {
      {"steps", course.terms.steps}, {"grid", course.terms.grid}, {"movie", course.terms.movie}};
  summary["planned"] = planned_part(definition);
  summary["model"] = {{"width_m", definition.model_width}, {"height_m", definition.model_height}};
  summary["wells"] = json::array();
  for (const auto& well : frame.wells) {
    summary["wells"].push_back(well_part(well));
    if (frame.jointed) summary["wells"].back()["injectivity_m2_per_Pa_s"] = injectivity(well, definition);
  }
  summary["setup"] = setup_part(setup_of(frame.sim));
  summary["state"] = state_part(frame.state);
  summary["longest_fracture"] = {{"length_m", longest.length}, {"width_m", longest.width}};
  summary["fracture_volume_m2"] = longest.volume;
  summary["balance"] = balance_part(balance_of(frame.sim));
  summary["fractures"] = json::array();
  for (const auto& fracture : frame.fractures) summary["fractures"].push_back(fracture_part(fracture));
  if (frame.jointed) summary["joints"] = joint_part(measure_joints(frame.sim));
  summary["versions"] = {{"hfrac", version_of_library()}, {"abi", abi}, {"build", build_of_library()}};
  summary["state_hash"] = fmt::format("{:016x}", static_cast<uint64_t>(state_hash_of(frame.sim)));
  return summary;
}

}  // namespace hfrac::output
