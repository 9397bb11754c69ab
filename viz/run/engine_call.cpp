// SPDX-License-Identifier: BSD-3-Clause
// Two-call copies (first the count, then the values) and the error path, written once.
#include "run/engine_call.hpp"

#include <fmt/format.h>

namespace hfrac::run {

std::string error_text(int32_t status, const hfrac_sim* sim) {
  std::string text = whole_text([&](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_last_error(sim, buffer, capacity, needed);
  });
  if (!text.empty()) return text;
  text = whole_text([&](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_status_text(status, buffer, capacity, needed);
  });
  return text.empty() ? fmt::format("status {}", status) : text;
}

void require(int32_t status, const hfrac_sim* sim) {
  if (status < 0) throw EngineError(status, error_text(status, sim));
}

namespace {

/** What a call copies when it is asked first for the count alone; `call` takes (destination, capacity, count). */
template <class Value, class Call>
std::vector<Value> copied(const hfrac_sim* sim, const Call& call) {
  int64_t count = 0;
  require(call(nullptr, 0, &count), sim);
  std::vector<Value> values(static_cast<size_t>(count));
  if (count > 0) require(call(values.data(), count, &count), sim);
  return values;
}

/** A struct that a call fills in. */
template <class Struct, class Call>
Struct filled(const hfrac_sim* sim, const Call& call) {
  auto value = sized<Struct>();
  require(call(sim, &value), sim);
  return value;
}

}  // namespace

std::vector<double> doubles(hfrac_sim* sim, int32_t field) {
  return copied<double>(sim, [&](double* to, int64_t capacity, int64_t* count) {
    return hfrac_field_copy_f64(sim, field, to, capacity, count);
  });
}

std::vector<int32_t> integers(hfrac_sim* sim, int32_t field) {
  return copied<int32_t>(sim, [&](int32_t* to, int64_t capacity, int64_t* count) {
    return hfrac_field_copy_i32(sim, field, to, capacity, count);
  });
}

Definition definition_of(const hfrac_sim* sim) {
  Definition definition;
  require(hfrac_sim_definition(sim, &definition), sim);
  return definition;
}

hfrac_sim_state state_of(const hfrac_sim* sim) {
  return filled<hfrac_sim_state>(sim, hfrac_sim_get_state);
}

hfrac_setup_report setup_of(const hfrac_sim* sim) {
  return filled<hfrac_setup_report>(sim, hfrac_sim_get_setup);
}

hfrac_balance balance_of(const hfrac_sim* sim) {
  return filled<hfrac_balance>(sim, hfrac_get_balance);
}

hfrac_solver_report solver_of(const hfrac_sim* sim) {
  return filled<hfrac_solver_report>(sim, hfrac_sim_get_solver);
}

int64_t state_hash_of(const hfrac_sim* sim) {
  int64_t hash = 0;
  require(hfrac_state_hash(sim, &hash), sim);
  return hash;
}

std::string state_image(const hfrac_sim* sim) {
  int64_t size = 0;
  require(hfrac_state_size(sim, &size), sim);
  std::string image(static_cast<size_t>(size), '\0');
  require(hfrac_state_save(sim, image.data(), size, &size), sim);
  return image;
}

std::vector<hfrac_well_state> wells_of(const hfrac_sim* sim) {
  int32_t count = 0;
  require(hfrac_well_count(sim, &count), sim);
  std::vector<hfrac_well_state> wells(static_cast<size_t>(count), sized<hfrac_well_state>());
  for (int32_t i = 0; i < count; ++i) require(hfrac_well_get(sim, i, &wells[static_cast<size_t>(i)]), sim);
  return wells;
}

std::vector<hfrac_crack> cracks_of(hfrac_sim* sim) {
  int64_t next = 0;
  return copied<hfrac_crack>(sim, [&](hfrac_crack* to, int64_t capacity, int64_t* count) {
    return hfrac_cracks_since(sim, 0, static_cast<int32_t>(sizeof(hfrac_crack)), to, capacity, count, &next);
  });
}

std::vector<hfrac_slip> slips_of(hfrac_sim* sim) {
  int64_t next = 0;
  return copied<hfrac_slip>(sim, [&](hfrac_slip* to, int64_t capacity, int64_t* count) {
    return hfrac_slips_since(sim, 0, static_cast<int32_t>(sizeof(hfrac_slip)), to, capacity, count, &next);
  });
}

std::vector<hfrac_fracture> fractures_of(hfrac_sim* sim) {
  return copied<hfrac_fracture>(sim, [&](hfrac_fracture* to, int64_t capacity, int64_t* count) {
    return hfrac_fractures(sim, static_cast<int32_t>(sizeof(hfrac_fracture)), to, capacity, count);
  });
}

std::vector<hfrac_fracture_point> line_of(hfrac_sim* sim, int64_t fracture) {
  return copied<hfrac_fracture_point>(sim, [&](hfrac_fracture_point* to, int64_t capacity, int64_t* count) {
    return hfrac_fracture_line(sim, fracture, static_cast<int32_t>(sizeof(hfrac_fracture_point)), to,
                               capacity, count);
  });
}

std::string version_of_library() {
  int32_t major = 0, minor = 0, patch = 0;
  require(hfrac_version(&major, &minor, &patch), nullptr);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string build_of_library() {
  return whole_text(hfrac_build_info);
}

std::string devices_of_library(int32_t& count) {
  return whole_text([&](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_devices(&count, buffer, capacity, needed);
  });
}

std::string case_text(const hfrac_sim_def& definition) {
  return whole_text([&](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_sim_def_write(&definition, buffer, capacity, needed);
  });
}

}  // namespace hfrac::run
