// SPDX-License-Identifier: BSD-3-Clause
// V22  Slip along a smooth joint that ends inside the rock.
//
// Formula    Pollard and Segall (1987), Fracture Mechanics of Rock, ch. 8: where a plane of half length c loses the shear stress D, its
//            faces slip by 4 D / E' sqrt(c^2 - s^2), E' = E / (1 - nu^2); D is half the difference of the stresses at 45 degrees.
//            The plate's edges are taken off by a boundary-element solution of the same plate (cracked_plate.hpp).
// Set-up     Dry plates of 100 m under 10 MPa, a joint without friction of c = 9.9 m in the middle at 45 degrees, sigma_Hmax raised by
//            2 MPa, quasi-static solver. Discs in rows (E' = k_n) and random packings (E' measured on them). Slip is fitted by
//            least squares to the ellipse and compared with the plate's fit.
// Tolerance  Discs of no size, by two of a ratio of two in radius: 5 %. Random packings at c = 22 R: mean of three 25 %, of which
//            17 % are the discs' size as in rows; their standard deviation 9 %, and not below 2 %. A joint of a fifth of the side
//            against one of a tenth, the same number of discs long: slip by the plate's edges, 10 %.
// Page       docs/verification/V22.md
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../joint_def.hpp"
#include "cracked_plate.hpp"
#include "support.hpp"

namespace V22_joint_slip {

using namespace verification;

constexpr double side = 100.0, around = 10e6, more = 2e6, stiffness = 16e9;  // m, Pa, Pa, N/m

struct Slip {
  std::vector<double> at, slip;  // m
};

// `turning`: radius of bonds over that of discs; what bends a bond grows with its square, and nothing else does.
hfrac::Definition plate(int64_t discs, bool square, int64_t seed, double turning = 1.0) {
  hfrac::Definition def = new_def();
  def.model_width = def.model_height = side;
  def.model_seed = seed;
  def.packing_disc_count = discs;
  def.packing_method = square ? 3 : 0;
  def.flow_scheme = 2;
  def.solver_kind = 1;
  def.contact_mode = 1;
  def.bond_radius_factor = turning;
  def.bond_normal_stiffness = stiffness;
  def.bond_shear_stiffness = square ? stiffness : 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = around;
  return def;
}

// What the joint of half length c at 45 degrees, `off` beside the middle, slips as sigma_Hmax rises.
Slip slip_along(hfrac::Definition def, double c, double off) {
  const double t = std::sqrt(0.5);  // both parts of the joint's direction; its normal is (-t, t)
  const double x = 0.5 * side - off * t, y = 0.5 * side + off * t;
  hfrac_sim_def_set_i64(&def, "joint_count", 1);
  def.joints[0] =
      joint_def(x - c * t, y - c * t, x + c * t, y + c * t, 1.0, 1.0, 0.0, HFRAC_JOINT_SMOOTH_BROKEN);
  Simulation sim(def);
  sim.step(1);  // set-up moves the rock to rest; what it left of the slip is settled by the solver
  const auto before = sim.values(HFRAC_JOINT_TOTAL_SLIP);
  sim.set_far_field(around + more, around);
  sim.step(1);
  const auto slip = moved(before, sim.values(HFRAC_JOINT_TOTAL_SLIP)), begin = sim.values(HFRAC_JOINT_BEGIN),
             end = sim.values(HFRAC_JOINT_END);
  std::vector<std::pair<double, double>> found;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    const double at_x = 0.5 * (begin[2 * k] + end[2 * k]), at_y = 0.5 * (begin[2 * k + 1] + end[2 * k + 1]);
    found.emplace_back(t * (at_x - x + at_y - y), std::abs(slip[k]));
  }
  std::sort(found.begin(), found.end());
  Slip result;
  for (const auto& [at, slid] : found) {
    result.at.push_back(at);
    result.slip.push_back(slid);
  }
  return result;
}

// Of least squares: slip = factor sqrt(c^2 - s^2).
double ellipse(const std::vector<double>& at, const std::vector<double>& slip, double c) {
  double both = 0.0, square = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double e = std::sqrt(std::max(0.0, c * c - at[k] * at[k]));
    both += e * slip[k];
    square += e * e;
  }
  return both / square;
}

// Factors of the fitted ellipse over that of rock without end: of the discs, and of a continuum of the same plate.
struct Factors {
  double discs, plate;
};
Factors factors(const hfrac_sim_def& def, double modulus, double c, double radius, double off,
                const std::string& series, bool drawn) {
  const Slip slip = slip_along(def, c, off);
  const PlateSlip smooth = plate_slip(side, c, 0.25 * pi, off);
  const double drop = 0.5 * more, expected = ellipse(smooth.at, smooth.slip, c) * more / modulus,
               found = ellipse(slip.at, slip.slip, c);
  std::printf(
      "  %s: c = %.1f R, %d contacts; over the ellipse of rock without end %.3f, of which the plate's edges "
      "%.3f; rest %.3f\n",
      series.c_str(), c / radius, static_cast<int>(slip.at.size()), found * modulus / (4.0 * drop),
      expected * modulus / (4.0 * drop), found / expected);
  if (drawn) {
    Curves curves("V22", "Slip along a smooth joint inside the rock", "along the joint (m),slip (mm)");
    for (std::size_t k = 0; k < slip.at.size(); ++k) curves.point(series, {slip.at[k], 1e3 * slip.slip[k]});
    static bool formula = false;  // once: it is the same for all
    if (!formula) {
      curves.line("Pollard and Segall with the plate's edges", -c, c, [&](double s) {
        return std::vector<double>{1e3 * expected * std::sqrt(std::max(0.0, c * c - s * s))};
      });
    }
    formula = true;
  }
  return {found * modulus / (4.0 * drop), expected * modulus / (4.0 * drop)};
}

// `cells` discs a side and a joint of `contacts`, between two of the diagonals that the centres lie on.
double in_rows(int64_t cells, int contacts, bool drawn = true, double turning = 1.0) {
  const double radius = 0.5 * side / static_cast<double>(cells), c = contacts * radius / std::sqrt(2.0);
  const Factors found =
      factors(plate(cells * cells, true, 1, turning), stiffness, c, radius, radius / std::sqrt(2.0),
              std::to_string(cells * cells) + " discs in rows", drawn);
  return found.discs / found.plate;
}

TEST(V22JointSlipSmoke, IsTheEllipseForDiscsOfNoSize) {
  const double coarse = in_rows(50, 14), fine = in_rows(100, 28);
  EXPECT_LT(fine, coarse);
  report("slip over the plate's, extrapolated", 2.0 * fine - coarse, 1.0, 0.05);
}

// Why it is high, for a part: discs beside the joint turn. Bonds stiffer against bending keep them from it; the modulus stays the same.
TEST(V22JointSlip, IsHighSinceDiscsTurn) {
  const auto of_packings = [](double turning) {
    double mean = 0.0;
    for (int64_t seed = 1; seed <= 3; ++seed) {
      const auto def = plate(3000, false, seed, turning);
      const Factors one = factors(def, elasticity(def, 10e6).modulus, 10.0, 0.92, 0.0,
                                  "3000 discs, packing " + std::to_string(seed), false);
      mean += one.discs / one.plate / 3;
    }
    return mean;
  };
  double rows[3], packings[3];
  constexpr double turning[] = {0.5, 1.0, 2.0};
  for (int k = 0; k < 3; ++k) {
    std::printf("  bond.radius_factor %.1f:\n", turning[k]);
    rows[k] = in_rows(50, 14, false, turning[k]);
    packings[k] = of_packings(turning[k]);
    std::printf("  bond.radius_factor %.1f: rows %.3f, mean of random packings %.3f\n", turning[k], rows[k],
                packings[k]);
  }
  report("slip over the plate's, bonds twice as wide, mean of packings", packings[2], 1.0, 0.25);
  for (int k = 1; k < 3; ++k) {
    EXPECT_LT(rows[k], rows[k - 1]);
    EXPECT_LT(packings[k], packings[k - 1]);
  }
}

TEST(V22JointSlip, IsTheEllipseForDiscsOfNoSize) {
  const double coarse = in_rows(100, 28, false), fine = in_rows(200, 56);
  EXPECT_LT(fine, coarse);
  report("slip over the plate's, extrapolated", 2.0 * fine - coarse, 1.0, 0.05);
}

// Means over three random packings of discs of a mean radius [m]; the discs' is held to the plate's.
Factors hold_packings(int64_t discs, double c, double radius) {
  constexpr int packings = 3;
  Factors mean{0.0, 0.0};
  double squares = 0.0;
  for (int64_t seed = 1; seed <= packings; ++seed) {
    const auto def = plate(discs, false, seed);
    const Factors one = factors(def, elasticity(def, 10e6).modulus, c, radius, 0.0,
                                std::to_string(discs) + " discs, packing " + std::to_string(seed), false);
    mean.discs += one.discs / packings;
    mean.plate += one.plate / packings;
    squares += one.discs * one.discs;
  }
  const double spread =
      std::sqrt(std::max(0.0, squares - packings * mean.discs * mean.discs) / (packings - 1)) / mean.discs;
  report("slip over the plate's, mean of three packings", mean.discs / mean.plate, 1.0, 0.25);
  report_absolute("standard deviation of a packing over the mean", spread, 0.0, 0.09);
  EXPECT_GT(spread, 0.02) << "packings that agree so well are hardly three different ones";
  return mean;
}

// The same number of discs along the joint, so that what differs is the joint's length over the plate's side.
TEST(V22JointSlipLong, ALongJointSlipsMoreByThePlatesEdges) {
  const Factors short_one = hold_packings(12000, 10.0, 0.46), long_one = hold_packings(3000, 20.0, 0.92);
  report("slip of the long joint over the short one's", long_one.discs / short_one.discs,
         long_one.plate / short_one.plate, 0.10);
}

}  // namespace V22_joint_slip
