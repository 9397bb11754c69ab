// SPDX-License-Identifier: BSD-3-Clause
// The elastic plane without end around a hole: what forces hold the hole's rim at given displacements.
//
// In two dimensions a ring around the hole has the same stiffness as its copy of twice the size: strains halve and the ring is
// twice as wide. So one thin ring of finite elements is enough. With [A B; B' C] its stiffness, inner side first, two of them, one around
// the other, condensed to their outermost sides are
//   S = C + A,   A <- A - B inverse(S) B',   C <- C - B' inverse(S) B,   B <- -B inverse(S) B
// a ring as thick as both. Doubled ten times it reaches as far as anything (Silvester, Lowther, Carpenter and Wyatt 1977, Proc. IEE 124,
// 1267-1270, "ballooning"; Dasgupta 1982, J. Appl. Mech. 49, 136-140, "cloning"), and A is what its inner side answers with the
// outer side at rest. That is symmetric and positive definite by construction, where boundary elements by collocation are neither.
//
// Held at rest far away, the plane resists a turn of the hole, as it has to: 4 pi G a^2 for a circle. A net force on a hole moves it
// the farther the farther away the plane is held, by the logarithm of that distance; here it is held at a thousand times the hole's size.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

// Rock as a plane: strain x = (s_x - poisson s_y) / modulus. In plane strain modulus is E' = E / (1 - nu^2) and poisson nu / (1 - nu).
struct PlaneElasticity {
  double modulus = 0.0;  // Pa
  double poisson = 0.0;
};

// The rim's points anticlockwise, an even number of them; pieces of the rim are parabolas through points 2 k to 2 k + 2. Unknowns: x and y
// of every point; forces [N/m of thickness] per displacement [m]. Empty if a ray from `centre` meets the rim more than once.
Eigen::MatrixXd infinite_plane_stiffness(const std::vector<Vec2>& rim, Vec2 centre,
                                         const PlaneElasticity& rock);

}  // namespace hfrac
