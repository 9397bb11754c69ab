// SPDX-License-Identifier: BSD-3-Clause
// The step loop's kernels: the same bits on every instruction set, the law of view_bond, forces that are the
// gradient of the energy and balance each other, and no force from turning the whole body.
#include "solid/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "model.hpp"

namespace {

using namespace testing_unit;

Options kernel_options(ContactMode mode) {
  Options o = dry_options(700);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.contact_mode = choice(mode);
  o.bond_tensile_strength = o.bond_shear_strength = 42.5e6;
  return o;
}

// A state with everything in it: broken bonds, sliding, pressures, motion.
void stir(Model& m) {
  m.shake(1e-3, 11);
  Random random(12);
  for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
    if (random.uniform() < 0.2) m.assembly.intact[e] = 0.0;
    m.assembly.slip[e] = 1e-4 * (random.uniform() - 0.5);
  }
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.vx[i] = 1e-5 * (random.uniform() - 0.5);
    m.assembly.vy[i] = i % 7 == 0 ? 0.0 : 1e-5 * (random.uniform() - 0.5);
    m.assembly.spin[i] = 1e-5 * (random.uniform() - 0.5);
    m.assembly.external_x[i] = 1e6 * random.uniform();
  }
  m.fill_pores();
  for (std::int64_t d = 0; d < m.network.domain_count(); ++d)
    m.network.content[d] = 1e-4 * (random.uniform() - 0.5);
}

// What the three passes write, as bytes.
std::string outputs_of(const char* isa, ContactMode mode) {
  const Options o = kernel_options(mode);
  Model m(o, packed(o));
  stir(m);
  const KernelTable& table = *kernels_for(isa);
  KernelArrays a = m.solver->arrays();
  a.stiffness = m.network.stiffness.data();
  std::string bytes;
  const auto keep = [&bytes](const auto* values, std::int64_t count) {
    bytes.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(*values));
  };
  const auto blocks = [](std::int64_t n) { return (n + kernel_block - 1) / kernel_block; };
  for (int cycle = 0; cycle < 3; ++cycle) {
    table.bond_pass(a, 0, a.bond_count);
    table.domain_pass(a, 0, a.domain_count);
    table.disc_pass(a, 0, a.disc_count);
    keep(a.force, a.bond_count);
    keep(a.slip, a.bond_count);
    for (const double* values : {a.ux, a.uy, a.rotation, a.vx, a.vy, a.spin}) keep(values, a.disc_count);
    keep(a.pressure, a.domain_count);
    keep(a.volume_change, a.domain_count);
    keep(a.bond_sums, blocks(a.bond_count));
    keep(a.disc_sums, blocks(a.disc_count));
    keep(a.domain_sums, blocks(a.domain_count));
  }
  return bytes;
}

TEST(Kernels, GiveTheSameBitsOnEveryInstructionSet) {
  for (const auto mode : {ContactMode::parallel, ContactMode::after_break}) {
    const std::string baseline = outputs_of("baseline", mode);
    for (const char* isa : {"avx2", "avx512"}) {
      if (kernels_for(isa) == nullptr) {
        GTEST_LOG_(INFO) << isa << " is not available on this processor: not compared";
        continue;
      }
      const std::string wide = outputs_of(isa, mode);
      ASSERT_EQ(wide.size(), baseline.size());
      EXPECT_EQ(std::memcmp(wide.data(), baseline.data(), baseline.size()), 0) << isa;
    }
  }
  EXPECT_EQ(kernels_for("none"), nullptr);
}

TEST(Kernels, FollowTheLawOfViewBond) {
  for (const auto mode : {ContactMode::parallel, ContactMode::after_break}) {
    Options o = kernel_options(mode);
    o.bond_tensile_strength = o.bond_shear_strength = 5e6;  // so that some bonds fail
    Model m(o, packed(o));
    stir(m);
    const Array<double> slip = m.assembly.slip;
    m.solver->evaluate();
    const Array<double> slipped = m.assembly.slip;
    std::vector<char> breaks_in_block(static_cast<std::size_t>(m.assembly.bond_count() / kernel_block + 1),
                                      0);
    std::int64_t breaking = 0;
    for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
      m.assembly.slip[e] = slip[e];
      const BondView bond = view_bond(m.assembly, o, e);
      const auto i = m.assembly.first[e], j = m.assembly.second[e];
      const double now = std::hypot(m.assembly.position(j).x - m.assembly.position(i).x,
                                    m.assembly.position(j).y - m.assembly.position(i).y);
      const double ratio = m.assembly.length[e] / now, tangential = bond.shear_force() * ratio;
      const BondForce& force = m.assembly.force[e];
      const double scale = 1e-12 * (std::abs(bond.normal_force()) + std::abs(tangential) + 1.0);
      EXPECT_NEAR(force.fx, bond.normal_force() * bond.normal.x - tangential * bond.normal.y, scale);
      EXPECT_NEAR(force.fy, bond.normal_force() * bond.normal.y + tangential * bond.normal.x, scale);
      EXPECT_NEAR(force.moment_i, bond.shear_force() * m.assembly.arm[e] + bond.bond_moment, scale);
      EXPECT_NEAR(force.moment_j,
                  bond.shear_force() * (m.assembly.length[e] - m.assembly.arm[e]) - bond.bond_moment, scale);
      // Sliding leaves the contact at the Coulomb limit, and never above it.
      m.assembly.slip[e] = slipped[e];
      const BondView after = view_bond(m.assembly, o, e);
      EXPECT_NEAR(after.contact_shear, bond.contact_shear, scale);
      EXPECT_LE(std::abs(after.contact_shear), o.contact_friction * after.contact_normal + scale);
      const bool breaks =
          m.assembly.intact[e] > 0.0 && (bond.tensile_excess >= 1.0 || bond.shear_excess >= 1.0);
      breaking += breaks ? 1 : 0;
      if (breaks) breaks_in_block[static_cast<std::size_t>(e / kernel_block)] = 1;
    }
    EXPECT_GT(breaking, 0);  // the state is violent enough to mean something
    EXPECT_LT(breaking, m.assembly.bond_count() / 2);
    for (std::size_t b = 0; b < breaks_in_block.size(); ++b) {
      EXPECT_EQ(m.solver->arrays().bond_sums[b].flagged, breaks_in_block[b]) << "block " << b;
    }
  }
}

TEST(Kernels, ForcesAreTheGradientOfTheEnergy) {
  Options o = kernel_options(ContactMode::after_break);
  Model m(o, packed(o));
  m.shake(1e-3, 21);
  m.solver->evaluate();
  const auto force_on = [&](std::int64_t disc, int component) {
    double total = 0.0;
    for (auto k = m.assembly.incidence_start[disc]; k < m.assembly.incidence_start[disc + 1]; ++k) {
      const BondForce& f = m.assembly.force[m.assembly.incidence[k] / 2];
      const bool second = m.assembly.incidence[k] % 2 != 0;
      if (component == 2) {
        total += second ? f.moment_j : f.moment_i;
      } else {
        total += (second ? -1.0 : 1.0) * (component == 0 ? f.fx : f.fy);
      }
    }
    return total;
  };
  // Only the bonds at the disc change with it.
  const auto energy_at = [&](std::int64_t disc) {
    double energy = 0.0;
    for (auto k = m.assembly.incidence_start[disc]; k < m.assembly.incidence_start[disc + 1]; ++k) {
      const BondView bond = view_bond(m.assembly, o, m.assembly.incidence[k] / 2);
      energy += bond.bond_energy + bond.contact_energy;
    }
    return energy;
  };
  for (std::int64_t disc = 0; disc < m.assembly.disc_count(); disc += 37) {
    double* const coordinate[] = {&m.assembly.ux[disc], &m.assembly.uy[disc], &m.assembly.rotation[disc]};
    for (int component = 0; component < 3; ++component) {
      const double at = *coordinate[component], step = 1e-6 * m.assembly.mean_radius;
      *coordinate[component] = at + step;
      const double above = energy_at(disc);
      *coordinate[component] = at - step;
      const double below = energy_at(disc);
      *coordinate[component] = at;
      const double force = force_on(disc, component);
      EXPECT_NEAR(force, -(above - below) / (2.0 * step), 1e-6 * o.bond_normal_stiffness * 1e-3)
          << "disc " << disc << " component " << component;
    }
  }
}

TEST(Kernels, ContactsBesideBondsPushByTheirEnergyToo) {
  // Compression without sliding: contacts are elastic then.
  Options o = kernel_options(ContactMode::parallel);
  o.contact_friction = 10.0;
  Model m(o, square_lattice(4, 4, 0.5));
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.ux[i] = -1e-3 * m.assembly.x[i];
    m.assembly.uy[i] = -2e-3 * m.assembly.y[i] + 1e-5 * m.assembly.x[i] * m.assembly.x[i];
  }
  m.solver->evaluate();
  for (std::int64_t disc = 0; disc < m.assembly.disc_count(); ++disc) {
    double force = 0.0;
    for (auto k = m.assembly.incidence_start[disc]; k < m.assembly.incidence_start[disc + 1]; ++k) {
      force +=
          (m.assembly.incidence[k] % 2 != 0 ? -1.0 : 1.0) * m.assembly.force[m.assembly.incidence[k] / 2].fy;
    }
    const double at = m.assembly.uy[disc], step = 1e-7;
    m.assembly.uy[disc] = at + step;
    const double above = m.elastic_energy();
    m.assembly.uy[disc] = at - step;
    const double below = m.elastic_energy();
    m.assembly.uy[disc] = at;
    EXPECT_NEAR(force, -(above - below) / (2.0 * step), 1e-6 * o.contact_normal_stiffness * 1e-3);
  }
}

TEST(Kernels, InnerForcesAddUpToNothing) {
  for (const auto mode : {ContactMode::parallel, ContactMode::after_break}) {
    const Options o = kernel_options(mode);
    Model m(o, packed(o));
    stir(m);
    m.solver->evaluate();
    // Disc by disc, as the disc pass gathers them.
    double fx = 0.0, fy = 0.0, torque = 0.0, size = 0.0;
    for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
      Vec2 force{};
      for (auto k = m.assembly.incidence_start[i]; k < m.assembly.incidence_start[i + 1]; ++k) {
        const bool second = m.assembly.incidence[k] % 2 != 0;
        const BondForce& f = m.assembly.force[m.assembly.incidence[k] / 2];
        force = force + (second ? -1.0 : 1.0) * Vec2{f.fx, f.fy};
        torque += second ? f.moment_j : f.moment_i;
        size += std::abs(f.fx) + std::abs(f.fy);
      }
      fx += force.x;
      fy += force.y;
      torque += cross(m.assembly.position(i), force);
    }
    EXPECT_LT(std::abs(fx), 1e-13 * size);
    EXPECT_LT(std::abs(fy), 1e-13 * size);
    EXPECT_LT(std::abs(torque), 1e-12 * size * o.model_width);
  }
}

TEST(Kernels, TurningTheBodyStrainsNothing) {
  const Options o = kernel_options(ContactMode::after_break);
  Model m(o, packed(o));
  constexpr double angle = 0.3;
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    const double x = m.assembly.x[i], y = m.assembly.y[i];
    m.assembly.ux[i] = std::cos(angle) * x - std::sin(angle) * y - x;
    m.assembly.uy[i] = std::sin(angle) * x + std::cos(angle) * y - y;
    m.assembly.rotation[i] = angle;
  }
  m.solver->evaluate();
  double worst_normal = 0.0, worst_shear = 0.0;
  for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
    const BondView bond = view_bond(m.assembly, o, e);
    worst_normal = std::max(worst_normal, std::abs(bond.gap) / m.assembly.length[e]);
    worst_shear = std::max(worst_shear, std::abs(bond.shear) / m.assembly.length[e]);
    EXPECT_EQ(bond.bond_moment, 0.0);
  }
  RecordProperty("worst_shear_strain", std::to_string(worst_shear));
  EXPECT_LT(worst_normal, 1e-13);
  // The arcsine is a series to the seventh power: 105 / 3456 angle^9 is left, 6e-7, a ten-thousandth of
  // strength.
  EXPECT_LT(worst_shear, 105.0 / 3456.0 * std::pow(std::sin(angle), 9) * 1.1);
}

}  // namespace
