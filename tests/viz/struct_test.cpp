// SPDX-License-Identifier: BSD-3-Clause
// Option structs of hosts that were compiled against another header: shorter, longer, or never filled.
#include <algorithm>
#include <cstring>
#include <vector>

#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

using Structs = VizTest;

// A struct inside a larger buffer whose rest shows whether it was touched.
template <class Options>
struct Surrounded {
  std::vector<unsigned char> bytes = std::vector<unsigned char>(sizeof(Options) + 64, 0xAB);
  Options* options() { return reinterpret_cast<Options*>(bytes.data()); }
  bool untouched_from(std::size_t size) const {
    return std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(size), bytes.end(),
                       [](unsigned char byte) { return byte == 0xAB; });
  }
};

template <class Options, class Init>
void expect_grows(const Init& init) {
  for (const std::size_t size :
       {sizeof(Options), sizeof(Options) - 4, std::size_t{8}, sizeof(Options) + 16}) {
    Surrounded<Options> host;
    ASSERT_EQ(init(host.options(), static_cast<std::int32_t>(size)), HFRAC_OK) << size;
    EXPECT_TRUE(host.untouched_from(size)) << size;
    std::int32_t noted = 0;
    std::memcpy(&noted, host.bytes.data(), sizeof noted);
    EXPECT_EQ(noted, static_cast<std::int32_t>(size));
  }
  Surrounded<Options> host;
  for (const std::int32_t size : {0, -8, 4, 30, 1 << 20}) {
    EXPECT_EQ(init(host.options(), size), HFRAC_ERR_STRUCT_SIZE) << size;
  }
  EXPECT_TRUE(host.untouched_from(0));
  EXPECT_EQ(init(nullptr, static_cast<std::int32_t>(sizeof(Options))), HFRAC_ERR_ARGUMENT);
}

TEST_F(Structs, InitWritesNoFurtherThanTheHostsStruct) {
  expect_grows<hfrac_viz_options>(hfrac_viz_options_init);
  expect_grows<hfrac_viz_chart_options>(hfrac_viz_chart_options_init);
  expect_grows<hfrac_viz_view_options>(hfrac_viz_view_options_init);
  expect_grows<hfrac_viz_comparison_options>(hfrac_viz_comparison_options_init);
}

TEST_F(Structs, AShorterStructMeansDefaultsForTheRest) {
  write_run(folder(), run);
  // A host that knows no further than `width`.
  std::array<std::int32_t, 4> old{};
  old[0] = sizeof old;
  old[1] = 1;
  old[3] = 400;
  EXPECT_EQ(hfrac_viz_render_picture(folder().c_str(), HFRAC_VIZ_STAGE, file("old.png").c_str(),
                                     reinterpret_cast<const hfrac_viz_options*>(old.data())),
            HFRAC_OK);
  options.width = 400;
  EXPECT_EQ(render_picture(HFRAC_VIZ_STAGE, file("new.png")).status, HFRAC_OK);
  EXPECT_EQ(std::filesystem::file_size(file("old.png")), std::filesystem::file_size(file("new.png")));
}

TEST_F(Structs, ALongerStructMayNotAskForWhatIsUnknown) {
  write_run(folder(), run);
  struct Newer {
    hfrac_viz_options known;
    std::int32_t unknown[2];
  } newer{};
  hfrac_viz_options_init(&newer.known, sizeof newer);
  newer.known.width = 400;
  const auto draw = [&] {
    return hfrac_viz_render_picture(folder().c_str(), HFRAC_VIZ_STAGE, file("p.png").c_str(), &newer.known);
  };
  EXPECT_EQ(draw(), HFRAC_OK);
  newer.unknown[1] = 1;
  EXPECT_EQ(draw(), HFRAC_ERR_STRUCT_SIZE);
}

}  // namespace
}  // namespace hfrac::viz_test
