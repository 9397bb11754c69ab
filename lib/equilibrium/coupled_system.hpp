// SPDX-License-Identifier: BSD-3-Clause
// The equations of one quasi-static step: equilibrium of every disc and the fluid's mass in every domain, together.
//
//   forces of bonds, contacts, walls and far field + W p = 0                        (eq. 11, 12 without inertia; eq. 9-14)
//   V / K_f (p - p_ref) + W' u = zeta + dt (sum q + source),  q = w^3 / (12 eta L) dp     (eq. 6-8, backward Euler)
//   p >= floor; a domain at the floor is a void that fills first
// The rock beyond the model (boundary.kind infinite) answers to its discs' displacements u by the tractions s of a few points (solid/exterior.hpp),
//   N' w u - inverse(H) s = 0,  -w N s  on the discs:
// s are unknowns of the tangent, so that it stays sparse, and follow exactly from u in the residual.
// With dt = 0 pores answer undrained. Apertures are those of the unknown displacements. Unknowns and equations are scaled
// (lengths by 1 m, forces by k_n, rotations by 1 / R, pressures by k_n / R), so that they are alike in size; the tangent is then
//   [ K  -W ; -W'  -(S + dt C) ],
// which is symmetric in pattern, and in value but for sliding contacts and the change of apertures; its symmetric part is
// quasi-definite and so has a factor in any order of elimination (Vanderbei 1995).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/rank_team.hpp"
#include "equilibrium/bond_response.hpp"
#include "flow/fluid_law.hpp"
#include "flow/wellbore_flow.hpp"
#include "frac/facets.hpp"
#include "linear/front_tree.hpp"
#include "model/network.hpp"
#include "solid/boundary.hpp"
#include "solid/non_bonded_contacts.hpp"

namespace hfrac {

class CoupledSystem {
 public:
  using Vector = Eigen::VectorXd;

  CoupledSystem(Assembly& assembly, Network& network, Boundary& boundary, const NonBondedContacts& non_bonded,
                const Options& options, Workers& workers, Facets& facets,
                std::vector<Wellbore>* wellbores = nullptr, const Ranks& ranks = {});

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

  // What the residual as it stands does along x: falls along a step, since the tangent with the domains' rows negated has a positive
  // symmetric part but for what slides and what is at the floor.
  [[nodiscard]] double work_along(const Vector& x) const;

  // Where the equations are farthest from fulfilled: the place of that disc or domain [m].
  [[nodiscard]] Vec2 worst_place() const;

  // y = tangent x at the last evaluation; of several ranks all call, and each makes its discs' and domains' rows.
  void product(const Vector& x, Vector& y) const;
  // Displacements and pressures change by `share` of x.
  void move(const Vector& x, double share);
  // Largest share of x at which no aperture with flow grows to more than `growth` times its size.
  [[nodiscard]] double share_for_apertures(const Vector& x, double growth) const;
  // No disc moves or turns farther than `longest` [m, at its rim].
  void limit(Vector& x, double longest) const;

  // The tangent as a list of entries, places always the same while the same discs are near; and what they make of a pattern.
  // How many there are; how many each row has; the `count` of those that are `wanted` by their numbers (empty: all are), returning the
  // largest size among them; those of the rows from `first` up to `end`, returning how many there are in all rows; and where they belong.
  [[nodiscard]] std::size_t entry_count() const;
  [[nodiscard]] std::vector<std::int32_t> entries_of_rows() const;
  template <class Real>
  double entries(std::vector<Real>& values, const std::vector<bool>& wanted, std::size_t count) const;
  std::size_t entries(std::vector<double>& values, std::int64_t first, std::int64_t end) const;
  void places(std::vector<std::int32_t>& row, std::vector<std::int32_t>& column, std::int64_t first,
              std::int64_t end) const;
  struct Structure {
    std::vector<std::int32_t> node_start;  // first unknown of each node
    std::vector<Vec2> position;
    Adjacency graph;
    std::vector<char> late;  // nodes to eliminate last
    FrontTree::EachPlace each_place;
  };
  [[nodiscard]] Structure structure() const;
  [[nodiscard]] Eigen::Index size() const { return residual_.size(); }

  // Forces of a contact that was never bonded [N]: pressed together, and along it.
  [[nodiscard]] double pair_normal_force(std::size_t pair) const { return -pairs_[pair].normal; }
  [[nodiscard]] double pair_shear_force(std::size_t pair) const { return pairs_[pair].shear; }

  // Of a domain at the displacements and pressures at hand [m2].
  [[nodiscard]] double volume_change(std::int64_t domain) const;
  // Conductances of facets and joints by the apertures held, not by the displacements at hand (Picard's iteration); hold() takes `share` of the way
  // to those at hand and returns how far off they were, relative to the largest.
  double hold_apertures(double share);
  void release_apertures() {
    held_.clear();
    held_joints_.clear();
  }

  // Content of every domain and flow of every pipe after the step.
  void keep_flow();
  // Pressure, content and rates of wellbores after the step.
  void keep_wellbores();

 private:
  // Share of k_n added to every disc's tangent, not to its forces: what nothing holds moves finitely.
  static constexpr double regularisation = 1e-7;
  struct Pin {
    std::int32_t disc;
    Vec2 along;
    double start;
  };
  [[nodiscard]] Eigen::Index pressure_at(std::int64_t domain) const { return 3 * discs_ + domain; }
  // First domain whose pressure pushes discs: the outside does on walls only, and in a dry model none.
  [[nodiscard]] std::int64_t first_pushing() const { return !wet_ ? domains_ : (boundary_.walled() ? 0 : 1); }
  [[nodiscard]] Eigen::Index wall_at(std::size_t wall) const {
    return 3 * discs_ + domains_ + static_cast<Eigen::Index>(wall);
  }
  // Of a domain whose pressure follows no content, on its own row.
  [[nodiscard]] double floor_entry(std::int64_t domain) const {
    return network_.stiffness[domain] > 0.0 ? pressure_scale_ / floor_stiffness(domain) / length_scale_ : 1.0;
  }
  // Pa/m2, by which pressure above the floor is compared with void: a joint's pore is stiffer than the rock around it.
  [[nodiscard]] double floor_stiffness(std::int64_t domain) const {
    const double own = network_.stiffness[domain];
    if (network_.joint_pore.empty() || network_.joint_pore[domain] == 0) return own;
    return std::min(own, options_.contact_normal_stiffness / (assembly_.mean_radius * assembly_.mean_radius));
  }
  // Of the rock beyond, behind all others.
  [[nodiscard]] Eigen::Index traction_at(std::int64_t unknown) const {
    return 3 * discs_ + domains_ + static_cast<Eigen::Index>(servo_walls_) + unknown;
  }
  template <class Visit>
  void each_rim_weight(const Visit& visit) const;
  void products_of_exterior(const Vector& x, Vector& y) const;
  void add_pair(const BondResponse& r, std::int32_t i, std::int32_t j);
  void list_neighbours();
  void find_own_bonds();
  // What the forces of a pair change by if unknowns change by x.
  void pair_product(const double* tangent, std::int32_t i, std::int32_t j, const Vector& x, double* f) const;
  void products_of_bonds(const Vector& x, Workers::Range bonds) const;
  void products_on_discs(const Vector& x, Vector& y, Workers::Range discs) const;
  void products_on_domains(const Vector& x, Vector& y, Workers::Range domains) const;
  void products_of_few(const Vector& x, Vector& y) const;
  void products_of_facets(const Vector& x, Vector& y) const;
  // emit(row, column, value) of every entry; needs(n): whether the values of the next n are looked at.
  template <class Emit, class Needs>
  void each_entry(const Emit& emit, const Needs& needs) const;
  template <class Visit>
  void each_place(const Visit& visit) const;
  // Pressure that drives flow from left to right [Pa], with what a host set beyond the outer boundary.
  [[nodiscard]] double drop(std::size_t pipe) const {
    const double own = network_.pressure[network_.left[pipe]] - network_.pressure[network_.right[pipe]];
    return outer_drop_.empty() ? own : own + outer_drop_[pipe];
  }
  [[nodiscard]] double opens(std::size_t bond, const Vector& x) const;
  void evaluate_walls();
  void open_facets();
  void add_faces_of_joints();
  void evaluate_facet_pipe(std::size_t e, std::size_t facet);
  // What a bond answers, as it stands.
  [[nodiscard]] BondResponse answer_of(std::size_t e) const;
  // Where a bond's tangent is kept, -1: it is not.
  [[nodiscard]] std::int64_t place_of_tangent(std::size_t e) const {
    if (!keeps_tangents_) return -1;
    return own_.all() ? static_cast<std::int64_t>(e) : own_.slot[e];
  }
  // Calls visit(tangent) of a bond at the last evaluation.
  template <class Visit>
  void with_tangent(std::size_t e, const Visit& visit) const {
    if (const auto kept = place_of_tangent(e); kept >= 0)
      visit(tangents_[static_cast<std::size_t>(kept)].data());
    else
      visit(answer_of(e).tangent);
  }
  static constexpr std::int64_t grain = 64;  // discs, bonds or domains
  [[nodiscard]] bool worth_sharing() const { return discs_ >= 2048; }
  void answer_all();
  void add_up_on_discs(Workers::Range discs);
  void evaluate_few();
  void find_fragments();
  void evaluate_pipe(std::size_t e, const BondResponse& bond);
  void evaluate_wellbores();
  // visit(domain, other domain, d(rate into the first) dt / d(pressure of the second), scaled as entries of the tangent are).
  template <class Visit>
  void each_cluster_pair(const Visit& visit) const;
  void evaluate_domains();
  double evaluate_domain(std::int64_t d);
  void measure();

  Assembly& assembly_;
  Network& network_;
  Boundary& boundary_;
  const NonBondedContacts& non_bonded_;
  const Options& options_;
  mutable RankTeam team_;
  Facets& facets_;
  std::vector<Wellbore>* wellbores_;  // none: there are none with friction
  std::vector<WellboreFlow> wellbore_flow_;
  std::vector<double> hole_;          // Pa, of a wellbore's clusters
  std::vector<double> facet_change_;  // per domain: volume change beside that of the corners [m2]
  std::vector<char> facet_open_;
  std::vector<double> held_;         // per facet: aperture its conductance goes by [m]
  std::vector<double> held_joints_;  // likewise, per contact of smooth joints
  std::int64_t discs_, domains_;
  std::int64_t tractions_;  // unknowns of the rock beyond
  std::size_t servo_walls_ = 0;
  bool wet_, closed_outside_;
  double force_scale_, length_scale_, pressure_scale_;
  double duration_ = 0.0;
  std::vector<double> source_, content_start_;
  std::vector<double> outer_drop_;  // per pipe: Pa; none: 0 everywhere
  std::vector<PairStart> pair_start_;
  std::vector<Pin> pins_;
  // at the last evaluation
  std::vector<BondResponse> pairs_;
  // Bonds that this rank's rows of a product need: all, or those of the list, with the place of each bond in it, -1 of others.
  struct OwnBonds {
    std::vector<std::int32_t> bond, slot;
    [[nodiscard]] bool all() const { return slot.empty(); }
  } own_;
  // Of those. 128 bytes each: where memory is short they answer anew for every product, as others do where a factor asks for them.
  bool keeps_tangents_;
  std::vector<std::array<double, 16>> tangents_;
  std::vector<double> by_push_;          // of a facet that slides: shear force by the fluid's push across it
  std::vector<double> aperture_change_;  // per pipe: d(flow) / d(gap) dt
  std::vector<double> squeeze_change_;   // likewise d(gap of the discs), where the opening is not the gap
  std::vector<double> slope_;  // per pipe: d(flow) / d(pressure drop), the conductance unless the fluid thins
  bool turns_open_;            // some rotation opens a pipe
  FluidLaw law_;
  std::vector<double>
      opening_;  // per pipe: m, what its aperture goes by: the gap, or that of the joint it belongs to
  struct OpeningWay {
    Vec2 along;                  // unit vector along which it is measured
    double by_first, by_second;  // m: its change by a disc's rotation
    Vec2 direction;              // from first to second disc
  };
  std::vector<OpeningWay> opening_way_;
  std::vector<std::int32_t> piece_;
  std::vector<char> adrift_;  // per disc: in a small piece that nothing holds
  std::vector<char> holds_,
      held_before_;  // per bond, then per pair: joins two discs, now and when pieces were last found
  std::vector<char> at_floor_;  // per domain: pressure follows no content
  // A disc's bonds and the domains' corners it stands at; a domain's pipes. Bonds and pipes: twice the number, + 1 on the second side.
  std::vector<std::int32_t> bond_start_, bond_of_, corner_start_, corner_of_, corner_domain_, pipe_start_,
      pipe_of_;
  struct Change {
    double force[4];  // of a bond, or what a displacement adds to it
    double moved;     // through its pipe
  };
  mutable std::vector<Change> changes_;
  std::vector<double> bond_forces_;  // N, sums over grains
  Vector residual_;
  double contact_force_ = 0.0, force_ratio_ = 0.0, pressure_error_ = 0.0;
};

template <class Visit>
void CoupledSystem::each_cluster_pair(const Visit& visit) const {
  for (std::size_t w = 0; duration_ > 0.0 && w < wellbore_flow_.size(); ++w) {
    const auto& clusters = (*wellbores_)[w].clusters;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = 0; j < clusters.size(); ++j)
        visit(clusters[i].domain, clusters[j].domain,
              duration_ * wellbore_flow_[w].by_pressure(i, j) * pressure_scale_ / length_scale_);
    }
  }
}

// visit(disc, point, weight of the traction at the point on the disc [m]).
template <class Visit>
void CoupledSystem::each_rim_weight(const Visit& visit) const {
  if (tractions_ == 0) return;
  for (const auto& at : boundary_.exterior()->rim()) {
    for (std::size_t p = 0; p < 2; ++p) visit(at.disc, at.point[p], at.weight[p]);
  }
}

}  // namespace hfrac
