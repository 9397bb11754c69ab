// SPDX-License-Identifier: BSD-3-Clause
#include "output/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "output/columns.hpp"
#include "output/stimulation.hpp"
#include "run/fields.hpp"
#include "run/files.hpp"
#include "run/table_file.hpp"
#include "run/text.hpp"

namespace hfrac::output {

namespace {

constexpr std::string_view shear = "shear", tension = "tension";

/** The columns with the mode as a word. */
template <class Visit>
void written_columns(const hfrac_crack& crack, const Visit& visit) {
  crack_columns(crack, [&](std::string_view name, const auto& value) {
    if (name == "mode") {
      visit(name, crack.mode == HFRAC_CRACK_SHEAR ? shear : tension);
    } else {
      visit(name, value);
    }
  });
}

std::string well_prefix(size_t well) {
  return well == 0 ? "well" : fmt::format("well_{}", well);
}

/** Of a model with smooth joints. */
template <class Visit>
void stimulation_columns(hfrac_sim* sim, const std::vector<hfrac_well_state>& wells, const Visit& visit) {
  const JointMeasure joints = measure_joints(sim);
  if (joints.length == 0.0) return;
  joint_columns(joints, visit);
  for (size_t i = 0; i < wells.size(); ++i) {
    const std::string name = well_prefix(i) + "_injectivity_m2_per_Pa_s";
    const double value = injectivity(wells[i], definition_of(sim));
    std::isnan(value) ? visit(name, "") : visit(name, value);
  }
}

/** Of models with wellbore storage, friction or depth. */
template <class Visit>
void wellbore_columns(const std::vector<hfrac_well_state>& wells, const hfrac_sim_def& def,
                      const Visit& visit) {
  bool any = false;
  for (int64_t i = 0; i < def.well_count; ++i) {
    const hfrac_well_def& well = def.wells[i];
    any = any || well.storage > 0.0 || well.perforation_count > 0.0 || well.near_well_friction > 0.0 ||
          well.depth > 0.0;
  }
  for (size_t i = 0; any && i < wells.size(); ++i) {
    const std::string prefix = well_prefix(i);
    visit(prefix + "_wellbore_pressure_Pa", wells[i].wellbore_pressure);
    visit(prefix + "_wellhead_pressure_Pa", wells[i].wellhead_pressure);
    visit(prefix + "_wellbore_rate_m2_per_s", wells[i].wellbore_rate);
  }
}

/** `well_...` is the first well; further ones are well_1_..., well_2_... as in the case file, where wells count from 0.
 * A model without a well has the first one's columns, empty. */
template <class Visit>
void history_columns(hfrac_sim* sim, const Visit& visit) {
  const auto state = state_of(sim);
  const auto balance = balance_of(sim);
  const auto solver = solver_of(sim);
  const auto fracture = measure(fractures_of(sim));
  const auto wells = wells_of(sim);
  visit("step", state.step);
  visit("time_s", state.time);
  if (wells.empty()) {
    visit("well_pressure_Pa", "");
    visit("well_rate_m2_per_s", "");
  }
  for (size_t i = 0; i < wells.size(); ++i) {
    const std::string prefix = well_prefix(i);
    visit(prefix + "_pressure_Pa", wells[i].pressure);
    visit(prefix + "_rate_m2_per_s", wells[i].rate);
  }
  visit("injected_volume_m2", balance.injected_volume);
  visit("crack_count", state.crack_count);
  visit("tensile_cracks", state.tensile_cracks);
  visit("shear_cracks", state.shear_cracks);
  visit("tip_distance_m", state.tip_distance);
  visit("fracture_length_m", fracture.length);
  visit("fracture_width_m", fracture.width);
  visit("fracture_volume_m2", fracture.volume);
  visit("force_ratio", state.force_ratio);
  visit("cycles", state.cycles);
  visit("at_rest", state.at_rest);
  energy_columns(balance, [&](const char* name, double value) {
    std::isnan(value) ? visit(name, "") : visit(name, value);
  });
  fluid_columns(balance, visit);
  visit("solver_increments", solver.increments);
  visit("newton_iterations", solver.newton_iterations);
  visit("rejected_error", solver.rejected_error);
  visit("rejected_strength", solver.rejected_strength);
  visit("rejected_divergence", solver.rejected_divergence);
  stimulation_columns(sim, wells, visit);
  wellbore_columns(wells, definition_of(sim), visit);
}

/** A line of names, then one per item; `columns` takes an item, its place in the list and a visitor. */
template <class Item, class Columns>
std::string table_of(const std::vector<Item>& items, const Columns& columns) {
  run::TableText table;
  table.head([&](const auto& visit) { columns(Item{}, size_t{0}, visit); });
  for (size_t k = 0; k < items.size(); ++k)
    table.row([&](const auto& visit) { columns(items[k], k, visit); });
  return table.take();
}

}  // namespace

std::string history_header(hfrac_sim* sim) {
  run::TableText table;
  table.head([&](const auto& visit) { history_columns(sim, visit); });
  return table.take();
}

std::string history_row(hfrac_sim* sim) {
  run::TableText table;
  table.row([&](const auto& visit) { history_columns(sim, visit); });
  return table.take();
}

std::string crack_table(const std::vector<hfrac_crack>& cracks) {
  return table_of(cracks,
                  [](const auto& crack, size_t, const auto& visit) { written_columns(crack, visit); });
}

std::string slip_table(const std::vector<hfrac_slip>& slips) {
  return table_of(slips, [](const auto& slip, size_t, const auto& visit) { slip_columns(slip, visit); });
}

namespace {

/** The items of a table: `columns` takes an item and a visitor. */
template <class Item, class Columns>
std::vector<Item> read_table(const std::filesystem::path& file, const Columns& columns) {
  const run::TableFile table(file);
  std::vector<Item> items(table.rows());
  std::vector<std::vector<std::string>> words;
  Item any{};
  columns(any, [&](std::string_view name, const auto&) { words.push_back(table.words(name)); });
  for (size_t row = 0; row < items.size(); ++row) {
    size_t place = 0;
    columns(items[row], [&](std::string_view name, auto& member) {
      const std::string& word = words[place++][row];
      if (name == "mode" && (word == shear || word == tension)) {
        member = word == shear ? HFRAC_CRACK_SHEAR : HFRAC_CRACK_TENSION;
      } else if (const auto value = run::number_in<std::decay_t<decltype(member)>>(word);
                 value && name != "mode") {
        member = *value;
      } else {
        run::fail_reading(fmt::format("'{}' is damaged: '{}' in line {}, column '{}', is no {}",
                                      file.string(), run::printable(word.substr(0, 40)), row + 2, name,
                                      name == "mode" ? "mode of a crack" : "number"));
      }
    });
  }
  return items;
}

}  // namespace

std::vector<hfrac_crack> read_crack_table(const std::filesystem::path& file) {
  return read_table<hfrac_crack>(file, [](auto& crack, const auto& visit) { crack_columns(crack, visit); });
}

std::vector<hfrac_slip> read_slip_table(const std::filesystem::path& file) {
  return read_table<hfrac_slip>(file, [](auto& slip, const auto& visit) { slip_columns(slip, visit); });
}

std::string fracture_table(const std::vector<hfrac_fracture>& fractures) {
  return table_of(fractures, [](const auto& fracture, size_t, const auto& visit) {
    visit("fracture", fracture.index);
    fracture_columns(fracture, visit);
  });
}

std::string line_table(const std::vector<std::vector<hfrac_fracture_point>>& lines) {
  struct Point {
    int64_t fracture = 0;
    hfrac_fracture_point at{};
  };
  std::vector<Point> points;
  for (size_t k = 0; k < lines.size(); ++k)
    for (const auto& point : lines[k]) points.push_back({static_cast<int64_t>(k), point});
  return table_of(points, [](const auto& point, size_t, const auto& visit) {
    visit("fracture", point.fracture);
    line_columns(point.at, visit);
  });
}

std::vector<hfrac_event> events_of(const std::vector<hfrac_crack>& cracks,
                                   const std::vector<hfrac_slip>& slips,
                                   const hfrac_catalogue_options* options) {
  constexpr auto event_size = static_cast<int32_t>(sizeof(hfrac_event));
  std::vector<hfrac_event> events(cracks.size() + slips.size());  // never more than that
  const auto crack_count = static_cast<int64_t>(cracks.size()),
             slip_count = static_cast<int64_t>(slips.size());
  int64_t of_cracks = 0, of_slips = 0;
  require(hfrac_find_events(cracks.data(), static_cast<int32_t>(sizeof(hfrac_crack)), crack_count, options,
                            event_size, events.data(), crack_count, &of_cracks),
          nullptr);
  require(hfrac_find_slip_events(slips.data(), static_cast<int32_t>(sizeof(hfrac_slip)), slip_count, options,
                                 event_size, events.data() + of_cracks, slip_count, &of_slips),
          nullptr);
  events.resize(static_cast<size_t>(of_cracks + of_slips));
  std::stable_sort(events.begin(), events.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  for (size_t k = 0; k < events.size(); ++k) events[k].index = static_cast<int64_t>(k);
  return events;
}

std::string event_table(const std::vector<hfrac_event>& events) {
  return table_of(events, [](const auto& event, size_t, const auto& visit) { event_columns(event, visit); });
}

std::string cell_table(const std::vector<hfrac_cell>& cells, int64_t nx) {
  return table_of(cells, [nx](const auto& cell, size_t k, const auto& visit) {
    visit("i", static_cast<int64_t>(k) % nx);
    visit("j", static_cast<int64_t>(k) / nx);
    cell_columns(cell, visit);
  });
}

FractureMeasure measure(const std::vector<hfrac_fracture>& fractures) {
  FractureMeasure result;
  for (const auto& fracture : fractures) {
    result.volume += fracture.volume;
    if (fracture.length > result.length) {
      result.length = fracture.length;
      result.width = fracture.largest_aperture;
    }
  }
  return result;
}

namespace {

/** One field with its values, either doubles or integers. */
struct Column {
  Field what;
  std::vector<double> reals;
  std::vector<int32_t> integers;
};

std::string table(hfrac_sim* sim, std::string_view item, std::initializer_list<Location> locations) {
  std::vector<Column> columns;
  for (const Location location : locations) {
    for (const Field& field : all_fields()) {
      if (field.location != location || field.number == HFRAC_DOMAIN_OFFSET) continue;
      if (field.real) {
        columns.push_back({field, doubles(sim, field.number), {}});
      } else {
        columns.push_back({field, {}, integers(sim, field.number)});
      }
    }
  }
  TableText text;
  text.cell(item);
  for (const auto& column : columns)
    for (int32_t c = 0; c < column.what.components; ++c) text.cell(column_name(column.what, c));
  text.end_line();
  if (columns.empty()) return text.take();
  const auto& first = columns.front();
  const size_t count =
      (first.reals.size() + first.integers.size()) / static_cast<size_t>(first.what.components);
  for (size_t k = 0; k < count; ++k) {
    text.cell(k);
    for (const auto& column : columns) {
      const auto components = static_cast<size_t>(column.what.components);
      for (size_t c = k * components; c < (k + 1) * components; ++c)
        column.what.real ? text.cell(column.reals.at(c)) : text.cell(column.integers.at(c));
    }
    text.end_line();
  }
  return text.take();
}

}  // namespace

std::string disc_table(hfrac_sim* sim) {
  return table(sim, "disc", {Location::disc});
}

std::string bond_table(hfrac_sim* sim) {
  return table(sim, "bond", {Location::bond, Location::pipe});
}

std::string domain_table(hfrac_sim* sim) {
  return table(sim, "domain", {Location::domain});
}

std::string joint_table(hfrac_sim* sim) {
  return table(sim, "contact", {Location::joint});
}

}  // namespace hfrac::output
