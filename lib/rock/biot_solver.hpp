// SPDX-License-Identifier: BSD-3-Clause
// Plane-strain poroelasticity of a continuum (eq. 1-3 of the paper; Biot 1941) by finite elements.
//
// Unknowns are the displacement u and the pore pressure p. Balance of forces holds at every moment, fluid is stored and flows:
//     div sigma = 0,   sigma = lambda div(u) I + 2 G sym(grad u) - alpha p I      (tension positive here)
//     d/dt (alpha div u + p / M) = div (k/eta grad p)
// Both are solved together, so nothing is split that could drift apart. Time steps are those of TR-BDF2 (Bank et al. 1985):
// second order, and what is sharp at the start dies out; the first step after a change of the loads is backward Euler.
//
// Loads and results are compression-positive, as everywhere in hfrac. Not for the step loop: it allocates.
#pragma once

#include <array>
#include <vector>

#include "linear/sparse.hpp"
#include "rock/biot_material.hpp"
#include "rock/rock_mesh.hpp"

namespace hfrac {

// How a side may move. Sides whose normal is held or tied are straight and along an axis; along the side they slide freely.
enum class SideMotion {
  free,        // under the stress given
  held,        // no motion along the normal
  rigid_plate  // all of it moves by the same amount along the normal
};

struct PlaneStress2 {
  double xx = 0.0, yy = 0.0, xy = 0.0;  // compression positive [Pa]
};

class BiotSolver {
 public:
  struct Side {
    RockSide side;
    SideMotion motion = SideMotion::free;
    bool drained = false;  // at the pressure given; else no flow across it
  };
  // Sides not named are free and sealed. What would float is held at as few points as do it.
  BiotSolver(RockMesh mesh, const BiotMaterial& material, const std::vector<Side>& sides);

  void set_stress(RockSide side, const PlaneStress2& total);  // [Pa]; zero at first
  void set_pressure(RockSide side, double pressure);          // of a drained side [Pa]; zero at first

  // The answer to the present loads from the unloaded state when there is no time to flow.
  void load_undrained();
  // The state under the present loads after infinite time. Without a drained side nothing can leave: as load_undrained.
  void load_steady();
  // `step` seconds on.
  void advance(double step);

  [[nodiscard]] const RockMesh& mesh() const { return mesh_; }
  [[nodiscard]] Vec2 displacement(std::int32_t node) const;  // [m]
  [[nodiscard]] double pressure(std::int32_t corner) const;  // at the corner of an element [Pa]
  // Fluid that leaves through a drained side in the steady state, per unit thickness [m2/s].
  [[nodiscard]] double steady_outflow(RockSide side) const;

  // Inside element e at reference coordinates -1..1.
  struct Sample {
    Vec2 place;          // [m]
    Vec2 displacement;   // [m]
    double pressure;     // [Pa]
    PlaneStress2 total;  // [Pa]
  };
  [[nodiscard]] Sample sample(std::size_t element, double s, double t) const;

 private:
  using Matrix = SparseMatrix;
  using Vector = Eigen::VectorXd;

  void number_motion(const std::vector<Side>& sides);
  void number_pressures(const std::vector<Side>& sides);
  void assemble();
  void fill_loads();
  void solve(double storing, double flowing, bool imposed, const Vector& right);
  [[nodiscard]] Vector stored() const;

  RockMesh mesh_;
  BiotMaterial material_;
  std::vector<std::array<std::int32_t, 2>> equation_;  // by node: of u_x and u_y; -1 held
  std::vector<std::int32_t> corner_;                   // by node: number among the pressures; -1 none
  std::vector<std::int32_t> drained_side_;             // by pressure: its RockSide; -1 free
  std::array<PlaneStress2, 5> stress_{};
  std::array<double, 5> imposed_pressure_{};
  std::int32_t motions_ = 0, pressures_ = 0;
  // Scaled by Young's modulus so that all entries are of one size: pressures in units of it.
  Matrix stiffness_, coupling_, storage_, flow_;
  Vector load_, u_, p_;
  bool fresh_ = true;
  double factored_storing_ = -1.0, factored_flowing_ = -1.0;
  bool factored_imposed_ = false;
  std::vector<std::int32_t> unknown_;  // by pressure: its row after the motions; -1 imposed
  Matrix system_;
  GeneralFactor factor_;
};

}  // namespace hfrac
