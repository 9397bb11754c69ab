// SPDX-License-Identifier: BSD-3-Clause
// The contacts of smooth joints as data: where they lie and how they look. Their law: solid/smooth_joints.hpp. Which hold and what they
// slid is Assembly::intact and slip of their bonds.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/array.hpp"
#include "geom/cell_grid.hpp"
#include "model/bond_index.hpp"
#include "model/joint_law.hpp"

namespace hfrac {

// As the step loop reads it (kernels.hpp, SmoothArrays): one cache line.
struct SmoothContact {
  std::int32_t bond;
  std::int32_t joint;                        // number in the definition
  Vec2 normal;                               // unit, towards the bond's second disc
  double area;                               // m2 per metre of thickness
  double opens_by_first, opens_by_second;    // m: change of U_n by a disc's rotation
  double slides_by_first, slides_by_second;  // m: change of U_s

  // m, from the centre of the disc to the contact
  [[nodiscard]] Vec2 first_arm() const { return opens_by_first * along() - slides_by_first * normal; }
  [[nodiscard]] Vec2 second_arm() const { return slides_by_second * normal - opens_by_second * along(); }

 private:
  [[nodiscard]] Vec2 along() const { return {-normal.y, normal.x}; }
};

static_assert(sizeof(SmoothContact) == 64);

// What settle_smooth left a contact with.
struct SettledContact {
  double open_before = 0.0, slid_before = 0.0;     // m: its motion counts from there
  double locked_normal = 0.0, locked_shear = 0.0;  // N: tension positive
};

// Of a contact's slip, what it slid in the set-up, and what its entries in the log add up to (step/slips.hpp) [m].
struct CountedSlip {
  double before = 0.0, logged = 0.0;
};

struct SmoothJoints {
  struct Line {
    Vec2 from, to;
  };
  Array<SmoothContact> contacts;         // ascending by bond
  BondIndex index;                       // of their bonds
  Array<SettledContact> settled;         // by contact; empty: none is
  std::vector<CountedSlip> counted;      // by contact
  std::vector<Line> lines;               // the joints themselves
  std::vector<JointLaw> laws;            // no two in a row alike
  std::vector<std::int32_t> law_number;  // by number in the definition, also of joints that are not smooth
  double normal_stiffness = 0.0, shear_stiffness = 0.0;  // Pa/m, of joints that give none

  [[nodiscard]] bool empty() const { return contacts.empty(); }
  [[nodiscard]] const SmoothContact* of(std::int64_t bond) const {
    const std::int32_t at = index.place_of(bond);
    return at < 0 ? nullptr : &contacts[static_cast<std::size_t>(at)];
  }
  [[nodiscard]] const JointLaw& law_of_joint(std::int32_t joint) const {
    return laws[static_cast<std::size_t>(law_number[static_cast<std::size_t>(joint)])];
  }
  [[nodiscard]] const JointLaw& law_of(const SmoothContact& contact) const {
    return law_of_joint(contact.joint);
  }
  [[nodiscard]] std::size_t place_of(const SmoothContact& contact) const {
    return static_cast<std::size_t>(index.place_of(contact.bond));
  }
  [[nodiscard]] SettledContact settled_of(const SmoothContact& contact) const {
    return settled.empty() ? SettledContact{} : settled[place_of(contact)];
  }
  // To be called when `lines` are all there.
  void sort_lines(double cell);
  // The contact by whose opening fluid flows past a bond along a joint: its own, or where joints meet and it is left to the rock that of
  // the nearest contact; -1: no joint.
  [[nodiscard]] std::int32_t opening_at(std::int64_t bond) const;
  struct Bridge {
    std::int64_t bond;
    std::int32_t contact;
  };
  // A disc that a line cut off from the rock on its own side, all but one bond at most, and that was left to the other side
  // (solid/discs_held.hpp).
  struct Moved {
    std::int32_t disc, line;
  };
  std::vector<Bridge> bridges;       // ascending
  std::vector<Moved> moved;          // ascending by disc
  std::vector<std::int64_t> shared;  // ascending: bonds that two joints cross
  bool held = false;                 // contacts of joints that conduct do not slip (initial equilibration)
  [[nodiscard]] std::int32_t moved_over(std::int32_t disc) const;  // line, or -1
  // Whether a joint lies between two places.
  [[nodiscard]] bool separate(Vec2 p, Vec2 q) const;
  // Whether one lies between disc i at p and disc j at q: what was left to the other side of a joint is on that side.
  [[nodiscard]] bool separate(std::int32_t i, Vec2 p, std::int32_t j, Vec2 q) const;

 private:
  [[nodiscard]] bool any_between(Vec2 p, Vec2 q, std::int32_t but) const;
  // Places along the lines, no farther apart than `pace`, and the line of each.
  std::optional<CellGrid> places_;
  std::vector<std::int32_t> line_at_;
  double pace_ = 0.0;
};

// Places along a line, no farther apart than `pace`, its ends among them.
std::vector<Vec2> places_along(Vec2 from, Vec2 to, double pace);

// Whether the lines from `from` to `to` and from p to q cross.
bool crosses(Vec2 from, Vec2 to, Vec2 p, Vec2 q);

}  // namespace hfrac
