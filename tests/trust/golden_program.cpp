// SPDX-License-Identifier: BSD-3-Clause
// hfrac_golden [WORKERS]: prints each case's name and fingerprint; to compare builds, machines and workers with.
//   hfrac_golden > tests/trust/golden.txt     after a change of the physics that is meant to change results
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "golden.hpp"

int main(int count, char** arguments) {
  try {
    const int64_t workers = count > 1 ? std::atoll(arguments[1]) : 1;
    for (const auto& each : golden::cases())
      std::printf("%s %016" PRIx64 "\n", each.name.c_str(), golden::fingerprint(each, workers));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hfrac_golden: %s\n", error.what());
    return 1;
  }
  return 0;
}
