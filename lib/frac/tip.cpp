// SPDX-License-Identifier: BSD-3-Clause
#include "frac/tip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frac/path.hpp"
#include "model/joint_pores.hpp"

namespace hfrac {
namespace {

constexpr std::size_t most_behind = 4;  // facets whose openings give K
constexpr double beyond = 0.5;       // mean radii from the last pore to the tip: half way to the next contact
constexpr double widest_turn = 0.5;  // cosine
constexpr double beta_cubed = 2.0 * 15.588457268119896;  // 2 * 3^(5/2)
constexpr double shortest_time = 1e-9;                   // s

// Half the way from a tip to the farthest pore of its fracture, holes included [m]. `seen` by domain, 0 before and after.
double half_length(const Facets& facets, const Assembly& a, const Network& n, std::int32_t tip,
                   std::vector<char>& seen) {
  double farthest = 0.0;
  std::vector<std::int32_t> pores{tip};
  seen[tip] = 1;
  for (std::size_t k = 0; k < pores.size(); ++k) {
    for (const auto e : facets.bonds_of(pores[k])) {
      if (facets.of(e) < 0) continue;
      const auto next = n.left[e] == pores[k] ? n.right[e] : n.left[e];
      if (seen[next] != 0) continue;
      seen[next] = 1;
      pores.push_back(next);
      double way = norm(n.centroid[next] - n.centroid[tip]);
      // To the far wall of a hole.
      if (n.kind[next] == DomainKind::well)
        for (auto c = n.corner_start[next]; c < n.corner_start[next + 1]; ++c)
          way = std::max(way, norm(a.position(n.corner_disc[c]) - n.centroid[tip]));
      farthest = std::max(farthest, way);
    }
  }
  for (const auto pore : pores) seen[pore] = 0;
  return 0.5 * farthest;
}

// Whether a joint that holds no more touches one of a pore's discs.
bool beside_joint(const Facets& facets, const Assembly& a, const Network& n, std::int32_t pore) {
  for (auto k = n.corner_start[pore]; k < n.corner_start[pore + 1]; ++k)
    for (const auto e : facets.bonds_of_disc(n.corner_disc[k]))
      if (a.intact[e] == 0 && a.smooth.of(e) != nullptr) return true;
  return false;
}

// The last facets of a fracture, from a tip on.
struct Path {
  std::vector<const Facet*> facets;
  std::vector<double> side;  // -1, 1: a facet's second disc is left, right of the way to the tip
  Vec2 end;                  // m, last pore
  Vec2 ahead;                // unit, from the farthest of the facets to it
};

Path path_behind(const Facets& facets, const Assembly& a, const Network& n, const Facet& last,
                 std::int32_t tip) {
  Path path{{&last}, {last.left == tip ? -1.0 : 1.0}, n.centroid[tip], {}};
  auto at = last.left == tip ? last.right : last.left;
  auto came = last.bond;
  while (path.facets.size() < most_behind && n.kind[at] == DomainKind::rock) {
    const Facet* next = nullptr;  // the widest
    for (const auto e : facets.bonds_of(at)) {
      if (e == came || facets.of(e) < 0) continue;
      const Facet& f = facets.all()[facets.of(e)];
      if (next == nullptr || facets.opening(a, n, f) > facets.opening(a, n, *next)) next = &f;
    }
    if (next == nullptr || std::find(path.facets.begin(), path.facets.end(), next) != path.facets.end())
      break;
    path.facets.push_back(next);
    path.side.push_back(next->left == at ? -1.0 : 1.0);
    came = next->bond;
    at = next->left == at ? next->right : next->left;
  }
  Vec2 from = path.facets.back()->middle;
  if (path.facets.size() == 1 && n.kind[at] == DomainKind::rock) from = n.centroid[at];
  path.ahead = (1.0 / norm(path.end - from)) * (path.end - from);
  return path;
}

// Openings behind the tip against those of K = 1 and of a tip that goes on at this speed [m/s], by least squares.
void measure(const Path& path, const Facets& facets, const Assembly& a, const Network& n, const Options& o,
             double speed, std::vector<char>& seen, Tip& tip) {
  const Vec2 normal{-path.ahead.y, path.ahead.x};
  const double half = half_length(facets, a, n, tip.domain, seen) + beyond * a.mean_radius_at(path.end);
  const double modulus = o.fracture_plane_modulus;
  const double tough = 4.0 * std::sqrt(2.0 / std::numbers::pi) * o.bond_fracture_toughness / modulus;
  const double viscosity =
      o.fluid_viscosity * n.viscosity_share_of(static_cast<std::size_t>(path.facets.front()->bond));
  const double viscous = beta_cubed * 12.0 * viscosity * speed / modulus;
  double by_shape = 0.0, shapes = 0.0, by_wanted = 0.0, wanted = 0.0;
  for (std::size_t k = 0; k < path.facets.size(); ++k) {
    const Facet& f = *path.facets[k];
    const double s =
        std::max(dot(path.end - f.middle, path.ahead), 0.0) + beyond * a.mean_radius_at(path.end);
    if (k > 0 && s > half) break;
    const double push = n.pressure[f.left] * f.left_length + n.pressure[f.right] * f.right_length;
    const double w =
        path.side[k] * facets.jump(a, f, normal) + (push - f.initial_normal) / facets.start().stiffness;
    const double of_whole = std::sqrt(1.0 - std::min(0.5, 0.5 * s / half));
    const double shape = std::sqrt(s) * of_whole;
    by_shape += w * shape;
    shapes += shape * shape;
    const double want = std::cbrt(tough * tough * tough * s * std::sqrt(s) + viscous * s * s) * of_whole;
    by_wanted += w * want;
    wanted += want * want;
  }
  tip.intensity = modulus / 8.0 * std::sqrt(2.0 * std::numbers::pi) * by_shape / shapes;
  tip.excess = by_wanted / wanted;
}

// The bond ahead along the plane of largest mean tension (Erdogan and Sih 1963), by the way that keeps to it best. Beside a joint the mean
// would be taken over both of its sides: there the tip keeps its direction.
std::int64_t bond_ahead(const Path& path, const Facets& facets, const Assembly& a, const Network& n,
                        const Options& o, std::int32_t tip) {
  Vec2 along = path.ahead;
  if (!beside_joint(facets, a, n, tip)) {
    double stress[3];
    facets.stress_around(a, n, o, tip, stress);
    const double turn =
        0.5 * std::atan2(2.0 * stress[2], stress[0] - stress[1]);  // of the largest compression
    along = {std::cos(turn), std::sin(turn)};
    if (dot(along, path.ahead) < 0.0) along = -1.0 * along;
    if (dot(along, path.ahead) < widest_turn) along = path.ahead;
  }
  Vec2 base = path.end;
  for (const Facet* f : path.facets) base = base + f->middle;
  base = (1.0 / static_cast<double>(path.facets.size() + 1)) * base;
  return straightest(facets, a, n, tip, {base, along}, {}, {});
}

}  // namespace

std::vector<Tip> find_tips(const Facets& facets, const Assembly& a, const Network& n, const Options& o,
                           double time) {
  std::vector<Tip> tips;
  std::vector<char> seen(n.kind.size(), 0);
  for (const Facet& last : facets.all()) {
    for (const auto domain : {last.left, last.right}) {
      if (n.kind[domain] != DomainKind::rock) continue;
      const auto& bonds = facets.bonds_of(domain);
      if (std::count_if(bonds.begin(), bonds.end(), [&](auto e) { return facets.of(e) >= 0; }) != 1) continue;
      if (joint_passes(n, a, domain)) continue;
      const Path path = path_behind(facets, a, n, last, domain);
      const double speed = last.way / std::max(time - n.facet_time[last.bond], shortest_time);
      Tip tip;
      tip.domain = domain;
      measure(path, facets, a, n, o, speed, seen, tip);
      tip.ahead = bond_ahead(path, facets, a, n, o, domain);
      tips.push_back(tip);
    }
  }
  return tips;
}

}  // namespace hfrac
