// SPDX-License-Identifier: BSD-3-Clause
// Graded packings: discs as large as their place says, as dense, connected and at rest as in a uniform packing, and what lengths of the
// model go with the discs around a place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "model.hpp"

namespace graded_packing_test {

using namespace testing_unit;

Options graded(std::int64_t discs, double coarsening = 4.0) {
  Options o = dry_options(discs);
  o.model_width = o.model_height = 100.0;
  o.packing_coarsening = coarsening;
  o.packing_fine_half_length = 25.0;
  o.packing_fine_half_width = 8.0;
  return o;
}

Grading asked(const Options& o) {
  CaseDefinition definition;
  definition.options = o;
  return grading_of(definition);
}

// What is found around the discs of a band of mean radii, R_f times `from` to `to`, three radii and more inside the sides.
struct Band {
  double discs = 0.0, radius = 0.0, coordination = 0.0,
         overlap = 0.0;  // the last three: means; over R, 1, over R
};
Band band(const Options& o, const Discs& discs, double from, double to) {
  const ContactGraph graph = build_contact_graph(discs.x, discs.y, discs.radius, {}, 0.05, {}, discs.sizes);
  std::vector<double> bonds(graph.x.size(), 0.0);
  Band b;
  double touching = 0.0;
  const auto takes = [&](std::size_t i) {
    const Vec2 at{graph.x[i], graph.y[i]};
    const double size = graph.sizes.at(at),
                 inside = std::min({at.x, o.model_width - at.x, at.y, o.model_height - at.y});
    return size >= from * graph.sizes.fine && size <= to * graph.sizes.fine && inside > 3.0 * size;
  };
  for (std::size_t e = 0; e < graph.first.size(); ++e) {
    const auto i = static_cast<std::size_t>(graph.first[e]), j = static_cast<std::size_t>(graph.second[e]);
    bonds[i] += 1.0;
    bonds[j] += 1.0;
    const double gap =
        std::hypot(graph.x[j] - graph.x[i], graph.y[j] - graph.y[i]) - graph.radius[i] - graph.radius[j];
    if (!takes(i) || gap >= 0.0) continue;
    b.overlap -= gap / graph.sizes.at({graph.x[i], graph.y[i]});
    touching += 1.0;
  }
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    if (!takes(i)) continue;
    b.discs += 1.0;
    b.radius += graph.radius[i] / graph.sizes.at({graph.x[i], graph.y[i]});
    b.coordination += bonds[i];
  }
  b.radius /= b.discs;
  b.coordination /= b.discs;
  b.overlap /= touching;
  return b;
}

TEST(Grading, GrowsWithTheDistanceToALineThroughEveryWell) {
  CaseDefinition definition;
  definition.options = graded(4000);
  definition.options.packing_fine_azimuth = 0.5 * pi;
  definition.wells.push_back({30.0, 50.0, 2.0});
  definition.wells.push_back({70.0, 50.0, 2.0});
  const Grading g = grading_of(definition);
  EXPECT_NEAR(g.distance({30.0, 74.0}), 0.0, 1e-12);
  EXPECT_NEAR(g.distance({44.0, 40.0}), 14.0, 1e-12);
  EXPECT_NEAR(g.distance({73.0, 79.0}), 5.0, 1e-12);  // beyond the end of the line
  EXPECT_DOUBLE_EQ(g.at({37.9, 50.0}), g.fine);
  EXPECT_NEAR(g.at({45.0, 50.0}), g.fine + 0.1 * 7.0, 1e-12);
  EXPECT_DOUBLE_EQ(g.at({0.0, 0.0}), std::min(4.0 * g.fine, g.fine + 0.1 * (std::hypot(30.0, 25.0) - 8.0)));
}

TEST(Grading, OfNoCoarseningIsTheUniformPacking) {
  const Options o = graded(1000, 1.0);
  const Grading g = asked(o);
  EXPECT_FALSE(g.graded());
  EXPECT_DOUBLE_EQ(g.fine, expected_mean_radius(o));
  Options plain = dry_options(1000);
  plain.model_width = plain.model_height = 100.0;
  EXPECT_TRUE(same_bits(packed(o).x, packed(plain).x));
}

TEST(GradedPacking, FillsTheModelWithTheDiscsAskedFor) {
  const Options o = graded(3000);
  const Discs discs = packed(o);
  ASSERT_EQ(discs.x.size(), 3000u);
  double solid = 0.0;
  for (const double r : discs.radius) solid += pi * r * r;
  EXPECT_NEAR(1.0 - solid / 1e4, o.packing_porosity, 1e-12);
  // The radius foreseen is the one that comes out, and spread around it is that of the uniform packing.
  EXPECT_NEAR(discs.sizes.fine / asked(o).fine, 1.0, 0.01);
  EXPECT_NEAR(discs.sizes.coarsest() / discs.sizes.fine, 4.0, 1e-12);
  int off = 0;  // discs that moved far in the last relaxation
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const double share = discs.radius[i] / discs.sizes.at({discs.x[i], discs.y[i]});
    off += share < 0.9 * 2.0 / 3.7 || share > 1.1 * 5.4 / 3.7 ? 1 : 0;
    EXPECT_GT(std::min({discs.x[i], discs.y[i], 100.0 - discs.x[i], 100.0 - discs.y[i]}),
              0.8 * discs.radius[i]);
  }
  EXPECT_LT(off, 15);
}

TEST(GradedPacking, IsSimilarToItselfEverywhere) {
  constexpr double seeds = 3.0;
  Band fine, between, coarse, uniform;
  const auto add = [](Band& to, const Band& b) {
    to.discs += b.discs / seeds;
    to.radius += b.radius / seeds;
    to.coordination += b.coordination / seeds;
    to.overlap += b.overlap / seeds;
  };
  for (std::int64_t seed = 1; seed <= 3; ++seed) {
    Options o = graded(2000), plain = graded(2000, 1.0);
    o.model_seed = plain.model_seed = seed;
    const Discs discs = packed(o);
    Discs same = packed(plain);
    same.sizes = asked(plain);
    add(fine, band(o, discs, 0.0, 1.0));
    add(between, band(o, discs, 1.0001, 3.9999));
    add(coarse, band(o, discs, 3.9999, 5.0));
    add(uniform, band(plain, same, 0.0, 5.0));
  }
  for (const Band* b : {&fine, &between, &coarse}) {
    EXPECT_GT(b->discs, 200.0);
    EXPECT_NEAR(b->radius, 1.0, 0.03);
    EXPECT_NEAR(b->coordination / uniform.coordination, 1.0, 0.03);
    EXPECT_LT(b->overlap / uniform.overlap, 1.5);  // as in packing_test.cpp for tiled and grown packings
  }
}

TEST(GradedPacking, DependsOnTheSeedAlone) {
  Options o = graded(800);
  const Discs one = packed(o), again = packed(o);
  EXPECT_TRUE(same_bits(one.x, again.x));
  EXPECT_TRUE(same_bits(one.y, again.y));
  EXPECT_TRUE(same_bits(one.radius, again.radius));
  o.model_seed = 2;
  EXPECT_FALSE(same_bits(one.x, packed(o).x));
}

TEST(GradedPacking, HasOneToughnessAndOnePermeability) {
  Options o = graded(2000);
  o.bond_fracture_toughness = 2e6;
  const TestModel tough(o, packed(o));
  o.bond_fracture_toughness = 0.0;
  o.bond_toughness_reference_radius = 1.0;
  o.bond_tensile_strength = 40e6;
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  TestModel scaled(o, packed(o));
  scaled.network.zero_stress_aperture = 1e-5;
  double sum = 0.0;
  for (std::int64_t e = 0; e < tough.assembly.bond_count(); ++e) {
    const double size = std::sqrt(tough.assembly.mean_radius_of(e));
    const auto strength = [e](const Assembly& a) { return a.tensile_capacity(e) / (2.0 * a.bond_radius(e)); };
    // With bond.fracture_toughness R is that of the discs around the bond, with a reference radius what is wanted there.
    sum += strength(tough.assembly) * size / (2e6 / toughness_coefficient(o));
    EXPECT_NEAR(strength(scaled.assembly) * size, 40e6, 1.0);
    const PipeAtRest pipe = scaled.network.pipe_at_rest(static_cast<std::size_t>(e));
    const double share = size * size / scaled.assembly.mean_radius;
    EXPECT_NEAR(pipe.force_share, share, 1e-12);
    EXPECT_NEAR(std::pow(pipe.aperture / scaled.network.zero_stress_aperture, 3), share, 1e-12 * share);
  }
  EXPECT_NEAR(sum / static_cast<double>(tough.assembly.bond_count()), 1.0, 0.03);
}

std::string refusal(const CaseDefinition& definition) {
  try {
    validate(definition);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(GradedPacking, RefusesWhatMakesNoSense) {
  CaseDefinition definition;
  definition.options = graded(4000);
  definition.options.stress_sigma_Hmax = 33e6;
  definition.options.stress_sigma_hmin = 25e6;
  EXPECT_EQ(refusal(definition), "");
  for (const auto method : {PackingMethod::tiled, PackingMethod::growth, PackingMethod::square}) {
    definition.options.packing_method = choice(method);
    EXPECT_NE(refusal(definition).find("packing.method = \"relaxed\" only"), std::string::npos);
  }
  definition.options.packing_method = choice(PackingMethod::relaxed);
  // A hole may be as small as the discs around it allow.
  definition.wells.push_back({50.0, 50.0, 1.0});
  EXPECT_EQ(refusal(definition), "");
  definition.options.packing_coarsening = 1.0;
  EXPECT_NE(refusal(definition).find("mean disc radii"), std::string::npos);
}

}  // namespace graded_packing_test
