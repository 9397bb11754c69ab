// SPDX-License-Identifier: BSD-3-Clause
// The step loop's kernels: the same bits on every instruction set, the law of view_bond, forces that are the
// gradient of the energy and balance each other, and no force from turning the whole body.
#include "solid/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "model.hpp"

namespace kernels_test {

using namespace testing_unit;

Options kernel_options(ContactMode mode, ContactShape shape = ContactShape::round, double energy = 0.0) {
  Options o = dry_options(700);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.contact_mode = choice(mode);
  o.contact_shape = choice(shape);
  o.bond_tensile_strength = o.bond_shear_strength = energy > 0.0 ? 5e6 : 42.5e6;
  o.bond_fracture_energy = energy;
  return o;
}

struct Law {
  ContactMode mode;
  ContactShape shape;
  double energy = 0.0;  // J/m2: bonds soften
};
constexpr Law laws[] = {
    {ContactMode::parallel, ContactShape::round},      {ContactMode::after_break, ContactShape::round},
    {ContactMode::parallel, ContactShape::flat},       {ContactMode::after_break, ContactShape::flat},
    {ContactMode::parallel, ContactShape::round, 4e3}, {ContactMode::after_break, ContactShape::flat, 4e3}};

// A state with everything in it: broken bonds, sliding, pressures, motion.
void stir(TestModel& m) {
  m.shake(1e-3, 11);
  Random random(12);
  for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
    if (random.uniform() < 0.2) m.assembly.intact[e] = 0;
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

// One cycle by a table's kernels, as the solver takes it.
void cycle(const KernelTable& table, const KernelArrays& a) {
  alignas(64) double scratch[tile_scratch];
  for (std::int64_t p = 0; p < a.pair_count; ++p) table.cross_bonds(a, p);
  for (std::int64_t t = 0; t <= a.tile_count; ++t) table.cross_domains(a, t);
  for (std::int64_t t = 0; t < a.tile_count; ++t) {
    table.tile_forces(a, t, scratch);
    table.tile_move(a, t, scratch);
  }
}

std::vector<BondForce> forces_of(const TestModel& m) {
  std::vector<BondForce> forces(static_cast<std::size_t>(m.assembly.bond_count()));
  kernels().bond_forces(m.solver->arrays(), forces.data());
  return forces;
}

// What a cycle writes, as bytes.
std::string outputs_of(const char* isa, const Law& law) {
  const Options o = kernel_options(law.mode, law.shape, law.energy);
  TestModel m(o, packed(o));
  stir(m);
  const KernelTable& table = *kernels_for(isa);
  KernelArrays a = m.solver->arrays();
  a.stiffness = m.network.stiffness.data();
  std::string bytes;
  const auto keep = [&bytes](const auto* values, std::int64_t count) {
    bytes.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(*values));
  };
  a.undrained = 1;
  EXPECT_EQ(a.tile_count, 2);  // so that bonds and pores across tiles have their part
  EXPECT_LT(a.first_cross_bond, a.bond_count);
  std::vector<BondForce> force(static_cast<std::size_t>(a.bond_count));
  for (int round = 0; round < 3; ++round) {
    cycle(table, a);
    table.bond_forces(a, force.data());
    keep(force.data(), a.bond_count);
    keep(a.slip, a.bond_count);
    if (law.energy > 0.0) {
      keep(a.softening_start, a.bond_count);
      keep(a.softening_worst, a.bond_count);
    }
    for (const double* values : {a.ux, a.uy, a.rotation, a.vx, a.vy, a.spin}) keep(values, a.disc_count);
    keep(a.pressure, m.network.domain_count());
    keep(a.volume_change, m.network.domain_count());
    keep(a.bond_sums, a.tile_count + a.pair_count);
    keep(a.disc_sums, a.tile_count);
    keep(a.domain_sums, 2 * a.tile_count + 1);
  }
  return bytes;
}

TEST(Kernels, GiveTheSameBitsOnEveryInstructionSet) {
  for (const Law& law : laws) {
    const std::string baseline = outputs_of("baseline", law);
    for (const char* isa : {"avx2", "avx512"}) {
      if (kernels_for(isa) == nullptr) {
        GTEST_LOG_(INFO) << isa << " is not available on this processor: not compared";
        continue;
      }
      const std::string wide = outputs_of(isa, law);
      ASSERT_EQ(wide.size(), baseline.size());
      EXPECT_EQ(std::memcmp(wide.data(), baseline.data(), baseline.size()), 0) << isa;
    }
  }
  EXPECT_EQ(kernels_for("none"), nullptr);
}

TEST(Kernels, FollowTheLawOfViewBond) {
  for (const Law& law : laws) {
    Options o = kernel_options(law.mode, law.shape, law.energy);
    o.bond_tensile_strength = o.bond_shear_strength = 5e6;  // so that some bonds fail
    TestModel m(o, packed(o));
    stir(m);
    const Array<double> slip = m.assembly.slip;
    const Softening whole = m.assembly.softening;
    const auto forces = forces_of(m);
    m.solver->evaluate();
    const Array<double> slipped = m.assembly.slip;
    const Softening softened = std::exchange(m.assembly.softening, whole);
    const KernelArrays& a = m.solver->arrays();
    std::vector<char> breaks_in(static_cast<std::size_t>(a.tile_count + a.pair_count), 0);  // by part
    std::int64_t breaking = 0;
    for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
      m.assembly.slip[e] = slip[e];
      const BondView bond = view_bond(m.assembly, o, e);
      const auto i = m.assembly.first[e], j = m.assembly.second[e];
      const double now = std::hypot(m.assembly.dx(e) + m.assembly.ux[j] - m.assembly.ux[i],
                                    m.assembly.dy(e) + m.assembly.uy[j] - m.assembly.uy[i]);
      const double ratio = m.assembly.length(e) / now, tangential = bond.shear_force() * ratio;
      const double moment = bond.bond_moment + bond.contact_moment;
      const BondForce& force = forces[static_cast<std::size_t>(e)];
      const double scale = 1e-12 * (std::abs(bond.normal_force()) + std::abs(tangential) + 1.0);
      EXPECT_NEAR(force.fx, bond.normal_force() * bond.normal.x - tangential * bond.normal.y, scale);
      EXPECT_NEAR(force.fy, bond.normal_force() * bond.normal.y + tangential * bond.normal.x, scale);
      EXPECT_NEAR(force.moment_i, bond.shear_force() * m.assembly.arm(e) + moment, scale);
      EXPECT_NEAR(force.moment_j, bond.shear_force() * (m.assembly.length(e) - m.assembly.arm(e)) - moment,
                  scale);
      // Sliding leaves the contact at the Coulomb limit, and never above it.
      m.assembly.slip[e] = slipped[e];
      const BondView after = view_bond(m.assembly, o, e);
      // The slip is a difference from the shear displacement, and rounds as that does: a barely pressed contact bears less.
      const double rounding = 1e-15 * o.contact_shear_stiffness * std::abs(bond.shear);
      EXPECT_NEAR(after.contact_shear, bond.contact_shear, scale + rounding);
      EXPECT_LE(std::abs(after.contact_shear), o.contact_friction * after.contact_normal + scale);
      if (law.energy > 0.0) {
        const Softened s = bond_law(m.assembly, o, e).softened;
        EXPECT_NEAR(softened.start[e], s.start, 1e-12 * s.start);
        EXPECT_NEAR(softened.worst[e], s.worst, 1e-12 * s.worst);
      }
      const bool breaks =
          m.assembly.intact[e] > 0.0 && (bond.tensile_excess >= 1.0 || bond.shear_excess >= 1.0);
      breaking += breaks ? 1 : 0;
      if (!breaks) continue;
      breaks_in[m.assembly.part_of(e)] = 1;
    }
    EXPECT_GT(breaking, 0);  // the state is violent enough to mean something
    EXPECT_LT(breaking, m.assembly.bond_count() / 2);
    for (std::size_t t = 0; t < breaks_in.size(); ++t)
      EXPECT_EQ(a.bond_sums[t].flagged, breaks_in[t]) << "part " << t;
  }
}

TEST(Kernels, ForcesAreTheGradientOfTheEnergy) {
  Options o = kernel_options(ContactMode::after_break);
  TestModel m(o, packed(o));
  m.shake(1e-3, 21);
  const auto forces = forces_of(m);
  const auto force_on = [&](std::int64_t disc, int component) {
    double total = 0.0;
    for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
      if (m.assembly.first[e] != disc && m.assembly.second[e] != disc) continue;
      const BondForce& f = forces[static_cast<std::size_t>(e)];
      const bool second = m.assembly.second[e] == disc;
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
    for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
      if (m.assembly.first[e] != disc && m.assembly.second[e] != disc) continue;
      const BondView bond = view_bond(m.assembly, o, e);
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
  TestModel m(o, square_lattice(4, 4, 0.5));
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.ux[i] = -1e-3 * m.assembly.x[i];
    m.assembly.uy[i] = -2e-3 * m.assembly.y[i] + 1e-5 * m.assembly.x[i] * m.assembly.x[i];
  }
  const auto forces = forces_of(m);
  for (std::int64_t disc = 0; disc < m.assembly.disc_count(); ++disc) {
    double force = 0.0;
    for (std::int64_t e = 0; e < m.assembly.bond_count(); ++e) {
      if (m.assembly.first[e] == disc) force += forces[static_cast<std::size_t>(e)].fy;
      if (m.assembly.second[e] == disc) force -= forces[static_cast<std::size_t>(e)].fy;
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

// A disc's motion in one undamped cycle from rest is what all that acts on it makes of it, within a tile or across.
TEST(Kernels, TilesAddUpWhatActsOnADisc) {
  Options o = kernel_options(ContactMode::parallel);
  o.boundary_kind = choice(BoundaryKind::walls);  // the pressure outside pushes too
  o.stepping_damping = 0.0;
  TestModel m(o, packed(o));
  stir(m);
  for (auto* v : {&m.assembly.vx, &m.assembly.vy, &m.assembly.spin}) std::fill(v->begin(), v->end(), 0.0);
  const auto forces = forces_of(m);
  const auto discs = static_cast<std::size_t>(m.assembly.disc_count());
  std::vector<double> fx(m.assembly.external_x.begin(), m.assembly.external_x.end()), fy(discs, 0.0),
      moment(discs, 0.0);
  for (std::size_t e = 0; e < forces.size(); ++e) {
    const auto i = static_cast<std::size_t>(m.assembly.first[e]),
               j = static_cast<std::size_t>(m.assembly.second[e]);
    fx[i] += forces[e].fx;
    fy[i] += forces[e].fy;
    fx[j] -= forces[e].fx;
    fy[j] -= forces[e].fy;
    moment[i] += forces[e].moment_i;
    moment[j] += forces[e].moment_j;
  }
  const Network& n = m.network;
  for (std::int64_t d = 0; d < n.domain_count(); ++d) {
    double change = 0.0;
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const auto i = static_cast<std::size_t>(n.corner_disc[k]);
      change += n.corner_weight[2 * k] * m.assembly.ux[i] + n.corner_weight[2 * k + 1] * m.assembly.uy[i];
    }
    const double p =
        n.stiffness[d] > 0.0
            ? std::max(n.floor_pressure, n.reference_pressure + n.stiffness[d] * (n.content[d] - change))
            : n.pressure[d];
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k) {
      const auto i = static_cast<std::size_t>(n.corner_disc[k]);
      fx[i] += p * n.corner_weight[2 * k];
      fy[i] += p * n.corner_weight[2 * k + 1];
    }
  }
  KernelArrays a = m.solver->arrays();
  a.stiffness = n.stiffness.data();
  a.undrained = 1;
  cycle(kernels(), a);
  double largest = 0.0;
  for (const double f : fx) largest = std::max(largest, std::abs(f));
  for (std::size_t i = 0; i < discs; ++i) {
    const auto disc = static_cast<std::int64_t>(i);
    EXPECT_NEAR(m.assembly.vx[i] / (a.step * a.inverse_mass[disc]), fx[i], 1e-12 * largest) << i;
    EXPECT_NEAR(m.assembly.vy[i] / (a.step * a.inverse_mass[disc]), fy[i], 1e-12 * largest) << i;
    EXPECT_NEAR(m.assembly.spin[i] / (a.step * a.inverse_inertia[disc]), moment[i], 1e-12 * largest) << i;
  }
}

TEST(Kernels, InnerForcesAddUpToNothing) {
  for (const auto mode : {ContactMode::parallel, ContactMode::after_break}) {
    const Options o = kernel_options(mode);
    TestModel m(o, packed(o));
    stir(m);
    double fx = 0.0, fy = 0.0, torque = 0.0, size = 0.0;
    std::vector<Vec2> on_disc(static_cast<std::size_t>(m.assembly.disc_count()));
    const auto forces = forces_of(m);
    for (std::size_t e = 0; e < forces.size(); ++e) {
      const BondForce& f = forces[e];
      const auto i = static_cast<std::size_t>(m.assembly.first[e]),
                 j = static_cast<std::size_t>(m.assembly.second[e]);
      on_disc[i] = on_disc[i] + Vec2{f.fx, f.fy};
      on_disc[j] = on_disc[j] - Vec2{f.fx, f.fy};
      torque += f.moment_i + f.moment_j;
      size += 2.0 * (std::abs(f.fx) + std::abs(f.fy));
    }
    for (std::size_t i = 0; i < on_disc.size(); ++i) {
      fx += on_disc[i].x;
      fy += on_disc[i].y;
      torque += cross(m.assembly.position(static_cast<std::int64_t>(i)), on_disc[i]);
    }
    EXPECT_LT(std::abs(fx), 1e-13 * size);
    EXPECT_LT(std::abs(fy), 1e-13 * size);
    EXPECT_LT(std::abs(torque), 1e-12 * size * o.model_width);
  }
}

TEST(Kernels, TurningTheBodyStrainsNothing) {
  const Options o = kernel_options(ContactMode::after_break);
  TestModel m(o, packed(o));
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
    worst_normal = std::max(worst_normal, std::abs(bond.gap) / m.assembly.length(e));
    worst_shear = std::max(worst_shear, std::abs(bond.shear) / m.assembly.length(e));
    EXPECT_EQ(bond.bond_moment, 0.0);
  }
  RecordProperty("worst_shear_strain", std::to_string(worst_shear));
  EXPECT_LT(worst_normal, 1e-13);
  // The arcsine is a series to the seventh power: 105 / 3456 angle^9 is left, 6e-7, a ten-thousandth of
  // strength.
  EXPECT_LT(worst_shear, 105.0 / 3456.0 * std::pow(std::sin(angle), 9) * 1.1);
}

}  // namespace kernels_test
