// SPDX-License-Identifier: BSD-3-Clause
#include "def_image.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "internal.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::int32_t def_version = 1;

// Every line of the tables is a member of the C structs, of the right type.
#define F64(section, name, unit, initial, min, max, help) \
  static_assert(std::is_same_v<decltype(hfrac_sim_def::section##_##name), double>);
#define I64(section, name, initial, min, max, help) \
  static_assert(std::is_same_v<decltype(hfrac_sim_def::section##_##name), std::int64_t>);
#define CHOICE(section, name, initial, words, help) I64(section, name, initial, 0, 0, help)
#include "options/option_list.inc"
#undef F64
#undef I64
#undef CHOICE

#define F64(name, unit, initial, min, max, help) \
  static_assert(std::is_same_v<decltype(hfrac_well_def::name), double>);
#define CHOICE(name, initial, words, help) \
  static_assert(std::is_same_v<decltype(hfrac_well_def::name), std::int64_t>);
#include "options/well_list.inc"
#undef F64
#undef CHOICE

#define F64(name, unit, initial, min, max, help) \
  static_assert(std::is_same_v<decltype(hfrac_joint_def::name), double>);
#define CHOICE(name, initial, words, help) \
  static_assert(std::is_same_v<decltype(hfrac_joint_def::name), std::int64_t>);
#include "options/joint_list.inc"
#undef F64
#undef CHOICE
static_assert(static_cast<int>(JointState::bonded) == HFRAC_JOINT_BONDED &&
              static_cast<int>(JointState::broken) == HFRAC_JOINT_BROKEN &&
              static_cast<int>(JointState::smooth_bonded) == HFRAC_JOINT_SMOOTH_BONDED &&
              static_cast<int>(JointState::smooth_broken) == HFRAC_JOINT_SMOOTH_BROKEN);

static_assert(static_cast<int>(WellControl::pressure) == HFRAC_WELL_PRESSURE &&
              static_cast<int>(WellControl::ramp) == HFRAC_WELL_RAMP &&
              static_cast<int>(WellControl::rate) == HFRAC_WELL_RATE);

}  // namespace

hfrac_sim_def default_def() {
  hfrac_sim_def def{};
  def.struct_size = sizeof def;
  def.struct_version = def_version;
  def.log_level = HFRAC_LOG_INFO;
  put_options(Options{}, def);
  return def;
}

hfrac_sim_def read_def(const hfrac_sim_def* def) {
  const hfrac_sim_def full = read_struct(def, default_def(), "def");
  if (full.struct_version < 1) {
    throw Error(ErrorKind::struct_size,
                "def.struct_version = " + std::to_string(full.struct_version) +
                    " was never given out; fill the struct with hfrac_sim_def_init first.");
  }
  return full;
}

Options options_of(const hfrac_sim_def& def) {
  Options options;
#define F64(section, name, unit, initial, min, max, help) options.section##_##name = def.section##_##name;
#define I64(section, name, initial, min, max, help) options.section##_##name = def.section##_##name;
#define CHOICE(section, name, initial, words, help) options.section##_##name = def.section##_##name;
#include "options/option_list.inc"
#undef F64
#undef I64
#undef CHOICE
  return options;
}

void put_options(const Options& options, hfrac_sim_def& def) {
#define F64(section, name, unit, initial, min, max, help) def.section##_##name = options.section##_##name;
#define I64(section, name, initial, min, max, help) def.section##_##name = options.section##_##name;
#define CHOICE(section, name, initial, words, help) def.section##_##name = options.section##_##name;
#include "options/option_list.inc"
#undef F64
#undef I64
#undef CHOICE
}

WellOptions well_of(const hfrac_well_def& well) {
  return {
      well.x, well.y, well.radius, well.pressure, well.ramp_per_step, well.rate, WellControl{well.control}};
}

void put_well(const WellOptions& from, hfrac_well_def& well) {
  well = {from.x,
          from.y,
          from.radius,
          from.pressure,
          from.ramp_per_step,
          from.rate,
          static_cast<std::int64_t>(from.control)};
}

JointOptions joint_of(const hfrac_joint_def& j) {
  return {j.x1, j.y1, j.x2, j.y2, j.tensile_factor, j.shear_factor, j.friction, j.state};
}
void put_joint(const JointOptions& j, hfrac_joint_def& joint) {
  joint = {j.x1, j.y1, j.x2, j.y2, j.tensile_factor, j.shear_factor, j.friction, j.state};
}
ScheduleEntry entry_of(const hfrac_schedule_def& e) {
  return {e.well, e.time, e.value, e.control};
}
void put_entry(const ScheduleEntry& e, hfrac_schedule_def& entry) {
  entry = {e.well, e.time, e.value, e.control};
}

namespace {

void require_count(const char* name, std::int64_t count, int most) {
  if (count >= 0 && count <= most) return;
  throw Error(ErrorKind::argument, std::string(name) + " = " + std::to_string(count) + " is outside 0 to " +
                                       std::to_string(most) + ".");
}

}  // namespace

CaseDefinition case_of(const hfrac_sim_def& def) {
  require_count("well_count", def.well_count, HFRAC_MAX_WELLS);
  require_count("joint_count", def.joint_count, HFRAC_MAX_JOINTS);
  require_count("schedule_count", def.schedule_count, HFRAC_MAX_SCHEDULE);
  const char* end = std::find(std::begin(def.title), std::end(def.title), '\0');
  if (end == std::end(def.title)) {
    throw Error(ErrorKind::argument,
                "title has no final 0 within its " + std::to_string(sizeof def.title) + " bytes.");
  }
  CaseDefinition definition{options_of(def), {}, std::string(std::begin(def.title), end), {}, {}};
  if (!is_utf8(definition.title)) throw Error(ErrorKind::argument, "title is not valid UTF-8.");
  for (std::int64_t i = 0; i < def.well_count; ++i) definition.wells.push_back(well_of(def.wells[i]));
  for (std::int64_t i = 0; i < def.joint_count; ++i) definition.joints.push_back(joint_of(def.joints[i]));
  for (std::int64_t i = 0; i < def.schedule_count; ++i)
    definition.schedule.push_back(entry_of(def.schedule[i]));
  return definition;
}

std::span<const double> given_discs_of(const hfrac_sim_def& def) {
  constexpr std::int64_t most_discs = 100'000'000;
  if (def.given_disc_count < 0 || def.given_disc_count > most_discs) {
    throw Error(ErrorKind::argument, "given_disc_count = " + std::to_string(def.given_disc_count) +
                                         " is outside 0 to " + std::to_string(most_discs) + ".");
  }
  if ((def.given_discs == nullptr) != (def.given_disc_count == 0)) {
    throw Error(ErrorKind::argument,
                "given_discs and given_disc_count disagree: one is set, the other is not.");
  }
  return {def.given_discs, static_cast<std::size_t>(3 * def.given_disc_count)};
}

std::span<const std::int64_t> given_bonds_of(const hfrac_sim_def& def) {
  if ((def.given_bonds == nullptr) != (def.given_bond_count == 0)) {
    throw Error(ErrorKind::argument,
                "given_bonds and given_bond_count disagree: one is set, the other is not.");
  }
  // Contacts of discs in a plane are a planar graph: 3 n - 6 of them at most (Euler).
  const std::int64_t most = 3 * static_cast<std::int64_t>(given_discs_of(def).size() / 3);
  if (def.given_bond_count < 0 || def.given_bond_count > most) {
    throw Error(ErrorKind::argument, "given_bond_count = " + std::to_string(def.given_bond_count) +
                                         " is outside 0 to " + std::to_string(most) +
                                         ", three per disc of given_discs.");
  }
  return {def.given_bonds, static_cast<std::size_t>(2 * def.given_bond_count)};
}

void put_case(const CaseDefinition& definition, hfrac_sim_def& def) {
  if (definition.wells.size() > HFRAC_MAX_WELLS) {
    throw Error(ErrorKind::argument,
                std::to_string(definition.wells.size()) + " wells are too many; at most " +
                    std::to_string(static_cast<int>(HFRAC_MAX_WELLS)) + " can be defined.");
  }
  require_count("joint_count", static_cast<std::int64_t>(definition.joints.size()), HFRAC_MAX_JOINTS);
  require_count("schedule_count", static_cast<std::int64_t>(definition.schedule.size()), HFRAC_MAX_SCHEDULE);
  put_title(definition.title, def);
  put_options(definition.options, def);
  def.well_count = static_cast<std::int64_t>(definition.wells.size());
  for (std::size_t i = 0; i < definition.wells.size(); ++i) put_well(definition.wells[i], def.wells[i]);
  def.joint_count = static_cast<std::int64_t>(definition.joints.size());
  for (std::size_t i = 0; i < definition.joints.size(); ++i) put_joint(definition.joints[i], def.joints[i]);
  def.schedule_count = static_cast<std::int64_t>(definition.schedule.size());
  for (std::size_t i = 0; i < definition.schedule.size(); ++i)
    put_entry(definition.schedule[i], def.schedule[i]);
}

void put_title(std::string_view title, hfrac_sim_def& def) {
  if (title.size() >= sizeof def.title) {
    throw Error(ErrorKind::argument, "title has " + std::to_string(title.size()) + " bytes; at most " +
                                         std::to_string(sizeof def.title - 1) + " fit.");
  }
  if (title.find('\0') != std::string_view::npos || !is_utf8(title)) {
    throw Error(ErrorKind::argument, "title is not valid UTF-8, or holds a character 0.");
  }
  std::memset(def.title, 0, sizeof def.title);
  std::copy(title.begin(), title.end(), def.title);
}

}  // namespace hfrac::capi
