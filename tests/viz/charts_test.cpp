// SPDX-License-Identifier: BSD-3-Clause
// The charts: which files, how large, and that curves are where their numbers say.
#include <gtest/gtest.h>

#include "file_text.h"
#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Charts : public VizTest {
 protected:
  Charts() { hfrac_viz_chart_options_init(&charts, sizeof charts); }

  Result render_charts(hfrac_viz_progress_fn progress = nullptr, void* user = nullptr) {
    return result_of(hfrac_viz_render_charts(folder().c_str(), &charts, progress, user));
  }
  std::filesystem::path chart(const std::string& name) const { return file("pictures") / name; }

  hfrac_viz_chart_options charts;
};

TEST_F(Charts, EveryChartInEveryFormat) {
  write_run(folder(), run);
  charts.formats = HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF;
  charts.width = 800;
  const Result result = render_charts();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  for (const std::string name : {"history", "rose", "profile", "events"}) {
    const Picture picture = read_picture(chart(name + ".png"));
    EXPECT_EQ(picture.width, 800) << name;
    EXPECT_GT(picture.share(0, 0, picture.width, picture.height, [](Pixel p) { return !p.is_white(); }), 0.01)
        << name;
    const std::string svg = file_text(chart(name + ".svg"));
    EXPECT_TRUE(holds(svg, "viewBox=\"0 0 1600 ")) << name;
    EXPECT_TRUE(holds(svg, "</svg>")) << name;
    EXPECT_EQ(file_text(chart(name + ".pdf")).substr(0, 5), "%PDF-") << name;
  }
  EXPECT_EQ(leftovers(file("pictures")), 0);
}

TEST_F(Charts, PressureRisesFromLowerLeftToUpperRightOfItsPanel) {
  write_run(folder(), run);
  charts.charts = HFRAC_VIZ_CHART_HISTORY;
  const Result result = render_charts();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(chart("history.png"));
  // The panel's plot is 554 x 256 at (120, 210); the pressure rises with the square root of time.
  const auto height_of_curve = [&](int x) {
    for (int y = 200; y < 480; ++y) {
      if (picture.at(x, y).is_red()) return y;
    }
    return -1;
  };
  const int quarter = height_of_curve(120 + 554 / 4);
  const int middle = height_of_curve(120 + 554 / 2);
  const int end = height_of_curve(120 + 554 * 9 / 10);
  ASSERT_GT(quarter, 0);
  EXPECT_LT(middle, quarter - 20);
  EXPECT_LT(end, middle - 20);
  EXPECT_NEAR(quarter, 210 + 256 - 256 * 0.5 / 1.06, 10);  // the root of a quarter is a half
}

TEST_F(Charts, ResolutionForPrintIsNotedInTheFile) {
  write_run(folder(), run);
  charts.charts = HFRAC_VIZ_CHART_PROFILE;
  charts.dots_per_inch = 300;
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  const std::string png = file_text(chart("profile.png"));
  ASSERT_EQ(png.substr(37, 4), "pHYs");
  EXPECT_EQ(png.substr(41, 4), std::string("\0\0\x2e\x23", 4));  // 11 811 pixels per metre
  EXPECT_EQ(read_picture(chart("profile.png")).width,
            1600);  // its check sum is right, or it could not be read
}

TEST_F(Charts, DarkPaperIsDark) {
  write_run(folder(), run);
  charts.dark = 1;
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  EXPECT_TRUE(read_picture(chart("rose.png")).at(3, 3).is_dark());
  charts.dark = 0;
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  EXPECT_TRUE(read_picture(chart("rose.png")).at(3, 3).is_white());
}

TEST_F(Charts, MissingTablesAreLeftOut) {
  run.with_tables = false;
  write_run(folder(), run);
  const Result result = render_charts();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_FALSE(std::filesystem::exists(chart("history.png")));
  EXPECT_FALSE(std::filesystem::exists(chart("rose.png")));
}

TEST_F(Charts, ALineThatIsStillBeingWrittenIsLeftOut) {
  write_run(folder(), run);
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  const auto before = read_picture(chart("history.png")).rgb;
  std::ofstream(file("history.csv"), std::ios::app) << "101,99999,4.5e";
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  EXPECT_EQ(read_picture(chart("history.png")).rgb, before);
}

TEST_F(Charts, BadOptionsAreRefused) {
  write_run(folder(), run);
  charts.formats = 0;
  EXPECT_EQ(render_charts().status, HFRAC_ERR_ARGUMENT);
  charts.formats = HFRAC_VIZ_PNG;
  charts.width = 10;
  EXPECT_EQ(render_charts().status, HFRAC_ERR_ARGUMENT);
  charts.width = 800;
  charts.struct_size = 4;
  EXPECT_EQ(render_charts().status, HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_viz_chart_options_init(nullptr, 48), HFRAC_ERR_ARGUMENT);
}

TEST_F(Charts, CatalogueNeedsItsTable) {
  write_run(folder(), run);
  charts.charts = HFRAC_VIZ_CHART_CATALOGUE;
  charts.formats = HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF;
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  for (const char* ending : {"png", "svg", "pdf"})
    EXPECT_TRUE(std::filesystem::exists(chart(std::string("catalogue.") + ending))) << ending;
  std::filesystem::remove_all(file("pictures"));
  std::filesystem::remove(file("events.csv"));
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  EXPECT_FALSE(std::filesystem::exists(chart("catalogue.png")));
}

TEST_F(Charts, ACallerCanStopThem) {
  write_run(folder(), run);
  const auto stop = [](void*, double, const char*) { return 1; };
  EXPECT_EQ(render_charts(stop).status, HFRAC_STOPPED);
}

}  // namespace
}  // namespace hfrac::viz_test
