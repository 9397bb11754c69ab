/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Pictures and a movie of a run, without a display.
 *
 * The renderer reads a run folder from disk (finished, or still being written), or looks at a simulation through hfrac.h. It
 * is a library of its own, libhfrac_viz. What it reads: discs.pvd, bonds.pvd, cracks.pvd and flow.pvd with their VTU files,
 * summary.json (title, stress_convention, model, wells), history.csv, cracks.csv and events.csv (charts). Only the discs are required.
 *
 * - Statuses and texts follow base.h; the codes below are added to its list. After a status below 0,
 *   hfrac_viz_last_error has the reason.
 * - Nothing is printed, the process is never ended, no display is opened or needed. (Mesa, which draws, says one line on
 *   stderr where it cannot make the folder of its shader cache, as with a HOME that is read-only;
 *   MESA_SHADER_CACHE_DISABLE=true keeps it quiet.)
 * - Pictures appear whole or not at all: each is written under another name in the same folder, then renamed.
 * - Calls are safe from any thread; drawing is done one call after another. The calling thread must not have an OpenGL
 *   context current. Calling back from inside a progress callback gives HFRAC_ERR_BUSY.
 */
#ifndef HFRAC_VIZ_H
#define HFRAC_VIZ_H

#include "hfrac/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Statuses of the renderer, besides those of base.h. Values are never renumbered. */
enum hfrac_viz_status {
  HFRAC_VIZ_INCOMPLETE = 60,  /**< drawn, but for what the run lacks the data of: hfrac_viz_last_error says what */
  HFRAC_VIZ_ERR_READ = -60,  /**< the run folder, or a file in it, is missing or damaged */
  HFRAC_VIZ_ERR_WRITE = -61, /**< a picture or the movie cannot be written; nothing is left behind */
  HFRAC_VIZ_ERR_DRAW = -62   /**< the off-screen renderer or the video encoder cannot do what is asked */
};

/** The text of the last error or note of this library on this thread: the file, value or name at fault, and what is wrong
 * with it. Empty if the last call that can fail was good. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_last_error(char *buffer, int32_t capacity, int32_t *needed);

/** What can be drawn. Values may be added together for hfrac_viz_options.pictures. */
enum hfrac_viz_picture {
  HFRAC_VIZ_MODEL = 1,     /**< model.png: discs, contacts and wells at the first snapshot (the paper's Figure 3) */
  HFRAC_VIZ_STAGE = 2,     /**< growth_1.png to growth_5.png: discs, bonds and cracks at five stages */
  HFRAC_VIZ_GROWTH = 4,    /**< growth.png: the five stages on one page (the paper's Figure 4) */
  HFRAC_VIZ_PRESSURE = 8,  /**< pressure.png: fluid pressure in the domains, cracks over it */
  HFRAC_VIZ_APERTURE = 16, /**< aperture.png: cracks by aperture, close up */
  HFRAC_VIZ_MOVIE = 32,    /**< movie.mp4: every snapshot, with the wells' pressure and the number of cracks */
  HFRAC_VIZ_ALL = 63       /**< all of them */
};

/** Kinds of files. Values may be added together for the members `formats`. */
enum hfrac_viz_format {
  HFRAC_VIZ_PNG = 1, /**< pixels */
  HFRAC_VIZ_SVG = 2, /**< lines, and letters as text */
  HFRAC_VIZ_PDF = 4  /**< lines, and letters of an embedded font */
};

/** How to draw. Fill with hfrac_viz_options_init first; members are only ever appended. */
typedef struct hfrac_viz_options {
  int32_t struct_size;    /**< sizeof(hfrac_viz_options) of the caller, set by init */
  int32_t struct_version; /**< set by init */
  int32_t pictures;       /**< sum of enum hfrac_viz_picture; default HFRAC_VIZ_ALL */
  int32_t width;          /**< [pixel] of each picture, 320 to 8192; default 1600 */
  int32_t height;         /**< [pixel] 240 to 8192, or 0: as the model's shape asks; default 0 */
  int32_t movie_width;    /**< [pixel] even, 320 to 4096; default 1280 */
  int32_t movie_height;   /**< [pixel] even, 240 to 4096, or 0: as the model's shape asks; default 0 */
  int32_t movie_seconds;  /**< [s] longest movie, 1 to 600; snapshots are left out only above 60 per second; default 12 */
  int32_t snapshot;       /**< number of the snapshot (the N of discs_N.vtu) for a single picture, pressure.png and
                               aperture.png; -1: the last (HFRAC_VIZ_MODEL: the first); default -1 */
  int32_t dark;           /**< nonzero: light on dark paper; default 0 */
  int32_t dots_per_inch;  /**< noted in the PNG files for printing, 0: not; default 0 */
  int32_t movie_follow;   /**< nonzero: while summary.json says that the run goes on, the movie follows it, written anew after
                               every ten snapshots, and is done when the run is over. MP4 only; default 0 */
  int32_t formats;        /**< of the pictures hfrac_viz_render_run draws, sum of enum hfrac_viz_format; default HFRAC_VIZ_PNG */
} hfrac_viz_options;

/** Called with the share done in [0, 1] and what is being drawn. Nonzero return stops (HFRAC_STOPPED); files already
 * written stay, the one at work is removed. */
typedef int32_t (*hfrac_viz_progress_fn)(void *user, double fraction, const char *what);

/** Defaults into `options`; `struct_size` is sizeof(hfrac_viz_options) in the caller. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_options_init(hfrac_viz_options *options, int32_t struct_size);

/** Draws what options->pictures asks for into run_dir/pictures/, which is made if missing, and writes paraview_state.py. options NULL: the defaults.
 * progress may be NULL. A picture whose data the run does not have (pressure.png without flow.pvd) is left out.
 * Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_run(const char *run_dir, const hfrac_viz_options *options,
                                       hfrac_viz_progress_fn progress, void *user);

/** Draws one picture, a single value of enum hfrac_viz_picture, to the file `path`: .png, or .svg or .pdf for circles, lines
 * and letters instead of pixels (discs too many or too small to be told apart are a picture in it). HFRAC_VIZ_STAGE draws
 * options->snapshot; HFRAC_VIZ_MOVIE draws the movie's frame of it as a picture, options->width wide. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_picture(const char *run_dir, int32_t picture, const char *path,
                                           const hfrac_viz_options *options);

/** Draws the movie to the MP4 file `path` (H.264, yuv420p, index in front), or to an animated WebP that loops if `path`
 * ends in .webp: that suits small movies, say 640 pixels wide. With
 * options->movie_follow the call returns when the run is over; while it waits for snapshots other threads may draw.
 * Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_movie(const char *run_dir, const char *path, const hfrac_viz_options *options,
                                         hfrac_viz_progress_fn progress, void *user);

/** Number of snapshots in the run so far. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_snapshot_count(const char *run_dir, int32_t *count);

/** Copies the numbers of the snapshots, in order of time, at most `capacity_snapshots` of them; *count is how many there
 * are. snapshots NULL: only *count. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_snapshots(const char *run_dir, int32_t *snapshots, int32_t capacity_snapshots,
                                      int32_t *count);

/** Numbers of the snapshots that growth_1.png to growth_5.png show; fewer than five (*count) in a run of fewer snapshots.
 * Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_stages(const char *run_dir, int32_t stages[5], int32_t *count);

/** What draws: OpenGL renderer and version, VTK and H.264 library versions, as one line. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_renderer_info(char *buffer, int32_t capacity, int32_t *needed);

/** Charts of a run. Values may be added together for hfrac_viz_chart_options.charts. */
enum hfrac_viz_chart {
  HFRAC_VIZ_CHART_HISTORY = 1, /**< history: pressures, rates, cracks, fracture, volumes, energies against time */
  HFRAC_VIZ_CHART_ROSE = 2,    /**< rose: directions of the cracks */
  HFRAC_VIZ_CHART_PROFILE = 4, /**< profile: aperture against distance from the well's wall */
  HFRAC_VIZ_CHART_EVENTS = 8,  /**< events: energy magnitudes of the cracks (Choy and Boatwright 1995), how many are at
                                     least as strong, and their b value (Aki 1965) */
  HFRAC_VIZ_CHART_CATALOGUE = 16, /**< catalogue: seismic events of events.csv: where, when, how strong, their b value,
                                     and their distance from the well against time (Shapiro et al. 1997) */
  HFRAC_VIZ_CHART_ALL = 31     /**< all of them */
};

/** How to draw charts. Fill with hfrac_viz_chart_options_init first; members are only ever appended. */
typedef struct hfrac_viz_chart_options {
  int32_t struct_size;     /**< sizeof(hfrac_viz_chart_options) of the caller, set by init */
  int32_t struct_version;  /**< set by init */
  int32_t charts;          /**< sum of enum hfrac_viz_chart; default HFRAC_VIZ_CHART_ALL */
  int32_t formats;         /**< sum of enum hfrac_viz_format; default HFRAC_VIZ_PNG */
  int32_t width;           /**< [pixel] of the PNG files, 320 to 8192; default 1600 */
  int32_t dots_per_inch;   /**< noted in the PNG files for printing, 0: not; default 0 */
  int32_t dark;            /**< nonzero: light on dark paper; default 0 */
  int32_t pad;             /**< 0 */
  double diffusivity;      /**< [m2/s] of the envelope in catalogue; default 0: of that around 95 % of the events */
} hfrac_viz_chart_options;

/** Defaults into `options`; `struct_size` is sizeof(hfrac_viz_chart_options) in the caller. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_chart_options_init(hfrac_viz_chart_options *options, int32_t struct_size);

/** Draws charts of history.csv, cracks.csv and events.csv into run_dir/pictures/, which is made if missing. A chart whose table the
 * run does not have (yet) is left out. options NULL: the defaults. progress may be NULL. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_charts(const char *run_dir, const hfrac_viz_chart_options *options,
                                          hfrac_viz_progress_fn progress, void *user);

/** How to draw a comparison. Fill with hfrac_viz_comparison_options_init first; members are only ever appended. */
typedef struct hfrac_viz_comparison_options {
  int32_t struct_size;    /**< sizeof(hfrac_viz_comparison_options) of the caller, set by init */
  int32_t struct_version; /**< set by init */
  int32_t width;          /**< [pixel] of a PNG file, 320 to 8192; default 1600 */
  int32_t dots_per_inch;  /**< noted in a PNG file for printing, 0: not; default 0 */
  int32_t dark;           /**< nonzero: light on dark paper; default 0 */
  int32_t reserved;       /**< 0 */
  const char *title;      /**< heading of the page, UTF-8; NULL: "Runs compared" */
  const char *x_label;    /**< under the x axes, UTF-8, as it stands; NULL: made from the table's column */
} hfrac_viz_comparison_options;

/** Defaults into `options`; `struct_size` is sizeof(hfrac_viz_comparison_options) in the caller. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_comparison_options_init(hfrac_viz_comparison_options *options, int32_t struct_size);

/** Draws runs against each other from the CSV file `table` to `path` (.png, .svg or .pdf). Its first line names the
 * columns: the series (a word or a number), x, then 1 to 6 quantities, a panel each; NAME_spread is the half length of
 * NAME's error bars. Names end with their SI unit as in history.csv, or with "(unit)", which is taken as it stands.
 * Lines of equal series and x are runs of different packings: their mean is drawn, their standard deviation as its
 * spread, and the single runs faintly. At most 12 series. options NULL: the defaults. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_comparison(const char *table, const char *path,
                                              const hfrac_viz_comparison_options *options);

/** How to draw traces of natural fractures. Fill with hfrac_viz_trace_options_init first; members are only ever appended. */
typedef struct hfrac_viz_trace_options {
  int32_t struct_size;    /**< sizeof(hfrac_viz_trace_options) of the caller, set by init */
  int32_t struct_version; /**< set by init */
  int32_t width;          /**< [pixel] of a PNG file, 320 to 8192; default 1600 */
  int32_t dots_per_inch;  /**< noted in a PNG file for printing, 0: not; default 0 */
  int32_t dark;           /**< nonzero: light on dark paper; default 0 */
  int32_t reserved;       /**< 0 */
  const char *title;      /**< heading of the page, UTF-8; NULL: "Natural fractures" */
  double left;            /**< [m] lower left corner of the model */
  double bottom;          /**< [m] */
  double frame_width;     /**< [m] of the model; 0: the rectangle around the traces */
  double frame_height;    /**< [m] */
  const double *given_lengths; /**< [m] rising: where the statistics' curve is given; NULL: none */
  const double *given_counts;  /**< how many traces are expected to be at least as long, one for each length */
  int64_t given_points;        /**< how many */
} hfrac_viz_trace_options;

/** Defaults into `options`; `struct_size` is sizeof(hfrac_viz_trace_options) in the caller. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_viz_trace_options_init(hfrac_viz_trace_options *options, int32_t struct_size);

/** Draws traces on one page to `path` (.png, .svg or .pdf): their map, a rose of their directions weighted by length, and how many are at
 * least as long as each length. `ends` holds x and y of both ends of each [m], `sets` which set each is of, from 0; NULL: all of one. At
 * most 100 000 traces, 12 sets. options NULL: the defaults. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_viz_render_traces(const double *ends, const int32_t *sets, int64_t count,
                                                   const char *path, const hfrac_viz_trace_options *options);

/** Which part of the model a view shows. */
enum hfrac_viz_zoom {
  HFRAC_VIZ_ZOOM_WHOLE = 0,  /**< all of it */
  HFRAC_VIZ_ZOOM_CRACKS = 1, /**< the cracks and the wells, with room around them */
  HFRAC_VIZ_ZOOM_WELL = 2,   /**< the first well */
  HFRAC_VIZ_ZOOM_TIP = 3,    /**< the crack tip farthest from the wells; the well if there are no cracks */
  HFRAC_VIZ_ZOOM_BOX = 4     /**< the box given by left, bottom, box_width, box_height */
};

/** How to draw views. Fill with hfrac_viz_view_options_init first; members are only ever appended. */
typedef struct hfrac_viz_view_options {
  int32_t struct_size;    /**< sizeof(hfrac_viz_view_options) of the caller, set by init */
  int32_t struct_version; /**< set by init */
  int32_t snapshot;       /**< number of the snapshot (the N of discs_N.vtu), -1: the last; default -1 */
  int32_t width;          /**< [pixel] 320 to 8192; default 1600 */
  int32_t height;         /**< [pixel] 240 to 8192, or 0: as the shape of what is shown asks; default 0 */
  int32_t dots_per_inch;  /**< of a PNG or PDF file for printing, 0: not said (PDF: 96); default 0 */
  int32_t dark;           /**< nonzero: light on dark paper; default 0 */
  int32_t zoom;           /**< enum hfrac_viz_zoom; default HFRAC_VIZ_ZOOM_WHOLE */
  double left;            /**< [m] lower left corner of the box, for HFRAC_VIZ_ZOOM_BOX */
  double bottom;          /**< [m] */
  double box_width;       /**< [m] positive */
  double box_height;      /**< [m] positive */
} hfrac_viz_view_options;

/** Defaults into `options`; `struct_size` is sizeof(hfrac_viz_view_options) in the caller. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_view_options_init(hfrac_viz_view_options *options, int32_t struct_size);

/** Draws 1 to 9 views of one snapshot side by side to the file `path`: .png, or .svg or .pdf for circles, lines and letters
 * instead of pixels (discs too many or too small to be told apart are a picture in it). A view is one that
 * hfrac_viz_view_names lists, or any array of the snapshot's VTU files by its name: "radius_m", "stress_Pa[1]" (its second
 * component), "flow:volume_m2" (of that file, if several have the name). Units come from the ends of names. options NULL:
 * the defaults. Fails with HFRAC_VIZ_ERR_READ if the run has no data for one of them. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_views(const char *run_dir, const char *const *views, int32_t view_count,
                                         const char *path, const hfrac_viz_view_options *options);

/** The same of a simulation as it stands; nothing but the picture is written. options->snapshot is not used. Errors of the
 * simulation keep their status (HFRAC_ERR_BAD_HANDLE, ...). Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_render_sim(hfrac_sim *sim, const char *const *views, int32_t view_count, const char *path,
                                       const hfrac_viz_view_options *options);

/** The names of the views with what they show, a line each. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_view_names(char *buffer, int32_t capacity, int32_t *needed);

/** Writes one HTML file with everything in it (path NULL: run_dir/report.html): the case, pictures, movie and curves (those
 * that are in run_dir/pictures/; curves as SVG), fractures, wells, balances, versions, how to reproduce it. It refers
 * to nothing outside itself. Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_write_report(const char *run_dir, const char *path);

/** Writes run_dir/paraview_state.py, a state script that opens the run in ParaView as the pictures look.
 * Stable since 0.1. */
HFRAC_API int32_t hfrac_viz_write_paraview_script(const char *run_dir);

#ifdef __cplusplus
}
#endif
#endif
