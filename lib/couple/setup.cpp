// SPDX-License-Identifier: BSD-3-Clause
// From options to a model at rest: pack, cut the wells, bond, find the pores, load, calibrate the apertures.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "couple/simulation.hpp"
#include "flow/aperture.hpp"
#include "geom/packing.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "rock/seeping_well.hpp"
#include "solid/joints.hpp"

namespace hfrac {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Packing take_given(std::span<const double> discs) {
  Packing packing;
  const std::size_t n = discs.size() / 3;
  for (std::size_t i = 0; i < n; ++i) {
    packing.x.push_back(discs[3 * i]);
    packing.y.push_back(discs[3 * i + 1]);
    packing.radius.push_back(discs[3 * i + 2]);
  }
  return packing;
}

}  // namespace

Simulation::Simulation(CaseDefinition definition, std::span<const double> given_discs,
                       const Progress& progress, std::span<const std::int64_t> given_bonds)
    : definition_(std::move(definition)) {
  validate(definition_, given_discs, given_bonds);
  const auto start = std::chrono::steady_clock::now();
  workers_.reset(new Workers(static_cast<int>(options().run_workers)));
  build(given_discs, given_bonds, progress);
  equilibrate(progress);
  begin_balance();
  formation_pressure_ = options().fluid_formation_pressure;
  model_ = model_fingerprint();
  return_unused_pages();
  setup_.setup_seconds = seconds_since(start);
}

void Simulation::build(std::span<const double> given_discs, std::span<const std::int64_t> given_bonds,
                       const Progress& progress) {
  const Options& o = options();
  const auto start = std::chrono::steady_clock::now();
  bool stop = false;
  Packing packing;
  if (given_discs.empty()) {
    packing = pack_discs(packing_options(o), [&](double done) {
      return stop = progress && progress(0.5 * done, "packing the discs");
    });
    if (stop) throw Stopped{};
  } else {
    packing = take_given(given_discs);
  }
  setup_.packing_residual = packing.residual;
  setup_.packed = static_cast<std::int64_t>(packing.x.size());
  double solid = 0.0;
  for (const double r : packing.radius) solid += std::numbers::pi * r * r;
  setup_.porosity = 1.0 - solid / (o.model_width * o.model_height);
  setup_.packing_seconds = seconds_since(start);

  if (progress && progress(0.5, "bonding")) throw Stopped{};
  std::vector<Hole> holes;
  for (const auto& well : definition_.wells) holes.push_back({{well.x, well.y}, well.radius});
  ContactGraph graph =
      build_contact_graph(packing.x, packing.y, packing.radius, holes, o.bond_gap_tolerance, given_bonds);
  packing = {};
  setup_.removed_in_wells = graph.removed_in_wells;
  setup_.removed_floaters = graph.removed_floaters;
  setup_.removed_crossings = graph.removed_crossings;
  setup_.unbonded = std::count(graph.bonded.begin(), graph.bonded.end(), 0);
  Hash bonded;
  bonded.add_all(graph.bonded);
  bonds_given_ = bonded.value();
  Faces faces = build_faces(graph);

  std::vector<std::int32_t> well_domains;
  for (std::size_t w = 0; w < definition_.wells.size(); ++w) {
    const auto& well = definition_.wells[w];
    const auto face = face_around(graph, faces, {well.x, well.y});
    if (face < 0) {
      throw Error(ErrorKind::model, "well[" + std::to_string(w) + "] at (" + std::to_string(well.x) + ", " +
                                        std::to_string(well.y) +
                                        ") m is not surrounded by rock; move it inward or make it smaller");
    }
    well_domains.push_back(face);
  }
  assembly_ = build_assembly(std::move(graph), o);
  apply_joints(assembly_, definition_.joints, o, cracks_);
  setup_.coordination =
      2.0 * static_cast<double>(assembly_.bond_count()) / static_cast<double>(assembly_.disc_count());
  for (std::size_t w = 0; w < definition_.wells.size(); ++w) {
    const auto& given = definition_.wells[w];
    Well well;
    well.place = {{given.x, given.y},
                  std::sqrt(faces.polygon_area[well_domains[w]] / std::numbers::pi),
                  well_domains[w]};
    well.control = given.control;
    well.target_pressure = given.pressure;
    well.ramp_per_step = given.ramp_per_step;
    well.set_rate = given.rate;
    for (const auto& entry : definition_.schedule) {
      if (entry.well == static_cast<std::int64_t>(w)) well.schedule.push_back(entry);
    }
    wells_.push_back(well);
  }
  network_ = build_network(std::move(faces), assembly_, well_domains, o);
  begin_heat();
  boundary_ = std::make_unique<Boundary>(assembly_, network_, o);
  solver_ = std::make_unique<ExplicitSolver>(assembly_, network_, *boundary_, o, *workers_);
}

// What the pores hold before the treatment, by domain [Pa].
std::vector<double> Simulation::initial_pressures() const {
  const Options& o = options();
  std::vector<double> pressure(static_cast<std::size_t>(network_.domain_count()),
                               network_.reference_pressure);
  if (InitialState{o.initial_state} == InitialState::uniform) return pressure;
  SeepingWell well;
  well.width = o.model_width;
  well.height = o.model_height;
  well.centre = wells_[0].place.centre;
  well.radius = wells_[0].place.equivalent_radius;
  well.excess = o.initial_well_pressure - network_.reference_pressure;
  well.duration = o.initial_seepage_time;
  well.outer_drained = OuterPores{o.flow_outer} == OuterPores::formation;
  well.outer_held = BoundaryKind{o.boundary_kind} == BoundaryKind::walls;
  double pores = 0.0;
  for (std::size_t d = 1; d < network_.volume.size(); ++d)
    pores += network_.kind[d] == DomainKind::rock ? network_.volume[d] : 0.0;
  BiotMaterial rock;
  rock.youngs_modulus = o.initial_youngs_modulus;
  rock.poissons_ratio = o.initial_poissons_ratio;
  rock.biot = 1.0;  // discs do not shrink under the pressure of the pores around them
  rock.storage = pores / (o.model_width * o.model_height) / o.fluid_bulk_modulus;
  // What rests in the end does not depend on it; validate() asks for it where it matters.
  if (o.flow_permeability > 0.0) rock.mobility = o.flow_permeability / o.fluid_viscosity;
  const auto excess = seepage_pressure(well, rock, network_.centroid);
  for (std::size_t d = 1; d < pressure.size(); ++d)
    pressure[d] = std::max(pressure[d] + excess[d], network_.floor_pressure);
  pressure[static_cast<std::size_t>(wells_[0].place.domain)] = o.initial_well_pressure;
  return pressure;
}

// The far field and what to do if rock does not bear it: in words, before anything is injected.
void Simulation::require_rock_stands(std::size_t cracks_before, double share) const {
  constexpr double most = 0.01;  // of all bonds
  const auto bonds = static_cast<double>(assembly_.bond_count());
  const auto broken = cracks_.size() - cracks_before;
  if (static_cast<double>(broken) <= std::max(10.0, most * bonds)) return;
  const Options& o = options();
  throw Error(ErrorKind::model,
              "the rock does not bear the far field: " + std::to_string(broken) + " of " +
                  std::to_string(assembly_.bond_count()) + " bonds broke at " + rounded_text(100.0 * share) +
                  " % of sigma_Hmax = " + rounded_text(o.stress_sigma_Hmax) +
                  " Pa and sigma_hmin = " + rounded_text(o.stress_sigma_hmin) +
                  " Pa, before any injection; at most 1 % may. Bonds bear " +
                  rounded_text(o.bond_tensile_strength * assembly_.strength_factor) + " Pa in tension and " +
                  rounded_text(o.bond_shear_strength * assembly_.strength_factor) +
                  " Pa in shear: raise bond.tensile_strength and bond.shear_strength (or "
                  "bond.fracture_toughness, which sets them), take smaller discs, or bring the stresses "
                  "nearer to each other and to the pore pressure");
}

// Far field and formation pressure in stages, together: at every stage effective stresses are a share of the final ones.
// Pores are drained, so breakage here is the far field's doing alone. Under stress control the quasi-static solver finds each stage's
// equilibrium and breaks bonds in order, the farthest beyond its strength first; damped motion, which can shake more loose than the
// load breaks, serves the explicit solver, walls, and stages that have no equilibrium near.
void Simulation::equilibrate(const Progress& progress) {
  const Options& o = options();
  constexpr int stages = 10;
  const std::vector<double> pressure = initial_pressures();
  if (progress && progress(0.5, "finding equilibrium under the far field")) throw Stopped{};
  solver_->use_scaled_masses();
  solver_->set_damping(std::max(0.3, o.stepping_damping));
  solver_->set_undrained(false);
  solver_->hold_edge(!boundary_->walled());
  std::unique_ptr<EquilibriumSolver> rest;
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static && !boundary_->walled()) {
    network_.stiffness.assign(network_.stiffness.size(), 0.0);  // pressures are given
    rest = std::make_unique<EquilibriumSolver>(assembly_, network_, *boundary_, *solver_, o, *workers_);
  }
  const std::size_t cracks_before = cracks_.size();
  ExplicitSolver::Outcome outcome;
  for (int stage = 1; stage <= stages; ++stage) {
    const double share = static_cast<double>(stage) / stages;
    boundary_->set_load(assembly_, share);
    for (std::size_t d = 0; d < pressure.size(); ++d) network_.pressure[d] = share * pressure[d];
    const bool last = stage == stages;
    bool stop = false;
    const auto asked = [&] {
      require_rock_stands(cracks_before, share);
      return stop = progress &&
                    progress(0.5 + 0.5 * (stage - 1) / stages, "finding equilibrium under the far field");
    };
    bool found = false;
    if (rest) {
      std::vector<std::byte> before;
      save_state(before);
      const auto solved = rest->solve(0.0, {}, std::numeric_limits<double>::infinity(), cracks_, asked);
      found = solved.end == EquilibriumSolver::End::rest;
      outcome.force_ratio = solved.force_ratio;
      outcome.at_rest = found;
      if (found) solver_->search_contacts(cracks_);
      else if (!stop) load_state(before);
    }
    if (!found && !stop)
      outcome = solver_->relax(last ? o.stepping_force_ratio : 1e-2,
                               (last ? 20 : 1) * o.stepping_max_cycles, cracks_, asked);
    if (stop) throw Stopped{};
    require_rock_stands(cracks_before, share);
  }
  solver_->hold_edge(false);
  require_joints_in_reach();
  setup_.force_ratio = force_ratio_ = outcome.force_ratio;
  setup_.cracks = static_cast<std::int64_t>(cracks_.size());
  at_rest_ = outcome.at_rest;
  if (WallsAfterEquilibration{o.boundary_walls_after_equilibration} == WallsAfterEquilibration::fixed) boundary_->fix_walls();
  solver_->stop_motion();
  solver_->set_damping(o.stepping_damping);
}

void Simulation::begin_balance() {
  const Options& o = options();
  start_x_ = assembly_.ux;
  start_y_ = assembly_.uy;
  start_rotation_ = assembly_.rotation;
  solver_->evaluate();  // volumes and forces where they came to rest
  const bool wet = FlowScheme{o.flow_scheme} != FlowScheme::off;
  for (std::int64_t d = 0; d < network_.domain_count(); ++d) {
    network_.content[d] = content_at(network_, d, o.fluid_bulk_modulus, network_.pressure[d]);
    const bool imposed = network_.kind[d] == DomainKind::outside;
    network_.stiffness[d] = wet && !imposed ? o.fluid_bulk_modulus / network_.volume[d] : 0.0;
  }
  if (wet) source_.assign(static_cast<std::size_t>(network_.domain_count()), 0.0);
  for (auto& well : wells_) {
    network_.stiffness[well.place.domain] = 0.0;
    well.content = network_.content[well.place.domain];
  }
  if (wet) {
    std::vector<double> pressure;
    calibrate_aperture(network_, assembly_, o, definition_.wells, pressure);
    setup_.permeability =
        measure_permeability(network_, assembly_, definition_.wells, o.fluid_viscosity, pressure);
    pressure = {};
    const double uniform = uniform_gradient_permeability(assembly_, network_, o.fluid_viscosity);
    if (uniform > 0.0 && setup_.permeability > 0.0) oda_matrix_ = setup_.permeability / uniform;
    flow_ = std::make_unique<FlowSolver>(network_, o);
    solver_->set_undrained(true);
  }
  if (wet) pressure_rate_.assign(static_cast<std::size_t>(network_.domain_count()), 0.0);
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static)
    equilibrium_ =
        std::make_unique<EquilibriumSolver>(assembly_, network_, *boundary_, *solver_, o, *workers_);
  if (wet) {
    start_content_ = network_.content;
  } else {
    for (const auto& well : wells_) start_content_.push_back(network_.content[well.place.domain]);
  }
  elastic_energy(start_bond_energy_, start_contact_energy_);
  start_boundary_work_ = boundary_->load_work(assembly_);
  start_outside_change_ = network_.volume_change[0];
  solver_->energies() = {};
  if (SteppingMode{o.stepping_mode} == SteppingMode::dynamic) solver_->use_real_masses();
}

}  // namespace hfrac
