// SPDX-License-Identifier: BSD-3-Clause
// Facets of fractures where the rock's motion is followed explicitly: a short list beside the kernels, as contacts of smooth joints are.
//
// In the kernels the bond of a facet has no stiffness, and a fractured pore neither pushes nor changes its volume. What they do instead one worker
// finds in every cycle, facet by facet:
//   pressures  the pore holds its content, so  (p - p_ref) V / K_f + V_0 + sum over open facets of L w = zeta,  w by facet_law.hpp. An opening
//              goes with the pressures of both its pores, since the half discs at its faces give way; the equations are the gradient of a
//              convex function of the pressures and are solved pore by pore, to and fro along the list (nonlinear Gauss-Seidel), until no
//              pressure changes by more than `settled`. Whatever is left, no fluid is lost: contents do not change here.
//   forces     what facet_law.hpp says of each facet, and on intact bonds around such pores the locked-in push of the pressure before.
//              They turn a body that nothing holds, since facets do not look along their bonds: what they turn two discs far apart bear, those
//              that the quasi-static solver's pins are on.
//
// Work is counted by the trapezoidal rule from cycle to cycle, as the kernels count it: p dV of each pore, friction of facets that slide. What
// facets store is known from the state (facet_energy), so that the ledger's balance checks all of it (step/ledger.hpp).
//
// Open facets are no stiffer than closed ones: the fluid of a pore gives way with the faces, so m facets of a pore add up to at most
// (1 + sqrt(m)) / 2 times k_n per facet. So the stable step of intact rock, with each bond as stiff as a facet that looks any way and each pore
// as it was, is that of broken rock too (stable_step.hpp), and breakage asks for no shorter one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/assembly.hpp"
#include "model/clock.hpp"
#include "model/network.hpp"
#include "options/options.hpp"
#include "solid/facet_law.hpp"

namespace hfrac {

// This bond does not break by what it bears, until the facets change.
void hold_bond(Assembly& assembly, std::int64_t bond);

class FacetMotion {
 public:
  FacetMotion(Assembly& assembly, Network& network, const Options& options, Energies& energies)
      : assembly_(assembly), network_(network), options_(options), energies_(energies) {}

  // From now on there may be facets. `weight`: of the pores' corners (Network::corner_weight) in rock without fractures.
  void begin(const FacetStart& start, const Array<double>& weight);
  [[nodiscard]] bool active() const { return start_ != nullptr; }
  [[nodiscard]] const Array<double>& rock_weight() const { return *weight_; }

  struct Push {
    std::int64_t bond;  // intact
    Vec2 force;         // N, on its first disc
  };
  // The fluid in a joint that conducts goes on to push on its faces where a fracture meets it.
  struct Face {
    std::int32_t domain, disc;
    Vec2 weight;  // m
    double turn;  // m2
  };
  // The facets as they are now, ascending by bond. To be called after each change, outside of begin_cycles and end_cycles. What the change
  // releases counts as fracture, unless a state is restored.
  void take(std::span<const Facet> facets, std::vector<Push> pushes, std::vector<Face> faces, bool restored);

  // Of a pore with a single facet, where a fracture ends, but at a joint (frac/tip.hpp): bonds around it break by bond.fracture_toughness.
  [[nodiscard]] bool at_tip(std::int32_t domain) const;
  // Discs that anything here pushes, ascending.
  [[nodiscard]] const std::vector<std::int32_t>& discs() const { return discs_; }
  // Holes whose corners the facets' pressures follow.
  [[nodiscard]] std::vector<std::int32_t> holes() const {
    std::vector<std::int32_t> domains;
    for (const auto& hole : holes_) domains.push_back(hole.domain);
    return domains;
  }
  // How often the list changed.
  [[nodiscard]] std::int64_t changes() const { return changes_; }

  // Around cycles: what kernels see of fractured pores is a constant pressure that pushes nothing.
  void begin_cycles();
  void end_cycles();
  // Stiffness of each domain as the kernels are to see it [Pa/m2].
  [[nodiscard]] const double* stiffness() const { return stiffness_.data(); }

  // Pressures at the displacements as they stand, unless drained.
  void answer(bool undrained);
  // On top of external_x, external_y, external_moment.
  void add_forces();

 private:
  struct Side {
    std::int32_t facet;
    double length;  // m
  };
  struct Pore {
    std::int32_t domain;
    std::int32_t first, last;  // of its sides
    double pressure, fixed;    // Pa; m2, of its volume change
    double volume;             // m2, volume change up to which its work is counted
  };
  struct Item {
    std::int32_t left, right;         // pores of the list; below 0: ~ a hole of the list
    double apart;                     // m, opening but for the push of the fluid
    double push;                      // N, by the pressures at hand
    double shear = 0.0, slide = 0.0;  // N, m, up to which friction is counted
  };
  struct Hole {
    std::int32_t domain;
    double pressure;
  };
  [[nodiscard]] double pressure_at(std::int32_t place) const {
    return place >= 0 ? pores_[static_cast<std::size_t>(place)].pressure
                      : holes_[-1 - static_cast<std::ptrdiff_t>(place)].pressure;
  }
  [[nodiscard]] double volume_change(const Pore& pore) const;
  // Openings but for the fluid's push, and the pushes, at displacements and pressures as they stand.
  void measure();
  void push_all();
  void settle_pressures();
  void book_change(bool restored);
  // Works and friction since they were counted last.
  void count_work();
  [[nodiscard]] double shear_of(std::size_t k) const;  // N, that facet k's grains bear
  [[nodiscard]] double energy() const;                 // J/m, of facets and locked-in pushes
  // Puts a force on the first of two discs and the opposite on the second; moments as they are. Returns what that turns the whole by [N m].
  double push_pair(std::int64_t bond, Vec2 force, double on_first, double on_second);
  void hold_against(double turns);
  double correct(Pore& pore);

  Assembly& assembly_;
  Network& network_;
  const Options& options_;
  Energies& energies_;
  const FacetStart* start_ = nullptr;
  const Array<double>* weight_ = nullptr;
  std::span<const Facet> facets_;
  std::vector<Push> pushes_;
  std::vector<Face> faces_;
  std::vector<Pore> pores_;
  std::vector<Side> sides_;
  std::vector<Item> items_;
  std::vector<Hole> holes_;
  std::vector<std::int32_t> discs_;
  std::vector<std::uint8_t> count_;      // facets per pore
  std::vector<std::int64_t> bonds_;      // of the facets
  double stored_ = 0.0;                  // J/m, before the facets change
  std::vector<std::int32_t> far_apart_;  // two discs; none between walls
  Vec2 couple_{},
      apart_{};  // N on the first of them; m, from it to the other, up to which its work is counted
  Array<double> stiffness_;
  std::int64_t changes_ = 0;
};

}  // namespace hfrac
