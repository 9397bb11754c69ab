// SPDX-License-Identifier: BSD-3-Clause
// What holds the model from outside: far-field stress on the outermost discs, or four rigid walls.
//
// stress  Each edge of the outer loop of bonds carries stress times length, half to each of its discs: no net force and no
//         net torque, for any uniform stress. (The part that balances the pore pressure is split by the pores' own weights
//         instead, so that a stress equal to the pore pressure leaves every disc in peace.) Fixed forces on a free body
//         pressed together are in unstable balance: the least turn of the whole gives them a lever. Rock around the
//         model would hold it, so its mean displacement and rotation are taken out now and then (remove_rigid_motion).
// walls   Frictionless rigid walls press on the discs that touch them at set-up, with the contacts' stiffness and no
//         tension. While a wall is servo-driven it is a body with one degree of freedom whose unbalanced force is
//         target stress times length minus what the discs push back; afterwards it may be fixed.
// infinite The forces of `stress`, and besides those of the elastic rock beyond (exterior.hpp), which change with the displacements.
// Besides, single discs may be gripped (the laboratory's platens): led along one direction to where they are told, free across
// it and in rotation, by a spring of the contacts' stiffness.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/model.hpp"
#include "options/options.hpp"
#include "solid/exterior.hpp"

namespace hfrac {

class Boundary {
 public:
  // Finds the discs it acts on; puts the far field of the options on, at load 0.
  Boundary(Model& model, const Options& options);

  // The rock beyond answers from here on (kind infinite).
  void engage(std::unique_ptr<Exterior> exterior);
  [[nodiscard]] const Exterior* exterior() const { return exterior_.get(); }
  // Its forces at the displacements as they stand: load_on() has them until the next call.
  void answer(const Assembly& assembly);

  // Share of the far-field stress in force, 0 to 1 (for loading in stages).
  void set_load(Assembly& assembly, double share);

  // One cycle: forces of walls and of the rock beyond on their discs into external_*, motion of servo-driven walls. `step` as the solver's.
  void cycle(Assembly& assembly, double step, double safety, double damping);

  // The forces of walls at rest on the discs from `first` up to `last`, as cycle() finds them; those of other discs stay.
  void press(Assembly& assembly, std::int64_t first, std::int64_t last) const;
  // Nothing from outside needs to know of more than one disc: no wall moves, no disc is gripped, no rock beyond answers.
  [[nodiscard]] bool acts_disc_by_disc() const { return !walls_move() && grips_.empty() && !exterior_; }

  // Takes the mean displacement and rotation since bonding, and their rates, out of a model held by nothing else. In parts: sums
  // over some discs, to be added up; then what the sums of all come to, out of one disc.
  void remove_rigid_motion(Assembly& assembly) const;
  using RigidMotion = std::array<double, 6>;  // along x and y and turning, and their rates
  [[nodiscard]] bool holds_still() const { return !walled_ && !exterior_ && grips_.empty(); }
  [[nodiscard]] RigidMotion momenta(const Assembly& assembly, std::int64_t first, std::int64_t last) const;
  [[nodiscard]] RigidMotion motion_of(RigidMotion momenta) const;
  void take_out(Assembly& assembly, const RigidMotion& motion, std::int64_t disc) const;

  // Adds the share of walls and rock beyond to the row sums of stiffness that set the stable step.
  void add_stiffness(std::span<double> row_x, std::span<double> row_y) const;

  // The force of far field and rock beyond on a disc now [N], and whether it is written anew in every cycle: of a wall's discs, of those gripped, of the
  // rim's.
  [[nodiscard]] Vec2 load_on(std::int32_t disc) const;
  [[nodiscard]] bool touches_wall(std::int32_t disc) const;

  void fix_walls() { state_.servo = false; }
  // Moves a servo-driven wall inward by `by` [m] (quasi-static solver).
  void shift_wall(std::size_t wall, double by) {
    state_.walls[wall].displacement += by;
    state_.work += state_.load * state_.walls[wall].target * state_.walls[wall].length * by;
  }
  [[nodiscard]] bool follows_far_field() const { return !walled_ || state_.servo; }
  // New far-field stress [Pa], total where stress.convention is total; the share in force stays.
  void set_far_field(Assembly& assembly, double sigma_Hmax, double sigma_hmin);
  // Likewise another pressure in the pores outside, that of domain 0 [Pa]; the total far-field stress stays.
  void set_outside_pressure(Assembly& assembly, const Network& network, double sigma_Hmax, double sigma_hmin);
  // The loads follow again from domain 0 and the far field after a state was loaded.
  void restore_load(Assembly& assembly, const Network& network, double sigma_Hmax, double sigma_hmin);

  // What stress at each disc of the outer boundary, in its order [Pa; xx, yy, xy, compression positive], comes to as forces on those
  // discs [N] (BoundaryState::cell_load; stress boundaries only). What net force and moment the tractions leave is taken out.
  [[nodiscard]] std::vector<Vec2> load_of_stress(const Assembly& assembly, const Network& network,
                                                 std::span<const double> stress) const;

  [[nodiscard]] bool walled() const { return walled_; }

  // Mean normal stress on the walls along x and y [Pa], compression positive, without pore pressure outside.
  [[nodiscard]] Vec2 wall_stress(const Assembly& assembly) const;
  // Likewise on one wall [Pa].
  [[nodiscard]] double wall_stress(const Assembly& assembly, std::size_t wall) const;
  [[nodiscard]] bool walls_move() const { return walled_ && state_.servo; }
  // Largest unbalanced force on a wall over its target, or 0 when fixed.
  [[nodiscard]] double wall_imbalance() const { return state_.servo ? state_.imbalance : 0.0; }
  // What a device needs to know of them and finds (device_cycles.hpp): share of the far field in force; N/m; kg, or by scaled masses; J/m.
  [[nodiscard]] double load() const { return state_.load; }
  [[nodiscard]] double contact_stiffness() const { return stiffness_; }
  [[nodiscard]] double wall_mass(const Wall& wall, double step, double safety) const {
    // Stable with the step in use, as light as that allows (a servo has no inertia of its own).
    return 0.5 * step * step * stiffness_ * static_cast<double>(wall.discs.size()) / (safety * safety);
  }
  [[nodiscard]] double wall_work() const { return state_.work; }
  void note_walls(double work, double imbalance) {
    state_.work = work;
    state_.imbalance = imbalance;
  }
  [[nodiscard]] Vec2 centre() const { return centre_; }  // m, of mass
  // Energy stored in wall contacts now [J/m].
  [[nodiscard]] double wall_energy(const Assembly& assembly) const;
  // Energy stored in the rock beyond now [J/m].
  [[nodiscard]] double exterior_energy(const Assembly& assembly) const {
    return exterior_ ? exterior_->energy(assembly, state_.load) : 0.0;
  }
  // The constant force of the far field on each disc [N] (stress boundary), for the work it does.
  [[nodiscard]] double load_work(const Assembly& assembly) const;

  struct Grip {
    std::int32_t disc;
    Vec2 along;     // unit vector
    double target;  // m, displacement along it
  };
  std::vector<Grip>& grips() { return grips_; }
  [[nodiscard]] const std::vector<Grip>& grips() const { return grips_; }
  // Forces on some discs change with every cycle.
  [[nodiscard]] bool reacts() const { return walled_ || !grips_.empty() || exterior_; }
  // Force of a grip on its disc, along its direction [N].
  [[nodiscard]] double grip_force(const Assembly& a, const Grip& grip) const {
    return stiffness_ * (grip.target - (a.ux[grip.disc] * grip.along.x + a.uy[grip.disc] * grip.along.y));
  }

  // Outermost discs, or those at walls; ascending.
  [[nodiscard]] const std::vector<std::int32_t>& edge() const { return edge_; }
  // How far a disc is pressed into a wall [m], with what it grew by temperature.
  [[nodiscard]] static double closing_of(const Assembly& a, const Wall& wall, std::int32_t i) {
    return wall.displacement - (a.ux[i] * wall.inward.x + a.uy[i] * wall.inward.y) + a.thermal.growth_of(i);
  }
  // Force of a wall on one of its discs [N]: contacts' stiffness, no tension.
  [[nodiscard]] static double push_of(const Assembly& a, const Wall& wall, std::int32_t i, double stiffness) {
    return stiffness * std::max(0.0, closing_of(a, wall, i));
  }
  // Where a wall stands along its normal's axis [m].
  [[nodiscard]] double wall_position(std::size_t wall) const {
    const Wall& w = state_.walls[wall];
    return wall_start_[wall] + (w.inward.x + w.inward.y) * w.displacement;
  }
  [[nodiscard]] const std::array<Wall, 4>& walls() const { return state_.walls; }
  std::array<Wall, 4>& walls() { return state_.walls; }

 private:
  void put_outside_pressure(const Network& network);
  [[nodiscard]] std::size_t place_of(std::int32_t disc) const;  // in edge_
  void put_far_field(double sigma_Hmax, double sigma_hmin);
  void push_rim(Assembly& assembly);

  BoundaryState& state_;
  double sigma_Hmax_, sigma_hmin_;  // Pa, with which the model begins
  bool walled_, wet_;
  double stiffness_;
  double mass_ = 0.0, inertia_ = 0.0;   // kg, kg m2 per metre, about
  Vec2 centre_{};                       // m
  std::array<double, 4> wall_start_{};  // m
  double outside_pressure_ = 0.0;       // Pa, what walls leave to the pores outside
  std::vector<std::int32_t> edge_;      // outermost discs, or those at walls; ascending
  std::vector<Vec2> pore_;              // N: what balances the pores' pressure at the start
  std::vector<Vec2> weight_;            // m: force per stress beyond that along x, y
  std::vector<Vec2> load_on_;           // N at full load
  std::unique_ptr<Exterior> exterior_;  // follows from the model
  std::vector<std::size_t> rim_place_;  // in edge_, of the exterior's rim
  std::vector<Vec2> answer_;            // N: the exterior's, per disc of edge_
  std::vector<Grip> grips_;             // no part of a state: the laboratory takes none
};

}  // namespace hfrac
