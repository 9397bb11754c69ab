// SPDX-License-Identifier: BSD-3-Clause
#include "lab/laboratory.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "flow/aperture.hpp"
#include "lab/crack_tests.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"

namespace hfrac {
namespace {

constexpr double small_strain = 1e-5;
constexpr double bearing_half_angle = 15.0 * std::numbers::pi / 180.0;  // Brazilian: half of each arc
// Elastic energy of a specimen near its strength is enough to break every bond. When this share has broken at one load
// the test is over: what would follow is dust.
constexpr std::int64_t collapse = 50;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void check(const LabSpec& spec) {
  const auto refuse = [](const std::string& text) { throw Error(ErrorKind::argument, text); };
  const auto test = static_cast<std::int32_t>(spec.test);
  if (test < 0 || test >= lab_test_count) {
    refuse("test = " + number_text(static_cast<std::int64_t>(test)) + " is no test; give 0 to " +
           number_text(static_cast<std::int64_t>(lab_test_count - 1)) + ".");
  }
  if (spec.discs < 100 || spec.discs > 2000000)
    refuse("disc_count = " + number_text(spec.discs) + " is out of range; give 100 to 2000000.");
  if (spec.seed < 0) refuse("seed = " + number_text(spec.seed) + " is negative; give 0 or more.");
  if (!(spec.width > 0.0) || !(spec.width <= 1e6))
    refuse("width = " + number_text(spec.width) + " m is out of range; give a positive width up to 1e6 m.");
  if (!(spec.confining >= 0.0) || !(spec.confining <= 1e12)) {
    refuse("confining = " + number_text(spec.confining) +
           " Pa is out of range; give 0 to 1e12 Pa, compression positive.");
  }
  if (!(spec.slit_fraction >= 0.05) || !(spec.slit_fraction <= 0.6))
    refuse("slit_fraction = " + number_text(spec.slit_fraction) + " is out of range; give 0.05 to 0.6.");
}

// E', nu' from a uniaxial stress and its strains, and what they are in plane strain: nu = nu' / (1 + nu'),
// E = E' (1 - nu^2) (Timoshenko and Goodier, Theory of Elasticity).
void put_elastic(LabReport& r, double stress, Strain strain) {
  r.plane_modulus = stress / strain.axial;
  r.plane_poisson = -strain.lateral / strain.axial;
  r.poisson = r.plane_poisson / (1.0 + r.plane_poisson);
  r.modulus = r.plane_modulus * (1.0 - r.poisson * r.poisson);
}

void describe(LabReport& r, const Specimen& s) {
  r.discs = s.assembly().disc_count();
  r.bonds = s.assembly().bond_count();
  r.coordination = s.coordination();
  r.mean_radius = s.assembly().mean_radius;
  r.tensile_cracks = s.cracks_in(CrackMode::tension);
  r.shear_cracks = s.cracks_in(CrackMode::shear);
  r.factors = s.factors();
  r.relaxations = s.relaxations();
}

LabResult test_elastic(const Options& material, const Packing& packing, double width) {
  LabResult result;
  auto s = std::make_unique<Specimen>(packing, material, SpecimenShape{.width = width, .height = width});
  s->grip_ends();
  s->make_unbreakable();
  s->lead_ends(-small_strain * width);
  const auto outcome = s->solve(1e300);
  put_elastic(result.report, s->pull() / width, s->strain());
  result.report.value = result.report.modulus;
  result.report.force_ratio = outcome.force_ratio;
  result.report.end =
      outcome.end == EquilibriumSolver::End::rest ? TestEnd::load_reached : TestEnd::no_equilibrium;
  result.specimen = std::move(s);
  return result;
}

// `way`: 1 apart, -1 together.
LabResult test_strength(const Options& material, const Packing& packing, double width, double confining,
                        double way, double end_share, const std::function<bool()>& interrupt) {
  LabResult result;
  const double height = specimen_aspect(LabTest::uniaxial) * width;
  auto s = std::make_unique<Specimen>(packing, material,
                                      SpecimenShape{.width = width, .height = height, .stress_x = confining});
  s->grip_ends();
  double start = 0.0;  // shortening at which the axial stress is the confining one
  if (confining > 0.0) {
    constexpr int stages = 10;
    // At least the rock's own stiffness [Pa], so that each round leaves a part of what is missing and none overshoots.
    const bool parallel = ContactMode{material.contact_mode} == ContactMode::parallel;
    const double stiffness =
        material.bond_normal_stiffness + (parallel ? material.contact_normal_stiffness : 0.0);
    for (int stage = 1; stage <= stages; ++stage) {
      s->load_sides(static_cast<double>(stage) / stages);
      for (int round = 0; round < 3; ++round) {
        s->lead_ends(-start * height);
        s->solve(1e300, interrupt);
        const double missing = confining * stage / stages + s->pull() / width;
        start += missing / stiffness;
      }
    }
    s->lead_ends(-start * height);
    s->solve(1e300, interrupt);
  }
  Loading loading;
  loading.apply = [&](double strain) { s->lead_ends((way * strain - start) * height); };
  loading.stress = [&] { return way * s->pull() / width; };
  loading.runaway = s->assembly().bond_count() / collapse;
  loading.end_share = end_share;
  take_loading(result, load_to_failure(*s, loading, interrupt));
  const auto& first = result.curve.empty() ? CurvePoint{} : result.curve.front();
  if (confining == 0.0 && !result.curve.empty())
    put_elastic(result.report, way * first.stress, {first.axial, first.lateral});
  result.report.value = result.report.peak_stress;
  result.specimen = std::move(s);
  return result;
}

// Stress at the centre of a disc under a uniform pressure on two arcs of 2 alpha each (Hondros 1959):
// sigma = 2 P / (pi D) (sin 2 alpha / alpha - 1), for P = p D sin alpha taken as p D alpha.
LabResult test_brazilian(const Options& material, const Packing& packing, double width, double end_share,
                         const std::function<bool()>& interrupt) {
  LabResult result;
  auto s = std::make_unique<Specimen>(packing, material,
                                      SpecimenShape{.width = width, .height = width, .round = true});
  s->grip_ends(bearing_half_angle);
  const double hondros =
      2.0 / (std::numbers::pi * width) * (std::sin(2.0 * bearing_half_angle) / bearing_half_angle - 1.0);
  Loading loading;
  loading.apply = [&](double strain) { s->lead_ends(-strain * width); };
  loading.stress = [&] { return -s->pull() * hondros; };
  loading.runaway = s->assembly().bond_count() / collapse;
  loading.end_share = end_share;
  take_loading(result, load_to_failure(*s, loading, interrupt));
  result.report.value = result.report.peak_stress;
  result.report.geometry_factor = hondros * width;
  result.specimen = std::move(s);
  return result;
}

// Along x, and along y by turning the packing. The aperture that gives the permeability asked for along x serves both.
LabResult test_permeability(Options material, const Packing& packing, double width) {
  LabResult result;
  LabReport& r = result.report;
  material.flow_outer = static_cast<std::int64_t>(OuterPores::closed);
  for (const bool turned : {false, true}) {
    Packing discs = packing;
    if (turned) discs.x.swap(discs.y);
    Specimen s(discs, material, SpecimenShape{.width = width, .height = width, .wet = true});
    Network& n = s.network();
    std::vector<double> pressure;
    calibrate_aperture(n, s.assembly(), s.options(), {}, pressure);
    const double k = measure_permeability(n, s.assembly(), {}, material.fluid_viscosity, pressure);
    (turned ? r.permeability_y : r.permeability_x) = k;
    r.zero_stress_aperture = material.flow_zero_stress_aperture = n.zero_stress_aperture;
    describe(r, s);
  }
  r.value = 0.5 * (r.permeability_x + r.permeability_y);
  r.end = TestEnd::load_reached;
  return result;
}

}  // namespace

void take_loading(LabResult& result, LoadingResult&& loaded) {
  LabReport& r = result.report;
  r.peak_stress = loaded.peak;
  r.strain_at_peak = loaded.strain_at_peak;
  r.first_crack_stress = loaded.first_crack;
  r.force_ratio = loaded.force_ratio;
  r.worst_overshoot = loaded.worst_overshoot;
  r.end = loaded.end;
  result.curve = std::move(loaded.curve);
}

double specimen_aspect(LabTest test) {
  switch (test) {
    case LabTest::tension:
    case LabTest::uniaxial:
    case LabTest::biaxial:
    case LabTest::sent:
      return 2.0;
    case LabTest::centre_crack:
      return 1.5;
    default:
      return 1.0;
  }
}

Packing pack_specimen(const Options& material, LabTest test, double width, std::int64_t discs,
                      std::int64_t seed, const std::function<bool(double)>& progress) {
  PackingOptions p = packing_options(material);
  p.width = width;
  p.height = specimen_aspect(test) * width;
  p.count = discs;
  p.seed = static_cast<std::uint64_t>(seed);
  return pack_discs(p, progress);
}

LabResult run_lab(const Options& material, const LabSpec& spec, const Packing& packing,
                  const std::function<bool()>& interrupt) {
  check(spec);
  const auto start = std::chrono::steady_clock::now();
  LabResult result;
  switch (spec.test) {
    case LabTest::elastic:
      result = test_elastic(material, packing, spec.width);
      break;
    case LabTest::tension:
      result = test_strength(material, packing, spec.width, 0.0, 1.0, spec.end_share, interrupt);
      break;
    case LabTest::uniaxial:
      result = test_strength(material, packing, spec.width, 0.0, -1.0, spec.end_share, interrupt);
      break;
    case LabTest::biaxial:
      result = test_strength(material, packing, spec.width, spec.confining, -1.0, spec.end_share, interrupt);
      break;
    case LabTest::brazilian:
      result = test_brazilian(material, packing, spec.width, spec.end_share, interrupt);
      break;
    case LabTest::centre_crack:
    case LabTest::sent:
    case LabTest::pressurised_crack:
      result = test_crack(material, spec, packing, interrupt);
      break;
    case LabTest::permeability:
      result = test_permeability(material, packing, spec.width);
      break;
  }
  if (result.specimen) describe(result.report, *result.specimen);
  result.report.test_seconds = seconds_since(start);
  return result;
}

LabResult run_lab(const Options& material, const LabSpec& spec, const std::function<bool()>& interrupt) {
  check(spec);
  const auto start = std::chrono::steady_clock::now();
  const Packing packing = pack_specimen(material, spec.test, spec.width, spec.discs, spec.seed,
                                        [&](double /*share*/) { return interrupt && interrupt(); });
  const double seconds = seconds_since(start);
  if (interrupt && interrupt()) {
    LabResult result;
    result.report.end = TestEnd::stopped;
    return result;
  }
  LabResult result = run_lab(material, spec, packing, interrupt);
  result.report.packing_seconds = seconds;
  return result;
}

}  // namespace hfrac
