// SPDX-License-Identifier: BSD-3-Clause
// That nothing on a page overlaps: legend, scales, scale bar, time, axes and title. Looked for in the SVG files, where
// letters say how long they are.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <vector>

#include "file_text.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

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
  const std::size_t views_end = svg.rfind("</g>");  // a page of charts has none
  const std::size_t from = views_end != std::string::npos ? views_end : svg.find("<path");
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

// Widths and heights [pixel], 0: as the model asks.
using Shapes = std::vector<std::pair<std::int32_t, std::int32_t>>;

class Overlap : public VizTest {
 protected:
  Overlap() {
    hfrac_viz_view_options_init(&views, sizeof views);
    run.with_temperature = true;
  }

  void expect_free(const std::string& what, const std::string& name = "page.svg") const {
    const std::string svg = file_text(file(name));
    std::smatch size;
    ASSERT_TRUE(std::regex_search(svg, size, std::regex("viewBox=\"0 0 ([0-9]+) ([0-9]+)\""))) << what;
    expect_no_overlap(svg, std::stod(size[1]), std::stod(size[2]), what);
  }
  void check_views(const std::vector<const char*>& names, const std::string& what) {
    const std::int32_t status =
        hfrac_viz_render_views(folder().c_str(), names.data(), static_cast<std::int32_t>(names.size()),
                               file("page.svg").c_str(), &views);
    ASSERT_EQ(status, HFRAC_OK) << last_error();
    expect_free(std::string(names[0]) + " of " + std::to_string(names.size()) + what);
  }

  hfrac_viz_view_options views;
};

std::string at(std::int32_t width, std::int32_t height) {
  return " at " + std::to_string(width) + " x " + std::to_string(height);
}

TEST_F(Overlap, ViewsAtAnyShapeAndZoom) {
  write_run(folder(), run);
  const Shapes shapes = {{1600, 0}, {1920, 1080}, {900, 1200}, {640, 480}, {500, 400}, {3000, 3000}};
  const std::vector<std::vector<const char*>> pages = {{"discs"},
                                                       {"forces"},
                                                       {"pressure"},
                                                       {"stress"},
                                                       {"temperature"},
                                                       {"aperture"},
                                                       {"crack-time"},
                                                       {"displacement", "stress-xy"},
                                                       {"discs", "bonds", "forces", "pressure"}};
  for (const auto& names : pages) {
    for (const auto& [width, height] : shapes) {
      for (const std::int32_t zoom : {HFRAC_VIZ_ZOOM_WHOLE, HFRAC_VIZ_ZOOM_TIP}) {
        views.width = width;
        views.height = height;
        views.zoom = zoom;
        views.dark = width == 640 ? 1 : 0;
        check_views(names, at(width, height) + ", zoom " + std::to_string(zoom));
      }
    }
  }
}

TEST_F(Overlap, PicturesAndFramesAtAnyShape) {
  const Shapes shapes = {{1600, 0},  {1920, 1080}, {1280, 720}, {900, 1200},
                         {640, 480}, {320, 240},   {3000, 3000}};
  for (const char* title :
       {"Synthetic run", "", "A run with a title that is much longer than any page is wide, and goes on"}) {
    run.title = title;
    write_run(folder(), run);
    for (const std::int32_t kind : {HFRAC_VIZ_MODEL, HFRAC_VIZ_STAGE, HFRAC_VIZ_GROWTH, HFRAC_VIZ_PRESSURE,
                                    HFRAC_VIZ_APERTURE, HFRAC_VIZ_MOVIE}) {
      for (const auto& [width, height] : shapes) {
        options.width = width;
        options.height = height;
        options.dark = width % 3 == 0 ? 1 : 0;
        const Result result = render_picture(kind, file("page.svg"));
        ASSERT_EQ(result.status, HFRAC_OK) << result.text;
        expect_free("picture " + std::to_string(kind) + at(width, height) + ", '" + title + "'");
      }
    }
  }
}

// A model three times as wide as high, and one as much higher: pages are laid out in other ways.
TEST_F(Overlap, PicturesOfLongModels) {
  for (const double height : {4.0, 36.0}) {
    run.height = height;
    write_run(folder(), run);
    for (const std::int32_t kind : {HFRAC_VIZ_MODEL, HFRAC_VIZ_STAGE, HFRAC_VIZ_GROWTH, HFRAC_VIZ_PRESSURE,
                                    HFRAC_VIZ_APERTURE, HFRAC_VIZ_MOVIE}) {
      for (const auto& [width, page_height] : Shapes{{1600, 0}, {1920, 1080}, {640, 480}}) {
        options.width = width;
        options.height = page_height;
        const Result result = render_picture(kind, file("page.svg"));
        ASSERT_EQ(result.status, HFRAC_OK) << result.text;
        expect_free("picture " + std::to_string(kind) + at(width, page_height) + " of a model " +
                    std::to_string(height));
      }
    }
  }
}

TEST_F(Overlap, ChartsOfARun) {
  hfrac_viz_chart_options charts;
  hfrac_viz_chart_options_init(&charts, sizeof charts);
  charts.formats = HFRAC_VIZ_SVG;
  for (const char* title : {"Synthetic run", "",
                            "A run with a title that is longer than any page of charts is wide, and "
                            "goes on about what was done to the rock"}) {
    run.title = title;
    write_run(folder(), run);
    for (const std::int32_t dark : {0, 1}) {
      charts.dark = dark;
      ASSERT_EQ(hfrac_viz_render_charts(folder().c_str(), &charts, nullptr, nullptr), HFRAC_OK);
      for (const char* name : {"history", "rose", "profile", "events", "catalogue"})
        expect_free(std::string(name) + " of '" + title + "'", "pictures/" + std::string(name) + ".svg");
    }
  }
}

TEST_F(Overlap, Comparisons) {
  for (const int series : {1, 5, 12}) {
    std::ofstream table(file("table.csv"));
    table << "well pressure (MPa),time_s,crack_count,fracture_length_m,injected_volume_m2\n";
    for (int one = 0; one < series; ++one) {
      for (int k = 0; k < 20; ++k)
        table << 5 * one << ',' << 0.01 * k << ',' << one * k << ',' << 1e-4 * one * k << ',' << 1e6 * k
              << '\n';
    }
    table.close();
    hfrac_viz_comparison_options page;
    hfrac_viz_comparison_options_init(&page, sizeof page);
    page.title =
        "Runs of many packings with a title that is longer than a page of charts is wide, and then some "
        "words";
    ASSERT_EQ(hfrac_viz_render_comparison(file("table.csv").c_str(), file("table.svg").c_str(), &page),
              HFRAC_OK)
        << last_error();
    expect_free(std::to_string(series) + " series compared", "table.svg");
  }
}

}  // namespace
}  // namespace hfrac::viz_test
