// SPDX-License-Identifier: BSD-3-Clause
#include "solid/sweep.hpp"

#include <algorithm>

#include "solid/kernels.hpp"

namespace hfrac {
namespace {

std::int64_t block_count(std::int64_t n) {
  return (n + kernel_block - 1) / kernel_block;
}

// Lowest and highest disc that a block of bonds or domains looks at.
struct Reach {
  std::int64_t low, high;
};

std::vector<Reach> bond_reach(const Assembly& a) {
  std::vector<Reach> reach(static_cast<std::size_t>(block_count(a.bond_count())), {a.disc_count(), -1});
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    Reach& r = reach[static_cast<std::size_t>(e / kernel_block)];
    r.low = std::min<std::int64_t>(r.low, a.first[e]);
    r.high = std::max<std::int64_t>(r.high, a.second[e]);
  }
  return reach;
}

std::vector<Reach> domain_reach(const Assembly& a, const Network& n) {
  std::vector<Reach> reach(static_cast<std::size_t>(block_count(n.domain_count())), {a.disc_count(), -1});
  for (std::int64_t d = 0; d < n.domain_count(); ++d) {
    Reach& r = reach[static_cast<std::size_t>(d / kernel_block)];
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      r.low = std::min<std::int64_t>(r.low, n.corner_disc[k]);
      r.high = std::max<std::int64_t>(r.high, n.corner_disc[k]);
    }
  }
  return reach;
}

}  // namespace

std::vector<Sweep> plan_sweeps(const Assembly& a, const Network& n, int workers) {
  const std::int64_t discs = a.disc_count(), disc_blocks = block_count(discs);
  const auto bonds = bond_reach(a), domains = domain_reach(a, n);
  const auto item = [](SweepItem::Kind kind, std::size_t block, std::int64_t count) {
    const auto first = static_cast<std::int64_t>(block) * kernel_block;
    return SweepItem{kind, first, std::min(first + kernel_block, count)};
  };
  std::vector<Sweep> sweeps(static_cast<std::size_t>(workers));
  std::vector<char> bonds_taken(bonds.size(), 0), domains_taken(domains.size(), 0);
  for (int w = 0; w < workers; ++w) {
    Sweep& sweep = sweeps[static_cast<std::size_t>(w)];
    const std::int64_t first_block = disc_blocks * w / workers, last_block = disc_blocks * (w + 1) / workers;
    const std::int64_t low = first_block * kernel_block, high = std::min(discs, last_block * kernel_block);
    const auto inside = [&](const Reach& r) { return r.low >= low && r.high < high; };
    const auto begins_here = [&](const Reach& r) { return r.low >= low && r.low < high; };
    std::vector<std::size_t> my_bonds, my_domains;
    for (std::size_t b = 0; b < bonds.size(); ++b) {
      if (bonds_taken[b] || !begins_here(bonds[b])) continue;
      bonds_taken[b] = 1;
      if (inside(bonds[b])) {
        my_bonds.push_back(b);
      } else {
        sweep.shared.push_back(item(SweepItem::Kind::bonds, b, a.bond_count()));
      }
    }
    for (std::size_t b = 0; b < domains.size(); ++b) {
      if (domains_taken[b] || !begins_here(domains[b])) continue;
      domains_taken[b] = 1;
      if (inside(domains[b])) {
        my_domains.push_back(b);
      } else {
        sweep.shared.push_back(item(SweepItem::Kind::domains, b, n.domain_count()));
      }
    }
    // A block of discs may move once every block of bonds and domains that looks at one of them is done.
    std::size_t next_bond = 0, next_domain = 0;
    for (std::int64_t q = first_block; q < last_block; ++q) {
      const std::int64_t end = std::min(discs, (q + 1) * kernel_block);
      for (; next_bond < my_bonds.size() && bonds[my_bonds[next_bond]].low < end; ++next_bond) {
        sweep.own.push_back(item(SweepItem::Kind::bonds, my_bonds[next_bond], a.bond_count()));
      }
      for (; next_domain < my_domains.size() && domains[my_domains[next_domain]].low < end; ++next_domain) {
        sweep.own.push_back(item(SweepItem::Kind::domains, my_domains[next_domain], n.domain_count()));
      }
      sweep.own.push_back(item(SweepItem::Kind::discs, static_cast<std::size_t>(q), discs));
    }
  }
  return sweeps;
}

}  // namespace hfrac
