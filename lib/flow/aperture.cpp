// SPDX-License-Identifier: BSD-3-Clause
#include "flow/aperture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/give_back.hpp"
#include "flow/fluid_law.hpp"
#include "linear/conjugate_gradient.hpp"
#include "linear/sparse.hpp"
#include "linear/symmetric_factor.hpp"
#include "model/joint_pores.hpp"
#include "options/choices.hpp"
#include "solid/smooth_joints.hpp"

namespace hfrac {
namespace {

// A band of more domains than this is measured over a part of its height, in the middle of the model: permeability is a
// mean, and that of a quarter of a million pores is known to a few thousandths.
constexpr std::int32_t most_measured = 250000;

// Conductivity of the domains whose centroid lies in the band [low, high] of x, over the model's height.
// `pressure`: as measure_permeability says.
double band_permeability(const Network& n, const Assembly& a, double low, double high, double viscosity,
                         std::vector<double>& pressure) {
  const double edge = 2.0 * a.coarsest_radius();
  const auto domains = static_cast<std::size_t>(n.domain_count());
  std::vector<std::int32_t> unknown(domains, -1);
  const auto [y_low, y_high] = std::minmax_element(a.y.begin(), a.y.end());
  // Coarse pores along the sides of a graded packing lack too much of their pipes: it is measured within them.
  const double rim =
      a.sizes.graded() ? std::min(3.0 * a.coarsest_radius(), 0.2 * (*y_high - *y_low)) : -a.mean_radius;
  double bottom = *y_low + rim, top = *y_high - rim;
  const auto within = [&](std::size_t d) {
    return n.kind[d] == DomainKind::rock && n.centroid[d].y >= bottom && n.centroid[d].y <= top;
  };
  const auto inner = [&](std::size_t d) {
    return within(d) && n.centroid[d].x > low + edge && n.centroid[d].x < high - edge;
  };
  std::int64_t all = 0;
  for (std::size_t d = 1; d < domains; ++d) all += inner(d) ? 1 : 0;
  if (all > most_measured) {
    const double middle = 0.5 * (bottom + top),
                 half = 0.5 * (top - bottom) * static_cast<double>(most_measured) / static_cast<double>(all);
    bottom = middle - half;
    top = middle + half;
  }
  std::int32_t count = 0;
  for (std::size_t d = 1; d < domains; ++d) {
    if (inner(d)) unknown[d] = count++;
  }
  if (count < 8) return 0.0;
  const auto imposed = [&](std::int32_t d) { return n.centroid[d].x <= low + edge ? 1.0 : 0.0; };
  const auto in_band = [&](std::int32_t d) {
    return within(static_cast<std::size_t>(d)) && n.centroid[d].x >= low - edge &&
           n.centroid[d].x <= high + edge;
  };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(count);
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    const double c = n.conductance[e];
    if (l == r || c <= 0.0 || !in_band(l) || !in_band(r)) continue;
    for (const auto& [d, other] : {std::pair{l, r}, std::pair{r, l}}) {
      if (unknown[d] < 0) continue;
      entries.emplace_back(unknown[d], unknown[d], c);
      if (unknown[other] >= 0) {
        if (unknown[d] > unknown[other])
          entries.emplace_back(unknown[d], unknown[other], -c);  // lower triangle
      } else {
        rhs[unknown[d]] += c * imposed(other);
      }
    }
  }
  // A domain without pipes would make the matrix singular: tie it to nothing with a unit entry far below the rest.
  double typical = 0.0;
  for (const auto& entry : entries) typical = std::max(typical, std::abs(entry.value()));
  for (std::int32_t d = 0; d < count; ++d) entries.emplace_back(d, d, 1e-14 * typical);
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  give_back(entries);
  Eigen::VectorXd p = Eigen::VectorXd::Zero(count);
  if (count <= largest_to_factorise) {
    const SymmetricFactor solver(matrix);
    if (!solver.succeeded()) return 0.0;
    p = solver.solve(rhs);
  } else {
    const auto span = std::max(high - low, 1e-300);
    pressure.resize(domains, -1.0);  // below 0: not known
    for (std::size_t d = 1; d < domains; ++d) {
      if (unknown[d] < 0) continue;
      p[unknown[d]] =
          pressure[d] >= 0.0 ? pressure[d] : std::clamp((high - n.centroid[d].x) / span, 0.0, 1.0);
    }
    ConjugateGradient solver;
    if (!solver.prepare(matrix) || solver.solve(rhs, p, 1e-8, 20000) < 0) return 0.0;
    for (std::size_t d = 1; d < domains; ++d) {
      if (unknown[d] >= 0) pressure[d] = p[unknown[d]];
    }
  }

  // Flow through the inlet and the distance between the mean positions of inlet and outlet domains that take part.
  double inflow = 0.0, inlet = 0.0, outlet = 0.0, inlet_weight = 0.0, outlet_weight = 0.0;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const auto l = n.left[e], r = n.right[e];
    if (!in_band(l) || !in_band(r) || (unknown[l] < 0) == (unknown[r] < 0)) continue;
    const auto fixed = unknown[l] < 0 ? l : r, open = unknown[l] < 0 ? r : l;
    const double q = n.conductance[e] * (imposed(fixed) - p[unknown[open]]);
    if (imposed(fixed) > 0.5) {
      inflow += q;
      inlet += std::abs(q) * n.centroid[fixed].x;
      inlet_weight += std::abs(q);
    } else {
      outlet += std::abs(q) * n.centroid[fixed].x;
      outlet_weight += std::abs(q);
    }
  }
  if (inlet_weight <= 0.0 || outlet_weight <= 0.0) return 0.0;
  return inflow * viscosity * (outlet / outlet_weight - inlet / inlet_weight) / (top - bottom);
}

}  // namespace

ApertureResponse aperture_response(const Options& o, PipeAtRest rest, double gap, double normal,
                                   double normal_stiffness, bool intact) {
  const double squeeze = -normal;
  ApertureResponse r{rest.aperture, 0.0};
  if (squeeze > 0.0) {
    const double half = o.flow_half_aperture_force * rest.force_share, sum = half + squeeze;
    r.aperture *= half / sum;
    r.by_gap = r.aperture / sum * normal_stiffness;
  } else if (gap > 0.0) {
    r.by_gap = intact ? o.flow_bonded_gap_factor : o.flow_gap_factor;
    r.aperture += r.by_gap * gap;
  }
  if (r.aperture > o.flow_aperture_limit) r = {o.flow_aperture_limit, 0.0};
  return r;
}

CrackApertureResponse crack_aperture_response(const Options& o, PipeAtRest rest, double opening,
                                              double normal, double normal_stiffness) {
  const double half = o.flow_half_aperture_force * rest.force_share, squeeze = std::max(0.0, -normal),
               sum = half + squeeze;
  CrackApertureResponse r{rest.aperture * half / sum, 0.0, 0.0};
  if (squeeze > 0.0) r.by_gap = r.aperture / sum * normal_stiffness;
  if (opening > 0.0) {
    r.aperture += o.flow_gap_factor * opening;
    r.by_opening = o.flow_gap_factor;
  }
  if (r.aperture > o.flow_aperture_limit) r = {o.flow_aperture_limit, 0.0, 0.0};
  return r;
}

CrackApertureResponse joint_aperture_response(const Options& o, const JointLaw& law, double opening) {
  const JointValue w = joint_aperture(law, opening);
  if (w.value > o.flow_aperture_limit) return {o.flow_aperture_limit, 0.0, 0.0};
  return {w.value, 0.0, w.slope};
}

double pipe_aperture(const Options& o, PipeAtRest rest, const NormalView& bond, bool intact) {
  return aperture_response(o, rest, bond.gap, bond.force, 0.0, intact).aperture;
}

void update_apertures(Network& n, const Assembly& a, const Options& o, Workers* workers, const Ranks& ranks) {
  constexpr std::int64_t worth_sharing = 4096, grain = 64;  // pipes
  const bool closed = OuterPores{o.flow_outer} == OuterPores::closed;
  const FluidLaw law(o);
  n.planes.refresh(n, a);
  const auto update = [&](std::size_t part, std::size_t e) {
    const auto bond = [&] { return view_normal(a, o, part, static_cast<std::int64_t>(e)); };
    const double joint = joint_opening(a, static_cast<std::int64_t>(e));
    const CrackPlane* plane = n.planes.of(e);
    const double way = n.facet_way.empty() ? 0.0 : n.facet_way[e];
    const double length = way > 0.0 ? way : pipe_length(n, a, e);
    double w;
    if (way > 0.0) {  // of a facet
      w = std::max(n.facet_least[e],
                   aperture_response(o, n.pipe_at_rest(e), n.facet_opening[e], 0.0, 0.0, false).aperture);
    } else if (const SmoothContact* contact = flowing_contact(n, a, e)) {
      w = joint_aperture_response(o, a.smooth.law_of(*contact), smooth_opening(a, *contact)).aperture;
    } else if (joint > 0.0) {
      w = aperture_response(o, n.pipe_at_rest(e), joint, 0.0, 0.0, false).aperture;
    } else if (plane != nullptr) {
      w = crack_aperture_response(o, n.pipe_at_rest(e), CrackPlanes::opening(*plane, a, e), bond().force, 0.0)
              .aperture;
    } else {
      w = pipe_aperture(o, n.pipe_at_rest(e), bond(), a.intact[e] != 0);
    }
    n.aperture[e] = w;
    if (!n.length.empty()) n.length[e] = length;
    const bool shut = n.left[e] == n.right[e] || (closed && (n.left[e] == 0 || n.right[e] == 0));
    n.conductance[e] =
        shut ? 0.0
             : FluidLaw::in_series(law.respond(w, length, n.pressure[n.left[e]] - n.pressure[n.right[e]],
                                               n.viscosity_share_of(e)),
                                   n.beyond_of(e))
                   .conductance;
  };
  const auto pipes = static_cast<std::int64_t>(n.left.size());
  const auto update_from = [&](std::int64_t first, std::int64_t last) {
    if (first >= last) return;
    std::size_t part = a.part_of(first);
    for (auto e = first; e < last; ++e) {
      while (a.part_first_bond[part + 1] <= e) ++part;
      update(part, static_cast<std::size_t>(e));
    }
  };
  const auto mine = ranks.part(ranks.rank(), pipes, grain);
  share_items(
      workers, mine.end - mine.first,
      [&](std::int64_t first, std::int64_t last) { update_from(mine.first + first, mine.first + last); },
      worth_sharing, grain);
  for (auto* found : {&n.aperture, &n.conductance, &n.length}) {
    if (!found->empty()) ranks.gather_parts(found->data(), pipes, grain);
  }
}

double measure_permeability(const Network& n, const Assembly& a, const std::vector<WellOptions>& wells,
                            double viscosity, std::vector<double>& pressure) {
  const auto [x_low, x_high] = std::minmax_element(a.x.begin(), a.x.end());
  double left_end = *x_high, right_begin = *x_low;
  for (const auto& well : wells) {
    left_end = std::min(left_end, well.x - well.radius - 3.0 * a.mean_radius_at({well.x, well.y}));
    right_begin = std::max(right_begin, well.x + well.radius + 3.0 * a.mean_radius_at({well.x, well.y}));
  }
  double sum = 0.0, weight = 0.0;
  const auto add = [&](double low, double high) {
    if (high - low < 12.0 * a.coarsest_radius()) return;
    const double k = band_permeability(n, a, low, high, viscosity, pressure);
    if (k <= 0.0) return;
    sum += (high - low) * k;
    weight += high - low;
  };
  if (wells.empty()) {
    add(*x_low, *x_high);
  } else {
    add(*x_low, left_end);
    add(right_begin, *x_high);
  }
  if (weight == 0.0) add(*x_low - a.coarsest_radius(), *x_high + a.coarsest_radius());
  return weight > 0.0 ? sum / weight : 0.0;
}

void calibrate_aperture(Network& n, const Assembly& a, const Options& o,
                        const std::vector<WellOptions>& wells, std::vector<double>& pressure) {
  if (o.flow_zero_stress_aperture > 0.0) {
    n.zero_stress_aperture = o.flow_zero_stress_aperture;
    update_apertures(n, a, o);
    return;
  }
  // k = C r0^3 / R_mean with C near 0.032 starts it; k goes with r0^3, so one correction is exact unless gaps count.
  n.zero_stress_aperture = std::cbrt(o.flow_permeability * a.mean_radius / 0.032);
  for (int round = 0; round < 4; ++round) {
    update_apertures(n, a, o);
    const double k = measure_permeability(n, a, wells, o.fluid_viscosity, pressure);
    if (k <= 0.0 || o.flow_permeability <= 0.0) break;
    const double factor = std::cbrt(o.flow_permeability / k);
    n.zero_stress_aperture *= factor;
    if (std::abs(factor - 1.0) < 1e-7) break;
  }
  update_apertures(n, a, o);
}

}  // namespace hfrac
