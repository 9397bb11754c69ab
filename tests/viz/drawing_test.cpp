// SPDX-License-Identifier: BSD-3-Clause
// Views by name, as SVG and as PDF; and in the SVG, where letters say how long they are, that nothing on a page
// overlaps.
#include <algorithm>
#include <cmath>
#include <cstdlib>
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

// Where something is on the page.
struct Place {
  double left, right, top, bottom;
  std::string what;
  bool overlaps(const Place& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// Lines of text: as long as the layout says, from the baseline to the top of digits.
std::vector<Place> letters_of(const std::string& svg) {
  const std::regex pattern(
      "<text x=\"([^\"]*)\" y=\"([^\"]*)\" font-size=\"([^\"]*)\" "
      "textLength=\"([^\"]*)\"([^>]*)>([^<]*)</text>");
  std::vector<Place> found;
  for (std::sregex_iterator one(svg.begin(), svg.end(), pattern), end; one != end; ++one) {
    const double x = std::stod((*one)[1]);
    const double y = std::stod((*one)[2]);
    const double size = std::stod((*one)[3]);
    const double length = std::stod((*one)[4]);
    const std::string style = (*one)[5];
    const double before = holds(style, "middle") ? length / 2 : holds(style, "\"end\"") ? length : 0;
    if (holds(style, "rotate")) {
      found.push_back({x - 0.7 * size, x, y - (length - before), y + before, (*one)[6]});
    } else {
      found.push_back({x - before, x + length - before, y - 0.7 * size, y, (*one)[6]});
    }
  }
  return found;
}

// What letters must not run over: the views, and the shapes around them (frames, ticks, scales, signs).
std::vector<Place> shapes_of(const std::string& svg) {
  std::vector<Place> found;
  const std::regex view(
      "<clipPath id=\"([^\"]*)\"><rect x=\"([^\"]*)\" y=\"([^\"]*)\" width=\"([^\"]*)\" height=\"([^\"]*)\"");
  for (std::sregex_iterator one(svg.begin(), svg.end(), view), end; one != end; ++one) {
    const double left = std::stod((*one)[2]);
    const double top = std::stod((*one)[3]);
    found.push_back({left, left + std::stod((*one)[4]), top, top + std::stod((*one)[5]), (*one)[1]});
  }
  const std::size_t from = svg.rfind("</g>");
  const std::size_t to = svg.find("<text", from);
  const char* at = svg.c_str() + from;
  const char* const stop = svg.c_str() + to;
  for (; at < stop; ++at) {
    if (*at == 'M' && at[-1] != '"' && at[-1] != 'Z') continue;
    if (*at != 'M' && *at != 'L') continue;
    char* next = nullptr;
    const double x = std::strtod(at + 1, &next);
    if (next == at + 1) continue;
    const double y = std::strtod(next, &next);
    if (*at == 'M') found.push_back({x, x, y, y, "a shape"});
    Place& shape = found.back();
    shape = {std::min(shape.left, x), std::max(shape.right, x), std::min(shape.top, y),
             std::max(shape.bottom, y), shape.what};
  }
  return found;
}

void expect_no_overlap(const std::string& svg, double width, double height, const std::string& what) {
  const std::vector<Place> letters = letters_of(svg);
  const std::vector<Place> shapes = shapes_of(svg);
  EXPECT_GT(letters.size(), 5U) << what;
  EXPECT_GT(shapes.size(), 10U) << what;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(letters[i].overlaps(letters[k]))
          << what << ": '" << letters[i].what << "' on '" << letters[k].what << "'";
    }
    for (const Place& shape : shapes) {
      EXPECT_FALSE(letters[i].overlaps(shape)) << what << ": '" << letters[i].what << "' on " << shape.what
                                               << " at " << shape.left << ", " << shape.top;
    }
  }
  for (const auto* places : {&letters, &shapes}) {
    for (const Place& place : *places) {
      const bool inside = place.left >= 0 && place.right <= width && place.top >= 0 && place.bottom <= height;
      EXPECT_TRUE(inside) << what << ": '" << place.what << "' leaves the page at " << place.left << " to "
                          << place.right << ", " << place.top << " to " << place.bottom;
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
  const std::vector<std::pair<std::int32_t, std::int32_t>> shapes = {{1600, 0},  {1920, 1080}, {900, 1200},
                                                                     {640, 480}, {500, 400},   {3000, 3000}};
  for (const auto& names : pages) {
    for (const auto& [width, height] : shapes) {
      for (const std::int32_t zoom : {HFRAC_VIZ_ZOOM_WHOLE, HFRAC_VIZ_ZOOM_TIP}) {
        views.width = width;
        views.height = height;
        views.zoom = zoom;
        views.dark = width == 640 ? 1 : 0;
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
