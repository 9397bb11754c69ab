// SPDX-License-Identifier: BSD-3-Clause
// In which order a cycle goes through memory.
//
// Bonds are sorted by their first disc and the first disc is the lower numbered one, so every bond of disc d is done once
// the bonds of all discs up to d are; and no bond of a later disc looks at d again. Domains are sorted by their lowest
// disc likewise. One sweep therefore does it all: bonds of a block of discs, domains that begin there, then those discs
// may move at once, while the forces just computed are still in cache. (Three whole passes would stream every bond force
// out to memory and back.)
//
//   discs   |  moved already  | block q |  still where they were  |
//   bonds                     |  done ->|
//
// With several workers each sweeps its own range of discs. What touches two ranges is done in a phase of its own first, so
// that nobody moves a disc another one still looks at. Values do not depend on who computes them, and each disc adds up
// its forces in a fixed order: any number of workers gives the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "flow/network.hpp"
#include "solid/assembly.hpp"

namespace hfrac {

struct SweepItem {
  enum class Kind : std::int32_t { bonds, domains, discs };
  Kind kind;
  std::int64_t first, last;  // of bonds, domains or discs; whole blocks of kernel_block
};

struct Sweep {
  std::vector<SweepItem> shared;  // bonds and domains that touch other workers' discs
  std::vector<SweepItem> own;     // the sweep through the worker's discs
};

// One sweep per worker.
std::vector<Sweep> plan_sweeps(const Assembly& assembly, const Network& network, int workers);

}  // namespace hfrac
