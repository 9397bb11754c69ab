// SPDX-License-Identifier: BSD-3-Clause
// Views by name and pictures, as SVG and as PDF.
#include <cmath>
#include <regex>
#include <vector>

#include "file_text.h"
#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Drawing : public VizTest {
 protected:
  Drawing() { hfrac_viz_view_options_init(&views, sizeof views); }

  Result draw(const std::vector<const char*>& names, const std::string& target) {
    return result_of(hfrac_viz_render_views(folder().c_str(), names.data(),
                                            static_cast<std::int32_t>(names.size()), file(target).c_str(),
                                            &views));
  }

  hfrac_viz_view_options views;
};

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST_F(Drawing, CirclesPathsAndLettersInsteadOfPixels) {
  write_run(folder(), run);
  const Result result = draw({"discs"}, "v.svg");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const std::string svg = file_text(file("v.svg"));
  int discs = 0;  // of the lattice, without the hole
  for (int i = 0; i < run.columns; ++i) {
    for (int k = 0; k < run.columns; ++k) {
      const double x = (i + 0.5) * run.spacing() - run.well_x();
      const double y = (k + 0.5) * run.spacing() - run.well_y();
      discs += std::hypot(x, y) < run.well_radius ? 0 : 1;
    }
  }
  EXPECT_EQ(count_of(svg, "<circle "), discs);
  EXPECT_TRUE(holds(svg, ">Synthetic run: a crack from a hole</text>"));
  EXPECT_TRUE(holds(svg, ">x (m)</text>"));
  EXPECT_FALSE(holds(svg, "<image"));
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST_F(Drawing, PdfHasThePageInInchesAndRealLetters) {
  write_run(folder(), run);
  views.width = 1500;
  views.height = 1200;
  views.dots_per_inch = 300;
  for (const auto& names : {std::vector<const char*>{"discs"}, {"pressure", "stress"}}) {
    const Result result = draw(names, "v.pdf");
    ASSERT_EQ(result.status, HFRAC_OK) << result.text;
    const std::string pdf = file_text(file("v.pdf"));
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_TRUE(std::regex_search(pdf, std::regex("/MediaBox \\[ ?0 0 360 288 ?\\]")));  // 5 by 4 inches
    EXPECT_TRUE(holds(pdf, "DejaVuSans") || holds(pdf, "/FontName"));
    EXPECT_FALSE(holds(pdf, "/Subtype /Image"));
    EXPECT_TRUE(holds(pdf, "%%EOF"));
  }
  EXPECT_EQ(draw({"discs"}, "v.eps").status, HFRAC_ERR_ARGUMENT);
}

TEST_F(Drawing, PicturesOfTheRunInEveryFormat) {
  write_run(folder(), run);
  options.pictures = HFRAC_VIZ_ALL & ~HFRAC_VIZ_MOVIE;
  options.formats = HFRAC_VIZ_SVG | HFRAC_VIZ_PDF;
  options.width = 900;
  options.dots_per_inch = 300;
  ASSERT_EQ(render_run().status, HFRAC_OK);
  for (const char* name : {"model", "growth_1", "growth_3", "growth", "pressure", "aperture"}) {
    const std::string stem = file("pictures") / name;
    EXPECT_FALSE(std::filesystem::exists(stem + ".png")) << name;
    EXPECT_TRUE(holds(file_text(stem + ".svg"), ">wellbore</text>") || holds(name, "aperture")) << name;
    const std::string pdf = file_text(stem + ".pdf");
    EXPECT_TRUE(std::regex_search(pdf, std::regex("/MediaBox \\[ ?0 0 216 "))) << name;  // 3 inches
    EXPECT_FALSE(holds(pdf, "/Subtype /Image")) << name;
  }
  const std::string last = file_text(file("pictures") / "growth_3.svg");
  EXPECT_TRUE(holds(last, ">crack, shear</text>"));
  EXPECT_TRUE(holds(last, "#0c0c10")) << "no crack is drawn";
}

TEST_F(Drawing, AFrameOfTheMovieIsAPictureToo) {
  write_run(folder(), run);
  ASSERT_EQ(render_picture(HFRAC_VIZ_MOVIE, file("frame.svg")).status, HFRAC_OK);
  const std::string last = file_text(file("frame.svg"));
  EXPECT_TRUE(holds(last, ">cracks</text>"));
  options.snapshot = 0;
  ASSERT_EQ(render_picture(HFRAC_VIZ_MOVIE, file("frame.svg")).status, HFRAC_OK);
  const std::string first = file_text(file("frame.svg"));
  EXPECT_LT(first.size(), last.size());  // its curves are shorter
}

TEST_F(Drawing, DiscsBelowAPixelAreAPictureInTheDrawing) {
  run.columns = 900;
  run.snapshots = 1;
  run.with_flow = false;
  write_run(folder(), run);
  const Result result = draw({"discs"}, "v.svg");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const std::string svg = file_text(file("v.svg"));
  EXPECT_TRUE(holds(svg, "href=\"data:image/png;base64,iVBOR"));
  EXPECT_EQ(count_of(svg, "<circle "), 0);
  ASSERT_EQ(draw({"discs"}, "v.pdf").status, HFRAC_OK);
  EXPECT_TRUE(holds(file_text(file("v.pdf")), "/Subtype /Image"));
}

TEST_F(Drawing, AnyArrayIsAViewWithItsUnit) {
  write_run(folder(), run);
  for (const char* name :
       {"radius_m", "displacement_m[1]", "flow:pressure_Pa", "aperture_m", "normal_force_N"}) {
    const Result result = draw({name}, "v.svg");
    ASSERT_EQ(result.status, HFRAC_OK) << name << ": " << result.text;
  }
  ASSERT_EQ(draw({"displacement_m[1]"}, "v.svg").status, HFRAC_OK);
  const std::string svg = file_text(file("v.svg"));
  EXPECT_TRUE(holds(svg, ">displacement (mm)</text>"));
  EXPECT_TRUE(holds(svg, ">of the discs</text>"));
  // A millimetre per metre of x: the left half is darker than the right one.
  ASSERT_EQ(draw({"displacement_m[1]"}, "v.png").status, HFRAC_OK);
  const Picture picture = read_picture(file("v.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  EXPECT_LT(picture.at(view.x(1.25), view.y(9.75)).red, 120);
  EXPECT_GT(picture.at(view.x(10.75), view.y(9.75)).red, 220);
}

TEST_F(Drawing, WhatIsNotThereIsRefusedWithWhatIs) {
  write_run(folder(), run);
  const Result missing = draw({"radius"}, "v.png");
  EXPECT_EQ(missing.status, HFRAC_VIZ_ERR_READ);
  EXPECT_TRUE(holds(missing.text, "radius_m")) << missing.text;
  EXPECT_EQ(draw({"temperature"}, "v.png").status, HFRAC_VIZ_ERR_READ);
  EXPECT_EQ(draw({"displacement_m[7]"}, "v.png").status, HFRAC_VIZ_ERR_READ);
  for (const char* name : {"rock:radius_m", "radius_m[x]", "radius_m[1", ""}) {
    EXPECT_EQ(draw({name}, "v.png").status, HFRAC_ERR_ARGUMENT) << name;
  }
  EXPECT_EQ(draw({"discs"}, "v.jpg").status, HFRAC_ERR_ARGUMENT);
  EXPECT_FALSE(std::filesystem::exists(file("v.png")));
  std::array<char, 2000> names{};
  ASSERT_EQ(hfrac_viz_view_names(names.data(), names.size(), nullptr), HFRAC_OK);
  EXPECT_TRUE(holds(names.data(), "stress-xy"));
}

}  // namespace
}  // namespace hfrac::viz_test
