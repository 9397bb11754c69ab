// SPDX-License-Identifier: BSD-3-Clause
#include "def_image.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

#include "def_lists.hpp"
#include "internal.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

constexpr std::int32_t def_version = 2;

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
#define I64(name, initial, min, max, help) \
  static_assert(std::is_same_v<decltype(hfrac_well_def::name), std::int64_t>);
#define CHOICE(name, initial, words, help) I64(name, initial, 0, 0, help)
#include "options/well_list.inc"
#undef F64
#undef I64
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

// Texts that the struct holds itself.
template <std::size_t size>
std::string text_of(const char (&member)[size], const std::string& name) {
  const char* end = std::find(std::begin(member), std::end(member), '\0');
  if (end == std::end(member)) {
    throw Error(ErrorKind::argument, name + " has no final 0 within its " + std::to_string(size) + " bytes.");
  }
  std::string text(std::begin(member), end);
  if (!is_utf8(text)) throw Error(ErrorKind::argument, name + " is not valid UTF-8.");
  return text;
}

template <std::size_t size>
void put_text(std::string_view text, char (&member)[size], const std::string& name) {
  if (text.size() >= size) {
    throw Error(ErrorKind::argument, name + " has " + std::to_string(text.size()) + " bytes; at most " +
                                         std::to_string(size - 1) + " fit.");
  }
  if (text.find('\0') != std::string_view::npos || !is_utf8(text))
    throw Error(ErrorKind::argument, name + " is not valid UTF-8, or holds a character 0.");
  std::memset(member, 0, size);
  std::copy(text.begin(), text.end(), member);
}

}  // namespace

hfrac_sim_def default_def() {
  hfrac_sim_def def{};
  def.struct_size = sizeof def;
  def.struct_version = def_version;
  def.log_level = HFRAC_LOG_INFO;
  put_options(Options{}, def);
  return def;
}

void require_def_size(std::int32_t size) {
  constexpr auto least = static_cast<std::int32_t>(offsetof(hfrac_sim_def, model_width));
  if (size >= least) return;
  throw Error(ErrorKind::struct_size, "def.struct_size = " + std::to_string(size) +
                                          " is smaller than any hfrac_sim_def, at least " +
                                          std::to_string(least) + " bytes; give sizeof(hfrac_sim_def).");
}

hfrac_sim_def read_def(const hfrac_sim_def* def) {
  const hfrac_sim_def full = read_struct(def, default_def(), "def");
  require_def_size(def->struct_size);
  if (full.struct_version < def_version) {
    throw Error(
        ErrorKind::struct_size,
        "def.struct_version = " + std::to_string(full.struct_version) +
            (full.struct_version < 1 ? " was never given out" : " is of a library whose lists were arrays") +
            "; fill the struct with hfrac_sim_def_init first.");
  }
  return full;
}

void write_def(hfrac_sim_def* to, const hfrac_sim_def& full, const char* name) {
  const hfrac_sim_def usual = default_def();
  const auto size = static_cast<std::size_t>(std::max(0, to->struct_size));
  const auto keep = [&](const char* key, std::size_t place, bool changed) {
    if (!changed || place < size) return;
    throw Error(ErrorKind::struct_size,
                std::string(key) + " has no place in the hfrac_sim_def of this program, " +
                    std::to_string(size) + " bytes where the library's has " + std::to_string(sizeof full) +
                    ": compile the program with this library's headers, or leave the option out.");
  };
#define F64(section, name, unit, initial, min, max, help)             \
  keep(#section "." #name, offsetof(hfrac_sim_def, section##_##name), \
       full.section##_##name != usual.section##_##name);
#define I64(section, name, initial, min, max, help) F64(section, name, "", initial, min, max, help)
#define CHOICE(section, name, initial, words, help) F64(section, name, "", initial, 0, 0, help)
#include "options/option_list.inc"
#undef F64
#undef I64
#undef CHOICE
  keep("packing.file", offsetof(hfrac_sim_def, packing_file), full.packing_file[0] != '\0');
  write_struct(to, full, name);
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

CaseDefinition case_of(const hfrac_sim_def& def) {
  CaseDefinition definition;
  definition.options = options_of(def);
  definition.title = text_of(def.title, "title");
  definition.packing_file = text_of(def.packing_file, "packing.file");
  each_list([&](auto list) { list.in(definition) = items_of(list, def); });
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

void write_case(hfrac_sim_def* to, const CaseDefinition& definition, hfrac_sim_def full, const char* name) {
  put_title(definition.title, full);
  put_packing_file(definition.packing_file, full);
  auto lists = std::make_unique<OwnedLists>();
  each_list([&](auto list) { list.in(*lists) = owned(list, list.in(definition), full); });
  put_options(definition.options, full);
  const auto* before = static_cast<OwnedLists*>(full.lists);
  full.lists = lists.get();
  each_list([&](auto list) { show_list(list, list.in(*lists), full); });
  write_def(to, full, name);
  static_cast<void>(lists.release());  // the caller's struct owns them now
  delete before;
}

void put_title(std::string_view title, hfrac_sim_def& def) {
  put_text(title, def.title, "title");
}

void put_packing_file(std::string_view path, hfrac_sim_def& def) {
  put_text(path, def.packing_file, "packing.file");
}

}  // namespace hfrac::capi
