// SPDX-License-Identifier: BSD-3-Clause
// Contacts between discs that were never bonded to each other.
//
// Intact rock keeps its neighbours, so the step loop knows bonded pairs only. Where bonds broke, discs may slide along and meet
// others: around such discs, and only there, near pairs are searched for again whenever something broke or moved. Their
// law is that of any contact, with the shear force kept as history: F_n = k_n max(0, -g), dF_s = k_s du_s,
// |F_s| <= mu F_n. Overlap that pairs had at bonding carries no force. There are few of them, so one worker does all.
#pragma once

#include <cstdint>
#include <vector>

#include "frac/crack_log.hpp"
#include "options/options.hpp"
#include "solid/assembly.hpp"
#include "solid/boundary.hpp"

namespace hfrac {

class NonBondedContacts {
 public:
  struct Pair {
    std::int32_t first, second;
    double reference_gap;       // m, 0 or the overlap at bonding
    double shear_force = 0.0;   // N
    double normal_force = 0.0;  // N, compression positive
  };

  explicit NonBondedContacts(const Options& options) : options_(options) {}

  // Looks for pairs if cracks were added or discs moved since the last time. True if the list changed.
  bool search(Assembly& assembly, const Boundary& boundary, const CrackLog& cracks);

  // Forces of one cycle into external_*; after Boundary::cycle. Adds friction work to `friction`.
  void cycle(Assembly& assembly, const Boundary& boundary, double step, double& friction);

  // Adds to the row sums that set the stable step.
  void add_stiffness(const Assembly& assembly, std::vector<double>& row_x, std::vector<double>& row_y,
                     std::vector<double>& row_rotation) const;

  // Forces found by another solver, in the order of pairs().
  void keep(std::size_t pair, double normal_force, double shear_force) {
    pairs_[pair].normal_force = normal_force;
    pairs_[pair].shear_force = shear_force;
  }

  [[nodiscard]] bool empty() const { return pairs_.empty(); }
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] double energy(const Assembly& assembly) const;  // J/m, stored now
  // Whether lists that were read can be those of so many discs: in range, in order, of matching lengths.
  [[nodiscard]] bool fits(std::int64_t discs) const;

  template <class Archive>
  void visit_state(Archive& archive) {
    visit(archive, *this);
  }
  template <class Archive>
  void visit_state(Archive& archive) const {
    visit(archive, *this);
  }

 private:
  template <class Archive, class Self>
  static void visit(Archive& archive, Self& s) {
    archive.list(s.pairs_, [](auto& ar, auto& pair) {
      ar.value(pair.first);
      ar.value(pair.second);
      for (auto* value : {&pair.reference_gap, &pair.shear_force, &pair.normal_force}) ar.value(*value);
    });
    const auto plain = [](auto& ar, auto& item) { ar.value(item); };
    archive.list(s.discs_, plain);
    archive.list(s.cracked_, plain);
    archive.list(s.searched_x_, plain);
    archive.list(s.searched_y_, plain);
    archive.value(s.cracks_seen_);
  }

  void release(Assembly& assembly, const Boundary& boundary);

  const Options& options_;
  std::vector<Pair> pairs_;                      // sorted by (first, second)
  std::vector<std::int32_t> discs_;              // discs of the pairs, each once
  std::vector<std::int32_t> cracked_;            // discs with a broken bond
  std::vector<double> searched_x_, searched_y_;  // m, displacement of cracked_ at the last search
  std::size_t cracks_seen_ = 0;
};

}  // namespace hfrac
