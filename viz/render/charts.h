// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run: what stands on each page. Every function fills a page; page heights are in its units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart_page.h"
#include "hfrac/viz.h"
#include "render_run.h"
#include "run/run_folder.hpp"
#include "run/table_file.hpp"

namespace hfrac::viz {

// What charts are drawn from; a table that is not there is none.
struct ChartData {
  const RunFolder* run = nullptr;
  std::optional<TableFile> history;
  std::optional<TableFile> cracks;
  std::optional<TableFile> events;
  double diffusivity = 0;  // m2/s, of the envelope around events; 0: found from them

  // Throws ReadError if one is damaged.
  explicit ChartData(const RunFolder& folder);
};

struct Chart {
  int kind;          // one value of enum hfrac_viz_chart
  const char* name;  // of the file, without ending
  const char* title;
  double (*height)(const ChartData& data);  // of the page
  void (*fill)(ChartPage& page, const ChartData& data);
  std::optional<TableFile> ChartData::*table;  // without lines in it there is no chart
  const char* table_name;
};

// Draws what `options`, which have been checked, ask for into run.path/pictures. Throws Failure, FileError or Stopped.
void render_charts(const RunFolder& run, const hfrac_viz_chart_options& options, const Progress& progress);

void fill_history(ChartPage& page, const ChartData& data);
void fill_rose(ChartPage& page, const ChartData& data);
void fill_profile(ChartPage& page, const ChartData& data);
double profile_height(const ChartData& data);
void fill_events(ChartPage& page, const ChartData& data);
void fill_catalogue(ChartPage& page, const ChartData& data);

// A seismic event and how far from the nearest well it was.
struct DistantEvent {
  double time = 0;      // s
  double distance = 0;  // m
  std::size_t kind = 0;
};
// Distance against time, a series for each kind in its colour, with the front of diffusion. `diffusivity` as in ChartData.
Panel spreading_panel(const std::vector<DistantEvent>& events, const std::vector<Colour>& colours,
                      double diffusivity);

// A circle's line.
void put_ring(ChartPage& page, Point centre, double radius, double thickness, Colour colour);

// Two lines at the top; the second may be empty.
void put_heading(ChartPage& page, const std::string& title, const std::string& second_line);
// The run's title and what the page shows, at the top.
void put_heading(ChartPage& page, const RunFolder& run, const std::string& what);

// What both kinds of events, single cracks and those of the catalogue, are plotted as: strength over time, and how many
// are at least as strong, with the line log10 N = a - b M of Gutenberg and Richter.
// Dots of magnitudes, a series for each kind of event; a kind without any is left out.
Panel course_panel(std::vector<ChartSeries> kinds);

// The number of events over the magnitude, and the law's line if there are events enough to tell it.
Panel frequency_panel(const std::string& title, std::vector<double> magnitudes);

}  // namespace hfrac::viz
