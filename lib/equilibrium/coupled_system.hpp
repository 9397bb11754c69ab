// SPDX-License-Identifier: BSD-3-Clause
// The equations of one quasi-static step: equilibrium of every disc and the fluid's mass in every domain, together.
//
//   forces of bonds, contacts, walls and far field + W p = 0                        (eq. 11, 12 without inertia; eq. 9-14)
//   V / K_f (p - p_ref) + W' u = zeta + dt (sum q + source),  q = w^3 / (12 eta L) dp     (eq. 6-8, backward Euler)
//   p >= floor; a domain at the floor is a void that fills first
// With dt = 0 pores answer undrained. Apertures are those of the unknown displacements. Unknowns and equations are scaled
// (lengths by 1 m, forces by k_n, rotations by 1 / R, pressures by k_n / R), so that they are alike in size; the tangent is then
//   [ K  -W ; -W'  -(S + dt C) ],
// which is symmetric but for sliding contacts and for the change of apertures, and quasi-definite: it has a factor L D L'
// in any order of elimination, without pivoting (Vanderbei 1995).
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "equilibrium/bond_response.hpp"
#include "equilibrium/dissection.hpp"
#include "flow/network.hpp"
#include "solid/boundary.hpp"
#include "solid/loose_contacts.hpp"

namespace hfrac {

class CoupledSystem {
 public:
  using Vector = Eigen::VectorXd;

  CoupledSystem(Assembly& assembly, Network& network, Boundary& boundary, const LooseContacts& loose,
                const Options& options);

  // What the step starts from: contents, shear forces and pins as they stand now. `duration` [s] of flow, 0 for none;
  // source[d] [m2/s] into domain d.
  void begin(double duration, const std::vector<double>& source);

  // Contacts that were never bonded slide from here on.
  void keep_pairs();

  // Forces, apertures and residual at the displacements and pressures as they stand.
  void evaluate();
  [[nodiscard]] const Vector& residual() const { return residual_; }
  // Mean unbalanced over mean contact force; largest error of a pressure over the largest pressure difference.
  [[nodiscard]] double force_ratio() const { return force_ratio_; }
  [[nodiscard]] double pressure_error() const { return pressure_error_; }

  // y = tangent x at the last evaluation.
  void product(const Vector& x, Vector& y) const;
  // Displacements and pressures change by `share` of x.
  void move(const Vector& x, double share);
  // Largest change of a displacement in x [m].
  [[nodiscard]] double largest_move(const Vector& x) const;

  // The symmetric part of the tangent, lower triangle, for factors.
  void symmetric_part(std::vector<Eigen::Triplet<double>>& entries) const;
  [[nodiscard]] Eigen::Index size() const { return residual_.size(); }
  // Order of elimination of the unknowns.
  [[nodiscard]] std::vector<Eigen::Index> order() const;

  // Forces of a contact that was never bonded [N]: pressed together, and along it.
  [[nodiscard]] double pair_normal_force(std::size_t pair) const { return -pairs_[pair].normal; }
  [[nodiscard]] double pair_shear_force(std::size_t pair) const { return pairs_[pair].shear; }

  // Content of every domain and flow of every pipe after the step.
  void keep_flow();

 private:
  struct Pin {
    std::int32_t disc;
    Vec2 along;
    double start;
  };
  [[nodiscard]] Eigen::Index pressure_at(std::int64_t domain) const { return 3 * discs_ + domain; }
  [[nodiscard]] Eigen::Index wall_at(std::size_t wall) const {
    return 3 * discs_ + domains_ + static_cast<Eigen::Index>(wall);
  }
  void add_pair(const BondResponse& r, std::int32_t i, std::int32_t j);
  void pair_product(const double* tangent, std::int32_t i, std::int32_t j, const Vector& x, Vector& y) const;
  void pair_entries(const double* tangent, std::int32_t i, std::int32_t j,
                    std::vector<Eigen::Triplet<double>>& entries) const;
  void evaluate_walls();
  void evaluate_pipes();
  void evaluate_domains();
  void measure();

  Assembly& assembly_;
  Network& network_;
  Boundary& boundary_;
  const LooseContacts& loose_;
  const Options& options_;
  std::int64_t discs_, domains_;
  std::size_t servo_walls_ = 0;
  bool wet_, closed_outside_;
  double force_scale_, length_scale_, pressure_scale_;
  double duration_ = 0.0;
  std::vector<double> source_, content_start_;
  std::vector<PairStart> pair_start_;
  std::vector<Pin> pins_;
  // at the last evaluation
  std::vector<BondResponse> bonds_, pairs_;
  std::vector<double> aperture_change_;  // per pipe: d(flow) / d(gap) dt
  std::vector<char> at_floor_;           // per domain: pressure follows no content
  Vector residual_;
  double contact_force_ = 0.0, force_ratio_ = 0.0, pressure_error_ = 0.0;
};

}  // namespace hfrac
