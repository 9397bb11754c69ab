// SPDX-License-Identifier: BSD-3-Clause
#include "output/field_tables.hpp"

#include <initializer_list>
#include <string_view>
#include <vector>

#include "run/fields.hpp"
#include "run/table_file.hpp"

namespace hfrac::output {
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

}  // namespace hfrac::output
