// SPDX-License-Identifier: BSD-3-Clause
// The rock that discs make, measured: the same packing without holes, joints and strengths to exceed, on the stress boundary, drained, at
// rest under the far field. Its strain under a little more stress along x and along y, over the inner 70 % of its sides, gives E' and nu'.
// Where fluid stays in its pores the rock is stiffer (Rice and Cleary 1976, Rev. Geophys. Space Phys. 14, 227-241), with plane-strain
// moduli
//   K_u = K + alpha^2 M,   E'_u = 4 G K_u / (K_u + G),   nu'_u = (K_u - G) / (K_u + G)
#pragma once

#include <optional>

#include "build/build_model.hpp"
#include "equilibrium/equilibrium_solver.hpp"
#include "solid/exterior.hpp"
#include "step/engine.hpp"

namespace hfrac {

class RockBlock {
 public:
  // At rest under the far field. `packing`: the model's, before wells were cut. Throws Error(collapsed) where no rest is found.
  RockBlock(const CaseDefinition& definition, Packing packing, const Ranks& ranks);
  // E' [Pa] and nu' under the far field, undrained where the model has flow. The first call leaves the block under other stresses.
  [[nodiscard]] PlaneElasticity measure();
  [[nodiscard]] const Assembly& assembly() const { return model_.assembly; }

 private:
  struct Strain {
    double x, y;  // contraction positive
  };
  void load(double sigma_Hmax, double sigma_hmin);
  [[nodiscard]] Strain strain() const;
  [[nodiscard]] double storing() const;

  bool exterior_;  // asked for by boundary.kind infinite; else by fracture.plane_modulus
  std::optional<PlaneElasticity> measured_;
  CaseDefinition definition_;
  Model model_;
  Engine engine_;
  EquilibriumSolver solver_;
};

}  // namespace hfrac
