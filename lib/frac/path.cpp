// SPDX-License-Identifier: BSD-3-Clause
#include "frac/path.hpp"

#include <algorithm>
#include <cmath>

namespace hfrac {
namespace {

constexpr int fewest_ahead = 3, most_ahead = 5;  // bonds of a way
constexpr double straightness = 2.0;             // metres of the way that a mean metre off the line is worth

struct Search {
  const Facets& facets;
  const Assembly& assembly;
  const Network& network;
  const Line& line;
  std::vector<std::int32_t> passed;  // pores
  std::vector<std::int64_t> cut;     // bonds on the way there
  std::int64_t kept;                 // bonds of each disc
  double best = -1e300;
  std::int64_t first = -1;  // bond of the best way

  [[nodiscard]] double progress(std::int32_t pore) const {
    return dot(network.centroid[pore] - line.through, line.along);
  }
  [[nodiscard]] double off_line(Vec2 at) const { return std::abs(cross(line.along, at - line.through)); }
  // Whether a disc would be left with fewer bonds than it is to keep.
  [[nodiscard]] bool frees(std::int64_t bond) const {
    const auto loose = [&](std::int32_t disc) {
      const auto& bonds = facets.bonds_of_disc(disc);
      const auto left = std::count_if(bonds.begin(), bonds.end(), [&](std::int32_t e) {
        return e != bond && assembly.intact[e] != 0 && std::find(cut.begin(), cut.end(), e) == cut.end();
      });
      return left < kept;
    };
    return loose(assembly.first[bond]) || loose(assembly.second[bond]);
  }
  // Goes on from the last pore passed; `off`: sum of what its pores are off the line [m].
  void look(std::int64_t by, int depth, double off) {
    const auto at = passed.back();
    if (depth >= fewest_ahead) {
      const double score = progress(at) - straightness * off / depth;
      if (score > best) {
        best = score;
        first = by;
      }
    }
    if (depth == most_ahead) return;
    for (const auto e : facets.bonds_of(at)) {
      if (assembly.intact[e] == 0 || frees(e)) continue;
      const auto next = network.left[e] == at ? network.right[e] : network.left[e];
      if (network.kind[next] != DomainKind::rock || facets.fractured(next)) continue;
      if (std::find(passed.begin(), passed.end(), next) != passed.end()) continue;
      passed.push_back(next);
      cut.push_back(e);
      // Through the bond as well as into the pore behind it: at a hole's wall many bonds lead to pores near the line.
      const double here = std::max(off_line(facets.contact(e)), off_line(network.centroid[next]));
      look(depth == 0 ? e : by, depth + 1, off + here);
      passed.pop_back();
      cut.pop_back();
    }
  }
};

}  // namespace

std::int64_t straightest(const Facets& facets, const Assembly& assembly, const Network& network,
                         std::int32_t from, const Line& line, const std::vector<std::int32_t>& passed,
                         const std::vector<std::int64_t>& cut, std::int64_t kept) {
  Search search{facets, assembly, network, line, passed, cut, kept};
  search.passed.push_back(from);
  search.look(-1, 0, 0.0);
  return search.first;
}

namespace {

// As far as it gets; one that leaves discs more than a bond each gets there or is none.
std::vector<std::int64_t> way_into(const Facets& facets, const Assembly& assembly, const Network& network,
                                   const WellPlace& well, const Line& line, double reach, std::int64_t kept) {
  std::vector<std::int64_t> bonds;
  std::vector<std::int32_t> passed;
  for (std::int32_t at = well.domain;;) {
    const auto bond = straightest(facets, assembly, network, at, line, passed, bonds, kept);
    if (bond < 0 && kept > 1) return {};
    if (bond < 0) return bonds;
    bonds.push_back(bond);
    passed.push_back(at);
    at = network.left[bond] == at ? network.right[bond] : network.left[bond];
    if (dot(network.centroid[at] - line.through, line.along) >= reach) return bonds;
  }
}

// Largest share of a bond's normal along the line; of no bonds more than any.
double steepest(const Assembly& assembly, const std::vector<std::int64_t>& bonds, const Line& line) {
  double most = bonds.empty() ? 2.0 : 0.0;
  for (const auto e : bonds) {
    const Vec2 across = assembly.position(assembly.second[e]) - assembly.position(assembly.first[e]);
    most = std::max(most, std::abs(dot(across, line.along)) / norm(across));
  }
  return most;
}

}  // namespace

std::vector<std::int64_t> perforation(const Facets& facets, const Assembly& assembly, const Network& network,
                                      const WellPlace& well, Vec2 way, double length) {
  const Line line{well.centre, way};
  const double reach = well.equivalent_radius + length;
  const auto any = way_into(facets, assembly, network, well, line, reach, 1),
             held = way_into(facets, assembly, network, well, line, reach, 2);
  return steepest(assembly, held, line) <= steepest(assembly, any, line) ? held : any;
}

}  // namespace hfrac
