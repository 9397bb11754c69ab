// SPDX-License-Identifier: BSD-3-Clause
// events.csv, and the crack log read back from cracks.csv to make it anew by another rule.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>

#include "output/safe_file.hpp"
#include "output/tables.hpp"

namespace hfrac::output {
namespace {

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t from = 0; from <= text.size();) {
    const size_t to = std::min(text.find(separator, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

/** One line of a table by the names of its columns. */
class Row {
 public:
  Row(const std::map<std::string_view, size_t>& columns, std::vector<std::string_view> cells)
      : columns_(&columns), cells_(std::move(cells)) {}

  std::string_view word(std::string_view column) const {
    const auto found = columns_->find(column);
    if (found == columns_->end() || found->second >= cells_.size())
      throw FileError(
          fmt::format("cracks.csv has no column '{}'; run the case again with this hfrac", column));
    return cells_[found->second];
  }
  template <class Number>
  void read(std::string_view column, Number& value) const {
    const auto cell = word(column);
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
      throw FileError(fmt::format("'{}' in column '{}' of cracks.csv is no number", cell, column));
  }

 private:
  const std::map<std::string_view, size_t>* columns_;
  std::vector<std::string_view> cells_;
};

hfrac_crack crack_of(const Row& row) {
  hfrac_crack crack{};
  row.read("crack_id", crack.id);
  row.read("step", crack.step);
  row.read("cycle", crack.cycle);
  row.read("time_s", crack.time);
  row.read("bond_id", crack.bond);
  row.read("disc_0", crack.disc[0]);
  row.read("disc_1", crack.disc[1]);
  row.read("x_m", crack.position[0]);
  row.read("y_m", crack.position[1]);
  row.read("normal_x", crack.normal[0]);
  row.read("normal_y", crack.normal[1]);
  row.read("length_m", crack.length);
  row.read("aperture_m", crack.aperture);
  row.read("normal_force_N", crack.normal_force);
  row.read("shear_force_N", crack.shear_force);
  row.read("energy_J_per_m", crack.energy);
  row.read("fracture", crack.fracture);
  row.read("distance_m", crack.distance);
  crack.mode = row.word("mode") == "shear" ? HFRAC_CRACK_SHEAR : HFRAC_CRACK_TENSION;
  return crack;
}

}  // namespace

std::vector<hfrac_crack> read_crack_table(const std::filesystem::path& file) {
  const std::string text = read_whole(file);
  const auto lines = parts_of(text, '\n');
  std::map<std::string_view, size_t> columns;
  const auto head = parts_of(lines.front(), ',');
  for (size_t i = 0; i < head.size(); ++i) columns[head[i]] = i;
  std::vector<hfrac_crack> cracks;
  for (size_t i = 1; i < lines.size(); ++i)
    if (!lines[i].empty()) cracks.push_back(crack_of(Row(columns, parts_of(lines[i], ','))));
  return cracks;
}

std::vector<hfrac_event> events_of(const std::vector<hfrac_crack>& cracks,
                                   const hfrac_catalogue_options* options) {
  constexpr auto crack_size = static_cast<int32_t>(sizeof(hfrac_crack));
  constexpr auto event_size = static_cast<int32_t>(sizeof(hfrac_event));
  std::vector<hfrac_event> events(cracks.size());  // never more events than cracks
  const auto most = static_cast<int64_t>(cracks.size());
  int64_t count = 0;
  require(
      hfrac_find_events(cracks.data(), crack_size, most, options, event_size, events.data(), most, &count),
      nullptr);
  events.resize(static_cast<size_t>(count));
  return events;
}

std::string event_table(const std::vector<hfrac_event>& events) {
  std::string table =
      "event,first_crack,crack_count,tensile_cracks,first_cycle,last_cycle,time_s,x_m,y_m,moment_xx_N_m,"
      "moment_yy_N_m,moment_xy_N_m,moment_N_m,magnitude,energy_J,energy_magnitude,isotropic_fraction,length_"
      "m,"
      "radius_m\n";
  for (const auto& event : events) {
    auto out = std::back_inserter(table);
    fmt::format_to(out, "{},{},{},{}", event.index, event.first_crack, event.crack_count,
                   event.tensile_cracks);
    fmt::format_to(out, ",{},{},{}", event.first_cycle, event.last_cycle, event.time);
    fmt::format_to(out, ",{},{}", event.position[0], event.position[1]);
    for (const double part : event.moment_tensor) fmt::format_to(out, ",{}", part);
    fmt::format_to(out, ",{},{},{},{}", event.moment, event.magnitude, event.energy, event.energy_magnitude);
    fmt::format_to(out, ",{},{},{}\n", event.isotropic_fraction, event.length, event.radius);
  }
  return table;
}

}  // namespace hfrac::output
