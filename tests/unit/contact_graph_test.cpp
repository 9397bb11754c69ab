// SPDX-License-Identifier: BSD-3-Clause
// The planar graph of bonds and its faces: crossings and floaters go, wells are cut, Euler holds, areas add
// up.
#include "geom/contact_graph.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include <cmath>

#include "core/error.hpp"
#include "geom/faces.hpp"
#include "model.hpp"

namespace contact_graph_test {

using namespace testing_unit;

ContactGraph graph_of(const Discs& discs, const std::vector<Hole>& holes = {}, double tolerance = 0.05) {
  return build_contact_graph(discs.x, discs.y, discs.radius, holes, tolerance);
}

void add(Discs& discs, double x, double y, double radius) {
  discs.x.push_back(x);
  discs.y.push_back(y);
  discs.radius.push_back(radius);
}

double outer_polygon_area(const ContactGraph& graph, const Faces& faces) {
  double area = 0.0;
  for (auto k = faces.corner_start[0]; k < faces.corner_start[1]; ++k) {
    const auto following = k + 1 < faces.corner_start[1] ? k + 1 : faces.corner_start[0];
    const auto i = faces.corner[k], j = faces.corner[following];
    area -= 0.5 * (graph.x[i] * graph.y[j] - graph.x[j] * graph.y[i]);  // the outside is walked clockwise
  }
  return area;
}

TEST(ContactGraph, LatticeHasItsBondsAndFaces) {
  const ContactGraph graph = graph_of(square_lattice(5, 4, 0.5));
  const Faces faces = build_faces(graph);
  EXPECT_EQ(graph.x.size(), 20u);
  EXPECT_EQ(graph.first.size(), 31u);  // 4 x 4 across, 5 x 3 up
  EXPECT_EQ(faces.count(), 13);        // 12 pores and the outside
  for (std::int32_t f = 1; f < faces.count(); ++f) {
    EXPECT_NEAR(faces.polygon_area[f], 1.0, 1e-12);
    EXPECT_EQ(faces.corner_start[f + 1] - faces.corner_start[f], 4);
  }
  for (std::size_t e = 0; e < graph.first.size(); ++e) EXPECT_LT(graph.first[e], graph.second[e]);
}

TEST(ContactGraph, EdgesGoByTilesOfDiscs) {
  const ContactGraph graph = graph_of(square_lattice(40, 40, 0.5));
  const auto tiles = static_cast<std::int32_t>(graph.tile_first_pair.size()) - 1;
  ASSERT_EQ(tiles, (1600 + tile_size - 1) / tile_size);
  EXPECT_EQ(graph.part_first_edge.front(), 0);
  std::set<std::pair<std::int32_t, std::int32_t>> all;
  const auto check = [&](std::int32_t part, std::int32_t tile) {
    const auto begin = graph.part_first_edge[part], end = graph.part_first_edge[part + 1];
    for (auto e = begin; e < end; ++e) {
      EXPECT_EQ(graph.first[e] / tile_size, tile);
      EXPECT_EQ(graph.second[e] / tile_size > tile, part >= tiles);
      EXPECT_TRUE(part < tiles || graph.second[e] / tile_size == graph.second[begin] / tile_size);
      EXPECT_TRUE(all.emplace(graph.first[e], graph.second[e]).second);
    }
  };
  for (std::int32_t t = 0; t < tiles; ++t) {
    check(t, t);
    for (auto pair = graph.tile_first_pair[t]; pair < graph.tile_first_pair[t + 1]; ++pair) check(pair, t);
  }
  EXPECT_EQ(graph.part_first_edge.back(), static_cast<std::int64_t>(graph.first.size()));
  EXPECT_EQ(all.size(), static_cast<std::size_t>(2 * 40 * 39));
  // Ranks and places are one to one for any count.
  for (std::int64_t count = 0; count < 40; ++count) {
    std::set<std::int64_t> places;
    for (std::int64_t rank = 0; rank < count; ++rank) places.insert(edge_at(rank, count));
    EXPECT_EQ(static_cast<std::int64_t>(places.size()), count);
    EXPECT_EQ(places.empty() ? -1 : *places.rbegin(), count - 1);
  }
}

TEST(Assembly, FindsTheBondOfTwoDiscs) {
  const ContactGraph graph = graph_of(square_lattice(40, 40, 0.5));
  const Assembly a = build_assembly(graph, Options{});
  for (std::int64_t e = 0; e < a.bond_count(); ++e) {
    EXPECT_EQ(a.bond_between(a.first[e], a.second[e]), e);
    EXPECT_EQ(a.bond_between(a.second[e], a.first[e]), e);
  }
  for (std::int32_t i = 0; i + 2 < 1600; ++i) EXPECT_EQ(a.bond_between(i, i + 2), -1);
}

TEST(Faces, LieLeftAndRightOfTheirEdges) {
  const ContactGraph graph = graph_of(square_lattice(4, 4, 0.5));
  const Faces faces = build_faces(graph);
  for (std::size_t e = 0; e < graph.first.size(); ++e) {
    const auto i = graph.first[e], j = graph.second[e];
    const Vec2 from{graph.x[i], graph.y[i]}, along = Vec2{graph.x[j], graph.y[j]} - from;
    if (faces.left[e] != 0) {
      EXPECT_GT(cross(along, faces.centroid[faces.left[e]] - from), 0.0);
    }
    if (faces.right[e] != 0) {
      EXPECT_LT(cross(along, faces.centroid[faces.right[e]] - from), 0.0);
    }
    EXPECT_NE(faces.left[e], faces.right[e]);
  }
}

TEST(Faces, OfAPackingFillItsOutline) {
  Options o;
  o.packing_disc_count = 800;
  for (const bool with_hole : {false, true}) {
    std::vector<Hole> holes;
    if (with_hole) holes.push_back({{50.0, 50.0}, 9.0});
    const ContactGraph graph = graph_of(packed(o), holes);
    const Faces faces = build_faces(graph);
    const auto n = static_cast<std::int64_t>(graph.x.size()),
               e = static_cast<std::int64_t>(graph.first.size());
    EXPECT_EQ(n - e + faces.count(), 2);
    double area = 0.0;
    for (std::int32_t f = 1; f < faces.count(); ++f) {
      EXPECT_GT(faces.polygon_area[f], 0.0);
      area += faces.polygon_area[f];
    }
    const double outline = outer_polygon_area(graph, faces);
    EXPECT_NEAR(area, outline, 1e-9 * outline);
    EXPECT_GT(outline, 0.9 * 1e4);
    for (std::size_t k = 0; k < graph.first.size(); ++k) {
      EXPECT_GE(faces.left[k], 0);
      EXPECT_LT(faces.left[k], faces.count());
      EXPECT_GE(faces.right[k], 0);
      EXPECT_LT(faces.right[k], faces.count());
    }
    // Each edge is walked once in either direction.
    EXPECT_EQ(faces.corner.size(), 2 * graph.first.size());
  }
}

TEST(ContactGraph, CrossingJoinsLoseTheWiderOne) {
  // A rhombus whose diagonals both lie within the tolerance; the one along x is the narrower.
  Discs discs;
  add(discs, -1.0, 0.0, 1.0);
  add(discs, 1.0, 0.0, 1.0);
  add(discs, 0.0, -1.1, 1.0);
  add(discs, 0.0, 1.1, 1.0);
  const ContactGraph graph = graph_of(discs, {}, 0.5);
  EXPECT_EQ(graph.removed_crossings, 1);
  ASSERT_EQ(graph.first.size(), 5u);
  for (std::size_t e = 0; e < 5; ++e) EXPECT_FALSE(graph.first[e] == 2 && graph.second[e] == 3);
  EXPECT_EQ(build_faces(graph).count(), 3);
}

TEST(ContactGraph, FloatersAndTailsGo) {
  Discs discs = square_lattice(3, 3, 0.5);
  add(discs, 10.0, 10.0, 0.5);  // alone
  add(discs, 3.5, 0.5, 0.5);    // a tail of two, held at one end only
  add(discs, 4.5, 0.5, 0.5);
  const ContactGraph graph = graph_of(discs);
  EXPECT_EQ(graph.removed_floaters, 3);
  EXPECT_EQ(graph.x.size(), 9u);
}

TEST(ContactGraph, OnlyTheLargestPieceStays) {
  Discs discs = square_lattice(4, 4, 0.5);
  const Discs small = square_lattice(2, 2, 0.5);
  for (std::size_t i = 0; i < 4; ++i) add(discs, small.x[i] + 20.0, small.y[i], 0.5);
  const ContactGraph graph = graph_of(discs);
  EXPECT_EQ(graph.x.size(), 16u);
  EXPECT_EQ(graph.removed_floaters, 4);
}

TEST(ContactGraph, WellsAreCut) {
  const Discs discs = square_lattice(9, 9, 0.5);
  const ContactGraph graph = graph_of(discs, {{{4.5, 4.5}, 1.2}});
  EXPECT_EQ(graph.removed_in_wells, 5);  // the middle and its four neighbours
  const Faces faces = build_faces(graph);
  const auto hole = face_around(graph, faces, {4.5, 4.5});
  ASSERT_GT(hole, 0);
  EXPECT_NEAR(faces.polygon_area[hole], 12.0, 1e-12);  // four by four less the corners it keeps
  EXPECT_NEAR(faces.centroid[hole].x, 4.5, 1e-12);
  EXPECT_NEAR(faces.centroid[hole].y, 4.5, 1e-12);
  EXPECT_EQ(face_around(graph, faces, {-3.0, 4.5}), -1);
}

TEST(ContactGraph, NothingCoherentIsRefused) {
  Discs discs;
  for (int i = 0; i < 6; ++i) add(discs, 5.0 * i, 0.0, 0.5);
  EXPECT_THROW(graph_of(discs), Error);
  EXPECT_THROW(graph_of(square_lattice(5, 5, 0.5), {{{2.5, 2.5}, 10.0}}), Error);
}

}  // namespace contact_graph_test
