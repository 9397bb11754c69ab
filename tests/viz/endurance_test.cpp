// SPDX-License-Identifier: BSD-3-Clause
// Many renders in one process: no growth, from any thread, and a C caller.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

#include "picture_file.h"
#include "viz_fixture.h"

extern "C" const char* hfrac_viz_test_from_c(const char* run_dir, const char* folder);

namespace hfrac::viz_test {
namespace {

class Endurance : public VizTest {};

double resident_megabytes() {
  std::ifstream statm("/proc/self/statm");
  long total = 0;
  long resident = 0;
  statm >> total >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST_F(Endurance, FiftyRendersDoNotGrow) {
  write_run(folder(), run);
  options.width = 500;
  double before = 0;
  for (int i = 0; i < 60; ++i) {
    const int kind = i % 2 == 0 ? HFRAC_VIZ_STAGE : HFRAC_VIZ_PRESSURE;
    ASSERT_EQ(render_picture(kind, file("picture.png")).status, HFRAC_OK);
    if (i == 9) before = resident_megabytes();
  }
  EXPECT_LT(resident_megabytes() - before, 12.0);
}

// Every kind of picture in turn, a thousand of them: what grows by a tenth of a megabyte each is found.
class Thousand : public Endurance {};

TEST_F(Thousand, RendersDoNotGrow) {
  write_run(folder(), run);
  options.width = 400;
  hfrac_viz_view_options views;
  hfrac_viz_view_options_init(&views, sizeof views);
  views.width = 400;
  hfrac_viz_chart_options charts;
  hfrac_viz_chart_options_init(&charts, sizeof charts);
  charts.charts = HFRAC_VIZ_CHART_PROFILE;
  charts.width = 400;
  double before = 0;
  for (int i = 0; i < 1000; ++i) {
    static constexpr std::array<const char*, 12> names = {
        "discs",        "forces",   "crack-time", "aperture",  "pressure",  "bonds",
        "displacement", "rotation", "stress",     "stress-xx", "stress-yy", "stress-xy"};
    const char* view = names[i % names.size()];
    std::int32_t status = HFRAC_OK;
    if (i % 10 == 9) {
      status = hfrac_viz_render_charts(folder().c_str(), &charts, nullptr, nullptr);
    } else if (i % 2 == 0) {
      views.dark = i % 4 == 0 ? 1 : 0;
      status = hfrac_viz_render_views(folder().c_str(), &view, 1, file("view.png").c_str(), &views);
    } else {
      status = render_picture(HFRAC_VIZ_STAGE, file("picture.png")).status;
    }
    ASSERT_EQ(status, HFRAC_OK) << i;
    if (i == 99) before = resident_megabytes();
  }
  EXPECT_LT(resident_megabytes() - before, 20.0);
}

TEST_F(Endurance, ThreadsTakeTurnsAndAgree) {
  write_run(folder(), run);
  options.width = 400;
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([this, i] {
      EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("picture_" + std::to_string(i) + ".png")).status,
                HFRAC_OK);
    });
  }
  for (std::thread& thread : threads) thread.join();
  const Picture first = read_picture(file("picture_0.png"));
  EXPECT_EQ(first.rgb, read_picture(file("picture_1.png")).rgb);
  EXPECT_EQ(first.rgb, read_picture(file("picture_2.png")).rgb);
}

TEST_F(Endurance, FromC) {
  write_run(folder(), run);
  const char* failed = hfrac_viz_test_from_c(folder().c_str(), folder().c_str());
  EXPECT_EQ(failed, nullptr) << failed;
  EXPECT_EQ(read_picture(file("c.png")).width, 320);
}

TEST_F(Endurance, RendererSaysWhatItIs) {
  std::array<char, 400> text{};
  std::int32_t needed = 0;
  ASSERT_EQ(hfrac_viz_renderer_info(text.data(), text.size(), &needed), HFRAC_OK) << text.data();
  EXPECT_NE(std::string(text.data()).find("OpenGL"), std::string::npos);
  EXPECT_EQ(static_cast<std::size_t>(needed), std::strlen(text.data()) + 1);
}

TEST_F(Endurance, SnapshotsAreListed) {
  write_run(folder(), run);
  std::int32_t count = 0;
  ASSERT_EQ(hfrac_viz_snapshot_count(folder().c_str(), &count), HFRAC_OK);
  EXPECT_EQ(count, 3);
  std::array<std::int32_t, 2> numbers{};
  ASSERT_EQ(hfrac_viz_snapshots(folder().c_str(), numbers.data(), 2, &count), HFRAC_OK);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(numbers[0], 0);
  EXPECT_EQ(numbers[1], 1);
}

}  // namespace
}  // namespace hfrac::viz_test
