// SPDX-License-Identifier: BSD-3-Clause
// A short list of bonds, ascending: whether a bond is in it, and where. A bit for each bond of the model, and a count for each 64.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/array.hpp"

namespace hfrac {

class BondIndex {
 public:
  BondIndex() = default;
  // bond_of(k): the list, one after the other.
  template <class BondOf>
  BondIndex(std::size_t listed, const BondOf& bond_of, std::int64_t bonds)
      : words_(static_cast<std::size_t>(bonds / 64 + 1)) {
    for (std::size_t k = 0; k < listed; ++k) word(bond_of(k)).bits |= bit(bond_of(k));
    for (std::size_t w = 1; w < words_.size(); ++w)
      words_[w].before = words_[w - 1].before + std::popcount(words_[w - 1].bits);
  }

  // Place in the list; -1: not in it.
  [[nodiscard]] std::int32_t place_of(std::int64_t bond) const {
    return words_.empty() || (word(bond).bits & bit(bond)) == 0 ? -1 : listed_before(bond);
  }
  [[nodiscard]] std::int32_t listed_before(std::int64_t bond) const {
    return words_.empty() ? 0 : word(bond).before + std::popcount(word(bond).bits & (bit(bond) - 1));
  }

 private:
  struct Word {
    std::uint64_t bits = 0;
    std::int32_t before = 0;
  };
  static std::uint64_t bit(std::int64_t bond) { return std::uint64_t{1} << (bond % 64); }
  [[nodiscard]] const Word& word(std::int64_t bond) const {
    return words_[static_cast<std::size_t>(bond / 64)];
  }
  Word& word(std::int64_t bond) { return words_[static_cast<std::size_t>(bond / 64)]; }

  std::vector<Word> words_;
};

// The bonds that joints cross, and which joint does (solid/joints.hpp).
struct JointBonds {
  BondIndex index;
  std::vector<std::int32_t> joint;  // by place in the index: number in the definition
  std::vector<Vec2> normal;         // by joint, unit

  [[nodiscard]] bool empty() const { return joint.empty(); }
  [[nodiscard]] std::int32_t joint_of(std::int64_t bond) const {  // -1: none
    const auto at = index.place_of(bond);
    return at < 0 ? -1 : joint[static_cast<std::size_t>(at)];
  }
};

}  // namespace hfrac
