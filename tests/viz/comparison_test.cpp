// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of runs: a table in, means with their spread where the numbers say.
#include <cmath>
#include <fstream>

#include "file_text.h"
#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Comparison : public VizTest {
 protected:
  Comparison() { hfrac_viz_comparison_options_init(&compared, sizeof compared); }

  Result draw(const std::string& table, const std::string& picture) {
    std::ofstream(file("table.csv")) << table;
    return result_of(
        hfrac_viz_render_comparison(file("table.csv").c_str(), file(picture).c_str(), &compared));
  }

  hfrac_viz_comparison_options compared;
};

// The lowest picture row below the plot's upper edge at which a column has ink of a curve: here the only thing blue.
int first_blue(const Picture& picture, int x, int from, int to) {
  for (int y = from; y < to; ++y) {
    const Pixel pixel = picture.at(x, y);
    if (pixel.blue > pixel.red + 90 && pixel.red < 60) return y;
  }
  return -1;
}

TEST_F(Comparison, MeansAndBarsAreWhereTheNumbersSay) {
  // One series, three places, two runs each: means 2, 6, 10; standard deviations sqrt(2), 0, sqrt(2).
  const Result result =
      draw("series,well[0].pressure_Pa,crack_count\n,10e6,1\n,10e6,3\n,20e6,6\n,20e6,6\n,30e6,9\n,30e6,11\n",
           "c.png");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("c.png"));
  EXPECT_EQ(picture.width, 1600);
  // The plot is 1420 x 620 at (130, 212); x from 10 to 30 with a room of 3 %, y from 0 to 10 + sqrt(2) and 6 % of it.
  const double spread = std::sqrt(2.0);
  const auto at_x = [](double x) { return static_cast<int>(130 + 1420 * (x - 9.4) / 21.2); };
  const auto at_y = [&](double y) { return 212 + 620 * (1 - y / (1.06 * (10 + spread))); };
  const auto top_of = [&](double x) { return first_blue(picture, at_x(x), 214, 830); };
  EXPECT_NEAR(top_of(10), at_y(2 + spread), 4);  // the upper end of its bar
  EXPECT_NEAR(top_of(20), at_y(6) - 7, 4);       // no bar: the dot's upper edge
  EXPECT_NEAR(top_of(30), at_y(10 + spread), 4);
  EXPECT_NEAR(top_of(15), at_y(4), 4);  // the line between the means
}

TEST_F(Comparison, EveryFormatAndADarkOne) {
  const std::string table =
      "strength_Pa,step,length_m,length_m_spread,width (mm)\n1e6,1,2,0.5,3\n1e6,2,4,0.5,4\n2e6,1,3,1,5\n";
  compared.title = "Title & <more>";
  compared.width = 640;
  for (const char* name : {"c.svg", "c.pdf", "c.png"}) {
    const Result result = draw(table, name);
    ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  }
  EXPECT_TRUE(holds(file_text(file("c.svg")), "</svg>"));
  EXPECT_EQ(file_text(file("c.pdf")).substr(0, 5), "%PDF-");
  EXPECT_TRUE(read_picture(file("c.png")).at(2, 2).is_white());
  compared.dark = 1;
  ASSERT_EQ(draw(table, "c.png").status, HFRAC_OK);
  EXPECT_TRUE(read_picture(file("c.png")).at(2, 2).is_dark());
}

TEST_F(Comparison, LongCurvesGetABandAndNoDots) {
  std::string table = "series,time_s,crack_count\n";
  for (const char* count : {"10", "14"}) {
    for (int i = 0; i <= 100; ++i)
      table.append(",").append(std::to_string(0.1 * i)).append(",").append(count).append("\n");
  }
  const Result result = draw(table, "c.png");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("c.png"));
  // Half-way along: the mean's line on 12, tinted band around it up to 12 + sqrt(8).
  const int x = 130 + 1420 / 2;
  const auto at_y = [](double y) {
    return static_cast<int>(212 + 620 * (1 - y / (1.06 * (12 + std::sqrt(8.0)))));
  };
  const Pixel band = picture.at(x, at_y(13.4));
  EXPECT_FALSE(band.is_white());
  EXPECT_GT(band.blue, band.red + 10);
  EXPECT_NEAR(first_blue(picture, x, 214, 830), at_y(12), 3);
}

// A count over the steps of a run stays what it is until the next crack: no ramps.
TEST_F(Comparison, CountsOverStepsAreSteps) {
  std::string table = "series,step,crack_count\n";
  for (int i = 0; i <= 100; ++i)
    table.append(",").append(std::to_string(i)).append(",").append(i < 50 ? "2" : "10").append("\n");
  for (const char* line : {",101,10\n", ",150,20\n", ",200,20\n"}) table += line;
  ASSERT_EQ(draw(table, "c.png").status, HFRAC_OK);
  const Picture picture = read_picture(file("c.png"));
  // Between steps 101 and 150 the line is on 10, not half-way to 20.
  const auto at_y = [](double y) { return static_cast<int>(212 + 620 * (1 - y / (1.06 * 20))); };
  EXPECT_NEAR(first_blue(picture, 130 + 1420 * 140 / 200, 214, 830), at_y(10), 4);
}

TEST_F(Comparison, WhatCannotBeDrawnIsRefusedWithAReason) {
  const auto refused = [&](const std::string& table, const std::string& reason) {
    const Result result = draw(table, "c.png");
    EXPECT_EQ(result.status, HFRAC_VIZ_ERR_READ);
    EXPECT_NE(result.text.find(reason), std::string::npos) << result.text;
    EXPECT_FALSE(std::filesystem::exists(file("c.png")));
  };
  refused("a,b\n1,2\n", "three columns");
  refused("a,b,c\n,,\n", "no line with numbers");
  refused("a,b,c\n,x,y\n", "'x' in line 2, column 'b', is no number");
  refused("a,b,c,d,e,f,g,h,i\n,1,1,1,1,1,1,1,1\n", "a page holds 6");
  std::string many = "a,b,c\n";
  for (int i = 0; i < 13; ++i) many.append(std::to_string(i)).append(",1,1\n");
  refused(many, "12 cannot be told apart");
  EXPECT_EQ(draw("a,b,c\n,1,1\n", "c.gif").status, HFRAC_ERR_ARGUMENT);
  compared.width = 1;
  EXPECT_EQ(draw("a,b,c\n,1,1\n", "c.png").status, HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_viz_render_comparison("/no/table.csv", file("c.png").c_str(), nullptr), HFRAC_VIZ_ERR_READ);
}

}  // namespace
}  // namespace hfrac::viz_test
