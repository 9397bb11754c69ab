// SPDX-License-Identifier: BSD-3-Clause
// What is where in the pictures, pixel by pixel, for a run known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

using Pictures = VizTest;

TEST_F(Pictures, WholeRunMakesEveryPictureOfTheRightSize) {
  run.snapshots = 6;
  write_run(folder(), run);
  options.width = 800;
  options.movie_width = 640;
  const Result result = render_run();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_EQ(result.text, "");
  for (const char* name : {"model.png", "growth_1.png", "growth_2.png", "growth_3.png", "growth_4.png",
                           "growth_5.png", "growth.png", "pressure.png", "aperture.png"}) {
    const Picture picture = read_picture(file("pictures") / name);
    EXPECT_EQ(picture.width, 800) << name;
    EXPECT_GT(picture.height, 400) << name;
    EXPECT_GT(picture.share(0, 0, picture.width, picture.height, [](Pixel p) { return !p.is_white(); }), 0.25)
        << name;
    EXPECT_TRUE(picture.at(2, picture.height - 3).is_white()) << name;
  }
  EXPECT_GT(std::filesystem::file_size(file("pictures") / "movie.mp4"), 1000U);
  EXPECT_EQ(leftovers(file("pictures")), 0);
}

TEST_F(Pictures, GivenHeightIsKept) {
  write_run(folder(), run);
  options.width = 900;
  options.height = 700;
  for (const int kind :
       {HFRAC_VIZ_MODEL, HFRAC_VIZ_STAGE, HFRAC_VIZ_GROWTH, HFRAC_VIZ_PRESSURE, HFRAC_VIZ_APERTURE}) {
    const Result result = render_picture(kind, file("picture.png"));
    ASSERT_EQ(result.status, HFRAC_OK) << result.text;
    const Picture picture = read_picture(file("picture.png"));
    EXPECT_EQ(picture.width, 900);
    EXPECT_EQ(picture.height, 700);
  }
}

TEST_F(Pictures, ModelShowsDiscsContactsAndTheWell) {
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_MODEL, file("model.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("model.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  EXPECT_TRUE(picture.at(view.x(run.well_x()), view.y(run.well_y())).is_red());
  const double yellow =
      picture.share(view.left, view.top, view.right, view.bottom, [](Pixel p) { return p.is_yellow(); });
  EXPECT_GT(yellow, 0.5);
  EXPECT_LT(yellow, std::acos(-1.0) / 4);  // discs on a square lattice fill no more
  // On the line between the centres of two neighbours: a contact. Beside it: disc.
  const double x = 4 * run.spacing();
  const double y = 4.5 * run.spacing();
  EXPECT_TRUE(picture.at(view.x(x), view.y(y)).is_dark());
  EXPECT_TRUE(picture.at(view.x(x + 0.25 * run.spacing()), view.y(y + 0.25 * run.spacing())).is_yellow());
  // Between four discs: nothing.
  EXPECT_TRUE(picture.at(view.x(x), view.y(5 * run.spacing())).is_white());
}

TEST_F(Pictures, CracksAreWhereTheyAreAndNowhereElse) {
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_STAGE, file("stage.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("stage.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  int dark = 0;
  int magenta = 0;
  int crack_pixels = 0;
  for (double x = run.well_radius + run.spacing(); x < run.half_length - run.spacing(); x += 0.05) {
    for (const double side : {-1.0, 1.0}) {
      const Pixel pixel = picture.at(view.x(run.well_x() + side * x), view.y(run.well_y()));
      dark += pixel.is_dark() ? 1 : 0;
      magenta += pixel.is_magenta() ? 1 : 0;
      ++crack_pixels;
    }
  }
  EXPECT_EQ(dark + magenta, crack_pixels);
  EXPECT_GT(dark, crack_pixels / 2);
  EXPECT_GT(magenta, 0);
  const auto crack_colour = [](Pixel p) { return p.is_dark() || p.is_magenta(); };
  EXPECT_EQ(
      picture.share(view.left + 4, view.top + 4, view.right - 4, view.y(run.well_y() + 0.5), crack_colour),
      0.0);
  EXPECT_EQ(
      picture.share(view.left + 4, view.y(run.well_y() - 0.5), view.right - 4, view.bottom - 4, crack_colour),
      0.0);
  EXPECT_EQ(picture.share(view.left + 4, view.top + 4, view.x(run.well_x() - run.half_length - 0.6),
                          view.bottom - 4, crack_colour),
            0.0);
}

TEST_F(Pictures, FirstStageHasNoCrackYet) {
  write_run(folder(), run);
  options.snapshot = 0;
  const Result result = render_picture(HFRAC_VIZ_STAGE, file("stage.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("stage.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  EXPECT_FALSE(picture.at(view.x(run.well_x() + 0.7 * run.half_length), view.y(run.well_y())).is_dark());
}

TEST_F(Pictures, PressureIsHighAtTheWellAndLowFarAway) {
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_PRESSURE, file("pressure.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("pressure.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  const Pixel well = picture.at(view.x(run.well_x()), view.y(run.well_y() + 0.5));
  EXPECT_GT(well.red, 230);
  EXPECT_GT(well.green, 210);
  EXPECT_LT(well.blue, 100);
  const Pixel corner = picture.at(view.x(0.6), view.y(0.6));
  EXPECT_LT(corner.red, 80);
  EXPECT_LT(corner.green, 80);
  EXPECT_GT(corner.blue, 80);
  // The ring around the well.
  EXPECT_GT(picture.share(view.x(run.well_x() - 2), view.y(run.well_y() + 2), view.x(run.well_x() + 2),
                          view.y(run.well_y() - 2), [](Pixel p) { return p.is_red(); }),
            0.001);
}

TEST_F(Pictures, ApertureIsDarkAtTheWellAndLightAtTheTip) {
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_APERTURE, file("aperture.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("aperture.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  const auto any = [](Pixel) { return true; };
  ASSERT_EQ(picture.share(view.left, view.top, view.right, view.bottom, any), 1.0);
  // The view is a close-up centred on the well; the widest crack is next to the well, the narrowest at the
  // tips.
  const int middle = (view.top + view.bottom) / 2;
  int amber = 0;
  int purple = 0;
  for (int x = view.left + 5; x < view.right - 5; ++x) {
    const Pixel pixel = picture.at(x, middle);
    amber += pixel.red > 220 && pixel.green > 80 && pixel.blue < 90 ? 1 : 0;
    purple += pixel.red < 150 && pixel.green < 40 && pixel.blue > 40 ? 1 : 0;
  }
  EXPECT_GT(amber, 10);
  EXPECT_GT(purple, 50);
}

TEST_F(Pictures, NoDisplayIsNeededAndAWrongOneDoesNoHarm) {
  write_run(folder(), run);
  const char* before = std::getenv("DISPLAY");
  const std::string kept = before != nullptr ? before : "";
  ::unsetenv("DISPLAY");
  const Result without = render_picture(HFRAC_VIZ_STAGE, file("without.png"));
  ::setenv("DISPLAY", ":99", 1);
  const Result wrong = render_picture(HFRAC_VIZ_STAGE, file("wrong.png"));
  kept.empty() ? ::unsetenv("DISPLAY") : ::setenv("DISPLAY", kept.c_str(), 1);
  ASSERT_EQ(without.status, HFRAC_OK) << without.text;
  ASSERT_EQ(wrong.status, HFRAC_OK) << wrong.text;
  EXPECT_EQ(read_picture(file("without.png")).rgb, read_picture(file("wrong.png")).rgb);
}

TEST_F(Pictures, OptionalFilesMayBeMissing) {
  run.with_flow = false;
  write_run(folder(), run);
  for (const char* name : {"summary.json", "bonds.pvd", "cracks.pvd"}) std::filesystem::remove(file(name));
  options.pictures = HFRAC_VIZ_ALL & ~HFRAC_VIZ_MOVIE;
  const Result result = render_run();
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  EXPECT_TRUE(std::filesystem::exists(file("pictures") / "aperture.png"));
  EXPECT_FALSE(std::filesystem::exists(file("pictures") / "pressure.png"));
}

TEST_F(Pictures, WellWithoutFlowIsACircle) {
  run.with_flow = false;
  write_run(folder(), run);
  const Result result = render_picture(HFRAC_VIZ_MODEL, file("model.png"));
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("model.png"));
  const FramedView view = find_view(picture, run.width, run.height);
  EXPECT_TRUE(picture.at(view.x(run.well_x()), view.y(run.well_y())).is_red());
}

TEST_F(Pictures, StagesRiseAndEndAtTheLastSnapshot) {
  run.snapshots = 21;
  write_run(folder(), run);
  std::array<std::int32_t, 5> stages{};
  std::int32_t count = 0;
  ASSERT_EQ(hfrac_viz_stages(folder().c_str(), stages.data(), &count), HFRAC_OK);
  ASSERT_EQ(count, 5);
  for (int i = 1; i < 5; ++i) EXPECT_GT(stages[i], stages[i - 1]);
  EXPECT_EQ(stages[4], 20);
  EXPECT_GT(stages[0], 0);
}

}  // namespace
}  // namespace hfrac::viz_test
