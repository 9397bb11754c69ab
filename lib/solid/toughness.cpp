// SPDX-License-Identifier: BSD-3-Clause
#include "solid/toughness.hpp"

#include <cmath>

#include "options/choices.hpp"

namespace hfrac {
namespace {

// `hfrac lab centre-crack`, mean over packings; figures and scatter in docs/verification/V8.md.
constexpr double measured_parallel = 1.5, measured_after_break = 1.3;

// Mean of every disc's value and those of its neighbours.
Array<double> spread(const Assembly& a, const Array<double>& value) {
  Array<double> sum = value;
  std::vector<double> count(value.size(), 1.0);
  for (std::size_t e = 0; e < a.first.size(); ++e) {
    const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
    sum[i] += value[j];
    sum[j] += value[i];
    count[i] += 1.0;
    count[j] += 1.0;
  }
  for (std::size_t i = 0; i < count.size(); ++i) sum[i] /= count[i];
  return sum;
}

}  // namespace

double toughness_coefficient(const Options& o) {
  if (o.bond_toughness_coefficient > 0.0) return o.bond_toughness_coefficient;
  return ContactMode{o.contact_mode} == ContactMode::parallel ? measured_parallel : measured_after_break;
}

void apply_fracture_toughness(Assembly& a, const Options& o) {
  const double at_mean = o.bond_fracture_toughness / (toughness_coefficient(o) * std::sqrt(a.mean_radius));
  a.strength_factor = at_mean / o.bond_tensile_strength;
  a.tensile_per_radius = 2.0 * at_mean;
  a.shear_per_radius = 2.0 * o.bond_shear_strength * a.strength_factor;
  const Array<double> around = spread(a, spread(a, a.radius));
  a.strength_scale.resize(a.first.size());
  for (std::size_t e = 0; e < a.first.size(); ++e)
    a.strength_scale[e] = std::sqrt(a.mean_radius / (0.5 * (around[a.first[e]] + around[a.second[e]])));
  combine_factors(a, o);
}

}  // namespace hfrac
