// SPDX-License-Identifier: BSD-3-Clause
#include "step/exterior_rock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "core/error.hpp"
#include "core/plane_fit.hpp"
#include "flow/aperture.hpp"
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

struct Strain {
  double x, y;  // contraction positive
};

// The block at rest under stresses that may change.
class Block {
 public:
  Block(const CaseDefinition& definition, Packing packing)
      : definition_(definition_of_block(definition)),
        model_(model_of_block(definition_, std::move(packing))),
        engine_(definition_.options, model_),
        solver_(model_, engine_.facets, *engine_.boundary, *engine_.mechanics, definition_.options,
                *engine_.workers) {
    engine_.mechanics->use_scaled_masses();
    engine_.mechanics->set_undrained(false);
    solver_.begin_step();
    engine_.boundary->set_load(model_.assembly, 1.0);
  }

  void load(double sigma_Hmax, double sigma_hmin) {
    engine_.boundary->set_far_field(model_.assembly, sigma_Hmax, sigma_hmin);
    if (solver_.solve(0.0, {}, std::numeric_limits<double>::infinity(), model_.cracks).end == End::rest)
      return;
    const Options& o = definition_.options;
    const auto moved = engine_.mechanics->relax(closest_rest, 20 * o.stepping_max_cycles, model_.cracks);
    if (moved.at_rest) return;
    throw Error(
        ErrorKind::collapsed,
        "boundary.kind = \"infinite\": the packing without wells does not come to rest under sigma_Hmax = " +
            rounded_text(sigma_Hmax) + " Pa and sigma_hmin = " + rounded_text(sigma_hmin) +
            " Pa (unbalanced-force ratio " + rounded_text(moved.force_ratio) + ", wanted " +
            rounded_text(closest_rest) +
            "); lower the stresses or raise the stiffnesses, or use boundary.kind = \"stress\"");
  }

  [[nodiscard]] Strain strain() const {
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
  [[nodiscard]] double storing() const {
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

  [[nodiscard]] const Assembly& assembly() const { return model_.assembly; }

 private:
  CaseDefinition definition_;
  Model model_;
  Engine engine_;
  EquilibriumSolver solver_;
};

// E' and nu' by how much more the block is strained under a little more stress.
PlaneElasticity measure(Block& block, const Options& o) {
  const double more = little_more * std::max(o.bond_normal_stiffness, o.contact_normal_stiffness);
  const Strain before = block.strain();
  block.load(o.stress_sigma_Hmax + more, o.stress_sigma_hmin);
  const Strain by_x = block.strain();
  block.load(o.stress_sigma_Hmax, o.stress_sigma_hmin + more);
  const Strain by_y = block.strain();
  const double along = 0.5 * (by_x.x - before.x + by_y.y - before.y) / more,
               across = 0.5 * (by_x.y - before.y + by_y.x - before.x) / more;
  return {1.0 / along, -across / along};
}

PlaneElasticity undrained(const PlaneElasticity& rock, double biot_modulus, double alpha) {
  const double shear = rock.modulus / (2.0 * (1.0 + rock.poisson));
  const double bulk = rock.modulus / (2.0 * (1.0 - rock.poisson)) + alpha * alpha * biot_modulus;
  return {4.0 * shear * bulk / (bulk + shear), (bulk - shear) / (bulk + shear)};
}

// Displacements of the block's discs by their places.
using Places = std::map<std::pair<double, double>, Vec2>;

Places places_of(const Assembly& block) {
  Places places;
  for (std::int64_t i = 0; i < block.disc_count(); ++i)
    places[{block.x[i], block.y[i]}] = {block.ux[i], block.uy[i]};
  return places;
}

// Of the model's rim: the same discs, by other numbers.
std::vector<Vec2> rest_of_rim(const Places& block, const Assembly& a, const Exterior& exterior) {
  std::vector<Vec2> rest;
  for (const auto& at : exterior.rim()) {
    const auto same = block.find({a.x[at.disc], a.y[at.disc]});
    if (same == block.end())
      throw Error(
          ErrorKind::model,
          "boundary.kind = \"infinite\": a disc of the outer boundary is not bonded to the packing without "
          "wells; bond the outermost discs, or use boundary.kind = \"stress\".");
    rest.push_back(same->second);
  }
  return rest;
}

}  // namespace

void begin_exterior(Engine& e, const CaseDefinition& definition, Packing packing, SetupReport& report) {
  const Options& o = e.options;
  Block block(definition, std::move(packing));
  block.load(o.stress_sigma_Hmax, o.stress_sigma_hmin);
  const Assembly& a = e.model.assembly;
  PlaneElasticity rock{o.boundary_exterior_modulus,
                       o.boundary_exterior_poisson_ratio / (1.0 - o.boundary_exterior_poisson_ratio)};
  const Places places = places_of(block.assembly());
  if (rock.modulus == 0.0) {
    rock = measure(block, o);
    if (!(rock.modulus > 0.0) || !(std::abs(rock.poisson) < 1.0))
      throw Error(
          ErrorKind::model,
          "boundary.kind = \"infinite\": the packing has no elastic constants under the far field (E' = " +
              rounded_text(rock.modulus) + " Pa, nu' = " + rounded_text(rock.poisson) +
              "); give boundary.exterior_modulus and boundary.exterior_poisson_ratio.");
    const double storing = block.storing();
    if (storing > 0.0) rock = undrained(rock, o.fluid_bulk_modulus / storing, o.rock_biot_coefficient);
  }
  auto exterior = std::make_unique<Exterior>(a, e.model.network, rock);
  exterior->rest_at(rest_of_rim(places, a, *exterior));
  e.boundary->engage(std::move(exterior));
  e.mechanics->refresh_stiffness();
  report.exterior_modulus = rock.modulus;
  report.exterior_poisson_ratio = rock.poisson / (1.0 + rock.poisson);
}

void put_rock_beyond_pipes(Engine& e, double permeability) {
  const Options& o = e.options;
  if (!(o.boundary_flow_distance > 0.0)) return;
  Network& n = e.model.network;
  const Assembly& a = e.model.assembly;
  double around = 0.0;  // m
  for (const auto pipe : n.outer_pipe) around += a.length(pipe);
  const double radius = std::sqrt(o.model_width * o.model_height / std::numbers::pi);
  const double whole =
      2.0 * std::numbers::pi * permeability / o.fluid_viscosity / std::log(o.boundary_flow_distance / radius);
  n.beyond.assign(n.left.size(), 0.0);
  for (const auto pipe : n.outer_pipe)
    n.beyond[static_cast<std::size_t>(pipe)] = whole * a.length(pipe) / around;
  update_apertures(n, a, o);
}

}  // namespace hfrac
