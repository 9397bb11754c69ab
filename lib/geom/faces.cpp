// SPDX-License-Identifier: BSD-3-Clause
#include "geom/faces.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace hfrac {
namespace {

// Half-edge h = 2 e + d leaves a disc: d = 0 runs from the first to the second disc of edge e, d = 1 back.
std::int32_t disc_of(const ContactGraph& graph, std::int32_t h) {
  return (h % 2 == 0 ? graph.first : graph.second)[static_cast<std::size_t>(h / 2)];
}

// The half-edge that follows each one around the face to its left.
std::vector<std::int32_t> link_half_edges(const ContactGraph& graph) {
  const std::size_t n = graph.x.size(), count = 2 * graph.first.size();
  std::vector<std::int32_t> start(n + 1, 0), leaving(count), next(count);
  for (std::size_t h = 0; h < count; ++h) ++start[disc_of(graph, static_cast<std::int32_t>(h)) + 1];
  for (std::size_t i = 0; i < n; ++i) start[i + 1] += start[i];
  // Filling moves each start to the next one's place; they are moved back below.
  for (std::size_t h = 0; h < count; ++h)
    leaving[start[disc_of(graph, static_cast<std::int32_t>(h))]++] = static_cast<std::int32_t>(h);

  struct Spoke {
    double angle;
    std::int32_t half_edge;
  };
  std::vector<Spoke> around;
  for (std::size_t i = 0; i < n; ++i) {
    around.clear();
    for (auto k = i > 0 ? start[i - 1] : 0; k < start[i]; ++k) {
      const auto j = disc_of(graph, leaving[k] ^ 1);
      around.push_back({std::atan2(graph.y[j] - graph.y[i], graph.x[j] - graph.x[i]), leaving[k]});
    }
    std::sort(around.begin(), around.end(), [](const Spoke& a, const Spoke& b) {
      return a.angle != b.angle ? a.angle < b.angle : a.half_edge < b.half_edge;
    });
    const auto degree = around.size();
    // Coming in against half-edge h, the face on the left goes on along the next one clockwise from h.
    for (std::size_t k = 0; k < degree; ++k)
      next[around[k].half_edge ^ 1] = around[(k + degree - 1) % degree].half_edge;
  }
  return next;
}

}  // namespace

Faces build_faces(const ContactGraph& graph) {
  const std::vector<std::int32_t> next = link_half_edges(graph);
  const auto count = static_cast<std::int32_t>(next.size());
  Faces faces;
  faces.left.assign(graph.first.size(), -1);
  faces.right.assign(graph.first.size(), -1);
  const auto face_of = [&](std::int32_t h) -> std::int32_t& {
    return (h % 2 == 0 ? faces.left : faces.right)[static_cast<std::size_t>(h / 2)];
  };
  // Once around each face: its number, area and centroid. Numbers go by the lowest edge.
  std::vector<std::int32_t> begin;  // a half-edge of each face
  // As many faces as Euler says, if all is well.
  const std::size_t expected =
      graph.first.size() + 2 > graph.x.size() ? graph.first.size() + 2 - graph.x.size() : 0;
  begin.reserve(expected);
  faces.centroid.reserve(expected);
  faces.polygon_area.reserve(expected);
  std::size_t outside = 0;
  for (std::int32_t h0 = 0; h0 < count; ++h0) {
    if (face_of(h0) >= 0) continue;
    const auto face = static_cast<std::int32_t>(begin.size());
    begin.push_back(h0);
    double area = 0.0, corners = 0.0;
    Vec2 moment{}, mean{};
    const auto point = [&](std::int32_t disc) { return Vec2{graph.x[disc], graph.y[disc]}; };
    const Vec2 origin = point(disc_of(graph, h0));
    for (auto h = h0; face_of(h) < 0; h = next[h]) {
      face_of(h) = face;
      const Vec2 a = point(disc_of(graph, h)) - origin, b = point(disc_of(graph, h ^ 1)) - origin;
      const double c = cross(a, b);
      area += 0.5 * c;
      moment = moment + (c / 6.0) * (a + b);
      mean = mean + a;
      corners += 1.0;
    }
    faces.centroid.push_back(origin +
                             (std::abs(area) > 0.0 ? (1.0 / area) * moment : (1.0 / corners) * mean));
    faces.polygon_area.push_back(area);
    if (area < faces.polygon_area[outside]) outside = begin.size() - 1;
  }
  const auto euler = static_cast<std::int64_t>(graph.x.size()) -
                     static_cast<std::int64_t>(graph.first.size()) + static_cast<std::int64_t>(begin.size());
  if (euler != 2) {
    throw Error(ErrorKind::model, "the contact graph is not planar: N - E + F = " + std::to_string(euler) +
                                      " instead of 2; check the given discs for overlaps");
  }
  // The outside first, then those all edges of which lie inside a tile (they stay in the order of tiles), then the rest.
  std::vector<char> across(begin.size(), 0);
  for (std::size_t e = static_cast<std::size_t>(graph.first_cross_edge()); e < graph.first.size(); ++e)
    across[faces.left[e]] = across[faces.right[e]] = 1;
  std::vector<std::int32_t> order{static_cast<std::int32_t>(outside)};
  for (const char rest : {0, 1}) {
    for (std::size_t f = 0; f < begin.size(); ++f) {
      if (f != outside && across[f] == rest) order.push_back(static_cast<std::int32_t>(f));
    }
  }
  const auto reorder = [&order](auto& values) {
    auto sorted = values;
    for (std::size_t f = 0; f < order.size(); ++f) sorted[f] = values[order[f]];
    values.swap(sorted);
  };
  reorder(begin);
  reorder(faces.polygon_area);
  reorder(faces.centroid);
  faces.polygon_area[0] = 0.0;
  std::vector<std::int32_t> number(order.size());
  for (std::size_t f = 0; f < order.size(); ++f) number[order[f]] = static_cast<std::int32_t>(f);
  for (auto* side : {&faces.left, &faces.right}) {
    for (auto& face : *side) face = number[face];
  }
  faces.corner.reserve(static_cast<std::size_t>(count));
  faces.corner_start.reserve(begin.size() + 1);
  faces.corner_start.push_back(0);
  for (const auto h0 : begin) {
    auto h = h0;
    do {
      faces.corner.push_back(disc_of(graph, h));
      h = next[h];
    } while (h != h0);
    faces.corner_start.push_back(static_cast<std::int32_t>(faces.corner.size()));
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
