// SPDX-License-Identifier: BSD-3-Clause
#include "solid/shear_modulus.hpp"

#include <algorithm>

#include "options/choices.hpp"

namespace hfrac {

double mean_field_shear_modulus(const Assembly& a, const Options& o) {
  if (a.bond_count() == 0) return 0.0;
  double squares = 0.0;
  for (std::int64_t bond = 0; bond < a.bond_count(); ++bond) squares += a.length(bond) * a.length(bond);
  // Bonds end at centres of discs, so the area is that between the outermost of them.
  const auto [left, right] = std::minmax_element(a.x.begin(), a.x.end());
  const auto [low, high] = std::minmax_element(a.y.begin(), a.y.end());
  const double area = (*right - *left) * (*high - *low);
  double stiffness = o.bond_normal_stiffness + o.bond_shear_stiffness;
  if (ContactMode{o.contact_mode} == ContactMode::parallel)
    stiffness += o.contact_normal_stiffness + o.contact_shear_stiffness;
  return area > 0.0 ? stiffness * squares / (8.0 * area) : 0.0;
}

}  // namespace hfrac
