// SPDX-License-Identifier: BSD-3-Clause
// Micro-parameters by temperature: the paper's Table 3 (250 to 400 degrees C), or a host's own rows.
//
// The table holds factors on what the case gives, so that it serves any rock: stiffness of contacts and bonds (the paper has the
// contacts' alone; bonds follow them), strength of bonds (not in the paper, 1 unless somebody assumes otherwise), friction.
// In between it is linear; outside there is no answer, and temperatures are refused before they get here.
#pragma once

#include <string>
#include <vector>

#include "options/options.hpp"

namespace hfrac {

struct MicroFactors {
  double stiffness = 1.0, strength = 1.0, friction = 1.0;  // over the values given
};

class MicroTable {
 public:
  // Empty with thermal.parameters = "constant".
  explicit MicroTable(const Options& options);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] MicroFactors at(double temperature) const;  // K; rounding beyond an end gives the end's
  // Throws Error(argument) for a temperature [K] outside the table, or none at all; `what` names it.
  void require(double temperature, const std::string& what) const;

 private:
  struct Row {
    double temperature;  // K
    MicroFactors factors;
  };
  std::vector<Row> rows_;
};

}  // namespace hfrac
