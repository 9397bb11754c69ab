// SPDX-License-Identifier: BSD-3-Clause
#include "step/initial_equilibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "core/give_back.hpp"
#include "flow/aperture.hpp"
#include "frac/joint_stress.hpp"
#include "frac/path.hpp"
#include "host/cell_report.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "rock/seeping_well.hpp"
#include "step/checks.hpp"
#include "step/exterior_rock.hpp"
#include "step/ledger.hpp"
#include "step/packed_state.hpp"
#include "step/rest.hpp"
#include "step/slips.hpp"
#include "step/snapshot.hpp"
#include "step/stages.hpp"

namespace hfrac {
namespace {

// Unbalanced over mean contact force after a stage of the initial equilibration, beyond which nothing is at rest.
constexpr double farthest_from_rest = 0.1;

// What the pores hold before the treatment, by domain [Pa].
std::vector<double> initial_pressures(const Engine& e) {
  const Options& o = e.options;
  const Network& n = e.model.network;
  const auto& wells = e.model.wells;
  std::vector<double> pressure(static_cast<std::size_t>(n.domain_count()), n.reference_pressure);
  if (InitialState{o.initial_state} == InitialState::uniform) return pressure;
  SeepingWell well;
  well.width = o.model_width;
  well.height = o.model_height;
  well.centre = wells[0].place.centre;
  well.radius = wells[0].place.equivalent_radius;
  well.excess = o.initial_well_pressure - n.reference_pressure;
  well.duration = o.initial_seepage_time;
  well.outer_drained = OuterPores{o.flow_outer} == OuterPores::formation;
  well.outer_held = BoundaryKind{o.boundary_kind} == BoundaryKind::walls;
  double pores = 0.0;
  for (std::size_t d = 1; d < n.volume.size(); ++d)
    pores += n.kind[d] == DomainKind::rock ? n.storing[d] : 0.0;
  BiotMaterial rock;
  rock.youngs_modulus = o.initial_youngs_modulus;
  rock.poissons_ratio = o.initial_poissons_ratio;
  rock.biot = o.rock_biot_coefficient;
  rock.storage = pores / (o.model_width * o.model_height) / o.fluid_bulk_modulus;
  // What rests in the end does not depend on it; validate() asks for it where it matters.
  if (o.flow_permeability > 0.0) rock.mobility = o.flow_permeability / o.fluid_viscosity;
  const auto excess = seepage_pressure(well, rock, n.centroid);
  for (std::size_t d = 1; d < pressure.size(); ++d)
    pressure[d] = std::max(pressure[d] + excess[d], n.floor_pressure);
  pressure[static_cast<std::size_t>(wells[0].place.domain)] = o.initial_well_pressure;
  return pressure;
}

// The far field and what to do if rock does not bear it: in words, before anything is injected.
void require_rock_stands(const Engine& e, std::size_t cracks_before, double share) {
  const Options& o = e.options;
  const Assembly& a = e.model.assembly;
  const auto bonds = static_cast<double>(a.bond_count());
  const auto broken = e.model.cracks.size() - cracks_before;
  if (static_cast<double>(broken) <= std::max(10.0, o.initial_broken_fraction * bonds)) return;
  throw Error(ErrorKind::collapsed,
              "the rock does not bear the far field: " + std::to_string(broken) + " of " +
                  std::to_string(a.bond_count()) + " bonds broke at " + rounded_text(100.0 * share) +
                  " % of sigma_Hmax = " + rounded_text(o.stress_sigma_Hmax) +
                  " Pa and sigma_hmin = " + rounded_text(o.stress_sigma_hmin) +
                  " Pa, before any injection; at most " + rounded_text(100.0 * o.initial_broken_fraction) +
                  " % may (initial.broken_fraction). Bonds bear " +
                  rounded_text(o.bond_tensile_strength * a.strength_factor) + " Pa in tension and " +
                  rounded_text(o.bond_shear_strength * a.strength_factor) +
                  " Pa in shear: raise bond.tensile_strength and bond.shear_strength (or "
                  "bond.fracture_toughness, which sets them), take smaller discs, or bring the stresses "
                  "nearer to each other and to the pore pressure");
}

// The state that facets are open or closed against: holes at the pressure at which fractures grow, sigma_hmin. What the discs around
// a hole bear of its pressure scatters and lies nearer to the wall than in a plate; with that pressure in it, little is left of either.
// Walls follow the far field until then, whatever they do afterwards: they bear the stress that facets are to release.
void begin_facets(Engine& e) {
  const Options& o = e.options;
  Model& m = e.model;
  const Array<double> pressure = m.network.pressure;
  const BoundaryState boundary = m.boundary;
  bool changed = false;
  m.boundary.servo = true;
  for (const auto& well : m.wells) {
    double& p = m.network.pressure[well.place.domain];
    changed = changed || p < o.stress_sigma_hmin;
    p = std::max(p, o.stress_sigma_hmin);
  }
  std::unique_ptr<EquilibriumSolver>
      own;  // that knows walls as they are now, or of a model that moves explicitly
  if (!e.equilibrium || e.boundary->walled())
    own = std::make_unique<EquilibriumSolver>(m, e.facets, *e.boundary, *e.mechanics, o, *e.workers);
  if (changed && !(own ? *own : *e.equilibrium).rest_unbroken())
    throw Error(ErrorKind::collapsed,
                "the rock does not come to rest with sigma_hmin = " + rounded_text(o.stress_sigma_hmin) +
                    " Pa in its wells, from where fracture.law facet measures openings; raise "
                    "bond.tensile_strength and bond.shear_strength, or make the wells smaller");
  e.facets.begin(m.assembly, m.network, m.well_places(), o);
  m.network.pressure = pressure;
  m.boundary = boundary;
  m.assembly.ux = m.start.x;
  m.assembly.uy = m.start.y;
  m.assembly.rotation = m.start.rotation;
  e.mechanics->evaluate();
}

// The explicit solver moves them, too.
void move_facets(Engine& e) {
  ExplicitSolver::FacetRules rules;
  rules.breaks = [&e](std::span<const std::int64_t> broken) {
    e.facets.add(e.model.assembly, e.model.network, broken);
  };
  if (e.options.bond_fracture_toughness > 0.0) rules.grow = [&e](CrackLog& log) { return grow_tips(e, log); };
  e.facets.follow(e.mechanics->follow_facets(e.facets.start(), e.facets.rock_weight(), std::move(rules)));
}

// Slots in the walls of holes, to either side, cut into rock at rest.
void perforate(Engine& e, const std::vector<WellOptions>& wells) {
  const Options& o = e.options;
  const auto places = e.model.well_places();
  for (std::size_t w = 0; w < places.size(); ++w) {
    const bool own = wells[w].perforation_length > 0.0;
    const double length = own ? wells[w].perforation_length : o.fracture_perforation_length,
                 azimuth = own ? wells[w].perforation_azimuth : o.fracture_perforation_azimuth;
    if (length <= 0.0) continue;
    const Vec2 way{std::cos(azimuth), std::sin(azimuth)};
    for (const double side : {1.0, -1.0})
      for (const auto bond :
           perforation(e.facets, e.model.assembly, e.model.network, places[w], side * way, length))
        if (e.model.assembly.intact[bond] != 0) {
          e.facets.cut(bond);
          e.mechanics->break_bond(bond, e.model.cracks);
          e.model.cracks.back().mode = CrackMode::tension;
        }
  }
}

// Far from any equilibrium: not short of the wanted accuracy, which a warning tells.
void require_some_rest(const Engine& e, const ExplicitSolver::Outcome& outcome, double share) {
  if (outcome.at_rest || outcome.force_ratio <= farthest_from_rest) return;
  const Options& o = e.options;
  throw Error(
      ErrorKind::collapsed,
      "the rock does not come to rest under the far field: at " + rounded_text(100.0 * share) +
          " % of it the unbalanced-force ratio stayed at " + rounded_text(outcome.force_ratio) + ", above " +
          rounded_text(farthest_from_rest) +
          ", where pieces move freely; raise bond.tensile_strength and bond.shear_strength, make holes "
          "smaller or lie farther apart, lower the stresses, or raise stepping.max_cycles = " +
          number_text(o.stepping_max_cycles) + " if it was still slowing down");
}

// Far field and formation pressure in stages, together: at every stage effective stresses are a share of the final ones.
// Pores are drained, so breakage here is the far field's doing alone. Under stress control the quasi-static solver finds each stage's
// equilibrium and breaks bonds in order, the farthest beyond its strength first; damped motion, which can shake more loose than the
// load breaks, serves the explicit solver, walls, and stages that have no equilibrium near.
void load_in_stages(Engine& e, const std::vector<double>& pressure, const Progress& progress) {
  const Options& o = e.options;
  Model& m = e.model;
  Network& network = m.network;
  constexpr int stages = 10;
  std::unique_ptr<EquilibriumSolver> rest;
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static && !e.boundary->walled()) {
    network.stiffness.assign(network.stiffness.size(), 0.0);  // pressures are given
    rest = std::make_unique<EquilibriumSolver>(m, e.facets, *e.boundary, *e.mechanics, o, *e.workers);
  }
  const std::size_t cracks_before = m.cracks.size();
  ExplicitSolver::Outcome outcome;
  const auto load = [&](double share) {
    const bool last = share == 1.0;
    e.boundary->set_load(m.assembly, share);
    for (std::size_t d = 0; d < pressure.size(); ++d) m.network.pressure[d] = share * pressure[d];
    bool stop = false;
    const auto asked = [&] {
      require_rock_stands(e, cracks_before, share);
      return stop = progress &&
                    progress(0.5 + 0.5 * (share - 1.0 / stages), "finding equilibrium under the far field");
    };
    bool found = false;
    if (rest) {
      std::vector<std::byte> before;
      save_state(e, before);
      const auto solved = rest->solve(0.0, {}, std::numeric_limits<double>::infinity(), m.cracks, asked);
      found = solved.end == EquilibriumSolver::End::rest;
      outcome.force_ratio = solved.force_ratio;
      outcome.at_rest = found;
      if (found) {
        e.mechanics->search_contacts(m.cracks);
      } else if (!stop) {
        load_state(e, before);
        // The boundary keeps the whole load and its share, also of the pressure outside.
        m.network.pressure[0] = pressure[0];
        e.boundary->restore_load(m.assembly, m.network, m.far_field.sigma_Hmax, m.far_field.sigma_hmin);
        m.network.pressure[0] = share * pressure[0];
      }
    }
    if (!found && !stop)
      outcome = e.mechanics->relax(last ? o.stepping_force_ratio : 1e-2,
                                   (last ? 20 : 1) * o.stepping_max_cycles, m.cracks, asked);
    if (stop) throw Stopped{};
    require_rock_stands(e, cracks_before, share);
    if (last) require_some_rest(e, outcome, share);
  };
  // Joints that conduct are held, then let go (frac/joint_stress.hpp).
  const bool natural = !network.joint_pore.empty();
  m.assembly.smooth.held = natural;
  for (int stage = 1; stage <= stages; ++stage) load(static_cast<double>(stage) / stages);
  if (natural) {
    settle_smooth(m.assembly, stress_on_joints(m, o, e.boundary->walled()));
    m.assembly.smooth.held = false;
    load(1.0);
  }
  m.clock.force_ratio = outcome.force_ratio;
  m.clock.at_rest = outcome.at_rest;
}

}  // namespace

void equilibrate(Engine& e, const Progress& progress, SetupReport& report, const PackedModel* at_rest) {
  const Options& o = e.options;
  Model& m = e.model;
  const std::vector<double> pressure = initial_pressures(e);
  if (progress && progress(0.5, "finding equilibrium under the far field")) throw Stopped{};
  e.mechanics->use_scaled_masses();
  e.mechanics->set_damping(std::max(0.3, o.stepping_damping));
  e.mechanics->set_undrained(false);
  e.mechanics->hold_edge(!e.boundary->walled());
  const std::size_t cracks_before = m.cracks.size();
  if (at_rest != nullptr)
    load_rest(e, *at_rest, pressure);
  else
    load_in_stages(e, pressure, progress);
  // The quasi-static solver needs an equilibrium afterwards, too.
  if (SolverKind{o.solver_kind} != SolverKind::quasi_static) e.mechanics->hold_edge(false);
  require_joints_in_reach(e);
  report.force_ratio = m.clock.force_ratio;
  report.cracks = static_cast<std::int64_t>(m.cracks.size());
  report.broken_joints = static_cast<std::int64_t>(cracks_before);
  if (WallsAfterEquilibration{o.boundary_walls_after_equilibration} == WallsAfterEquilibration::fixed)
    e.boundary->fix_walls();
  e.mechanics->stop_motion();
  e.mechanics->set_damping(o.stepping_damping);
}

double begin_run(Engine& e, const std::vector<WellOptions>& wells, SetupReport& report) {
  const Options& o = e.options;
  Model& m = e.model;
  Network& n = m.network;
  m.start.x = m.assembly.ux;
  m.start.y = m.assembly.uy;
  m.start.rotation = m.assembly.rotation;
  e.mechanics->evaluate();  // volumes and forces where they came to rest
  const bool wet = e.wet();
  for (std::int64_t d = 0; d < n.domain_count(); ++d) {
    n.content[d] = content_at(n, d, o.fluid_bulk_modulus, n.pressure[d]);
    const bool imposed = n.kind[d] == DomainKind::outside;
    n.stiffness[d] = wet && !imposed ? o.fluid_bulk_modulus / n.storing[d] : 0.0;
  }
  if (wet) e.source.assign(static_cast<std::size_t>(n.domain_count()), 0.0);
  for (auto& well : m.wells) {
    n.stiffness[well.place.domain] = 0.0;
    well.content = n.content[well.place.domain];
  }
  double oda_matrix = 1.0;
  if (wet) {
    std::vector<double> pressure;
    const Array<double> joints =
        std::exchange(n.joint_length, {});  // it is the rock between them that is measured
    calibrate_aperture(n, m.assembly, o, wells, pressure);
    report.permeability = measure_permeability(n, m.assembly, wells, o.fluid_viscosity, pressure);
    put_rock_beyond_pipes(e, report.permeability);
    give_back(pressure);
    const double uniform = uniform_gradient_permeability(m.assembly, n, o.fluid_viscosity);
    if (uniform > 0.0 && report.permeability > 0.0) oda_matrix = report.permeability / uniform;
    if (!joints.empty()) {
      n.joint_length = joints;
      update_apertures(n, m.assembly, o);
    }
    if (o.fluid_second_viscosity > 0.0) {
      n.second_content.assign(static_cast<std::size_t>(n.domain_count()), 0.0);
      e.second_fluid = std::make_unique<SecondFluid>(n);
      e.inlets.reserve(m.wells.size());
    }
    if (e.heat && FluidKind{o.fluid_kind} == FluidKind::water) {
      e.water = std::make_unique<WaterInPores>(m.assembly, n, o);
      e.mechanics->refresh_stiffness();  // for water at its stiffest
    }
    if (e.second_fluid || e.water) n.viscosity_share.assign(n.left.size(), 1.0);
    e.flow = std::make_unique<FlowSolver>(n, o, &m.wellbores, e.mechanics->shared_tiles().ranks(),
                                          e.workers.get(), e.device.get());
    e.mechanics->set_undrained(true);
  }
  if (wet) m.increment.pressure_rate.assign(static_cast<std::size_t>(n.domain_count()), 0.0);
  if (SolverKind{o.solver_kind} == SolverKind::quasi_static)
    e.equilibrium =
        std::make_unique<EquilibriumSolver>(m, e.facets, *e.boundary, *e.mechanics, o, *e.workers);
  if (FractureLaw{o.fracture_law} == FractureLaw::facet) {
    begin_facets(e);
    if (!e.equilibrium) move_facets(e);
    perforate(e, wells);
    e.facets.update(m.assembly, m.network);
    if (!e.equilibrium) update_geometry(e);
  }
  log_slips(m, 0, m.clock.time, 0.0);
  begin_ledger(e);
  if (SteppingMode{o.stepping_mode} == SteppingMode::dynamic) e.mechanics->use_real_masses();
  auto& smooth = m.assembly.smooth;
  for (std::size_t k = 0; k < smooth.contacts.size(); ++k)
    smooth.counted[k].before = m.assembly.slip[smooth.contacts[k].bond];
  return oda_matrix;
}

}  // namespace hfrac
