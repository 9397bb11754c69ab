// SPDX-License-Identifier: BSD-3-Clause
#include "build/fallen_discs.hpp"

#include "options/choices.hpp"

namespace hfrac {
namespace {

constexpr int fewest_held = 2;  // bonds, as of any disc at bonding

struct Hold {
  int bonds = 0;
  bool cut = false;
};

}  // namespace

std::vector<std::int32_t> fallen_discs(const Assembly& a, const std::vector<JointOptions>& joints,
                                       const Faces& faces, const std::vector<std::int32_t>& holes) {
  std::vector<std::int32_t> fallen;
  if (joints.empty() || holes.empty()) return fallen;
  std::vector<Hold> discs(static_cast<std::size_t>(a.disc_count()));
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    const auto k = a.joints.joint_of(e);
    const JointState state{k < 0 ? 0 : joints[static_cast<std::size_t>(k)].state};
    const bool cut = k >= 0 && is_smooth(state) && is_broken(state);
    for (const auto i : {a.first[e], a.second[e]}) {
      Hold& disc = discs[static_cast<std::size_t>(i)];
      disc.cut = disc.cut || cut;
      disc.bonds += cut ? 0 : 1;
    }
  }
  for (const auto hole : holes) {
    for (auto k = faces.corner_start[hole]; k < faces.corner_start[hole + 1]; ++k) {
      Hold& disc = discs[static_cast<std::size_t>(faces.corner[k])];
      if (!disc.cut || disc.bonds >= fewest_held) continue;
      disc.cut = false;  // once, should a face have it at several corners
      fallen.push_back(faces.corner[k]);
    }
  }
  return fallen;
}

}  // namespace hfrac
