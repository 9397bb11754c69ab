// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <cmath>

namespace hfrac::viz {
namespace {

constexpr int all_formats = HFRAC_VIZ_PNG | HFRAC_VIZ_SVG | HFRAC_VIZ_PDF;

// What all pictures have in common.
template <class Options>
void check_pixels(const Options& o) {
  check_range("width", o.width, 320, 8192);
  check_range("dots_per_inch", o.dots_per_inch, 36, 2400, true);
}

}  // namespace

void check_range(const char* name, int value, int lowest, int highest, bool zero_allowed) {
  if ((value >= lowest && value <= highest) || (zero_allowed && value == 0)) return;
  fail_argument(std::string(name) + " is " + std::to_string(value) + "; allowed: " + std::to_string(lowest) +
                " to " + std::to_string(highest) + (zero_allowed ? ", or 0" : ""));
}

void OptionStruct<hfrac_viz_options>::set_defaults(hfrac_viz_options& o) {
  o.pictures = HFRAC_VIZ_ALL;
  o.width = 1600;
  o.movie_width = 1280;
  o.movie_seconds = 12;
  o.snapshot = -1;
  o.formats = HFRAC_VIZ_PNG;
}

void OptionStruct<hfrac_viz_options>::check(const hfrac_viz_options& o) {
  check_range("pictures", o.pictures, 0, HFRAC_VIZ_ALL);
  check_pixels(o);
  check_range("height", o.height, 240, 8192, true);
  check_range("movie_width", o.movie_width, 320, 4096);
  check_range("movie_height", o.movie_height, 240, 4096, true);
  check_range("movie_seconds", o.movie_seconds, 1, 600);
  check_range("formats", o.formats, 1, all_formats);
  if (o.movie_width % 2 != 0 || o.movie_height % 2 != 0)
    fail_argument("a movie's width and height must be even");
}

void OptionStruct<hfrac_viz_chart_options>::set_defaults(hfrac_viz_chart_options& o) {
  o.charts = HFRAC_VIZ_CHART_ALL;
  o.formats = HFRAC_VIZ_PNG;
  o.width = 1600;
}

void OptionStruct<hfrac_viz_chart_options>::check(const hfrac_viz_chart_options& o) {
  check_range("charts", o.charts, 0, HFRAC_VIZ_CHART_ALL);
  if (!std::isfinite(o.diffusivity) || o.diffusivity < 0.0)
    fail_argument("diffusivity must be 0 or more, in m2/s; 0: found from the events");
  check_range("formats", o.formats, 1, all_formats);
  check_pixels(o);
}

void OptionStruct<hfrac_viz_comparison_options>::set_defaults(hfrac_viz_comparison_options& o) {
  o.width = 1600;
}

void OptionStruct<hfrac_viz_comparison_options>::check(const hfrac_viz_comparison_options& o) {
  check_pixels(o);
}

void OptionStruct<hfrac_viz_trace_options>::set_defaults(hfrac_viz_trace_options& o) {
  o.width = 1600;
}

void OptionStruct<hfrac_viz_trace_options>::check(const hfrac_viz_trace_options& o) {
  check_pixels(o);
  const bool finite = std::isfinite(o.left) && std::isfinite(o.bottom) && std::isfinite(o.frame_width) &&
                      std::isfinite(o.frame_height);
  if (!finite || o.frame_width < 0 || o.frame_height < 0)
    fail_argument("the traces' frame must have a finite corner and a width and height of 0 m or more");
  if (o.given_points < 0 || o.given_points > 100000)
    fail_argument("given_points is " + std::to_string(o.given_points) + "; allowed: 0 to 100000");
  if (o.given_points > 0 && (o.given_lengths == nullptr || o.given_counts == nullptr))
    fail_argument("given_lengths or given_counts is NULL, but there are given_points");
}

void OptionStruct<hfrac_viz_view_options>::set_defaults(hfrac_viz_view_options& o) {
  o.snapshot = -1;
  o.width = 1600;
}

void OptionStruct<hfrac_viz_view_options>::check(const hfrac_viz_view_options& o) {
  check_pixels(o);
  check_range("height", o.height, 240, 8192, true);
  check_range("zoom", o.zoom, HFRAC_VIZ_ZOOM_WHOLE, HFRAC_VIZ_ZOOM_BOX);
  if (o.zoom != HFRAC_VIZ_ZOOM_BOX) return;
  const bool finite = std::isfinite(o.left) && std::isfinite(o.bottom) && std::isfinite(o.box_width) &&
                      std::isfinite(o.box_height);
  if (!finite || !(o.box_width > 0) || !(o.box_height > 0)) {
    fail_argument("the box to zoom on must have finite corners and a positive width and height");
  }
  constexpr double flattest = 20;
  if (std::max(o.box_width, o.box_height) > flattest * std::min(o.box_width, o.box_height)) {
    fail_argument("the box to zoom on is more than 20 times longer than wide");
  }
}

}  // namespace hfrac::viz
