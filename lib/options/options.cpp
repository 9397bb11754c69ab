// SPDX-License-Identifier: BSD-3-Clause
#include "options/options.hpp"

#include <cmath>

#include "core/error.hpp"
#include "options/choices.hpp"
#include "options/nearest.hpp"
#include "options/number_text.hpp"

namespace hfrac {
namespace {

#define F64(section, name, unit, initial, min, max, help)                                   \
  OptionInfo{{#section "." #name, unit, ValueType::real, nullptr, initial, min, max, help}, \
             &Options::section##_##name,                                                    \
             nullptr},
#define I64(section, name, initial, min, max, help)                                           \
  OptionInfo{{#section "." #name, "1", ValueType::integer, nullptr, initial, min, max, help}, \
             nullptr,                                                                         \
             &Options::section##_##name},
#define CHOICE(section, name, initial, words, help)                                                          \
  OptionInfo{                                                                                                \
      {#section "." #name, "1", ValueType::choice, words, static_cast<double>(choice_index(words, initial)), \
       0.0, static_cast<double>(choice_count(words) - 1), help},                                             \
      nullptr,                                                                                               \
      &Options::section##_##name},
constexpr OptionInfo option_rows[] = {
#include "options/option_list.inc"
};
#undef F64
#undef CHOICE
#undef I64

#define F64(name, unit, initial, min, max, help) \
  WellOptionInfo{                                \
      {#name, unit, ValueType::real, nullptr, initial, min, max, help}, &WellOptions::name, nullptr},
#define I64(name, initial, min, max, help) \
  WellOptionInfo{                          \
      {#name, "1", ValueType::integer, nullptr, initial, min, max, help}, nullptr, &WellOptions::name},
// The control has a type of its own.
constexpr std::int64_t WellOptions::*index_member(std::int64_t WellOptions::*member) {
  return member;
}
constexpr std::int64_t WellOptions::*index_member(WellControl WellOptions::* /*control*/) {
  return nullptr;
}
#define CHOICE(name, initial, words, help)                                                                 \
  WellOptionInfo{{#name, "1", ValueType::choice, words, static_cast<double>(choice_index(words, initial)), \
                  0.0, static_cast<double>(choice_count(words) - 1), help},                                \
                 nullptr,                                                                                  \
                 index_member(&WellOptions::name)},
constexpr WellOptionInfo well_rows[] = {
#include "options/well_list.inc"
};
#undef F64
#undef I64
#undef CHOICE

#define HFRAC_ITEM_F64(Item, name, unit, initial, min, max, help) \
  ItemInfo<Item>{{#name, unit, ValueType::real, nullptr, initial, min, max, help}, &Item::name, nullptr},
#define HFRAC_ITEM_CHOICE(Item, name, initial, words, help)                                                \
  ItemInfo<Item>{{#name, "1", ValueType::choice, words, static_cast<double>(choice_index(words, initial)), \
                  0.0, static_cast<double>(choice_count(words) - 1), help},                                \
                 nullptr,                                                                                  \
                 &Item::name},
#define F64(...) HFRAC_ITEM_F64(JointOptions, __VA_ARGS__)
#define CHOICE(...) HFRAC_ITEM_CHOICE(JointOptions, __VA_ARGS__)
constexpr JointInfo joint_rows[] = {
#include "options/joint_list.inc"
};
#undef F64
#undef CHOICE
#define F64(...) HFRAC_ITEM_F64(ScheduleEntry, __VA_ARGS__)
#define I64(name, initial, min, max, help) \
  ScheduleInfo{                            \
      {#name, "1", ValueType::integer, nullptr, initial, min, max, help}, nullptr, &ScheduleEntry::name},
#define CHOICE(...) HFRAC_ITEM_CHOICE(ScheduleEntry, __VA_ARGS__)
constexpr ScheduleInfo schedule_rows[] = {
#include "options/schedule_list.inc"
};
#undef F64
#undef I64
#undef CHOICE
#undef HFRAC_ITEM_F64
#undef HFRAC_ITEM_CHOICE

// Mistakes in the tables themselves do not compile.
constexpr bool sound(const ValueInfo& info) {
  return info.min <= info.max && (info.initial == 0.0 || info.initial >= info.min) &&
         info.initial <= info.max;
}
constexpr bool tables_sound() {
  for (const auto& info : option_rows) {
    if (!sound(info) || info.initial < info.min) return false;
  }
  for (const auto& info : well_rows) {
    if (!sound(info)) return false;
  }
  for (const auto& info : joint_rows) {
    if (!sound(info)) return false;
  }
  for (const auto& info : schedule_rows) {
    if (!sound(info)) return false;
  }
  return true;
}
static_assert(tables_sound(), "a default lies outside its range, or a range is empty");

constexpr std::string_view words_of(std::string_view key) {
  for (const auto& info : option_rows) {
    if (info.key == key) return info.choices;
  }
  return {};
}
constexpr bool is_word(std::string_view key, std::string_view word, auto index) {
  return choice_index(words_of(key), word) == static_cast<std::int64_t>(index);
}
static_assert(is_word("stress.convention", "total", StressConvention::total) &&
              is_word("stress.convention", "effective", StressConvention::effective));
static_assert(is_word("run.device", "cpu", RunDevice::cpu) && is_word("run.device", "gpu", RunDevice::gpu) &&
              is_word("run.device", "auto", RunDevice::automatic));
static_assert(is_word("fluid.kind", "given", FluidKind::given) &&
              is_word("fluid.kind", "water", FluidKind::water));
static_assert(is_word("packing.method", "relaxed", PackingMethod::relaxed) &&
              is_word("packing.method", "tiled", PackingMethod::tiled) &&
              is_word("packing.method", "growth", PackingMethod::growth) &&
              is_word("packing.method", "square", PackingMethod::square));
static_assert(is_word("packing.reuse", "model", PackingReuse::model) &&
              is_word("packing.reuse", "discs", PackingReuse::discs));
static_assert(is_word("flow.solver", "auto", FlowMatrixSolver::automatic) &&
              is_word("flow.solver", "direct", FlowMatrixSolver::direct) &&
              is_word("flow.solver", "iterative", FlowMatrixSolver::iterative) &&
              is_word("flow.solver", "petsc", FlowMatrixSolver::petsc));
static_assert(is_word("contact.shape", "round", ContactShape::round) &&
              is_word("contact.shape", "flat", ContactShape::flat));
static_assert(is_word("contact.mode", "parallel", ContactMode::parallel) &&
              is_word("contact.mode", "after-break", ContactMode::after_break));
static_assert(is_word("boundary.kind", "stress", BoundaryKind::stress) &&
              is_word("boundary.kind", "walls", BoundaryKind::walls) &&
              is_word("boundary.kind", "infinite", BoundaryKind::infinite));
static_assert(is_word("boundary.walls_after_equilibration", "fixed", WallsAfterEquilibration::fixed) &&
              is_word("boundary.walls_after_equilibration", "servo", WallsAfterEquilibration::servo));
static_assert(is_word("flow.scheme", "implicit", FlowScheme::implicit_scheme) &&
              is_word("flow.scheme", "explicit", FlowScheme::explicit_scheme) &&
              is_word("flow.scheme", "off", FlowScheme::off));
static_assert(is_word("flow.fracture_aperture", "bond", FractureAperture::bond) &&
              is_word("flow.fracture_aperture", "plane", FractureAperture::plane));
static_assert(is_word("flow.outer", "formation", OuterPores::formation) &&
              is_word("flow.outer", "closed", OuterPores::closed));
static_assert(is_word("stepping.mode", "substep", SteppingMode::substep) &&
              is_word("stepping.mode", "dynamic", SteppingMode::dynamic) &&
              is_word("stepping.mode", "coupled", SteppingMode::coupled));
static_assert(is_word("initial.state", "uniform", InitialState::uniform) &&
              is_word("initial.state", "seepage", InitialState::seepage));
static_assert(is_word("solver.kind", "explicit", SolverKind::explicit_solver) &&
              is_word("solver.kind", "quasi-static", SolverKind::quasi_static));
static_assert(is_word("solver.factor", "own", FactorOf::own) &&
              is_word("solver.factor", "petsc", FactorOf::petsc));
static_assert(is_word("thermal.mode", "uniform", ThermalMode::uniform) &&
              is_word("thermal.mode", "transport", ThermalMode::transport) &&
              is_word("thermal.outer", "held", ThermalOuter::held) &&
              is_word("thermal.parameters", "table", ThermalParameters::table));
static_assert(choice_index(well_rows[6].choices, "ramp") == static_cast<std::int64_t>(WellControl::ramp) &&
              choice_index(well_rows[6].choices, "rate") == static_cast<std::int64_t>(WellControl::rate));

static_assert(
    choice_index(joint_rows[7].choices, "broken") == static_cast<std::int64_t>(JointState::broken) &&
    choice_index(joint_rows[7].choices, "smooth-bonded") ==
        static_cast<std::int64_t>(JointState::smooth_bonded) &&
    choice_index(joint_rows[7].choices, "smooth-broken") ==
        static_cast<std::int64_t>(JointState::smooth_broken) &&
    choice_index(schedule_rows[3].choices, "rate") == static_cast<std::int64_t>(WellControl::rate) &&
    choice_index(schedule_rows[4].choices, "second") == static_cast<std::int64_t>(ScheduleFluid::second));

template <class Table>
auto find_in(const Table& table, std::string_view key) noexcept -> decltype(&table[0]) {
  for (const auto& info : table) {
    if (info.key == key) return &info;
  }
  return nullptr;
}

std::string with_unit(const std::string& number, const ValueInfo& info) {
  return std::string_view(info.unit) == "1" ? number : number + " " + info.unit;
}

std::string list_of_words(const ValueInfo& info, bool with_index) {
  std::string list;
  const std::int64_t count = choice_count(info.choices);
  for (std::int64_t i = 0; i < count; ++i) {
    if (i > 0) list += i + 1 < count ? ", " : " or ";
    if (with_index) list += number_text(i) + " (";
    list += choice_word(info.choices, i);
    if (with_index) list += ")";
  }
  return list;
}

// Bounds are whole numbers for integers, and written as such: 9007199254740991, not 9.007199254740991e15.
std::string bound_text(const ValueInfo& info, double bound) {
  return info.type == ValueType::integer ? number_text(static_cast<std::int64_t>(bound)) : number_text(bound);
}

[[noreturn]] void refuse(std::string_view key, const std::string& fault) {
  throw Error(ErrorKind::argument, std::string(key) + fault);
}

void check_value(const ValueInfo& info, std::string_view key, double value, const std::string& shown) {
  if (info.type == ValueType::choice) {
    if (value >= info.min && value <= info.max) return;
    refuse(key, " = " + shown + " is not one of " + list_of_words(info, true) + ".");
  }
  const std::string range =
      bound_text(info, info.min) + " to " + with_unit(bound_text(info, info.max), info) + ".";
  if (!std::isfinite(value)) refuse(key, " = " + shown + " is not a finite number; allowed is " + range);
  if (value < info.min || value > info.max) refuse(key, " = " + shown + " is outside " + range);
}

std::int64_t word_index(const ValueInfo& info, std::string_view key, std::string_view word) {
  if (info.type != ValueType::choice) {
    refuse(key, std::string(" is ") + (info.type == ValueType::real ? "a number" : "an integer") +
                    ", not a text.");
  }
  const std::int64_t index = choice_index(info.choices, word);
  if (index < 0) {
    refuse(key, " = \"" + std::string(word) + "\" is not one of " + list_of_words(info, false) + ".");
  }
  return index;
}

void check_real(const ValueInfo& info, std::string_view key, double value) {
  if (info.type == ValueType::integer)
    refuse(key, " is an integer; " + number_text(value) + " was given as a real.");
  if (info.type == ValueType::choice)
    refuse(key, " is one of " + list_of_words(info, false) + ", not a real number.");
  check_value(info, key, value, number_text(value));
}

void check_integer(const ValueInfo& info, std::string_view key, std::int64_t value) {
  check_value(info, key, static_cast<double>(value), number_text(value));
}

}  // namespace

std::span<const OptionInfo> option_table() noexcept {
  return option_rows;
}
std::span<const WellOptionInfo> well_option_table() noexcept {
  return well_rows;
}
std::span<const JointInfo> joint_table() noexcept {
  return joint_rows;
}
std::span<const ScheduleInfo> schedule_table() noexcept {
  return schedule_rows;
}
const JointInfo* find_joint_value(std::string_view name) noexcept {
  return find_in(joint_rows, name);
}
const ScheduleInfo* find_schedule_value(std::string_view name) noexcept {
  return find_in(schedule_rows, name);
}
const OptionInfo* find_option(std::string_view key) noexcept {
  return find_in(option_rows, key);
}
const WellOptionInfo* find_well_option(std::string_view name) noexcept {
  return find_in(well_rows, name);
}

std::string renamed_text(std::string_view old_name) {
  struct Renamed {
    std::string_view before, now, besides;
  };
  static constexpr Renamed all[] = {
#define RENAMED(before, now, besides) {before, now, besides},
#include "options/renamed_list.inc"
#undef RENAMED
  };
  for (const auto& one : all) {
    if (one.before != old_name) continue;
    std::string text = std::string(old_name) + " is now called " + std::string(one.now);
    if (!one.besides.empty()) text += ", and " + std::string(one.besides);
    return text + ".";
  }
  return {};
}

std::string unknown_key_text(std::string_view key) {
  if (std::string renamed = renamed_text(key); !renamed.empty()) return renamed;
  std::vector<std::string_view> keys;
  for (const auto& info : option_rows) keys.emplace_back(info.key);
  const std::string_view nearest = nearest_name(key, keys);
  constexpr std::size_t shown = 80;
  std::string text(key.substr(0, shown));
  if (key.size() > shown) text += "...";
  text += " is not a known key";
  return nearest.empty() ? text + "." : text + "; did you mean " + std::string(nearest) + "?";
}

double get_value(const Options& values, const OptionInfo& info) noexcept {
  return info.real != nullptr ? values.*info.real : static_cast<double>(values.*info.integer);
}

double get_value(const WellOptions& values, const WellOptionInfo& info) noexcept {
  if (info.real != nullptr) return values.*info.real;
  return static_cast<double>(info.integer != nullptr ? values.*info.integer
                                                     : static_cast<std::int64_t>(values.control));
}

void set_real(Options& values, const OptionInfo& info, std::string_view key, double value) {
  check_real(info, key, value);
  values.*info.real = value;
}

void set_integer(Options& values, const OptionInfo& info, std::string_view key, std::int64_t value) {
  check_integer(info, key, value);
  if (info.real != nullptr) {
    values.*info.real = static_cast<double>(value);
  } else {
    values.*info.integer = value;
  }
}

void set_word(Options& values, const OptionInfo& info, std::string_view key, std::string_view word) {
  values.*info.integer = word_index(info, key, word);
}

void set_real(WellOptions& values, const WellOptionInfo& info, std::string_view key, double value) {
  check_real(info, key, value);
  values.*info.real = value;
}

void set_integer(WellOptions& values, const WellOptionInfo& info, std::string_view key, std::int64_t value) {
  check_integer(info, key, value);
  if (info.real != nullptr) {
    values.*info.real = static_cast<double>(value);
  } else if (info.integer != nullptr) {
    values.*info.integer = value;
  } else {
    values.control = WellControl{value};
  }
}

void set_word(WellOptions& values, const WellOptionInfo& info, std::string_view key, std::string_view word) {
  set_integer(values, info, key, word_index(info, key, word));
}

template <class Item>
void set_real(Item& values, const ItemInfo<Item>& info, std::string_view key, double value) {
  check_real(info, key, value);
  values.*info.real = value;
}

template <class Item>
void set_integer(Item& values, const ItemInfo<Item>& info, std::string_view key, std::int64_t value) {
  check_integer(info, key, value);
  if (info.real != nullptr) {
    values.*info.real = static_cast<double>(value);
  } else {
    values.*info.integer = value;
  }
}

template <class Item>
void set_word(Item& values, const ItemInfo<Item>& info, std::string_view key, std::string_view word) {
  values.*info.integer = word_index(info, key, word);
}

template void set_real(JointOptions&, const JointInfo&, std::string_view, double);
template void set_integer(JointOptions&, const JointInfo&, std::string_view, std::int64_t);
template void set_word(JointOptions&, const JointInfo&, std::string_view, std::string_view);
template void set_real(ScheduleEntry&, const ScheduleInfo&, std::string_view, double);
template void set_integer(ScheduleEntry&, const ScheduleInfo&, std::string_view, std::int64_t);
template void set_word(ScheduleEntry&, const ScheduleInfo&, std::string_view, std::string_view);

namespace {

template <class Item>
void check_items(const std::vector<Item>& items, std::span<const ItemInfo<Item>> table, const char* name) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const auto& info : table) {
      const double value = get_value(items[i], info);
      check_value(info, std::string(name) + "[" + std::to_string(i) + "]." + info.key, value,
                  info.real != nullptr ? number_text(value) : number_text(static_cast<std::int64_t>(value)));
    }
  }
}

}  // namespace

void check_ranges(const CaseDefinition& definition) {
  for (const auto& info : option_rows) {
    if (info.real != nullptr) {
      check_real(info, info.key, definition.options.*info.real);
    } else {
      check_integer(info, info.key, definition.options.*info.integer);
    }
  }
  for (std::size_t i = 0; i < definition.wells.size(); ++i) {
    for (const auto& info : well_rows) {
      const std::string key = "well[" + std::to_string(i) + "]." + info.key;
      const double value = get_value(definition.wells[i], info);
      check_value(info, key, value,
                  info.real != nullptr ? number_text(value) : number_text(static_cast<std::int64_t>(value)));
    }
  }
  check_items(definition.joints, joint_table(), "joint");
  check_items(definition.schedule, schedule_table(), "schedule");
}

}  // namespace hfrac
