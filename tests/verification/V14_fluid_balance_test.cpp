// SPDX-License-Identifier: BSD-3-Clause
// V14  No fluid is lost or made: injected = stored + leaked, whatever breaks.
//
// Formula    injected + put in by the host = change of what pores, cracks and wells hold + what left over the outer boundary.
// Source     Conservation of mass (eq. 8).
// Set-up     2 000 discs of Table 1's rock between walls, well of 8.5 m held at 45 MPa net (and, coupled, fed at a rate), ten
//            steps with cracks, cavities and leak-off, by each solver and each way of stepping. The error is what hfrac_get_balance finds:
//            contents added up anew from all pores, against the balance kept step by step.
// Tolerance  1e-12 of what was injected, the rounding of ten steps' sums (physics.md asks for 1e-6).
#include <gtest/gtest.h>

#include <cmath>

#include "support.hpp"

namespace V14_fluid_balance {

using namespace verification;

void check_balance(const char* name, const hfrac_sim_def& def) {
  Simulation rock(def);
  hfrac_balance balance{};
  balance.struct_size = sizeof balance;
  Curves curves("V14", "Fluid by the quasi-static solver in mode coupled: injected; stored and leaked",
                "step,volume (m2 per m)");
  for (int step = 1; step <= 10; ++step) {
    rock.step(1);
    rock.balance(&balance);
    if (def.stepping_mode != 2 || def.wells[0].control == HFRAC_WELL_RATE) continue;
    curves.point("injected", {static_cast<double>(step), balance.injected_volume});
    curves.point("stored", {static_cast<double>(step), balance.stored_volume});
    curves.point("leaked", {static_cast<double>(step), balance.leaked_volume});
  }
  const double error = balance.fluid_error / balance.injected_volume;
  std::printf("  %s: injected %.4g m2, cracks %lld\n", name, balance.injected_volume,
              static_cast<long long>(rock.state().crack_count));
  EXPECT_GT(balance.injected_volume, 0.0);
  EXPECT_GT(rock.state().crack_count, 0);
  report_absolute("fluid lost over that injected", error, 0.0, 1e-12);
}

TEST(V14FluidBalanceSmoke, ClosesByEverySolver) {
  hfrac::Definition def = paper_rock(1);
  def.wells[0].pressure = 45e6;
  check_balance("explicit solver, implicit flow", def);
  hfrac::Definition narrow = def;
  narrow.flow_scheme = 1;
  narrow.flow_aperture_limit = 1e-3;  // wide cracks would need a million explicit sub-cycles
  check_balance("explicit solver, explicit flow", narrow);
  def.solver_kind = 1;
  check_balance("quasi-static solver, sub-steps", def);
  def.stepping_mode = 2;
  check_balance("quasi-static solver, coupled", def);
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 1500.0;
  check_balance("quasi-static solver, coupled, at a rate", def);
}

}  // namespace V14_fluid_balance
