// SPDX-License-Identifier: BSD-3-Clause
// A picture straight from a simulation is the one its run folder gives, and nothing but the picture is written.
#include <gtest/gtest.h>

#include <array>
#include <iterator>

#include "file_text.h"
#include "hfrac/hfrac.h"
#include "output/run_folder.hpp"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Simulated : public VizTest {
 protected:
  Simulated() {
    hfrac_viz_view_options_init(&views, sizeof views);
    views.width = 640;
    hfrac::Definition def;
    hfrac_sim_def_set_f64(&def, "packing.disc_count", 300);
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

}  // namespace
}  // namespace hfrac::viz_test
