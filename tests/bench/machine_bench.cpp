// SPDX-License-Identifier: BSD-3-Clause
// The machine's limits as lines "what,workers,value,unit", for tests/bench/compare.
#include <cstdio>
#include <initializer_list>

#include "machine.hpp"

using namespace hfrac::bench;

int main() {
  for (const int threads : {1, 2}) {
    std::printf("triad in memory,%d,%.4g,B/s\n", threads, triad(std::size_t{1} << 24U, 5, threads));
    std::printf("triad in L2,%d,%.4g,B/s\n", threads, triad(std::size_t{1} << 14U, 5, threads));
    std::printf("multiply-add,%d,%.4g,1/s\n", threads, multiply_add(5, threads));
  }
  return 0;
}
