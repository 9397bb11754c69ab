// SPDX-License-Identifier: BSD-3-Clause
// A picture straight from a simulation is the one its run folder gives, and nothing but the picture is written.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>

#include "file_text.h"
#include "hfrac/hfrac.h"
#include "output/run_folder.hpp"
#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Simulated : public VizTest {
 protected:
  Simulated() {
    hfrac_viz_view_options_init(&views, sizeof views);
    views.width = 640;
    hfrac::Definition def;
    EXPECT_EQ(hfrac_sim_def_set_i64(&def, "packing.disc_count", 300), HFRAC_OK);
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
    EXPECT_GE(hfrac_step(sim, 1), 0);
  }
  ~Simulated() override { hfrac_sim_destroy(&sim); }

  Result draw(const char* target) {
    return result_of(hfrac_viz_render_sim(sim, names.data(), static_cast<std::int32_t>(names.size()),
                                          file(target).c_str(), &views));
  }

  std::array<const char*, 4> names = {"discs", "pressure", "stress", "forces"};
  hfrac_viz_view_options views;
  hfrac_sim* sim = nullptr;
};

TEST_F(Simulated, ItsPictureIsThatOfItsRunFolder) {
  const Result result = draw("straight.png");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder()), {}), 1);
  output::RunFolder(folder()).open(sim);
  ASSERT_EQ(hfrac_viz_render_views(folder().c_str(), names.data(), static_cast<std::int32_t>(names.size()),
                                   file("folder.png").c_str(), &views),
            HFRAC_OK)
      << last_error();
  EXPECT_EQ(file_text(file("straight.png")), file_text(file("folder.png")));
}

// Its wall follows discs, and a pore that was made a well has none.
TEST_F(Simulated, AHoleIsRingedAsItWasAskedFor) {
  hfrac_sim_destroy(&sim);
  hfrac::Definition def;
  ASSERT_EQ(hfrac_sim_def_set_i64(&def, "packing.disc_count", 300), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].radius", 12.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "well[0].pressure", 1e6), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK);
  int32_t index = 0;
  ASSERT_EQ(hfrac_well_add(sim, 80.0, 70.0, &index), HFRAC_OK);
  views.width = 1600;
  const std::array<const char*, 1> one = {"pressure"};
  const auto ringed = [&](const char* target) {
    const Picture picture = read_picture(file(target));
    const FramedView view = find_view(picture, 100.0, 100.0);
    int found = 0;
    for (int k = 0; k < 64; ++k) {
      const double angle = 2.0 * std::acos(-1.0) * (k + 0.5) / 64;
      bool red = false;
      for (double r = 11.7; r < 12.3; r += 0.1)
        red = red ||
              picture.at(view.x(50.0 + r * std::cos(angle)), view.y(50.0 + r * std::sin(angle))).is_red();
      found += red ? 1 : 0;
    }
    return found;
  };
  ASSERT_EQ(hfrac_viz_render_sim(sim, one.data(), 1, file("straight.png").c_str(), &views), HFRAC_OK)
      << last_error();
  EXPECT_GE(ringed("straight.png"), 60);
  output::RunFolder(folder()).open(sim);
  ASSERT_EQ(hfrac_viz_render_views(folder().c_str(), one.data(), 1, file("folder.png").c_str(), &views),
            HFRAC_OK)
      << last_error();
  EXPECT_GE(ringed("folder.png"), 60);
}

}  // namespace
}  // namespace hfrac::viz_test
