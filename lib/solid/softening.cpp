// SPDX-License-Identifier: BSD-3-Clause
#include "solid/softening.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "options/number_text.hpp"
#include "solid/bond_law.hpp"
#include "solid/kernels.hpp"

namespace hfrac {
namespace {

// w_0 w_c of a bond [m2].
double start_times_end(const Assembly& a, const Options& o, std::int64_t e) {
  return 4.0 * o.bond_fracture_energy * a.bond_radius(e) /
         (o.bond_normal_stiffness * a.factors.stiffness_of(e));
}

struct End {
  double at, by_start;  // m, 1
};
End end_of(double product, double start) {
  const double soft = product / start, steep = steepest_softening * start;
  return soft > steep ? End{soft, -soft / start} : End{steep, steepest_softening};
}

}  // namespace

Softened soften(const Assembly& a, const Options& o, std::int64_t e, const PairMotion& m) {
  Softened s;
  s.start = a.softening.start[e];
  s.worst = a.softening.worst[e];
  const double stiffness = o.bond_normal_stiffness * a.factors.stiffness_of(e);
  if (!(stiffness > 0.0)) return s;
  const double radius = a.bond_radius(e), open = std::max(0.0, m.gap),
               across = o.bond_shear_stiffness / o.bond_normal_stiffness * m.shear,
               bent = radius * radius / 3.0 * m.bend;
  const double w = std::sqrt(open * open + across * m.shear + bent * m.bend);
  const double by_gap = stiffness / a.tensile_capacity(e),
               by_shear = o.bond_shear_stiffness / o.bond_normal_stiffness * stiffness / a.shear_capacity(e),
               by_bend = o.bond_moment_contribution * radius * by_gap;
  s.tensile = by_gap * m.gap + by_bend * std::abs(m.bend);
  s.shear = by_shear * std::abs(m.shear);
  const bool pulled = s.tensile >= s.shear;
  const double stress = pulled ? s.tensile : s.shear, product = start_times_end(a, o, e);
  const bool whole = s.start == 0.0;
  if (whole && !(stress > 0.0)) return s;
  const double start = whole ? w / stress : s.start;
  const End end = end_of(product, start);
  s.spent = std::max(w, s.worst) / end.at;
  if (whole && stress < 1.0) return s;
  s.start = start;
  s.at_start = w > start ? start / w : 1.0;
  const bool grows = w > s.worst;
  s.worst = std::min(std::max(w, s.worst), end.at);
  const double way = end.at - start, left = end.at - s.worst;
  s.kept = s.worst > start ? start * left / (s.worst * way) : 1.0;
  if (!grows || w <= start || w >= end.at) return s;
  // By w, and of a bond that begins to soften just now by its start, which goes with the way it is loaded.
  const double by_w = -start * end.at / (w * w * way);
  const double by_start =
      whole ? (end.by_start * start * (w - start) + left * end.at) / (w * way * way) : 0.0;
  const double through_w = (by_w + by_start / stress) / w, through_stress = -by_start * start / stress;
  s.by_gap = through_w * open + (pulled ? through_stress * by_gap : 0.0);
  s.by_shear = through_w * across + (pulled ? 0.0 : through_stress * std::copysign(by_shear, m.shear));
  s.by_bend = through_w * bent + (pulled ? through_stress * std::copysign(by_bend, m.bend) : 0.0);
  return s;
}

double energy_taken(const Assembly& a, const Options& o, std::int64_t e) {
  const double start = a.softening.start[e];
  if (start == 0.0) return 0.0;
  const double end = end_of(start_times_end(a, o, e), start).at;
  return 0.5 * o.bond_normal_stiffness * a.factors.stiffness_of(e) * start * end *
         std::max(0.0, a.softening.worst[e] - start) / (end - start);
}

double energy_taken(const Assembly& a, const Options& o) {
  double sum = 0.0;
  if (a.softening.empty()) return sum;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) sum += energy_taken(a, o, e);
  return sum;
}

double largest_stress(const Assembly& a, const Options& o) {
  double largest = 0.0;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    if (a.intact[e] == 0) continue;
    const Softened s = bond_law(a, o, e).softened;
    largest = std::max({largest, s.tensile, s.shear, s.start > 0.0 ? 1.0 : 0.0});
  }
  return largest;
}

void begin_softening(Assembly& a, const Options& o) {
  double radius = 0.0;
  for (std::int64_t e = 0; e < a.bond_count(); ++e) radius = std::max(radius, a.bond_radius(e));
  // In tension w_c = 2 G_c / T has to be more than w_0 = 2 R T / k_n.
  const double strength = o.bond_tensile_strength * a.strength_factor,
               least = strength * strength * radius / o.bond_normal_stiffness;
  if (!(o.bond_fracture_energy > least))
    throw Error(ErrorKind::model, "bond.fracture_energy = " + number_text(o.bond_fracture_energy) +
                                      " J/m2 is less than a bond stores when it reaches its strength, "
                                      "sigma_c^2 R / bond.normal_stiffness = " +
                                      rounded_text(least) + " J/m2 for the largest bond radius of " +
                                      rounded_text(radius) +
                                      " m, so that it could not soften; give more, smaller discs (below " +
                                      rounded_text(radius * o.bond_fracture_energy / least) +
                                      " m at this energy), a lower bond.tensile_strength, or 0 for bonds "
                                      "that break at their strength.");
  a.softening.start.assign(a.first.size(), 0.0);
  a.softening.worst.assign(a.first.size(), 0.0);
  combine_factors(a, o);
}

}  // namespace hfrac
