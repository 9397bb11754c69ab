// SPDX-License-Identifier: BSD-3-Clause
// A simulation's life from C: create, step, ask how it stands, destroy.
#include "hfrac/sim.h"

#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "def_image.hpp"
#include "def_lists.hpp"
#include "internal.hpp"
#include "messages.hpp"
#include "model_file.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"
#include "sim_handle.hpp"
#include "step/added_well.hpp"
#include "step/alike.hpp"
#include "step/impose.hpp"
#include "step/simulation.hpp"
#include "step/step_limits.hpp"
#include "stepping.hpp"

using namespace hfrac;
using namespace hfrac::capi;

hfrac_sim::hfrac_sim() = default;
hfrac_sim::~hfrac_sim() = default;

void* hfrac_sim::operator new(std::size_t size) {
  void* const place = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::bad_alloc();
  return place;
}

void hfrac_sim::operator delete(void* place, std::size_t size) {
  ::madvise(place, size, MADV_DONTNEED);
}

namespace {

// One step of a longer call, `duration` seconds long; `fraction` of that call is done when it begins.
std::int32_t take_step(hfrac_sim& sim, ProgressPoll& poll, double fraction, double duration) {
  const Simulation& s = *sim.simulation;
  const std::size_t cracks_before = s.cracks().size();
  ++sim.epoch;
  const auto outcome = together(sim, [&] {
    return sim.simulation->step(sim.simulation->loads(), duration,
                                [&] { return poll.stop(fraction, "stepping"); });
  });
  ++sim.epoch;  // a callback may have looked at the middle of the step
  if (outcome.stopped) return HFRAC_STOPPED;
  tell_step(sim, cracks_before);
  const auto asks_to_stop = [&] {
    return sim.on_step != nullptr &&
           call_host(&sim, [&] {
             return sim.on_step(sim.on_step_user, &sim, s.engine_as_is().model.clock.step, s.time());
           }) != 0;
  };
  if (sim.ranks.any(together(sim, asks_to_stop))) return HFRAC_STOPPED;
  return outcome.at_rest ? HFRAC_OK : HFRAC_NOT_AT_REST;
}

// The duration that brings the clock from `time` to `end` by an addition that rounds.
double duration_to(double time, double end) {
  double duration = end - time;
  while (time + duration < end) duration = std::nextafter(duration, HUGE_VAL);
  while (time + duration > end) duration = std::nextafter(duration, 0.0);
  return duration;
}

// Of the next step on the way to `target`. Whole steps miss a time they add up to by rounding, so one that ends within a millionth
// of a step of the target ends at it; `exact`: so does one that would pass it.
double duration_towards(const Simulation& s, double target, bool exact) {
  const double whole = s.next_step(), after = s.time() + whole;
  const double slack = 1e-6 * s.options().stepping_flow_step;
  const bool at_target = exact ? after > target - slack : after < target && after >= target - slack;
  return at_target ? duration_to(s.time(), target) : whole;
}

std::int32_t advance(hfrac_sim& sim, double target, bool exact, double& reached, std::int32_t& reason) {
  const Simulation& s = *sim.simulation;
  const double start = s.time();
  ProgressPoll poll(sim, sim.progress, sim.progress_user, sim.progress_seconds);
  std::int32_t status = HFRAC_OK;
  reached = start;
  reason = HFRAC_REASON_TARGET;
  while (s.time() < target) {
    reason = static_cast<std::int32_t>(s.stop_reason());
    if (reason != HFRAC_REASON_TARGET) return HFRAC_STOP_CONDITION;
    const double fraction = (s.time() - start) / (target - start);
    const bool stopped = poll.stop(fraction, "stepping") ||
                         take_step(sim, poll, fraction, duration_towards(s, target, exact)) == HFRAC_STOPPED;
    reached = s.time();
    if (stopped) {
      reason = HFRAC_REASON_CALLBACK;
      return HFRAC_STOPPED;
    }
    if (!s.engine_as_is().model.clock.at_rest) status = HFRAC_NOT_AT_REST;
  }
  return status;
}

Well const& well_at(const hfrac_sim& sim, std::int32_t index) {
  const auto& wells = sim.simulation->wells();
  if (index < 0 || static_cast<std::size_t>(index) >= wells.size()) {
    throw Error(ErrorKind::argument, "well " + std::to_string(index) + " is not there: this simulation has " +
                                         std::to_string(wells.size()) + " wells, counted from 0.");
  }
  return wells[static_cast<std::size_t>(index)];
}

// The range the option table gives for a well's value.
void require_in_range(const char* name, double value) {
  WellOptions any;
  set_real(any, *find_well_option(name), name, value);
}

void tell_well(const hfrac_sim& sim, std::int32_t index, const std::string& what) {
  tell(sim, HFRAC_LOG_INFO, "well " + std::to_string(index) + ": " + what);
}

void require_finite(double value, const char* name) {
  if (!std::isfinite(value)) throw Error(ErrorKind::argument, std::string(name) + " is not a finite number.");
}

}  // namespace

std::int32_t hfrac::capi::create(const hfrac_sim_def* def, const hfrac_exchange& exchange, hfrac_sim** sim) {
  require_not_null(sim, "sim");
  *sim = nullptr;
  const hfrac_sim_def full = read_def(def);
  auto handle = std::make_unique<hfrac_sim>();
  handle->exchange = exchange;
  if (exchange.size > 1 || exchange.linear_solver != nullptr) handle->ranks = ranks_of(*handle);
  handle->listener = listener_of(full.log, full.log_user, full.log_level);
  ProgressPoll poll(*handle, full.progress, full.progress_user, 0.05);
  const char* stage = "";
  try {
    const auto progress = [&](double done, const char* what) {
      if (what != stage) tell(*handle, HFRAC_LOG_INFO, stage = what);
      return poll.stop(done, what);
    };
    handle->simulation = together(*handle, [&] {
      CaseDefinition definition;
      all_or_none(handle->ranks,
                  Error(ErrorKind::argument,
                        "another rank was given a definition that is refused there; give all the same."),
                  [&] {
                    definition = case_of(full);
                    static_cast<void>(given_discs_of(full));
                    static_cast<void>(given_bonds_of(full));
                  });
      require_same_definition(handle->ranks, definition, given_discs_of(full), given_bonds_of(full));
      const auto packed = packed_model_of(definition, full.given_disc_count > 0, handle->ranks);
      return std::make_unique<Simulation>(std::move(definition), given_discs_of(full), progress,
                                          given_bonds_of(full), handle->ranks, packed ? &*packed : nullptr);
    });
  } catch (const Stopped&) {
    return HFRAC_STOPPED;
  } catch (const Error& error) {
    tell(*handle, HFRAC_LOG_ERROR, error.what());
    throw;
  }
  tell_setup(*handle);
  handle->listener = {};
  *sim = handle.release();
  return HFRAC_OK;
}

int32_t hfrac_sim_create(const hfrac_sim_def* def, hfrac_sim** sim) {
  return guarded([&] { return create(def, hfrac_exchange{}, sim); });
}

int32_t hfrac_sim_destroy(hfrac_sim** sim) {
  return guarded([&] {
    if (sim == nullptr || *sim == nullptr) return;
    require_handle(*sim);
    Occupancy inside(**sim);
    if ((*sim)->in_callback) {
      throw Error(
          ErrorKind::busy,
          "a simulation cannot be destroyed from inside its own callback; return nonzero to stop it first.");
    }
    inside.give_up();
    delete *sim;
    *sim = nullptr;
  });
}

int32_t hfrac_sim_definition(const hfrac_sim* sim, hfrac_sim_def* def) {
  return guarded_sim(sim, [&] {
    const hfrac_sim_def given = read_def(def);
    hfrac_sim_def full = default_def();
    full.lists = given.lists;
    each_list([&](auto list) { list.size(full) = list.size(given); });
    write_case(def, sim->simulation->given_definition(), full, "hfrac_sim_def");
  });
}

int32_t hfrac_step(hfrac_sim* sim, int64_t count) {
  return guarded_sim(sim, [&]() -> std::int32_t {
    if (count < 0)
      throw Error(ErrorKind::argument,
                  "count = " + std::to_string(count) + " is negative; give 0 or more steps.");
    require_no_open_step(*sim);
    ProgressPoll poll(*sim, sim->progress, sim->progress_user, sim->progress_seconds);
    std::int32_t status = HFRAC_OK;
    for (std::int64_t k = 0; k < count; ++k) {
      const double fraction = static_cast<double>(k) / static_cast<double>(count);
      if (poll.stop(fraction, "stepping")) return HFRAC_STOPPED;
      status = take_step(*sim, poll, fraction, sim->simulation->next_step());
      if (status == HFRAC_STOPPED) return status;
    }
    const bool at_stop = sim->simulation->stop_reason() != StopReason::target;
    return at_stop ? HFRAC_STOP_CONDITION : status;
  });
}

int32_t hfrac_advance(hfrac_sim* sim, double target, double* reached, int32_t* reason) {
  return guarded_sim(sim, [&] {
    require_finite(target, "target");
    require_not_null(reached, "reached");
    require_not_null(reason, "reason");
    require_no_open_step(*sim);
    return advance(*sim, target, false, *reached, *reason);
  });
}

int32_t hfrac_advance_to(hfrac_sim* sim, double target, double* reached, int32_t* reason) {
  return guarded_sim(sim, [&] {
    require_finite(target, "target");
    require_not_null(reached, "reached");
    require_not_null(reason, "reason");
    require_no_open_step(*sim);
    const double now = sim->simulation->time();
    if (target < now) {
      throw Error(ErrorKind::argument, "target = " + number_text(target) +
                                           " s lies before the model's time, " + number_text(now) +
                                           " s; give that or more.");
    }
    return advance(*sim, target, true, *reached, *reason);
  });
}

int32_t hfrac_set_stop(hfrac_sim* sim, double extent_fraction, int64_t cracks) {
  return guarded_sim(sim, [&] {
    Options any;  // the ranges of the option table
    set_real(any, *find_option("stop.extent_fraction"), "extent_fraction", extent_fraction);
    set_integer(any, *find_option("stop.cracks"), "cracks", cracks);
    sim->simulation->set_stop(extent_fraction, cracks);
  });
}

int32_t hfrac_set_progress(hfrac_sim* sim, hfrac_progress_fn progress, void* user, double seconds) {
  return guarded_sim(sim, [&] {
    require_finite(seconds, "seconds");
    sim->progress = progress;
    sim->progress_user = user;
    sim->progress_seconds = seconds;
  });
}

int32_t hfrac_set_on_step(hfrac_sim* sim, hfrac_step_fn on_step, void* user) {
  return guarded_sim(sim, [&] {
    sim->on_step = on_step;
    sim->on_step_user = user;
  });
}

int32_t hfrac_set_log(hfrac_sim* sim, hfrac_log_fn log, void* user, int32_t level) {
  return guarded_sim(sim, [&] { sim->listener = listener_of(log, user, level); });
}

int32_t hfrac_sim_get_state(const hfrac_sim* sim, hfrac_sim_state* state) {
  return guarded_sim(sim, [&] {
    const Simulation& s = *sim->simulation;
    const Clock& clock = s.engine_as_is().model.clock;
    hfrac_sim_state full{};
    full.at_rest = clock.at_rest ? 1 : 0;
    full.time = clock.time;
    full.step = clock.step;
    full.cycles = clock.cycles;
    full.force_ratio = clock.force_ratio;
    for (const auto& crack : s.cracks()) {
      ++full.crack_count;
      ++(crack.mode == CrackMode::tension ? full.tensile_cracks : full.shear_cracks);
    }
    full.equilibration_cracks = s.setup().cracks;
    full.disc_count = s.engine_as_is().model.assembly.disc_count();
    full.bond_count = s.engine_as_is().model.assembly.bond_count();
    full.domain_count = s.network().domain_count();
    full.mechanical_step = s.engine_as_is().mechanics->real_step();
    full.tip_distance = clock.tip_distance;
    full.stop_reason = static_cast<std::int32_t>(s.stop_reason());
    full.flow_subcycles = clock.flow_rounds;
    full.sigma_Hmax = s.loads().sigma_Hmax;
    full.sigma_hmin = s.loads().sigma_hmin;
    full.formation_pressure = s.loads().formation_pressure;
    write_struct(state, full, "hfrac_sim_state");
  });
}

int32_t hfrac_sim_get_setup(const hfrac_sim* sim, hfrac_setup_report* report) {
  return guarded_sim(sim, [&] {
    const Simulation& s = *sim->simulation;
    const SetupReport& setup = s.setup();
    hfrac_setup_report full{};
    full.mean_radius = s.engine_as_is().model.assembly.mean_radius;
    full.porosity = setup.porosity;
    full.packing_residual = setup.packing_residual;
    full.coordination = setup.coordination;
    full.packed_discs = setup.packed;
    full.removed_in_wells = setup.removed_in_wells;
    full.removed_floaters = setup.removed_floaters;
    full.removed_crossings = setup.removed_crossings;
    full.strength_factor = s.engine_as_is().model.assembly.strength_factor;
    full.zero_stress_aperture = s.network().zero_stress_aperture;
    full.permeability = setup.permeability;
    full.equilibration_force_ratio = setup.force_ratio;
    full.packing_seconds = setup.packing_seconds;
    full.setup_seconds = setup.setup_seconds;
    full.coarsest_radius = setup.coarsest_radius;
    full.fine_discs = setup.fine_discs;
    full.exterior_modulus = setup.exterior_modulus;
    full.exterior_poisson_ratio = setup.exterior_poisson_ratio;
    full.plane_modulus = setup.plane_modulus;
    write_struct(report, full, "hfrac_setup_report");
  });
}

int32_t hfrac_get_balance(const hfrac_sim* sim, hfrac_balance* balance) {
  return guarded_sim(sim, [&] {
    const Balance b = sim->simulation->balance();
    hfrac_balance full{};
    full.kinetic = b.kinetic;
    full.bond_elastic = b.bond_elastic;
    full.contact_elastic = b.contact_elastic;
    full.fluid_work = b.fluid_work;
    full.boundary_work = b.boundary_work;
    full.friction = b.friction;
    full.damping = b.damping;
    full.fracture = b.fracture;
    full.energy_error = b.energy_error;
    full.energy_checked = b.energy_checked ? 1 : 0;
    full.injected_volume = b.injected;
    full.stored_volume = b.stored;
    full.leaked_volume = b.leaked;
    full.fluid_error = b.fluid_error;
    full.host_volume = b.host;
    write_struct(balance, full, "hfrac_balance");
  });
}

int32_t hfrac_sim_get_solver(const hfrac_sim* sim, hfrac_solver_report* report) {
  return guarded_sim(sim, [&] {
    const Simulation& s = *sim->simulation;
    const SolverWork& work = s.engine_as_is().model.work;
    hfrac_solver_report full{};
    full.kind = static_cast<std::int32_t>(s.options().solver_kind);
    full.increment = s.engine_as_is().model.increment.length;
    full.increments = work.increments;
    full.rounds = work.rounds;
    full.newton_iterations = work.newton;
    full.linear_iterations = work.krylov;
    full.factors = work.factors;
    full.rejected_error = work.rejected_error;
    full.rejected_strength = work.rejected_strength;
    full.rejected_divergence = work.rejected_divergence;
    write_struct(report, full, "hfrac_solver_report");
  });
}

int32_t hfrac_get_step_limits(const hfrac_sim* sim, hfrac_step_limits* limits) {
  return guarded_sim(sim, [&] {
    const Simulation& s = *sim->simulation;
    const StepLimits from = step_limits(s);
    hfrac_step_limits full{};
    full.flow_step = from.flow_step;
    full.mechanical_step = from.mechanical_step;
    full.explicit_step = from.explicit_step;
    full.binding = static_cast<std::int32_t>(from.binding);
    write_struct(limits, full, "hfrac_step_limits");
  });
}

int32_t hfrac_wall_count(const hfrac_sim* sim, int32_t* count) {
  return guarded_sim(sim, [&] {
    require_not_null(count, "count");
    *count = sim->simulation->engine_as_is().boundary->walled() ? 4 : 0;
  });
}

int32_t hfrac_wall_get(const hfrac_sim* sim, int32_t index, hfrac_wall_state* state) {
  return guarded_sim(sim, [&] {
    const Simulation& s = *sim->simulation;
    const Boundary& boundary = *s.engine_as_is().boundary;
    if (index < 0 || index >= (boundary.walled() ? 4 : 0)) {
      throw Error(ErrorKind::argument,
                  "wall " + std::to_string(index) + " is not there: this simulation has " +
                      (boundary.walled() ? "walls 0 to 3." : "no walls (boundary.kind stress)."));
    }
    const auto number = static_cast<std::size_t>(index);
    const Wall& wall = boundary.walls()[number];
    hfrac_wall_state full{};
    full.moves = boundary.walls_move() ? 1 : 0;
    full.normal[0] = wall.inward.x;
    full.normal[1] = wall.inward.y;
    full.displacement = wall.displacement;
    full.position = boundary.wall_position(number);
    full.stress = boundary.wall_stress(s.assembly(), number);
    full.target = wall.target;
    full.disc_count = static_cast<std::int64_t>(wall.discs.size());
    write_struct(state, full, "hfrac_wall_state");
  });
}

int32_t hfrac_state_hash(const hfrac_sim* sim, int64_t* hash) {
  return guarded_sim(sim, [&] {
    require_not_null(hash, "hash");
    *hash = static_cast<std::int64_t>(sim->simulation->state_hash());
  });
}

int32_t hfrac_well_count(const hfrac_sim* sim, int32_t* count) {
  return guarded_sim(sim, [&] {
    require_not_null(count, "count");
    *count = static_cast<std::int32_t>(sim->simulation->wells().size());
  });
}

int32_t hfrac_well_get(const hfrac_sim* sim, int32_t index, hfrac_well_state* state) {
  return guarded_sim(sim, [&] {
    const Well& well = well_at(*sim, index);
    hfrac_well_state full{};
    full.control = static_cast<std::int32_t>(well.drive.control);
    full.x = well.place.centre.x;
    full.y = well.place.centre.y;
    full.equivalent_radius = well.place.equivalent_radius;
    full.pressure = sim->simulation->network().pressure[static_cast<std::size_t>(well.place.domain)];
    full.target_pressure = well.drive.target_pressure;
    full.rate = well.rate;
    full.injected_volume = well.injected;
    full.domain = well.place.domain;
    const Simulation& s = *sim->simulation;
    const auto& cut = s.definition().wells;  // the others were added later
    full.radius =
        static_cast<std::size_t>(index) < cut.size() ? cut[static_cast<std::size_t>(index)].radius : 0.0;
    full.wellbore_pressure = full.pressure;
    full.wellbore_rate = full.rate;
    if (well.wellbore >= 0) {
      const Wellbore& wellbore = s.engine_as_is().model.wellbores[static_cast<std::size_t>(well.wellbore)];
      full.wellbore_pressure = wellbore.pressure;
      full.wellbore_rate = wellbore.pump_rate;
    }
    const bool net = StressConvention{s.options().stress_convention} == StressConvention::effective;
    full.wellhead_pressure =
        full.wellbore_pressure + (net ? s.options().fluid_formation_pressure : 0.0) -
        (s.engine_as_is().model.drive_of(well).fluid == WellFluid::second ? well.second_head : well.head);
    full.fluid = static_cast<std::int64_t>(s.engine_as_is().model.drive_of(well).fluid);
    write_struct(state, full, "hfrac_well_state");
  });
}

int32_t hfrac_well_add(hfrac_sim* sim, double x, double y, int32_t* index) {
  return guarded_sim(sim, [&] {
    require_not_null(index, "index");
    require_not_between_tries(*sim, "further wells");
    *index = static_cast<std::int32_t>(add_well(*sim->simulation, {x, y}));
    ++sim->epoch;
    const Well& well = well_at(*sim, *index);
    tell_well(*sim, *index,
              "added in domain " + std::to_string(well.place.domain) + ", at (" +
                  number_text(well.place.centre.x) + ", " + number_text(well.place.centre.y) +
                  ") m, shut in");
  });
}

int32_t hfrac_well_set_pressure(hfrac_sim* sim, int32_t index, double pressure) {
  return guarded_sim(sim, [&] {
    well_at(*sim, index);
    require_in_range("pressure", pressure);
    set_well_pressure(*sim->simulation, static_cast<std::size_t>(index), pressure);
    ++sim->epoch;
    tell_well(*sim, index, "held at " + number_text(pressure) + " Pa");
  });
}

int32_t hfrac_well_set_ramp(hfrac_sim* sim, int32_t index, double pressure, double per_step) {
  return guarded_sim(sim, [&] {
    well_at(*sim, index);
    require_in_range("pressure", pressure);
    require_in_range("ramp_per_step", per_step);
    if (per_step <= 0.0)
      throw Error(ErrorKind::argument,
                  "per_step = " + std::to_string(per_step) + " must be positive, in Pa per step.");
    set_well_ramp(*sim->simulation, static_cast<std::size_t>(index), pressure, per_step);
    ++sim->epoch;
    tell_well(*sim, index,
              "ramped by " + number_text(per_step) + " Pa a step to " + number_text(pressure) + " Pa");
  });
}

int32_t hfrac_well_set_rate(hfrac_sim* sim, int32_t index, double rate) {
  return guarded_sim(sim, [&] {
    well_at(*sim, index);
    require_in_range("rate", rate);
    if (FlowScheme{sim->simulation->options().flow_scheme} == FlowScheme::off) {
      throw Error(ErrorKind::argument,
                  "a well cannot be driven at a rate with flow.scheme = \"off\"; use implicit or explicit.");
    }
    set_well_rate(*sim->simulation, static_cast<std::size_t>(index), rate);
    ++sim->epoch;
    tell_well(*sim, index, "takes " + number_text(rate) + " m2/s");
  });
}

int32_t hfrac_well_set_fluid(hfrac_sim* sim, int32_t index, int32_t fluid) {
  return guarded_sim(sim, [&] {
    well_at(*sim, index);
    if (fluid != HFRAC_WELL_FLUID_FIRST && fluid != HFRAC_WELL_FLUID_SECOND)
      throw Error(ErrorKind::argument,
                  "fluid = " + std::to_string(fluid) + " is none; it is 0 (first) or 1 (second).");
    set_well_fluid(*sim->simulation, static_cast<std::size_t>(index), WellFluid{fluid});
    ++sim->epoch;
    tell_well(*sim, index,
              fluid == HFRAC_WELL_FLUID_FIRST ? "pumps the first fluid" : "pumps the second fluid");
  });
}

int32_t hfrac_well_set_schedule(hfrac_sim* sim, int32_t index, int32_t count, const double* time,
                                const int32_t* control, const double* value) {
  return guarded_sim(sim, [&] {
    well_at(*sim, index);
    if (count < 0)
      throw Error(ErrorKind::argument,
                  "count = " + std::to_string(count) + " is negative; give 0 or more entries.");
    if (count > 0) {
      require_not_null(time, "time");
      require_not_null(control, "control");
      require_not_null(value, "value");
    }
    std::vector<ScheduleEntry> entries;
    for (std::int32_t k = 0; k < count; ++k) {
      const std::string name = "schedule[" + std::to_string(k) + "]";
      ScheduleEntry entry;
      set_integer(entry, *find_schedule_value("control"), name + ".control", control[k]);
      set_real(entry, *find_schedule_value("time"), name + ".time", time[k]);
      set_real(entry, *find_schedule_value("value"), name + ".value", value[k]);
      entry.well = index;
      check_schedule_entry(name, entry, sim->simulation->options());
      if (!entries.empty() && entry.time <= entries.back().time) {
        throw Error(ErrorKind::argument, name + ".time = " + number_text(entry.time) + " s is not after " +
                                             number_text(entries.back().time) +
                                             " s, the entry before it; give them in order of time.");
      }
      entries.push_back(entry);
    }
    set_well_schedule(*sim->simulation, static_cast<std::size_t>(index), std::move(entries));
    ++sim->epoch;
    tell_well(*sim, index, "follows a schedule of " + std::to_string(count) + " entries");
  });
}
