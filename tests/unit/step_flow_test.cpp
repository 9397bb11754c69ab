// SPDX-License-Identifier: BSD-3-Clause
// Every flow that can be asked for after a step is the mean over that step: times its duration it is what the ledger and the pores
// say has passed, in every mode, after steps tried again and steps rejected too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "small_case.hpp"

namespace step_flow_test {

using namespace testing_unit;

struct Way {
  const char* name;
  SteppingMode mode;
  SolverKind kind;
  bool rejects;
};

class StepFlow : public testing::TestWithParam<Way> {};

CaseDefinition leaking_case(const Way& way) {
  CaseDefinition definition = cracking_case();
  Options& o = definition.options;
  o.packing_disc_count = 500;
  definition.wells[0].radius = 12.0;
  o.stepping_mode = choice(way.mode);
  o.solver_kind = choice(way.kind);
  o.stepping_flow_step = way.mode == SteppingMode::dynamic ? 1e-3 : 2e-3;
  if (way.mode == SteppingMode::dynamic) definition.wells[0].pressure = 120e6;
  o.flow_permeability = 1e-12;  // so that much leaks within a step
  return definition;
}

void take_step(Simulation& s, const Way& way, double duration) {
  if (!way.rejects) {
    s.step(s.loads(), duration);
    return;
  }
  s.begin_step();
  s.try_step(0.5 * duration);
  s.reject_step();
  s.begin_step();
  s.try_step(1.5 * duration);
  s.try_step(duration);
  s.accept_step();
}

double injected(const Simulation& s) {
  return s.wells()[0].injected;
}

TEST_P(StepFlow, IsTheMeanOverTheStep) {
  const Way way = GetParam();
  Simulation s(leaking_case(way), {}, {});
  s.set_grid(HostGrid::regular(3, 2, {-10.0, -10.0}, {40.0, 60.0}, 0.0));
  const Network& n = s.network();
  for (int k = 0; k < 4; ++k) {
    const double duration = s.options().stepping_flow_step;
    const Array<double> before = n.content;
    const double injected_before = injected(s), leaked_before = s.balance().leaked;
    take_step(s, way, duration);
    const double passed = injected(s) - injected_before, leaked = s.balance().leaked - leaked_before;
    const double scale = std::abs(passed) + std::abs(leaked);
    ASSERT_GT(scale, 0.0);

    EXPECT_NEAR(duration * s.wells()[0].rate, passed, 1e-9 * scale);
    double outflow = 0.0, leak_off = 0.0;
    for (const auto& cell : report_cells(s, Upscaling::oda)) {
      outflow += cell.outflow;
      leak_off += cell.leak_off;
    }
    EXPECT_NEAR(duration * outflow, leaked, 1e-9 * scale) << "step " << k;

    // What flows into a pore is what it holds more; what leaves the cracks' pores is their leak-off.
    std::vector<double> inflow(n.kind.size(), 0.0);
    double into_cracks = 0.0;
    const std::vector<char> cracked = fractured_pores(s.assembly(), n);
    const auto is_cracked = [&](std::int32_t d) { return cracked[static_cast<std::size_t>(d)] != 0; };
    for (std::size_t p = 0; p < n.left.size(); ++p) {
      const auto l = n.left[p], r = n.right[p];
      inflow[static_cast<std::size_t>(l)] -= n.flow[p];
      inflow[static_cast<std::size_t>(r)] += n.flow[p];
      const auto feeds = [&](std::int32_t d) {
        return n.kind[static_cast<std::size_t>(d)] != DomainKind::rock;
      };
      if (is_cracked(r) && feeds(l)) into_cracks += n.flow[p];
      if (is_cracked(l) && feeds(r)) into_cracks -= n.flow[p];
    }
    double worst = 0.0, held_by_cracks = 0.0;
    for (std::size_t d = 1; d < n.kind.size(); ++d) {
      const double gained = n.content[d] - before[d];
      if (is_cracked(static_cast<std::int32_t>(d))) held_by_cracks += gained;
      if (n.stiffness[d] > 0.0) worst = std::max(worst, std::abs(gained - duration * inflow[d]));
    }
    EXPECT_LT(worst, 1e-9 * scale) << "step " << k;
    EXPECT_NEAR(duration * leak_off, duration * into_cracks - held_by_cracks, 1e-9 * scale) << "step " << k;
  }
  EXPECT_GT(s.cracks().size(), 0U);
  if (way.mode == SteppingMode::coupled) {
    EXPECT_GT(s.model().work.increments, 4);  // several increments a step, some of them rejected
    EXPECT_GT(s.model().work.rejected_error + s.model().work.rejected_strength, 0);
  }
}

constexpr Way ways[] = {
    {"substep", SteppingMode::substep, SolverKind::explicit_solver, false},
    {"substep_rejected", SteppingMode::substep, SolverKind::explicit_solver, true},
    {"quasi_static", SteppingMode::substep, SolverKind::quasi_static, false},
    {"quasi_static_rejected", SteppingMode::substep, SolverKind::quasi_static, true},
    {"dynamic", SteppingMode::dynamic, SolverKind::explicit_solver, false},
    {"dynamic_rejected", SteppingMode::dynamic, SolverKind::explicit_solver, true},
    {"coupled", SteppingMode::coupled, SolverKind::quasi_static, false},
    {"coupled_rejected", SteppingMode::coupled, SolverKind::quasi_static, true},
};
INSTANTIATE_TEST_SUITE_P(Ways, StepFlow, testing::ValuesIn(ways),
                         [](const auto& way) { return way.param.name; });

}  // namespace step_flow_test
