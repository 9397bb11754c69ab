// SPDX-License-Identifier: BSD-3-Clause
#include "frac/tip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frac/path.hpp"

namespace hfrac {
namespace {

constexpr std::size_t most_behind = 4;  // facets whose openings give K
constexpr double beyond = 0.5;       // mean radii from the last pore to the tip: half way to the next contact
constexpr double widest_turn = 0.5;  // cosine
constexpr double beta_cubed = 2.0 * 15.588457268119896;  // 2 * 3^(5/2)
constexpr double shortest_time = 1e-9;                   // s

double size(Vec2 v) {
  return std::sqrt(dot(v, v));
}

// Half the way from a tip to the farthest pore of its fracture, holes included [m].
double half_length(const Facets& facets, const Assembly& a, const Network& n, std::int32_t tip) {
  double farthest = 0.0;
  std::vector<std::int32_t> pores{tip};
  std::vector<char> seen(n.kind.size(), 0);
  seen[tip] = 1;
  for (std::size_t k = 0; k < pores.size(); ++k) {
    for (const auto e : facets.bonds_of(pores[k])) {
      if (facets.of(e) < 0) continue;
      const auto next = n.left[e] == pores[k] ? n.right[e] : n.left[e];
      if (seen[next] != 0) continue;
      seen[next] = 1;
      pores.push_back(next);
      double way = size(n.centroid[next] - n.centroid[tip]);
      // To the far wall of a hole.
      if (n.kind[next] == DomainKind::well)
        for (auto c = n.corner_start[next]; c < n.corner_start[next + 1]; ++c)
          way = std::max(way, size(a.position(n.corner_disc[c]) - n.centroid[tip]));
      farthest = std::max(farthest, way);
    }
  }
  return 0.5 * farthest;
}

}  // namespace

std::vector<Tip> find_tips(const Facets& facets, const Assembly& a, const Network& n, const Options& o,
                           double time) {
  std::vector<Tip> tips;
  for (const Facet& first : facets.all()) {
    for (const auto domain : {first.left, first.right}) {
      if (n.kind[domain] != DomainKind::rock) continue;
      int broken = 0;
      for (const auto e : facets.bonds_of(domain)) broken += facets.of(e) >= 0 ? 1 : 0;
      if (broken != 1) continue;
      // Back along the fracture.
      std::vector<const Facet*> path{&first};
      std::vector<double> side{
          first.left == domain ? -1.0 : 1.0};  // its second disc is left or right of the way to the tip
      auto at = first.left == domain ? first.right : first.left;
      auto came = first.bond;
      while (path.size() < most_behind && n.kind[at] == DomainKind::rock) {
        const Facet* next = nullptr;
        for (const auto e : facets.bonds_of(at)) {
          if (e == came || facets.of(e) < 0) continue;
          const Facet& f = facets.all()[facets.of(e)];
          if (next == nullptr || facets.opening(a, n, f) > facets.opening(a, n, *next)) next = &f;
        }
        if (next == nullptr || std::find(path.begin(), path.end(), next) != path.end()) break;
        path.push_back(next);
        side.push_back(next->left == at ? -1.0 : 1.0);
        came = next->bond;
        at = next->left == at ? next->right : next->left;
      }
      const Vec2 end = n.centroid[domain];
      Vec2 ahead = end - (path.size() > 1 ? path.back()->middle
                                          : (n.kind[at] == DomainKind::rock ? n.centroid[at] : first.middle));
      ahead = (1.0 / size(ahead)) * ahead;
      Vec2 normal{-ahead.y, ahead.x};
      const double half = half_length(facets, a, n, domain) + beyond * a.mean_radius;
      const double speed = first.way / std::max(time - n.facet_time[first.bond], shortest_time);
      const double modulus = o.fracture_plane_modulus;
      const double tough = 4.0 * std::sqrt(2.0 / std::numbers::pi) * o.bond_fracture_toughness / modulus;
      const double viscous = beta_cubed * 12.0 * o.fluid_viscosity * speed / modulus;
      double by_shape = 0.0, shapes = 0.0, by_wanted = 0.0, wanted = 0.0;
      for (std::size_t k = 0; k < path.size(); ++k) {
        const Facet* f = path[k];
        const double s = std::max(dot(end - f->middle, ahead), 0.0) + beyond * a.mean_radius;
        if (k > 0 && s > half) break;
        const double push = n.pressure[f->left] * f->left_length + n.pressure[f->right] * f->right_length;
        const double w = side[k] * facets.jump(a, *f, normal) + (push - f->initial_normal) / facets.stiffness;
        const double end_of_two = std::sqrt(1.0 - std::min(0.5, 0.5 * s / half));
        const double shape = std::sqrt(s) * end_of_two;
        by_shape += w * shape;
        shapes += shape * shape;
        const double want =
            std::cbrt(tough * tough * tough * s * std::sqrt(s) + viscous * s * s) * end_of_two;
        by_wanted += w * want;
        wanted += want * want;
      }
      Tip tip;
      tip.domain = domain;
      tip.excess = by_wanted / wanted;
      tip.intensity = modulus / 8.0 * std::sqrt(2.0 * std::numbers::pi) * by_shape / shapes;
      double stress[3];
      facets.stress_around(a, n, o, domain, stress);
      // Along the plane of largest mean tension (Erdogan and Sih 1963), by the way that keeps to it best.
      const double turn =
          0.5 * std::atan2(2.0 * stress[2], stress[0] - stress[1]);  // of the largest compression
      Vec2 along{std::cos(turn), std::sin(turn)};
      if (dot(along, ahead) < 0.0) along = -1.0 * along;
      if (dot(along, ahead) < widest_turn) along = ahead;
      Vec2 base = end;
      for (const Facet* f : path) base = base + f->middle;
      base = (1.0 / static_cast<double>(path.size() + 1)) * base;
      tip.ahead = straightest(facets, a, n, domain, {base, along}, {}, {});
      tips.push_back(tip);
    }
  }
  return tips;
}

}  // namespace hfrac
