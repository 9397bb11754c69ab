// SPDX-License-Identifier: BSD-3-Clause
// The C interface of comparisons: a table in, a picture or a vector file out.
#include "comparison.h"
#include "failure.h"
#include "guarded_call.h"
#include "hfrac/viz.h"
#include "offscreen_window.h"
#include "option_struct.h"
#include "page_files.h"

namespace hfrac::viz {
namespace {

hfrac_viz_comparison_options defaults() {
  hfrac_viz_comparison_options options{};
  options.struct_size = static_cast<int32_t>(sizeof options);
  options.struct_version = 1;
  options.width = 1600;
  return options;
}

hfrac_viz_comparison_options checked(const hfrac_viz_comparison_options* options) {
  const hfrac_viz_comparison_options own = read_options("hfrac_viz_comparison_options", options, defaults());
  check_range("width", own.width, 320, 8192);
  check_range("dots_per_inch", own.dots_per_inch, 36, 2400, true);
  return own;
}

std::string text_or_empty(const char* text) {
  return text != nullptr ? text : "";
}

void render_comparison(const std::filesystem::path& table, const std::filesystem::path& target,
                       const hfrac_viz_comparison_options& options) {
  const Comparison comparison = read_comparison(table);
  const PaletteScope paper(options.dark != 0 ? dark_palette() : light_palette());
  const auto window = make_offscreen_window();
  const ComparisonTexts texts{text_or_empty(options.title), text_or_empty(options.x_label)};
  const PageContent content{texts.title.empty() ? "Runs compared" : texts.title,
                            comparison_height(comparison),
                            [&](ChartPage& page) { fill_comparison(page, comparison, texts); }};
  write_page(target, content, window, {options.width, options.dots_per_inch});
}

}  // namespace
}  // namespace hfrac::viz

using namespace hfrac::viz;

extern "C" {

int32_t hfrac_viz_comparison_options_init(hfrac_viz_comparison_options* options, int32_t struct_size) {
  return init_options(options, struct_size, defaults());
}

int32_t hfrac_viz_render_comparison(const char* table, const char* path,
                                    const hfrac_viz_comparison_options* options, char* error,
                                    int32_t capacity, int32_t* needed) {
  return call(error, capacity, needed, [&] {
    render_comparison(required_text(table, "table"), required_text(path, "path"), checked(options));
  });
}

}  // extern "C"
