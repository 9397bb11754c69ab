// SPDX-License-Identifier: BSD-3-Clause
// Views of arrays that the renderer knows nothing of but their name: the name's end tells the unit, the file it is in
// tells what carries the colour.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

#include "disc_field.h"
#include "grid_file.h"
#include "quantity.h"
#include "view_job.h"

namespace hfrac::viz {
namespace {

struct Place {
  const char* file;
  const char* section;
  Series RunFolder::*series;
};

constexpr std::array<Place, 4> places = {{{"discs", "PointData", &RunFolder::discs},
                                          {"flow", "CellData", &RunFolder::flow},
                                          {"cracks", "CellData", &RunFolder::cracks},
                                          {"bonds", "CellData", &RunFolder::bonds}}};

struct FoundArray {
  const Place* place = nullptr;
  std::vector<double> values;
};

// Everything there is, for the user who guessed.
std::string names_of(const Job& job) {
  std::string text;
  for (const Place& place : places) {
    const SeriesFile* file = file_of(job.run.*place.series, job.scene.point.number);
    if (file == nullptr) continue;
    text.append(text.empty() ? "" : "; ").append(place.file).append(":");
    for (const std::string& name : GridFile(*file).array_names(place.section)) text.append(" ").append(name);
  }
  return text;
}

// The name, with the component if it is not the first.
std::string named(std::string name, const ViewSpec& spec) {
  if (spec.component > 0) name.append("[").append(std::to_string(spec.component)).append("]");
  return name;
}

FoundArray find_array(const Job& job, const ViewSpec& spec) {
  for (const Place& place : places) {
    if (!spec.file.empty() && spec.file != place.file) continue;
    const SeriesFile* file = file_of(job.run.*place.series, job.scene.point.number);
    if (file == nullptr) continue;
    std::optional<std::vector<double>> values =
        GridFile(*file).component(place.section, spec.array, static_cast<std::size_t>(spec.component));
    if (!values) continue;
    for (double& value : *values) value = std::fabs(value) < 1e30 ? value : 0.0;
    return {&place, std::move(*values)};
  }
  return {};
}

struct Scale {
  double lowest;
  double highest;
  const ColourMap* map;
  Colour at(double value) const { return map->at((value - lowest) / (highest - lowest)); }
};

// From the least to the largest but for a hundredth at both ends, as wide to both sides of zero if there are two.
Scale scale_of(std::vector<double> values, bool two_ways) {
  if (values.empty()) values.push_back(0);
  if (two_ways) {
    for (double& value : values) value = std::fabs(value);
  }
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  double highest = values[static_cast<std::size_t>(0.99 * last)];
  double lowest = two_ways ? -highest : values[static_cast<std::size_t>(0.01 * last)];
  if (!(highest > lowest)) {
    lowest -= 1;
    highest += 1;
  }
  return {lowest, highest, two_ways ? palette().two_ways : &magnitude_map};
}

std::vector<Colour> colours_of(const std::vector<double>& values, const Scale& scale) {
  std::vector<Colour> colours;
  colours.reserve(values.size());
  for (const double value : values) colours.push_back(scale.at(value));
  return colours;
}

void show_domains(const Job& job, const std::vector<double>& values, const Scale& scale) {
  job.add(domain_layer(job.scene.flow, colours_of(values, scale)));
  job.add_cracks(true);
  job.add_ring();
}

void show_cracks(const Job& job, const std::vector<double>& values, const Scale& scale) {
  job.add_well();
  job.add_quiet_discs();
  job.add(coloured_cracks(job.scene.cracks.cracks, colours_of(values, scale), 1.4 * job.crack_half_width()));
}

void show_bonds(const Job& job, const std::vector<double>& values, const Scale& scale) {
  job.add_well();
  job.add_quiet_discs();
  const double half_width = std::max(0.16 * job.radius, 0.8 * job.size.unit_metres);
  job.add(coloured_bonds(read_bond_lines(job.file(job.run.bonds, "bonds")), colours_of(values, scale),
                         half_width));
}

}  // namespace

Key show_array(const Job& job, const ViewSpec& spec) {
  FoundArray found = find_array(job, spec);
  if (found.place == nullptr) {
    fail_reading("snapshot " + std::to_string(job.scene.point.number) + " has no array '" +
                 named(spec.array, spec) + "'; it has " + names_of(job));
  }
  double least = 0;
  double largest = 0;
  for (const double value : found.values) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  const bool two_ways = least < 0 && largest > 0;
  const Quantity quantity = quantity_of(spec.array, std::max(-least, largest));
  Key key;
  key.title = named(quantity.name, spec);
  key.title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(key.title[0])));
  key.label = quantity.label();
  key.second_label =
      std::string("of the ") + (found.place->series == &RunFolder::flow ? "domains" : found.place->file);
  if (found.place->series == &RunFolder::discs) {
    return show_field(job, std::move(found.values), quantity.scale, two_ways, key);
  }
  for (double& value : found.values) value *= quantity.scale;
  const Scale scale = scale_of(found.values, two_ways);
  std::tie(key.lowest, key.highest, key.map) = std::tuple{scale.lowest, scale.highest, scale.map};
  if (found.place->series == &RunFolder::flow) show_domains(job, found.values, scale);
  if (found.place->series == &RunFolder::cracks) show_cracks(job, found.values, scale);
  if (found.place->series == &RunFolder::bonds) show_bonds(job, found.values, scale);
  return key;
}

Key show_temperature(const Job& job) {
  for (const char* name : {"temperature_degC", "temperature_K"}) {
    const ViewSpec spec{array_view, name, "", 0};
    if (find_array(job, spec).place != nullptr) return show_array(job, spec);
  }
  fail_reading("the run has no temperature: neither temperature_K nor temperature_degC in discs or domains");
}

}  // namespace hfrac::viz
