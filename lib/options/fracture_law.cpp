// SPDX-License-Identifier: BSD-3-Clause
#include "options/fracture_law.hpp"

#include <algorithm>
#include <cstddef>

namespace hfrac {

bool is_perforated(const CaseDefinition& definition) {
  const auto& wells = definition.wells;
  return definition.options.fracture_perforation_length > 0.0 ||
         std::any_of(wells.begin(), wells.end(),
                     [](const WellOptions& w) { return w.perforation_length > 0.0; });
}

FractureLaw fracture_law_of(const CaseDefinition& definition) {
  const Options& o = definition.options;
  if (FractureLaw{o.fracture_law} != FractureLaw::automatic) return FractureLaw{o.fracture_law};
  // What only facets have is refused, if at all, with what they do not go with.
  if (is_perforated(definition) || o.rock_biot_coefficient < 1.0) return FractureLaw::facet;
  const bool wanted = o.bond_fracture_toughness > 0.0;
  return wanted && why_no_facets(definition).empty() ? FractureLaw::facet : FractureLaw::bond;
}

std::string why_no_facets(const CaseDefinition& definition) {
  const Options& o = definition.options;
  const bool coupled = SteppingMode{o.stepping_mode} == SteppingMode::coupled;
  if (!coupled && SolverKind{o.solver_kind} == SolverKind::quasi_static)
    return "fracture.law = \"facet\" with solver.kind = \"quasi-static\" is for stepping.mode = \"coupled\" "
           "only; set that, or solver.kind = \"explicit\", or take fracture.law = \"bond\".";
  if (FlowScheme{o.flow_scheme} == FlowScheme::off)
    return "fracture.law = \"facet\" needs fluid, but flow.scheme = \"off\"; set flow.scheme = \"implicit\" "
           "or "
           "\"explicit\", or take fracture.law = \"bond\".";
  if (ThermalMode{o.thermal_mode} != ThermalMode::off) {
    if (!coupled)
      return "fracture.law = \"facet\" takes temperature with stepping.mode = \"coupled\" only; set that and "
             "solver.kind = \"quasi-static\", or thermal.mode = \"off\", or take fracture.law = \"bond\".";
    if (ThermalParameters{o.thermal_parameters} == ThermalParameters::table)
      return "fracture.law = \"facet\" takes no micro-parameters that follow temperature; set "
             "thermal.parameters = \"constant\", or take fracture.law = \"bond\".";
  }
  for (std::size_t k = 0; k < definition.joints.size(); ++k) {
    if (is_smooth(JointState{definition.joints[k].state})) continue;
    return "joint[" + std::to_string(k) +
           "].state: fracture.law = \"facet\" takes smooth joints only; set it to \"smooth-bonded\" or "
           "\"smooth-broken\", or take fracture.law = \"bond\".";
  }
  if (ContactShape{o.contact_shape} == ContactShape::flat)
    return "contact.shape = \"flat\" is a law of broken bonds, and fracture.law = \"facet\" makes them faces "
           "of "
           "the rock; leave the shape \"round\", or set fracture.law = \"bond\".";
  return {};
}

}  // namespace hfrac
