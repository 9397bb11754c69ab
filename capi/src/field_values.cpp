// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.hpp"

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "hfrac/field.h"
#include "joint_values.hpp"
#include "solid/bond_law.hpp"
#include "solid/disc_stress.hpp"

namespace hfrac::capi {
namespace {

template <class Get>
void write_bonds(const Simulation& s, double* to, Get get) {
  for (std::int64_t e = 0; e < s.assembly().bond_count(); ++e)
    to[e] = get(view_bond(s.assembly(), s.options(), e));
}

// A dry model has pipes that carry nothing.
void write_pipes(const Simulation& s, const Array<double>& values, double* to) {
  if (values.empty()) {
    std::fill(to, to + s.assembly().bond_count(), 0.0);
  } else {
    std::copy(values.begin(), values.end(), to);
  }
}

void write_saturation(const Simulation& s, double* to) {
  for (std::int64_t d = 0; d < s.network().domain_count(); ++d)
    to[d] = saturation_of(s.network(), d, s.options().fluid_bulk_modulus);
}

void write_pairs(const Array<double>& x, const Array<double>& y, double* to) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    to[2 * i] = x[i];
    to[2 * i + 1] = y[i];
  }
}

}  // namespace

void write_values(const Simulation& s, std::int32_t field, double* to) {
  const Assembly& a = s.assembly();
  const Network& n = s.network();
  switch (field) {
    case HFRAC_DISC_POSITION:
      for (std::size_t i = 0; i < a.x.size(); ++i) {
        to[2 * i] = a.x[i] + a.ux[i];
        to[2 * i + 1] = a.y[i] + a.uy[i];
      }
      return;
    case HFRAC_DISC_RADIUS:
      std::copy(a.radius.begin(), a.radius.end(), to);
      return;
    case HFRAC_DISC_DISPLACEMENT:
      for (std::size_t i = 0; i < a.x.size(); ++i) {
        to[2 * i] = a.ux[i] - s.model().start.x[i];
        to[2 * i + 1] = a.uy[i] - s.model().start.y[i];
      }
      return;
    case HFRAC_DISC_ROTATION:
      for (std::size_t i = 0; i < a.x.size(); ++i) to[i] = a.rotation[i] - s.model().start.rotation[i];
      return;
    case HFRAC_DISC_VELOCITY:
      write_pairs(a.vx, a.vy, to);
      return;
    case HFRAC_DISC_STRESS:
      find_disc_stress(s.model(), s.options(), to);
      return;
    case HFRAC_DISC_TEMPERATURE:
      if (!s.model().heat) {
        std::fill(to, to + a.disc_count(), s.options().thermal_rock_temperature);
      } else {
        std::copy(s.model().heat->disc.begin(), s.model().heat->disc.end(), to);
      }
      return;
    case HFRAC_BOND_NORMAL_FORCE:
      write_bonds(s, to, [](const BondView& b) { return b.normal_force(); });
      return;
    case HFRAC_BOND_SHEAR_FORCE:
      write_bonds(s, to, [](const BondView& b) { return b.shear_force(); });
      return;
    case HFRAC_BOND_MOMENT:
      write_bonds(s, to, [](const BondView& b) { return b.bond_moment; });
      return;
    case HFRAC_BOND_GAP:
      write_bonds(s, to, [](const BondView& b) { return b.gap; });
      return;
    case HFRAC_PIPE_APERTURE:
      write_pipes(s, n.aperture, to);
      return;
    case HFRAC_PIPE_FLOW:
      write_pipes(s, n.flow, to);
      return;
    case HFRAC_DOMAIN_PRESSURE:
      std::copy(n.pressure.begin(), n.pressure.end(), to);
      return;
    case HFRAC_DOMAIN_VOLUME:
      for (std::size_t d = 0; d < n.kind.size(); ++d) to[d] = n.volume[d] + n.volume_change[d];
      return;
    case HFRAC_DOMAIN_SATURATION:
      write_saturation(s, to);
      return;
    case HFRAC_DOMAIN_SECOND_FLUID:
      for (std::size_t d = 0; d < n.kind.size(); ++d) to[d] = n.second_share_of(d);
      return;
    case HFRAC_DOMAIN_TEMPERATURE:
      if (!s.model().heat) {
        std::fill(to, to + n.domain_count(), s.options().thermal_rock_temperature);
      } else {
        std::copy(s.model().heat->fluid.begin(), s.model().heat->fluid.end(), to);
      }
      return;
    case HFRAC_DOMAIN_CENTRE:
      for (std::size_t d = 0; d < n.kind.size(); ++d) {
        to[2 * d] = n.centroid[d].x;
        to[2 * d + 1] = n.centroid[d].y;
      }
      return;
    default:
      if (write_joint_values(s, field, to)) return;
      throw Error(ErrorKind::internal, "a field of doubles without values");
  }
}

void write_indices(const Simulation& s, std::int32_t field, std::int32_t* to) {
  const Assembly& a = s.assembly();
  const Network& n = s.network();
  const auto pairs = [&](const std::vector<std::int32_t>& p, const std::vector<std::int32_t>& q) {
    for (std::size_t e = 0; e < p.size(); ++e) {
      to[2 * e] = p[e];
      to[2 * e + 1] = q[e];
    }
  };
  switch (field) {
    case HFRAC_DISC_INTACT_BONDS:
      std::fill(to, to + a.disc_count(), 0);
      for (std::int64_t e = 0; e < a.bond_count(); ++e) {
        to[a.first[e]] += a.intact[e];
        to[a.second[e]] += a.intact[e];
      }
      return;
    case HFRAC_BOND_DISCS:
      pairs(a.first, a.second);
      return;
    case HFRAC_BOND_STATE:
      for (std::int64_t e = 0; e < a.bond_count(); ++e) to[e] = a.intact[e] != 0 ? 0 : 3;
      for (const auto& crack : s.cracks()) to[crack.bond] = static_cast<std::int32_t>(crack.mode);
      return;
    case HFRAC_PIPE_DOMAINS:
      pairs(n.left, n.right);
      return;
    case HFRAC_DOMAIN_KIND:
      for (std::size_t d = 0; d < n.kind.size(); ++d)
        to[d] = static_cast<std::int32_t>(n.is_well(d) ? DomainKind::well : n.kind[d]);
      return;
    case HFRAC_DOMAIN_OFFSET:
      std::copy(n.corner_start.begin(), n.corner_start.end() - 1, to);
      return;
    case HFRAC_DOMAIN_CORNERS:
      std::copy(n.corner_disc.begin(), n.corner_disc.end(), to);
      return;
    default:
      if (write_joint_indices(s, field, to)) return;
      throw Error(ErrorKind::internal, "a field of int32 without values");
  }
}

}  // namespace hfrac::capi
