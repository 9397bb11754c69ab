// SPDX-License-Identifier: BSD-3-Clause
// V36  A slit in poroelastic rock that fluid holds open: rock around it drains, which lets it open farther, and takes up what leaks, which
//      presses on it.
//
// Formula    Plane-strain poroelasticity (Biot 1941), by finite elements on the same square: a quarter of it, symmetric along both axes but for
//            the slit, whose face bears the fluid's pressure and has it in its pores. At once rock answers undrained, w = 4 dp l / E'_u
//            sqrt(1 - (x / l)^2) in rock without end; fully drained by E' in its place, less what the leaked fluid presses with.
// Source     Detournay and Cheng (1991), Plane strain analysis of a stationary hydraulic fracture in a poroelastic medium. Int. J. Solids Struct. 27, 1645.
// Set-up     Random packings of the linear set in 100 m x 100 m under 10 MPa all round, 9.9 or 8 MPa in the pores; two slots of
//            14 m from a hole of 1.65 m in the middle, unbreakable, 11 MPa from the beginning. Net pressure 1 MPa, excess over the rock's pores 1.1
//            or 3 MPa. Nothing is fitted: E and nu of the drained packing (as in V2), k of the network, storage phi / K_f, alpha = 1. The continuum's slit
//            has no hole and is as long as facets reach, half a radius beyond the last. Volumes beyond the hole at two excesses give the part
//            by net pressure and the part by what leaks; T = c t / l^2.
// Tolerance  At once 15 % (a slit's length is known to half a facet), with 16 000 discs 5 %; drained over at once 2 %. What leaks presses too little
//            at the size of a disc, since a fracture's own pores do not swell: 25 % of it at most in the end, with 16 000 discs 17 %.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "rectangle_mesh.hpp"
#include "rock/biot_solver.hpp"
#include "support.hpp"

namespace V36_poroelastic_slit {

using namespace hfrac;
using verification::report;

constexpr double side = 100.0, stress = 10e6, fluid = 11e6, hole = 1.65, slot = 14.35;  // m, Pa, Pa, m, m

hfrac::Definition slit_of_discs(int64_t discs, int64_t seed, double formation) {
  hfrac::Definition def = verification::new_def();
  def.model_seed = seed;
  def.packing_disc_count = discs;
  def.contact_mode = 1;
  def.contact_normal_stiffness = def.bond_normal_stiffness = 16e9;
  def.contact_shear_stiffness = def.bond_shear_stiffness = 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = stress;
  def.fluid_formation_pressure = formation;
  def.fluid_viscosity = 1e-3;
  def.fluid_bulk_modulus = 2.2e9;
  def.flow_permeability = 8e-15;
  def.flow_half_aperture_force = 1e15;
  def.flow_aperture_limit = 0.1;
  def.solver_kind = 1;
  def.stepping_mode = 2;
  def.fracture_law = 1;
  def.fracture_perforation_length = slot;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 0.5 * side;
  def.wells[0].radius = hole;
  def.wells[0].pressure = fluid;
  return def;
}

// n + 1 places from `from` to `to`, the finer the nearer to `from`.
std::vector<double> graded(double from, double to, int n, double exponent) {
  std::vector<double> place;
  for (int k = 0; k <= n; ++k)
    place.push_back(from + (to - from) * std::pow(static_cast<double>(k) / n, exponent));
  return place;
}

class Continuum {
 public:
  Continuum(const BiotMaterial& material, double half, double width) {
    auto x = graded(half, 0.0, 12, 2.0);
    std::reverse(x.begin(), x.end());
    *std::lower_bound(x.begin() + 1, x.end(), hole) = hole;
    const auto beyond = graded(half, width, 14, 2.0);
    x.insert(x.end(), beyond.begin() + 1, beyond.end());
    RockMesh mesh = verification::rectangle_mesh(x, graded(0.0, width, 22, 2.5));
    for (auto& edge : mesh.edge)
      if (edge.side == RockSide::bottom && mesh.node[static_cast<std::size_t>(edge.middle)].x < half)
        edge.side = RockSide::well;
    rock_ =
        std::make_unique<BiotSolver>(mesh, material,
                                     std::vector<BiotSolver::Side>{{RockSide::left, SideMotion::held},
                                                                   {RockSide::bottom, SideMotion::held},
                                                                   {RockSide::well, SideMotion::free, true},
                                                                   {RockSide::right, SideMotion::free, true},
                                                                   {RockSide::top, SideMotion::free, true}});
  }
  void load(double net, double excess) {
    rock_->set_stress(RockSide::well, {0.0, net, 0.0});
    rock_->set_pressure(RockSide::well, excess);
  }
  void load_at_once() { rock_->load_undrained(); }
  void load_drained() { rock_->load_steady(); }
  void go(double until) {
    while (time_ < until * (1.0 - 1e-12)) {
      const double step = std::min(std::max(1e-6 * until, 0.2 * time_), until - time_);
      rock_->advance(step);
      time_ += step;
    }
  }
  // Between the faces of both wings, from a distance to the middle on [m2].
  [[nodiscard]] double volume(double from = hole) const {
    double sum = 0.0;
    for (const auto& edge : rock_->mesh().edge) {
      if (edge.side != RockSide::well) continue;
      const auto y = [&](std::int32_t node) { return rock_->displacement(node).y; };
      const auto x = [&](std::int32_t node) { return rock_->mesh().node[static_cast<std::size_t>(node)].x; };
      if (x(edge.middle) < from) continue;
      sum += std::abs(x(edge.to) - x(edge.from)) / 6.0 * (y(edge.from) + 4.0 * y(edge.middle) + y(edge.to));
    }
    return 4.0 * sum;
  }

 private:
  double time_ = 0.0;
  std::unique_ptr<BiotSolver> rock_;
};

// Of the slit [m2]: by its net pressure alone, and by what leaks under an excess as large as that.
struct Volumes {
  double by_net, by_excess;
};
struct Tolerances {
  double at_once, leaked;
};
constexpr std::array<double, 2> formations = {9.9e6, 8e6};                   // Pa
constexpr std::array<double, 6> times = {1e-3, 1e-2, 0.03, 0.1, 1.0, 10.0};  // over l^2 / c
Volumes split(double little, double much) {
  const auto excess = [](double formation) { return (fluid - formation) / (fluid - stress); };
  const double by_excess = (much - little) / (excess(formations[1]) - excess(formations[0]));
  return {little - excess(formations[0]) * by_excess, by_excess};
}

double reach_of(verification::Simulation& rock) {
  double reach[2] = {0.0, 0.0}, radius = 0.0;
  for (const auto& crack : rock.cracks()) {
    const double x = crack.position[0] - 0.5 * side, along = 0.5 * crack.length * std::abs(crack.normal[1]);
    reach[x > 0.0] = std::max(reach[x > 0.0], std::abs(x) + along);
  }
  const auto radii = rock.values(HFRAC_DISC_RADIUS);
  for (const double r : radii) radius += r / static_cast<double>(radii.size());
  return 0.5 * (reach[0] + reach[1]) + 0.5 * radius;
}

void compare(int64_t discs, int64_t seed, const Tolerances& tolerance) {
  BiotMaterial m;
  {
    hfrac::Definition drained = slit_of_discs(discs, seed, 0.0);
    hfrac_sim_def_set_i64(&drained, "well_count", 0);
    drained.fracture_law = 0;
    drained.fracture_perforation_length = 0.0;
    const auto measured = verification::elasticity(drained, 5e6);
    m.poissons_ratio = measured.plane_strain_poisson();
    m.youngs_modulus = measured.plane_strain_modulus();
  }
  std::unique_ptr<verification::Simulation> rock[2];
  std::unique_ptr<Continuum> continuum[2];
  double reach = 0.0;
  for (const std::size_t k : {0U, 1U}) {
    const hfrac::Definition def = slit_of_discs(discs, seed, formations[k]);
    rock[k] = std::make_unique<verification::Simulation>(def);
    reach = reach_of(*rock[k]);
    const auto volume = rock[k]->values(HFRAC_DOMAIN_VOLUME);
    const auto kind = rock[k]->indices(HFRAC_DOMAIN_KIND);
    double pores = 0.0;
    for (std::size_t d = 0; d < volume.size(); ++d) pores += kind[d] == 0 ? volume[d] : 0.0;
    m.biot = 1.0;
    m.storage = pores / (side * side) / def.fluid_bulk_modulus;
    m.mobility = rock[k]->setup().permeability / def.fluid_viscosity;
    continuum[k] = std::make_unique<Continuum>(m, reach, 0.5 * side);
    continuum[k]->load(fluid - stress, fluid - formations[k]);
    continuum[k]->load_at_once();
  }
  // Nothing has leaked at once, so the excess is none of it.
  const double at_once = continuum[0]->volume(), scale = reach * reach / m.consolidation();
  std::printf("  %lld discs, packing %lld: E %.2f GPa, nu %.3f, nu_u %.3f, c %.3e m2/s, l %.2f m\n",
              static_cast<long long>(discs), static_cast<long long>(seed), 1e-9 * m.youngs_modulus,
              m.poissons_ratio, m.undrained_poissons_ratio(), m.consolidation(), reach);
  const std::string name = std::to_string(discs) + " discs of packing " + std::to_string(seed) + ": ";
  double time = 0.0, first = 0.0;
  for (const double until : times) {
    const double begin = time;
    for (int part = 1; part <= 5; ++part) {
      const double end =
          begin > 0.0 ? begin * std::pow(until * scale / begin, 0.2 * part) : 0.2 * part * until * scale;
      for (const auto& one : rock) one->step_for(end - time);
      time = end;
    }
    for (const auto& one : continuum) one->go(time);
    double volume[2];
    for (const std::size_t k : {0U, 1U}) {
      volume[k] = 0.0;
      for (const auto& f : rock[k]->fractures()) volume[k] += f.volume;
    }
    const Volumes of_discs = split(volume[0], volume[1]),
                  wanted = split(continuum[0]->volume(), continuum[1]->volume());
    // A first step takes some time: the volume after it is taken back to that at once by the continuum's ratio.
    if (first == 0.0) {
      first = of_discs.by_net / wanted.by_net * at_once;
      report(name + "volume at once, m2", first, at_once, tolerance.at_once);
    }
    std::printf(
        "  T = %-5g  over the first by net pressure %.4f, continuum %.4f; by what leaks, per pressure %.4f, "
        "%.4f\n",
        until, of_discs.by_net / first, wanted.by_net / at_once, of_discs.by_excess / first,
        wanted.by_excess / at_once);
    verification::Curves curves(
        "V36-slit",
        "A slit that fluid holds open: volume by net pressure and less by what leaks, over the first",
        "T,by net pressure,by what leaks");
    curves.point(name + "discs", {until, of_discs.by_net / first, of_discs.by_excess / first});
    curves.point(name + "continuum", {until, wanted.by_net / at_once, wanted.by_excess / at_once});
    if (until < times.back()) continue;
    report(name + "drained over at once", of_discs.by_net / first, wanted.by_net / at_once, 0.02);
    report(name + "pressed on by what leaked, over at once", of_discs.by_excess / first,
           wanted.by_excess / at_once, tolerance.leaked);
  }
}

// In a plate of 25 half lengths: 2 pi l^2 dp / E', undrained and drained (Sneddon 1946).
TEST(V36PoroelasticSlitSmoke, ContinuumOpensAsInRockWithoutEnd) {
  constexpr double half = 16.0, net = 1e6;  // m, Pa
  BiotMaterial m;
  Continuum continuum(m, half, 25.0 * half);
  continuum.load(net, 0.0);
  const auto wanted = [&](double poisson) {
    return 2.0 * verification::pi * half * half * net * (1.0 - poisson) / (2.0 * m.shear_modulus());
  };
  continuum.load_at_once();
  report("continuum, volume at once, m2", continuum.volume(0.0), wanted(m.undrained_poissons_ratio()), 0.02);
  continuum.load_drained();
  report("continuum, volume drained, m2", continuum.volume(0.0), wanted(m.poissons_ratio), 0.02);
}

TEST(V36PoroelasticSlit, OpensDrainsAndIsPressedOn) {
  for (const int64_t seed : {1, 2, 3}) compare(4000, seed, {0.15, 0.25});
}

TEST(V36PoroelasticSlitLong, IsPressedOnMoreOnFinerDiscs) {
  for (const int64_t seed : {1, 2}) compare(16000, seed, {0.05, 0.17});
}

}  // namespace V36_poroelastic_slit
