// SPDX-License-Identifier: BSD-3-Clause
// The lists of a definition - wells, joints, schedule - each the same way: where it stands in the C struct, in the engine's
// CaseDefinition and in what the library owns behind a struct, and how an item is carried from one to the other.
//
// A list is a pointer, a count and the size of an item. The caller's own arrays are read and never written or kept. A list that
// the library changes (a case file, a key) becomes one of its own first; `hfrac_sim_def.lists` points to those, and
// hfrac_sim_def_free ends them.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hfrac/def.h"
#include "internal.hpp"
#include "options/options.hpp"

namespace hfrac::capi {

// Items one after the other, each `size` bytes long.
struct OwnedList {
  std::vector<std::uint64_t> words;
  std::int64_t size = 0;
  [[nodiscard]] std::int64_t count() const {
    return size == 0 ? 0 : static_cast<std::int64_t>(words.size()) * 8 / size;
  }
};
struct OwnedLists {
  OwnedList wells, joints, schedule;
};

struct Wells {
  using Item = hfrac_well_def;
  using Values = WellOptions;
  static constexpr std::string_view name = "well", plural = "wells";
  static auto& items(auto& def) { return def.wells; }
  static auto& count(auto& def) { return def.well_count; }
  static auto& size(auto& def) { return def.well_size; }
  static auto& in(auto& definition) { return definition.wells; }
  static const WellOptionInfo* find(std::string_view value) { return find_well_option(value); }
  static Values get(const Item& w) { return converted<Values>(w); }
  static Item put(const Values& w) { return converted<Item>(w); }
  static Values fresh(const hfrac_sim_def& def) {  // in the model's middle
    Values well;
    well.x = 0.5 * def.model_width;
    well.y = 0.5 * def.model_height;
    return well;
  }

 private:
  template <class To>
  static To converted(const auto& from) {
    To to{};
#define F64(name, ...) to.name = from.name;
#define I64(name, ...) to.name = from.name;
#define CHOICE(name, ...) to.name = static_cast<decltype(to.name)>(from.name);
#include "options/well_list.inc"
#undef F64
#undef I64
#undef CHOICE
    return to;
  }
};

struct Joints {
  using Item = hfrac_joint_def;
  using Values = JointOptions;
  static constexpr std::string_view name = "joint", plural = "joints";
  static auto& items(auto& def) { return def.joints; }
  static auto& count(auto& def) { return def.joint_count; }
  static auto& size(auto& def) { return def.joint_size; }
  static auto& in(auto& definition) { return definition.joints; }
  static const JointInfo* find(std::string_view value) { return find_joint_value(value); }
  static Values get(const Item& j) { return converted<Values>(j); }
  static Item put(const Values& j) { return converted<Item>(j); }
  static Values fresh(const hfrac_sim_def& /*def*/) { return {}; }

 private:
  template <class To>
  static To converted(const auto& from) {
    To to{};
#define F64(name, ...) to.name = from.name;
#define CHOICE(name, ...) to.name = from.name;
#include "options/joint_list.inc"
#undef F64
#undef CHOICE
    return to;
  }
};

struct Schedule {
  using Item = hfrac_schedule_def;
  using Values = ScheduleEntry;
  static constexpr std::string_view name = "schedule", plural = "entries";
  static auto& items(auto& def) { return def.schedule; }
  static auto& count(auto& def) { return def.schedule_count; }
  static auto& size(auto& def) { return def.schedule_size; }
  static auto& in(auto& definition) { return definition.schedule; }
  static const ScheduleInfo* find(std::string_view value) { return find_schedule_value(value); }
  static Values get(const Item& e) { return {e.well, e.time, e.value, e.control, e.fluid}; }
  static Item put(const Values& e) { return {e.well, e.time, e.value, e.control, e.fluid}; }
  static Values fresh(const hfrac_sim_def& /*def*/) { return {}; }
};

template <class Use>
void each_list(const Use& use) {
  use(Wells{});
  use(Joints{});
  use(Schedule{});
}

template <class List>
std::string count_key(List /*list*/) {
  return std::string(List::name) + "_count";
}

template <class List>
const char* list_member(List /*list*/) {
  return List::name == "well" ? "wells" : List::name == "joint" ? "joints" : "schedule";
}

// More of anything is garbage, not a list.
inline constexpr std::int64_t most_items = 100'000'000;

// The library's own list if the items of `def` are it, otherwise nullptr.
template <class List>
OwnedList* own_list(List /*list*/, const hfrac_sim_def& def) {
  auto* lists = static_cast<OwnedLists*>(def.lists);
  if (lists == nullptr) return nullptr;
  auto& own = List::in(*lists);
  return !own.words.empty() && static_cast<const void*>(List::items(def)) == own.words.data() ? &own
                                                                                              : nullptr;
}

template <class List>
[[noreturn]] void refuse_size(List /*list*/, const hfrac_sim_def& def, const std::string& fault) {
  throw Error(ErrorKind::struct_size,
              std::string(List::name) + "_size = " + std::to_string(List::size(def)) + fault);
}

// Throws unless `def` has as many readable items as it says.
template <class List>
void require_list(List list, const hfrac_sim_def& def) {
  const std::int64_t count = List::count(def), size = List::size(def);
  const std::string name(List::name), shown = count_key(list) + " = " + std::to_string(count);
  const auto refuse = [&](const std::string& fault) { throw Error(ErrorKind::argument, shown + fault); };
  if (count < 0 || count > most_items) refuse(" is outside 0 to " + std::to_string(most_items) + ".");
  if (count == 0) return;
  if (List::items(def) == nullptr)
    refuse(", but there are no items; point " + std::string(list_member(list)) +
           " to that many, or set the count by its key.");
  if (const OwnedList* own = own_list(list, def)) {
    if (size != own->size)
      refuse_size(list, def, ", but the library's items are " + std::to_string(own->size) + " bytes apart.");
    if (count > own->count())
      refuse(", but the library's list has " + std::to_string(own->count()) +
             "; add more by their keys, or set the count by its key.");
    return;
  }
  if (size < 8 || size % 8 != 0 || size > struct_size_limit)
    refuse_size(list, def, " cannot be the size of an item; set it to sizeof(hfrac_" + name + "_def).");
}

// Item `index`, which is there; what a smaller item lacks has its default.
template <class List>
typename List::Values item_of(List list, const hfrac_sim_def& def, std::int64_t index) {
  using Item = typename List::Item;
  const auto size = static_cast<std::size_t>(List::size(def));
  const auto* bytes = reinterpret_cast<const unsigned char*>(List::items(def)) + index * List::size(def);
  if (std::any_of(bytes + std::min(size, sizeof(Item)), bytes + size, [](unsigned char b) { return b != 0; }))
    refuse_size(list, def,
                ": " + std::string(List::name) + "[" + std::to_string(index) +
                    "] was made with a newer header and uses a member this library does not know; update the "
                    "library.");
  Item item = List::put(typename List::Values{});
  std::memcpy(&item, bytes, std::min(size, sizeof item));
  return List::get(item);
}

template <class List>
std::vector<typename List::Values> items_of(List list, const hfrac_sim_def& def) {
  require_list(list, def);
  std::vector<typename List::Values> items;
  items.reserve(static_cast<std::size_t>(List::count(def)));
  for (std::int64_t i = 0; i < List::count(def); ++i) items.push_back(item_of(list, def, i));
  return items;
}

// Throws Error(struct_size) if items of that size have no place for what `values` hold.
template <class List>
void require_place(List /*list*/, std::int64_t size, const typename List::Values& values) {
  using Item = typename List::Item;
  const Item item = List::put(values), usual = List::put(typename List::Values{});
  const auto kept = std::min(static_cast<std::size_t>(size), sizeof(Item));
  const auto tail = [&](const Item& of) { return reinterpret_cast<const unsigned char*>(&of) + kept; };
  if (std::memcmp(tail(item), tail(usual), sizeof(Item) - kept) == 0) return;
  throw Error(ErrorKind::struct_size, std::string(List::name) + "_size = " + std::to_string(size) +
                                          " has no place for all values of a " + std::string(List::name) +
                                          ", " + std::to_string(sizeof(Item)) +
                                          " bytes: compile the program with this library's headers.");
}

// Item `index` of a list of the library's, as far as its items reach.
template <class List>
void write_item(List /*list*/, OwnedList& own, std::size_t index, const typename List::Values& values) {
  const typename List::Item item = List::put(values);
  const auto size = static_cast<std::size_t>(own.size);
  std::memcpy(reinterpret_cast<unsigned char*>(own.words.data()) + index * size, &item,
              std::min(size, sizeof item));
}

// Room for one more item, zeroed.
inline void add_item(OwnedList& own) {
  own.words.resize(own.words.size() + static_cast<std::size_t>(own.size) / 8);
}

// `items` as a list of the library's, of the size that `def` says, or of this library's if it says none.
template <class List>
OwnedList owned(List list, const std::vector<typename List::Values>& items, const hfrac_sim_def& def) {
  const std::int64_t size = List::size(def);
  const bool given = size >= 8 && size % 8 == 0 && size <= struct_size_limit;
  OwnedList own;
  own.size = given ? size : static_cast<std::int64_t>(sizeof(typename List::Item));
  own.words.resize(items.size() * static_cast<std::size_t>(own.size) / 8);
  for (std::size_t i = 0; i < items.size(); ++i) {
    require_place(list, own.size, items[i]);
    write_item(list, own, i, items[i]);
  }
  return own;
}

// Points `def` at the library's list, of which `count` items are in use.
template <class List>
void show_list(List /*list*/, OwnedList& own, hfrac_sim_def& def) {
  using Item = typename List::Item;
  List::items(def) = own.words.empty() ? nullptr : reinterpret_cast<Item*>(own.words.data());
  List::count(def) = own.count();
  List::size(def) = own.size;
}

// Makes `items` the library's own list of `def`. If that throws, nothing has changed.
template <class List>
void put_items(List list, const std::vector<typename List::Values>& items, hfrac_sim_def& def) {
  OwnedList own = owned(list, items, def);
  if (def.lists == nullptr) def.lists = std::make_unique<OwnedLists>().release();
  auto& place = List::in(*static_cast<OwnedLists*>(def.lists));
  place = std::move(own);
  show_list(list, place, def);
}

}  // namespace hfrac::capi
