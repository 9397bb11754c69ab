// SPDX-License-Identifier: BSD-3-Clause
// Numbers too small to matter are made zero, so that those they lead to do not become subnormal.
//
// What a well does to pores far from it dies away by a factor with every pore, and never ends: 1e-100 Pa, 1e-200 Pa, and then numbers below
// 2e-308, which processors take a hundred times as long for. Solvers of flow cut it off where even products of two such numbers
// are ordinary ones. By arithmetic, not by a mode of the processor, so that a card has the same bits and the host's mode stays as it is.
//
// No standard templates here, since kernels for devices include it (linear/multigrid_kernels.hpp).
#pragma once

namespace hfrac {

constexpr double negligible = 1e-130;  // in SI units; pressures of rock are known to some 1e-9 Pa

// What is not finite stays as it is.
inline double unless_negligible(double value) {
  return value < negligible && value > -negligible ? 0.0 : value;
}

}  // namespace hfrac
