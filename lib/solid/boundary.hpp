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
// Besides, single discs may be gripped (the laboratory's platens): led along one direction to where they are told, free across
// it and in rotation, by a spring of the contacts' stiffness.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "flow/network.hpp"
#include "solid/assembly.hpp"

namespace hfrac {

class Boundary {
 public:
  Boundary(const Assembly& assembly, const Network& network, const Options& options);

  // Share of the far-field stress in force, 0 to 1 (for loading in stages).
  void set_load(Assembly& assembly, double share);

  // One cycle: forces of the walls on their discs into external_*, motion of servo-driven walls. `step` as the solver's.
  void cycle(Assembly& assembly, double step, double safety, double damping);

  // The forces of walls at rest on the discs from `first` up to `last`, as cycle() finds them; those of other discs stay.
  void press(Assembly& assembly, std::int64_t first, std::int64_t last) const;
  // Nothing from outside needs to know of more than one disc: no wall moves, no disc is gripped.
  [[nodiscard]] bool acts_disc_by_disc() const { return !walls_move() && grips_.empty(); }

  // Takes the mean displacement and rotation since bonding, and their rates, out of a model held by nothing else.
  void remove_rigid_motion(Assembly& assembly) const;

  // Adds the walls' share to the row sums of stiffness that set the stable step.
  void add_stiffness(std::vector<double>& row_x, std::vector<double>& row_y) const;

  // The far field's force on a disc now (stress boundary) [N], and whether a disc is one of a wall's or gripped.
  [[nodiscard]] Vec2 load_on(std::int32_t disc) const;
  [[nodiscard]] bool touches_wall(std::int32_t disc) const;

  void fix_walls() { servo_ = false; }
  // Moves a servo-driven wall inward by `by` [m] (quasi-static solver).
  void shift_wall(std::size_t wall, double by) {
    walls_[wall].displacement += by;
    work_ += load_ * walls_[wall].target * walls_[wall].length * by;
  }
  [[nodiscard]] bool follows_far_field() const { return !walled_ || servo_; }
  // New far-field stress [Pa], total where stress.convention is total; the share in force stays.
  void set_far_field(Assembly& assembly, double sigma_Hmax, double sigma_hmin);
  // Likewise another pressure in the pores outside, that of domain 0 [Pa]; the total far-field stress stays.
  void set_outside_pressure(Assembly& assembly, const Network& network, double sigma_Hmax, double sigma_hmin);
  // The loads follow again from domain 0 and the far field after a state was loaded.
  void restore_load(Assembly& assembly, const Network& network, double sigma_Hmax, double sigma_hmin);

  // Stress that a host adds to the far field at each disc of the outer loop, in its order [Pa; xx, yy, xy, compression
  // positive]; stress boundaries only. What net force and moment the tractions leave is taken out.
  void set_host_stress(Assembly& assembly, const Network& network, std::span<const double> stress,
                       double sigma_Hmax, double sigma_hmin);
  // The forces that came of it, to keep them while a state is loaded; set_far_field or restore_load puts them in force.
  using HostLoad = std::vector<Vec2>;
  [[nodiscard]] const HostLoad& host_load() const { return host_; }
  void put_host_load(const HostLoad& load) { host_ = load; }

  template <class Archive>
  void visit_state(Archive& archive) {
    visit(archive, *this);
  }
  template <class Archive>
  void visit_state(Archive& archive) const {
    visit(archive, *this);
  }
  [[nodiscard]] bool walled() const { return walled_; }

  // Mean normal stress on the walls along x and y [Pa], compression positive, without pore pressure outside.
  [[nodiscard]] Vec2 wall_stress(const Assembly& assembly) const;
  // Likewise on one wall [Pa].
  [[nodiscard]] double wall_stress(const Assembly& assembly, std::size_t wall) const;
  [[nodiscard]] bool walls_move() const { return walled_ && servo_; }
  // Largest unbalanced force on a wall over its target, or 0 when fixed.
  [[nodiscard]] double wall_imbalance() const { return servo_ ? imbalance_ : 0.0; }
  // Energy stored in wall contacts now [J/m].
  [[nodiscard]] double wall_energy(const Assembly& assembly) const;
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
  [[nodiscard]] bool reacts() const { return walled_ || !grips_.empty(); }
  // Force of a grip on its disc, along its direction [N].
  [[nodiscard]] double grip_force(const Assembly& a, const Grip& grip) const {
    return stiffness_ * (grip.target - (a.ux[grip.disc] * grip.along.x + a.uy[grip.disc] * grip.along.y));
  }

  struct Wall {
    Vec2 inward;                // unit normal into the model
    double length = 0.0;        // m
    double target = 0.0;        // Pa
    double displacement = 0.0;  // m, inward
    double velocity = 0.0;
    std::vector<std::int32_t> discs;
  };
  // Outermost discs, or those at walls; ascending.
  [[nodiscard]] const std::vector<std::int32_t>& edge() const { return edge_; }
  // How far a disc is pressed into a wall [m], with what it grew by temperature.
  [[nodiscard]] static double closing_of(const Assembly& a, const Wall& wall, std::int32_t i) {
    return wall.displacement - (a.ux[i] * wall.inward.x + a.uy[i] * wall.inward.y) + a.thermal.growth_of(i);
  }
  [[nodiscard]] const std::array<Wall, 4>& walls() const { return walls_; }
  std::array<Wall, 4>& walls() { return walls_; }

 private:
  void put_outside_pressure(const Network& network);
  [[nodiscard]] std::size_t place_of(std::int32_t disc) const;  // in edge_
  void put_far_field(double sigma_Hmax, double sigma_hmin);

  template <class Archive, class Self>
  static void visit(Archive& archive, Self& s) {
    for (auto& wall : s.walls_) {
      archive.value(wall.displacement);
      archive.value(wall.velocity);
    }
    archive.value(s.servo_);
    archive.value(s.load_);
    archive.value(s.work_);
    archive.value(s.imbalance_);
    archive.value(s.carried_work_);
    archive.list(s.host_, [](auto& ar, auto& force) {
      ar.value(force.x);
      ar.value(force.y);
    });
    archive.require(s.host_.size() == s.weight_.size());
  }

  bool walled_, wet_, servo_ = true;
  double stiffness_, load_ = 0.0, work_ = 0.0, imbalance_ = 0.0, carried_work_ = 0.0;
  double outside_pressure_ = 0.0;   // Pa, what walls leave to the pores outside
  std::vector<std::int32_t> edge_;  // outermost discs, or those at walls; ascending
  std::vector<Vec2> pore_;          // N: what balances the pores' pressure at the start
  std::vector<Vec2> weight_;        // m: force per stress beyond that along x, y
  std::vector<Vec2> host_;          // N: from the host's stress
  std::vector<Vec2> load_on_;       // N at full load
  std::array<Wall, 4> walls_;
  std::vector<Grip> grips_;  // no part of a state: the laboratory takes none
};

}  // namespace hfrac
