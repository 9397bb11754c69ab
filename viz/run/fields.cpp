// SPDX-License-Identifier: BSD-3-Clause
#include "run/fields.hpp"

#include <fmt/format.h>
#include <hfrac/field.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace hfrac::run {
namespace {

constexpr std::array fields{
#define HFRAC_FIELD_ENTRY_(name, value, key, unit, location, dtype, components, help) \
  Field{value, key, unit, Location{location}, (dtype) == 0, components},
    HFRAC_FIELD_LIST(HFRAC_FIELD_ENTRY_)
#undef HFRAC_FIELD_ENTRY_
};

// Points and cells themselves, what only the solver needs, and velocities, which between sub-steps are the solver's too.
constexpr std::array<int32_t, 9> not_shown = {HFRAC_DISC_POSITION,  HFRAC_DISC_VELOCITY, HFRAC_BOND_DISCS,
                                              HFRAC_PIPE_DOMAINS,   HFRAC_DOMAIN_CENTRE, HFRAC_DOMAIN_OFFSET,
                                              HFRAC_DOMAIN_CORNERS, HFRAC_JOINT_BEGIN,   HFRAC_JOINT_END};

}  // namespace

std::span<const Field> all_fields() {
  return fields;
}

std::vector<Field> shown_fields(Location location) {
  std::vector<Field> shown;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(shown), [&](const Field& field) {
    return field.location == location &&
           std::find(not_shown.begin(), not_shown.end(), field.number) == not_shown.end();
  });
  return shown;
}

std::string_view bare_name(const Field& field) {
  return field.key.substr(field.key.find('.') + 1);
}

std::string unit_ending(std::string_view unit) {
  if (unit.empty() || unit == "1") return {};
  std::string ending = "_";
  for (const char c : unit) {
    if (c == '/') {
      ending += "_per_";
    } else {
      ending += c == ' ' ? '_' : c;
    }
  }
  return ending;
}

std::string array_name(const Field& field) {
  return std::string(bare_name(field)) + unit_ending(field.unit);
}

std::vector<const char*> component_names(const Field& field) {
  if (field.components == 2) return {"x", "y", "z"};
  if (field.components == 3) return {"xx", "yy", "xy"};
  return {};
}

std::string column_name(const Field& field, int32_t component) {
  const std::string_view name = bare_name(field);
  if (field.components == 1) return array_name(field);
  if (!field.real) return fmt::format("{}_{}", name.substr(0, name.size() - 1), component);  // disc_0, disc_1
  const char* part = component_names(field)[static_cast<size_t>(component)];
  const bool place = name == "position" || name == "centre";
  return (place ? std::string() : fmt::format("{}_", name)) + part + unit_ending(field.unit);
}

}  // namespace hfrac::run
