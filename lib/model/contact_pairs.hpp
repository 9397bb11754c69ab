// SPDX-License-Identifier: BSD-3-Clause
// Contacts between discs that were never bonded to each other, as data; their law: solid/non_bonded_contacts.hpp.
#pragma once

#include <cstdint>
#include <vector>

namespace hfrac {

struct ContactPair {
  std::int32_t first, second;
  double reference_gap;       // m, 0 or the overlap (negative) at bonding or when first looked at
  double shear_force = 0.0;   // N
  double normal_force = 0.0;  // N, compression positive
};

struct ContactPairs {
  std::vector<ContactPair> pairs;              // sorted by (first, second)
  std::vector<std::int32_t> discs;             // discs of the pairs, each once
  std::vector<std::int32_t> cracked;           // discs with a broken bond
  std::vector<double> searched_x, searched_y;  // m, displacement of `cracked` at the last search
  std::size_t cracks_seen = 0;

  // Whether lists that were read can be those of so many discs: in range, in order, of matching lengths.
  [[nodiscard]] bool fits(std::int64_t disc_count) const;

  template <class Archive, class Self>
  static void visit(Archive& archive, Self& s) {
    archive.list(s.pairs, [](auto& ar, auto& pair) {
      ar.value(pair.first);
      ar.value(pair.second);
      for (auto* value : {&pair.reference_gap, &pair.shear_force, &pair.normal_force}) ar.value(*value);
    });
    const auto plain = [](auto& ar, auto& item) { ar.value(item); };
    archive.list(s.discs, plain);
    archive.list(s.cracked, plain);
    archive.list(s.searched_x, plain);
    archive.list(s.searched_y, plain);
    archive.value(s.cracks_seen);
  }
};

}  // namespace hfrac
