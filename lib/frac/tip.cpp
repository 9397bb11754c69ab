// SPDX-License-Identifier: BSD-3-Clause
#include "frac/tip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frac/path.hpp"

namespace hfrac {
namespace {

constexpr std::size_t most_behind = 4;  // facets whose openings give K
constexpr double widest_turn = 0.5;     // cosine

double size(Vec2 v) {
  return std::sqrt(dot(v, v));
}
}  // namespace

std::vector<Tip> find_tips(const Facets& facets, const Assembly& a, const Network& n, const Options& o) {
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
      double sum_w = 0.0, sum_s = 0.0;
      for (std::size_t k = 0; k < path.size(); ++k) {
        const Facet* f = path[k];
        const double s = std::max(dot(end - f->middle, ahead), 0.1 * a.mean_radius);
        const double push = n.pressure[f->left] * f->left_length + n.pressure[f->right] * f->right_length;
        const double w = side[k] * facets.jump(a, *f, normal) + (push - f->initial_normal) / facets.stiffness;
        sum_w += w * std::sqrt(s);
        sum_s += s;
      }
      Tip tip;
      tip.domain = domain;
      tip.intensity = o.fracture_plane_modulus / 8.0 * std::sqrt(2.0 * std::numbers::pi) * sum_w / sum_s;
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
