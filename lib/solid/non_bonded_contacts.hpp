// SPDX-License-Identifier: BSD-3-Clause
// Contacts between discs that were never bonded to each other.
//
// Intact rock keeps its neighbours, so the step loop knows bonded pairs only. Where bonds broke, discs may slide along and meet
// others: around such discs, and only there, near pairs are searched for again whenever something broke or moved. Not where a contact of a
// smooth joint stands for the bond: what lies across the joint that one bears, and on either side the rock keeps its neighbours. Their
// law is that of any contact, with the shear force kept as history: F_n = k_n max(0, -g), dF_s = k_s du_s,
// |F_s| <= mu F_n. Overlap that pairs had at bonding, or when they are first looked at, carries no force: rock that was pressed
// together before anything broke near by would otherwise gain energy by being looked at. There are few of them, so one worker does all.
#pragma once

#include <span>
#include <vector>

#include "model/assembly.hpp"
#include "model/contact_pairs.hpp"
#include "model/crack_log.hpp"
#include "options/options.hpp"
#include "solid/boundary.hpp"

namespace hfrac {

class NonBondedContacts {
 public:
  using Pair = ContactPair;

  NonBondedContacts(const Options& options, ContactPairs& list) : options_(options), list_(list) {}

  // Whether cracks were added or discs moved since pairs were looked for; looks for them if so. True if the list changed.
  [[nodiscard]] bool is_due(const Assembly& assembly, const CrackLog& cracks) const;
  bool search(Assembly& assembly, const Boundary& boundary, const CrackLog& cracks);

  // Forces of one cycle onto external_*; after Boundary::cycle. Adds friction work to `friction`.
  void cycle(Assembly& assembly, double step, double& friction);

  // Adds to the row sums that set the stable step.
  void add_stiffness(const Assembly& assembly, std::span<double> row_x, std::span<double> row_y,
                     std::span<double> row_rotation) const;

  // Forces found by another solver, in the order of pairs().
  void keep(std::size_t pair, double normal_force, double shear_force) {
    list_.pairs[pair].normal_force = normal_force;
    list_.pairs[pair].shear_force = shear_force;
  }

  // For a device, which finds their forces in its own cycles.
  [[nodiscard]] ContactPairs& list() { return list_; }

  [[nodiscard]] bool empty() const { return list_.pairs.empty(); }
  [[nodiscard]] const std::vector<std::int32_t>& discs() const { return list_.discs; }  // of pairs
  [[nodiscard]] const std::vector<Pair>& pairs() const { return list_.pairs; }
  [[nodiscard]] double energy(const Assembly& assembly) const;  // J/m, stored now

 private:
  void release(Assembly& assembly, const Boundary& boundary);

  const Options& options_;
  ContactPairs& list_;
};

}  // namespace hfrac
