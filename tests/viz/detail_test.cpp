// SPDX-License-Identifier: BSD-3-Clause
// Models with more discs than pixels: the picture shows how much of each pixel is disc, evenly and at once.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Detail : public VizTest {
 protected:
  explicit Detail(int columns = 900) {  // of discs of little more than a pixel, 790 000 in all
    hfrac_viz_view_options_init(&views, sizeof views);
    run.columns = columns;
    run.snapshots = 1;
    run.with_flow = false;
  }
  Result render_view(const char* kind) {
    return result_of(hfrac_viz_render_views(folder().c_str(), &kind, 1, file("view.png").c_str(), &views));
  }

  // Every pixel has as much paper as there is between the discs, and wells and cracks are above them.
  void expect_even_tint() {
    write_run(folder(), run);
    const Result result = render_view("discs");
    ASSERT_EQ(result.status, HFRAC_OK) << result.text;
    const Picture picture = read_picture(file("view.png"));
    const FramedView view = find_view(picture, run.width, run.height);
    // A square lattice of touching discs covers pi / 4, the rest is paper: that much of the way to yellow's blue.
    const double blue = 255 - (255 - 87) * std::acos(-1.0) / 4;
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (int y = view.y(11); y < view.y(8); ++y) {
      for (int x = view.x(1); x < view.x(11); ++x) {
        const double value = picture.at(x, y).blue;
        sum += value;
        squares += value * value;
        ++count;
      }
    }
    const double mean = sum / count;
    EXPECT_NEAR(mean, blue, 4);
    EXPECT_LT(std::sqrt(std::max(0.0, squares / count - mean * mean)), 20);  // little pattern
    EXPECT_TRUE(picture.at(view.x(run.well_x()), view.y(run.well_y())).is_red());
    // The crack is still there: of the bonds of one pixel every fifth is drawn in shear's colour, over the others.
    const Pixel crack = picture.at(view.x(run.well_x() + 2.5), view.y(run.well_y()));
    EXPECT_TRUE(crack.is_dark() || crack.is_magenta());
  }

  hfrac_viz_view_options views;
};

class DetailLong : public Detail {
 protected:
  DetailLong() : Detail(3500) {}  // 12 million, a dozen to a pixel
};

TEST_F(Detail, DiscsBelowAPixelBecomeAnEvenTint) {
  expect_even_tint();
}

TEST_F(DetailLong, SoDoTwelveMillionDiscs) {
  expect_even_tint();
}

TEST_F(Detail, CloseUpOfTheSameModelShowsRoundDiscs) {
  write_run(folder(), run);
  views.zoom = HFRAC_VIZ_ZOOM_BOX;
  views.left = 2;
  views.bottom = 2;
  views.box_width = views.box_height = 10 * run.spacing();
  const Result result = render_view("discs");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("view.png"));
  const FramedView view = find_view(picture, 1, 1);
  const auto yellow = [](Pixel p) { return p.is_yellow(); };
  const auto white = [](Pixel p) { return p.is_white(); };
  EXPECT_GT(picture.share(view.left + 4, view.top + 4, view.right - 4, view.bottom - 4, yellow), 0.6);
  EXPECT_GT(picture.share(view.left + 4, view.top + 4, view.right - 4, view.bottom - 4, white), 0.15);
}

}  // namespace
}  // namespace hfrac::viz_test
