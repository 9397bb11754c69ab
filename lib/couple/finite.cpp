// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are no numbers: found at the end of the step that made them, and named.
//
// The mechanics watch their forces while they move; this looks at all a step leaves behind, by the one list of what a state is
// (visit_state). Only if something is wrong is it asked what, and where.
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "couple/simulation.hpp"

namespace hfrac {
namespace {

// Index of the first value that is not finite; -1: none.
std::int64_t first_bad(const Array<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) return static_cast<std::int64_t>(k);
  }
  return -1;
}

}  // namespace

void Simulation::require_finite() const {
  if (const std::string what = not_finite(); !what.empty()) throw Error(ErrorKind::diverged, what);
}

std::string Simulation::not_finite() const {
  if (is_finite()) return {};
  const std::string end =
      " after " + std::to_string(time_) +
      " s; use a shorter stepping.flow_step or a lower stepping.safety, or smaller loads and rates";
  if (const std::string where = solver_->first_not_finite(); !where.empty())
    return "a number is no longer finite" + where + end;
  struct Named {
    const Array<double>& values;
    const char* what;
    const char* equation;
  };
  std::vector<Named> all = {
      {network_.content, "what is held by domain ", " (eq. 8)"},
      {network_.volume_change, "the volume of domain ", " (eq. 8)"},
      {network_.aperture, "the aperture of pipe ", " (eq. 7)"},
      {network_.conductance, "the conductance of pipe ", " (eq. 6)"},
      {network_.flow, "the flow in pipe ", " (eq. 6)"},
      {assembly_.slip, "the slip of bond ", " (eq. 18)"},
  };
  if (heat_) {
    all.push_back({heat_->state.disc, "the temperature of disc ", " (conduction of heat)"});
    all.push_back({heat_->state.fluid, "the temperature of domain ", " (heat carried by the fluid)"});
  }
  for (const auto& [values, what, equation] : all) {
    if (const auto bad = first_bad(values); bad >= 0)
      return what + std::to_string(bad) + " is no longer finite" + equation + end;
  }
  return "the balances left the range of finite numbers" + end;
}

}  // namespace hfrac
