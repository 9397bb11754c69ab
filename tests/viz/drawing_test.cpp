// SPDX-License-Identifier: BSD-3-Clause
// Views by name and as SVG; and in the SVG, whose letters have places, that nothing on a page overlaps.
#include <algorithm>
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
    std::array<char, 2000> text{};
    const std::int32_t status = hfrac_viz_render_named_views(
        folder().c_str(), names.data(), static_cast<std::int32_t>(names.size()), file(target).c_str(), &views,
        text.data(), static_cast<std::int32_t>(text.size()), nullptr);
    return {status, text.data()};
  }

  hfrac_viz_view_options views;
};

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

// Where a line of text is on the page, a little tighter than it is drawn.
struct Letters {
  double left, right, top, bottom;
  std::string text;
  bool overlaps(const Letters& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

std::vector<Letters> letters_of(const std::string& svg) {
  const std::regex pattern(
      "<text x=\"([^\"]*)\" y=\"([^\"]*)\" font-size=\"([^\"]*)\"([^>]*)>([^<]*)</text>");
  std::vector<Letters> found;
  for (std::sregex_iterator one(svg.begin(), svg.end(), pattern), end; one != end; ++one) {
    const double x = std::stod((*one)[1]);
    const double y = std::stod((*one)[2]);
    const double size = std::stod((*one)[3]);
    const std::string style = (*one)[4];
    const std::string text = (*one)[5];
    const double length = 0.5 * size * static_cast<double>(text.size());
    const double before = holds(style, "middle") ? length / 2 : holds(style, "\"end\"") ? length : 0;
    if (holds(style, "rotate")) {
      found.push_back({x - 0.7 * size, x, y - (length - before), y + before, text});
    } else {
      found.push_back({x - before, x + length - before, y - 0.7 * size, y, text});
    }
  }
  return found;
}

void expect_no_overlap(const std::string& svg, double width, double height, const std::string& what) {
  const std::vector<Letters> all = letters_of(svg);
  EXPECT_GT(all.size(), 5U) << what;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GE(all[i].left, 0) << what << ": " << all[i].text;
    EXPECT_LE(all[i].right, width) << what << ": " << all[i].text;
    EXPECT_GE(all[i].top, 0) << what << ": " << all[i].text;
    EXPECT_LE(all[i].bottom, height) << what << ": " << all[i].text;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(all[i].overlaps(all[k])) << what << ": '" << all[i].text << "' on '" << all[k].text << "'";
    }
  }
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
}

TEST_F(Drawing, NothingOverlapsAtAnyShapeAndZoom) {
  write_run(folder(), run);
  const std::vector<std::vector<const char*>> pages = {{"discs"},
                                                       {"forces"},
                                                       {"pressure"},
                                                       {"stress"},
                                                       {"aperture"},
                                                       {"crack-time"},
                                                       {"displacement", "stress-xy"},
                                                       {"discs", "bonds", "forces", "pressure"}};
  const std::vector<std::pair<std::int32_t, std::int32_t>> shapes = {
      {1600, 0}, {1600, 900}, {900, 1200}, {500, 400}};
  for (const auto& names : pages) {
    for (const auto& [width, height] : shapes) {
      for (const std::int32_t zoom : {HFRAC_VIZ_ZOOM_WHOLE, HFRAC_VIZ_ZOOM_TIP}) {
        views.width = width;
        views.height = height;
        views.zoom = zoom;
        const Result result = draw(names, "v.svg");
        ASSERT_EQ(result.status, HFRAC_OK) << result.text;
        const std::string svg = file_text(file("v.svg"));
        std::smatch size;
        ASSERT_TRUE(std::regex_search(svg, size, std::regex("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"")));
        expect_no_overlap(svg, std::stod(size[1]), std::stod(size[2]),
                          std::string(names[0]) + " " + std::to_string(names.size()) + " at " +
                              std::to_string(width) + " x " + std::to_string(height) + ", zoom " +
                              std::to_string(zoom));
      }
    }
  }
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
