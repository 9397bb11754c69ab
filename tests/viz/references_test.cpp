// SPDX-License-Identifier: BSD-3-Clause
// Pictures against committed ones. Letters and edges differ a little between versions of VTK, Mesa and FreeType, so both
// are blurred over a few pixels and compared as the eye does, by their distance in CIELAB (1976); what is in the wrong
// place or colour still stands out. HFRAC_WRITE_REFERENCES=1 writes the references anew: look at them before they are
// committed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "picture_file.h"
#include "viz_fixture.h"

namespace hfrac::viz_test {
namespace {

// Lightness, green to red, blue to yellow of each pixel.
using Lab = std::vector<std::array<double, 3>>;

double linear(int value) {
  const double share = value / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

double curved(double share) {
  return share > 216.0 / 24389 ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
}

// sRGB under D65.
Lab lab_of(const Picture& picture) {
  Lab lab(static_cast<std::size_t>(picture.width) * picture.height);
  for (std::size_t i = 0; i < lab.size(); ++i) {
    const double r = linear(picture.rgb[3 * i]);
    const double g = linear(picture.rgb[3 * i + 1]);
    const double b = linear(picture.rgb[3 * i + 2]);
    const double x = curved((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = curved(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = curved((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    lab[i] = {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }
  return lab;
}

// The mean over 2 radius + 1 pixels along one direction.
Lab blurred(const Lab& lab, int width, int height, bool across) {
  constexpr int radius = 2;
  Lab out(lab.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::array<double, 3> sum{};
      for (int k = -radius; k <= radius; ++k) {
        const int column = std::clamp(across ? x + k : x, 0, width - 1);
        const int row = std::clamp(across ? y : y + k, 0, height - 1);
        const auto& one = lab[static_cast<std::size_t>(row) * width + column];
        for (int c = 0; c < 3; ++c) sum[c] += one[c] / (2 * radius + 1);
      }
      out[static_cast<std::size_t>(y) * width + x] = sum;
    }
  }
  return out;
}

Lab seen(const Picture& picture) {
  return blurred(blurred(lab_of(picture), picture.width, picture.height, true), picture.width, picture.height,
                 false);
}

struct Distance {
  double mean = 1e9;
  double worst = 1e9;  // all but a five-hundredth of the pixels are nearer
};

Distance distance(const Picture& one, const Picture& other) {
  if (one.width != other.width || one.height != other.height || one.rgb.empty()) return {};
  const Lab a = seen(one);
  const Lab b = seen(other);
  std::vector<double> all(a.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    all[i] = std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]);
    sum += all[i];
  }
  const auto place = all.begin() + static_cast<std::ptrdiff_t>(0.998 * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), place, all.end());
  return {sum / static_cast<double>(a.size()), *place};
}

// A just noticeable difference is about 2.3; letters moved by a pixel stay below these after the blur.
constexpr double mean_allowed = 0.6;
constexpr double worst_allowed = 12;

bool alike(const Distance& found) {
  return found.mean < mean_allowed && found.worst < worst_allowed;
}

class References : public VizTest {
 protected:
  References() {
    hfrac_viz_view_options_init(&views, sizeof views);
    hfrac_viz_chart_options_init(&charts, sizeof charts);
    options.width = views.width = charts.width = 480;
  }
  // Before write_run: everything there is to draw.
  void with_everything() {
    run.with_temperature = true;
    write_run(folder(), run);
  }
  std::filesystem::path picture_of(std::int32_t kind) {
    EXPECT_EQ(render_picture(kind, file("p.png")).status, HFRAC_OK);
    return file("p.png");
  }
  std::filesystem::path views_of(const std::vector<const char*>& names) {
    EXPECT_EQ(hfrac_viz_render_views(folder().c_str(), names.data(), static_cast<std::int32_t>(names.size()),
                                     file("p.png").c_str(), &views),
              HFRAC_OK);
    return file("p.png");
  }
  std::filesystem::path chart_of(std::int32_t kind, const char* name) {
    charts.charts = kind;
    EXPECT_EQ(hfrac_viz_render_charts(folder().c_str(), &charts, nullptr, nullptr), HFRAC_OK);
    return file("pictures") / (std::string(name) + ".png");
  }
  void compare(const std::filesystem::path& drawn, const std::string& name) {
    const std::filesystem::path reference = std::filesystem::path(HFRAC_REFERENCES) / (name + ".png");
    if (std::getenv("HFRAC_WRITE_REFERENCES") != nullptr) {
      std::filesystem::copy_file(drawn, reference, std::filesystem::copy_options::overwrite_existing);
      return;
    }
    ASSERT_TRUE(std::filesystem::exists(reference)) << reference;
    const Distance found = distance(read_picture(drawn), read_picture(reference));
    if (alike(found)) return;
    const auto kept = std::filesystem::temp_directory_path() / ("hfrac-unlike-" + name + ".png");
    std::filesystem::copy_file(drawn, kept, std::filesystem::copy_options::overwrite_existing);
    ADD_FAILURE() << name << ": mean " << found.mean << ", worst " << found.worst << " in CIELAB; see "
                  << kept;
  }

  hfrac_viz_view_options views;
  hfrac_viz_chart_options charts;
};

TEST_F(References, Pictures) {
  write_run(folder(), run);
  compare(picture_of(HFRAC_VIZ_MODEL), "model");
  compare(picture_of(HFRAC_VIZ_STAGE), "stage");
  compare(picture_of(HFRAC_VIZ_GROWTH), "growth");
  compare(picture_of(HFRAC_VIZ_PRESSURE), "pressure");
  compare(picture_of(HFRAC_VIZ_APERTURE), "aperture");
  compare(picture_of(HFRAC_VIZ_MOVIE), "frame");
  options.dark = 1;
  compare(picture_of(HFRAC_VIZ_GROWTH), "dark-growth");
}

TEST_F(References, Views) {
  with_everything();
  compare(views_of({"forces", "stress", "displacement", "bonds"}), "views");
  views.dark = 1;
  compare(views_of({"temperature", "stress", "pressure", "forces"}), "dark-views");
  views.zoom = HFRAC_VIZ_ZOOM_TIP;
  compare(views_of({"crack-time"}), "dark-tip");
}

TEST_F(References, Charts) {
  write_run(folder(), run);
  compare(chart_of(HFRAC_VIZ_CHART_HISTORY, "history"), "history");
  compare(chart_of(HFRAC_VIZ_CHART_ROSE, "rose"), "rose");
  compare(chart_of(HFRAC_VIZ_CHART_PROFILE, "profile"), "profile");
  compare(chart_of(HFRAC_VIZ_CHART_EVENTS, "events"), "events");
  compare(chart_of(HFRAC_VIZ_CHART_CATALOGUE, "catalogue"), "catalogue");
  charts.dark = 1;
  compare(chart_of(HFRAC_VIZ_CHART_CATALOGUE, "catalogue"), "dark-catalogue");
}

// The measure itself: what must not pass does not, what may differ does.
TEST_F(References, TheMeasureSeesWhatMattersAndNothingElse) {
  write_run(folder(), run);
  const Picture whole = read_picture(picture_of(HFRAC_VIZ_STAGE));
  options.snapshot = 1;
  const Picture shorter = read_picture(picture_of(HFRAC_VIZ_STAGE));  // a crack that is half as long
  EXPECT_FALSE(alike(distance(whole, shorter)));

  Picture noisy = whole;
  for (std::size_t i = 0; i < noisy.rgb.size(); ++i) {
    const int changed = noisy.rgb[i] + static_cast<int>(i * 2654435761U % 7) - 3;
    noisy.rgb[i] = static_cast<std::uint8_t>(std::clamp(changed, 0, 255));
  }
  EXPECT_TRUE(alike(distance(whole, noisy)));

  Picture tinted = whole;
  for (std::size_t i = 2; i < tinted.rgb.size(); i += 3)
    tinted.rgb[i] = static_cast<std::uint8_t>(tinted.rgb[i] * 0.9);
  EXPECT_FALSE(alike(distance(whole, tinted)));
}

}  // namespace
}  // namespace hfrac::viz_test
