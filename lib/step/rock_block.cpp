// SPDX-License-Identifier: BSD-3-Clause
#include "step/rock_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/plane_fit.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"

namespace hfrac {
using End = EquilibriumSolver::End;

namespace {

constexpr double gauge = 0.35;         // half of the sides' share that strain is taken over
constexpr double little_more = 1e-4;   // stress over the bonds' normal stiffness: a strain of about as much
constexpr double closest_rest = 1e-6;  // mean unbalanced over mean contact force
constexpr double unbreakable = 1e30;   // N per radius

Options options_of_block(Options o) {
  o.boundary_kind = static_cast<std::int64_t>(BoundaryKind::stress);
  o.fracture_law = static_cast<std::int64_t>(FractureLaw::bond);
  o.flow_fracture_aperture = static_cast<std::int64_t>(FractureAperture::bond);
  o.bond_fracture_toughness = 0.0;
  o.bond_smallest_fragment = 1;
  if (ThermalMode{o.thermal_mode} != ThermalMode::off)
    o.thermal_mode = static_cast<std::int64_t>(ThermalMode::uniform);
  o.solver_tolerance = std::min(o.solver_tolerance, closest_rest);
  return o;
}

CaseDefinition definition_of_block(const CaseDefinition& definition) {
  CaseDefinition block;
  block.options = options_of_block(definition.options);
  return block;
}

Model model_of_block(const CaseDefinition& definition, Packing packing) {
  SetupReport report;
  Model model = build_model(definition, std::move(packing), {}, report);
  model.assembly.tensile_per_radius = model.assembly.shear_per_radius = unbreakable;
  model.network.stiffness.assign(model.network.kind.size(), 0.0);  // pressures are given
  std::fill(model.network.pressure.begin(), model.network.pressure.end(), model.network.reference_pressure);
  return model;
}

PlaneElasticity undrained(const PlaneElasticity& rock, double biot_modulus, double alpha) {
  const double shear = rock.modulus / (2.0 * (1.0 + rock.poisson));
  const double bulk = rock.modulus / (2.0 * (1.0 - rock.poisson)) + alpha * alpha * biot_modulus;
  return {4.0 * shear * bulk / (bulk + shear), (bulk - shear) / (bulk + shear)};
}

std::string asked_by(bool exterior) {
  return exterior ? "boundary.kind = \"infinite\": " : "fracture.plane_modulus = 0, that is to be measured: ";
}

}  // namespace

RockBlock::RockBlock(const CaseDefinition& definition, Packing packing, const Ranks& ranks)
    : exterior_(BoundaryKind{definition.options.boundary_kind} == BoundaryKind::infinite),
      definition_(definition_of_block(definition)),
      model_(model_of_block(definition_, std::move(packing))),
      engine_(definition_.options, model_, ranks),
      solver_(model_, engine_.facets, *engine_.boundary, *engine_.mechanics, definition_.options,
              *engine_.workers) {
  engine_.mechanics->use_scaled_masses();
  engine_.mechanics->set_undrained(false);
  solver_.begin_step();
  engine_.boundary->set_load(model_.assembly, 1.0);
  load(definition_.options.stress_sigma_Hmax, definition_.options.stress_sigma_hmin);
}

void RockBlock::load(double sigma_Hmax, double sigma_hmin) {
  engine_.boundary->set_far_field(model_.assembly, sigma_Hmax, sigma_hmin);
  if (solver_.solve(0.0, {}, std::numeric_limits<double>::infinity(), model_.cracks).end == End::rest) return;
  const auto moved =
      engine_.mechanics->relax(closest_rest, 20 * definition_.options.stepping_max_cycles, model_.cracks);
  if (moved.at_rest) return;
  throw Error(ErrorKind::collapsed,
              asked_by(exterior_) + "the packing without wells does not come to rest under sigma_Hmax = " +
                  rounded_text(sigma_Hmax) + " Pa and sigma_hmin = " + rounded_text(sigma_hmin) +
                  " Pa (unbalanced-force ratio " + rounded_text(moved.force_ratio) + ", wanted " +
                  rounded_text(closest_rest) + "); lower the stresses or raise the stiffnesses, or " +
                  (exterior_ ? "use boundary.kind = \"stress\"." : "give fracture.plane_modulus."));
}

RockBlock::Strain RockBlock::strain() const {
  const Assembly& a = model_.assembly;
  const Options& o = definition_.options;
  PlaneFit along_x, along_y;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    if (std::abs(a.x[i] - 0.5 * o.model_width) > gauge * o.model_width ||
        std::abs(a.y[i] - 0.5 * o.model_height) > gauge * o.model_height)
      continue;
    along_x.add(a.x[i], a.y[i], a.ux[i]);
    along_y.add(a.x[i], a.y[i], a.uy[i]);
  }
  return {-along_x.plane().by_x, -along_y.plane().by_y};
}

// Pore volume per area whose fluid would store what the rock does; 0 of a dry model.
double RockBlock::storing() const {
  const Network& n = model_.network;
  const Assembly& a = model_.assembly;
  double area = 0.0, pores = 0.0;
  for (auto k = n.corner_start[0]; k < n.corner_start[1]; ++k) {
    const auto [i, before, after] = n.corner(0, k);
    area += 0.5 * cross({a.x[i], a.y[i]}, {a.x[after], a.y[after]});
  }
  for (std::size_t d = 1; engine_.wet() && d < n.storing.size(); ++d) pores += n.storing[d];
  return pores / std::abs(area);
}

PlaneElasticity RockBlock::measure() {
  if (measured_) return *measured_;
  const Options& o = definition_.options;
  const double more = little_more * std::max(o.bond_normal_stiffness, o.contact_normal_stiffness);
  const Strain before = strain();
  load(o.stress_sigma_Hmax + more, o.stress_sigma_hmin);
  const Strain by_x = strain();
  load(o.stress_sigma_Hmax, o.stress_sigma_hmin + more);
  const Strain by_y = strain();
  const double along = 0.5 * (by_x.x - before.x + by_y.y - before.y) / more,
               across = 0.5 * (by_x.y - before.y + by_y.x - before.x) / more;
  const PlaneElasticity rock{1.0 / along, -across / along};
  if (!(rock.modulus > 0.0) || !(std::abs(rock.poisson) < 1.0))
    throw Error(ErrorKind::model,
                asked_by(exterior_) + "the packing has no elastic constants under the far field (E' = " +
                    rounded_text(rock.modulus) + " Pa, nu' = " + rounded_text(rock.poisson) + "); give " +
                    (exterior_ ? "boundary.exterior_modulus and boundary.exterior_poisson_ratio."
                               : "fracture.plane_modulus."));
  const double pores = storing();
  measured_ = pores > 0.0 ? undrained(rock, o.fluid_bulk_modulus / pores, o.rock_biot_coefficient) : rock;
  return *measured_;
}

}  // namespace hfrac
