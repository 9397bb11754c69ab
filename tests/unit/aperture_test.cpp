// SPDX-License-Identifier: BSD-3-Clause
// Apertures of pipes: both branches of eq. 7, the cap, and the cubic law.
#include "flow/aperture.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/workers.hpp"
#include "model.hpp"

namespace aperture_test {

using namespace testing_unit;

TEST(Aperture, ShrinksWithCompression) {
  const Options o;
  NormalView bond{};
  EXPECT_EQ(pipe_aperture(o, 5e-5, bond, true), 5e-5);
  bond.force = -50e6;  // pressed with F0 = 50 MN
  bond.gap = -1e-3;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, true), 2.5e-5);
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, false), 2.5e-5);
  bond.force = -150e6;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, true), 1.25e-5);
}

TEST(Aperture, GrowsWithTheGap) {
  Options o;
  NormalView bond{};
  bond.gap = 2e-3;
  bond.force = 1e7;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, true), 5e-5);  // intact rock keeps r0 by default
  bond.force = 0.0;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, false), 5e-5 + 2e-3);
  o.flow_gap_factor = 0.5;
  o.flow_bonded_gap_factor = 0.1;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, false), 5e-5 + 1e-3);
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, true), 5e-5 + 2e-4);
}

TEST(Aperture, IsCapped) {
  Options o;
  NormalView bond{};
  bond.gap = 0.5;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, false), o.flow_aperture_limit);
  o.flow_aperture_limit = 0.2;
  EXPECT_DOUBLE_EQ(pipe_aperture(o, 5e-5, bond, false), 0.2);
}

TEST(Aperture, HasTheSameBitsOnAnyNumberOfWorkers) {
  Options o = dry_options(2500);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  TestModel m(o, packed(o));
  ASSERT_GT(m.network.left.size(), 4096U);  // fewer are not shared
  m.network.zero_stress_aperture = 4e-5;
  m.shake(1e-4, 6);
  for (std::size_t e = 0; e < m.network.left.size(); e += 50) m.assembly.intact[e] = 0;
  update_apertures(m.network, m.assembly, o);
  const auto apertures = m.network.aperture, conductances = m.network.conductance;
  for (const int count : {1, 2, 3}) {
    Workers workers(count);
    for (auto* values : {&m.network.aperture, &m.network.conductance})
      std::fill(values->begin(), values->end(), -1.0);
    update_apertures(m.network, m.assembly, o, &workers);
    EXPECT_EQ(m.network.aperture, apertures) << count;
    EXPECT_EQ(m.network.conductance, conductances) << count;
  }
}

TEST(Aperture, SetsTheConductanceOfItsPipe) {
  for (const auto shape : {ContactShape::round, ContactShape::flat}) {
    for (const auto mode : {ContactMode::parallel, ContactMode::after_break}) {
      Options o = dry_options(1300);  // several tiles
      o.flow_scheme = choice(FlowScheme::implicit_scheme);
      o.contact_shape = choice(shape);
      o.contact_mode = choice(mode);
      TestModel m(o, packed(o));
      m.network.zero_stress_aperture = 4e-5;
      m.shake(1e-4, 6);
      for (std::size_t e = 7; e < m.network.left.size(); e += 3) m.assembly.intact[e] = 0;
      update_apertures(m.network, m.assembly, o);
      for (std::size_t e = 0; e < m.network.left.size(); ++e) {
        const double w = m.network.aperture[e];
        const BondView bond = view_bond(m.assembly, o, static_cast<std::int64_t>(e));
        ASSERT_EQ(w, pipe_aperture(o, 4e-5, {bond.gap, bond.normal_force()}, m.assembly.intact[e] != 0));
        const double length =
            m.assembly.radius[m.assembly.first[e]] + m.assembly.radius[m.assembly.second[e]];
        ASSERT_NEAR(m.network.conductance[e], w * w * w / (12.0 * 0.3 * length),
                    1e-12 * m.network.conductance[e]);
      }
    }
  }
}

}  // namespace aperture_test
