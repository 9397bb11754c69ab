// SPDX-License-Identifier: BSD-3-Clause
// The definition of a simulation from C: the struct, the keyed way to the same values, case files, the option
// table.
#include "hfrac/def.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <string>

#include "case_file.hpp"
#include "def_image.hpp"
#include "def_lists.hpp"
#include "internal.hpp"
#include "model_file.hpp"
#include "options/fracture_law.hpp"
#include "options/grading.hpp"
#include "options/number_text.hpp"
#include "traces.hpp"
#include "utf8.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

[[noreturn]] void refuse_unknown(std::string_view key) {
  throw Error(ErrorKind::unknown_key, unknown_key_text(printable(key)));
}

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

// Calls use(list) if the key is the number of a list's items.
template <class Use>
bool use_count(std::string_view key, const Use& use) {
  bool found = false;
  each_list([&](auto list) {
    if (found || key != count_key(list)) return;
    found = true;
    use(list);
  });
  return found;
}

template <class List>
std::int64_t good_count(List list, const hfrac_sim_def& def) {
  require_list(list, def);
  return list.count(def);
}

template <class List>
[[noreturn]] void refuse_item(List list, const hfrac_sim_def& def, std::int64_t index) {
  throw Error(ErrorKind::argument, std::string(List::name) + "[" + std::to_string(index) +
                                       "] is not there: " + count_key(list) + " is " +
                                       std::to_string(list.count(def)) + "; " + std::string(List::plural) +
                                       " are added in order.");
}

// The item of a key, to be read.
template <class List>
auto item_at(List list, const hfrac_sim_def& def, std::int64_t index) {
  if (index >= good_count(list, def)) refuse_item(list, def, index);
  return item_of(list, def, index);
}

// Changes one item with set(values); one past the last is added, so that keys alone can define items. Nothing changes if a value
// is refused.
template <class List, class Set>
void set_item(List list, hfrac_sim_def& def, std::int64_t index, const Set& set) {
  const std::int64_t count = good_count(list, def);
  if (index > count || index >= most_items) refuse_item(list, def, index);
  auto values = index == count ? List::fresh(def) : item_of(list, def, index);
  set(values);
  OwnedList* own = own_list(list, def);
  if (own == nullptr || own->count() != count) {
    auto items = items_of(list, def);
    items.resize(static_cast<std::size_t>(std::max(count, index + 1)));
    items[static_cast<std::size_t>(index)] = values;
    put_items(list, items, def);
    return;
  }
  require_place(list, own->size, values);
  if (index == count) add_item(*own);
  write_item(list, *own, static_cast<std::size_t>(index), values);
  show_list(list, *own, def);
}

template <class List>
void set_count(List list, hfrac_sim_def& def, std::int64_t count) {
  if (count < 0 || count > most_items) {
    throw Error(ErrorKind::argument, count_key(list) + " = " + std::to_string(count) + " is outside 0 to " +
                                         std::to_string(most_items) + ".");
  }
  auto items = items_of(list, def);
  items.resize(static_cast<std::size_t>(count), List::fresh(def));
  put_items(list, items, def);
}

std::int64_t integer_of(const WellOptions& values, const WellOptionInfo& info) {
  if (info.integer != nullptr) return values.*info.integer;
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
      set_item(list, full, index, [&](auto& values) { set(values, info); });
    });
    if (of_a_list) {
    } else if (const OptionInfo* info = find_option(key)) {
      Options values = options_of(full);
      set(values, *info);
      put_options(values, full);
    } else {
      refuse_unknown(key);
    }
    write_def(def, full, "def");
  });
}

// To whom the definition says; what a listener throws is dropped, as it is later.
void tell_notes(const hfrac_sim_def& def, const std::vector<std::string>& notes) {
  if (def.log == nullptr || def.log_level < HFRAC_LOG_INFO) return;
  for (const auto& note : notes) {
    try {
      call_host(nullptr, [&] { return def.log(def.log_user, HFRAC_LOG_INFO, note.c_str()); });
    } catch (const CallbackError&) {
      continue;
    }
  }
}

void check(const hfrac_sim_def& full) {
  const CaseDefinition definition = case_of(full);
  validate(definition, given_discs_of(full), given_bonds_of(full));
  const auto packed = packed_model_of(definition, !given_discs_of(full).empty());
  if (!packed) return;
  CaseDefinition decided = definition;
  decided.options.fracture_law = static_cast<std::int64_t>(fracture_law_of(definition));
  require_fit(*packed, decided);
}

}  // namespace

std::int32_t hfrac_sim_def_init(hfrac_sim_def* def, std::int32_t struct_size) {
  return guarded([&] {
    require_not_null(def, "def");
    require_struct_size(struct_size, "def");
    require_def_size(struct_size);
    def->struct_size = struct_size;
    write_struct(def, default_def(), "def");
  });
}

std::int32_t hfrac_sim_def_free(hfrac_sim_def* def) {
  return guarded([&] {
    if (def == nullptr) return;
    hfrac_sim_def full = read_def(def);
    const std::unique_ptr<OwnedLists> lists(static_cast<OwnedLists*>(full.lists));
    each_list([&](auto list) {
      if (own_list(list, full) == nullptr) return;
      list.items(full) = nullptr;
      list.count(full) = 0;
    });
    full.lists = nullptr;
    write_def(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_copy(const hfrac_sim_def* from, hfrac_sim_def* to) {
  return guarded([&] {
    hfrac_sim_def full = read_def(from);
    const CaseDefinition definition = case_of(full);
    const hfrac_sim_def old = read_def(to);
    full.lists = old.lists;
    each_list([&](auto list) { list.size(full) = list.size(old); });
    write_case(to, definition, full, "to");
  });
}

std::int32_t hfrac_sim_def_load(hfrac_sim_def* def, const char* path) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(path, "path");
    std::vector<std::string> notes;
    write_case(def, load_case(path, case_of(full), &notes), full, "def");
    tell_notes(full, notes);
  });
}

std::int32_t hfrac_sim_def_add_traces(hfrac_sim_def* def, const char* path) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(path, "path");
    CaseDefinition definition = case_of(full);
    const auto traces = read_traces(path, {});
    definition.joints.insert(definition.joints.end(), traces.begin(), traces.end());
    write_case(def, definition, full, "def");
  });
}

std::int32_t hfrac_sim_def_write(const hfrac_sim_def* def, char* buffer, std::int32_t capacity,
                                 std::int32_t* needed) {
  return guarded([&] { copy_text(case_text(case_of(read_def(def))), buffer, capacity, needed); });
}

std::int32_t hfrac_sim_def_check(const hfrac_sim_def* def) {
  return guarded([&] { check(read_def(def)); });
}

std::int32_t hfrac_sim_def_disc_radii(const hfrac_sim_def* def, double* fine, double* coarsest) {
  return guarded([&] {
    require_not_null(fine, "fine");
    require_not_null(coarsest, "coarsest");
    const CaseDefinition definition = case_of(read_def(def));
    check_ranges(definition);
    const Grading sizes = grading_of(definition);
    *fine = sizes.fine;
    *coarsest = sizes.coarsest();
  });
}

std::int32_t hfrac_sim_def_check_file(const hfrac_sim_def* def, const char* path) {
  return guarded([&] {
    const hfrac_sim_def full = read_def(def);
    require_not_null(path, "path");
    try {
      check(full);
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
  if (key == nullptr || !use_count(key, [](auto /*list*/) {})) {
    return set_by_key(def, key,
                      [&](auto& values, const auto& info) { set_integer(values, info, key, value); });
  }
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    use_count(key, [&](auto list) { set_count(list, full, value); });
    write_def(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_set_str(hfrac_sim_def* def, const char* key, const char* value) {
  if (value == nullptr) return guarded([&] { require_not_null(value, "value"); });
  const bool title = key != nullptr && key == std::string_view("title"),
             file = key != nullptr && key == std::string_view("packing.file");
  if (!title && !file) {
    const std::string word = printable(value);
    return set_by_key(def, key, [&](auto& values, const auto& info) { set_word(values, info, key, word); });
  }
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    title ? put_title(value, full) : put_packing_file(value, full);
    write_def(def, full, "def");
  });
}

std::int32_t hfrac_sim_def_get_f64(const hfrac_sim_def* def, const char* key, double* value) {
  return guarded([&] {
    hfrac_sim_def full = read_def(def);
    require_not_null(key, "key");
    require_not_null(value, "value");
    if (use_item(key, [&](auto list, std::int64_t index, const auto& info) {
          *value = get_value(item_at(list, full, index), info);
        }))
      return;
    if (const OptionInfo* info = find_option(key))
      *value = get_value(options_of(full), *info);
    else if (!use_count(key, [&](auto list) { *value = static_cast<double>(good_count(list, full)); }))
      refuse_unknown(key);
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
        }))
      return;
    if (const OptionInfo* info = find_option(key)) {
      if (info->real != nullptr) refuse_fraction(key);
      *value = options_of(full).*info->integer;
    } else if (!use_count(key, [&](auto list) { *value = good_count(list, full); })) {
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
    const bool of_list = use_item(key,
                                  [&](auto list, std::int64_t index, const auto& info) {
                                    text = value_text(info, get_value(item_at(list, full, index), info));
                                  }) ||
                         use_count(key, [&](auto list) { text = number_text(good_count(list, full)); });
    if (const OptionInfo* info = of_list ? nullptr : find_option(key)) {
      const Options options = options_of(full);
      text = info->type == ValueType::integer ? number_text(options.*info->integer)
                                              : value_text(*info, get_value(options, *info));
    } else if (key == std::string_view("title")) {
      text = case_of(full).title;
    } else if (key == std::string_view("packing.file")) {
      text = case_of(full).packing_file;
    } else if (!of_list) {
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
