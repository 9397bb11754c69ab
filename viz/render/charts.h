// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run: what stands on each page. Every function fills a page; page heights are in its units.
#pragma once

#include "chart_page.h"
#include "run_folder.h"
#include "table_file.h"

namespace hfrac::viz {

// What charts are drawn from.
struct ChartData {
  const RunFolder* run = nullptr;
  TableFile history;
  TableFile cracks;
  TableFile events;

  explicit ChartData(const RunFolder& folder)
      : run(&folder),
        history(folder.path / "history.csv"),
        cracks(folder.path / "cracks.csv"),
        events(folder.path / "events.csv") {}
};

struct Chart {
  int kind;          // one value of enum hfrac_viz_chart
  const char* name;  // of the file, without ending
  const char* title;
  double height;  // of the page
  void (*fill)(ChartPage& page, const ChartData& data);
  TableFile ChartData::*table;  // without lines in it there is no chart
};

void fill_history(ChartPage& page, const ChartData& data);
void fill_rose(ChartPage& page, const ChartData& data);
void fill_profile(ChartPage& page, const ChartData& data);
void fill_events(ChartPage& page, const ChartData& data);
void fill_catalogue(ChartPage& page, const ChartData& data);

// A circle's line.
void put_ring(ChartPage& page, Point centre, double radius, double thickness, Colour colour);

// Two lines at the top; the second may be empty.
void put_heading(ChartPage& page, const std::string& title, const std::string& second_line);
// The run's title and what the page shows, at the top.
void put_heading(ChartPage& page, const RunFolder& run, const std::string& what);

}  // namespace hfrac::viz
