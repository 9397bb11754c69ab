// SPDX-License-Identifier: BSD-3-Clause
// Arrays of a simulation from C. Values are laid out in field_values.cpp; here is how they get out: by copy, or as a
// view into a cache that the handle keeps until the epoch moves on.
#include "hfrac/field.h"

#include <algorithm>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "internal.hpp"
#include "options/nearest.hpp"
#include "options/options.hpp"
#include "sim_handle.hpp"
#include "utf8.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

struct FieldEntry {
  std::int32_t field;
  const char* name;
  const char* unit;
  std::int32_t location, dtype, components;
  const char* help;
};
#define HFRAC_ENTRY_(name, value, key, unit, location, dtype, components, help) \
  {value, key, unit, location, dtype, components, help},
constexpr FieldEntry entries[] = {HFRAC_FIELD_LIST(HFRAC_ENTRY_)};
#undef HFRAC_ENTRY_

const FieldEntry& entry_of(std::int32_t field) {
  for (const auto& entry : entries) {
    if (entry.field == field) return entry;
  }
  throw Error(ErrorKind::argument, "field " + std::to_string(field) +
                                       " is not one of enum hfrac_field; ask hfrac_field_find for a name's.");
}

std::int64_t item_count(const Simulation& s, std::int32_t location) {
  switch (location) {
    case 0:
      return s.engine_as_is().model.assembly.disc_count();
    case 1:
    case 2:
      return s.engine_as_is().model.assembly.bond_count();
    case 3:
      return s.network().domain_count();
    case 4:
      return static_cast<std::int64_t>(s.network().corner_disc.size());
    default:
      return static_cast<std::int64_t>(s.engine_as_is().model.assembly.smooth.contacts.size());
  }
}

void require_dtype(const FieldEntry& entry, std::int32_t dtype) {
  if (entry.dtype == dtype) return;
  throw Error(ErrorKind::argument,
              std::string(entry.name) + (dtype == 0 ? " holds int32; use hfrac_field_copy_i32."
                                                    : " holds doubles; use hfrac_field_copy_f64."));
}

template <class Value>
std::int32_t copy_out(hfrac_sim* sim, std::int32_t field, std::int32_t dtype, Value* destination,
                      std::int64_t capacity, std::int64_t* count) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    const FieldEntry& entry = entry_of(field);
    require_dtype(entry, dtype);
    const std::int64_t values = item_count(*sim->simulation, entry.location) * entry.components;
    if (destination == nullptr) {
      *count = values;
      return;
    }
    if (capacity < values) {
      throw Error(ErrorKind::argument, "capacity = " + std::to_string(capacity) + " is less than the " +
                                           std::to_string(values) + " values of " + entry.name +
                                           "; ask for the count first.");
    }
    if constexpr (sizeof(Value) == sizeof(double)) {
      write_values(*sim->simulation, field, destination);
    } else {
      write_indices(*sim->simulation, field, destination);
    }
    *count = values;
  });
}

}  // namespace

int32_t hfrac_field_info(const hfrac_sim* sim, int32_t field, hfrac_field_desc* desc) {
  return guarded_sim(sim, [&] {
    const FieldEntry& entry = entry_of(field);
    hfrac_field_desc full{};
    full.field = field;
    full.name = entry.name;
    full.unit = entry.unit;
    full.help = entry.help;
    full.location = entry.location;
    full.dtype = entry.dtype;
    full.components = entry.components;
    full.count = item_count(*sim->simulation, entry.location);
    full.epoch = sim->epoch;
    write_struct(desc, full, "hfrac_field_desc");
  });
}

int32_t hfrac_field_find(const char* name, int32_t* field) {
  return guarded([&] {
    require_not_null(name, "name");
    require_not_null(field, "field");
    for (const auto& entry : entries) {
      if (std::string_view(entry.name) == name) {
        *field = entry.field;
        return;
      }
    }
    std::vector<std::string_view> names;
    for (const auto& entry : entries) names.emplace_back(entry.name);
    const std::string given = printable(name);
    if (const std::string renamed = renamed_text(given); !renamed.empty())
      throw Error(ErrorKind::unknown_key, renamed);
    const std::string_view nearest = nearest_name(given, names);
    throw Error(ErrorKind::unknown_key,
                given + " is not a field" +
                    (nearest.empty() ? "; the names are in HFRAC_FIELD_LIST of hfrac/field.h."
                                     : "; did you mean " + std::string(nearest) + "?"));
  });
}

int32_t hfrac_field_copy_f64(hfrac_sim* sim, int32_t field, double* destination, int64_t capacity,
                             int64_t* count) {
  return copy_out(sim, field, 0, destination, capacity, count);
}

int32_t hfrac_field_copy_i32(hfrac_sim* sim, int32_t field, int32_t* destination, int64_t capacity,
                             int64_t* count) {
  return copy_out(sim, field, 1, destination, capacity, count);
}

int32_t hfrac_field_view(hfrac_sim* sim, int32_t field, const void** data, int64_t* count, int64_t* epoch) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(data, "data");
    require_not_null(count, "count");
    const FieldEntry& entry = entry_of(field);
    const std::int64_t values = item_count(*sim->simulation, entry.location) * entry.components;
    auto& cached = sim->views[field];
    if (cached.epoch != sim->epoch) {
      if (entry.dtype == 0) {
        cached.values.reserve(1);  // so that an empty field has an address too
        cached.values.resize(static_cast<std::size_t>(values));
        write_values(*sim->simulation, field, cached.values.data());
      } else {
        cached.indices.reserve(1);
        cached.indices.resize(static_cast<std::size_t>(values));
        write_indices(*sim->simulation, field, cached.indices.data());
      }
      cached.epoch = sim->epoch;
    }
    *data = entry.dtype == 0 ? static_cast<const void*>(cached.values.data()) : cached.indices.data();
    *count = values;
    if (epoch != nullptr) *epoch = sim->epoch;
  });
}

int32_t hfrac_epoch(const hfrac_sim* sim, int64_t* epoch) {
  return guarded_sim(sim, [&] {
    require_not_null(epoch, "epoch");
    *epoch = sim->epoch;
  });
}
