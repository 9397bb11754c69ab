// SPDX-License-Identifier: BSD-3-Clause
// What cannot be built though each value is within its range. Every refusal says which values are at odds,
// and what to change; a simulation that would run and mean nothing is worse than one that does not start.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/water.hpp"
#include "options/choices.hpp"
#include "options/fracture_law.hpp"
#include "options/grading.hpp"
#include "options/model_size.hpp"
#include "options/number_text.hpp"
#include "options/options.hpp"

namespace hfrac {
namespace {

// A hole narrower than this many mean radii is a missing disc, not a well.
constexpr double smallest_hole = 2.0;
// A hole wider than this share of the smaller side leaves no rock between it and the boundary's influence.
constexpr double largest_hole = 0.25;
// Sides shorter than this many of the largest radii hold no packing.
constexpr double shortest_side = 4.0;
constexpr std::int64_t fewest_discs = 20;
// The quasi-static solver's factor takes some 10 kB a disc.
constexpr std::int64_t most_discs_of_block = 200000;

struct Radii {
  Grading mean;
  double largest_share = 1.0;  // largest radius over the mean around it

  [[nodiscard]] double largest() const { return largest_share * mean.coarsest(); }
  [[nodiscard]] double largest_at(Vec2 place) const { return largest_share * mean.at(place); }
};

[[noreturn]] void refuse(const std::string& text) {
  throw Error(ErrorKind::model, text);
}

std::string value_text(const char* key, double value, const char* unit) {
  return std::string(key) + " = " + number_text(value) + " " + unit;
}

Radii radii_of_packing(const CaseDefinition& definition) {
  const double ratio = definition.options.packing_radius_ratio;
  return {grading_of(definition), 2.0 * ratio / (1.0 + ratio)};
}

Radii radii_of_given(std::span<const double> discs, const Options& o) {
  const auto count = static_cast<std::int64_t>(discs.size() / 3);
  if (count < fewest_discs) {
    refuse("given_disc_count = " + number_text(count) + " is too few; give at least " +
           number_text(fewest_discs) + " discs.");
  }
  double mean = 0.0, largest = 0.0;
  for (std::int64_t i = 0; i < count; ++i) {
    const double* disc = &discs[static_cast<std::size_t>(3 * i)];
    const auto name = [i] { return "given_discs[" + number_text(i) + "]"; };
    if (!std::isfinite(disc[0]) || !std::isfinite(disc[1]) || !std::isfinite(disc[2])) {
      refuse(name() + " has a coordinate or radius that is not a finite number.");
    }
    if (!(disc[2] > 0.0)) refuse(name() + " has radius " + number_text(disc[2]) + " m; it must be positive.");
    if (disc[0] < 0.0 || disc[0] > o.model_width || disc[1] < 0.0 || disc[1] > o.model_height) {
      refuse(name() + " lies at (" + number_text(disc[0]) + ", " + number_text(disc[1]) +
             ") m, outside the model of " + number_text(o.model_width) + " m x " +
             number_text(o.model_height) + " m; the origin is its lower left corner.");
    }
    mean += disc[2];
    largest = std::max(largest, disc[2]);
  }
  mean /= static_cast<double>(count);
  Radii radii;
  radii.mean.fine = mean;
  radii.largest_share = largest / mean;
  return radii;
}

// A host's own bonds: two indices of its discs each, every pair once, discs that can hold each other.
void check_bonds(std::span<const std::int64_t> bonds, std::span<const double> discs) {
  if (bonds.empty()) return;
  const auto disc_count = static_cast<std::int64_t>(discs.size() / 3);
  const std::size_t count = bonds.size() / 2;
  if (disc_count == 0) {
    refuse("given_bonds are bonds between given_discs, and there are none; give both, or neither.");
  }
  const auto name = [](std::size_t k) {
    return "given_bonds[" + number_text(static_cast<std::int64_t>(k)) + "]";
  };
  std::vector<std::array<std::int64_t, 3>> pairs(count);  // smaller index, larger, number of the bond
  for (std::size_t k = 0; k < count; ++k) {
    const std::int64_t i = bonds[2 * k], j = bonds[2 * k + 1];
    for (const auto disc : {i, j}) {
      if (disc >= 0 && disc < disc_count) continue;
      refuse(name(k) + " names disc " + number_text(disc) + "; given_discs go from 0 to " +
             number_text(disc_count - 1) + ".");
    }
    if (i == j) refuse(name(k) + " bonds disc " + number_text(i) + " to itself.");
    const double* a = &discs[static_cast<std::size_t>(3 * i)];
    const double* b = &discs[static_cast<std::size_t>(3 * j)];
    const double gap = std::hypot(b[0] - a[0], b[1] - a[1]) - a[2] - b[2];
    if (gap > std::min(a[2], b[2])) {
      refuse(name(k) + " bonds discs " + number_text(i) + " and " + number_text(j) + ", which are " +
             rounded_text(gap) + " m apart; at most the smaller one's radius, " +
             rounded_text(std::min(a[2], b[2])) + " m, can be bridged.");
    }
    pairs[k] = {std::min(i, j), std::max(i, j), static_cast<std::int64_t>(k)};
  }
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t k = 1; k < count; ++k) {
    if (pairs[k][0] != pairs[k - 1][0] || pairs[k][1] != pairs[k - 1][1]) continue;
    refuse(name(static_cast<std::size_t>(pairs[k][2])) + " bonds discs " + number_text(pairs[k][0]) +
           " and " + number_text(pairs[k][1]) + " again, after " +
           name(static_cast<std::size_t>(pairs[k - 1][2])) + "; give every pair once.");
  }
}

void check_packing(const Options& o, const Radii& radii, bool given) {
  if (o.packing_coarsening > 1.0) {
    const std::string asked = value_text("packing.coarsening", o.packing_coarsening, "");
    if (given) refuse(asked + "is for discs that are packed, and given_discs come as they are; set it to 1.");
    if (PackingMethod{o.packing_method} != PackingMethod::relaxed) {
      refuse(asked +
             "is for packing.method = \"relaxed\" only: bricks, rows and grown discs are the same "
             "size everywhere; take that method, or a coarsening of 1.");
    }
  }
  const double side = std::min(o.model_width, o.model_height);
  if (side < shortest_side * radii.largest()) {
    refuse("The smaller model side of " + number_text(side) + " m is shorter than " +
           number_text(shortest_side) + " times the largest disc radius, about " +
           rounded_text(radii.largest()) +
           " m; raise packing.disc_count or make model.width and model.height less unequal.");
  }
}

// Facets of fractures: what they do not go with yet is refused.
void check_facets(const CaseDefinition& definition) {
  if (fracture_law_of(definition) == FractureLaw::facet) {
    if (const std::string why = why_no_facets(definition); !why.empty()) refuse(why);
  } else if (is_perforated(definition)) {
    refuse(
        "fracture.perforation_length, or that of a well, needs fracture.law = \"facet\"; set it, or leave "
        "the length at 0 m.");
  }
}

void check_rock(const CaseDefinition& definition) {
  const Options& o = definition.options;
  if (o.rock_biot_coefficient < 1.0 && fracture_law_of(definition) != FractureLaw::facet)
    refuse("rock.biot_coefficient = " + number_text(o.rock_biot_coefficient) +
           " needs fracture.law = \"facet\": the fluid pushes whole on a fracture's faces, which contacts of "
           "law bond cannot "
           "tell from the rock's pores; set the law, or leave the coefficient at 1.");
  const bool given = o.rock_porosity > 0.0;
  const double porosity = given ? o.rock_porosity : o.packing_porosity;
  if (porosity > o.rock_biot_coefficient)
    refuse((given ? "rock.porosity = " : "The packing's porosity of ") + number_text(porosity) +
           " is above rock.biot_coefficient = " + number_text(o.rock_biot_coefficient) +
           ", which no rock has; " + (given ? "lower the porosity" : "give the rock's, rock.porosity,") +
           " or raise the coefficient.");
}

void check_stresses(const Options& o) {
  if (o.stress_sigma_hmin > o.stress_sigma_Hmax) {
    refuse(value_text("stress.sigma_hmin", o.stress_sigma_hmin, "Pa") + " is above " +
           value_text("stress.sigma_Hmax", o.stress_sigma_Hmax, "Pa") +
           "; sigma_Hmax along x is the larger one: swap them or turn the model by 90 degrees.");
  }
  const bool total = StressConvention{o.stress_convention} == StressConvention::total;
  const bool wet = FlowScheme{o.flow_scheme} != FlowScheme::off;
  if (total && wet && o.stress_sigma_hmin < o.fluid_formation_pressure) {
    refuse(value_text("stress.sigma_hmin", o.stress_sigma_hmin, "Pa") + " is below " +
           value_text("fluid.formation_pressure", o.fluid_formation_pressure, "Pa") +
           ", so the rock would be pulled apart before injection; stress.convention = \"total\" takes total "
           "stresses: "
           "raise stress.sigma_hmin, lower fluid.formation_pressure, or set stress.convention = "
           "\"effective\" for "
           "effective ones.");
  }
  if (BoundaryKind{o.boundary_kind} == BoundaryKind::walls && o.stress_sigma_hmin < 0.0) {
    refuse(value_text("stress.sigma_hmin", o.stress_sigma_hmin, "Pa") +
           " is tension, and walls only push; give at least 0 Pa or set boundary.kind = \"stress\".");
  }
}

// The rock beyond the model.
void check_exterior(const Options& o, std::int64_t discs) {
  const bool infinite = BoundaryKind{o.boundary_kind} == BoundaryKind::infinite;
  const auto need = [&](bool fine, const std::string& text) {
    if (!fine) refuse(text);
  };
  const bool told = o.boundary_exterior_modulus > 0.0 || o.boundary_exterior_poisson_ratio > 0.0;
  need(
      infinite || !told,
      "boundary.exterior_modulus and boundary.exterior_poisson_ratio are of the rock beyond the model, which "
      "boundary.kind = \"infinite\" has alone; set it, or leave both at 0.");
  need(o.boundary_exterior_modulus > 0.0 || !(o.boundary_exterior_poisson_ratio > 0.0),
       value_text("boundary.exterior_poisson_ratio", o.boundary_exterior_poisson_ratio, "") +
           "needs boundary.exterior_modulus: both are measured, or both given.");
  need(!infinite || discs <= most_discs_of_block,
       "boundary.kind = \"infinite\" solves for the rest of all discs at once, and " + number_text(discs) +
           " discs are more than its " + number_text(most_discs_of_block) +
           "; take fewer, or boundary.kind = \"stress\".");
  if (!(o.boundary_flow_distance > 0.0)) return;
  need(infinite, value_text("boundary.flow_distance", o.boundary_flow_distance, "m") +
                     " is for boundary.kind = \"infinite\"; set it, or leave the distance at 0 m.");
  const double radius = std::sqrt(o.model_width * o.model_height / std::numbers::pi);
  need(o.boundary_flow_distance > radius,
       value_text("boundary.flow_distance", o.boundary_flow_distance, "m") +
           " is not beyond the model, whose area is that of a circle of " + rounded_text(radius) +
           " m; give more, or 0 for the formation pressure at the outermost discs.");
  need(FlowScheme{o.flow_scheme} != FlowScheme::off && OuterPores{o.flow_outer} == OuterPores::formation,
       "boundary.flow_distance needs flow.outer = \"formation\" and a flow.scheme other than \"off\"; no "
       "fluid "
       "passes the outer boundary, leave the distance at 0 m.");
  need(o.flow_permeability > 0.0 || o.flow_zero_stress_aperture > 0.0,
       "boundary.flow_distance needs flow.permeability above 0 m2: rock without it lets nothing through.");
  need(!(o.fluid_consistency > 0.0),
       "boundary.flow_distance takes Newtonian fluids, and fluid.consistency makes this one thin; leave the "
       "distance at 0 m.");
}

void check_material(const Options& o) {
  if (ContactMode{o.contact_mode} == ContactMode::after_break && o.bond_normal_stiffness == 0.0) {
    refuse(
        "bond.normal_stiffness = 0 N/m with contact.mode = \"after-break\" leaves intact rock without "
        "stiffness; "
        "give bond.normal_stiffness or set contact.mode = \"parallel\".");
  }
  if (o.bond_fracture_toughness > 0.0 && o.bond_toughness_reference_radius > 0.0) {
    refuse(value_text("bond.fracture_toughness", o.bond_fracture_toughness, "Pa m^0.5") + " and " +
           value_text("bond.toughness_reference_radius", o.bond_toughness_reference_radius, "m") +
           " both set the strengths; leave one of them at 0.");
  }
  if (o.bond_fracture_toughness > 0.0 && !(o.bond_tensile_strength > 0.0)) {
    refuse(
        "bond.fracture_toughness needs bond.tensile_strength above 0: bond.shear_strength keeps its ratio to "
        "it, 1 if both are left alone.");
  }
  if (o.flow_zero_stress_aperture > o.flow_aperture_limit) {
    refuse(value_text("flow.zero_stress_aperture", o.flow_zero_stress_aperture, "m") + " is above " +
           value_text("flow.aperture_limit", o.flow_aperture_limit, "m") +
           "; raise the limit or lower the aperture.");
  }
}

// Bonds that soften: what does not go with it is refused. Discs too large for the energy the packing shows (solid/softening.hpp).
void check_softening(const CaseDefinition& definition) {
  const Options& o = definition.options;
  if (!(o.bond_fracture_energy > 0.0)) return;
  const std::string asked = value_text("bond.fracture_energy", o.bond_fracture_energy, "J/m2");
  const auto need = [&](bool fine, const std::string& text) {
    if (!fine) refuse(asked + " " + text);
  };
  need(o.bond_normal_stiffness > 0.0 && o.bond_tensile_strength > 0.0 && o.bond_shear_strength > 0.0,
       "needs bond.normal_stiffness, bond.tensile_strength and bond.shear_strength above 0: a bond softens "
       "from its strength on; give them, or leave the energy at 0.");
  need(
      !(o.bond_fracture_toughness > 0.0) && !(o.bond_toughness_reference_radius > 0.0),
      "sets the toughness, and so do bond.fracture_toughness and bond.toughness_reference_radius, which take "
      "the strengths for it; leave those at 0, or the energy.");
  need(fracture_law_of(definition) == FractureLaw::bond,
       "is for fracture.law = \"bond\": facets break at tips by bond.fracture_toughness; set that law, or "
       "leave "
       "the energy at 0.");
  need(
      o.bond_smallest_fragment == 1,
      "goes with bond.smallest_fragment = 1 only: a bond that has softened bears nothing, whether it is kept "
      "or not; set 1, or leave the energy at 0.");
  need(ThermalMode{o.thermal_mode} == ThermalMode::off ||
           ThermalParameters{o.thermal_parameters} == ThermalParameters::constant,
       "takes no micro-parameters that follow temperature; set thermal.parameters = \"constant\", or leave "
       "the "
       "energy at 0.");
  for (std::size_t k = 0; k < definition.joints.size(); ++k)
    need(
        is_smooth(JointState{definition.joints[k].state}),
        "takes smooth joints only, which stay as they are, and joint[" + std::to_string(k) +
            "] is rough; set its state to \"smooth-bonded\" or \"smooth-broken\", or leave the energy at 0.");
}

void check_solver(const Options& o) {
  const bool quasi_static = SolverKind{o.solver_kind} == SolverKind::quasi_static;
  if (!quasi_static && FactorOf{o.solver_factor} == FactorOf::petsc) {
    refuse(
        "solver.factor = \"petsc\" is for solver.kind = \"quasi-static\"; the explicit solver has no factor, "
        "and flow.solver = \"petsc\" is for its flow steps.");
  }
  const SteppingMode mode{o.stepping_mode};
  if (mode == SteppingMode::coupled && !quasi_static) {
    refuse(
        "stepping.mode = \"coupled\" solves for equilibrium and flow together; set solver.kind = "
        "\"quasi-static\", or stepping.mode = \"substep\" for the explicit solver.");
  }
  if (mode == SteppingMode::coupled && FlowScheme{o.flow_scheme} != FlowScheme::implicit_scheme) {
    refuse("stepping.mode = \"coupled\" needs flow.scheme = \"implicit\"; a dry model has mode \"substep\".");
  }
  if (mode == SteppingMode::dynamic && quasi_static) {
    refuse(
        "stepping.mode = \"dynamic\" is motion in real time, which solver.kind = \"quasi-static\" has none "
        "of; "
        "use solver.kind = \"explicit\", or stepping.mode = \"coupled\".");
  }
}

void check_initial(const CaseDefinition& c) {
  const Options& o = c.options;
  if (InitialState{o.initial_state} != InitialState::seepage) return;
  if (FlowScheme{o.flow_scheme} == FlowScheme::off) {
    refuse(
        "initial.state = \"seepage\" needs flow, but flow.scheme = \"off\"; set flow.scheme = \"implicit\".");
  }
  if (c.wells.size() != 1) {
    refuse("initial.state = \"seepage\" is solved around one well, the case has " +
           std::to_string(c.wells.size()) + "; keep one well or set initial.state = \"uniform\".");
  }
  const double lowest =
      StressConvention{o.stress_convention} == StressConvention::total ? 0.0 : -o.fluid_formation_pressure;
  if (o.initial_well_pressure < lowest) {
    refuse(value_text("initial.well_pressure", o.initial_well_pressure, "Pa") +
           " is below zero absolute pressure, which is " + number_text(lowest) +
           " Pa in this stress.convention.");
  }
  if (o.initial_seepage_time > 0.0 && o.flow_permeability == 0.0) {
    refuse(
        "initial.seepage_time above 0 needs flow.permeability, which is 0; give the rock's permeability, or "
        "initial.seepage_time = 0 for the steady state.");
  }
}

void check_water(const Options& o) {
  if (FluidKind{o.fluid_kind} != FluidKind::water) return;
  if (o.fluid_consistency > 0.0)
    refuse("fluid.kind = \"water\" does not thin; set fluid.consistency = 0, or fluid.kind = \"given\".");
  if (o.thermal_rock_temperature < coldest_water || o.thermal_rock_temperature > hottest_water)
    refuse(value_text("thermal.rock_temperature", o.thermal_rock_temperature, "K") +
           " is outside 273.15 to 623.15 K, where "
           "the law of fluid.kind = \"water\" holds; set fluid.kind = \"given\".");
  const double boils = saturation_pressure(o.thermal_rock_temperature);
  if (o.fluid_formation_pressure < boils || o.fluid_formation_pressure > highest_water_pressure)
    refuse(value_text("fluid.formation_pressure", o.fluid_formation_pressure, "Pa") + " is outside " +
           rounded_text(boils) +
           " Pa, at which water of thermal.rock_temperature boils, to 100e6 Pa, where the law of fluid.kind "
           "= \"water\" "
           "holds; set fluid.kind = \"given\".");
}

void check_second_fluid(const CaseDefinition& c) {
  const Options& o = c.options;
  const auto is_second = [](const auto& item) {
    return item.fluid == static_cast<std::int64_t>(WellFluid::second);
  };
  const auto turns_second = [](const ScheduleEntry& entry) {
    return ScheduleFluid{entry.fluid} == ScheduleFluid::second;
  };
  if (o.fluid_second_viscosity > 0.0) {
    if (FlowScheme{o.flow_scheme} == FlowScheme::off)
      refuse("fluid.second_viscosity needs flow, but flow.scheme = \"off\"; set flow.scheme = \"implicit\".");
    if (o.fluid_consistency > 0.0)
      refuse(
          "fluid.second_viscosity is that of a fluid beside one that does not thin; set fluid.consistency = "
          "0 and "
          "fluid.power_index = 1, or fluid.second_viscosity = 0.");
    return;
  }
  if (std::any_of(c.wells.begin(), c.wells.end(), is_second) ||
      std::any_of(c.schedule.begin(), c.schedule.end(), turns_second))
    refuse("a well pumps the second fluid, and there is none: give its fluid.second_viscosity.");
  if (o.fluid_second_density > 0.0)
    refuse(value_text("fluid.second_density", o.fluid_second_density, "kg/m3") +
           " is of no fluid; give fluid.second_viscosity with it.");
}

void check_fluid(const Options& o) {
  check_water(o);
  const bool thinning = o.fluid_consistency > 0.0;
  if (thinning != (o.fluid_power_index < 1.0)) {
    refuse(
        value_text("fluid.consistency", o.fluid_consistency, "Pa s^n") +
        " and fluid.power_index = " + number_text(o.fluid_power_index) +
        (thinning
             ? ": a fluid of index 1 is Newtonian; give fluid.viscosity and set fluid.consistency = 0, or an "
               "index below 1."
             : ": a power law needs its consistency; give fluid.consistency above 0, or set "
               "fluid.power_index = 1."));
  }
  if (thinning && FlowScheme{o.flow_scheme} == FlowScheme::explicit_scheme) {
    refuse("fluid.consistency needs flow.scheme = \"implicit\": explicit flow is the paper's, Newtonian.");
  }
}

void check_joint(const std::string& name, const JointOptions& joint, const Options& o) {
  if (joint.x1 == joint.x2 && joint.y1 == joint.y2) {
    refuse(name + " has no length: both ends are at (" + number_text(joint.x1) + ", " +
           number_text(joint.y1) + ") m; move one of them.");
  }
  const auto need = [&](bool fine, const char* what, const std::string& fault) {
    if (!fine) refuse(name + "." + what + fault);
  };
  constexpr std::size_t first_of_smooth = 8;  // in joint_list.inc
  for (const auto& info : joint_table().subspan(first_of_smooth)) {
    need(is_smooth(JointState{joint.state}) || joint.*info.real == 0.0, info.key,
         " is for smooth joints; set state = \"smooth-broken\" or \"smooth-bonded\", or leave it out.");
  }
  need(joint.dilation_angle == 0.0 || joint.dilation_slip > 0.0, "dilation_slip",
       " = 0 m: dilation has to end; give the slip at which it does, some centimetres at most.");
  const bool own = joint.friction >= 0.0;
  need(own || joint.friction == -1.0, "friction",
       std::string(" = ") + number_text(joint.friction) +
           " is below 0; give 0 to 10, or -1 for contact.friction.");
  const double friction = own ? joint.friction : o.contact_friction;
  need(joint.weakening_slip == 0.0 || joint.residual_friction <= friction, "residual_friction",
       std::string(" = ") + number_text(joint.residual_friction) + " is above " + (own ? "" : "contact.") +
           "friction = " + number_text(friction) + "; slip weakens a joint, lower it.");
  need(joint.residual_friction == 0.0 || joint.weakening_slip > 0.0, "weakening_slip",
       " = 0 m: residual_friction needs the slip over which friction falls to it.");
  need(joint.aperture == 0.0 || joint.max_closure <= joint.aperture, "max_closure",
       " = " + number_text(joint.max_closure) + " m is more than the aperture of " +
           number_text(joint.aperture) + " m that there is to close.");
  need(joint.storage == 0.0 || joint.aperture > 0.0 || joint.residual_aperture > 0.0, "storage",
       " is for joints with an aperture of their own: without one, fluid does not flow along them; set "
       "aperture or "
       "residual_aperture, or leave it out.");
}

// Whether a joint meets the model's rectangle (Liang and Barsky 1984).
bool meets_model(const JointOptions& joint, const Options& o) {
  double first = 0.0, last = 1.0;  // share of its length at which it comes in and goes out
  const auto cut = [&](double from, double along, double side) {
    if (along == 0.0) {
      if (from < 0.0 || from > side) last = -1.0;
      return;
    }
    const double one = -from / along, other = (side - from) / along;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
  };
  cut(joint.x1, joint.x2 - joint.x1, o.model_width);
  cut(joint.y1, joint.y2 - joint.y1, o.model_height);
  return first <= last;
}

// Some joints of a map may lie outside; all of them are in other coordinates than the model.
void check_joints(const CaseDefinition& definition) {
  const Options& o = definition.options;
  const auto& joints = definition.joints;
  for (std::size_t k = 0; k < joints.size(); ++k)
    check_joint("joint[" + std::to_string(k) + "]", joints[k], o);
  const auto inside = [&](const JointOptions& joint) { return meets_model(joint, o); };
  if (joints.empty() || std::any_of(joints.begin(), joints.end(), inside)) return;
  const JointOptions& joint = joints.front();
  const auto end_text = [](double x, double y) {
    return std::string("(") + number_text(x) + ", " + number_text(y) + ")";
  };
  refuse("joint[0] from " + end_text(joint.x1, joint.y1) + " to " + end_text(joint.x2, joint.y2) +
         " m lies outside the model of " + number_text(o.model_width) + " m x " +
         number_text(o.model_height) + " m" + (joints.size() > 1 ? ", as do all others" : "") +
         "; the origin is its lower left corner.");
}

void check_schedule(const CaseDefinition& definition) {
  const auto& entries = definition.schedule;
  std::vector<const ScheduleEntry*> last(definition.wells.size());  // of each well
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::string name = "schedule[" + std::to_string(k) + "]";
    const ScheduleEntry& entry = entries[k];
    if (entry.well >= static_cast<std::int64_t>(definition.wells.size())) {
      refuse(name + ".well = " + number_text(entry.well) + " is not there: the case has " +
             std::to_string(definition.wells.size()) + " wells, counted from 0.");
    }
    check_schedule_entry(name, entry, definition.options);
    const ScheduleEntry*& before = last[static_cast<std::size_t>(entry.well)];
    if (before != nullptr && before->time >= entry.time) {
      refuse(name + ".time = " + number_text(entry.time) + " s is not after " + number_text(before->time) +
             " s, the time of the same well's entry before it; give them in order of time.");
    }
    before = &entry;
  }
}

double row_value(const Options& o, const char* column, std::int64_t row) {
  const std::string key = std::string("thermal.") + column + "_" + std::to_string(row);
  return get_value(o, *find_option(key));
}

void check_temperature(const Options& o) {
  const ThermalMode mode{o.thermal_mode};
  if (mode == ThermalMode::off || ThermalParameters{o.thermal_parameters} == ThermalParameters::constant)
    return;
  for (std::int64_t row = 2; row <= o.thermal_table_rows; ++row) {
    const double before = row_value(o, "temperature", row - 1), here = row_value(o, "temperature", row);
    if (here > before) continue;
    refuse("thermal.temperature_" + std::to_string(row) + " = " + number_text(here) +
           " K is not above the row before, " + number_text(before) +
           " K; give the rows of the table in rising temperature, or lower thermal.table_rows.");
  }
  const double lowest = row_value(o, "temperature", 1),
               highest = row_value(o, "temperature", o.thermal_table_rows);
  const auto require_inside = [&](const char* key, double kelvin) {
    if (kelvin >= lowest && kelvin <= highest) return;
    refuse(
        value_text(key, kelvin, "K") + " lies outside the table of micro-parameters, " + number_text(lowest) +
        " to " + number_text(highest) +
        " K; add a row (thermal.table_rows, thermal.temperature_1 to _5 and the factors beside them), or set "
        "thermal.parameters = \"constant\".");
  };
  require_inside("thermal.rock_temperature", o.thermal_rock_temperature);
  if (mode == ThermalMode::transport && FlowScheme{o.flow_scheme} != FlowScheme::off)
    require_inside("thermal.fluid_temperature", o.thermal_fluid_temperature);
}

void check_control(const std::string& name, const WellOptions& well, const Options& o) {
  if (well.control == WellControl::ramp && !(well.ramp_per_step > 0.0)) {
    refuse(name + ".ramp_per_step = " + number_text(well.ramp_per_step) +
           " Pa never reaches the target; give a positive rise per sub-step or set " + name +
           ".control = \"pressure\".");
  }
  if (well.control == WellControl::rate) {
    if (FlowScheme{o.flow_scheme} == FlowScheme::off) {
      refuse(name + ".control = \"rate\" needs flow, but flow.scheme = \"off\"; set " + name +
             ".control = \"pressure\" or flow.scheme = \"implicit\".");
    }
    return;
  }
  const bool total = StressConvention{o.stress_convention} == StressConvention::total;
  const double lowest = total ? 0.0 : -o.fluid_formation_pressure;
  if (well.pressure < lowest) {
    refuse(name + "." + value_text("pressure", well.pressure, "Pa") +
           " is below zero absolute pressure, which is " + number_text(lowest) +
           " Pa in stress.convention = \"" + (total ? "total" : "effective") + "\".");
  }
}

void check_well(const std::string& name, const WellOptions& well, const Options& o, const Radii& radii) {
  const double side = std::min(o.model_width, o.model_height);
  if (well.radius > largest_hole * side) {
    refuse(name + "." + value_text("radius", well.radius, "m") + " is above " + number_text(largest_hole) +
           " of the smaller model side, " + number_text(largest_hole * side) +
           " m; enlarge the model or the hole is its boundary.");
  }
  if (const double mean = radii.mean.at({well.x, well.y}); well.radius < smallest_hole * mean) {
    refuse(name + "." + value_text("radius", well.radius, "m") + " is below " + number_text(smallest_hole) +
           " mean disc radii, about " + rounded_text(smallest_hole * mean) +
           " m; raise packing.disc_count or enlarge the hole.");
  }
  const double margin = well.radius + 2.0 * radii.largest();
  if (well.x < margin || well.x > o.model_width - margin || well.y < margin ||
      well.y > o.model_height - margin) {
    refuse(name + " at (" + number_text(well.x) + ", " + number_text(well.y) +
           ") m does not lie inside the model; its centre must keep its radius and the largest disc's "
           "diameter, " +
           rounded_text(margin) + " m together, from each side of " + number_text(o.model_width) + " m x " +
           number_text(o.model_height) + " m.");
  }
}

// Wellbore, perforations and what a well shares with others.
void check_wellbore(std::size_t w, const CaseDefinition& c) {
  const WellOptions& well = c.wells[w];
  const Options& o = c.options;
  const std::string name = "well[" + std::to_string(w) + "]";
  const bool friction = well.perforation_count > 0.0 || well.near_well_friction > 0.0;
  if (well.perforation_count > 0.0 && !(well.perforation_diameter > 0.0))
    refuse(
        name +
        ".perforation_diameter = 0 m lets nothing through; give that of a perforation, some 0.01 m, or set " +
        name + ".perforation_count = 0.");
  if (FlowScheme{o.flow_scheme} == FlowScheme::off && (friction || well.storage > 0.0))
    refuse(name +
           " has wellbore storage or friction, which need flow, but flow.scheme = \"off\"; set flow.scheme = "
           "\"implicit\".");
  if (FlowScheme{o.flow_scheme} == FlowScheme::off && well.fluid_area > 0.0)
    refuse(name + "." + value_text("fluid_area", well.fluid_area, "m2") +
           " needs flow, but flow.scheme = \"off\"; set flow.scheme = \"implicit\", or fluid_area = 0.");
  if (friction && FlowScheme{o.flow_scheme} == FlowScheme::explicit_scheme)
    refuse(name +
           " has friction, which the explicit flow scheme does not follow; set flow.scheme = \"implicit\".");
  if (friction && InitialState{o.initial_state} == InitialState::seepage)
    refuse(
        name +
        " has friction, and initial.state = \"seepage\" knows no wellbore; set initial.state = \"uniform\".");
  if (well.wellbore == 0) return;
  std::size_t first = 0;
  while (c.wells[first].wellbore != well.wellbore) ++first;
  const bool shared = std::any_of(c.wells.begin(), c.wells.end(), [&](const WellOptions& other) {
    return &other != &well && other.wellbore == well.wellbore;
  });
  if (shared && !friction)
    refuse(name + " shares wellbore " + number_text(well.wellbore) +
           " and has no friction, by which the rate divides; "
           "give it perforation_count and perforation_diameter, or near_well_friction.");
  if (first == w) return;
  const bool scheduled = std::any_of(c.schedule.begin(), c.schedule.end(), [&](const ScheduleEntry& entry) {
    return entry.well == static_cast<std::int64_t>(w);
  });
  if (well.control == WellControl::pressure && well.pressure == 0.0 && well.rate == 0.0 && !scheduled) return;
  refuse(name + " is a cluster of wellbore " + number_text(well.wellbore) + ", which well[" +
         std::to_string(first) +
         "] drives; give the rate, pressure or schedule there, for all clusters together.");
}

void check_pair(std::size_t i, std::size_t j, const WellOptions& a, const WellOptions& b,
                const Radii& radii) {
  const double distance = std::hypot(a.x - b.x, a.y - b.y);
  const Vec2 middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  const double least = a.radius + b.radius + 2.0 * radii.largest_at(middle);
  if (distance >= least) return;
  refuse("well[" + std::to_string(i) + "] and well[" + std::to_string(j) + "] overlap: their centres are " +
         rounded_text(distance) + " m apart, at least " + rounded_text(least) +
         " m are needed to leave one disc between them.");
}

}  // namespace

void check_schedule_entry(const std::string& name, const ScheduleEntry& entry, const Options& o) {
  if (WellControl{entry.control} == WellControl::ramp) {
    refuse(name + ".control = \"ramp\" is not for a schedule; give pressures at several times, or a rate.");
  }
  WellOptions as_well;
  as_well.control = WellControl{entry.control};
  const bool by_rate = as_well.control == WellControl::rate;
  const WellOptionInfo& info = *find_well_option(by_rate ? "rate" : "pressure");
  set_real(as_well, info, name + ".value", entry.value);  // refuses what a well may not have
  check_control(name, as_well, o);
}

double expected_mean_radius(const Options& o) noexcept {
  // Radii spread evenly between the smallest and the largest: squared coefficient of variation
  // ((a-1)/(a+1))^2 / 3.
  const double spread = (o.packing_radius_ratio - 1.0) / (o.packing_radius_ratio + 1.0);
  const double mean_square_factor = 1.0 + spread * spread / 3.0;
  return std::sqrt(o.model_width * o.model_height * (1.0 - o.packing_porosity) /
                   (static_cast<double>(o.packing_disc_count) * std::numbers::pi * mean_square_factor));
}

void validate(const CaseDefinition& definition, std::span<const double> given_discs,
              std::span<const std::int64_t> given_bonds) {
  check_ranges(definition);
  const Options& o = definition.options;
  const std::int64_t discs = disc_count_of(o, given_discs);
  if (const std::string why = why_too_large(definition, discs); !why.empty()) refuse(why);
  const Radii radii = given_discs.empty() ? radii_of_packing(definition) : radii_of_given(given_discs, o);
  check_bonds(given_bonds, given_discs);
  check_packing(o, radii, !given_discs.empty());
  check_stresses(o);
  check_exterior(o, discs);
  check_facets(definition);
  check_rock(definition);
  check_material(o);
  check_softening(definition);
  check_solver(o);
  check_initial(definition);
  check_fluid(o);
  check_second_fluid(definition);
  check_joints(definition);
  check_schedule(definition);
  check_temperature(o);
  const auto& wells = definition.wells;
  for (std::size_t i = 0; i < wells.size(); ++i) {
    const std::string name = "well[" + std::to_string(i) + "]";
    check_well(name, wells[i], o, radii);
    check_control(name, wells[i], o);
    check_wellbore(i, definition);
    for (std::size_t j = 0; j < i; ++j) check_pair(j, i, wells[j], wells[i], radii);
  }
}

}  // namespace hfrac
