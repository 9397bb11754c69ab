// SPDX-License-Identifier: BSD-3-Clause
// The cases whose results are promised bit for bit, and the number that stands for all of a result.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace golden {

struct Case {
  std::string name;
  hfrac::Definition def;
  int64_t steps;
  // What a test's list shows, instead of the bytes.
  friend std::ostream& operator<<(std::ostream& out, const Case& which) { return out << which.name; }
};

/** Both solvers, all stepping modes, all ways of the flow, both boundaries; each breaks bonds, but for the dry one. */
std::vector<Case> cases();

/** Builds and steps a case with so many workers and folds what a host can read of the end - places, bonds, pressures,
 * apertures, cracks, balances - into one number. Throws std::runtime_error if a call fails. */
std::uint64_t fingerprint(const Case& which, int64_t workers);

/** What golden.txt says, by the names of cases. */
std::map<std::string, std::uint64_t> wanted(const char* file);

}  // namespace golden
