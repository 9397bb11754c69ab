// SPDX-License-Identifier: BSD-3-Clause
// The contacts of smooth joints as data: where they lie, how they look, what they slid. Their law: solid/smooth_joints.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/array.hpp"
#include "geom/cell_grid.hpp"
#include "model/joint_law.hpp"

namespace hfrac {

struct SmoothContact {
  std::int64_t bond;
  std::int64_t joint;                        // number in the definition
  Vec2 normal;                               // unit, towards the bond's second disc
  Vec2 first_arm, second_arm;                // m, from the centre of the disc to the contact
  double opens_by_first, opens_by_second;    // m: change of U_n by a disc's rotation
  double slides_by_first, slides_by_second;  // m: change of U_s
  double area;                               // m2 per metre of thickness
  double slip;                               // m
  bool holds;
  double open_before, slid_before;     // m: counted from where settle_smooth left them
  double locked_normal, locked_shear;  // N: tension positive
  double slip_before;                  // m: of `slip`, what it slid in the set-up
  double slip_logged;                  // m: of `slip`, what its entries in the log add up to (step/slips.hpp)
};

struct SmoothJoints {
  struct Line {
    Vec2 from, to;
  };
  std::vector<SmoothContact> contacts;  // ascending by bond
  std::vector<std::int32_t> place;      // per bond: in contacts, -1 of none; empty without smooth joints
  std::vector<Line> lines;              // the joints themselves
  std::vector<JointLaw>
      laws;  // by number in the definition; those of joints that are not smooth are not used
  double normal_stiffness = 0.0, shear_stiffness = 0.0;  // Pa/m, of joints that give none

  [[nodiscard]] bool empty() const { return contacts.empty(); }
  [[nodiscard]] const SmoothContact* of(std::int64_t bond) const {
    const std::int32_t at = empty() ? -1 : place[static_cast<std::size_t>(bond)];
    return at < 0 ? nullptr : &contacts[static_cast<std::size_t>(at)];
  }
  [[nodiscard]] SmoothContact* of(std::int64_t bond) {
    const std::int32_t at = empty() ? -1 : place[static_cast<std::size_t>(bond)];
    return at < 0 ? nullptr : &contacts[static_cast<std::size_t>(at)];
  }
  [[nodiscard]] const JointLaw& law_of(const SmoothContact& contact) const {
    return laws[static_cast<std::size_t>(contact.joint)];
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
  std::vector<Bridge> bridges;       // ascending
  std::vector<std::int64_t> shared;  // ascending: bonds that two joints cross
  bool held = false;                 // contacts of joints that conduct do not slip (initial equilibration)
  // Whether a joint lies between two places.
  [[nodiscard]] bool separate(Vec2 p, Vec2 q) const;
  // Which contacts hold, and what they slid, is kept here while the step loop runs, where other workers hold the bonds' own
  // numbers; those are the state.
  void read_state(const Array<std::uint8_t>& intact, const Array<double>& slip);
  void write_state(Array<std::uint8_t>& intact, Array<double>& slip) const;

 private:
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
