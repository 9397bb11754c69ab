// SPDX-License-Identifier: BSD-3-Clause
// Views of quantities, and parts of the model, for a run known in closed form.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "picture_file.h"
#include "run/views.hpp"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Views : public VizTest {
 protected:
  Views() { hfrac_viz_view_options_init(&views, sizeof views); }

  Result render_views(const std::vector<const char*>& kinds) {
    return result_of(hfrac_viz_render_views(folder().c_str(), kinds.data(),
                                            static_cast<std::int32_t>(kinds.size()), file("view.png").c_str(),
                                            &views));
  }
  Picture picture() const { return read_picture(file("view.png")); }

  hfrac_viz_view_options views;
};

bool reddish(Pixel p) {
  return p.red > p.blue + 40;
}
bool bluish(Pixel p) {
  return p.blue > p.red + 40;
}

// But for temperatures and joints, which have tests of their own below.
TEST_F(Views, EveryKindIsDrawnAloneAndNineTogether) {
  write_run(folder(), run);
  std::vector<const char*> nine;
  views.width = 700;
  for (const hfrac::run::NamedView& view : hfrac::run::all_views()) {
    if (view.array == "temperature_K" || view.mesh == "joints") continue;
    const char* kind = view.name.data();
    const Result result = render_views({kind});
    ASSERT_EQ(result.status, HFRAC_OK) << kind << ": " << result.text;
    EXPECT_EQ(picture().width, 700);
    if (nine.size() < 9) nine.push_back(kind);
  }
  views.width = 1600;
  const Result result = render_views(nine);
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_EQ(picture().width, 1600);
}

TEST_F(Views, TheUserGuideNamesEach) {
  std::ifstream file(HFRAC_USER_GUIDE);
  const std::string guide(std::istreambuf_iterator<char>(file), {});
  const auto start = guide.find("\nViews: "), end = guide.find("\n\n", start);
  ASSERT_NE(end, std::string::npos);
  std::set<std::string> words;
  std::string word;
  for (const char c : guide.substr(start, end - start)) {
    if (std::islower(static_cast<unsigned char>(c)) != 0 || c == '-') {
      word += c;
    } else {
      words.insert(std::exchange(word, {}));
    }
  }
  for (const hfrac::run::NamedView& view : hfrac::run::all_views())
    EXPECT_EQ(words.count(std::string(view.name)), 1U)
        << view.name << " is not in the list \"Views:\" of the user guide";
}

TEST_F(Views, StressIsRedWherePressedAndBlueWherePulled) {
  write_run(folder(), run);
  const Result result = render_views({"stress"});
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture drawn = picture();
  const FramedView view = find_view(drawn, run.width, run.height);
  EXPECT_TRUE(reddish(drawn.at(view.x(1.75), view.y(9.75))));
  EXPECT_TRUE(bluish(drawn.at(view.x(10.25), view.y(9.75))));
  EXPECT_GT(drawn.share(view.x(1), view.y(11), view.x(4), view.y(8), reddish), 0.6);
  EXPECT_GT(drawn.share(view.x(8), view.y(11), view.x(11), view.y(8), bluish), 0.6);
}

TEST_F(Views, TemperatureIsDarkAtTheWellAndLightFarAway) {
  run.with_temperature = true;
  write_run(folder(), run);
  const Result result = render_views({"temperature"});
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture drawn = picture();
  const FramedView view = find_view(drawn, run.width, run.height);
  const auto brightness = [&](double x, double y) {
    const Pixel pixel = drawn.at(view.x(x), view.y(y));
    return pixel.red + pixel.green + pixel.blue;
  };
  const double disc = 0.25;  // the middle of one: the lattice's spacing is half a metre
  EXPECT_LT(brightness(6 + disc, 7.5 + disc), 330);
  EXPECT_GT(brightness(1 + disc, 11 + disc), 520);
  EXPECT_GT(brightness(6 + disc, 9 + disc), brightness(6 + disc, 7.5 + disc));
}

// The middle of each piece of the joint, which must differ where its value does.
TEST_F(Views, JointsAreColouredByApertureSlipPressureAndState) {
  run.with_joints = true;
  write_run(folder(), run);
  ASSERT_EQ(render_views({"discs"}).status, HFRAC_OK);
  const FramedView view = find_view(picture(), run.width, run.height);  // the same in all of them
  for (const std::int32_t dark : {0, 1}) {
    views.dark = dark;
    std::vector<Pixel> by_state;
    for (const char* kind :
         {"joint-state", "joint-aperture", "joint-pressure", "joint-slip", "joints:slip_m"}) {
      const Result result = render_views({kind});
      ASSERT_EQ(result.status, HFRAC_OK) << kind << ": " << result.text;
      const Picture drawn = picture();
      std::vector<Pixel> colour;
      for (int k = 0; k < 4; ++k)
        colour.push_back(drawn.at(view.x(run.width / 4), view.y(run.height * (k + 0.5) / 4)));
      const auto apart = [&](int a, int b) {
        return std::abs(colour[a].red - colour[b].red) + std::abs(colour[a].green - colour[b].green) +
               std::abs(colour[a].blue - colour[b].blue);
      };
      const bool slip = std::string_view(kind).find("slip") != std::string_view::npos;
      if (slip) {
        EXPECT_LT(apart(0, 1), 6) << kind;
        EXPECT_LT(apart(2, 3), 6) << kind;
        EXPECT_GT(apart(1, 2), 60) << kind;
      } else {
        // Of apertures the scale shows the middle 98 %, so that the widest of four has the colour of the next.
        const int told = std::string_view(kind) == "joint-aperture" ? 3 : 4;
        for (int a = 0; a < told; ++a) {
          for (int b = a + 1; b < told; ++b) EXPECT_GT(apart(a, b), 60) << kind << " " << a << " " << b;
        }
      }
      if (by_state.empty()) by_state = colour;
    }
    EXPECT_GT(by_state[2].red, by_state[2].green + 100);  // slips: as shear
    EXPECT_GT(by_state[1].blue, by_state[1].red);         // sticks: as bonds that hold
  }
}

TEST_F(Views, JointsOfARunWithoutThemAreRefused) {
  write_run(folder(), run);
  const Result result = render_views({"joint-aperture"});
  EXPECT_EQ(result.status, HFRAC_VIZ_ERR_READ);
  EXPECT_NE(result.text.find("no array 'hydraulic_aperture_m'"), std::string::npos) << result.text;
}

// Every view that shows cracks by mode, on light and on dark paper: the colour of its mode in the middle of each crack,
// and another one there before it broke.
TEST_F(Views, CracksAreWhereTheyAreInEveryView) {
  run.with_temperature = true;
  write_run(folder(), run);
  ASSERT_EQ(render_views({"discs"}).status, HFRAC_OK);
  const FramedView view = find_view(picture(), run.width, run.height);  // the same in all of them
  const auto alike = [](Pixel a, Pixel b) {
    return std::abs(a.red - b.red) < 60 && std::abs(a.green - b.green) < 60 && std::abs(a.blue - b.blue) < 60;
  };
  for (const char* kind : {"discs", "forces", "pressure", "displacement", "stress", "stress-xx", "stress-xy",
                           "rotation", "temperature", "bonds"}) {
    for (const std::int32_t dark : {0, 1}) {
      const Pixel tension = dark == 0 ? Pixel{12, 12, 16} : Pixel{255, 255, 250};
      const Pixel shear = dark == 0 ? Pixel{200, 20, 140} : Pixel{255, 92, 200};
      views.dark = dark;
      views.snapshot = -1;
      ASSERT_EQ(render_views({kind}).status, HFRAC_OK) << kind;
      const Picture after = picture();
      views.snapshot = 0;
      ASSERT_EQ(render_views({kind}).status, HFRAC_OK) << kind;
      const Picture before = picture();
      int crack = 0;
      for (int i = 0; i < run.columns; ++i) {
        const double x = (i + 0.5) * run.spacing();
        const double distance = std::abs(x - run.well_x());
        if (distance < run.well_radius || distance > run.half_length) continue;
        const Pixel colour = crack++ % 5 == 4 ? shear : tension;
        if (distance < run.well_radius + run.spacing()) continue;  // the well's ring lies over it
        const int column = view.x(x);
        const int row = view.y(run.well_y());
        EXPECT_TRUE(alike(after.at(column, row), colour))
            << "view " << kind << ", dark " << dark << ", x " << x;
        EXPECT_FALSE(alike(before.at(column, row), colour))
            << "view " << kind << ", dark " << dark << ", x " << x;
      }
      EXPECT_GT(crack, 8);
    }
  }
}

TEST_F(Views, ForcesAreBlueInRowsAndOrangeInColumns) {
  write_run(folder(), run);
  const Result result = render_views({"forces"});
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture drawn = picture();
  const FramedView view = find_view(drawn, run.width, run.height);
  EXPECT_TRUE(bluish(drawn.at(view.x(2.0), view.y(2.25))));   // between two discs of a row
  EXPECT_TRUE(reddish(drawn.at(view.x(2.25), view.y(2.0))));  // between two discs of a column
}

TEST_F(Views, ZoomShowsThatPart) {
  write_run(folder(), run);
  views.zoom = HFRAC_VIZ_ZOOM_BOX;
  views.left = 5.5;
  views.bottom = 5.5;
  views.box_width = 1;
  views.box_height = 1;  // all of it inside the well
  Result result = render_views({"discs"});
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  Picture drawn = picture();
  FramedView view = find_view(drawn, 1, 1);
  EXPECT_GT(drawn.share(view.left + 8, view.top + 8, view.right - 8, view.bottom - 8,
                        [](Pixel p) { return p.is_red(); }),
            0.99);
  for (const int zoom : {HFRAC_VIZ_ZOOM_CRACKS, HFRAC_VIZ_ZOOM_WELL, HFRAC_VIZ_ZOOM_TIP}) {
    views.zoom = zoom;
    result = render_views({"discs"});
    ASSERT_EQ(result.status, HFRAC_OK) << zoom << ": " << result.text;
    drawn = picture();
    view = find_view(drawn, 1, 1);
    EXPECT_GT(drawn.share(view.left, view.top, view.right, view.bottom, [](Pixel p) { return p.is_dark(); }),
              0.002)
        << zoom;
  }
}

TEST_F(Views, DarkPaperIsDark) {
  write_run(folder(), run);
  views.dark = 1;
  ASSERT_EQ(render_views({"discs", "pressure"}).status, HFRAC_OK);
  EXPECT_TRUE(picture().at(3, 3).is_dark());
  // It does not stay for the pictures after it.
  ASSERT_EQ(render_picture(HFRAC_VIZ_STAGE, file("stage.png")).status, HFRAC_OK);
  EXPECT_TRUE(read_picture(file("stage.png")).at(3, 3).is_white());
}

TEST_F(Views, BadRequestsAreRefusedWithAReason) {
  run.with_flow = false;
  write_run(folder(), run);
  EXPECT_EQ(render_views(std::vector<const char*>{}).status, HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(render_views({"file:"}).status, HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(render_views({"no such view"}).status, HFRAC_VIZ_ERR_READ);
  EXPECT_EQ(render_views(std::vector<const char*>(10, "discs")).status, HFRAC_ERR_ARGUMENT);
  const Result no_flow = render_views({"pressure"});
  EXPECT_EQ(no_flow.status, HFRAC_VIZ_ERR_READ);
  EXPECT_NE(no_flow.text.find("no array 'pressure_Pa'"), std::string::npos) << no_flow.text;
  views.snapshot = 77;
  EXPECT_EQ(render_views({"discs"}).status, HFRAC_ERR_ARGUMENT);
  views.snapshot = -1;
  views.zoom = HFRAC_VIZ_ZOOM_BOX;
  for (const double width : {0.0, -1.0, std::numeric_limits<double>::infinity(), 1000.0}) {
    views.box_width = width;
    views.box_height = 1;
    EXPECT_EQ(render_views({"discs"}).status, HFRAC_ERR_ARGUMENT) << width;
  }
  views.struct_size = 0;
  EXPECT_EQ(render_views({"discs"}).status, HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_viz_view_options_init(nullptr, 48), HFRAC_ERR_ARGUMENT);
}

}  // namespace
}  // namespace hfrac::viz_test
