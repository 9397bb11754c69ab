// SPDX-License-Identifier: BSD-3-Clause
// Facets in explicit motion: the same equations as in the quasi-static solver, the same bits for any number of workers and after an image, and
// no fluid lost.
#include "solid/facet_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "equilibrium/coupled_system.hpp"
#include "small_case.hpp"
#include "step/simulation.hpp"

namespace facet_motion_test {

using namespace testing_unit;

// A hole with slots in rock that bears 20 MPa.
CaseDefinition slotted(std::int64_t seed = 1) {
  CaseDefinition definition = quiet_case();
  Options& o = definition.options;
  o.model_seed = seed;
  o.packing_disc_count = 600;
  o.contact_mode = choice(ContactMode::after_break);
  o.contact_normal_stiffness = o.bond_normal_stiffness = 16e9;
  o.contact_shear_stiffness = o.bond_shear_stiffness = 5.6e9;
  o.stress_sigma_Hmax = 22e6;
  o.stress_sigma_hmin = 20e6;
  o.fluid_formation_pressure = 5e6;
  o.fracture_law = choice(FractureLaw::facet);
  o.fracture_perforation_length = 10.0;
  o.stepping_force_ratio = 1e-5;
  o.stepping_max_cycles = 20000;
  o.stepping_flow_step = 0.5;
  definition.wells[0].radius = 6.0;
  definition.wells[0].pressure = 24e6;
  return definition;
}

// Rock that breaks at its slots' tips, and fluid at a rate.
CaseDefinition growing(std::int64_t seed = 1) {
  CaseDefinition definition = slotted(seed);
  Options& o = definition.options;
  o.fracture_perforation_length = 4.0;
  o.fracture_plane_modulus = 18.6e9;
  o.bond_fracture_toughness = 3e6;
  o.bond_tensile_strength = 20e6;
  o.bond_shear_strength = 60e6;
  o.fluid_viscosity = 0.01;
  o.stepping_force_ratio = 1e-4;
  o.stepping_flow_step = 0.5;
  o.stop_extent_fraction = 1.0;
  o.fluid_formation_pressure = 19.5e6;  // the hole is large: filling it takes long otherwise
  definition.wells[0].control = WellControl::rate;
  definition.wells[0].rate = 2e-2;
  return definition;
}

// Where damped motion comes to rest, the quasi-static solver's equations are fulfilled: forces of facets open and shut, what pores
// hold, what they push.
TEST(FacetMotion, RestsWhereTheQuasiStaticEquationsDo) {
  struct Case {
    bool joint;
    double more;  // fluid in each pore of the slots, over the mean radius [m]
  };
  for (const auto& [joint, more] : {Case{false, 2e-3}, Case{false, 6e-3}, Case{true, 6e-3}}) {
    CaseDefinition definition = slotted();
    if (joint) {
      JointOptions along;
      along.x1 = 56.0;
      along.y1 = 20.0;
      along.x2 = 64.0;
      along.y2 = 80.0;
      along.state = choice(JointState::smooth_broken);
      along.aperture = 1e-3;
      along.friction = 5.0;
      definition.joints.push_back(along);
    }
    Simulation s(definition, {}, {});
    Engine& e = const_cast<Engine&>(s.engine());
    Network& n = e.model.network;
    for (std::int64_t d = 0; d < n.domain_count(); ++d)
      if (e.facets.fractured(d)) n.content[d] += more * s.assembly().mean_radius;
    const auto motion = e.mechanics->relax(s.options().stepping_force_ratio, 20000, e.model.cracks);
    e.mechanics->evaluate();
    int open = 0, shut = 0;
    for (const Facet& f : e.facets.all())
      ++(e.facets.opening(s.assembly(), s.network(), f) > 0.0 ? open : shut);
    if (joint) {
      EXPECT_GT(std::min(open, shut), 0);
    } else {
      EXPECT_GT(more > 4e-3 ? open : shut, 4);
    }
    CoupledSystem system(e.model.assembly, e.model.network, *e.boundary, e.mechanics->non_bonded_contacts(),
                         s.options(), *e.workers, e.facets);
    system.begin(0.0, {});
    system.evaluate();
    // Two discs bear what turns the whole, there by pins.
    const Assembly& a = s.assembly();
    std::vector<double> off;
    for (std::int64_t i = 0; i < a.disc_count(); ++i)
      off.push_back(system.residual().segment<3>(3 * i).lpNorm<1>());
    std::sort(off.begin(), off.end());
    off.resize(off.size() - 2);
    double mean = 0.0;
    for (const double one : off) mean += one / static_cast<double>(off.size());
    // Over the force of 20 MPa on a disc.
    mean /= 20e6 * 2.0 * a.mean_radius / s.options().contact_normal_stiffness;
    std::printf(
        " %s joint: %d open, %d shut; off by %.1e of a contact's force (motion: %.1e), pressures by %.1e\n",
        joint ? "with" : "without", open, shut, mean, motion.force_ratio, system.pressure_error());
    EXPECT_TRUE(motion.at_rest);
    EXPECT_LT(mean, 3e-5);
    EXPECT_LT(system.pressure_error(), 1e-6);
  }
}

// Growth from slots: fluid is accounted for to rounding, an image goes on with the same bits, and so does any number of workers.
void grows(const CaseDefinition& definition, int steps, std::size_t cracks) {
  const auto slots = Simulation(definition, {}, {}).cracks().size();
  const auto run = [&](int workers, Simulation*& kept) {
    CaseDefinition mine = definition;
    mine.options.run_workers = workers;
    auto* s = new Simulation(mine, {}, {});
    kept = s;
    for (int k = 0; k < steps; ++k) s->step();
    return s->state_hash();
  };
  std::vector<std::uint64_t> hashes;
  for (int workers = 1; workers <= 3; ++workers) {
    Simulation* s = nullptr;
    hashes.push_back(run(workers, s));
    const std::unique_ptr<Simulation> owner(s);
    if (workers > 1) continue;
    const Balance balance = s->balance();
    std::printf(" %zu cracks, %zu of them slots; %zu facets, %.2e m2 in, off by %.1e of it\n",
                s->cracks().size(), slots, s->engine().facets.all().size(), balance.injected,
                balance.fluid_error / balance.injected);
    EXPECT_GE(s->cracks().size(), slots + cracks);
    EXPECT_LT(std::abs(balance.fluid_error), 1e-12 * balance.injected);
    const double worked = std::abs(balance.fluid_work) + std::abs(balance.boundary_work);
    std::printf(
        " works of fluid %.3e and far field %.3e J/m, friction %.2e, damping %.2e, fracture %.2e, off by "
        "%.1e of works\n",
        balance.fluid_work, balance.boundary_work, balance.friction, balance.damping, balance.fracture,
        balance.energy_error / worked);
    EXPECT_TRUE(balance.energy_checked);
    EXPECT_LT(std::abs(balance.energy_error), 1e-3 * worked);
    std::vector<std::byte> image(s->image_size());
    s->write_image(image);
    const auto go_on = [](Simulation& of) {
      for (int k = 0; k < 4; ++k) of.step();
      return of.state_hash();
    };
    const auto hash = go_on(*s);
    s->restore(image);
    EXPECT_EQ(go_on(*s), hash);
    Simulation other(definition, {}, {});
    other.restore(image);
    EXPECT_EQ(go_on(other), hash);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(FacetMotion, GrowsByImplicitFlow) {
  grows(growing(), 40, 8);
}

TEST(FacetMotion, GrowsByExplicitFlow) {
  CaseDefinition definition = growing();
  definition.options.flow_scheme = choice(FlowScheme::explicit_scheme);
  definition.options.stepping_flow_step = 0.2;
  definition.wells[0].rate = 0.1;
  grows(definition, 20, 3);
}

TEST(FacetMotion, GrowsInRealTime) {
  CaseDefinition definition = growing();
  Options& o = definition.options;
  o.stepping_mode = choice(SteppingMode::dynamic);
  o.stepping_damping = 0.3;
  o.stepping_flow_step = 0.01;
  definition.wells[0].control = WellControl::pressure;
  definition.wells[0].pressure = 30e6;
  grows(definition, 40, 5);
}

}  // namespace facet_motion_test
