/* SPDX-License-Identifier: BSD-3-Clause */
/* The header in plain C99: every function is called once, as a C host would, on a run and into a folder given. */
#include <stdio.h>

#include "hfrac/viz.h"

const char* hfrac_viz_test_from_c(const char* run_dir, const char* folder);

static char error[2048];
static char text[1024];

static const char* in_folder(const char* folder, const char* name) {
  snprintf(text, sizeof text, "%s/%s", folder, name);
  return text;
}

static int32_t no_news(void* user, double fraction, const char* what) {
  (void)what;
  *(double*)user = fraction;
  return 0;
}

#define GOOD(call) \
  if ((call) != HFRAC_OK) return #call

/* The call that failed, or NULL. */
const char* hfrac_viz_test_from_c(const char* run_dir, const char* folder) {
  const int32_t capacity = (int32_t)sizeof error;
  const char* views[2] = {"discs", "pressure"};
  int32_t snapshots[8];
  int32_t stages[5];
  int32_t count = 0;
  int32_t needed = 0;
  double share = 0.0;
  hfrac_viz_options options;
  hfrac_viz_chart_options charts;
  hfrac_viz_view_options view;
  hfrac_viz_comparison_options compared;
  hfrac_viz_trace_options traced;
  FILE* table;

  GOOD(hfrac_viz_options_init(&options, (int32_t)sizeof options));
  GOOD(hfrac_viz_chart_options_init(&charts, (int32_t)sizeof charts));
  GOOD(hfrac_viz_view_options_init(&view, (int32_t)sizeof view));
  GOOD(hfrac_viz_comparison_options_init(&compared, (int32_t)sizeof compared));
  GOOD(hfrac_viz_trace_options_init(&traced, (int32_t)sizeof traced));
  traced.width = 320;
  options.width = charts.width = view.width = compared.width = 320;
  options.movie_width = 320;
  options.pictures = HFRAC_VIZ_MODEL;
  GOOD(hfrac_viz_renderer_info(error, capacity, &needed));
  GOOD(hfrac_viz_snapshot_count(run_dir, &count));
  GOOD(hfrac_viz_snapshots(run_dir, snapshots, 8, &count));
  GOOD(hfrac_viz_stages(run_dir, stages, &count));
  GOOD(hfrac_viz_render_run(run_dir, &options, no_news, &share));
  if (share != 1.0) return "the progress of hfrac_viz_render_run";
  GOOD(hfrac_viz_render_picture(run_dir, HFRAC_VIZ_MODEL, in_folder(folder, "c.png"), &options));
  GOOD(hfrac_viz_render_movie(run_dir, in_folder(folder, "c.mp4"), &options, NULL, NULL));
  GOOD(hfrac_viz_render_charts(run_dir, &charts, NULL, NULL));
  GOOD(hfrac_viz_render_views(run_dir, views, 2, in_folder(folder, "views.png"), &view));
  GOOD(hfrac_viz_view_names(error, capacity, &needed));
  {
    const char* names[1] = {"radius_m"};
    hfrac_sim* none = NULL;
    if (hfrac_viz_render_sim(none, names, 1, in_folder(folder, "sim.png"), &view) != HFRAC_ERR_ARGUMENT)
      return "hfrac_viz_render_sim without a simulation";
  }
  GOOD(hfrac_viz_last_error(error, capacity, &needed));
  if (needed <= 1) return "hfrac_viz_last_error";
  table = fopen(in_folder(folder, "c.csv"), "w");
  if (table == NULL) return "fopen";
  fputs("series,x,y\n,1,1\n,2,2\n", table);
  fclose(table);
  {
    char picture[1024];
    snprintf(picture, sizeof picture, "%s/compared.png", folder);
    GOOD(hfrac_viz_render_comparison(in_folder(folder, "c.csv"), picture, &compared));
  }
  {
    const double ends[8] = {10, 10, 90, 50, 20, 80, 70, 20};
    const int32_t sets[2] = {0, 1};
    GOOD(hfrac_viz_render_traces(ends, sets, 2, in_folder(folder, "traces.png"), &traced));
  }
  GOOD(hfrac_viz_write_report(run_dir, in_folder(folder, "c.html")));
  GOOD(hfrac_viz_write_paraview_script(run_dir));
  return NULL;
}
