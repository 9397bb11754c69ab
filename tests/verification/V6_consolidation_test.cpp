// SPDX-License-Identifier: BSD-3-Clause
// V6  Consolidation of a continuum: Terzaghi's column, Mandel's plate with its Cryer effect, and a seeping well.
//
// Formulas   Terzaghi: p = p0 sum 4/(pi m) sin(pi m z / 2 h) exp(-pi^2 m^2 T / 4), m = 1, 3, 5 ..., T = c t / h^2, z from
//            the drained end; p0 = B (1 + nu_u) / (3 (1 - nu_u)) sigma.
//            Mandel: p = 2/3 B (1 + nu_u) sigma sum (sin a_i / (a_i - sin a_i cos a_i)) (cos(a_i x / a) - cos a_i)
//            exp(-a_i^2 T), tan a_i / a_i = (1 - nu) / (nu_u - nu), T = c t / a^2.
//            Well: steady seepage through a thick ring, p ~ ln r, and the stresses that go with it.
// Source     Terzaghi (1923) and Mandel (1953) as written in Detournay and Cheng (1993), section 6; ring: Lame, with the
//            seepage's part from radial equilibrium (same source, section 5).
// Set-up     lib/rock: nu 0.24, alpha 0.9, B 0.66 (nu_u 0.36), graded meshes of 1 x 40, 10 x 4 to 40 x 4 and 48 x 32 elements,
//            200 to 400 steps that grow with time. Discs: 4 000 (2 000 and 8 000 in the long variant) of the linear set in 100 m x 100 m, unbreakable, apertures
//            that do not change, K_f 5 GPa; 5 MPa more on all sides at once, the outer boundary drained. Against the continuum on the same
//            square with nothing fitted: E and nu of the dry packing under 20 MPa along x (as in V2), k of the network, storage
//            phi / K_f with phi the pores' share of the polygons, alpha = 1 since discs are rigid; half width from the
//            polygons' area. Means over squares of 10 m.
// Tolerance  0.5 % of the greatest value; discs 3 % of the first pressure, rms over the squares, from T = 0.05 on
//            and with 4 000 discs or more; 6 % before and with fewer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "rectangle_mesh.hpp"
#include "rock/biot_solver.hpp"
#include "support.hpp"

namespace V6_consolidation {

using namespace hfrac;
using verification::pi;
using verification::report;
using verification::report_absolute;

constexpr double load = 10e6;  // [Pa]

BiotMaterial sandstone() {
  BiotMaterial m;
  m.youngs_modulus = 14.2e9;
  m.poissons_ratio = 0.24;
  m.biot = 0.9;
  m.storage = 5e-11;
  m.mobility = 1e-14;
  return m;
}

// n + 1 places from 0 to length, the first interval `first` times as long as an even one would be.
std::vector<double> graded(double length, int n, double exponent) {
  std::vector<double> place;
  for (int k = 0; k <= n; ++k) place.push_back(length * std::pow(static_cast<double>(k) / n, exponent));
  return place;
}

std::vector<double> mirrored(const std::vector<double>& from) {
  std::vector<double> place;
  for (auto it = from.rbegin(); it != from.rend(); ++it) place.push_back(from.back() - *it);
  return place;
}

// Goes to `until` in steps that grow with the time passed.
class Clock {
 public:
  Clock(BiotSolver& rock, double first) : rock_(rock), step_(first) {}
  void go(double until) {
    while (time_ < until * (1.0 - 1e-12)) {
      const double step = std::min(std::max(step_, 0.04 * time_), until - time_);
      rock_.advance(step);
      time_ += step;
    }
  }

 private:
  BiotSolver& rock_;
  double step_, time_ = 0.0;
};

double terzaghi(double depth, double time) {
  double sum = 0.0;
  for (int m = 1; m < 400; m += 2)
    sum += 4.0 / (pi * m) * std::sin(0.5 * pi * m * depth) * std::exp(-0.25 * pi * pi * m * m * time);
  return sum;
}

class Mandel {
 public:
  explicit Mandel(const BiotMaterial& m)
      : start_(2.0 / 3.0 * m.skempton() * (1.0 + m.undrained_poissons_ratio())) {
    const double slope = (1.0 - m.poissons_ratio) / (m.undrained_poissons_ratio() - m.poissons_ratio);
    for (int k = 0; k < 60; ++k) {
      double low = pi * k + 1e-9, high = pi * (k + 0.5) - 1e-12;
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (std::tan(middle) < slope * middle ? low : high) = middle;
      }
      root_.push_back(low);
    }
  }
  // Over the load; place over the half width.
  [[nodiscard]] double pressure(double place, double time) const {
    double sum = 0.0;
    for (const double a : root_) {
      sum += std::sin(a) / (a - std::sin(a) * std::cos(a)) * (std::cos(a * place) - std::cos(a)) *
             std::exp(-a * a * time);
    }
    return start_ * sum;
  }

 private:
  double start_;
  std::vector<double> root_;
};

TEST(V6ContinuumSmoke, ColumnConsolidatesAsTerzaghiSays) {
  const BiotMaterial m = sandstone();
  const double height = 10.0, nu_u = m.undrained_poissons_ratio();
  BiotSolver rock(verification::rectangle_mesh({0.0, 1.0}, mirrored(graded(height, 40, 1.5))), m,
                  {{RockSide::left, SideMotion::held},
                   {RockSide::right, SideMotion::held},
                   {RockSide::bottom, SideMotion::held},
                   {RockSide::top, SideMotion::free, true}});
  rock.set_stress(RockSide::top, {0.0, load, 0.0});
  rock.load_undrained();
  const double start = m.skempton() * (1.0 + nu_u) / (3.0 * (1.0 - nu_u)) * load;
  const auto foot = rock.mesh().element.front()[0], head = rock.mesh().element.back()[3];
  report("Terzaghi: pressure at once, Pa", rock.pressure(foot), start, 1e-6);
  const double settled_at_once = -rock.displacement(head).y;
  const double scale = height * height / m.consolidation();
  Clock clock(rock, 1e-6 * scale);
  verification::Curves curves("V6-terzaghi",
                              "Terzaghi's column: pressure over the first at T = 0.01 and 0.1 and 0.5",
                              "depth over height,pressure over the first");
  for (const double time : {0.001, 0.01, 0.1, 0.5, 1.0}) {
    clock.go(time * scale);
    double worst = 0.0;
    const bool drawn = time > 0.005 && time < 0.9;
    char name[32];
    std::snprintf(name, sizeof name, "T = %g", time);
    if (drawn) {
      curves.line(std::string("formula: ") + name, 0.0, 1.0,
                  [&](double depth) { return std::vector<double>{terzaghi(depth, time)}; });
    }
    int number = 0;
    for (const auto& element : rock.mesh().element) {
      const double depth = 1.0 - rock.mesh().node[static_cast<std::size_t>(element[0])].y / height;
      if (drawn && number++ % 3 == 0)
        curves.point(std::string("continuum: ") + name, {depth, rock.pressure(element[0]) / start});
      worst = std::max(worst, std::abs(rock.pressure(element[0]) / start - terzaghi(depth, time)));
    }
    report_absolute(std::string("Terzaghi: worst error of the pressure over the first, ") + name, worst, 0.0,
                    5e-3);
  }
  clock.go(10.0 * scale);
  const double stiff = m.bulk_modulus() + 4.0 / 3.0 * m.shear_modulus();
  report("Terzaghi: settlement in the end, m", -rock.displacement(head).y, load * height / stiff, 1e-6);
  const double stiff_undrained = stiff + m.biot * m.biot / m.storage;
  report("Terzaghi: settlement at once, m", settled_at_once, load * height / stiff_undrained, 1e-6);
}

TEST(V6Continuum, PlateConsolidatesAsMandelSays) {
  const BiotMaterial m = sandstone();
  const Mandel analytic(m);
  const double half = 10.0;
  double coarser = 1e300;  // largest error of the mesh before
  for (const int elements : {10, 20, 40}) {
    BiotSolver rock(verification::rectangle_mesh(mirrored(graded(half, elements, 1.5)), graded(2.0, 4, 1.0)),
                    m,
                    {{RockSide::left, SideMotion::held},
                     {RockSide::bottom, SideMotion::held},
                     {RockSide::top, SideMotion::rigid_plate},
                     {RockSide::right, SideMotion::free, true}});
    rock.set_stress(RockSide::top, {0.0, load, 0.0});
    rock.load_undrained();
    const auto middle = rock.mesh().element.front()[0];
    const double at_once = rock.pressure(middle) / load;
    report("Mandel: pressure at once over the load", at_once,
           m.skempton() * (1.0 + m.undrained_poissons_ratio()) / 3.0, 1e-6);
    const double scale = half * half / m.consolidation();
    Clock clock(rock, 1e-6 * scale);
    double peak = 0.0, analytic_peak = 0.0, largest = 0.0;
    verification::Curves curves("V6-mandel",
                                "Mandel's plate: pressure in its middle over the first (the Cryer effect)",
                                "T,pressure over the first");
    if (elements == 40) {
      curves.line("formula", 0.002, 0.5,
                  [&](double t) { return std::vector<double>{analytic.pressure(0.0, t) / at_once}; });
    }
    for (const double time :
         {0.001, 0.003, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.1, 0.2, 0.5, 1.0}) {
      clock.go(time * scale);
      double worst = 0.0;
      for (int k = 0; k < elements; ++k) {
        const auto node = rock.mesh().element[static_cast<std::size_t>(k)][0];
        const double place = rock.mesh().node[static_cast<std::size_t>(node)].x / half;
        worst = std::max(worst, std::abs(rock.pressure(node) / load - analytic.pressure(place, time)));
      }
      worst /= at_once;
      peak = std::max(peak, rock.pressure(middle) / load);
      analytic_peak = std::max(analytic_peak, analytic.pressure(0.0, time));
      if (elements == 40 && time <= 0.5)
        curves.point("continuum with 40 elements", {time, rock.pressure(middle) / load / at_once});
      largest = std::max(largest, worst);
    }
    if (elements == 40) {
      report_absolute("Mandel: worst error of the pressure over the first", largest, 0.0, 5e-3);
    } else {
      std::printf("  Mandel, %d elements: worst error of the pressure %.3f %% of the first\n", elements,
                  100.0 * largest);
    }
    EXPECT_LT(largest, 0.5 * coarser) << "twice the elements, and the error did not halve";
    coarser = largest;
    report("Mandel: greatest pressure over the first", peak / at_once, analytic_peak / at_once, 5e-3);
    EXPECT_GT(peak / at_once, 1.02) << "without the Cryer effect the pressure would only fall";
  }
}

// A ring under no stress outside, a pressure inside that seeps out through the outer boundary. With p falling as ln r, radial
// equilibrium of sigma' + alpha p gives
//   u = A r + D / r + C r ln r,   C = alpha k_p / (2 (lambda + 2 G)),   p = p_rim + k_p ln(r / r_rim).
// The plate is square, which is felt near its outer boundary: only flow and the stresses up to a quarter of the way are compared.
TEST(V6Continuum, SeepingWellIsInEquilibrium) {
  const BiotMaterial m = sandstone();
  const double wall = 0.5, width = 20.0;
  constexpr std::size_t around = 48, outward = 32;
  BiotSolver rock(plate_mesh(width, width, {10.0, 10.0}, wall, around, outward), m,
                  {{RockSide::left, SideMotion::free, true},
                   {RockSide::right, SideMotion::free, true},
                   {RockSide::top, SideMotion::free, true},
                   {RockSide::bottom, SideMotion::free, true},
                   {RockSide::well, SideMotion::free, true}});
  rock.set_pressure(RockSide::well, load);
  rock.set_stress(RockSide::well, {load, load, 0.0});
  rock.load_steady();
  // A square of width w lets flow out as a circle of radius 0.5393 w does (conformal radius of the square).
  const double rim = 0.5393526 * width;
  const double flow = 2.0 * pi * m.mobility * load / std::log(rim / wall);
  report("well: outflow, m2/s", -rock.steady_outflow(RockSide::well), flow, 5e-3);
  double out = 0.0;
  for (const auto side : {RockSide::left, RockSide::right, RockSide::top, RockSide::bottom})
    out += rock.steady_outflow(side);
  report("well: what flows in flows out, m2/s", out, flow, 5e-3);
  // Two constants: one from the pressure on the wall, one from the mean stress near it; the field follows.
  const double slope = -load / std::log(rim / wall), lambda = m.lambda(), g = m.shear_modulus();
  const double c = m.biot * slope / (2.0 * (lambda + 2.0 * g));
  struct Place {
    double radius, radial, hoop;  // compression positive
  };
  const auto round = [&](std::size_t ring) {
    std::vector<Place> places;
    for (std::size_t k = 0; k < around; ++k) {
      const auto s = rock.sample(k * outward + ring, 0.0, 0.0);
      const double x = s.place.x - 10.0, y = s.place.y - 10.0, r2 = x * x + y * y;
      const double rr = (s.total.xx * x * x + s.total.yy * y * y + 2.0 * s.total.xy * x * y) / r2;
      places.push_back({std::sqrt(r2), rr, s.total.xx + s.total.yy - rr});
    }
    return places;
  };
  // Tension positive: s_rr = 2 (lambda + G) (A + C ln r) + C (lambda + 2 G) - 2 G D / r^2 - alpha p, and s_tt likewise.
  const auto common = [&](double r) {
    return 2.0 * (lambda + g) * c * std::log(r) - m.biot * slope * std::log(r / rim);
  };
  double a = 0.0;  // 2 (lambda + G) A
  for (const auto& at : round(2))
    a += (-0.5 * (at.radial + at.hoop) - common(at.radius) - c * (lambda + g)) / static_cast<double>(around);
  const double d = (a + common(wall) + c * (lambda + 2.0 * g) + load) * wall * wall;  // 2 G D
  for (const std::size_t ring : {0U, 3U, 6U, 9U}) {
    double worst = 0.0, radius = 0.0;
    for (const auto& at : round(ring)) {
      const double both = a + common(at.radius), r2 = at.radius * at.radius;
      worst = std::max(worst, std::abs(at.radial + both + c * (lambda + 2.0 * g) - d / r2));
      worst = std::max(worst, std::abs(at.hoop + both + c * lambda + d / r2));
      radius = std::max(radius, at.radius);
    }
    std::printf("  well: up to %.2f radii\n", radius / wall);
    report_absolute("well: worst error of radial and hoop stress over the load", worst / load, 0.0, 5e-3);
  }
}

hfrac::Definition square_of_discs(int64_t discs) {
  hfrac::Definition def = verification::new_def();
  def.packing_disc_count = discs;
  def.contact_mode = 1;
  def.bond_normal_stiffness = 16e9;
  def.bond_shear_stiffness = 5.6e9;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.fluid_bulk_modulus = 5e9;
  def.flow_half_aperture_force = 1e15;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 30e6;
  def.solver_kind = 1;
  def.stepping_mode = 2;
  def.solver_pressure_change = 0.01;
  return def;
}

// E and nu of the packing, read as plane strain of a three-dimensional rock (V2).
void measure_elasticity(const hfrac_sim_def& wet, BiotMaterial& m) {
  hfrac::Definition def = wet;
  def.rock_biot_coefficient = 1.0;
  def.fracture_law = 0;
  def.flow_scheme = 2;
  def.solver_kind = 0;
  def.stepping_mode = 0;
  const auto measured = verification::elasticity(def, 20e6);
  m.poissons_ratio = measured.plane_strain_poisson();
  m.youngs_modulus = measured.plane_strain_modulus();
}

// Mean of a quantity over squares of 10 m, by volume.
class Squares {
 public:
  void add(double x, double y, double volume, double value) {
    auto& sum = sums_[{static_cast<int>(std::floor(x / 10.0)), static_cast<int>(std::floor(y / 10.0))}];
    sum.first += volume;
    sum.second += volume * value;
  }
  [[nodiscard]] double rms() const {
    double square = 0.0;
    for (const auto& [place, sum] : sums_) square += (sum.second / sum.first) * (sum.second / sum.first);
    return std::sqrt(square / static_cast<double>(sums_.size()));
  }

 private:
  std::map<std::pair<int, int>, std::pair<double, double>> sums_;
};

// Area of the polygon through the outermost discs [m2].
double area_inside(verification::Simulation& rock) {
  const auto place = rock.values(HFRAC_DISC_POSITION);
  const auto offset = rock.indices(HFRAC_DOMAIN_OFFSET), corner = rock.indices(HFRAC_DOMAIN_CORNERS);
  double twice = 0.0;
  const auto first = static_cast<std::size_t>(offset[0]), end = static_cast<std::size_t>(offset[1]);
  for (std::size_t k = first; k < end; ++k) {
    const auto i = static_cast<std::size_t>(corner[k]),
               j = static_cast<std::size_t>(corner[k + 1 < end ? k + 1 : first]);
    twice += place[2 * i] * place[2 * j + 1] - place[2 * j] * place[2 * i + 1];
  }
  return 0.5 * std::abs(twice);
}

// Pressure of the continuum at a place; `lines`: its element borders along both axes.
double at(const BiotSolver& rock, const std::vector<double>& lines, double x, double y) {
  const auto find = [&](double place) {
    const auto k = std::upper_bound(lines.begin(), lines.end() - 1, place) - lines.begin() - 1;
    return std::pair{static_cast<std::size_t>(k),
                     2.0 * (place - lines[static_cast<std::size_t>(k)]) /
                             (lines[static_cast<std::size_t>(k) + 1] - lines[static_cast<std::size_t>(k)]) -
                         1.0};
  };
  const auto [i, s] = find(x);
  const auto [j, t] = find(y);
  return rock.sample(j * (lines.size() - 1) + i, s, t).pressure;
}

// Greatest pressure in the middle over the first one. Below a Biot coefficient of 1 the rock is one of 5 % porosity whose grains give.
double consolidate(int64_t discs, double biot = 1.0) {
  hfrac::Definition def = square_of_discs(discs);
  if (biot < 1.0) {
    def.rock_biot_coefficient = biot;
    def.rock_porosity = 0.05;
    def.rock_grain_modulus = 30e9;
    def.fracture_law = 1;
  }
  BiotMaterial m;
  measure_elasticity(def, m);
  verification::Simulation rock(def);
  const double polygons = area_inside(rock), half = 0.5 * std::sqrt(polygons);
  const std::string name = std::to_string(discs) + (biot < 1.0 ? " discs with alpha 0.5" : " discs");
  double pores = 0.0;
  const auto volume = rock.values(HFRAC_DOMAIN_VOLUME), centre = rock.values(HFRAC_DOMAIN_CENTRE);
  for (std::size_t d = 1; d < volume.size(); ++d) pores += volume[d];
  m.biot = biot;
  m.storage = pores / polygons / def.fluid_bulk_modulus;
  if (biot < 1.0) m.storage += (biot - def.rock_porosity) / def.rock_grain_modulus;
  m.mobility = rock.setup().permeability / def.fluid_viscosity;
  std::printf("  %lld discs: E %.2f GPa, nu %.3f, B %.3f, nu_u %.3f, c %.3e m2/s\n",
              static_cast<long long>(discs), m.youngs_modulus / 1e9, m.poissons_ratio, m.skempton(),
              m.undrained_poissons_ratio(), m.consolidation());
  // The continuum: a quarter of the square.
  const auto lines = mirrored(graded(half, 30, 1.5));
  BiotSolver continuum(verification::rectangle_mesh(lines, lines), m,
                       {{RockSide::left, SideMotion::held},
                        {RockSide::bottom, SideMotion::held},
                        {RockSide::right, SideMotion::free, true},
                        {RockSide::top, SideMotion::free, true}});
  constexpr double more = 5e6;
  for (const auto side : {RockSide::right, RockSide::top}) continuum.set_stress(side, {more, more, 0.0});
  continuum.load_undrained();
  const double at_once = continuum.pressure(continuum.mesh().element.front()[0]);
  const double scale = half * half / m.consolidation();
  Clock clock(continuum, 1e-5 * scale);
  rock.set_far_field(30e6 + more, 30e6 + more);
  const auto start = rock.values(HFRAC_DOMAIN_PRESSURE);
  double time = 0.0, peak = 0.0;
  for (const double until : {0.02, 0.05, 0.1, 0.2, 0.4}) {
    rock.step_for((until - time) * scale);
    time = until;
    clock.go(time * scale);
    const auto pressure = rock.values(HFRAC_DOMAIN_PRESSURE);
    Squares squares;
    double middle = 0.0, middle_volume = 0.0;
    for (std::size_t d = 1; d < volume.size(); ++d) {
      const double x = centre[2 * d] - 50.0, y = centre[2 * d + 1] - 50.0, rise = pressure[d] - start[d];
      if (std::max(std::abs(x), std::abs(y)) >= 0.98 * half) continue;
      squares.add(x, y, volume[d], (rise - at(continuum, lines, std::abs(x), std::abs(y))) / at_once);
      if (std::hypot(x, y) > 10.0) continue;
      middle += volume[d] * rise / at_once;
      middle_volume += volume[d];
    }
    peak = std::max(peak, middle / middle_volume);
    verification::Curves curves(
        "V6-discs", "A square of discs drained at its outer boundary: pressure in the middle over the first",
        "T,pressure over the first");
    curves.point(name, {time, middle / middle_volume});
    curves.point("continuum for " + name, {time, at(continuum, lines, 3.0, 3.0) / at_once});
    std::printf("  %lld discs: T = %-4g  middle %.4f of the first pressure, continuum %.4f\n",
                static_cast<long long>(discs), time, middle / middle_volume,
                at(continuum, lines, 3.0, 3.0) / at_once);
    // Coarse discs do not resolve the layer under the outer boundary while it is thin.
    report_absolute("pressure over the first, rms over squares", squares.rms(), 0.0,
                    until >= 0.05 && discs >= 4000 ? 0.03 : 0.06);
  }
  return peak;
}

TEST(V6Discs, ConsolidateAsTheContinuumDoes) {
  EXPECT_GT(consolidate(4000), 1.05) << "the Cryer effect: the middle's pressure rises before it falls";
}

TEST(V6Discs, OfABiotCoefficientOfOneHalfDoSoToo) {
  EXPECT_GT(consolidate(4000, 0.5), 1.0);
}

TEST(V6DiscsLong, ComeCloserWithTheirNumber) {
  for (const int64_t discs : {2000, 8000}) EXPECT_GT(consolidate(discs), 1.05);
}

}  // namespace V6_consolidation
