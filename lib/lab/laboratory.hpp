// SPDX-License-Identifier: BSD-3-Clause
// The rock laboratory: standard tests on specimens of the rock that a case describes, each a function of discs and seed.
//
//   elastic            square between platens, 1e-5 shorter: E and nu. Without contacts beside the bonds (contact.mode
//                      after-break) this is one linear solve; with them, a few, since contacts open and slide.
//   tension            twice as high as wide, platens drawn apart: direct tensile strength
//   uniaxial           likewise pressed together: compressive strength (UCS)
//   biaxial            likewise, confining stress on the sides first
//   brazilian          round disc pressed between two arcs of 30 degrees: indirect tensile strength (Hondros 1959); bonds within
//                      0.15 diameters of either end do not break, since a rock whose UCS is 4 times its tensile strength
//                      would be crushed at the arcs, which bear 5 to 12 times the stress at the centre
//   centre_crack       plate 1.5 times as high as wide under constant load, slit in the middle: K_Ic
//   sent               plate twice as high as wide under constant load, slit from one side: K_Ic
//   pressurised_crack  square, slit in the middle under fluid pressure that follows as it grows: K_Ic and opening
//   permeability       of the unloaded network, along x and along y
//
// Strengths between platens are led by displacement, so that what follows the peak is seen; those of plates with slits by dead
// load, whose largest value is where the slit runs. All are quasi-static: nothing of these strengths hangs on a rate, a mass or
// a damping. The stress-strain curve has a point at every break.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geom/packing.hpp"
#include "lab/loading.hpp"
#include "lab/specimen.hpp"
#include "options/options.hpp"

namespace hfrac {

enum class LabTest : std::int32_t {
  elastic = 0,
  tension = 1,
  uniaxial = 2,
  biaxial = 3,
  brazilian = 4,
  centre_crack = 5,
  sent = 6,
  pressurised_crack = 7,
  permeability = 8
};
constexpr std::int32_t lab_test_count = 9;

struct LabSpec {
  LabTest test = LabTest::elastic;
  std::int64_t discs = 2000;
  std::int64_t seed = 1;
  double width = 10.0;         // m
  double confining = 0.0;      // Pa, biaxial
  double slit_fraction = 0.3;  // of the width: the whole slit of a centre crack, the depth of a notch
  double end_share = 0.5;      // tests between platens end when stress has fallen to this share of its peak
};

struct LabReport {
  double value = 0.0;                               // what the test is for: Pa, Pa m^0.5 or m2
  double modulus = 0.0, poisson = 0.0;              // Pa, 1: plane strain, E and nu
  double plane_modulus = 0.0, plane_poisson = 0.0;  // Pa, 1: slopes of the two-dimensional model, E' and nu'
  double peak_stress = 0.0, strain_at_peak = 0.0, first_crack_stress = 0.0;  // Pa, 1, Pa
  double slit_half_length = 0.0, geometry_factor = 0.0;  // m, 1: K = factor stress sqrt(pi a)
  double toughness_coefficient = 0.0;                    // K_Ic over sigma_c sqrt(mean radius)
  double permeability_x = 0.0, permeability_y = 0.0, zero_stress_aperture = 0.0;  // m2, m2, m
  double mean_radius = 0.0, coordination = 0.0;                                   // m, 1
  double force_ratio = 0.0, worst_overshoot = 0.0;
  double packing_seconds = 0.0, test_seconds = 0.0;
  std::int64_t discs = 0, bonds = 0, tensile_cracks = 0, shear_cracks = 0, factors = 0;
  std::int64_t relaxations = 0;  // equilibria that took the explicit solver
  TestEnd end = TestEnd::failed;
};

struct LabResult {
  LabReport report;
  std::vector<CurvePoint> curve;
  std::vector<Vec2> opening;           // pressurised_crack: opening() at 1 % of the pressure at failure
  double opening_pressure = 0.0;       // Pa, it holds for
  std::unique_ptr<Specimen> specimen;  // as the test left it; none for permeability
};

// What a loading came to, into a test's report and curve.
void take_loading(LabResult& result, LoadingResult&& loaded);

// Height over width of a test's specimen.
double specimen_aspect(LabTest test);
// Discs for a specimen. The same seed, number and shape give the same packing whatever the micro-parameters.
Packing pack_specimen(const Options& material, LabTest test, double width, std::int64_t discs,
                      std::int64_t seed, const std::function<bool(double)>& progress = {});

// Throws Error(argument) if the spec is out of range, Error(model) if no specimen comes of it, Stopped-like ends are in
// report.end.
LabResult run_lab(const Options& material, const LabSpec& spec, const std::function<bool()>& interrupt = {});
// The same on discs already packed by pack_specimen.
LabResult run_lab(const Options& material, const LabSpec& spec, const Packing& packing,
                  const std::function<bool()>& interrupt = {});

}  // namespace hfrac
