// SPDX-License-Identifier: BSD-3-Clause
// V23  Slip along a joint that fluid drives, at constant friction.
//
// Formula    Bhattacharya and Viesca (2019), Science 364; Viesca (2021), J. Fluid Mech. 928. An overpressure dp held at x = 0 of a plane that
//            conducts in tight rock gives p = dp erfc(|x| / sqrt(4 alpha t)); with friction f, normal effective stress s and shear stress tau before
//            it, the plane slips to a = lambda sqrt(4 alpha t), where
//                T = (f s - tau) / (f dp) = (2 / pi) int_0^{pi/2} erfc(lambda sin th) dth,
//            by what the shear drop f p - T f dp opens in shear (Bilby and Eshelby 1968):
//                slip(x) = 4 / (pi E') int_-a^a drop(y) ln |(a^2 - x y + sqrt((a^2 - x^2)(a^2 - y^2))) / (a (x - y))| dy.
// Set-up     Random packings of 100 m in rock without end, under a mean stress of 40 MPa, pores at 20 MPa; a joint of 80 m at 45 degrees, friction 0.6,
//            residual aperture 1 mm and no other, so that it conducts and stores the same throughout; the fluid gives so much (1 MPa) that what the
//            joint's elastic opening stores is a hundredth; dp = 5 MPa held in one pore near its middle (no well: its hole would be as wide as the
//            slip is long at first); quasi-static solver. alpha = w^2 K_f / (12 eta). E' is measured on the packing without the joint.
//            The same in a plate of 100 m, whose edges make the slip longer and larger: over those of a plate of elements (slipping_plate.hpp), too.
// Measured   pressure: rms over 2 a. Slip: mean over |x| < a / 2. Length: root of the second moment of the slip. Over those of the formula.
// Tolerance  Pressure 3 % of dp. Slip and length 10 % where a is 20 m (40 R of 10 000 discs, 80 R of 40 000), or 16 R with T = 0.9; means of three
//            packings, nine for T = 0.1, where single ones scatter most. In a plate, 40 R, 15 %.
// Page       docs/verification/V23.md
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "joint_model.hpp"
#include "slipping_plate.hpp"
#include "solid/smooth_joints.hpp"
#include "step/simulation.hpp"
#include "support.hpp"

namespace V23_fault_injection {

using namespace hfrac;

constexpr double side = 100.0, half = 40.0, mean_stress = 40e6, pores = 20e6, over = 5e6;  // m, Pa
constexpr double friction = 0.6, aperture = 1e-3, viscosity = 1e-3, bulk = 1e6, stiff = 2e11;
constexpr double pi = verification::pi;

double excess_of(double lambda) {  // T
  constexpr int n = 2000;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) sum += std::erfc(lambda * std::sin((k + 0.5) / n * 0.5 * pi)) / n;
  return sum;
}

double lambda_of(double excess) {
  double low = 1e-6, high = 20.0;
  for (int k = 0; k < 100; ++k) (excess_of(0.5 * (low + high)) > excess ? low : high) = 0.5 * (low + high);
  return low;
}

// Of the formula, per f dp / E' [m].
double slip_at(double x, double a, double lambda, double excess) {
  constexpr int n = 2000;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) {
    const double turn = ((k + 0.5) / n - 0.5) * pi, y = a * std::sin(turn);
    const double drop = std::erfc(std::abs(y) / a * lambda) - excess;
    const double root = std::sqrt(std::max(0.0, (a * a - x * x) * (a * a - y * y)));
    sum += drop * std::log(std::abs((a * a - x * y + root) / (a * (x - y)))) * a * std::cos(turn) * pi / n;
  }
  return 4.0 / pi * sum;
}

CaseDefinition fault(std::int64_t discs, std::int64_t seed, double excess, BoundaryKind kind) {
  CaseDefinition definition = verification::tight_rock(discs, seed, pores);
  Options& o = definition.options;
  o.boundary_kind = static_cast<std::int64_t>(kind);
  const double shear = friction * (mean_stress - pores - excess * over);
  o.stress_sigma_Hmax = mean_stress + shear;
  o.stress_sigma_hmin = mean_stress - shear;
  o.fluid_viscosity = viscosity;
  o.fluid_bulk_modulus = bulk;
  const double low = 0.5 * side - half * std::sqrt(0.5), high = side - low;
  definition.joints = {verification::plate_joint({low, low}, {high, high}, friction, stiff, aperture)};
  return definition;
}

double plane_modulus(std::int64_t discs, std::int64_t seed) {
  return verification::elasticity(verification::dry_rock(discs, seed), 10e6).modulus;
}

// How far what the contacts bore when the far field was on, before each started from its stress, differs from piece to piece of the
// joint: standard deviation over the mean, of normal and shear stress.
void print_scatter(const Simulation& sim, double window) {
  const Assembly& a = sim.assembly();
  struct Piece {
    double area = 0.0, normal = 0.0, shear = 0.0;
  };
  std::map<std::int64_t, Piece> pieces;
  for (const auto& c : a.smooth.contacts) {
    const auto i = a.first[c.bond];
    const double x = std::sqrt(0.5) * (a.x[i] + c.first_arm().x + a.y[i] + c.first_arm().y);
    const SmoothResponse r = smooth_response(a, c);
    Piece& piece = pieces[static_cast<std::int64_t>(x / (window * a.mean_radius))];
    piece.area += c.area;
    const SettledContact locked = a.smooth.settled_of(c);
    piece.normal += r.normal + locked.locked_normal;
    piece.shear += r.shear + locked.locked_shear;
  }
  const auto deviation = [&](auto part) {
    double mean = 0.0, squares = 0.0, count = 0.0;
    for (const auto& [at, piece] : pieces) {
      if (piece.area < 0.75 * window * a.mean_radius) continue;  // at the ends
      const double stress = part(piece) / piece.area;
      mean += stress;
      squares += stress * stress;
      ++count;
    }
    mean /= count;
    return std::sqrt(squares / count - mean * mean) / std::abs(mean);
  };
  std::printf(
      "  over %2.0f R along the joint, before it is let go: normal stress scatters by %4.1f %%, shear by "
      "%4.1f %%\n",
      window, 100.0 * deviation([](const Piece& p) { return p.normal; }),
      100.0 * deviation([](const Piece& p) { return p.shear; }));
}

// The piece of the joint that slid farthest, and by how many bonds its two discs hang on the rock on their own side.
void print_farthest(const Simulation& sim, const verification::DrivenJoint& driven) {
  const Assembly& a = sim.assembly();
  std::size_t farthest = 0;
  for (std::size_t k = 0; k < driven.contacts().size(); ++k)
    if (driven.slip(k) > driven.slip(farthest)) farthest = k;
  const SmoothContact& c = driven.contacts()[farthest];
  int bonds[2] = {};
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (a.smooth.of(e) != nullptr) continue;
    for (int k = 0; k < 2; ++k) {
      const auto disc = k == 0 ? a.first[c.bond] : a.second[c.bond];
      bonds[k] += a.first[e] == disc || a.second[e] == disc ? 1 : 0;
    }
  }
  std::printf("  farthest slide %.3f mm, at %.2f m over %.2f m, discs on %d and %d bonds\n",
              1e3 * driven.slip(farthest), driven.at(farthest), c.area, bonds[0], bonds[1]);
}

struct Ratios {
  double pressure, slip, length;  // rms over dp; over the formula's
};

// Once per half length of the formula in `reached` [m].
std::vector<Ratios> drive(std::int64_t discs, std::int64_t seed, double excess,
                          const std::vector<double>& reached, BoundaryKind kind) {
  const double modulus = plane_modulus(discs, seed), lambda = lambda_of(excess);
  const double diffusivity = aperture * aperture * bulk / (12.0 * viscosity);
  Simulation sim(fault(discs, seed, excess, kind), {}, {});
  for (const double window : {8.0, 32.0}) print_scatter(sim, window);
  const verification::DrivenJoint driven(sim, 0.5 * side, over);
  const auto& contacts = driven.contacts();
  const Network& n = sim.network();
  std::vector<Ratios> result;
  double time = 0.0;
  for (const double half_length : reached) {
    const double until = std::pow(half_length / lambda, 2) / (4.0 * diffusivity);
    constexpr int parts = 4;
    for (int k = 0; k < parts; ++k) sim.step(sim.loads(), (until - time) / parts);
    time = until;
    double squares = 0.0, near = 0.0, found = 0.0, expected = 0.0, sum = 0.0, moment = 0.0, sum_formula = 0.0,
           moment_formula = 0.0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const SmoothContact& c = contacts[k];
      const double x = driven.at(k), slip = driven.slip(k), A = c.area;
      const double formula = std::abs(x) < half_length
                                 ? friction * over / modulus * slip_at(x, half_length, lambda, excess)
                                 : 0.0;
      sum += A * slip;
      moment += A * slip * x * x;
      sum_formula += A * formula;
      moment_formula += A * formula * x * x;
      if (std::abs(x) < 0.5 * half_length) {
        found += A * slip;
        expected += A * formula;
      }
      if (std::abs(x) > 2.0 * half_length) continue;
      const double p =
          0.5 * (n.pressure[n.left[c.bond]] + n.pressure[n.right[c.bond]]) - n.reference_pressure;
      squares += A * std::pow(p / over - std::erfc(std::abs(x) / std::sqrt(4.0 * diffusivity * time)), 2);
      near += A;
    }
    const Ratios r{std::sqrt(squares / near), found / expected,
                   std::sqrt(moment / sum * sum_formula / moment_formula)};
    std::printf(
        "  %lld discs, packing %lld, T %.1f, a = %4.1f m = %2.0f R: pressure rms %.3f, slip %.3f, length "
        "%.3f\n",
        static_cast<long long>(discs), static_cast<long long>(seed), excess, half_length,
        half_length / sim.assembly().mean_radius, r.pressure, r.slip, r.length);
    print_farthest(sim, driven);
    std::fflush(stdout);
    result.push_back(r);
  }
  return result;
}

// Of packings 1 to `packings` at the last half length; prints the standard errors.
Ratios mean_of(std::int64_t discs, double excess, const std::vector<double>& reached, int packings,
               BoundaryKind kind) {
  Ratios mean{0.0, 0.0, 0.0};
  std::vector<double> slips, lengths;
  for (int seed = 1; seed <= packings; ++seed) {
    const Ratios last = drive(discs, seed, excess, reached, kind).back();
    mean.pressure += last.pressure / packings;
    mean.slip += last.slip / packings;
    mean.length += last.length / packings;
    slips.push_back(last.slip);
    lengths.push_back(last.length);
  }
  const auto error = [packings](const std::vector<double>& values, double average) {
    double squares = 0.0;
    for (const double v : values) squares += (v - average) * (v - average);
    return std::sqrt(squares / (packings - 1) / packings);
  };
  std::printf("  means of %d packings: slip %.3f +- %.3f, length %.3f +- %.3f\n", packings, mean.slip,
              error(slips, mean.slip), mean.length, error(lengths, mean.length));
  return mean;
}

std::string name_of(std::int64_t discs, double excess) {
  return "T " + std::to_string(excess).substr(0, 3) + ", " + std::to_string(discs) + " discs: ";
}

// What the same plate's edges make of the formula's slip and length (pressure: of no meaning).
Ratios by_the_edges(double half_length, double excess) {
  static const verification::SlippingPlate plate(side, 2.0 * half);
  const double lambda = lambda_of(excess);
  Eigen::VectorXd drop(plate.count);
  for (int k = 0; k < plate.count; ++k)
    drop[k] = std::erfc(std::abs(plate.at(k)) / half_length * lambda) - excess;
  double slip[2] = {}, length[2] = {};
  for (const bool edges : {false, true}) {
    const Eigen::VectorXd found = plate.slip(drop, edges);
    double moment = 0.0;
    for (int k = 0; k < plate.count; ++k) {
      const double x = plate.at(k);
      moment += found[k] * x * x;
      if (std::abs(x) < 0.5 * half_length) slip[edges] += found[k];
    }
    length[edges] = std::sqrt(moment / found.sum());
  }
  const Ratios r{0.0, slip[1] / slip[0], length[1] / length[0]};
  std::printf("  T %.1f, a = %.1f m: by the plate's edges slip %.3f, length %.3f\n", excess, half_length,
              r.slip, r.length);
  return r;
}

// At the last half length.
void hold(std::int64_t discs, double excess, const std::vector<double>& reached, double tolerance,
          int packings, BoundaryKind kind = BoundaryKind::infinite) {
  const Ratios mean = mean_of(discs, excess, reached, packings, kind);
  const std::string name = name_of(discs, excess);
  if (kind != BoundaryKind::infinite) {
    const Ratios edges = by_the_edges(reached.back(), excess);
    std::printf("  %sover those of the plate: slip %.3f, length %.3f\n", name.c_str(), mean.slip / edges.slip,
                mean.length / edges.length);
  }
  verification::report_absolute(name + "pressure, rms over dp", mean.pressure, 0.0, 0.03);
  verification::report(name + "slip in the middle half", mean.slip, 1.0, tolerance);
  verification::report(name + "length", mean.length, 1.0, tolerance);
}

// Half lengths [m]. With discs of 0.5 m (10 000) 8 to 40 R; with 40 000 twice as many.
const std::vector<double> growing = {4.0, 7.0, 10.0, 14.0, 20.0};

TEST(V23FaultInjectionSmoke, PressureDiffusesAlongTheJoint) {
  const auto rows = drive(4000, 1, 0.5, {10.0}, BoundaryKind::infinite);
  verification::report_absolute("pressure along the joint, rms over dp", rows[0].pressure, 0.0, 0.03);
}

TEST(V23FaultInjection, SlipsAsFarAsPressureTakesIt) {
  hold(10000, 0.5, growing, 0.1, 3);
  hold(10000, 0.1, growing, 0.1, 3);
}

// The elements by themselves, where the formula holds: table of Bhattacharya and Viesca (2019).
TEST(V23FaultInjectionSmoke, ElementsSlipAsTheFormulaSays) {
  constexpr double half_length = 10.0, excess = 0.5, of_the_table = 0.934;
  const verification::SlippingPlate plate(side, 2.0 * half);
  Eigen::VectorXd drop(plate.count);
  for (int k = 0; k < plate.count; ++k)
    drop[k] = std::erfc(std::abs(plate.at(k)) / half_length * lambda_of(excess)) - excess;
  verification::report("slip in the middle of elements, times E' / (f dp a)",
                       plate.slip(drop, false).maxCoeff() / half_length, of_the_table, 0.01);
  for (const double T : {0.5, 0.1})
    for (const double reached : {4.0, 7.0, 10.0, 20.0}) by_the_edges(reached, T);
}

TEST(V23FaultInjectionLong, ManyPackings) {
  hold(10000, 0.5, growing, 0.1, 9);
  hold(10000, 0.1, growing, 0.1, 9);
}
TEST(V23FaultInjectionLong, FinerDiscsAtT01) {
  hold(40000, 0.1, growing, 0.1, 9);
}
TEST(V23FaultInjectionLong, FinerDiscsAtT05) {
  hold(40000, 0.5, growing, 0.1, 3);
}
TEST(V23FaultInjectionLong, FinerDiscsAtT09) {
  hold(40000, 0.9, {2.0, 3.0, 4.0}, 0.1, 3);
}
TEST(V23FaultInjectionLong, InAPlateOfFinerDiscsAtT01) {
  hold(40000, 0.1, {4.0, 7.0, 10.0}, 0.15, 9, BoundaryKind::stress);
}

}  // namespace V23_fault_injection
