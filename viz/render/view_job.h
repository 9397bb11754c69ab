// SPDX-License-Identifier: BSD-3-Clause
// What every kind of view is made with: the view, the scene, and the layers most of them share.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "disc_detail.h"
#include "failure.h"
#include "layers.h"
#include "view_layers.h"

namespace hfrac::viz {

struct Job {
  const View& view;
  const RunFolder& run;
  const Scene& scene;
  const ViewSize& size;
  double radius;  // [m] mean of the discs

  void add(vtkSmartPointer<vtkActor> layer) const { view.renderer->AddActor(layer); }
  const SeriesFile& file(const Series& series, const char* what) const {
    const SeriesFile* found = file_of(series, scene.point.number);
    if (found == nullptr) {
      fail_reading("snapshot " + std::to_string(scene.point.number) + " has no " + what);
    }
    return *found;
  }
  double crack_half_width() const {
    return std::clamp(0.2 * radius, 1.8 * size.unit_metres, 5.0 * size.unit_metres);
  }
  void add_well() const { add(well_layer(scene.flow, run.wells, 2 * size.unit_metres)); }
  // Where colours tell values, the well's red would too.
  void add_quiet_well() const {
    add(well_layer(scene.flow, run.wells, 2 * size.unit_metres, palette().faint_ink));
  }
  void add_ring() const { add(well_rings(scene.flow, run.wells, 1.6 * size.unit_metres, palette().well)); }
  void add_discs(Colour fill, Colour rim) const {
    add(discs_in_view(view, scene.discs, fill, rim, size.drawn_pixel));
  }
  void add_quiet_discs() const { add_discs(palette().quiet_disc, palette().quiet_disc_rim); }
  // Over colours: with paper around them.
  void add_cracks(bool cased) const {
    if (scene.cracks.cracks.empty()) return;
    add(crack_layer(scene.cracks.cracks, crack_half_width(), cased ? 1.1 * size.unit_metres : 0.0));
  }
  std::vector<LegendEntry> crack_signs() const {
    return {{Sign::band, palette().tension, {}, "crack, tension"},
            {Sign::band, palette().shear, {}, "crack, shear"},
            {Sign::hole, palette().well, {}, "wellbore"}};
  }
};

}  // namespace hfrac::viz
