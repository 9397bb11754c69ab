// SPDX-License-Identifier: BSD-3-Clause
// What a bond is by its place in the packing, and never changes.
//
// Kept in blocks of eight bonds, all values of a block side by side: the step loop reads one stream instead of five and asks for
// it ahead of time with less trouble (docs/performance.md). Every part of the bonds (geom/contact_graph.hpp) begins with a block of
// its own.
#pragma once

#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "core/layout.hpp"

namespace hfrac {

struct BondValues {
  double dx, dy;  // m: centre to centre at bonding
  double length;  // m: likewise
  double arm;     // m: from the first disc's centre to the contact point at bonding
  double radius;  // m: of the bond
};

class BondGeometry {
 public:
  // Room for bonds that are numbered part after part: where each begins, and last their number.
  void lay_out(const std::vector<std::int64_t>& part_first_bond) {
    std::int64_t blocks = 0;
    first_block_.clear();
    shift_.clear();
    for (std::size_t part = 0; part + 1 < part_first_bond.size(); ++part) {
      const std::int64_t first = part_first_bond[part], last = part_first_bond[part + 1];
      first_block_.push_back(blocks);
      shift_.push_back(blocks * block_bonds - first);
      blocks += (last - first + block_bonds - 1) / block_bonds;
    }
    // The law is asked for whole blocks: places that no bond takes answer like any other.
    values_.assign(static_cast<std::size_t>(blocks * block_values), 1.0);
  }

  void put(std::size_t part, std::int64_t bond, const BondValues& v) {
    const std::int64_t to = place(part, bond);
    set(to + block_dx, v.dx);
    set(to + block_dy, v.dy);
    set(to + block_length, v.length);
    set(to + block_arm, v.arm);
    set(to + block_radius, v.radius);
  }
  void put_radius(std::size_t part, std::int64_t bond, double radius) {
    set(place(part, bond) + block_radius, radius);
  }
  [[nodiscard]] double at(std::size_t part, std::int64_t bond, std::int64_t row) const {
    return values_[static_cast<std::size_t>(place(part, bond) + row)];
  }

  [[nodiscard]] const double* data() const { return values_.data(); }
  [[nodiscard]] std::int64_t value_count() const { return static_cast<std::int64_t>(values_.size()); }
  [[nodiscard]] std::int64_t first_block(std::size_t part) const { return first_block_[part]; }

 private:
  [[nodiscard]] std::int64_t place(std::size_t part, std::int64_t bond) const {
    const std::int64_t slot = bond + shift_[part];
    return slot / block_bonds * block_values + slot % block_bonds;
  }

  void set(std::int64_t at, double value) { values_[static_cast<std::size_t>(at)] = value; }

  Array<double> values_;
  std::vector<std::int64_t> first_block_, shift_;  // by part: its first block; slot of a bond less its number
};

}  // namespace hfrac
