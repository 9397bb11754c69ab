// SPDX-License-Identifier: BSD-3-Clause
#include "step/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/water.hpp"
#include "options/choices.hpp"
#include "options/fracture_law.hpp"
#include "options/model_size.hpp"
#include "step/alike.hpp"
#include "step/checks.hpp"
#include "step/device_choice.hpp"
#include "step/exterior_rock.hpp"
#include "step/image.hpp"
#include "step/initial_equilibration.hpp"
#include "step/packed_state.hpp"
#include "step/rock_block.hpp"
#include "step/snapshot.hpp"
#include "step/stages.hpp"

namespace hfrac {
namespace {

// Water of the formation: what the rest of the engine takes as the fluid's viscosity, density and bulk modulus.
void resolve_fluid(Options& o) {
  if (FluidKind{o.fluid_kind} != FluidKind::water) return;
  o.thermal_fluid_density = water_density(o.thermal_rock_temperature, o.fluid_formation_pressure);
  o.fluid_viscosity = water_viscosity(o.thermal_rock_temperature, o.thermal_fluid_density);
  o.fluid_bulk_modulus = water_bulk_modulus(o.thermal_rock_temperature, o.fluid_formation_pressure);
}

// Law facet judges tips by E', which is the packing's own unless it is given.
bool wants_plane_modulus(const Options& o) {
  return FractureLaw{o.fracture_law} == FractureLaw::facet && o.bond_fracture_toughness > 0.0 &&
         o.fracture_plane_modulus == 0.0;
}

void require_memory(const CaseDefinition& definition, std::int64_t discs, const Ranks& ranks) {
  const std::string why = why_no_memory(definition, discs, ranks.alone(), machine_memory());
  if (!why.empty()) throw Error(ErrorKind::memory, why);
}

// Solvers from outside the library come with the ranks.
void require_solvers(const Options& o, const Ranks& ranks) {
  const bool flow = FlowMatrixSolver{o.flow_solver} == FlowMatrixSolver::petsc &&
                    FlowScheme{o.flow_scheme} == FlowScheme::implicit_scheme,
             factor = FactorOf{o.solver_factor} == FactorOf::petsc;
  if (ranks.solver() != nullptr || !(flow || factor)) return;
  throw Error(
      ErrorKind::model,
      std::string(flow ? "flow.solver" : "solver.factor") +
          " = \"petsc\" needs PETSc, and this simulation was created without: install petsc-dev, build "
          "hfrac there (it makes libhfrac_petsc), and run by 'hfrac run' or 'mpirun -n N hfrac run'; a "
          "program gives hfrac_exchange::linear_solver by hfrac_petsc_solver. Or use " +
          (flow ? "flow.solver = \"auto\"." : "solver.factor = \"own\"."));
}

}  // namespace

// What a simulation is built of beside its definition, and what is kept of it on the way.
struct Simulation::Parts {
  std::span<const double> discs;
  std::span<const std::int64_t> bonds;
  const PackedModel* from = nullptr;
  PackedModel* kept = nullptr;
};

// As far as the model at rest.
Simulation::Simulation(CaseDefinition definition, const Progress& progress, const Ranks& ranks,
                       const Parts& parts)
    : definition_(std::move(definition)), given_(definition_.options) {
  validate(definition_, parts.discs, parts.bonds);
  require_memory(definition_, disc_count_of(options(), parts.discs), ranks);
  require_solvers(options(), ranks);
  definition_.options.fracture_law = static_cast<std::int64_t>(fracture_law_of(definition_));
  if (parts.from != nullptr) require_fit(*parts.from, definition_);
  if (parts.kept != nullptr) parts.kept->take_definition(definition_);
  resolve_fluid(definition_.options);
  set_stop(options().stop_extent_fraction, options().stop_cracks);
  auto device = device_for(definition_, ranks.size(), setup_.why_no_device);
  if (device) setup_.device = device->name();
  Packing packing = take_discs(definition_, parts.discs, progress, setup_,
                               parts.from != nullptr ? &parts.from->packing : nullptr, ranks);
  const auto bonds = parts.from != nullptr ? std::span<const std::int64_t>(parts.from->bonds) : parts.bonds;
  if (progress && progress(0.5, "bonding")) throw Stopped{};
  if (parts.kept != nullptr) {
    parts.kept->packing = packing;
    parts.kept->bonds.assign(bonds.begin(), bonds.end());
  }
  const bool discs_alone = PackingReuse{options().packing_reuse} == PackingReuse::discs;
  const PackedModel* at_rest = discs_alone ? nullptr : parts.from;
  const bool infinite = BoundaryKind{options().boundary_kind} == BoundaryKind::infinite,
             judged = wants_plane_modulus(options());
  RockAtRest rock = at_rest != nullptr ? at_rest->rock : RockAtRest{};
  std::optional<RockBlock> block;
  if (at_rest == nullptr && (infinite || judged)) block.emplace(definition_, packing, ranks);
  model_ = build_model(definition_, std::move(packing), bonds, setup_);
  engine_ = std::make_unique<Engine>(options(), model_, ranks, std::move(device));
  if (infinite) begin_exterior(*engine_, block ? &*block : nullptr, rock, setup_);
  if (judged) {
    if (block) rock.modulus = block->measure().modulus;
    definition_.options.fracture_plane_modulus = rock.modulus;
  }
  setup_.plane_modulus = options().fracture_plane_modulus;
  block.reset();
  equilibrate(*engine_, progress, setup_, at_rest);
  if (parts.kept != nullptr) {
    parts.kept->rock = std::move(rock);
    keep_rest(*engine_, *parts.kept);
  }
}

Simulation::Simulation(CaseDefinition definition, std::span<const double> given_discs,
                       const Progress& progress, std::span<const std::int64_t> given_bonds,
                       const Ranks& ranks, const PackedModel* packed)
    : Simulation(std::move(definition), progress, ranks, {given_discs, given_bonds, packed, nullptr}) {
  oda_matrix_ = begin_run(*engine_, definition_.wells, setup_);
  loads_ = loads_of(model_);
  engine_->mechanics->let_state_stay();
  fingerprint_ = fingerprint_of(*engine_, setup_);
  return_unused_pages();
  setup_.setup_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

PackedModel Simulation::pack(CaseDefinition definition, std::span<const double> given_discs,
                             const Progress& progress, std::span<const std::int64_t> given_bonds,
                             const PackedModel* packed) {
  PackedModel kept;
  // Nothing flows yet, and PETSc's factor and the library's find the same rest.
  definition.options.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::automatic);
  definition.options.solver_factor = static_cast<std::int64_t>(FactorOf::own);
  const Simulation at_rest(std::move(definition), progress, {}, {given_discs, given_bonds, packed, &kept});
  return kept;
}

CaseDefinition Simulation::given_definition() const {
  CaseDefinition given = definition_;
  given.options = given_;
  return given;
}

void Simulation::take_well(const Well& well) {
  as_opened_ = false;
  model_.wells.push_back(well);
  loads_.wells.push_back({well.drive, well.schedule});
  if (model_.heat) {
    model_.heat->well.push_back(options().thermal_fluid_temperature);
    loads_.well_temperature.push_back(options().thermal_fluid_temperature);
  }
  engine_->take_wells();
}

StepOutcome Simulation::step(const Loads& loads, double duration, const Interrupt& interrupt) {
  require_same_step(engine_->ranks, model_, loads, duration);
  return take_step(loads, duration, interrupt);
}

StepOutcome Simulation::take_step(const Loads& loads, double duration, const Interrupt& interrupt) {
  Engine& e = *engine_;
  const bool as_opened = as_opened_ && loads == loads_;
  impose(loads);
  // What a device keeps a copy of is as an open step began, until that is closed.
  if (!step_open_)
    save_before_step(e, before_step_);
  else if (!as_opened)
    save_state(e, before_step_);
  const auto go_back = [&] {
    if (!step_open_)
      load_before_step(e, before_step_);
    else if (!as_opened)
      load_state(e, before_step_);
    else
      load_before_step(e, opened_);
    as_opened_ = as_opened;
  };
  note_places(e);
  try {
    // What a step does follows from the state alone, so no factor outlives the step before.
    if (e.equilibrium) e.equilibrium->begin_step();
    const StepOutcome outcome = stepper_of(options())(e, duration, interrupt);
    if (!outcome.stopped) return outcome;
    go_back();
    return {true, model_.clock.at_rest};
  } catch (const Error& error) {
    // A solver that could not go on may not know which number kept it from it.
    const std::string what = error.kind() == ErrorKind::diverged ? not_finite(e) : std::string();
    go_back();
    if (!what.empty()) throw Error(ErrorKind::diverged, what);
    throw;
  } catch (...) {
    go_back();
    throw;
  }
}

double Simulation::next_step() const {
  double step = options().stepping_flow_step;
  for (const auto& well : model_.wells) {
    for (auto k = static_cast<std::size_t>(well.next); k < well.schedule.size(); ++k) {
      if (!is_due(*engine_, well.schedule[k])) {
        step = std::min(step, well.schedule[k].time - model_.clock.time);
        break;
      }
    }
  }
  return step;
}

StopReason Simulation::stop_reason() const {
  const Options& o = options();
  if (model_.clock.tip_distance > stop_extent_fraction_ * std::min(o.model_width, o.model_height))
    return StopReason::extent;
  if (stop_cracks_ > 0 && static_cast<std::int64_t>(model_.cracks.size()) >= stop_cracks_)
    return StopReason::cracks;
  return StopReason::target;
}

void Simulation::set_stop(double extent_fraction, std::int64_t cracks) {
  stop_extent_fraction_ = extent_fraction;
  stop_cracks_ = cracks;
}

void Simulation::begin_step() {
  step_open_ = as_opened_ = false;
  save_before_step(*engine_, opened_);
  opened_loads_ = loads_;
  opened_logs_.reset();
  step_open_ = as_opened_ = true;
}

// Back to where the step was opened.
void Simulation::reopen() {
  require_open_step();
  if (opened_logs_) std::tie(model_.cracks, model_.slips) = *opened_logs_;
  load_before_step(*engine_, opened_);
  loads_ = opened_loads_;
  as_opened_ = true;
}

void Simulation::require_open_step() const {
  if (!step_open_) throw Error(ErrorKind::argument, "no step is open; begin one first.");
}

StepOutcome Simulation::try_step(double duration, const Interrupt& interrupt) {
  require_open_step();
  const Loads wanted = loads_;
  require_same_step(engine_->ranks, model_, wanted, duration);
  if (!as_opened_) reopen();
  return take_step(wanted, duration, interrupt);
}

void Simulation::accept_step() {
  require_open_step();
  step_open_ = as_opened_ = false;
}

void Simulation::reject_step() {
  reopen();
  step_open_ = as_opened_ = false;
}

std::size_t Simulation::image_size() const {
  return hfrac::image_size(*engine_);
}

void Simulation::write_image(std::span<std::byte> image) const {
  hfrac::write_image(*engine_, fingerprint_, image);
}

void Simulation::restore(std::span<const std::byte> image) {
  // What is kept of an open step has no more than the lengths of the logs.
  as_opened_ = false;
  if (step_open_ && !opened_logs_) opened_logs_.emplace(model_.cracks, model_.slips);
  restore_image(*engine_, fingerprint_, image);
  loads_ = loads_of(model_);
}

std::uint64_t Simulation::state_hash() const {
  return hash_of_state(*engine_);
}

std::vector<Fracture> Simulation::fractures() {
  bring_home();
  return find_fractures(model_.assembly, model_.network, options(), model_.well_places(), model_.cracks,
                        &engine_->facets);
}

std::vector<FracturePoint> Simulation::fracture_line(std::int32_t fracture) const {
  bring_home();
  return hfrac::fracture_line(model_.assembly, model_.network, options(), model_.well_places(), model_.cracks,
                              fracture);
}

void Simulation::set_grid(HostGrid grid) {
  grid.lay_over(model_.assembly, model_.network);
  grid_ = std::move(grid);
}

const HostGrid& Simulation::grid() const {
  if (!grid_) throw Error(ErrorKind::argument, "this simulation has no host grid; set one first.");
  return *grid_;
}

}  // namespace hfrac
