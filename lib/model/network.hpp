// SPDX-License-Identifier: BSD-3-Clause
// The fluid's side of the model: a domain in every pore, a pipe across every contact.
//
// What a domain stores is its content zeta: fluid taken in since the start, as a volume at reference pressure. The
// pressure follows from content and the pore's change of volume,
//     p = max(floor, p_ref + K_f (zeta + growth - dV) / V)                              (eq. 8 in total form; growth by temperature, if any)
// so mass is never lost to linearisation. dV = sum of w.u over the discs around the domain, with the very weights
// w = s1 n1 + s2 n2 by which the pressure pushes the discs (eq. 10): what the fluid loses the discs get, exactly. The
// weights are taken at bonding (small rotations).
//
// Rock whose grains give has a Biot coefficient alpha below 1: its pores push with alpha p and change by alpha times as much. At constant
// strain it stores 1 / M = porosity / K_f + (alpha - porosity) / K_s per pressure and area (Detournay and Cheng 1993).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/array.hpp"
#include "geom/faces.hpp"
#include "model/assembly.hpp"
#include "model/crack_plane.hpp"
#include "options/options.hpp"

namespace hfrac {

enum class DomainKind : std::uint8_t { rock = 0, well = 1, outside = 2 };

// What eq. 7 says of a pipe that nothing presses: r0, and its F0 over flow.half_aperture_force.
struct PipeAtRest {
  // NOLINTNEXTLINE(google-explicit-constructor): where sizes are the same everywhere r0 is all there is
  PipeAtRest(double r0, double share = 1.0) : aperture(r0), force_share(share) {}
  double aperture;  // m
  double force_share;
};

struct Network {
  // pipes, one per bond, from the domain left of (first -> second) to the one right of it
  std::vector<std::int32_t> left, right;
  // Empty in a dry model:
  Array<double> aperture;     // m, hydraulic
  Array<double> conductance;  // m2/(Pa s): w^3 / (12 eta L)
  Array<double> flow;         // m2/s, left to right, of the last flow step
  Array<double> length;       // m, of pipes; only for a fluid that thins
  // domains; 0 is the outside
  std::vector<DomainKind> kind;
  // 1: a pore of the rock that a well added later feeds; empty: none. Follows from the wells.
  std::vector<std::uint8_t> fed;
  Array<double> volume;         // m2, pore volume at bonding; of a hole well.fluid_area if it is given
  Array<double> storing;        // m2, pore volume whose fluid alone would store what fluid and grains do
  Array<double> volume_change;  // m2
  Array<double> content;        // m2
  Array<double> pressure;       // Pa
  Array<double> stiffness;      // Pa/m2: K_f / storing, 0 where the pressure is imposed
  std::vector<std::int32_t> corner_start, corner_disc;
  Array<double>
      corner_weight;  // m, (x, y) per corner: change of the domain's volume with the disc's place; dry: those of domain 0 alone
  Array<double> corner_turn;   // m2, likewise with its rotation; empty: none
  std::vector<Vec2> centroid;  // m, at bonding
  // pipes to the outside, and how far the pressure beyond each is above domain 0's: a host may say what lies there
  std::vector<std::int32_t> outer_pipe;
  Array<double> outer_excess;  // Pa
  Array<double>
      beyond;  // m2/(Pa s), per pipe: conductance of the rock behind those (boundary.flow_distance); empty or 0: none
  Array<double>
      viscosity_share;  // per pipe: viscosity over fluid.viscosity, with fluid.kind water and temperature, or two fluids; empty: 1
  Array<double> second_content;  // m2, per domain: of the second fluid in it; empty: there is none
  // with fracture.law facet (frac/facets.hpp), else empty
  Array<double> facet_offset;  // m2, per domain: of a fracture's pore before its facets open
  Array<double> facet_time;    // s, per pipe: when its bond broke
  Array<double>
      facet_worked;  // Pa, per domain: pressure up to which the work on facets is counted; explicit motion only
  double facet_pushed = 0.0;  // J/m, potential of the locked-in pushes where they began
  // with fluid.kind water and temperature (heat/water_in_pores.hpp), else empty
  Array<double> growth;  // m2, per domain: by which temperature made its fluid grow more than its void
  // These follow from the state:
  Array<double> storing_at_start;  // m2, per domain: storing at thermal.rock_temperature
  double stiffest_water = 1.0;  // bulk modulus of water at its stiffest over that at thermal.rock_temperature
  Array<double> facet_opening;  // m, per pipe: across the fracture
  Array<double> facet_way;      // m, per pipe: that a facet's fluid flows; 0: no facet
  Array<double> facet_least;    // m, per pipe: that a facet's aperture has at least
  // with joints that conduct (model/joint_pores.hpp), else empty
  Array<double> joint_length;            // m, per pipe: of the piece of a joint that it runs along
  std::vector<std::uint8_t> joint_pore;  // per domain
  double reference_pressure = 0.0, floor_pressure = 0.0;  // Pa
  double zero_stress_aperture = 0.0;  // m, r0; where discs have the assembly's mean radius
  // Of a graded packing, per pipe; else empty. Permeability goes with r0^3 / R and forces under the same stress with R, so that
  // r0 goes with the cube root of R and F0 with R: rock then has one permeability, at any stress.
  std::vector<PipeAtRest> pipe_sizes;
  double porosity_share = 1.0;  // of the rock's over the packing's
  CrackPlanes planes;           // with flow.fracture_aperture = "plane"

  // 0 in a dry model, for those who look at either.
  [[nodiscard]] double aperture_of(std::size_t pipe) const { return aperture.empty() ? 0.0 : aperture[pipe]; }
  [[nodiscard]] double flow_of(std::size_t pipe) const { return flow.empty() ? 0.0 : flow[pipe]; }
  [[nodiscard]] double conductance_of(std::size_t pipe) const {
    return conductance.empty() ? 0.0 : conductance[pipe];
  }
  [[nodiscard]] double growth_of(std::int64_t domain) const { return growth.empty() ? 0.0 : growth[domain]; }
  // What stores in it when it stores least [m2].
  [[nodiscard]] double least_storing(std::int64_t domain) const {
    return growth.empty() ? storing[domain] : storing_at_start[domain] / stiffest_water;
  }
  [[nodiscard]] PipeAtRest pipe_at_rest(std::size_t pipe) const {
    if (pipe_sizes.empty()) return zero_stress_aperture;
    return {zero_stress_aperture * pipe_sizes[pipe].aperture, pipe_sizes[pipe].force_share};
  }
  [[nodiscard]] double viscosity_share_of(std::size_t pipe) const {
    return viscosity_share.empty() ? 1.0 : viscosity_share[pipe];
  }
  // Fluid in a domain, as a volume at reference pressure [m2]: what was there at bonding and what was taken in since.
  [[nodiscard]] double fluid_in(std::size_t domain) const {
    return std::max(0.0, volume[domain] + content[domain]);
  }
  // Pressure from content without the floor of cavitation [Pa].
  [[nodiscard]] double full_pressure(std::size_t domain) const {
    return reference_pressure +
           stiffness[domain] *
               (content[domain] + growth_of(static_cast<std::int64_t>(domain)) - volume_change[domain]);
  }
  [[nodiscard]] double second_share_of(std::size_t domain) const {
    if (second_content.empty() || second_content[domain] == 0.0) return 0.0;
    const double all = fluid_in(domain);
    return all > 0.0 ? std::min(1.0, second_content[domain] / all) : 0.0;
  }
  [[nodiscard]] double beyond_of(std::size_t pipe) const { return beyond.empty() ? 0.0 : beyond[pipe]; }
  [[nodiscard]] std::int64_t domain_count() const { return static_cast<std::int64_t>(kind.size()); }
  // Whose fluid is a well's, and whose the rock's own.
  [[nodiscard]] bool is_well(std::size_t domain) const {
    return kind[domain] == DomainKind::well || (!fed.empty() && fed[domain] != 0);
  }
  [[nodiscard]] bool is_own(std::size_t domain) const {
    return kind[domain] == DomainKind::rock && !is_well(domain);
  }

  // The disc at a domain's corner k (of corner_start), and those before and after it around the domain.
  struct Corner {
    std::int32_t disc, before, after;
  };
  [[nodiscard]] Corner corner(std::int64_t domain, std::int32_t k) const {
    const auto begin = corner_start[static_cast<std::size_t>(domain)],
               end = corner_start[static_cast<std::size_t>(domain) + 1];
    const auto at = [this](std::int32_t place) { return corner_disc[static_cast<std::size_t>(place)]; };
    return {at(k), at(k > begin ? k - 1 : end - 1), at(k + 1 < end ? k + 1 : begin)};
  }
};

// `well_domain[k]` is the face of well k.
// Takes the faces over.
Network build_network(Faces faces, const Assembly& assembly, const std::vector<std::int32_t>& well_domain,
                      const Options& options);

// Content at which a domain has pressure p, given its volume change now.
inline double content_at(const Network& n, std::int64_t domain, double bulk_modulus, double p) {
  return n.volume_change[domain] - n.growth_of(domain) +
         (p - n.reference_pressure) * n.storing[domain] / bulk_modulus;
}

// Share of a domain's volume that fluid fills; 1 where the pressure is imposed. A pore at the floor may hold less than would fill it.
inline double saturation_of(const Network& n, std::int64_t domain, double bulk_modulus) {
  if (n.stiffness.empty() || n.stiffness[domain] <= 0.0) return 1.0;
  const double lacking = content_at(n, domain, bulk_modulus, n.floor_pressure) - n.content[domain];
  return std::clamp(1.0 - lacking / (n.volume[domain] + n.volume_change[domain]), 0.0, 1.0);
}

}  // namespace hfrac
