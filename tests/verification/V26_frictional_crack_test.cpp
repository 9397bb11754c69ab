// SPDX-License-Identifier: BSD-3-Clause
// V26  Inclined crack with friction under uniaxial compression: a natural fracture that slips as the far field is put on.
//
// Formula    Phan, Napier, Gray and Kaplan (2003), Int. J. Numer. Methods Eng. 57: a crack of half length b at an angle psi to the load
//            sigma bears sigma sin^2 psi across it, and with friction tan theta its faces slip by
//                slip = 4 / E' sigma sin psi (cos psi - sin psi tan theta) sqrt(b^2 - s^2),     E' = E / (1 - nu^2).
//            The plate's edges are taken off by a boundary-element solution of the same plate (cracked_plate.hpp): as much as friction
//            takes off the shear stress it takes off the slip, since slip of a straight crack leaves its normal stress what it is.
// Set-up     Random packings of 100 m in rock that does not break and lets nothing through, pores at 0 Pa, 100 MPa along x and nothing
//            along y; in the middle a natural fracture of b = 14 m that conducts, psi = 20 degrees, theta = 30 degrees, stiffness
//            2e12 Pa/m. What is measured is what it slips in the initial equilibration and a step without flow. E' is measured on each
//            packing without it. Slip is fitted by least squares to the ellipse.
// Tolerance  Largest slip for discs of no size, from two sizes of a ratio of two, means of the packings: 5 %. Normal stress on the crack: 5 %, 15 % in the
//            mean of three packings of 3 000 discs, of which each scatters by 15 %.
// Page       docs/verification/V26.md
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cracked_plate.hpp"
#include "joint_model.hpp"
#include "solid/smooth_joints.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V26_frictional_crack {

using namespace hfrac;
using namespace verification;

constexpr double side = 100.0, half = 14.0, load = 100e6, stiff = 2e12;  // m, m, Pa, Pa/m
constexpr double psi = 20.0 * verification::pi / 180.0, theta = 30.0 * verification::pi / 180.0;  // rad
constexpr double phan_modulus = 25e9 / (1.0 - 0.25 * 0.25),
                 phan_half = 1.0;  // Pa, m: the source's rock and crack

// Factor of sqrt(b^2 - s^2), by least squares.
double ellipse(const std::vector<double>& at, const std::vector<double>& slip) {
  double both = 0.0, square = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double e = std::sqrt(std::max(0.0, half * half - at[k] * at[k]));
    both += e * slip[k];
    square += e * e;
  }
  return both / square;
}

double shear_drop() {
  return load * std::sin(psi) * (std::cos(psi) - std::sin(psi) * std::tan(theta));
}

struct Measured {
  double slip, normal;  // over the formula's
};

Measured measure(std::int64_t discs, std::int64_t seed, bool drawn) {
  const double modulus = elasticity(dry_rock(discs, seed), 10e6).modulus;
  CaseDefinition definition = tight_rock(discs, seed, 0.0);
  definition.options.stress_sigma_Hmax = load;
  definition.options.stress_sigma_hmin = 0.0;
  const double x = half * std::cos(psi), y = half * std::sin(psi), middle = 0.5 * side;
  definition.joints = {
      plate_joint({middle - x, middle - y}, {middle + x, middle + y}, std::tan(theta), stiff, 1e-3)};
  hfrac::Simulation sim(definition, {}, {});
  sim.step();
  const Assembly& a = sim.assembly();
  std::vector<double> at, slip;
  double borne = 0.0, length = 0.0;
  for (const auto& c : a.smooth.contacts) {
    const auto i = a.first[c.bond];
    at.push_back((a.x[i] + c.first_arm().x - middle) * std::cos(psi) +
                 (a.y[i] + c.first_arm().y - middle) * std::sin(psi));
    slip.push_back(std::abs(a.slip[c.bond]));
    borne -= smooth_response(a, c).normal;
    length += c.area;
  }
  // Per modulus, of the shear stress that a load of one bears on the crack, and without edges.
  static const PlateSlip edges = plate_slip(side, half, psi, 0.0);
  const double by_edges = ellipse(edges.at, edges.slip) / (4.0 * std::sin(psi) * std::cos(psi));
  const double found = ellipse(at, slip) * modulus / (4.0 * shear_drop());
  const Measured result{found / by_edges, borne / length / (load * std::sin(psi) * std::sin(psi))};
  std::printf(
      "  %lld discs, packing %lld: b = %.1f R, slip %.3f of the formula, the plate's edges %.3f; rest %.3f; "
      "normal stress %.3f\n",
      static_cast<long long>(discs), static_cast<long long>(seed), half / a.mean_radius, found, by_edges,
      result.slip, result.normal);
  std::fflush(stdout);
  if (!drawn) return result;
  // In the source's rock and for its crack.
  Curves curves("V26", "Slip along an inclined crack with friction", "along the crack over b,slip (mm)");
  const double to_phan = modulus / phan_modulus * phan_half / half / by_edges;
  for (std::size_t k = 0; k < at.size(); ++k)
    curves.point(std::to_string(discs) + " discs", {at[k] / half, 1e3 * slip[k] * to_phan});
  static bool formula = false;
  if (!formula)
    curves.line("Phan et al. (2003)", -1.0, 1.0, [&](double s) {
      return std::vector<double>{1e3 * 4.0 * shear_drop() / phan_modulus * phan_half *
                                 std::sqrt(std::max(0.0, 1.0 - s * s))};
    });
  formula = true;
  return result;
}

// Mean of packings 1 to `packings`.
Measured mean_of(std::int64_t discs, int packings) {
  Measured mean{0.0, 0.0};
  for (int seed = 1; seed <= packings; ++seed) {
    const Measured one = measure(discs, seed, seed == 1);
    mean.slip += one.slip / packings;
    mean.normal += one.normal / packings;
  }
  std::printf("  %lld discs, mean of %d packings: slip %.3f, normal stress %.3f\n",
              static_cast<long long>(discs), packings, mean.slip, mean.normal);
  return mean;
}

void hold(std::int64_t discs, int packings) {
  const Measured coarse = mean_of(discs, packings), fine = mean_of(4 * discs, packings);
  const double most = 4.0 * shear_drop() / phan_modulus * phan_half,
               across = load * std::sin(psi) * std::sin(psi);
  report("largest slip for discs of no size [mm]", 1e3 * most * (2.0 * fine.slip - coarse.slip), 1e3 * most,
         0.05);
  report("normal stress on the crack [MPa]", 1e-6 * across * fine.normal, 1e-6 * across, 0.05);
}

TEST(V26FrictionalCrackSmoke, BearsItsNormalStress) {
  report("normal stress over sigma sin^2 psi, mean of three packings", mean_of(3000, 3).normal, 1.0, 0.15);
}

TEST(V26FrictionalCrack, SlipsAsTheFormulaSays) {
  hold(3000, 6);
}

TEST(V26FrictionalCrackLong, SlipsAsTheFormulaSaysWithFinerDiscs) {
  hold(10000, 6);
}

}  // namespace V26_frictional_crack
