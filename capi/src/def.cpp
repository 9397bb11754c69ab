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

[[noreturn]] void refuse_unknown(std::string_view key) {
  throw Error(ErrorKind::unknown_key, unknown_key_text(printable(key)));
}

// The lists of a definition, each the same way: "well[2].radius" is the value `radius` of item 2 of the list `well`.
struct Wells {
  static constexpr std::string_view name = "well", plural = "wells", count_key = "well_count";
  static constexpr std::int64_t most = HFRAC_MAX_WELLS;
  static auto& count(auto& def) { return def.well_count; }
  static auto* items(auto& def) { return def.wells; }
  static auto* find(std::string_view value) { return find_well_option(value); }
  static WellOptions get(const hfrac_well_def& well) { return well_of(well); }
  static void put(const WellOptions& from, hfrac_well_def& well) { put_well(from, well); }
  static WellOptions fresh(const hfrac_sim_def& def) {
    WellOptions well;
    well.x = 0.5 * def.model_width;
    well.y = 0.5 * def.model_height;
    return well;
  }
};
struct Joints {
  static constexpr std::string_view name = "joint", plural = "joints", count_key = "joint_count";
  static constexpr std::int64_t most = HFRAC_MAX_JOINTS;
  static auto& count(auto& def) { return def.joint_count; }
  static auto* items(auto& def) { return def.joints; }
  static auto* find(std::string_view value) { return find_joint_value(value); }
  static JointOptions get(const hfrac_joint_def& joint) { return joint_of(joint); }
  static void put(const JointOptions& from, hfrac_joint_def& joint) { put_joint(from, joint); }
  static JointOptions fresh(const hfrac_sim_def& /*def*/) { return {}; }
};
struct Schedule {
  static constexpr std::string_view name = "schedule", plural = "entries", count_key = "schedule_count";
  static constexpr std::int64_t most = HFRAC_MAX_SCHEDULE;
  static auto& count(auto& def) { return def.schedule_count; }
  static auto* items(auto& def) { return def.schedule; }
  static auto* find(std::string_view value) { return find_schedule_value(value); }
  static ScheduleEntry get(const hfrac_schedule_def& entry) { return entry_of(entry); }
  static void put(const ScheduleEntry& from, hfrac_schedule_def& entry) { put_entry(from, entry); }
  static ScheduleEntry fresh(const hfrac_sim_def& /*def*/) { return {}; }
};

// Calls use(list, index, entry of the list's table) if the key is of `List`.
template <class List, class Use>
bool use_item_of(std::string_view key, const Use& use) {
  if (!key.starts_with(List::name) || !key.substr(List::name.size()).starts_with('[')) return false;
  std::int64_t index = -1;
  const char* const end = key.data() + key.size();
  const auto number = std::from_chars(key.data() + List::name.size() + 1, end, index);
  const std::string_view rest(number.ptr, static_cast<std::size_t>(end - number.ptr));
  if (number.ec != std::errc{} || index < 0 || !rest.starts_with("].")) refuse_unknown(key);
  const auto* info = List::find(rest.substr(2));
  if (info == nullptr)
    throw Error(ErrorKind::unknown_key, unknown_item_key_text(List::name, printable(rest.substr(2))));
  use(List{}, index, *info);
  return true;
}

template <class Use>
bool use_item(std::string_view key, const Use& use) {
  return use_item_of<Wells>(key, use) || use_item_of<Joints>(key, use) || use_item_of<Schedule>(key, use);
}

// The number of a list's items, nullptr if the key is no such number.
std::int64_t* count_of(hfrac_sim_def& def, std::string_view key) {
  if (key == Wells::count_key) return &def.well_count;
  if (key == Joints::count_key) return &def.joint_count;
  if (key == Schedule::count_key) return &def.schedule_count;
  return nullptr;
}

template <class List>
[[noreturn]] void refuse_item(const hfrac_sim_def& def, std::int64_t index) {
  throw Error(ErrorKind::argument,
              std::string(List::name) + "[" + std::to_string(index) + "] is not there: " +
                  std::string(List::count_key) + " is " + std::to_string(List::count(def)) + ", at most " +
                  std::to_string(List::most) + "; " + std::string(List::plural) + " are added in order.");
}

// The item of a key, to be read.
template <class List>
auto item_at(List /*list*/, const hfrac_sim_def& def, std::int64_t index) {
  if (index >= std::min<std::int64_t>(List::count(def), List::most)) refuse_item<List>(def, index);
  return List::get(List::items(def)[index]);
}

// The item of a key, to be set. One past the last is added, so that keys alone can define items.
template <class List>
auto& item_to_set(List /*list*/, hfrac_sim_def& def, std::int64_t index) {
  const std::int64_t count = List::count(def);
  if (count < 0 || index > count || index >= List::most) refuse_item<List>(def, index);
  if (index == count) {
    List::put(List::fresh(def), List::items(def)[index]);
    ++List::count(def);
  }
  return List::items(def)[index];
}

std::int64_t integer_of(const WellOptions& values, const WellOptionInfo& /*info*/) {
  return static_cast<std::int64_t>(values.control);
}
template <class Item>
std::int64_t integer_of(const Item& values, const ItemInfo<Item>& info) {
  return values.*info.integer;
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
    const bool of_a_list = use_item(key, [&](auto list, std::int64_t index, const auto& info) {
      auto& item = item_to_set(list, full, index);
      auto values = list.get(item);
      set(values, info);
      list.put(values, item);
    });
    if (of_a_list) {
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
    put_case(load_case(path, case_of(full), {HFRAC_MAX_WELLS, HFRAC_MAX_JOINTS, HFRAC_MAX_SCHEDULE}), full);
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

std::int32_t hfrac_sim_def_check_file(const hfrac_sim_def* def, const char* path) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(path, "path");
    try {
      validate(case_of(full), given_discs_of(full), given_bonds_of(full));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::argument && error.kind() != ErrorKind::model) throw;
      const std::string text = with_place(path, lines_of_keys(path), error.what());
      throw Error(ErrorKind::case_file, text);
    }
  });
}

std::int32_t hfrac_sim_def_set_f64(hfrac_sim_def* def, const char* key, double value) {
  return set_by_key(def, key, [&](auto& values, const auto& info) { set_real(values, info, key, value); });
}

std::int32_t hfrac_sim_def_set_i64(hfrac_sim_def* def, const char* key, std::int64_t value) {
  hfrac_sim_def any{};
  if (key == nullptr || count_of(any, key) == nullptr) {
    return set_by_key(def, key,
                      [&](auto& values, const auto& info) { set_integer(values, info, key, value); });
  }
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    *count_of(full, key) = value;
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
    if (use_item(key, [&](auto list, std::int64_t index, const auto& info) {
          *value = get_value(item_at(list, full, index), info);
        })) {
    } else if (const OptionInfo* info = find_option(key)) {
      *value = get_value(options_of(full), *info);
    } else if (const std::int64_t* count = count_of(full, key)) {
      *value = static_cast<double>(*count);
    } else {
      refuse_unknown(key);
    }
  });
}

std::int32_t hfrac_sim_def_get_i64(const hfrac_sim_def* def, const char* key, std::int64_t* value) {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    require_not_null(value, "value");
    if (use_item(key, [&](auto list, std::int64_t index, const auto& info) {
          const auto item = item_at(list, full, index);
          if (info.real != nullptr) refuse_fraction(key);
          *value = integer_of(item, info);
        })) {
    } else if (const OptionInfo* info = find_option(key)) {
      if (info->real != nullptr) refuse_fraction(key);
      *value = options_of(full).*info->integer;
    } else if (const std::int64_t* count = count_of(full, key)) {
      *value = *count;
    } else {
      refuse_unknown(key);
    }
  });
}

std::int32_t hfrac_sim_def_get_str(const hfrac_sim_def* def, const char* key, char* buffer,
                                   std::int32_t capacity, std::int32_t* needed) {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    std::string text;
    if (use_item(key, [&](auto list, std::int64_t index, const auto& info) {
          text = value_text(info, get_value(item_at(list, full, index), info));
        })) {
    } else if (const OptionInfo* info = find_option(key)) {
      const Options options = options_of(full);
      text = info->type == ValueType::integer ? number_text(options.*info->integer)
                                              : value_text(*info, get_value(options, *info));
    } else if (const std::int64_t* count = count_of(full, key)) {
      text = number_text(*count);
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

std::int32_t hfrac_joint_option_count(std::int32_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    *count = static_cast<std::int32_t>(joint_table().size());
  });
}

std::int32_t hfrac_joint_option_at(std::int32_t index, hfrac_option_info* info) {
  return guarded([&] { describe(joint_table(), index, info); });
}

std::int32_t hfrac_schedule_option_count(std::int32_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    *count = static_cast<std::int32_t>(schedule_table().size());
  });
}

std::int32_t hfrac_schedule_option_at(std::int32_t index, hfrac_option_info* info) {
  return guarded([&] { describe(schedule_table(), index, info); });
}
