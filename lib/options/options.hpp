// SPDX-License-Identifier: BSD-3-Clause
// What a simulation is made of: the options, the wells, a title.
//
// Members and their description come from the same lines (option_list.inc, well_list.inc), so a value cannot
// exist without a unit, a range and a sentence of help. Everything that reads or writes options by name goes
// through the tables option_table() and well_option_table().
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac {

enum class ValueType : std::int32_t { real = 0, integer = 1, choice = 2 };

// What a table says of one value. All texts are literals: 0-terminated, living as long as the library.
struct ValueInfo {
  const char* key;  // "section.name"; of a well: "name"
  const char* unit;
  ValueType type;
  const char* choices;  // words split by '|', nullptr unless a choice
  double initial;       // default; of a choice its index
  double min;
  double max;
  const char* help;
};

// Words of a choice. In a constant expression an unknown word does not compile.
constexpr std::int64_t choice_count(std::string_view words) {
  std::int64_t count = 1;
  for (const char c : words) count += c == '|';
  return count;
}
constexpr std::string_view choice_word(std::string_view words, std::int64_t index) {
  for (; index > 0; --index) words.remove_prefix(words.find('|') + 1);
  return words.substr(0, words.find('|'));
}
// Index of a word, -1 if it is none of them.
constexpr std::int64_t choice_index(std::string_view words, std::string_view word) {
  const std::int64_t count = choice_count(words);
  for (std::int64_t i = 0; i < count; ++i) {
    if (choice_word(words, i) == word) return i;
  }
  return -1;
}

// The options as plain members: section_name.
struct Options {
#define F64(section, name, unit, initial, min, max, help) double section##_##name = initial;
#define I64(section, name, initial, min, max, help) std::int64_t section##_##name = initial;
#define CHOICE(section, name, initial, words, help) \
  std::int64_t section##_##name = choice_index(words, initial);
#include "options/option_list.inc"
#undef F64
#undef I64
#undef CHOICE
};

enum class WellControl : std::int64_t { pressure = 0, ramp = 1, rate = 2 };
enum class WellFluid : std::int64_t { first = 0, second = 1 };
enum class ScheduleFluid : std::int64_t { same = 0, first = 1, second = 2 };

struct WellOptions {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  double pressure = 0.0;
  double ramp_per_step = 0.0;
  double rate = 0.0;
  WellControl control = WellControl::pressure;
  // Of the wellbore and what lies between it and the hole (model/wellbore.hpp); 0 is what well_list.inc says
  double storage = 0.0;                                        // m2/Pa
  double perforation_count = 0.0, perforation_diameter = 0.0;  // 1, m
  double discharge_coefficient = 0.0;                          // 1
  double near_well_friction = 0.0;                             // Pa/(m3/s)^0.5
  double height = 0.0, depth = 0.0;                            // m
  double fluid_density = 0.0;                                  // kg/m3
  std::int64_t wellbore = 0;                                   // 0: one of its own
  std::int64_t fluid = 0;                                      // WellFluid
  double perforation_length = 0.0, perforation_azimuth = 0.0;  // m, rad; a length of 0: as options say of all
  double fluid_area = 0.0;                                     // m2; 0: the void between the discs
};

// A line along which the rock is weaker or broken (solid/joints.hpp).
enum class JointState : std::int64_t { bonded = 0, broken = 1, smooth_bonded = 2, smooth_broken = 3 };
constexpr bool is_broken(JointState state) {
  return state == JointState::broken || state == JointState::smooth_broken;
}
constexpr bool is_smooth(JointState state) {
  return state == JointState::smooth_bonded || state == JointState::smooth_broken;
}
struct JointOptions {
  double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;    // m
  double tensile_factor = 1.0, shear_factor = 1.0;  // of the rock's strengths
  double friction = -1.0;                           // negative: contact.friction
  std::int64_t state = 0;                           // JointState
  // Of smooth joints (model/joint_law.hpp); 0 is what joint_list.inc says
  double normal_stiffness = 0.0, shear_stiffness = 0.0;  // Pa/m
  double max_closure = 0.0;                              // m
  double tensile_strength = 0.0, cohesion = 0.0;         // Pa
  double residual_friction = 0.0, weakening_slip = 0.0;  // 1, m
  double dilation_angle = 0.0, dilation_slip = 0.0;      // rad, m
  double aperture = 0.0, residual_aperture = 0.0;        // m
  double roughness = 0.0;                                // 1
  double storage = 0.0;                                  // m/Pa
};

// From `time` on, a well is driven otherwise.
struct ScheduleEntry {
  std::int64_t well = 0;
  double time = 0.0;         // s
  double value = 0.0;        // Pa or m2/s
  std::int64_t control = 0;  // WellControl, pressure or rate
  std::int64_t fluid = 0;    // ScheduleFluid

  bool operator==(const ScheduleEntry&) const = default;
};

struct CaseDefinition {
  Options options;
  std::vector<WellOptions> wells;
  std::string title;
  std::vector<JointOptions> joints;
  std::vector<ScheduleEntry> schedule;
  std::string
      packing_file;  // of a model that was packed before (step/packed_model.hpp); empty: the model is packed
};

struct OptionInfo : ValueInfo {
  double Options::*real;           // of type real
  std::int64_t Options::*integer;  // of type integer or choice
};
struct WellOptionInfo : ValueInfo {
  double WellOptions::*real;
  std::int64_t WellOptions::*integer;  // neither of both: the control
};
// Of an item of a list: one of the two members is set.
template <class Item>
struct ItemInfo : ValueInfo {
  double Item::*real;
  std::int64_t Item::*integer;
};
using JointInfo = ItemInfo<JointOptions>;
using ScheduleInfo = ItemInfo<ScheduleEntry>;

std::span<const OptionInfo> option_table() noexcept;
std::span<const WellOptionInfo> well_option_table() noexcept;
std::span<const JointInfo> joint_table() noexcept;
std::span<const ScheduleInfo> schedule_table() noexcept;

// Entry of a key, nullptr if there is none.
const OptionInfo* find_option(std::string_view key) noexcept;
const WellOptionInfo* find_well_option(std::string_view name) noexcept;
const JointInfo* find_joint_value(std::string_view name) noexcept;
const ScheduleInfo* find_schedule_value(std::string_view name) noexcept;

// "old is now called new.", for a name of renamed_list.inc; empty for any other.
std::string renamed_text(std::string_view old_name);

// "section.name is not a known key; did you mean section.other?", or renamed_text.
std::string unknown_key_text(std::string_view key);

// As a double; integers and choices converted.
double get_value(const Options& values, const OptionInfo& info) noexcept;
double get_value(const WellOptions& values, const WellOptionInfo& info) noexcept;
template <class Item>
double get_value(const Item& values, const ItemInfo<Item>& info) noexcept {
  return info.real != nullptr ? values.*info.real : static_cast<double>(values.*info.integer);
}

// Sets one value, after a check of type and range. `key` is the name shown in errors. All throw
// Error(ErrorKind::argument) and change nothing then. An integer may be given for a real, not the reverse.
void set_real(Options& values, const OptionInfo& info, std::string_view key, double value);
void set_integer(Options& values, const OptionInfo& info, std::string_view key, std::int64_t value);
void set_word(Options& values, const OptionInfo& info, std::string_view key, std::string_view word);
void set_real(WellOptions& values, const WellOptionInfo& info, std::string_view key, double value);
void set_integer(WellOptions& values, const WellOptionInfo& info, std::string_view key, std::int64_t value);
void set_word(WellOptions& values, const WellOptionInfo& info, std::string_view key, std::string_view word);
// For JointOptions and ScheduleEntry.
template <class Item>
void set_real(Item& values, const ItemInfo<Item>& info, std::string_view key, double value);
template <class Item>
void set_integer(Item& values, const ItemInfo<Item>& info, std::string_view key, std::int64_t value);
template <class Item>
void set_word(Item& values, const ItemInfo<Item>& info, std::string_view key, std::string_view word);

// Every value by itself: finite and in range. Throws Error(argument).
void check_ranges(const CaseDefinition& definition);

// check_ranges, then what cannot be built though each value is fine: contradictory stresses, wells outside
// the model or overlapping, holes smaller than the discs around them. Throws Error(model) with the fix.
// `given_discs` are the host's own discs (x, y, radius each) instead of a packing, `given_bonds` which of them are bonded.
void validate(const CaseDefinition& definition, std::span<const double> given_discs = {},
              std::span<const std::int64_t> given_bonds = {});

// Refuses, as Error(model) or Error(argument), what a well cannot be driven by.
void check_schedule_entry(const std::string& name, const ScheduleEntry& entry, const Options& options);

// Mean radius of a packing made from these options.
double expected_mean_radius(const Options& options) noexcept;

}  // namespace hfrac
