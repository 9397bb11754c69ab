// SPDX-License-Identifier: BSD-3-Clause
// That no text on a page of charts lies on another one, on a line, or beyond the page. VTK writes letters into SVG files as
// outlines, a path for each text; these are what is measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "file_text.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

struct Rectangle {
  double left = INFINITY;
  double right = -INFINITY;
  double top = INFINITY;
  double bottom = -INFINITY;

  void include(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  bool overlaps(const Rectangle& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  // Whether a line passes through it (Liang and Barsky 1984).
  bool crossed_by(const std::array<double, 4>& line) const {
    const double dx = line[2] - line[0];
    const double dy = line[3] - line[1];
    double from = 0;
    double to = 1;
    for (const auto& [towards, room] : {std::pair{-dx, line[0] - left}, std::pair{dx, right - line[0]},
                                        std::pair{-dy, line[1] - top}, std::pair{dy, bottom - line[1]}}) {
      if (towards == 0 && room < 0) return false;
      if (towards < 0) from = std::max(from, room / towards);
      if (towards > 0) to = std::min(to, room / towards);
    }
    return from < to;
  }
  std::string text() const {
    return std::to_string(std::lround(left)) + ", " + std::to_string(std::lround(top)) + " to " +
           std::to_string(std::lround(right)) + ", " + std::to_string(std::lround(bottom));
  }
};

// Places x,y of a path or a line; letters between them are skipped.
std::vector<std::pair<double, double>> places_of(const std::string& data) {
  std::vector<std::pair<double, double>> places;
  static const std::regex place("(-?[0-9.]+(?:e-?[0-9]+)?),(-?[0-9.]+(?:e-?[0-9]+)?)");
  for (std::sregex_iterator one(data.begin(), data.end(), place), end; one != end; ++one)
    places.emplace_back(std::strtod((*one)[1].str().c_str(), nullptr),
                        std::strtod((*one)[2].str().c_str(), nullptr));
  return places;
}

std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(" " + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t first = at + name.size() + 3;
  return tag.substr(first, tag.find('"', first) - first);
}

std::vector<std::string> tags_of(const std::string& svg, const std::string& name) {
  std::vector<std::string> tags;
  for (std::size_t at = svg.find("<" + name + " "); at != std::string::npos;
       at = svg.find("<" + name + " ", at + 1))
    tags.push_back(svg.substr(at, svg.find("/>", at) - at));
  return tags;
}

// "translate(x,y)", turned by "rotate(degrees)" if it is there.
std::vector<Rectangle> texts_of(const std::string& svg) {
  std::vector<Rectangle> texts;
  for (const std::string& tag : tags_of(svg, "path")) {
    const std::string transform = attribute(tag, "transform");
    if (transform.empty()) continue;
    const std::vector<std::pair<double, double>> moved = places_of(transform);
    const std::size_t turn = transform.find("rotate(");
    const double angle = turn == std::string::npos
                             ? 0.0
                             : std::strtod(transform.c_str() + turn + 7, nullptr) * std::acos(-1.0) / 180;
    Rectangle text;
    for (const auto& [x, y] : places_of(attribute(tag, "d")))
      text.include(moved.front().first + x * std::cos(angle) - y * std::sin(angle),
                   moved.front().second + x * std::sin(angle) + y * std::cos(angle));
    if (text.right > text.left) texts.push_back(text);
  }
  return texts;
}

std::vector<std::array<double, 4>> lines_of(const std::string& svg) {
  std::vector<std::array<double, 4>> lines;
  for (const std::string& tag : tags_of(svg, "polyline")) {
    if (!attribute(tag, "stroke-dasharray").empty()) continue;  // VTK's way of drawing nothing
    const auto places = places_of(attribute(tag, "points"));
    for (std::size_t i = 1; i < places.size(); ++i)
      lines.push_back({places[i - 1].first, places[i - 1].second, places[i].first, places[i].second});
  }
  return lines;
}

void expect_no_overlap(const std::filesystem::path& file, const std::string& what) {
  const std::string svg = file_text(file);
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\""))) << what;
  const double width = std::stod(size[1]);
  const double height = std::stod(size[2]);
  const std::vector<Rectangle> texts = texts_of(svg);
  const auto lines = lines_of(svg);
  EXPECT_GT(texts.size(), 10U) << what;
  EXPECT_GT(lines.size(), 10U) << what;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Rectangle& text = texts[i];
    EXPECT_TRUE(text.left >= 0 && text.right <= width && text.top >= 0 && text.bottom <= height)
        << what << ": a text leaves the page: " << text.text();
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(text.overlaps(texts[k]))
          << what << ": texts at " << text.text() << " and " << texts[k].text();
    for (const auto& line : lines)
      EXPECT_FALSE(text.crossed_by(line))
          << what << ": the text at " << text.text() << " is crossed by a line from " << line[0] << ", "
          << line[1] << " to " << line[2] << ", " << line[3];
  }
}

class ChartOverlap : public VizTest {};

TEST_F(ChartOverlap, ChartsOfARun) {
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
        expect_no_overlap(file("pictures") / (std::string(name) + ".svg"),
                          std::string(name) + " of '" + title + "'");
    }
  }
}

TEST_F(ChartOverlap, Comparisons) {
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
    expect_no_overlap(file("table.svg"), std::to_string(series) + " series compared");
  }
}

}  // namespace
}  // namespace hfrac::viz_test
