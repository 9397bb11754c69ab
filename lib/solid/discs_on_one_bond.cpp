// SPDX-License-Identifier: BSD-3-Clause
#include "solid/discs_on_one_bond.hpp"

#include <algorithm>
#include <utility>

#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr int fewest_crossed = 2;  // bonds to the other side, which are to hold what moves there
constexpr int rings = 2;           // bonds to where no other joint may be

struct Beside {
  int held = 0, crossed = 0;  // bonds
  std::int32_t joint = -1;    // that crosses them
  bool several = false, moved = false;
  bool met = false;  // the joint's line crosses bonds of its own

  void cut(std::int32_t by) {
    several = several || (joint >= 0 && joint != by);
    joint = by;
    met = true;
  }
  [[nodiscard]] bool on_one_bond() const {
    return met && held == 1 && crossed >= fewest_crossed && !several && !moved;
  }
  // Whether it is held without one of its bonds, or can follow.
  [[nodiscard]] bool can_lose_one(std::int32_t to) const {
    if (several || moved || (joint >= 0 && joint != to)) return false;
    return held > 2 || (met && held == 2 && crossed >= fewest_crossed - 1);
  }
};

class Mover {
 public:
  Mover(const Assembly& a, const std::vector<JointOptions>& joints, std::vector<std::int32_t>& joint_of)
      : a_(a), joints_(joints), joint_of_(joint_of), discs_(static_cast<std::size_t>(a.disc_count())) {
    for (std::int64_t e = 0; e < a.bond_count(); ++e)
      for (const auto i : {a.first[e], a.second[e]}) {
        Beside& disc = discs_[static_cast<std::size_t>(i)];
        ++(cut(e) ? disc.crossed : disc.held);
        if (cut(e)) disc.cut(joint_of_[static_cast<std::size_t>(e)]);
      }
    for (std::int64_t e = 0; e < a.bond_count(); ++e)
      for (const auto i : {a.first[e], a.second[e]})
        if (discs_[static_cast<std::size_t>(i)].met) bonds_.emplace_back(i, e);
    std::sort(bonds_.begin(), bonds_.end());
    find_ends();
  }

  DiscsOnOneBond move_all() {
    DiscsOnOneBond found;
    for (std::int32_t i = 0; i < a_.disc_count(); ++i)
      for (auto disc = i; disc >= 0;) disc = move(disc);
    std::sort(moved_.begin(), moved_.end(),
              [](const MovedDisc& p, const MovedDisc& q) { return p.disc < q.disc; });
    found.moved = std::move(moved_);
    for (std::int32_t i = 0; i < a_.disc_count(); ++i) {
      const Beside& disc = discs_[static_cast<std::size_t>(i)];
      if (!disc.met || disc.held != 1 || disc.crossed != 1 || disc.several) continue;
      for (const auto e : bonds_of(i))
        if (cut(e)) found.idle.push_back(e);
    }
    std::sort(found.idle.begin(), found.idle.end());
    return found;
  }

 private:
  [[nodiscard]] bool cut(std::int64_t e) const {
    const auto k = joint_of_[static_cast<std::size_t>(e)];
    return k >= 0 && is_smooth(JointState{joints_[static_cast<std::size_t>(k)].state});
  }

  // Along a joint [m].
  [[nodiscard]] double place(std::int32_t joint, std::int64_t e) const {
    const JointOptions& line = joints_[static_cast<std::size_t>(joint)];
    const Vec2 from{line.x1, line.y1}, along = Vec2{line.x2, line.y2} - from;
    return dot(a_.contact_point(e) - from, along) / norm(along);
  }

  void find_ends() {
    ends_.resize(joints_.size());
    for (std::int64_t e = 0; e < a_.bond_count(); ++e) {
      if (!cut(e)) continue;
      const auto k = joint_of_[static_cast<std::size_t>(e)];
      Ends& ends = ends_[static_cast<std::size_t>(k)];
      if (ends.first < 0 || place(k, e) < place(k, ends.first)) ends.first = e;
      if (ends.last < 0 || place(k, e) > place(k, ends.last)) ends.last = e;
    }
  }

  // Led around a disc at its end a joint would be shorter.
  [[nodiscard]] bool ends_at(std::int32_t joint, const std::vector<std::int64_t>& around) const {
    const Ends& ends = ends_[static_cast<std::size_t>(joint)];
    return std::any_of(around.begin(), around.end(),
                       [&](std::int64_t e) { return e == ends.first || e == ends.last; });
  }

  [[nodiscard]] std::int32_t other(std::int64_t e, std::int32_t i) const {
    return a_.first[e] == i ? a_.second[e] : a_.first[e];
  }

  // Of a disc beside a joint; of others none.
  [[nodiscard]] std::vector<std::int64_t> bonds_of(std::int32_t i) const {
    std::vector<std::int64_t> around;
    const auto begin = std::lower_bound(bonds_.begin(), bonds_.end(), std::pair{i, std::int64_t{0}});
    for (auto b = begin; b != bonds_.end() && b->first == i; ++b) around.push_back(b->second);
    return around;
  }

  // Whether another joint comes near, so many bonds away: led around a disc there, a joint would miss it.
  [[nodiscard]] bool joints_meet(std::int32_t i, int bonds_away) const {
    const auto joint = discs_[static_cast<std::size_t>(i)].joint;
    std::vector<std::int32_t> ring{i};
    for (; bonds_away > 0; --bonds_away) {
      std::vector<std::int32_t> next;
      for (const auto d : ring)
        for (const auto e : bonds_of(d)) {
          const Beside& disc = discs_[static_cast<std::size_t>(other(e, d))];
          if (disc.several || (disc.joint >= 0 && disc.joint != joint)) return true;
          next.push_back(other(e, d));
        }
      ring = std::move(next);
    }
    return false;
  }

  // Moves it, if it is on one bond. Returns the disc that it leaves behind, -1: none.
  std::int32_t move(std::int32_t i) {
    Beside& disc = discs_[static_cast<std::size_t>(i)];
    if (!disc.on_one_bond()) return -1;
    const auto around = bonds_of(i);
    const auto single = *std::find_if(around.begin(), around.end(), [&](std::int64_t e) { return !cut(e); });
    const auto behind = other(single, i);
    Beside& rock = discs_[static_cast<std::size_t>(behind)];
    const bool rough = joint_of_[static_cast<std::size_t>(single)] >= 0;
    if (rough || !rock.can_lose_one(disc.joint) || !beside(disc.joint, i, behind, single)) return -1;
    if (ends_at(disc.joint, around) || joints_meet(i, rings)) return -1;
    for (const auto e : around) {
      if (e == single) continue;
      joint_of_[static_cast<std::size_t>(e)] = -1;
      Beside& across = discs_[static_cast<std::size_t>(other(e, i))];
      ++across.held;
      --across.crossed;
    }
    disc.held = std::exchange(disc.crossed, 1);
    disc.moved = true;
    joint_of_[static_cast<std::size_t>(single)] = disc.joint;
    --rock.held;
    ++rock.crossed;
    rock.joint = disc.joint;
    moved_.push_back({i, disc.joint});
    return behind;
  }

  // Whether two discs are on the same side of a joint's line, and where they meet is beside the joint and not beyond its ends.
  [[nodiscard]] bool beside(std::int32_t joint, std::int32_t i, std::int32_t j, std::int64_t bond) const {
    const JointOptions& line = joints_[static_cast<std::size_t>(joint)];
    const Vec2 from{line.x1, line.y1}, along = Vec2{line.x2, line.y2} - from;
    const auto left = [&](std::int32_t d) { return cross(along, Vec2{a_.x[d], a_.y[d]} - from) > 0.0; };
    const double at = place(joint, bond);
    return left(i) == left(j) && at > 0.0 && at < norm(along);
  }

  const Assembly& a_;
  const std::vector<JointOptions>& joints_;
  std::vector<std::int32_t>& joint_of_;
  std::vector<Beside> discs_;
  std::vector<std::pair<std::int32_t, std::int64_t>> bonds_;  // of discs beside joints; ascending
  struct Ends {
    std::int64_t first = -1, last = -1;  // bonds that it crosses
  };
  std::vector<Ends> ends_;  // by joint
  std::vector<MovedDisc> moved_;
};

}  // namespace

DiscsOnOneBond move_discs_on_one_bond(const Assembly& a, const std::vector<JointOptions>& joints,
                                      std::vector<std::int32_t>& joint_of) {
  return Mover(a, joints, joint_of).move_all();
}

}  // namespace hfrac
