// SPDX-License-Identifier: BSD-3-Clause
// The faces of a fracture: one facet for each broken bond, from the centroid of the pore on one side to that on the other.
//
// A bonded packing lumps the compliance of two half discs in their contact, and its forces scatter from bond to bond although the
// stress in the rock does not. If a broken bond simply becomes a contact, both come back as a toughness that grows with depth:
// faces that the fluid opens swell by the contact's compression, and what the bond bore beyond the mean is released at the tip.
// A facet releases what rock releases, by superposition on the state without fractures (holes at sigma_hmin, initial_equilibration.cpp):
//
//   - When a bond breaks, the force F_0 of the mean stress on its facet (holed_plate.hpp) is released, and no more: the difference to
//     what this very bond bore (force and couple) stays, as a locked-in force.
//   - The fluid pushes across the facets, p_A L_A + p_B L_B with the parts L of the facet in either pore; on intact bonds
//     around a fracture's pore the pressure from before the treatment stays (alpha of it). A pore of a joint that conducts goes on to
//     push on the joint's faces, and never pushed on bonds.
//   - The opening is  w = n . (du - du_0) + (p L - n . F_0) / k_n:  displacement since the initial equilibrium, and the
//     compression of the half discs at the face, which bear p L where they bore F_0. Closed (w < 0) the facet transmits
//     n . F_0 - k_n n . (du - du_0), with Coulomb friction on what exceeds p; open it transmits p.
//   - Its volume is w L, shared by the two pores as L_A to L_B. So what a pore stores is what its facets are open.
//
// Facets of broken bonds as faces through which fluid flows: Asahina, Houseworth, Birkholzer, Rutqvist and Bolander 2014.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/array.hpp"
#include "frac/holed_plate.hpp"
#include "model/assembly.hpp"
#include "model/network.hpp"
#include "model/well.hpp"
#include "options/options.hpp"
#include "solid/bond_law.hpp"
#include "solid/facet_law.hpp"
#include "solid/facet_motion.hpp"

namespace hfrac {

class Facets {
 public:
  // Records the initial state: to be called once, at the initial equilibrium.
  void begin(const Assembly& assembly, Network& network, const std::vector<WellPlace>& wells,
             const Options& options);
  [[nodiscard]] bool active() const { return active_; }
  // This bond's facet, once it is broken, will be a slot.
  void cut(std::int64_t bond) { cut_[bond] = 1; }
  // From all bonds as they stand: at the beginning, or after a restore.
  void update(const Assembly& assembly, Network& network, bool restored = false);
  // After these bonds broke: looks at what lies near them only, and leaves what update() would, bit for bit.
  void add(const Assembly& assembly, Network& network, std::span<const std::int64_t> broken);

  // The explicit solver's list of them follows from now on.
  void follow(FacetMotion& motion) { motion_ = &motion; }
  // Weights of the pores' corners in rock without fractures.
  [[nodiscard]] const Array<double>& rock_weight() const { return weight_; }

  [[nodiscard]] std::int32_t of(std::int64_t bond) const { return active_ ? of_[bond] : -1; }
  [[nodiscard]] const std::vector<Facet>& all() const { return facets_; }
  [[nodiscard]] bool fractured(std::int64_t domain) const { return active_ && fractured_[domain] != 0; }
  [[nodiscard]] const std::vector<std::int32_t>& bonds_of(std::int64_t domain) const {
    return bonds_[domain];
  }
  [[nodiscard]] const std::vector<std::int32_t>& bonds_of_disc(std::int32_t disc) const {
    return disc_bonds_[disc];
  }
  // m; n . (du - du_0 - g) along `way`.
  [[nodiscard]] double jump(const Assembly& a, const Facet& f, Vec2 way) const {
    return facet_jump(a, start_, f, way);
  }
  // What others read of openings: network.facet_opening.
  void tell_openings(const Assembly& assembly, Network& network) const;
  [[nodiscard]] double opening(const Assembly& a, const Network& n, const Facet& f) const;
  // J/m, that facets and locked-in pushes store.
  [[nodiscard]] double energy(const Assembly& a, const Network& n, const Options& o) const;
  // Force of the locked-in pressure on an intact bond of a fracture's pore, on its first disc [N].
  [[nodiscard]] Vec2 locked_of(std::int64_t bond) const {
    return {pore_push_[2 * bond], pore_push_[2 * bond + 1]};
  }
  [[nodiscard]] Vec2 part(std::int64_t bond, bool left) const;                    // h of a bond
  [[nodiscard]] Vec2 contact(std::int64_t bond) const { return contact_[bond]; }  // m
  [[nodiscard]] Vec2 initial_force(std::int64_t bond) const {
    return {force_[4 * bond], force_[4 * bond + 1]};
  }
  // Mean total stress of the discs around a pore now, compression positive: xx, yy, xy [Pa].
  void stress_around(const Assembly& a, const Network& n, const Options& o, std::int32_t domain,
                     double* stress) const;
  [[nodiscard]] const FacetStart& start() const { return start_; }

 private:
  [[nodiscard]] bool in_joint(std::int32_t domain) const {
    return !network_->joint_pore.empty() && network_->joint_pore[domain] != 0;
  }
  [[nodiscard]] Vec2 pushed(std::int64_t bond, bool left) const;
  [[nodiscard]] bool is_face(const Assembly& a, const Network& n, std::int64_t bond) const;
  [[nodiscard]] Facet face_of(const Assembly& a, const Network& n, std::int64_t bond) const;
  [[nodiscard]] double change_before(const Assembly& a, const Network& n, std::int32_t domain) const;
  void put_weights(Network& n, std::int32_t domain, bool open) const;
  void put_push(const Assembly& a, Network& n, std::int64_t bond, bool restored);
  void put_pipe(Network& n, const Facet& f) const;
  void tell_motion(const Assembly& a, Network& n, bool restored) const;
  [[nodiscard]] std::vector<std::int64_t> near_to(const Assembly& a, const Network& n,
                                                  const std::vector<std::int64_t>& fresh) const;
  void lay_along_fracture(const Assembly& a, const Network& n, Facet& f) const;
  [[nodiscard]] Vec2 mean_force(const Network& n, const Facet& f, bool left) const;
  FacetStart start_;
  HoledPlate plate_;
  bool active_ = false;
  const Network* network_ = nullptr;
  std::vector<std::int32_t> of_;
  std::vector<Facet> facets_;
  std::vector<char> fractured_, cut_;
  std::vector<std::vector<std::int32_t>> bonds_;  // of a domain
  Array<double> force_;   // per bond at the initial state: force on the first disc, two couples
  Array<double> energy_;  // likewise: of bond and contact [J/m]
  Array<double>
      pressure_;  // per domain: what the rock around it, or its joint's faces, bore of its pressure initially [Pa]
  double biot_ = 1.0;
  Array<double> pore_push_, weight_, turn_;
  FacetMotion* motion_ = nullptr;
  std::vector<Vec2> contact_;
  std::vector<std::vector<std::int32_t>> disc_bonds_;
  Array<double> area_;
  const Assembly* assembly_ = nullptr;
};

}  // namespace hfrac
