// SPDX-License-Identifier: BSD-3-Clause
// Newton's law for every disc, cycle by cycle (eq. 11, 12), with local damping (Cundall 1987).
//
// One cycle, in two phases with a barrier after each; tiles.hpp says what is done in which:
//   1  bonds and pores across tiles; boundary (worker 0): wall forces, servo
//   2  tile by tile: forces of bonds, breakage, undrained pressures; then velocities and displacements
//
// With real masses a cycle lasts the stable step. To find rest, masses are scaled instead so that every disc is equally close
// to its stability limit and the step is 1 (density scaling): the way is not physical, the end is.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/exact_sum.hpp"
#include "core/workers.hpp"
#include "model/model.hpp"
#include "options/options.hpp"
#include "solid/blocked_batch.hpp"
#include "solid/bond_law.hpp"
#include "solid/boundary.hpp"
#include "solid/device_cycles.hpp"
#include "solid/facet_motion.hpp"
#include "solid/fragments.hpp"
#include "solid/kernels.hpp"
#include "solid/non_bonded_contacts.hpp"
#include "solid/shared_tiles.hpp"
#include "solid/smooth_joints.hpp"
#include "solid/tiles.hpp"

namespace hfrac {

class ExplicitSolver {
 public:
  ExplicitSolver(Model& model, Boundary& boundary, const Options& options, Workers& workers,
                 const Ranks& ranks = {});

  // How the next cycles run.
  void use_scaled_masses();
  void use_real_masses();
  // Facets of fractures (fracture.law = "facet"). A bond that is to break is not gone in the cycle that finds it: between that and the next,
  // `breaks` makes facets of all found, ascending. `grow` breaks bonds at tips that the openings behind them ask to go on, and says whether
  // there were any: asked at rest, and in real motion from time to time.
  struct FacetRules {
    std::function<void(std::span<const std::int64_t> broken)> breaks;
    std::function<bool(CrackLog& log)> grow;
  };
  FacetMotion& follow_facets(const FacetStart& start, const Array<double>& rock_weight, FacetRules rules);
  // Model time as the cycles to come begin, with real masses, or for all of them [s]; and that of the cycle at hand.
  void set_time(double time) {
    time_ = time;
    cycles_then_ = total_cycles_;
  }
  [[nodiscard]] double time() const {
    return time_ + (scaled_ ? 0.0 : arrays_.step * static_cast<double>(total_cycles_ - cycles_then_));
  }
  [[nodiscard]] double step() const { return arrays_.step; }
  // Real stable step times safety [s].
  [[nodiscard]] double real_step() const { return real_step_; }
  void set_undrained(bool undrained) { undrained_ = undrained; }
  void set_damping(double damping) { arrays_.damping = damping; }
  // After wells change between imposed pressure and rate.
  void refresh_stiffness();

  struct Outcome {
    std::int64_t cycles = 0;
    double force_ratio = 0.0;
    bool at_rest = false;
    bool stopped = false;  // by `interrupt`
  };
  // Cycles until the unbalanced-force ratio is below `ratio` and nothing breaks, at most `most` cycles. `interrupt` is
  // asked now and then. New cracks are appended to `log` (bond, cycle, forces, energy, mode). With `then` an evaluation comes after them,
  // unless they were stopped, of which ranks share what they can.
  enum class Then { nothing, evaluate };
  Outcome relax(double ratio, std::int64_t most, CrackLog& log, const std::function<bool()>& interrupt = {},
                Then then = Then::nothing);

  // Exactly `cycles` cycles.
  Outcome run(std::int64_t cycles, CrackLog& log, const std::function<bool()>& interrupt = {},
              Then then = Then::nothing);

  // `duration` seconds of real motion (real masses) in equal cycles no longer than the stable one.
  Outcome run_for(double duration, CrackLog& log, const std::function<bool()>& interrupt = {},
                  Then then = Then::nothing);

  // Forces, pressures and volumes at the displacements as they stand (no motion, no breakage).
  void evaluate();

  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] const Energies& energies() const { return energies_; }
  [[nodiscard]] std::int64_t total_cycles() const { return total_cycles_; }
  // Several cycles in one pass over the model where nothing couples all of it in every cycle (temporal_blocking.hpp); the bits are the same.
  // Models that no cache holds do so of themselves. For tests and benchmarks: in this shape; 1 cycle: never.
  void set_blocking(const BlockingShape& shape);
  // Cycles run on this device from here on wherever it knows all that answers in them (null: on none). It must outlive the solver's cycles.
  void use_device(const Device* device);
  [[nodiscard]] bool runs_on_device() const;
  // State that stays on the device from one step to the next, once this allows it. The host has, after evaluate(), what the next flow step
  // and the checks of a step read: displacements, pressures, volumes, cracks, sums; rotations, slips and softening where apertures
  // depend on them (DeviceCycles). The rest is there until somebody asks:
  //   bring_home      before anything reads or changes it: images, hashes, balances (step/snapshot.cpp, step/ledger.cpp), whoever comes
  //                   in by Simulation::model(), assembly() or engine(), new contacts, loads and temperatures, breaks in close_step
  //   holds_numbers, is_slower   what check_step asks of it, found on the device
  //   keep_for_step, take_back   the way back of a step that fails: a copy on the device
  void let_state_stay() { stays_ = true; }
  void bring_home() const;
  [[nodiscard]] bool is_away() const { return away_; }
  [[nodiscard]] bool holds_numbers() const;
  [[nodiscard]] bool is_slower(double kinetic) const;  // J/m
  void keep_for_step();
  void take_back();
  // The host's arrays are about to be written anew, all of them.
  void forget_device() { away_ = lost_ = false; }
  // There is no state: a device failed that had it. bring_home says so, until a saved one is read.
  [[nodiscard]] bool is_lost() const { return lost_; }
  void lose() { lost_ = true; }
  // For tests: what is not here reads as 1e99.
  void spoil_what_is_away() { spoils_ = true; }
  void count_cycles(std::int64_t cycles) { total_cycles_ += cycles; }  // of another solver
  void stop_motion();
  // Looks for new contacts around cracks; call between steps.
  void search_contacts(const CrackLog& cracks);
  [[nodiscard]] const NonBondedContacts& non_bonded_contacts() const { return non_bonded_; }
  [[nodiscard]] const SharedTiles& shared_tiles() const { return shared_; }

  // Bonds of the outermost discs do not break while the far field is put on: a constant load on a disc that nothing holds has no
  // equilibrium, and no rock ends there.
  void hold_edge(bool hold);
  // Whether a bond has to stay: of a held disc, or as fragments.hpp says.
  [[nodiscard]] bool stays(std::int64_t bond) const {
    return is_held(bond) || fragments_.would_cut(assembly_, bond);
  }
  // Breaks one bond as it stands (quasi-static solver).
  void break_bond(std::int64_t bond, CrackLog& log);
  // What the fluid did beyond what the passes counted (quasi-static solver) [J/m].
  void add_fluid_work(double work) { energies_.fluid += work; }
  // The kept force of a contact that was never bonded (quasi-static solver) [N].
  void keep_non_bonded_force(std::size_t pair, double normal, double shear) {
    non_bonded_.keep(pair, normal, shear);
  }

  // After the state was restored: loads follow from the far field [Pa] and domain 0, the stable step from all (forces are found
  // anew in every cycle).
  void after_restore(double sigma_Hmax, double sigma_hmin);
  const KernelArrays& arrays() const { return arrays_; }

  // Where a number of discs or pores is not finite, and by which equation it moves: ", at disc 7 near ..."; empty: nowhere.
  [[nodiscard]] std::string first_not_finite() const;

 private:
  // What one worker found in a batch.
  struct Found {
    std::vector<Crack> cracks;
    std::vector<std::int64_t> to_facets;  // bonds that break
  };
  // What a batch came to, over the whole model.
  struct Sums {
    double unbalanced = 0.0, contact = 0.0;  // N, sums of |f_x| + |f_y|
    Boundary::RigidMotion momenta{};
    bool no_memory = false, broken = false;
  };
  void batch(std::int64_t cycles, std::vector<Found>& found);
  void begin_on_device();
  void take_contents();
  void batch_on_device(std::int64_t cycles, std::vector<Found>& found);
  void fetch_state();
  void evaluate_on_device();
  void evaluate_own();
  void begin_evaluation();
  template <class PartOf>
  void answer_once(std::int64_t parts, const PartOf& part_of, std::int64_t first_tile,
                   std::int64_t last_tile);
  void take_works();
  void take_own_works();
  void forget_works_of_others();
  template <class Fetch>
  void fetch_or_lose(const Fetch& fetch) const;
  static void take_work(TileSums& sums, ExactSum& total);
  Sums sum_up(const std::vector<Found>& found);
  std::vector<Crack> cracks_of(std::vector<Found>& found) const;
  void hold_still(const Sums& sums);
  void show_everywhere();
  void break_across(std::int64_t cycle, Found& found);
  void take_facets();
  void break_into_facets(std::int64_t cycle, std::vector<Found>& found);
  void begin_smooth_joints();
  void answer_smooth_joints(std::int64_t part, std::int64_t cycle, Found& found);
  void list_pushed();
  void put_loads();
  void release_pushed();
  [[nodiscard]] bool may_block() const;
  void mark_left_alone();
  void run_blocked(std::int64_t cycles, std::vector<Found>& found);
  [[nodiscard]] bool is_held(std::int64_t bond) const;
  bool break_cross_bonds(std::int64_t pair, std::int64_t cycle, Found& found);
  void take_pairs(std::int64_t part, std::int64_t cycle, Found& found);
  void take_tile(std::int64_t tile, std::int64_t cycle, double* scratch, Found& found);
  void break_bond(const BondView& bond, std::int64_t e, std::int64_t cycle, std::vector<Crack>& found);
  void log_softened(Crack& crack) const;
  bool break_bonds(std::int64_t first, std::int64_t last, std::int64_t cycle, Found& found);
  void stiffness(std::span<double> row_x, std::span<double> row_y, std::span<double> row_rotation) const;
  [[nodiscard]] double force_ratio(const Sums& sums);
  void bind_arrays();
  [[nodiscard]] double kinetic_of(std::size_t first, std::size_t last) const;

  Assembly& assembly_;
  Network& network_;
  Energies& energies_;
  std::int64_t& total_cycles_;
  Boundary& boundary_;
  ContactPairs& contacts_;  // those of non_bonded_
  NonBondedContacts non_bonded_;
  const Options& options_;
  Workers& workers_;
  // Of a cycle: parts across tiles, those that need other ranks' discs, tiles.
  Workers::Pass parts_left_, outer_parts_left_, tiles_left_;
  const KernelTable& kernels_;
  Fragments fragments_;
  // For the kernels: contacts of smooth joints before each part (SmoothArrays::from), their laws, and the forces of laws they do not know.
  std::vector<std::int64_t> smooth_from_;
  Array<SmoothLaw> smooth_laws_;
  Array<SmoothForces> smooth_forces_;
  // Discs on which the boundary's load, constant while a batch of cycles lasts, is not all there is: non-bonded contacts and facets add to
  // it in every cycle.
  struct PushedDisc {
    std::int32_t disc;
    bool outermost, walled;
    Vec2 load;  // N
  };
  std::vector<PushedDisc> pushed_;
  FacetMotion facets_;
  FacetRules facet_rules_;
  std::int64_t facets_seen_ = 0;                  // FacetMotion::changes
  std::atomic<std::int64_t> facets_to_come_{-1};  // cycle in which a bond was found that breaks
  double time_ = 0.0;
  std::int64_t cycles_then_ = 0;
  std::vector<char> held_;  // per disc: its bonds do not break; empty: none
  TilePlan plan_;
  const Device* device_ = nullptr;
  std::unique_ptr<DeviceCycles> device_cycles_;  // once there were some
  bool on_device_ = false;                       // the cycles at hand
  bool stays_ = false, spoils_ = false;
  mutable bool away_ = false;  // the device has the newest state
  mutable bool lost_ = false;  // it had, and failed
  bool kept_ = false;          // a copy of what it had as the step began
  SharedTiles shared_;
  std::vector<Found> dropped_;          // by worker: what another rank finds, too
  std::atomic<bool> no_memory_{false};  // in the batch at hand
  KernelArrays arrays_{};
  Array<double> inverse_mass_, inverse_inertia_;
  Array<double> filled_;  // m2, per domain: content and growth, of water that feels temperature; else empty
  std::vector<Array<double>> scratch_;  // one per worker
  BlockedBatch blocked_;                // empty where the caches hold the model
  std::vector<TileSums> bond_sums_, disc_sums_, domain_sums_;
  double real_step_ = 0.0;
  bool scaled_ = true, undrained_ = false;
};

}  // namespace hfrac
