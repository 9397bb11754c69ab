// SPDX-License-Identifier: BSD-3-Clause
// The charts: which files, how large, and that curves are where their numbers say.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

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
  ASSERT_EQ(result.status, HFRAC_VIZ_INCOMPLETE) << result.text;
  for (const char* said : {"history.csv is missing, so there is no history", "events.csv is missing",
                           "cracks.csv is missing, so there is no rose, profile, events"})
    EXPECT_NE(result.text.find(said), std::string::npos) << result.text;
  EXPECT_FALSE(std::filesystem::exists(chart("history.png")));
  EXPECT_FALSE(std::filesystem::exists(chart("rose.png")));
}

// Nothing is drawn of what cannot be read, and the reason names file, line and column.
TEST_F(Charts, DamagedTablesAreRefused) {
  write_run(folder(), run);
  const std::string whole = file_text(file("cracks.csv"));
  const auto refused = [&](const std::string& content, const std::string& reason) {
    std::ofstream(file("cracks.csv"), std::ios::binary) << content;
    const Result result = render_charts();
    EXPECT_EQ(result.status, HFRAC_VIZ_ERR_READ);
    EXPECT_NE(result.text.find("cracks.csv"), std::string::npos) << result.text;
    EXPECT_NE(result.text.find(reason), std::string::npos) << result.text;
    EXPECT_FALSE(std::filesystem::exists(chart("rose.png")));
  };
  const std::size_t line = whole.find('\n') + 1;
  refused("", "no line of names");
  refused(whole.substr(0, line) + "1,2\n" + whole.substr(line), "line 2 has 2 cells");
  std::string noise = whole.substr(line);
  for (std::size_t i = 0; i < noise.size(); ++i)
    if (noise[i] != '\n' && noise[i] != ',') noise[i] = static_cast<char>(0x80 + 37 * i % 128);
  refused(whole.substr(0, line) + noise, "is no number");
  std::string renamed = whole;
  refused(renamed.replace(renamed.find("length_m"), 8, "length_f"), "has no column 'length_m'");
}

TEST_F(Charts, ThreeWingsHaveAPanelEach) {
  write_run(folder(), run);
  std::ofstream cracks(file("cracks.csv"));
  cracks << "x_m,y_m,normal_x,normal_y,length_m,aperture_m,time_s,energy_J_per_m,mode\n";
  for (const double direction : {0.0, 2.1, 4.2}) {
    for (double r = run.well_radius; r < 6; r += 0.25)
      cracks << run.well_x() + r * std::cos(direction) << ',' << run.well_y() + r * std::sin(direction) << ','
             << -std::sin(direction) << ',' << std::cos(direction) << ",0.25,0.001,1,1,tension\n";
  }
  cracks.close();
  charts.charts = HFRAC_VIZ_CHART_PROFILE;
  charts.formats = HFRAC_VIZ_SVG | HFRAC_VIZ_PNG;
  const Result result = render_charts();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_GT(read_picture(chart("profile.png")).height, 900);  // two rows of panels
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
  // As before there were events from slip.
  std::ofstream(file("events.csv")) << "event,time_s,x_m,y_m,moment_N_m,magnitude,isotropic_fraction\n"
                                       "0,1,2,3,1e6,-2,0\n";
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  for (const char* ending : {"png", "svg", "pdf"})
    EXPECT_TRUE(std::filesystem::exists(chart(std::string("catalogue.") + ending))) << ending;
  std::filesystem::remove_all(file("pictures"));
  std::filesystem::remove(file("events.csv"));
  ASSERT_EQ(render_charts().status, HFRAC_VIZ_INCOMPLETE);
  EXPECT_FALSE(std::filesystem::exists(chart("catalogue.png")));
}

// r = sqrt(4 pi D t) through an event at 10 m after 100 s has D = 10^2 / (4 pi 100) m2/s; 19 of 20 events lie there or below.
TEST_F(Charts, TheFrontOfDiffusionHoldsTheShareOfEventsItSays) {
  write_run(folder(), run);
  std::ofstream events(file("events.csv"));
  events << "event,time_s,x_m,y_m,moment_N_m,magnitude,isotropic_fraction,kind\n";
  for (int k = 0; k < 20; ++k) {
    const double distance = k == 0 ? 90 : k == 1 ? 10 : 0.5 * k;
    events << k << ",100," << run.well_x() + distance << ',' << run.well_y() << ",1e6,-2,0,"
           << (k % 2 == 0 ? "slip" : "cracks") << '\n';
  }
  events.close();
  charts.charts = HFRAC_VIZ_CHART_CATALOGUE;
  charts.formats = HFRAC_VIZ_SVG;
  ASSERT_EQ(render_charts().status, HFRAC_OK) << last_error();
  std::string svg = file_text(chart("catalogue.svg"));
  EXPECT_NE(svg.find("D = 0.0796 m"), std::string::npos);
  EXPECT_NE(svg.find("95 %"), std::string::npos);
  EXPECT_NE(svg.find("slip of joints"), std::string::npos);
  charts.diffusivity = 0.5;
  ASSERT_EQ(render_charts().status, HFRAC_OK);
  svg = file_text(chart("catalogue.svg"));
  EXPECT_NE(svg.find("D = 0.5 m"), std::string::npos);
  EXPECT_EQ(svg.find("95 %"), std::string::npos);
  charts.diffusivity = -1;
  EXPECT_EQ(render_charts().status, HFRAC_ERR_ARGUMENT);
}

TEST_F(Charts, ACallerCanStopThem) {
  write_run(folder(), run);
  const auto stop = [](void*, double, const char*) { return 1; };
  EXPECT_EQ(render_charts(stop).status, HFRAC_STOPPED);
}

}  // namespace
}  // namespace hfrac::viz_test
