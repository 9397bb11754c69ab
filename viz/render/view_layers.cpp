// SPDX-License-Identifier: BSD-3-Clause
// Quantities are drawn by what carries them - discs, domains, cracks, bonds - whether the list of views (run/views.hpp) names
// them or the user names an array of the files; only discs, bonds and forces are drawings of their own.
#include "view_layers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "disc_detail.h"
#include "failure.h"
#include "layers.h"
#include "number_text.h"
#include "sheet.h"

namespace hfrac::viz {

std::string ViewSpec::component_text() const {
  std::string text;
  if (component > 0) text.append("[").append(std::to_string(component)).append("]");
  return text;
}

ViewSpec view_named(const std::string& name) {
  ViewSpec spec;
  if (const NamedView* view = view_of(name)) {
    spec.title = view->title;
    if (view->mesh.empty()) {
      spec.drawing = name;
      return spec;
    }
    spec.label = view->label;
    spec.note = view->note;
    spec.array = view->array;
    spec.file = view->mesh;
    spec.how = view->how;
    spec.component = view->component;
    spec.scale = view->scale;
    spec.all_values = view->all_values;
    spec.smoothed = view->smoothed;
    spec.states = view->states;
    spec.by_width = view->array == "aperture_m";
    return spec;
  }
  spec.array = name;
  if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
    spec.file = name.substr(0, colon);
    spec.array = name.substr(colon + 1);
    if (spec.file != "discs" && spec.file != "flow" && spec.file != "cracks" && spec.file != "bonds" &&
        spec.file != "joints") {
      fail_argument("'" + spec.file + "' in '" + name + "' is none of discs, flow, cracks, bonds, joints");
    }
  }
  if (const std::size_t open = spec.array.find('['); open != std::string::npos) {
    const char* const first = spec.array.data() + open + 1;
    const char* const last = spec.array.data() + spec.array.size();
    const auto [end, error] = std::from_chars(first, last, spec.component);
    if (error != std::errc() || end + 1 != last || *end != ']' || spec.component < 0) {
      fail_argument("'" + name + "' does not end with the number of a component, [0] the first");
    }
    spec.array.resize(open);
  }
  if (spec.array.empty()) fail_argument("'" + name + "' names no view and no array");
  return spec;
}

std::string view_names() {
  std::string text;
  for (const NamedView& view : all_views()) {
    std::string line = "  " + std::string(view.name);
    line.resize(21, ' ');
    line += view.title;
    if (!view.note.empty()) line.append(": ").append(view.note);
    text += line + "\n";
  }
  return text + "  or an array of the snapshot's files: radius_m, displacement_m[1], flow:volume_m2, ...\n";
}

namespace {

// Neighbours are found through square cells as wide as the search radius: each disc looks into nine of them.
class Cells {
 public:
  Cells(const Discs& discs, double size) : size_(size) {
    double right = -INFINITY;
    double top = -INFINITY;
    for (const Disc& disc : discs.discs) {
      left_ = std::min(left_, disc.centre.x);
      bottom_ = std::min(bottom_, disc.centre.y);
      right = std::max(right, disc.centre.x);
      top = std::max(top, disc.centre.y);
    }
    constexpr double most = 4096;  // in each direction, whatever the radius
    size_ = std::max({size_, (right - left_) / most, (top - bottom_) / most});
    columns_ = 1 + static_cast<int>((right - left_) / size_);
    rows_ = 1 + static_cast<int>((top - bottom_) / size_);
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (const Disc& disc : discs.discs) ++first_[cell(disc.centre) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    members_.resize(discs.discs.size());
    for (std::size_t i = 0; i < discs.discs.size(); ++i) {
      members_[next[cell(discs.discs[i].centre)]++] = static_cast<std::uint32_t>(i);
    }
  }

  template <class Visit>
  void around(Point place, const Visit& visit) const {
    const int column = column_of(place);
    const int row = row_of(place);
    for (int j = std::max(0, row - 1); j <= std::min(rows_ - 1, row + 1); ++j) {
      for (int i = std::max(0, column - 1); i <= std::min(columns_ - 1, column + 1); ++i) {
        const std::size_t index = static_cast<std::size_t>(j) * columns_ + i;
        for (std::uint32_t k = first_[index]; k < first_[index + 1]; ++k) visit(members_[k]);
      }
    }
  }

 private:
  int column_of(Point place) const {
    return std::clamp(static_cast<int>((place.x - left_) / size_), 0, columns_ - 1);
  }
  int row_of(Point place) const {
    return std::clamp(static_cast<int>((place.y - bottom_) / size_), 0, rows_ - 1);
  }
  std::size_t cell(Point place) const {
    return static_cast<std::size_t>(row_of(place)) * columns_ + column_of(place);
  }

  double size_;
  double left_ = INFINITY;
  double bottom_ = INFINITY;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> members_;
};

bool visible(const Disc& disc, const Extent& extent) {
  return disc.centre.x >= extent.left && disc.centre.x <= extent.left + extent.width &&
         disc.centre.y >= extent.bottom && disc.centre.y <= extent.bottom + extent.height;
}

// Each disc's value becomes the mean over the discs within `radius` [m], large and near ones counting most:
// the stress of a single disc of a packing says little, that of its neighbourhood does.
std::vector<double> smoothed(const Discs& discs, std::span<const double> values, double radius) {
  std::vector<double> means(values.begin(), values.end());
  if (!(radius > 0) || discs.discs.empty()) return means;
  const Cells cells(discs, radius);
  for (std::size_t i = 0; i < discs.discs.size() && i < values.size(); ++i) {
    const Point centre = discs.discs[i].centre;
    double sum = 0;
    double weights = 0;
    cells.around(centre, [&](std::uint32_t other) {
      const Disc& disc = discs.discs[other];
      const double dx = disc.centre.x - centre.x;
      const double dy = disc.centre.y - centre.y;
      const double nearness = 1 - (dx * dx + dy * dy) / (radius * radius);
      if (nearness <= 0) return;
      const double weight = nearness * nearness * disc.radius * disc.radius;
      sum += weight * values[other];
      weights += weight;
    });
    if (weights > 0) means[i] = sum / weights;
  }
  return means;
}

// The values between which nearly all visible discs lie; a few odd ones do not stretch the colour scale.
// `two_ways`: the same to both sides of zero.
std::pair<double, double> usual_range(const Discs& discs, std::span<const double> values,
                                      const Extent& extent, bool two_ways) {
  std::vector<double> seen;
  for (std::size_t i = 0; i < discs.discs.size() && i < values.size(); ++i) {
    if (visible(discs.discs[i], extent)) seen.push_back(two_ways ? std::fabs(values[i]) : values[i]);
  }
  if (seen.empty()) return {0.0, 0.0};
  const auto at_share = [&](double share) {
    const auto place =
        seen.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seen.size() - 1));
    std::nth_element(seen.begin(), place, seen.end());
    return *place;
  };
  const double highest = at_share(0.99);
  const double lowest = two_ways ? -highest : at_share(0.01);
  return {lowest, highest};
}

// What every kind of view is made with: the view, the scene, and the layers most of them share.
struct Job {
  const View& view;
  const RunFolder& run;
  const Scene& scene;
  const ViewSize& size;
  double radius;  // [m] mean of the discs

  void add(const vtkSmartPointer<vtkActor>& layer) const { view.renderer->AddActor(layer); }
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

constexpr double smoothing_radii = 5;  // of a disc

Key show_discs(const Job& job) {
  job.add_well();
  job.add_discs(palette().disc, palette().disc_rim);
  job.add_cracks(false);
  Key key;
  key.entries = job.crack_signs();
  key.entries.insert(key.entries.begin(), {Sign::disc, palette().disc, palette().disc_rim, "disc"});
  return key;
}

Key show_forces(const Job& job) {
  const std::vector<BondForce> bonds = read_bond_forces(job.file(job.run.bonds, "bonds"));
  std::vector<double> sizes;
  sizes.reserve(bonds.size());
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
  job.add(force_layer(bonds, bounds_of(job.view.extent), largest,
                      std::max(0.45 * job.radius, 1.2 * job.size.unit_metres)));
  job.add_cracks(true);
  Key key;
  key.entries = {{Sign::band, palette().push, {}, "compression"},
                 {Sign::band, palette().pull, {}, "tension"}};
  const std::vector<LegendEntry> signs = job.crack_signs();
  key.entries.insert(key.entries.end(), signs.begin(), signs.end());
  // Per metre of thickness.
  const Quantity widest = quantity_of("normal_force_N", largest);
  key.label = "widest: " + value_text(largest * widest.scale) + " " + widest.unit + "/m";
  return key;
}

Key show_bonds(const Job& job) {
  const Bonds bonds = read_bonds(job.file(job.run.bonds, "bonds"));
  job.add_well();
  job.add_discs(palette().disc, palette().soft_disc_rim);
  if (!drawn_as_density(job.view, job.scene.discs)) {
    const double half = 0.06 * job.radius;
    job.add(coloured_bonds(bonds.intact, bounds_of(job.view.extent),
                           std::vector<Colour>(bonds.intact.size(), palette().bond), half));
  }
  job.add_cracks(false);
  Key key;
  key.entries = job.crack_signs();
  key.entries.insert(key.entries.begin(), {{Sign::disc, palette().disc, palette().disc_rim, "disc"},
                                           {Sign::line, palette().bond, {}, "intact bond"}});
  return key;
}

struct Place {
  const char* file;
  const char* section;
  Series RunFolder::*series;
};

constexpr std::array<Place, 5> places = {{{"discs", "PointData", &RunFolder::discs},
                                          {"flow", "CellData", &RunFolder::flow},
                                          {"cracks", "CellData", &RunFolder::cracks},
                                          {"bonds", "CellData", &RunFolder::bonds},
                                          {"joints", "CellData", &RunFolder::joints}}};

// Everything there is, for the user who guessed.
std::string names_of(const Job& job) {
  std::string text;
  for (const Place& place : places) {
    const SeriesFile* file = file_of(job.run.*place.series, job.scene.point.number);
    if (file == nullptr) continue;
    text.append(text.empty() ? "" : "; ").append(place.file).append(":");
    for (const ArrayHead& head : GridFile(*file).arrays(place.section)) text.append(" ").append(head.name);
  }
  return text;
}

struct FoundArray {
  const Place* place = nullptr;
  std::vector<double> values;  // one per item
};

// One number per item out of all components.
std::vector<double> combined(const std::vector<double>& all, std::size_t components, const ViewSpec& spec) {
  std::vector<double> values;
  values.reserve(all.size() / components);
  for (std::size_t i = 0; i + components <= all.size(); i += components) {
    const auto at = [&](std::size_t k) { return usable(all[i + k]); };
    switch (spec.how) {
      case Combination::length:
        values.push_back(std::hypot(at(0), at(1)));
        break;
      case Combination::mean:
        values.push_back((at(0) + at(1)) / 2);
        break;
      case Combination::shear:
        values.push_back(std::hypot((at(0) - at(1)) / 2, at(2)));
        break;
      case Combination::component:
        values.push_back(at(static_cast<std::size_t>(spec.component)));
        break;
    }
  }
  return values;
}

FoundArray find_array(const Job& job, const ViewSpec& spec) {
  for (const Place& place : places) {
    if (!spec.file.empty() && spec.file != place.file) continue;
    const SeriesFile* file = file_of(job.run.*place.series, job.scene.point.number);
    if (file == nullptr) continue;
    const GridFile grid(*file);
    for (const ArrayHead& head : grid.arrays(place.section)) {
      const std::size_t needed = spec.how == Combination::shear ? 3
                                 : spec.how == Combination::component
                                     ? static_cast<std::size_t>(spec.component) + 1
                                     : 2;
      if (head.name != spec.array || head.components < needed) continue;
      return {&place, combined(grid.values(place.section, head.name), head.components, spec)};
    }
  }
  return {};
}

// The ends of a colour scale, in the array's own unit.
std::pair<double, double> range_of(const Job& job, const ViewSpec& spec, const FoundArray& found,
                                   bool two_ways) {
  if (found.place->series == &RunFolder::discs && !spec.all_values)
    return usual_range(job.scene.discs, found.values, job.view.extent, two_ways);
  if (found.values.empty()) return {0, 0};
  std::vector<double> values = found.values;
  if (two_ways) {
    for (double& value : values) value = std::fabs(value);
  }
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  const double cut = spec.all_values ? 0.0 : 0.01;
  const double highest = values[static_cast<std::size_t>((1 - cut) * last)];
  return {two_ways ? -highest : values[static_cast<std::size_t>(cut * last)], highest};
}

const ColourMap* map_of(ColourScale scale) {
  switch (scale) {
    case ColourScale::two_ways:
      return palette().two_ways;
    case ColourScale::narrow:
      return palette().narrow;
    case ColourScale::pressure:
      return &pressure_map;
    case ColourScale::magnitude:
    case ColourScale::states:
      break;
  }
  return &magnitude_map;
}

void show_cracks(const Job& job, const ViewSpec& spec, std::span<const Colour> colours) {
  job.add_well();
  job.add_quiet_discs();
  const auto& cracks = job.scene.cracks.cracks;
  if (spec.by_width) {
    double widest = 0;
    for (const Crack& crack : cracks) widest = std::max(widest, crack.aperture);
    const double half = std::clamp(0.35 * job.radius, 4 * job.size.unit_metres, 12 * job.size.unit_metres);
    job.add(aperture_layer(cracks, widest, half));
  } else {
    job.add(coloured_cracks(cracks, colours, 1.4 * job.crack_half_width()));
  }
}

// Alone over pale rock: each contact of a broken joint is among the cracks too, and would lie over it.
void show_joints(const Job& job, const std::vector<Colour>& colours) {
  job.add_quiet_well();
  job.add_quiet_discs();
  job.add(joint_layer(read_lines(job.file(job.run.joints, "joints")), colours, 2 * job.crack_half_width(),
                      0.8 * job.size.unit_metres));
}

void show_colours(const Job& job, const ViewSpec& spec, const FoundArray& found,
                  const std::vector<Colour>& colours) {
  const Series RunFolder::*series = found.place->series;
  if (series == &RunFolder::discs) {
    job.add_quiet_well();
    job.add(discs_in_view(job.view, job.scene.discs, colours, job.size.drawn_pixel));
    job.add_cracks(true);
  } else if (series == &RunFolder::flow) {
    job.add(domain_layer(job.scene.flow, bounds_of(job.view.extent), colours));
    job.add_cracks(true);
    job.add_ring();
  } else if (series == &RunFolder::cracks) {
    show_cracks(job, spec, colours);
  } else if (series == &RunFolder::joints) {
    show_joints(job, colours);
  } else {
    job.add_well();
    job.add_quiet_discs();
    const double half_width = std::max(0.16 * job.radius, 0.8 * job.size.unit_metres);
    job.add(coloured_bonds(read_lines(job.file(job.run.bonds, "bonds")), bounds_of(job.view.extent), colours,
                           half_width));
  }
}

// Grey, blue, and the colours of shear and tension.
Key show_states(const Job& job, const ViewSpec& spec, const FoundArray& found) {
  const std::array<Colour, 4> signs = {palette().faint_ink, palette().bond, palette().shear,
                                       palette().tension};
  std::vector<Colour> colours;
  for (const double value : found.values)
    colours.push_back(signs[static_cast<std::size_t>(std::clamp(value, 0.0, 3.0))]);
  show_colours(job, spec, found, colours);
  Key key;
  for (std::size_t k = 0; k < signs.size(); ++k)
    key.entries.push_back({Sign::band, signs[k], {}, std::string(spec.states[k])});
  return key;
}

Key show_quantity(const Job& job, const ViewSpec& spec) {
  FoundArray found = find_array(job, spec);
  if (found.place == nullptr) {
    fail_reading("snapshot " + std::to_string(job.scene.point.number) + " has no array '" + spec.full_name() +
                 "'; it has " + names_of(job));
  }
  if (spec.scale == ColourScale::states) return show_states(job, spec, found);
  if (spec.smoothed) found.values = smoothed(job.scene.discs, found.values, smoothing_radii * job.radius);
  const auto [least, largest] = std::minmax_element(found.values.begin(), found.values.end());
  const bool two_ways =
      spec.scale ? *spec.scale == ColourScale::two_ways : !found.values.empty() && *least < 0 && *largest > 0;
  auto [lowest, highest] = range_of(job, spec, found, two_ways);
  if (spec.by_width) lowest = 0;
  const double size = std::max(std::fabs(lowest), std::fabs(highest));
  const Quantity quantity = quantity_of(spec.array, size > 0 ? size : 1);
  Key key;
  key.lowest = lowest * quantity.scale;
  key.highest = highest * quantity.scale;
  if (!(key.highest > key.lowest)) {  // the same everywhere
    key.lowest -= spec.by_width ? 0 : 1;
    key.highest += 1;
  }
  key.map = map_of(spec.scale.value_or(two_ways ? ColourScale::two_ways : ColourScale::magnitude));
  const std::string name = spec.label.empty() ? quantity.name : spec.label;
  key.label = quantity.unit.empty() ? name : name + " (" + quantity.unit + ")";
  key.second_label = spec.note;
  if (spec.label.empty()) {
    key.title = name + spec.component_text();
    key.title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(key.title[0])));
    key.second_label =
        std::string("of the ") + (found.place->series == &RunFolder::flow ? "domains" : found.place->file);
  } else if (spec.array == "pressure_Pa" && job.run.net_pressures) {
    key.second_label = "above the formation's";
  }
  std::vector<Colour> colours;
  colours.reserve(found.values.size());
  for (const double value : found.values)
    colours.push_back(key.map->at((value * quantity.scale - key.lowest) / (key.highest - key.lowest)));
  show_colours(job, spec, found, colours);
  return key;
}

}  // namespace

Key add_view_layers(const View& view, const RunFolder& run, const Scene& scene, const ViewSpec& spec,
                    const ViewSize& size) {
  const Job job{view, run, scene, size, mean_radius(scene.discs)};
  Key key = spec.drawing == "discs"    ? show_discs(job)
            : spec.drawing == "bonds"  ? show_bonds(job)
            : spec.drawing == "forces" ? show_forces(job)
                                       : show_quantity(job, spec);
  if (!spec.title.empty()) key.title = spec.title;
  return key;
}

}  // namespace hfrac::viz
