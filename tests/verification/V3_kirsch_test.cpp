// SPDX-License-Identifier: BSD-3-Clause
// V3  Stress around a round hole, hydrostatic and uniaxial far field.
//
// Formula    Kirsch (1898) for a plate without end; here for a ring of outer radius b under uniform
// tractions, which
//            tends to Kirsch's for b >> a: with s = (sigma_H + sigma_h) / 2 and d = (sigma_H - sigma_h) / 2
//              sigma_theta = s b^2 / (b^2 - a^2) (1 + a^2 / r^2) + (2 A + 12 B r^2 + 6 C / r^4) cos 2 theta
//            A to D from the four tractions sigma_r(a) = tau(a) = 0, sigma_r(b) = d cos 2 theta, tau(b) = -d
//            sin 2 theta.
// Source     Timoshenko and Goodier, Theory of Elasticity, sections 28 and 32.
// Set-up     Linear set (bond 16e9 and 5.6e9 N/m, contacts after breakage), dry, unbreakable. A disc of 48 m
// radius is cut
//            out of a relaxed packing and given to the library, a hole of 7.5 m cut into its middle; the far
//            field acts on the outermost discs. Four packings. a is the hole's equivalent radius, b that of
//            the outline. Hoop stress from disc.stress, averaged over rings by cell area; the analytic value
//            is averaged over the same discs. Cell areas are scaled so that they fill the ring from 1.3 a to
//            0.9 b.
// Tolerance  physics.md: 2 % of the hoop stress beyond 1.7 a, -8 % from 1.3 a to 1.7 a (hydrostatic, ring
// mean).
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "support.hpp"

namespace {

using namespace verification;

constexpr double centre = 50.0;        // m
constexpr double outer_radius = 48.0;  // m
constexpr double hole_radius = 7.5;    // m, nominal
constexpr int packings = 4;

hfrac_sim_def rock(int64_t seed) {
  hfrac_sim_def def = new_def();
  def.flow_scheme = 2;
  def.packing_disc_count = 10500;
  def.model_seed = seed;
  def.contact_mode = 1;
  def.bond_normal_stiffness = 16e9;
  def.bond_shear_stiffness = 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  return def;
}

// Hoop stress in the ring from a to b.
class Ring {
 public:
  Ring(double a, double b, double larger, double smaller)
      : a_(a), b_(b), mean_(0.5 * (larger + smaller)), deviation_(0.5 * (larger - smaller)) {
    Eigen::Matrix4d rows;
    rows << radial(a), shear(a), radial(b), shear(b);
    coefficients_ = rows.fullPivLu().solve(Eigen::Vector4d(0.0, 0.0, deviation_, -deviation_));
  }
  [[nodiscard]] double hoop(double r, double theta) const {
    return mean_ * b_ * b_ / (b_ * b_ - a_ * a_) * (1.0 + a_ * a_ / (r * r)) +
           (2.0 * coefficients_[0] + 12.0 * coefficients_[1] * r * r +
            6.0 * coefficients_[2] / std::pow(r, 4)) *
               std::cos(2.0 * theta);
  }

 private:
  static Eigen::RowVector4d radial(double r) { return {-2.0, 0.0, -6.0 / std::pow(r, 4), -4.0 / (r * r)}; }
  static Eigen::RowVector4d shear(double r) {
    return {2.0, 6.0 * r * r, -6.0 / std::pow(r, 4), -2.0 / (r * r)};
  }
  double a_, b_, mean_, deviation_;
  Eigen::Vector4d coefficients_;
};

// Sums over the discs of one zone: a ring, all round or within 30 degrees of an axis.
struct Zone {
  double from, to;  // r / a
  int sector;       // 0 all round, 1 about y (sigma_h), 2 about x (sigma_H)
  double measured = 0.0, analytic = 0.0, kirsch = 0.0, weight = 0.0;
};

double outline_radius(Simulation& s, const std::vector<double>& x) {
  const auto corners = s.indices(HFRAC_DOMAIN_CORNERS), offset = s.indices(HFRAC_DOMAIN_OFFSET);
  double area = 0.0;
  for (auto k = offset[0]; k < offset[1]; ++k) {
    const auto i = static_cast<std::size_t>(corners[static_cast<std::size_t>(k)]);
    const auto j =
        static_cast<std::size_t>(corners[static_cast<std::size_t>(k + 1 < offset[1] ? k + 1 : offset[0])]);
    area -= 0.5 * (x[2 * i] * x[2 * j + 1] - x[2 * j] * x[2 * i + 1]);
  }
  return std::sqrt(area / pi);
}

void add_packing(int64_t seed, double larger, double smaller, std::vector<Zone>& zones) {
  hfrac_sim_def def = rock(seed);
  std::vector<double> given;
  {
    Simulation whole(def);
    const auto x = whole.values(HFRAC_DISC_POSITION), radius = whole.values(HFRAC_DISC_RADIUS);
    for (std::size_t i = 0; i < radius.size(); ++i) {
      if (std::hypot(x[2 * i] - centre, x[2 * i + 1] - centre) >= outer_radius) continue;
      given.insert(given.end(), {x[2 * i], x[2 * i + 1], radius[i]});
    }
  }
  def.given_discs = given.data();
  def.given_disc_count = static_cast<int64_t>(given.size() / 3);
  def.well_count = 1;
  def.wells[0].x = def.wells[0].y = centre;
  def.wells[0].radius = hole_radius;
  def.stress_sigma_H = larger;
  def.stress_sigma_h = smaller;
  Simulation s(def);
  EXPECT_EQ(s.state().at_rest, 1);
  const auto x = s.values(HFRAC_DISC_POSITION), radius = s.values(HFRAC_DISC_RADIUS),
             stress = s.values(HFRAC_DISC_STRESS);
  const double a = s.well(0).equivalent_radius, b = outline_radius(s, x);
  const Ring ring(a, b, larger, smaller), far(a, 1e4 * a, larger, smaller);

  // disc.stress divides by the disc's share of the box, which here is not full: find the share that fills the
  // ring.
  const double solid = 1.0 - s.setup().porosity;
  double cells = 0.0;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double r = std::hypot(x[2 * i] - centre, x[2 * i + 1] - centre);
    if (r > 1.3 * a && r < 0.9 * b) cells += pi * radius[i] * radius[i] / solid;
  }
  const double share = pi * (0.81 * b * b - 1.69 * a * a) / cells;

  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double dx = x[2 * i] - centre, dy = x[2 * i + 1] - centre, r = std::hypot(dx, dy),
                 theta = std::atan2(dy, dx);
    const double c = dx / r, sine = dy / r, cell = radius[i] * radius[i];
    const double hoop =
        (stress[3 * i] * sine * sine + stress[3 * i + 1] * c * c - 2.0 * stress[3 * i + 2] * sine * c) /
        share;
    for (Zone& zone : zones) {
      if (r < zone.from * a || r >= zone.to * a) continue;
      if (zone.sector == 1 && std::abs(c) > 0.5) continue;
      if (zone.sector == 2 && std::abs(sine) > 0.5) continue;
      zone.measured += cell * hoop;
      zone.analytic += cell * ring.hoop(r, theta);
      zone.kirsch += cell * far.hoop(r, theta);
      zone.weight += cell;
    }
  }
  if (seed == 1) {
    std::printf(
        "  %zu discs, mean radius %.3f m, hole %.2f m (nominal %.2f + %.2f mean radii), outline %.2f m\n",
        radius.size(), s.setup().mean_radius, a, hole_radius, (a - hole_radius) / s.setup().mean_radius, b);
  }
}

void print(const Zone& zone, double unit) {
  static const char* const where[] = {"all round", "about y", "about x"};
  std::printf(
      "  r/a %.1f to %.1f, %-9s measured %7.4f  analytic %7.4f (plate without end %7.4f)  error %+6.1f %%\n",
      zone.from, zone.to, where[zone.sector], zone.measured / zone.weight / unit,
      zone.analytic / zone.weight / unit, zone.kirsch / zone.weight / unit,
      100.0 * (zone.measured / zone.analytic - 1.0));
}

TEST(V3Kirsch, HydrostaticFarField) {
  constexpr double far_field = 20e6;
  std::vector<Zone> zones{{1.0, 1.3, 0}, {1.3, 1.7, 0}, {1.7, 2.5, 0},
                          {2.5, 3.5, 0}, {3.5, 5.0, 0}, {1.7, 5.0, 0}};
  for (int seed = 1; seed <= packings; ++seed) add_packing(seed, far_field, far_field, zones);
  for (const Zone& zone : zones) {
    print(zone, far_field);
    const double error = zone.measured / zone.analytic - 1.0;
    if (zone.from >= 1.7) {
      EXPECT_LT(std::abs(error), 0.02) << "r/a " << zone.from << " to " << zone.to;
    } else if (zone.from >= 1.3) {
      EXPECT_LT(std::abs(error), 0.08);
    }
  }
}

TEST(V3Kirsch, UniaxialFarField) {
  constexpr double far_field = 20e6;
  std::vector<Zone> zones;
  for (int sector = 0; sector < 3; ++sector) {
    for (const auto& [from, to] : {std::pair{1.0, 1.3}, {1.3, 1.7}, {1.7, 2.5}, {2.5, 3.5}, {3.5, 5.0}}) {
      zones.push_back({from, to, sector});
    }
  }
  for (int seed = 1; seed <= packings; ++seed) add_packing(seed, far_field, 0.0, zones);
  for (const Zone& zone : zones) {
    print(zone, far_field);
    // Along x the hoop stress passes through zero: errors are taken of the far field.
    const double error = (zone.measured - zone.analytic) / zone.weight / far_field;
    if (zone.from >= 1.7) {
      EXPECT_LT(std::abs(error), 0.02 * std::max(1.0, zone.analytic / zone.weight / far_field))
          << "r/a " << zone.from << " to " << zone.to << " sector " << zone.sector;
    }
  }
}

}  // namespace
