// SPDX-License-Identifier: BSD-3-Clause
#include "geom/faces.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace hfrac {
namespace {

// Half-edge h = 2 e + d leaves disc `from`: d = 0 runs from first to second, d = 1 back.
struct HalfEdges {
  std::vector<std::int32_t> next;  // the following half-edge around the face to the left
  std::vector<std::int32_t> from;
};

HalfEdges link_half_edges(const ContactGraph& graph) {
  const std::size_t n = graph.x.size(), edges = graph.first.size();
  HalfEdges half;
  half.from.resize(2 * edges);
  half.next.resize(2 * edges);
  std::vector<std::int32_t> start(n + 1, 0), leaving(2 * edges);
  for (std::size_t e = 0; e < edges; ++e) {
    half.from[2 * e] = graph.first[e];
    half.from[2 * e + 1] = graph.second[e];
    ++start[graph.first[e] + 1];
    ++start[graph.second[e] + 1];
  }
  for (std::size_t i = 0; i < n; ++i) start[i + 1] += start[i];
  auto cursor = start;
  for (std::size_t h = 0; h < 2 * edges; ++h) leaving[cursor[half.from[h]]++] = static_cast<std::int32_t>(h);

  std::vector<double> angle(2 * edges);
  for (std::size_t h = 0; h < 2 * edges; ++h) {
    const auto i = half.from[h], j = half.from[h ^ 1U];
    angle[h] = std::atan2(graph.y[j] - graph.y[i], graph.x[j] - graph.x[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto begin = leaving.begin() + start[i], end = leaving.begin() + start[i + 1];
    std::sort(begin, end, [&](std::int32_t a, std::int32_t b) { return angle[a] < angle[b]; });
    const auto degree = end - begin;
    // Coming in against half-edge h, the face on the left goes on along the next one clockwise from h.
    for (std::ptrdiff_t k = 0; k < degree; ++k) half.next[begin[k] ^ 1] = begin[(k + degree - 1) % degree];
  }
  return half;
}

}  // namespace

Faces build_faces(const ContactGraph& graph) {
  const HalfEdges half = link_half_edges(graph);
  const std::size_t count = half.from.size();
  struct Loop {
    std::vector<std::int32_t> half_edges;
    double area;
    Vec2 centroid;
  };
  std::vector<Loop> loops;
  std::vector<char> seen(count, 0);
  std::size_t outside = 0;
  for (std::size_t begin = 0; begin < count; ++begin) {
    if (seen[begin]) continue;
    Loop loop{{}, 0.0, {}};
    Vec2 moment{}, mean{};
    const Vec2 origin{graph.x[half.from[begin]], graph.y[half.from[begin]]};
    for (auto h = static_cast<std::int32_t>(begin); !seen[h]; h = half.next[h]) {
      seen[h] = 1;
      loop.half_edges.push_back(h);
      const Vec2 a = Vec2{graph.x[half.from[h]], graph.y[half.from[h]]} - origin;
      const Vec2 b = Vec2{graph.x[half.from[h ^ 1]], graph.y[half.from[h ^ 1]]} - origin;
      const double c = cross(a, b);
      loop.area += 0.5 * c;
      moment = moment + (c / 6.0) * (a + b);
      mean = mean + a;
    }
    loop.centroid = std::abs(loop.area) > 0.0
                        ? origin + (1.0 / loop.area) * moment
                        : origin + (1.0 / static_cast<double>(loop.half_edges.size())) * mean;
    loops.push_back(std::move(loop));
    if (loops.back().area < loops[outside].area) outside = loops.size() - 1;
  }
  const auto euler = static_cast<std::int64_t>(graph.x.size()) -
                     static_cast<std::int64_t>(graph.first.size()) + static_cast<std::int64_t>(loops.size());
  if (euler != 2) {
    throw Error(ErrorKind::model, "the contact graph is not planar: N - E + F = " + std::to_string(euler) +
                                      " instead of 2; check the given discs for overlaps");
  }
  // The outside first; the others stay sorted by their lowest edge, and so by their lowest disc.
  std::rotate(loops.begin(), loops.begin() + static_cast<std::ptrdiff_t>(outside),
              loops.begin() + static_cast<std::ptrdiff_t>(outside) + 1);

  Faces faces;
  faces.left.resize(graph.first.size());
  faces.right.resize(graph.first.size());
  faces.corner_start.push_back(0);
  for (std::size_t f = 0; f < loops.size(); ++f) {
    for (const auto h : loops[f].half_edges) {
      faces.corner.push_back(half.from[h]);
      faces.corner_edge.push_back(h / 2);
      (h % 2 == 0 ? faces.left : faces.right)[h / 2] = static_cast<std::int32_t>(f);
    }
    faces.corner_start.push_back(static_cast<std::int32_t>(faces.corner.size()));
    faces.polygon_area.push_back(f == 0 ? 0.0 : loops[f].area);
    faces.centroid.push_back(loops[f].centroid);
  }
  return faces;
}

std::int32_t face_around(const ContactGraph& graph, const Faces& faces, Vec2 point) {
  std::int32_t best = -1;
  for (std::int32_t f = 1; f < faces.count(); ++f) {
    if (best >= 0 && faces.polygon_area[f] >= faces.polygon_area[best]) continue;
    bool inside = false;
    for (auto k = faces.corner_start[f]; k < faces.corner_start[f + 1]; ++k) {
      const auto following = k + 1 < faces.corner_start[f + 1] ? k + 1 : faces.corner_start[f];
      const Vec2 a{graph.x[faces.corner[k]], graph.y[faces.corner[k]]};
      const Vec2 b{graph.x[faces.corner[following]], graph.y[faces.corner[following]]};
      if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) * (b.x - a.x) / (b.y - a.y))
        inside = !inside;
    }
    if (inside) best = f;
  }
  return best;
}

}  // namespace hfrac
