// SPDX-License-Identifier: BSD-3-Clause
// Traces of natural fractures on a page: where the numbers say, in each format, and what is refused.
#include <cmath>
#include <vector>

#include "file_text.h"
#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

class Traces : public VizTest {
 protected:
  Traces() {
    hfrac_viz_trace_options_init(&traced, sizeof traced);
    traced.frame_width = traced.frame_height = 100.0;
  }

  Result draw(const std::vector<double>& ends, const std::vector<std::int32_t>& sets,
              const std::string& name) {
    return result_of(hfrac_viz_render_traces(ends.data(), sets.empty() ? nullptr : sets.data(),
                                             static_cast<std::int64_t>(ends.size() / 4), file(name).c_str(),
                                             &traced));
  }

  hfrac_viz_trace_options traced;
  const std::vector<double> two = {10, 10, 90, 90, 20, 60, 70, 60};
};

bool is_coloured(const Pixel& pixel) {
  const int low = std::min({pixel.red, pixel.green, pixel.blue}),
            high = std::max({pixel.red, pixel.green, pixel.blue});
  return high - low > 60;
}

TEST_F(Traces, LieWhereTheirEndsSay) {
  const Result result = draw(two, {0, 1}, "t.png");
  ASSERT_EQ(result.status, HFRAC_OK) << result.text;
  const Picture picture = read_picture(file("t.png"));
  EXPECT_EQ(picture.width, 1600);
  // The map is 690 x 690 at (130, 240), y up.
  const auto ink = [&](double x, double y) {
    return is_coloured(picture.at(static_cast<int>(std::lround(130 + 6.9 * x)),
                                  static_cast<int>(std::lround(240 + 690 - 6.9 * y))));
  };
  EXPECT_TRUE(ink(30, 30));
  EXPECT_TRUE(ink(45, 60));
  EXPECT_FALSE(ink(30, 70));
  EXPECT_FALSE(ink(80, 60));
}

TEST_F(Traces, EveryFormatSetsAndTheStatisticsCurve) {
  const std::vector<double> lengths = {40, 80, 120}, counts = {2, 1, 0.5};
  traced.given_lengths = lengths.data();
  traced.given_counts = counts.data();
  traced.given_points = 3;
  traced.title = "Two & <sets>";
  traced.dark = 1;
  for (const char* name : {"t.svg", "t.pdf"}) {
    const Result result = draw(two, {0, 1}, name);
    EXPECT_EQ(result.status, HFRAC_OK) << result.text;
  }
  const std::string svg = file_text(file("t.svg"));
  for (const char* words : {"Two &amp; &lt;sets&gt;", "set 1", "set 2", "as asked", "2 traces"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  // Without a frame, sets and curve; a single trace along x has a frame of no height of its own.
  hfrac_viz_trace_options_init(&traced, sizeof traced);
  EXPECT_EQ(draw({10, 10, 90, 10}, {}, "one.svg").status, HFRAC_OK) << last_error();
  EXPECT_EQ(file_text(file("one.svg")).find("set 1"), std::string::npos);
}

TEST_F(Traces, ThatCannotBeDrawnAreRefused) {
  const auto refused = [&](const std::vector<double>& ends, const std::vector<std::int32_t>& sets,
                           const std::string& words) {
    const Result result = draw(ends, sets, "t.png");
    EXPECT_EQ(result.status, HFRAC_ERR_ARGUMENT) << words;
    EXPECT_NE(result.text.find(words), std::string::npos) << result.text;
  };
  refused({}, {}, "count is 0; allowed: 1 to 100000");
  refused({1, 2, 3, NAN}, {}, "trace 0 has an end");
  refused(two, {0, 12}, "sets[1] is 12; allowed: 0 to 11");
  traced.frame_width = -1.0;
  refused(two, {}, "frame");
  traced.frame_width = 100.0;
  traced.given_points = 2;
  refused(two, {}, "given_lengths or given_counts is NULL");
}

}  // namespace
}  // namespace hfrac::viz_test
