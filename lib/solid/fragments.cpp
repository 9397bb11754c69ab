// SPDX-License-Identifier: BSD-3-Clause
#include "solid/fragments.hpp"

#include <algorithm>
#include <array>

#include "model/assembly.hpp"
#include "options/choices.hpp"

namespace hfrac {

namespace {
std::int64_t smallest_of(const Assembly& a, const Options& o) {
  if (FractureLaw{o.fracture_law} == FractureLaw::facet) return Fragments::most;
  const bool fluid = std::any_of(a.smooth.contacts.begin(), a.smooth.contacts.end(),
                                 [&](const SmoothContact& c) { return a.smooth.law_of(c).conducts(); });
  return fluid ? std::max(o.bond_smallest_fragment, Fragments::largest_flake + 1) : o.bond_smallest_fragment;
}
}  // namespace

Fragments::Fragments(const Assembly& a, const Options& o) : smallest_(smallest_of(a, o)) {
  if (!kept()) return;
  bond_start_.assign(static_cast<std::size_t>(a.disc_count()) + 1, 0);
  for (const auto* ends : {&a.first, &a.second}) {
    for (const auto i : *ends) ++bond_start_[static_cast<std::size_t>(i) + 1];
  }
  for (std::size_t i = 1; i < bond_start_.size(); ++i) bond_start_[i] += bond_start_[i - 1];
  bond_of_.resize(2 * a.first.size());
  auto cursor = bond_start_;
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    for (const auto i : {a.first[e], a.second[e]})
      bond_of_[static_cast<std::size_t>(cursor[static_cast<std::size_t>(i)]++)] =
          static_cast<std::int32_t>(e);
  }
}

bool Fragments::would_cut(const Assembly& a, std::int64_t bond, std::int64_t smallest) const {
  return small(a, a.first[static_cast<std::size_t>(bond)], bond, smallest) ||
         small(a, a.second[static_cast<std::size_t>(bond)], bond, smallest);
}

bool Fragments::small(const Assembly& a, std::int32_t from, std::int64_t without,
                      std::int64_t smallest) const {
  std::array<std::int32_t, most> piece;
  piece[0] = from;
  std::int64_t count = 1;
  for (std::int64_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(piece[static_cast<std::size_t>(k)]);
    for (auto q = bond_start_[i]; q < bond_start_[i + 1]; ++q) {
      const auto e = static_cast<std::size_t>(bond_of_[static_cast<std::size_t>(q)]);
      if (static_cast<std::int64_t>(e) == without || a.intact[e] == 0) continue;
      const auto other = a.first[e] == static_cast<std::int32_t>(i) ? a.second[e] : a.first[e];
      const auto end = piece.begin() + count;
      if (std::find(piece.begin(), end, other) != end) continue;
      if (count + 1 >= smallest) return false;
      piece[static_cast<std::size_t>(count++)] = other;
    }
  }
  return true;
}

}  // namespace hfrac
