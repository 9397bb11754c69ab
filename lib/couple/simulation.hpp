// SPDX-License-Identifier: BSD-3-Clause
// A simulation: the model, its clock, its balance. What a step does, in order, stands in step.cpp; how a model is
// built, in setup.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/workers.hpp"
#include "equilibrium/equilibrium_solver.hpp"
#include "flow/flow_solver.hpp"
#include "flow/network.hpp"
#include "frac/crack_log.hpp"
#include "frac/fractures.hpp"
#include "heat/heat.hpp"
#include "host/cell_report.hpp"
#include "options/options.hpp"
#include "solid/assembly.hpp"
#include "solid/boundary.hpp"
#include "solid/explicit_solver.hpp"

namespace hfrac {

// progress(share done, what): true asks to stop.
using Progress = std::function<bool(double, const char*)>;

struct Well {
  WellPlace place;
  WellControl control = WellControl::pressure;
  double target_pressure = 0.0;         // Pa
  double ramp_per_step = 0.0;           // Pa
  double set_rate = 0.0;                // m2/s
  double rate = 0.0;                    // m2/s into the well in the last step
  double injected = 0.0;                // m2 since the initial equilibration
  double content = 0.0;                 // m2 at the end of the last step
  double taken = 0.0;                   // m2 in the increments of the step so far
  std::vector<ScheduleEntry> schedule;  // in order of time; `well` is not looked at
  std::int64_t next = 0;                // of the schedule: entries before it hold or are past
};

struct SetupReport {
  double packing_residual = 0.0, porosity = 0.0, coordination = 0.0, permeability = 0.0, force_ratio = 0.0;
  std::int64_t packed = 0, removed_in_wells = 0, removed_floaters = 0, removed_crossings = 0;
  std::int64_t unbonded = 0;  // contacts that a host's list of bonds left out
  double packing_seconds = 0.0, setup_seconds = 0.0;
  std::int64_t cracks = 0;
};

// What the quasi-static solver did since the initial equilibration.
struct SolverWork {
  std::int64_t increments = 0, rounds = 0, newton = 0, krylov = 0, factors = 0;
  std::int64_t rejected_error = 0, rejected_strength = 0, rejected_divergence = 0;
};

struct Balance {
  double kinetic, bond_elastic, contact_elastic, fluid_work, boundary_work, friction, damping, fracture,
      energy_error;                              // J/m
  double injected, stored, leaked, fluid_error;  // m2
  double host;                                   // m2, put into pores by the host
};

// Heat of rock and pores [J/m], counted from the temperature at set-up.
struct HeatBalance {
  double stored, from_wells, from_outside, from_held, from_host, error;
  double thermal_work;     // J/m of elastic energy put in by changes of temperature
  double lowest, highest;  // K, of the discs
};

enum class StopReason : std::int32_t { target = 0, callback = 1, extent = 2, cracks = 3 };

class Simulation {
 public:
  // Builds the model and brings it to rest under the far field. Throws Error; Stopped if progress asked for it.
  // The host's own discs (x, y, radius each) instead of a packing, and which of them are bonded (two indices each; none: all
  // that are near).
  Simulation(CaseDefinition definition, std::span<const double> given_discs, const Progress& progress,
             std::span<const std::int64_t> given_bonds = {});

  struct StepOutcome {
    bool stopped = false;  // the step was undone
    bool at_rest = true;
  };
  // One step. If it is interrupted or fails, the state is as before it.
  StepOutcome step(const std::function<bool()>& interrupt = {}) { return step_for(next_step(), interrupt); }
  // The same, `duration` seconds long instead.
  StepOutcome step_of_length(double duration, const std::function<bool()>& interrupt = {}) {
    return step_for(duration, interrupt);
  }
  // stepping.flow_step, or as much of it as is left before the next entry of a schedule [s].
  [[nodiscard]] double next_step() const;

  void set_well_pressure(std::size_t well, double pressure);
  void set_well_ramp(std::size_t well, double pressure, double per_step);
  void set_well_rate(std::size_t well, double rate);
  // Replaces the well's schedule. Entries already past take effect with the next step, the last of them in the end. The three
  // functions above end a well's schedule.
  void set_well_schedule(std::size_t well, std::vector<ScheduleEntry> schedule);

  [[nodiscard]] const CaseDefinition& definition() const { return definition_; }
  [[nodiscard]] const Options& options() const { return definition_.options; }
  [[nodiscard]] const Assembly& assembly() const { return assembly_; }
  [[nodiscard]] const Network& network() const { return network_; }
  [[nodiscard]] const Boundary& boundary() const { return *boundary_; }
  [[nodiscard]] const ExplicitSolver& solver() const { return *solver_; }
  [[nodiscard]] const std::vector<Well>& wells() const { return wells_; }
  [[nodiscard]] const CrackLog& cracks() const { return cracks_; }
  [[nodiscard]] const SetupReport& setup() const { return setup_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t step_count() const { return step_; }
  [[nodiscard]] double force_ratio() const { return force_ratio_; }
  [[nodiscard]] bool at_rest() const { return at_rest_; }
  [[nodiscard]] int flow_rounds() const { return flow_rounds_; }
  [[nodiscard]] double leaked() const { return leaked_; }
  [[nodiscard]] const SolverWork& work() const { return work_; }
  [[nodiscard]] double increment() const { return increment_; }
  [[nodiscard]] const Array<double>& start_x() const {
    return start_x_;
  }  // displacement at the end of the initial equilibration
  [[nodiscard]] const Array<double>& start_y() const { return start_y_; }
  [[nodiscard]] const Array<double>& start_rotation() const { return start_rotation_; }

  std::vector<Fracture> fractures() {
    return find_fractures(assembly_, network_, options(), well_places(), cracks_);
  }
  [[nodiscard]] std::vector<WellPlace> well_places() const;
  [[nodiscard]] Balance balance() const;
  [[nodiscard]] double tip_distance() const { return tip_distance_; }
  [[nodiscard]] StopReason stop_reason() const;
  // Other limits than stop.extent_fraction and stop.cracks from now on.
  void set_stop(double extent_fraction, std::int64_t cracks);
  [[nodiscard]] std::uint64_t state_hash() const;

  // The state as bytes, and back. A restored simulation goes on bit for bit as the saved one did. Images fit the model they
  // were taken from; anything else is refused and changes nothing.
  [[nodiscard]] std::size_t image_size() const;
  void write_image(std::span<std::byte> image) const;  // of image_size() bytes
  void restore(std::span<const std::byte> image);

  // A step in three parts, for hosts that iterate: try_step may be called again and again, with another duration or
  // other wells, and always starts from where begin_step was called; accept_step keeps the last one, reject_step
  // goes back.
  void begin_step();
  StepOutcome try_step(double duration, const std::function<bool()>& interrupt = {});
  void accept_step();
  void reject_step();
  [[nodiscard]] bool step_open() const { return step_open_; }

  // From the next step on; stress-controlled or servo-driven boundaries only.
  void set_far_field(double sigma_Hmax, double sigma_hmin);
  // From the next step on, another absolute pressure in the pores outside the model. Total stresses stay; inside it follows
  // by flow.
  void set_formation_pressure(double pressure);
  [[nodiscard]] double formation_pressure() const { return formation_pressure_; }

  // A reservoir simulator's grid and what passes through it (host.cpp). The grid is no part of the state, what it brought is.
  void set_grid(HostGrid grid);
  [[nodiscard]] const HostGrid& grid() const;
  [[nodiscard]] std::vector<CellReport> cells(Upscaling rule) const;
  // Pores beside no crack take the host's pressure at once, each the mean of its cells by area; `added` (empty or one per cell)
  // gets the fluid each cell thereby gave [m2]. Not while a step is open.
  void set_cell_pressure(std::span<const double> pressure, std::span<double> added);
  // From the next step on, pressure beyond the model's outer boundary by cell [Pa]; empty: the formation's again.
  void set_boundary_pressure(std::span<const double> pressure);
  // From the next step on, stress on top of the far field by cell [Pa; xx, yy, xy].
  void set_cell_stress(std::span<const double> stress);

  // Temperature (heat.cpp); nullptr with thermal.mode = "off".
  [[nodiscard]] const Heat* heat() const { return heat_.get(); }
  [[nodiscard]] HeatBalance heat_balance() const;
  // At once, in kelvin; the rock answers in the next step. Not while a step is open. By disc, or by the cell that holds
  // a disc's centre, in mode transport only.
  void set_temperature(double kelvin);
  void set_disc_temperature(std::span<const double> kelvin);
  void set_cell_temperature(std::span<const double> kelvin);
  [[nodiscard]] std::vector<double> cell_temperature() const;  // mean by heat capacity
  // Discs not 0 keep their temperature until told otherwise.
  void hold_temperature(std::span<const std::int32_t> held);
  void set_well_temperature(std::size_t well, double kelvin);  // of what it injects

 private:
  // setup.cpp
  void build(std::span<const double> given_discs, std::span<const std::int64_t> given_bonds,
             const Progress& progress);
  [[nodiscard]] std::vector<double> initial_pressures() const;
  void equilibrate(const Progress& progress);
  void require_rock_stands(std::size_t cracks_before, double share) const;
  void begin_balance();
  // step.cpp
  StepOutcome step_for(double duration, const std::function<bool()>& interrupt);
  [[nodiscard]] bool is_due(const ScheduleEntry& entry) const;
  void follow_schedules();
  void drive_wells();
  void flow_step(double duration);
  void finish_step(double duration, std::size_t cracks_before);
  // finite.cpp
  [[nodiscard]] std::string not_finite() const;  // what is not, and where, in words; empty: everything is
  void require_finite() const;
  void watch_energy() const;
  void require_joints_in_reach() const;
  void require_walls_to_push(double sigma_hmin, double outside) const;
  void put_formation_pressure(double pressure);
  void impose_well_pressure(Well& well, double pressure);
  void accumulate_flow(double duration);
  void close_step(double duration, std::size_t cracks_before);
  // coupled_step.cpp
  StepOutcome quasi_static_substep(double duration, const std::function<bool()>& interrupt);
  StepOutcome coupled_step(double duration, const std::function<bool()>& interrupt);
  EquilibriumSolver::Outcome relax_dynamically(double increment, const std::function<bool()>& interrupt);
  [[nodiscard]] double increment_error(double increment) const;
  void count(const EquilibriumSolver::Outcome& outcome);
  // state.cpp
  template <class Archive, class Self>
  static void visit_state(Archive& archive, Self& self);  // what a step or the host may change
  template <class Archive, class Self>
  static void visit_start(Archive& archive, Self& self);  // what is fixed after set-up
  template <class Archive, class Self>
  static void visit_start_content(Archive& archive, Self& self);
  [[nodiscard]] bool is_finite() const;
  [[nodiscard]] std::size_t state_size(bool whole) const;
  void write_state(std::span<std::byte> state, bool whole) const;
  void save_state(std::vector<std::byte>& state, bool whole = false) const;
  void load_state(std::span<const std::byte> state, bool whole = false);
  [[nodiscard]] std::uint64_t model_fingerprint() const;
  // host.cpp
  void require_cells(std::size_t given, std::size_t per_cell, const char* what) const;
  // heat.cpp
  void begin_heat();
  void move_heat(double duration);
  void feel_heat();
  void feel_again();  // after a restore
  void book_host_fluid(std::size_t domain, double gain);
  void put_temperatures(const Array<double>& disc);
  void require_heat() const;
  void require_transport(const char* what) const;
  void require_no_open_step() const;
  [[nodiscard]] double stored_heat() const;
  // balance.cpp
  void elastic_energy(double& bonds, double& contacts) const;  // J/m
  [[nodiscard]] double stored_fluid() const;                   // m2 since the initial equilibration

  CaseDefinition definition_;
  std::unique_ptr<Workers, Workers::Release> workers_;
  Assembly assembly_;
  Network network_;
  std::unique_ptr<Boundary> boundary_;
  std::unique_ptr<ExplicitSolver> solver_;
  std::unique_ptr<FlowSolver> flow_;
  std::unique_ptr<EquilibriumSolver> equilibrium_;
  std::unique_ptr<Heat> heat_;
  std::vector<Well> wells_;
  CrackLog cracks_;
  SetupReport setup_;
  std::uint64_t bonds_given_ = 0;  // hash of which contacts are bonded
  std::vector<double> source_;     // m2/s per domain, from wells at a rate
  double time_ = 0.0, force_ratio_ = 0.0, leaked_ = 0.0, tip_distance_ = 0.0, host_added_ = 0.0;
  std::int64_t step_ = 0;
  bool at_rest_ = true;
  bool outer_is_hosts_ = false;  // a host's grid said what the outer boundary feels
  int flow_rounds_ = 0;
  bool jumped_ = false;  // a well's imposed pressure in the step at hand
  // mode coupled: length of the next increment [s], largest stress over strength so far, pressures before the increment and their rate
  double increment_ = 0.0, excess_ = 0.0;
  Array<double> increment_pressure_, pressure_rate_;
  SolverWork work_;
  // where the balance begins
  Array<double> start_x_, start_y_, start_rotation_;
  Array<double> start_content_;  // m2 per domain; dry: per well, since nothing else changes
  std::vector<std::byte> before_step_, opened_, before_increment_;  // images to go back to
  bool step_open_ = false;
  std::optional<HostGrid> grid_;
  double oda_matrix_ =
      1.0;  // the rock's permeability over that of a uniform gradient, at the end of the initial equilibration
  double start_bond_energy_ = 0.0, start_contact_energy_ = 0.0, start_boundary_work_ = 0.0,
         start_outside_change_ = 0.0;
  double formation_pressure_ = 0.0;  // Pa, absolute, outside now
  double outside_work_ = 0.0;        // J/m, by earlier pressures outside, up to start_outside_change_
  std::uint64_t model_ = 0;          // fingerprint of what never changes
};

// Thrown by the constructor when progress asked to stop.
struct Stopped {};

}  // namespace hfrac
