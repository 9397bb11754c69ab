// SPDX-License-Identifier: BSD-3-Clause
// The definition of a simulation from C: the struct, the keyed way to the same values, case files, the option
// table.
#include "hfrac/def.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "case_file.hpp"
#include "def_image.hpp"
#include "internal.hpp"
#include "options/number_text.hpp"
#include "utf8.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

constexpr std::string_view well_count_key = "well_count";

// "well[2].radius": number and entry of the value.
struct WellKey {
  std::int64_t index;
  const WellOptionInfo* info;
};

[[noreturn]] void refuse_unknown(std::string_view key) {
  throw Error(ErrorKind::unknown_key, unknown_key_text(printable(key)));
}

std::optional<WellKey> parse_well_key(std::string_view key) {
  constexpr std::string_view prefix = "well[";
  if (!key.starts_with(prefix)) return std::nullopt;
  WellKey result{-1, nullptr};
  const char* const end = key.data() + key.size();
  const auto number = std::from_chars(key.data() + prefix.size(), end, result.index);
  const std::string_view rest(number.ptr, static_cast<std::size_t>(end - number.ptr));
  if (number.ec != std::errc{} || result.index < 0 || !rest.starts_with("].")) refuse_unknown(key);
  result.info = find_well_option(rest.substr(2));
  if (result.info == nullptr) {
    throw Error(ErrorKind::unknown_key, unknown_well_key_text(printable(rest.substr(2))));
  }
  return result;
}

[[noreturn]] void refuse_well(const hfrac_sim_def& def, std::int64_t index) {
  throw Error(ErrorKind::argument, "well[" + std::to_string(index) + "] is not there: well_count is " +
                                       std::to_string(def.well_count) + ", at most " +
                                       std::to_string(static_cast<int>(HFRAC_MAX_WELLS)) +
                                       "; wells are added in order.");
}

// The well of a key, to be read.
const hfrac_well_def& well_at(const hfrac_sim_def& def, std::int64_t index) {
  if (index >= std::min<std::int64_t>(def.well_count, HFRAC_MAX_WELLS)) refuse_well(def, index);
  return def.wells[index];
}

// The well of a key, to be set. One past the last is added, so that keys alone can define wells.
hfrac_well_def& well_to_set(hfrac_sim_def& def, std::int64_t index) {
  const std::int64_t count = def.well_count;
  if (count < 0 || index > count || index >= HFRAC_MAX_WELLS) refuse_well(def, index);
  if (index == count) {
    def.wells[index] = hfrac_well_def{};
    def.wells[index].x = 0.5 * def.model_width;
    def.wells[index].y = 0.5 * def.model_height;
    ++def.well_count;
  }
  return def.wells[index];
}

[[noreturn]] void refuse_fraction(std::string_view key) {
  throw Error(ErrorKind::argument,
              std::string(key) + " is a real number; read it with hfrac_sim_def_get_f64.");
}

// A value as a case file would have it, without quotes.
std::string value_text(const ValueInfo& info, double value) {
  if (info.type == ValueType::real) return number_text(value);
  const auto index = static_cast<std::int64_t>(value);
  if (info.type == ValueType::integer) return number_text(index);
  return index >= 0 && index < choice_count(info.choices) ? std::string(choice_word(info.choices, index))
                                                          : number_text(index);
}

template <class Table>
void describe(const Table& table, std::int32_t index, hfrac_option_info* info) {
  if (index < 0 || static_cast<std::size_t>(index) >= table.size()) {
    throw Error(ErrorKind::argument, "index = " + std::to_string(index) + " is outside 0 to " +
                                         std::to_string(table.size() - 1) + ".");
  }
  const ValueInfo& row = table[static_cast<std::size_t>(index)];
  const hfrac_option_info full{sizeof full, static_cast<std::int32_t>(row.type),
                               row.key,     row.unit,
                               row.choices, row.help,
                               row.initial, row.min,
                               row.max};
  write_struct(info, full, "info");
}

// Sets a value of any key with set(values, info, key), in a copy that replaces the caller's struct if all
// went well.
template <class Set>
std::int32_t set_by_key(hfrac_sim_def* def, const char* key, Set&& set) noexcept {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    if (const auto well_key = parse_well_key(key)) {
      hfrac_well_def& well = well_to_set(full, well_key->index);
      WellOptions values = well_of(well);
      set(values, *well_key->info);
      put_well(values, well);
    } else if (const OptionInfo* info = find_option(key)) {
      Options values = options_of(full);
      set(values, *info);
      put_options(values, full);
    } else {
      refuse_unknown(key);
    }
    write_struct(def, full, "def");
  });
}

}  // namespace

std::int32_t hfrac_sim_def_init(hfrac_sim_def* def, std::int32_t struct_size) {
  return guarded([&] {
    require_not_null(def, "def");
    require_struct_size(struct_size, "def");
    def->struct_size = struct_size;
    write_struct(def, default_def(), "def");
  });
}

std::int32_t hfrac_sim_def_load(hfrac_sim_def* def, const char* path) {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(path, "path");
    put_case(load_case(path, case_of(full), HFRAC_MAX_WELLS), full);
    write_struct(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_write(const hfrac_sim_def* def, char* buffer, std::int32_t capacity,
                                 std::int32_t* needed) {
  return guarded([&] { copy_text(case_text(case_of(read_def(def))), buffer, capacity, needed); });
}

std::int32_t hfrac_sim_def_check(const hfrac_sim_def* def) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    validate(case_of(full), given_discs_of(full), given_bonds_of(full));
  });
}

std::int32_t hfrac_sim_def_set_f64(hfrac_sim_def* def, const char* key, double value) {
  return set_by_key(def, key, [&](auto& values, const auto& info) { set_real(values, info, key, value); });
}

std::int32_t hfrac_sim_def_set_i64(hfrac_sim_def* def, const char* key, std::int64_t value) {
  if (key == nullptr || key != well_count_key) {
    return set_by_key(def, key,
                      [&](auto& values, const auto& info) { set_integer(values, info, key, value); });
  }
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    full.well_count = value;
    (void)case_of(full);  // refuses a count out of range
    write_struct(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_set_str(hfrac_sim_def* def, const char* key, const char* value) {
  if (value == nullptr) return guarded([&] { require_not_null(value, "value"); });
  if (key == nullptr || key != std::string_view("title")) {
    const std::string word = printable(value);
    return set_by_key(def, key, [&](auto& values, const auto& info) { set_word(values, info, key, word); });
  }
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    put_title(value, full);
    write_struct(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_get_f64(const hfrac_sim_def* def, const char* key, double* value) {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    require_not_null(value, "value");
    if (const auto well_key = parse_well_key(key)) {
      *value = get_value(well_of(well_at(full, well_key->index)), *well_key->info);
    } else if (const OptionInfo* info = find_option(key)) {
      *value = get_value(options_of(full), *info);
    } else if (key == well_count_key) {
      *value = static_cast<double>(full.well_count);
    } else {
      refuse_unknown(key);
    }
  });
}

std::int32_t hfrac_sim_def_get_i64(const hfrac_sim_def* def, const char* key, std::int64_t* value) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    require_not_null(value, "value");
    if (const auto well_key = parse_well_key(key)) {
      const WellOptions well = well_of(well_at(full, well_key->index));
      if (well_key->info->real != nullptr) refuse_fraction(key);
      *value = static_cast<std::int64_t>(well.control);
    } else if (const OptionInfo* info = find_option(key)) {
      if (info->real != nullptr) refuse_fraction(key);
      *value = options_of(full).*info->integer;
    } else if (key == well_count_key) {
      *value = full.well_count;
    } else {
      refuse_unknown(key);
    }
  });
}

std::int32_t hfrac_sim_def_get_str(const hfrac_sim_def* def, const char* key, char* buffer,
                                   std::int32_t capacity, std::int32_t* needed) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    std::string text;
    if (const auto well_key = parse_well_key(key)) {
      const WellOptions well = well_of(well_at(full, well_key->index));
      text = value_text(*well_key->info, get_value(well, *well_key->info));
    } else if (const OptionInfo* info = find_option(key)) {
      const Options options = options_of(full);
      text = info->type == ValueType::integer ? number_text(options.*info->integer)
                                              : value_text(*info, get_value(options, *info));
    } else if (key == well_count_key) {
      text = number_text(full.well_count);
    } else if (key == std::string_view("title")) {
      text = case_of(full).title;
    } else {
      refuse_unknown(key);
    }
    copy_text(text, buffer, capacity, needed);
  });
}

std::int32_t hfrac_option_count(std::int32_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    *count = static_cast<std::int32_t>(option_table().size());
  });
}

std::int32_t hfrac_option_at(std::int32_t index, hfrac_option_info* info) {
  return guarded([&] { describe(option_table(), index, info); });
}

std::int32_t hfrac_well_option_count(std::int32_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    *count = static_cast<std::int32_t>(well_option_table().size());
  });
}

std::int32_t hfrac_well_option_at(std::int32_t index, hfrac_option_info* info) {
  return guarded([&] { describe(well_option_table(), index, info); });
}
