// SPDX-License-Identifier: BSD-3-Clause
// A simulation: a model, what moves it, and the loads on it. It owns these and keeps the one promise that none of them can keep
// alone: after a step that fails or is interrupted, everything is as before it. What a step does stands in steppers.hpp, what is
// counted in ledger.hpp, what a host may impose in impose.hpp and put in at once in host_state.hpp.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "build/build_model.hpp"
#include "frac/fracture_line.hpp"
#include "frac/fractures.hpp"
#include "host/host_grid.hpp"
#include "step/engine.hpp"
#include "step/ledger.hpp"
#include "step/loads.hpp"
#include "step/packed_model.hpp"
#include "step/steppers.hpp"

namespace hfrac {

enum class StopReason : std::int32_t { target = 0, callback = 1, extent = 2, cracks = 3 };

class Simulation {
 public:
  // Builds the model and brings it to rest under the far field. Throws Error; Stopped if progress asked for it.
  // The host's own discs (x, y, radius each) instead of a packing, and which of them are bonded (two indices each; none: all
  // that are near). Over several ranks, on each with the same arguments.
  // Or from a model that was packed before: what its state spares is not done again. Throws Error(model) if it does not fit.
  Simulation(CaseDefinition definition, std::span<const double> given_discs, const Progress& progress,
             std::span<const std::int64_t> given_bonds = {}, const Ranks& ranks = {},
             const PackedModel* packed = nullptr);
  // As far as the model at rest, to begin others from.
  static PackedModel pack(CaseDefinition definition, std::span<const double> given_discs,
                          const Progress& progress, std::span<const std::int64_t> given_bonds = {},
                          const PackedModel* packed = nullptr);

  // What was built, with what the case leaves open decided. Loads that changed since stand in loads().
  [[nodiscard]] const CaseDefinition& definition() const { return definition_; }
  // As it was given.
  [[nodiscard]] CaseDefinition given_definition() const;
  [[nodiscard]] const Options& options() const { return definition_.options; }
  // What a device keeps of the state comes home first (ExplicitSolver::bring_home).
  [[nodiscard]] const Model& model() const { return bring_home().model; }
  [[nodiscard]] const Engine& engine() const { return bring_home(); }
  [[nodiscard]] Engine& engine() {
    as_opened_ = false;
    bring_home();
    return *engine_;
  }
  // For all else: sizes, clock, loads, wells, cracks, displacements, what flows.
  [[nodiscard]] const Engine& engine_as_is() const { return *engine_; }
  [[nodiscard]] const SetupReport& setup() const { return setup_; }
  [[nodiscard]] const Assembly& assembly() const { return bring_home().model.assembly; }
  [[nodiscard]] const Network& network() const { return model_.network; }
  [[nodiscard]] const std::vector<Well>& wells() const { return model_.wells; }
  [[nodiscard]] const CrackLog& cracks() const { return model_.cracks; }
  [[nodiscard]] double time() const { return model_.clock.time; }
  [[nodiscard]] Balance balance() const { return balance_of(*engine_); }

  // From the next step on.
  [[nodiscard]] const Loads& loads() const { return loads_; }
  // A further well, with its load (added_well.hpp).
  void take_well(const Well& well);
  void impose(const Loads& wanted) {
    as_opened_ = false;
    hfrac::impose(*engine_, loads_, wanted);
  }

  // One step. If it is interrupted or fails, the state is as before it.
  StepOutcome step(const Interrupt& interrupt = {}) { return step(loads_, next_step(), interrupt); }
  StepOutcome step(const Loads& loads, double duration, const Interrupt& interrupt = {});
  // stepping.flow_step, or as much of it as is left before the next entry of a schedule [s].
  [[nodiscard]] double next_step() const;
  [[nodiscard]] StopReason stop_reason() const;
  // Other limits than stop.extent_fraction and stop.cracks from now on.
  void set_stop(double extent_fraction, std::int64_t cracks);

  // A step in three parts, for hosts that iterate: try_step may be called again and again, with another duration or
  // other loads, and always starts from where begin_step was called; accept_step keeps the last one, reject_step
  // goes back.
  void begin_step();
  StepOutcome try_step(double duration, const Interrupt& interrupt = {});
  void accept_step();
  void reject_step();
  [[nodiscard]] bool step_open() const { return step_open_; }

  [[nodiscard]] std::size_t image_size() const;
  void write_image(std::span<std::byte> image) const;  // of image_size() bytes
  void restore(std::span<const std::byte> image);
  [[nodiscard]] std::uint64_t state_hash() const;

  // Numbers the cracks by fracture.
  std::vector<Fracture> fractures();
  // Of a fracture by its index there.
  [[nodiscard]] std::vector<FracturePoint> fracture_line(std::int32_t fracture) const;

  // A reservoir simulator's grid over the model. It is no part of the state, what it brought is.
  void set_grid(HostGrid grid);
  [[nodiscard]] bool has_grid() const { return grid_.has_value(); }
  [[nodiscard]] const HostGrid& grid() const;
  [[nodiscard]] double oda_matrix() const { return oda_matrix_; }

 private:
  const Engine& bring_home() const {
    engine_->mechanics->bring_home();
    return *engine_;
  }
  struct Parts;
  Simulation(CaseDefinition definition, const Progress& progress, const Ranks& ranks, const Parts& parts);
  void require_open_step() const;
  StepOutcome take_step(const Loads& loads, double duration, const Interrupt& interrupt);
  void reopen();

  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  CaseDefinition definition_;
  Options given_;
  Model model_;
  std::unique_ptr<Engine> engine_;
  Loads loads_;
  SetupReport setup_;
  std::optional<HostGrid> grid_;
  double oda_matrix_ = 1.0;  // the rock's permeability over that of a uniform gradient, at the start
  std::uint64_t fingerprint_ = 0;
  std::vector<std::byte> before_step_, opened_;  // states to go back to
  Loads opened_loads_;
  std::optional<std::pair<CrackLog, SlipLog>> opened_logs_;  // before another state came
  bool step_open_ = false,
       as_opened_ = false;  // as_opened_: nothing has changed since, so opened_ is what is now
  double stop_extent_fraction_ = 0.0;
  std::int64_t stop_cracks_ = 0;
};

}  // namespace hfrac
