// SPDX-License-Identifier: BSD-3-Clause
// The elastic rock beyond the model, without end, as its answer to what the outer loop of discs does (boundary.kind infinite).
//
// Points along the loop, some four discs apart and one at each corner, stand for it: with hat functions N between them and w the length of
// loop that belongs to a disc, the displacement U of the points is that of least squares,
//   M U = sum w N (u - u_rest),   M = sum w N N'
// and what the plane around a hole with these points as its rim (infinite_plane.hpp) answers, -K U, goes back to the discs by the same
// weights. On the discs the exterior so has the stiffness  w N H N' w  with  H = inverse(M) K inverse(M),  symmetric and positive
// semi-definite, of as many ranks as points have displacements: a product with H, a few tens wide, in every cycle. The points themselves lie
// where least squares puts the discs' places, so a shift or a turn of all discs is exactly one of the points. What changes from disc to disc the
// exterior does not resist; rock is strained by that no deeper than a few discs.
//
// u_rest is where the far field alone leaves the loop: in a model without holes and fractures the exterior bears nothing (step/exterior_rock.hpp).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/assembly.hpp"
#include "model/network.hpp"
#include "solid/infinite_plane.hpp"

namespace hfrac {

class Exterior {
 public:
  // Throws Error(model) if the outer loop is no rim that a plane can be around.
  Exterior(const Assembly& assembly, const Network& network, const PlaneElasticity& rock);

  struct RimDisc {
    std::int32_t disc;
    std::array<std::int32_t, 2> point;  // between which it lies
    std::array<double, 2> weight;       // m: its length of loop, by share
  };
  // In order along the loop; a disc that the loop passes twice stands there twice.
  [[nodiscard]] const std::vector<RimDisc>& rim() const { return rim_; }
  [[nodiscard]] std::size_t size() const { return point_.size() * 2; }  // unknowns of the points
  [[nodiscard]] const std::vector<Vec2>& points() const { return point_; }
  [[nodiscard]] const PlaneElasticity& rock() const { return rock_; }

  // Displacements of the rim's discs, in its order, under the far field with which the model begins [m].
  void rest_at(std::span<const Vec2> displacement);
  // The far field is by so much larger than that [Pa, compression positive]: the exterior rests elsewhere.
  void add_far_field(double along_x, double along_y);

  // Tractions of the points [Pa] at the displacements as they stand, the far field being on by `share`; to be read by force_on.
  void answer(const Assembly& assembly, double share);
  // On a disc of the rim [N], of its length of loop there.
  [[nodiscard]] Vec2 force_on(const RimDisc& place) const;
  // Elastic energy beyond the rim [J/m].
  [[nodiscard]] double energy(const Assembly& assembly, double share) const;

  // Row sums of its stiffness on the discs, at most [N/m].
  void add_stiffness(std::span<double> row_x, std::span<double> row_y) const;
  // Sums w N u over the rim [m2] per traction of the points [Pa]: inverse(H), for the quasi-static solver.
  [[nodiscard]] const Eigen::MatrixXd& compliance() const { return compliance_; }

 private:
  void lay_points(const Assembly& assembly, const Network& network);
  void sum_up(const Assembly& assembly, double share, std::vector<double>& sums) const;

  PlaneElasticity rock_;
  std::vector<RimDisc> rim_;
  std::vector<Vec2> point_;  // m, from the middle of the rim
  Eigen::MatrixXd mass_;     // m: M
  Eigen::MatrixXd stiffness_, compliance_;
  std::vector<double> rest_, far_rest_;       // m2: sums w N u_rest, as the model begins and now
  std::vector<double> displaced_, traction_;  // m2, Pa: of the last answer
};

}  // namespace hfrac
