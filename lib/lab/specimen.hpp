// SPDX-License-Identifier: BSD-3-Clause
// A piece of bonded rock on the bench: cut to shape, slit where a crack is wanted, held or loaded from outside.
//
// Rock is held in one of three ways, and which one a test takes stands with the test (laboratory.hpp):
//   platens   the discs at the lower and upper end are led along y; they slide sideways and turn freely (no friction)
//   tractions constant loads on the outer loop of bonds, as the far field of a simulation
//   fluid     a pressure in the pores that touch a slit or crack, the rest drained
// Equilibrium is found by the quasi-static solver (equilibrium/equilibrium_solver.hpp), which breaks bonds in order.
//
// Stress is force over the nominal section (unit thickness). Strain is the least-squares slope of the discs' displacement
// over the gauge, the inner 70 % of either side, so that what platens and free sides do differently does not count.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "core/workers.hpp"
#include "equilibrium/equilibrium_solver.hpp"
#include "geom/packing.hpp"
#include "model/model.hpp"
#include "solid/boundary.hpp"
#include "solid/explicit_solver.hpp"

namespace hfrac {

struct SpecimenShape {
  double width = 0.0, height = 0.0;         // m; of a round one the diameter, twice
  bool round = false;                       // a disc cut from a square
  bool wet = false;                         // with pores that take a pressure
  double slit_begin = 0.0, slit_end = 0.0;  // m along x at half height; equal: no slit
  double stress_x = 0.0, stress_y = 0.0;    // Pa at load 1, compression positive: tractions
};

struct Strain {
  double axial = 0.0, lateral = 0.0;  // along y and x, extension positive
};

class Specimen {
 public:
  // `material` gives contacts, bonds and fluid; its shape, wells, stresses and solver do not count.
  Specimen(const Packing& packing, const Options& material, const SpecimenShape& shape);
  Specimen(const Specimen&) = delete;  // its parts hold each other's addresses
  Specimen& operator=(const Specimen&) = delete;

  // Platens at both ends; bonds of the discs they hold do not break, as in a specimen with thickened ends. `half_angle`
  // [rad] > 0: on the rim of a round one, within that angle of the y axis; then the ends of the round do not break
  // either.
  void grip_ends(double half_angle = 0.0);
  // Both platens move apart by half of `elongation` [m] each.
  void lead_ends(double elongation);
  // Force with which the platens pull [N], mean of both.
  [[nodiscard]] double pull() const;
  // Tractions at `share` of those of the shape.
  void load_sides(double share) { boundary_->set_load(model_.assembly, share); }
  // Pressure [Pa] in every pore that touches a broken bond of the slit or connected to it.
  void pressurise(double pressure);
  void make_unbreakable();

  // Equilibrium at the loads as they stand. Bonds break unless the largest stress over strength is above most_excess. Between
  // platens, where a disc has lost its hold and Newton's method finds no rest, the explicit solver lets it move to one, and bonds
  // that break on the way are broken. Under constant load there may be no rest to find: that is failure. Bonds that soften keep what
  // they come to on the way, so there the loading goes back first (loading.cpp).
  EquilibriumSolver::Outcome solve(double most_excess, const std::function<bool()>& interrupt = {});

  [[nodiscard]] Strain strain() const;
  // Largest stress over strength of an intact bond.
  [[nodiscard]] double largest_excess() const;
  // Whether its bonds soften; largest stress over strength of one that does not yet, 1 or more if one does.
  [[nodiscard]] bool softens() const { return !model_.assembly.softening.empty(); }
  [[nodiscard]] double largest_stress() const { return hfrac::largest_stress(model_.assembly, options_); }
  // What is stored, what softening bonds have taken [J/m], and the work of platens and tractions on the way from one of two equilibria to the
  // next, by the mean of a platen's forces.
  struct Account {
    double stored, taken, tractions, elongation, pull;  // J/m, J/m, J/m, m, N
    // Work since `before` less what has become of it: what was lost on the way, and below 0 nothing real [J/m].
    [[nodiscard]] double lost_since(const Account& before) const {
      return 0.5 * (pull + before.pull) * (elongation - before.elongation) + tractions - before.tractions -
             (stored - before.stored) - (taken - before.taken);
    }
  };
  [[nodiscard]] Account account() const;
  // What an equilibrium that was not found leaves behind is put back by these.
  void keep();
  void go_back();
  // Damped motion at the loads as they stand to an equilibrium, if there is one (where softening rock gives way Newton's method may find none).
  EquilibriumSolver::Outcome settle(const std::function<bool()>& interrupt);
  // How far the faces of the slit stand apart, bond by bond: x from the slit's middle [m], opening along y [m].
  [[nodiscard]] std::vector<Vec2> opening() const;
  // Where the slit ends along x [m], each tip half way between the last bond cut and the first one that holds.
  [[nodiscard]] Vec2 tips() const { return tips_; }

  [[nodiscard]] const Assembly& assembly() const { return model_.assembly; }
  [[nodiscard]] const Network& network() const { return model_.network; }
  Network& network() { return model_.network; }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] const SpecimenShape& shape() const { return shape_; }
  [[nodiscard]] const CrackLog& cracks() const { return model_.cracks; }
  [[nodiscard]] std::int64_t cracks_in(CrackMode mode) const;
  [[nodiscard]] double coordination() const;
  [[nodiscard]] int factors() const { return factors_; }
  [[nodiscard]] int relaxations() const { return relaxations_; }  // by the explicit solver

 private:
  void cut_slit();

  Options options_;
  SpecimenShape shape_;
  Model model_;
  std::unique_ptr<Boundary> boundary_;
  std::unique_ptr<Workers, Workers::Release> workers_;
  std::unique_ptr<ExplicitSolver> mechanics_;
  Facets facets_;  // none: specimens break by strength
  std::unique_ptr<EquilibriumSolver> equilibrium_;
  std::vector<std::int64_t> slit_;  // its bonds
  std::vector<std::byte> kept_;
  Vec2 tips_;                          // begin, end
  std::size_t lower_ = 0, upper_ = 0;  // grips of either platen: [0, lower_), [lower_, upper_)
  int factors_ = 0, relaxations_ = 0;
  double elongation_ = 0.0;
};

}  // namespace hfrac
