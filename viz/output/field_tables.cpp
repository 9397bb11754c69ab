// SPDX-License-Identifier: BSD-3-Clause
#include "output/field_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <vector>

namespace hfrac::output {
namespace {

enum Location : int32_t { kDisc = 0, kBond = 1, kPipe = 2, kDomain = 3 };

constexpr std::array kFields{
#define HFRAC_FIELD_NUMBER_(name, value, key, unit, location, dtype, components, help) int32_t{value},
    HFRAC_FIELD_LIST(HFRAC_FIELD_NUMBER_)
#undef HFRAC_FIELD_NUMBER_
};

/** One field with its values, either doubles or integers. */
struct Column {
  hfrac_field_desc what = sized<hfrac_field_desc>();
  std::vector<double> reals;
  std::vector<int32_t> integers;
};

std::string unit_suffix(std::string_view unit) {
  if (unit == "1") return {};
  std::string suffix = "_";
  for (const char c : unit) {
    if (c == '/') {
      suffix.append("_per_");
    } else {
      suffix.push_back(c == ' ' ? '_' : c);
    }
  }
  return suffix;
}

std::string component_name(const hfrac_field_desc& what, int32_t component) {
  const std::string_view key = what.name;
  const std::string_view name = key.substr(key.find('.') + 1);
  const std::string unit = unit_suffix(what.unit);
  if (what.components == 1) return std::string(name) + unit;
  const auto k = static_cast<size_t>(component);
  if (what.dtype == 1)
    return fmt::format("{}_{}", name.substr(0, name.size() - 1), component);  // disc_0, disc_1
  if (what.components == 3) return fmt::format("{}_{}{}", name, std::array{"xx", "yy", "xy"}[k], unit);
  const char* axis = std::array{"x", "y"}[k];
  if (name == "position" || name == "centre") return fmt::format("{}{}", axis, unit);
  return fmt::format("{}_{}{}", name, axis, unit);
}

std::vector<Column> columns_at(hfrac_sim* sim, std::initializer_list<Location> locations) {
  std::vector<Column> columns;
  for (const Location location : locations) {
    for (const int32_t field : kFields) {
      Column column;
      require(hfrac_field_info(sim, field, &column.what), sim);
      if (column.what.location != location || field == HFRAC_DOMAIN_OFFSET) continue;
      if (column.what.dtype == 0) column.reals = doubles(sim, field);
      if (column.what.dtype == 1) column.integers = integers(sim, field);
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

std::string table(std::string_view item, const std::vector<Column>& columns) {
  std::string text(item);
  for (const auto& column : columns)
    for (int32_t c = 0; c < column.what.components; ++c)
      fmt::format_to(std::back_inserter(text), ",{}", component_name(column.what, c));
  text += "\n";
  const int64_t count = columns.empty() ? 0 : columns.front().what.count;
  for (int64_t k = 0; k < count; ++k) {
    auto out = fmt::format_to(std::back_inserter(text), "{}", k);
    for (const auto& column : columns) {
      for (int32_t c = 0; c < column.what.components; ++c) {
        const auto at = static_cast<size_t>(k * column.what.components + c);
        out = column.what.dtype == 0 ? fmt::format_to(out, ",{}", column.reals[at])
                                     : fmt::format_to(out, ",{}", column.integers[at]);
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string disc_table(hfrac_sim* sim) {
  return table("disc", columns_at(sim, {kDisc}));
}

std::string bond_table(hfrac_sim* sim) {
  return table("bond", columns_at(sim, {kBond, kPipe}));
}

std::string domain_table(hfrac_sim* sim) {
  return table("domain", columns_at(sim, {kDomain}));
}

}  // namespace hfrac::output
