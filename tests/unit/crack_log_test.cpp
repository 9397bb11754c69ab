// SPDX-License-Identifier: BSD-3-Clause
// The log of broken bonds: in order of breakage, each bond once, with what it bore when it failed.
#include "model/crack_log.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "model.hpp"

namespace crack_log_test {

using namespace testing_unit;

TEST(CrackLog, IsInOrderOfBreakage) {
  Options o = dry_options(500);
  o.bond_tensile_strength = 5e6;
  o.bond_shear_strength = 5e6;
  TestModel m(o, packed(o), {}, 2);
  // Pulled apart from the middle, faster and faster.
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.vx[i] = 2e-4 * (m.assembly.x[i] - 10.0) / 10.0;
    m.assembly.vy[i] = 1e-4 * (m.assembly.y[i] - 10.0) / 10.0;
  }
  CrackLog log;
  m.solver->run(100, log);
  const std::size_t first_batch = log.size();
  m.solver->run(100, log);
  ASSERT_GT(first_batch, 10u);
  std::set<std::int64_t> bonds;
  double energy = 0.0;
  std::int64_t tensile = 0;
  for (std::size_t c = 0; c < log.size(); ++c) {
    if (c > 0) {
      EXPECT_TRUE(log[c - 1].cycle < log[c].cycle ||
                  (log[c - 1].cycle == log[c].cycle && log[c - 1].bond < log[c].bond));
    }
    EXPECT_TRUE(bonds.insert(log[c].bond).second) << "bond " << log[c].bond << " broke twice";
    EXPECT_EQ(m.assembly.intact[log[c].bond], 0.0);
    EXPECT_EQ(log[c].cycle < 100, c < first_batch);
    // A bond that fails in shear bears its shear strength, give or take what one cycle adds.
    const double shear = std::abs(log[c].shear_force) / m.assembly.shear_capacity(log[c].bond);
    if (log[c].mode == CrackMode::shear) {
      EXPECT_GE(shear, 1.0);
    } else {
      EXPECT_LT(shear, 2.0);
    }
    tensile += log[c].mode == CrackMode::tension ? 1 : 0;
    energy += log[c].energy;
    EXPECT_GT(log[c].energy, 0.0);
  }
  EXPECT_GT(tensile, 0);
  std::int64_t broken = 0;
  for (const double intact : m.assembly.intact) broken += intact == 0.0 ? 1 : 0;
  EXPECT_EQ(broken, static_cast<std::int64_t>(log.size()));
  EXPECT_NEAR(m.solver->energies().fracture, energy, 1e-9 * energy);
}

}  // namespace crack_log_test
