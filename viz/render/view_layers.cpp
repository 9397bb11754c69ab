// SPDX-License-Identifier: BSD-3-Clause
#include "view_layers.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "disc_field.h"
#include "number_text.h"
#include "sheet.h"
#include "view_job.h"

namespace hfrac::viz {
namespace {

constexpr double pascal_per_megapascal = 1e6;
constexpr double newton_per_meganewton = 1e6;
constexpr double millimetres_per_metre = 1e3;
constexpr double smoothing_radii = 5;  // of a disc

Key show_discs(const Job& job) {
  job.add_well();
  job.add_discs(palette().disc, palette().disc_rim);
  job.add_cracks(false);
  Key key;
  key.title = "Discs and cracks";
  key.entries = job.crack_signs();
  key.entries.insert(key.entries.begin(), {Sign::disc, palette().disc, palette().disc_rim, "disc"});
  return key;
}

Key show_forces(const Job& job) {
  const std::vector<BondForce> bonds = read_bond_forces(job.file(job.run.bonds, "bonds"));
  std::vector<double> sizes;
  for (const BondForce& bond : bonds) sizes.push_back(std::fabs(bond.normal));
  double largest = 1;
  if (!sizes.empty()) {
    const auto place =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), place, sizes.end());
    largest = std::max(*place, 1e-9);
  }
  job.add_well();
  job.add_quiet_discs();
  job.add(force_layer(bonds, largest, std::max(0.45 * job.radius, 1.2 * job.size.unit_metres)));
  job.add_cracks(true);
  Key key;
  key.title = "Forces across bonds";
  key.entries = {{Sign::band, palette().push, {}, "compression"},
                 {Sign::band, palette().pull, {}, "tension"}};
  const std::vector<LegendEntry> signs = job.crack_signs();
  key.entries.insert(key.entries.end(), signs.begin(), signs.end());
  key.label = "widest: " + value_text(largest / newton_per_meganewton) + " MN/m";
  return key;
}

Key show_crack_times(const Job& job) {
  double first = INFINITY;
  double last = -INFINITY;
  for (const Crack& crack : job.scene.cracks.cracks) {
    first = std::min(first, crack.time);
    last = std::max(last, crack.time);
  }
  if (!(last > first)) {
    first = std::isfinite(first) ? first : 0.0;
    last = first + 1;
  }
  job.add_well();
  job.add_quiet_discs();
  job.add(crack_time_layer(job.scene.cracks.cracks, first, last, 1.4 * job.crack_half_width()));
  return {"Cracks by time", palette().narrow, first, last, "broken at (s)", "", {}};
}

Key show_apertures(const Job& job) {
  double widest = 0;
  for (const Crack& crack : job.scene.cracks.cracks) widest = std::max(widest, crack.aperture);
  job.add_well();
  job.add_quiet_discs();
  const double half = std::clamp(0.35 * job.radius, 4 * job.size.unit_metres, 12 * job.size.unit_metres);
  job.add(aperture_layer(job.scene.cracks.cracks, widest, half));
  const double highest = widest > 0 ? widest * millimetres_per_metre : 1.0;
  return {"Crack aperture", palette().narrow, 0, highest, "aperture (mm)", "", {}};
}

Key show_pressure(const Job& job) {
  if (job.scene.flow.domains.empty()) job.file(job.run.flow, "flow data");
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const Domain& domain : job.scene.flow.domains) {
    lowest = std::min(lowest, domain.pressure);
    highest = std::max(highest, domain.pressure);
  }
  if (!(highest > lowest)) highest = lowest + pascal_per_megapascal;
  job.add(domain_layer(job.scene.flow, lowest, highest));
  job.add_cracks(true);
  job.add_ring();
  return {"Fluid pressure",
          &pressure_map,
          lowest / pascal_per_megapascal,
          highest / pascal_per_megapascal,
          "pressure (MPa)",
          job.run.net_pressures ? "above the formation's" : "",
          {}};
}

Key show_displacement(const Job& job) {
  const std::vector<double> vectors = read_disc_array(job.file(job.run.discs, "discs"), "displacement_m", 3);
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 2 < vectors.size(); i += 3)
    lengths.push_back(std::hypot(vectors[i], vectors[i + 1]));
  return show_field(
      job, std::move(lengths), millimetres_per_metre, false,
      {"Displacement", nullptr, 0, 1, "displacement (mm)", "since the initial equilibration", {}});
}

// Of the tensor xx, yy, xy the engine gives per disc.
Key show_stress(const Job& job, double xx, double yy, double xy, bool signed_by_compression, Key key) {
  const std::vector<double> tensors = read_disc_array(job.file(job.run.discs, "discs"), "stress_Pa", 3);
  std::vector<double> values;
  for (std::size_t i = 0; i + 2 < tensors.size(); i += 3)
    values.push_back(xx * tensors[i] + yy * tensors[i + 1] + xy * tensors[i + 2]);
  key.second_label = signed_by_compression ? "compression positive" : "";
  return show_field(job, smoothed(job.scene.discs, values, smoothing_radii * job.radius),
                    1 / pascal_per_megapascal, true, key);
}

Key show_stress(const Job& job, int kind) {
  switch (kind) {
    case HFRAC_VIZ_VIEW_STRESS_XX:
      return show_stress(job, 1, 0, 0, true, {"Stress along x", nullptr, 0, 1, "stress xx (MPa)", "", {}});
    case HFRAC_VIZ_VIEW_STRESS_YY:
      return show_stress(job, 0, 1, 0, true, {"Stress along y", nullptr, 0, 1, "stress yy (MPa)", "", {}});
    case HFRAC_VIZ_VIEW_STRESS_XY:
      return show_stress(job, 0, 0, 1, false, {"Shear stress", nullptr, 0, 1, "stress xy (MPa)", "", {}});
    default:
      return show_stress(job, 0.5, 0.5, 0, true, {"Mean stress", nullptr, 0, 1, "mean stress (MPa)", "", {}});
  }
}

Key show_bonds(const Job& job) {
  const Bonds bonds = read_bonds(job.file(job.run.bonds, "bonds"));
  job.add_well();
  job.add_discs(palette().disc, palette().soft_disc_rim);
  if (!drawn_as_density(job.view, job.scene.discs)) {
    const double half = 0.06 * job.radius;
    job.add(coloured_bonds(bonds.intact, std::vector<Colour>(bonds.intact.size(), palette().bond), half));
  }
  job.add_cracks(false);
  Key key;
  key.title = "Bonds and cracks";
  key.entries = job.crack_signs();
  key.entries.insert(key.entries.begin(), {{Sign::disc, palette().disc, palette().disc_rim, "disc"},
                                           {Sign::line, palette().bond, {}, "intact bond"}});
  return key;
}

Key show_rotation(const Job& job) {
  constexpr double milliradians = 1e3;
  return show_field(
      job, read_disc_array(job.file(job.run.discs, "discs"), "rotation_rad", 1), milliradians, true,
      {"Rotation of the discs", nullptr, 0, 1, "rotation (mrad)", "anticlockwise positive", {}});
}

}  // namespace

Key show_field(const Job& job, std::vector<double> values, double scale, bool two_ways, Key key) {
  for (double& value : values) value *= scale;
  std::tie(key.lowest, key.highest) = usual_range(job.scene.discs, values, job.view.extent, two_ways);
  key.map = two_ways ? palette().two_ways : &magnitude_map;
  std::vector<Colour> fills;
  fills.reserve(values.size());
  for (const double value : values) {
    fills.push_back(key.map->at((value - key.lowest) / (key.highest - key.lowest)));
  }
  job.add_quiet_well();
  job.add(discs_in_view(job.view, job.scene.discs, fills, job.size.drawn_pixel));
  job.add_cracks(true);
  return key;
}

Key add_view_layers(const View& view, const RunFolder& run, const Scene& scene, const ViewSpec& spec,
                    const ViewSize& size) {
  const Job job{view, run, scene, size, mean_radius(scene.discs)};
  switch (spec.kind) {
    case array_view:
      return show_array(job, spec);
    case HFRAC_VIZ_VIEW_TEMPERATURE:
      return show_temperature(job);
    case HFRAC_VIZ_VIEW_BONDS:
      return show_bonds(job);
    case HFRAC_VIZ_VIEW_FORCES:
      return show_forces(job);
    case HFRAC_VIZ_VIEW_CRACK_TIME:
      return show_crack_times(job);
    case HFRAC_VIZ_VIEW_APERTURE:
      return show_apertures(job);
    case HFRAC_VIZ_VIEW_PRESSURE:
      return show_pressure(job);
    case HFRAC_VIZ_VIEW_DISPLACEMENT:
      return show_displacement(job);
    case HFRAC_VIZ_VIEW_ROTATION:
      return show_rotation(job);
    case HFRAC_VIZ_VIEW_STRESS:
    case HFRAC_VIZ_VIEW_STRESS_XX:
    case HFRAC_VIZ_VIEW_STRESS_YY:
    case HFRAC_VIZ_VIEW_STRESS_XY:
      return show_stress(job, spec.kind);
    default:
      return show_discs(job);
  }
}

}  // namespace hfrac::viz
