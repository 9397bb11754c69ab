// SPDX-License-Identifier: BSD-3-Clause
#include "solid/discs_held.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "options/choices.hpp"
#include "solid/fragments.hpp"

namespace hfrac {
namespace {

constexpr int fewest_held = 2;  // bonds to the rock

// What some discs are held by.
struct Hold {
  int bonds = 0;            // that no joint crosses
  std::int32_t joint = -1;  // that cuts them
  bool several = false;

  void cut(std::int32_t by) {
    several = several || (joint >= 0 && joint != by);
    joint = by;
  }
};

// The discs that hang together by bonds that no joint crosses, each set by one of its discs.
class Pieces {
 public:
  explicit Pieces(std::int64_t discs) : next_(static_cast<std::size_t>(discs)), size_(next_.size(), 1) {
    std::iota(next_.begin(), next_.end(), 0);
  }
  std::size_t of(std::int32_t disc) {
    auto i = static_cast<std::size_t>(disc);
    while (static_cast<std::size_t>(next_[i]) != i)
      i = static_cast<std::size_t>(next_[i] = next_[static_cast<std::size_t>(next_[i])]);
    return i;
  }
  void join(std::int32_t disc, std::int32_t other) {
    auto i = of(disc), j = of(other);
    if (i == j) return;
    if (size_[i] < size_[j]) std::swap(i, j);
    next_[j] = static_cast<std::int32_t>(i);
    size_[i] += size_[j];
  }
  [[nodiscard]] std::int32_t size(std::size_t piece) const { return size_[piece]; }

 private:
  std::vector<std::int32_t> next_, size_;
};

}  // namespace

HeldDiscs keep_discs_held(const Assembly& a, const std::vector<JointOptions>& joints,
                          std::vector<std::int32_t>& joint_of) {
  HeldDiscs held;
  DiscsOnOneBond on_one_bond = move_discs_on_one_bond(a, joints, joint_of);
  held.moved = std::move(on_one_bond.moved);
  held.idle = std::move(on_one_bond.idle);
  const auto cut_by = [&](std::int64_t e) {
    const auto k = joint_of[static_cast<std::size_t>(e)];
    return k >= 0 && is_smooth(JointState{joints[static_cast<std::size_t>(k)].state}) ? k : -1;
  };
  Pieces pieces(a.disc_count());
  for (std::int64_t e = 0; e < a.bond_count(); ++e)
    if (cut_by(e) < 0) pieces.join(a.first[e], a.second[e]);

  std::vector<Hold> discs(static_cast<std::size_t>(a.disc_count())), flakes(discs.size());
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const auto k = cut_by(e);
    for (const auto i : {a.first[e], a.second[e]}) {
      Hold& disc = discs[static_cast<std::size_t>(i)];
      if (k < 0) {
        ++disc.bonds;
      } else {
        disc.cut(k);
        flakes[pieces.of(i)].cut(k);
      }
    }
  }
  const auto loose = [&](std::int32_t i) {
    const Hold &disc = discs[static_cast<std::size_t>(i)], &flake = flakes[pieces.of(i)];
    return (disc.several && disc.bonds < fewest_held) ||
           (flake.bonds < fewest_held && pieces.size(pieces.of(i)) <= Fragments::largest_flake);
  };
  for (std::int32_t i = 0; i < a.disc_count(); ++i) {
    const auto piece = pieces.of(i);
    if (flakes[piece].joint >= 0 && !flakes[piece].several && pieces.size(piece) <= Fragments::largest_flake)
      held.moved.push_back({i, flakes[piece].joint});
  }
  std::sort(held.moved.begin(), held.moved.end(),
            [](const MovedDisc& p, const MovedDisc& q) { return p.disc < q.disc; });
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (cut_by(e) < 0 || (!loose(a.first[e]) && !loose(a.second[e]))) continue;
    held.kept.push_back({e, cut_by(e)});
    joint_of[static_cast<std::size_t>(e)] = -1;
    for (const auto i : {a.first[e], a.second[e]}) {
      ++discs[static_cast<std::size_t>(i)].bonds;
      ++flakes[pieces.of(i)].bonds;
    }
  }
  return held;
}

}  // namespace hfrac
