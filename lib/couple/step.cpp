// SPDX-License-Identifier: BSD-3-Clause
// The order of a step. Everything a step does is called from Simulation::step, top to bottom:
//
//   1  wells take their pressures or rates, of their schedule if they have one; steps end at its times
//   2  fluid moves along the pipes for flow_step seconds while the rock stands still (eq. 6, 8; implicit or sub-cycled)
//      and heat with it, if there is a temperature; the rock feels it in 3 (heat.cpp)
//   3  the rock moves until it is at rest, or for flow_step seconds of real time (mode dynamic): in every cycle
//        bond and contact forces (eq. 15-20), breakage (eq. 21-23) -> crack log
//        pores answer undrained: pressure follows from the fluid they hold and their volume (eq. 8)
//        pressures push the discs (eq. 9-14), boundary, motion (eq. 11, 12)
//   4  apertures and conductances at the new geometry (eq. 6, 7); new contacts around cracks
//   5  clock, injected and leaked volumes, farthest crack tip
//
// Between 2 and 3 no fluid is lost or made: pores keep their content while the rock moves. Freezing the pressure
// instead (the drained split) is unstable. If a step fails or is interrupted, the state is put back as it was.
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "couple/simulation.hpp"
#include "flow/aperture.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"

namespace hfrac {

Simulation::StepOutcome Simulation::step_for(double duration, const std::function<bool()>& interrupt) {
  const Options& o = options();
  save_state(before_step_);
  try {
    follow_schedules();
    drive_wells();
    if (equilibrium_) {
      equilibrium_->begin_step();
      const StepOutcome outcome = SteppingMode{o.stepping_mode} == SteppingMode::coupled
                                      ? coupled_step(duration, interrupt)
                                      : quasi_static_substep(duration, interrupt);
      if (outcome.stopped) {
        load_state(before_step_);
        return {true, at_rest_};
      }
      require_finite();
      require_joints_in_reach();
      // What the works did beyond what is stored went into motion that damping would have ended.
      solver_->energies().damping += balance().energy_error;
      return outcome;
    }
    flow_step(duration);

    ExplicitSolver::Outcome mechanics;
    const std::size_t cracks_before = cracks_.size();
    if (SteppingMode{o.stepping_mode} == SteppingMode::dynamic) {
      mechanics = solver_->run_for(duration, cracks_, interrupt);
      mechanics.at_rest = true;  // not asked for
    } else {
      mechanics = solver_->relax(o.stepping_force_ratio, o.stepping_max_cycles, cracks_, interrupt);
    }
    if (mechanics.stopped) {
      load_state(before_step_);
      return {true, at_rest_};
    }
    force_ratio_ = mechanics.force_ratio;
    at_rest_ = mechanics.at_rest;
    solver_->evaluate();
    if (flow_) update_apertures(network_, assembly_, o);
    solver_->search_contacts(cracks_);
    finish_step(duration, cracks_before);
    require_finite();
    require_joints_in_reach();
    watch_energy();
  } catch (const Error& error) {
    // A solver that could not go on may not know which number kept it from it.
    const std::string what = error.kind() == ErrorKind::diverged ? not_finite() : std::string();
    load_state(before_step_);
    if (!what.empty()) throw Error(ErrorKind::diverged, what);
    throw;
  } catch (...) {
    load_state(before_step_);
    throw;
  }
  return {false, at_rest_};
}

// Adding up steps rounds: a billionth of a step early is on time.
bool Simulation::is_due(const ScheduleEntry& entry) const {
  return entry.time <= time_ + 1e-9 * options().stepping_flow_step;
}

double Simulation::next_step() const {
  double step = options().stepping_flow_step;
  for (const auto& well : wells_) {
    for (auto k = static_cast<std::size_t>(well.next); k < well.schedule.size(); ++k) {
      if (!is_due(well.schedule[k])) {
        step = std::min(step, well.schedule[k].time - time_);
        break;
      }
    }
  }
  return step;
}

void Simulation::follow_schedules() {
  bool turned = false;
  for (auto& well : wells_) {
    for (; well.next < static_cast<std::int64_t>(well.schedule.size()); ++well.next) {
      const ScheduleEntry& entry = well.schedule[static_cast<std::size_t>(well.next)];
      if (!is_due(entry)) break;
      well.control = WellControl{entry.control};
      (well.control == WellControl::rate ? well.set_rate : well.target_pressure) = entry.value;
      turned = true;
    }
  }
  // What pressures were heading for before says nothing any more.
  if (turned) std::fill(pressure_rate_.begin(), pressure_rate_.end(), 0.0);
}

// A time step too long for the model lets every cycle add energy that no work brought in. What is looked at closely is
// only motion that is worth it: at rest there is none.
void Simulation::watch_energy() const {
  constexpr double noteworthy = 0.01;    // kinetic energy over all that was ever put in
  constexpr double from_nowhere = 0.25;  // energy no work accounts for, likewise; in sound runs some 1e-3
  const double kinetic = solver_->kinetic_energy();
  const double load_work = boundary_->load_work(assembly_) - start_boundary_work_;
  const double start = start_bond_energy_ + start_contact_energy_;
  const double put_in = std::abs(solver_->energies().fluid) + std::abs(load_work) + start;
  if (kinetic <= noteworthy * put_in) return;
  const Balance b = balance();
  const double excess = -b.energy_error;
  if (excess <= from_nowhere * (std::abs(b.fluid_work) + std::abs(b.boundary_work) + start)) return;
  std::size_t fastest = 0;
  const auto speed = [this](std::size_t i) { return std::hypot(assembly_.vx[i], assembly_.vy[i]); };
  for (std::size_t i = 1; i < assembly_.vx.size(); ++i) {
    if (speed(i) > speed(fastest)) fastest = i;
  }
  const Vec2 at = assembly_.position(static_cast<std::int64_t>(fastest));
  throw Error(ErrorKind::diverged,
              "the step after " + std::to_string(time_) + " s made " + number_text(excess) +
                  " J/m of energy that no work accounts for (eq. 11, 12), fastest at disc " +
                  std::to_string(fastest) + " near (" + number_text(at.x) + ", " + number_text(at.y) +
                  ") m; lower stepping.safety, or a host's pressures and stresses");
}

// The smooth-joint law keeps the pairs of discs of the set-up; past about a radius others face each other.
void Simulation::require_joints_in_reach() const {
  double slide = 0.0;
  const SmoothContact* contact = farthest_slide(assembly_, slide);
  if (contact == nullptr || slide <= assembly_.mean_radius) return;
  const Vec2 at = assembly_.position(assembly_.first[contact->bond]) + contact->first_arm;
  throw Error(
      ErrorKind::diverged,
      "joint[" + std::to_string(contact->joint) + "] slid by " + rounded_text(slide) + " m near (" +
          rounded_text(at.x) + ", " + rounded_text(at.y) + ") m, farther than the mean disc radius of " +
          rounded_text(assembly_.mean_radius) +
          " m: a smooth joint keeps the pairs of discs that faced each other at first; load it less, hold "
          "it by friction, strength or its length, or set its state to \"broken\"");
}

void Simulation::drive_wells() {
  jumped_ = false;
  std::fill(source_.begin(), source_.end(), 0.0);
  for (auto& well : wells_) {
    const auto d = well.place.domain;
    switch (well.control) {
      case WellControl::pressure:
        impose_well_pressure(well, well.target_pressure);
        break;
      case WellControl::ramp: {
        const double now = network_.pressure[d], gap = well.target_pressure - now;
        impose_well_pressure(well, std::abs(gap) <= well.ramp_per_step
                                       ? well.target_pressure
                                       : now + std::copysign(well.ramp_per_step, gap));
        break;
      }
      case WellControl::rate:
        if (network_.stiffness[d] == 0.0) {
          network_.stiffness[d] = options().fluid_bulk_modulus / network_.volume[d];
          network_.content[d] = content_at(network_, d, options().fluid_bulk_modulus, network_.pressure[d]);
        }
        if (flow_) source_[static_cast<std::size_t>(d)] = well.set_rate;
        break;
    }
  }
}

void Simulation::impose_well_pressure(Well& well, double pressure) {
  network_.stiffness[well.place.domain] = 0.0;
  const double before = network_.pressure[well.place.domain];
  network_.pressure[well.place.domain] = std::max(pressure, network_.floor_pressure);
  jumped_ = jumped_ || network_.pressure[well.place.domain] != before;
}

void Simulation::flow_step(double duration) {
  if (flow_) flow_rounds_ = flow_->advance(network_, duration, source_);
  move_heat(duration);
  feel_heat();
}

void Simulation::finish_step(double duration, std::size_t cracks_before) {
  accumulate_flow(duration);
  close_step(duration, cracks_before);
}

// What an increment of a step injected and leaked.
void Simulation::accumulate_flow(double duration) {
  // What left through the pipes; domains of imposed pressure keep no content of their own.
  std::vector<double> outflow(wells_.size(), 0.0);
  if (flow_) {
    double leak = 0.0;
    for (std::size_t e = 0; e < network_.left.size(); ++e) {
      const auto l = network_.left[e], r = network_.right[e];
      if (l == 0) leak -= network_.flow[e];
      if (r == 0) leak += network_.flow[e];
      for (std::size_t w = 0; w < wells_.size(); ++w) {
        if (l == wells_[w].place.domain) outflow[w] += network_.flow[e];
        if (r == wells_[w].place.domain) outflow[w] -= network_.flow[e];
      }
    }
    leaked_ += duration * leak;
  }
  for (std::size_t w = 0; w < wells_.size(); ++w) {
    Well& well = wells_[w];
    const auto d = well.place.domain;
    const double injected_before = well.injected;
    if (network_.stiffness[d] == 0.0) {
      // What it took to keep the pressure: what flowed out, and what the hole holds more than before.
      const double content = content_at(network_, d, options().fluid_bulk_modulus, network_.pressure[d]);
      well.injected += duration * outflow[w] + content - well.content;
      network_.content[d] = content;
    } else {
      if (flow_) well.injected += duration * source_[static_cast<std::size_t>(d)];
    }
    well.content = network_.content[d];
    well.taken += well.injected - injected_before;
  }
}

void Simulation::close_step(double duration, std::size_t cracks_before) {
  time_ += duration;
  ++step_;
  for (auto& well : wells_) {
    well.rate = well.taken / duration;
    well.taken = 0.0;
  }
  for (std::size_t c = cracks_before; c < cracks_.size(); ++c) {
    cracks_[c].step = step_;
    cracks_[c].time = time_;
  }
  // Cracks elsewhere, say at the outer boundary, are no part of what the wells drive.
  if (cracks_.size() > cracks_before)
    tip_distance_ =
        std::max(tip_distance_, farthest_tip(assembly_, network_, options(), well_places(), cracks_));
}

void Simulation::begin_step() {
  save_state(opened_);
  step_open_ = true;
}

Simulation::StepOutcome Simulation::try_step(double duration, const std::function<bool()>& interrupt) {
  if (!step_open_) throw Error(ErrorKind::argument, "no step is open; call hfrac_step_prepare first.");
  // Wells, far field and what the host's grid says of the outer boundary are the host's: what it set since the last try stays.
  const auto wells = wells_;
  const auto outer_excess = network_.outer_excess;
  const bool outer_is_hosts = outer_is_hosts_;
  const auto host_load = boundary_->host_load();
  const double sigma_Hmax = options().stress_sigma_Hmax, sigma_hmin = options().stress_sigma_hmin;
  const double formation = formation_pressure_;
  const auto well_temperature = heat_ ? heat_->state.well : std::vector<double>{};
  load_state(opened_);
  if (heat_) heat_->state.well = well_temperature;
  for (std::size_t w = 0; w < wells.size(); ++w) {
    wells_[w].control = wells[w].control;
    wells_[w].target_pressure = wells[w].target_pressure;
    wells_[w].ramp_per_step = wells[w].ramp_per_step;
    wells_[w].set_rate = wells[w].set_rate;
    // The same schedule goes on from where it was when the step was opened, a new one from its beginning.
    if (wells_[w].schedule != wells[w].schedule) set_well_schedule(w, wells[w].schedule);
  }
  boundary_->put_host_load(host_load);
  definition_.options.stress_sigma_Hmax = sigma_Hmax;
  definition_.options.stress_sigma_hmin = sigma_hmin;
  if (formation != formation_pressure_) put_formation_pressure(formation);
  network_.outer_excess = outer_excess;
  outer_is_hosts_ = outer_is_hosts;
  boundary_->set_far_field(assembly_, sigma_Hmax, sigma_hmin);
  return step_for(duration, interrupt);
}

void Simulation::accept_step() {
  if (!step_open_) throw Error(ErrorKind::argument, "no step is open; call hfrac_step_prepare first.");
  step_open_ = false;
}

void Simulation::reject_step() {
  if (!step_open_) throw Error(ErrorKind::argument, "no step is open; call hfrac_step_prepare first.");
  load_state(opened_);
  step_open_ = false;
}

void Simulation::set_far_field(double sigma_Hmax, double sigma_hmin) {
  if (!boundary_->follows_far_field()) {
    throw Error(ErrorKind::argument,
                "the walls are fixed, so the far field cannot act; use boundary.kind = \"stress\" or "
                "boundary.walls_after_equilibration = \"servo\".");
  }
  if (sigma_hmin > sigma_Hmax)
    throw Error(ErrorKind::argument, "sigma_hmin = " + std::to_string(sigma_hmin) +
                                         " Pa is larger than sigma_Hmax = " + std::to_string(sigma_Hmax) +
                                         " Pa; swap them.");
  require_walls_to_push(sigma_hmin, network_.pressure[0]);
  definition_.options.stress_sigma_Hmax = sigma_Hmax;
  definition_.options.stress_sigma_hmin = sigma_hmin;
  boundary_->set_far_field(assembly_, sigma_Hmax, sigma_hmin);
}

// What walls would have to pull at they run away from.
void Simulation::require_walls_to_push(double sigma_hmin, double outside) const {
  const double bears = sigma_hmin - (flow_ ? outside : 0.0);
  if (!boundary_->walled() || !boundary_->follows_far_field() || bears >= 0.0) return;
  throw Error(
      ErrorKind::argument,
      "sigma_hmin = " + std::to_string(sigma_hmin) + " Pa is " + std::to_string(-bears) +
          " Pa below the pressure in the pores outside, and walls only push; keep sigma_hmin at or above "
          "it, or use boundary.kind = \"stress\".");
}

void Simulation::set_formation_pressure(double pressure) {
  const Options& o = options();
  if (!flow_ || OuterPores{o.flow_outer} == OuterPores::closed) {
    throw Error(
        ErrorKind::argument,
        "no pores outside are connected to the model, so their pressure cannot act; use flow.scheme = "
        "\"implicit\" or \"explicit\" with flow.outer = \"formation\".");
  }
  const bool total = StressConvention{o.stress_convention} == StressConvention::total;
  if (total && boundary_->follows_far_field() && pressure > o.stress_sigma_hmin) {
    throw Error(ErrorKind::argument, "a formation pressure of " + std::to_string(pressure) +
                                         " Pa is above sigma_hmin = " + std::to_string(o.stress_sigma_hmin) +
                                         " Pa and would pull the rock apart; raise the far field first.");
  }
  require_walls_to_push(o.stress_sigma_hmin,
                        network_.reference_pressure + (pressure - o.fluid_formation_pressure));
  put_formation_pressure(pressure);
}

void Simulation::put_formation_pressure(double pressure) {
  const Options& o = options();
  // Pressures count from the datum of the stress convention; content is measured from where it was at set-up.
  const double outside = network_.reference_pressure + (pressure - o.fluid_formation_pressure);
  outside_work_ += network_.pressure[0] * (network_.volume_change[0] - start_outside_change_);
  start_outside_change_ = network_.volume_change[0];
  // What a host's grid said of the outer boundary is absolute and stays; the excess is over what lies beyond.
  if (outer_is_hosts_)
    for (double& excess : network_.outer_excess) excess += network_.pressure[0] - outside;
  network_.pressure[0] = outside;
  formation_pressure_ = pressure;
  boundary_->set_outside_pressure(assembly_, network_, o.stress_sigma_Hmax, o.stress_sigma_hmin);
}

void Simulation::set_well_pressure(std::size_t well, double pressure) {
  set_well_schedule(well, {});
  wells_[well].control = WellControl::pressure;
  wells_[well].target_pressure = pressure;
}

void Simulation::set_well_ramp(std::size_t well, double pressure, double per_step) {
  set_well_schedule(well, {});
  wells_[well].control = WellControl::ramp;
  wells_[well].target_pressure = pressure;
  wells_[well].ramp_per_step = per_step;
}

void Simulation::set_well_rate(std::size_t well, double rate) {
  set_well_schedule(well, {});
  wells_[well].control = WellControl::rate;
  wells_[well].set_rate = rate;
}

void Simulation::set_well_schedule(std::size_t well, std::vector<ScheduleEntry> schedule) {
  wells_[well].schedule = std::move(schedule);
  wells_[well].next = 0;
}

}  // namespace hfrac
