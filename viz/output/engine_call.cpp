// SPDX-License-Identifier: BSD-3-Clause
// Two-call copies (first the count, then the values) and the error path, written once.
#include "output/engine_call.hpp"

#include <fmt/format.h>

namespace hfrac::output {

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

std::vector<double> doubles(hfrac_sim* sim, int32_t field) {
  int64_t count = 0;
  require(hfrac_field_copy_f64(sim, field, nullptr, 0, &count), sim);
  std::vector<double> values(static_cast<size_t>(count));
  if (count > 0) require(hfrac_field_copy_f64(sim, field, values.data(), count, &count), sim);
  return values;
}

std::vector<int32_t> integers(hfrac_sim* sim, int32_t field) {
  int64_t count = 0;
  require(hfrac_field_copy_i32(sim, field, nullptr, 0, &count), sim);
  std::vector<int32_t> values(static_cast<size_t>(count));
  if (count > 0) require(hfrac_field_copy_i32(sim, field, values.data(), count, &count), sim);
  return values;
}

hfrac_sim_def definition_of(const hfrac_sim* sim) {
  auto definition = sized<hfrac_sim_def>();
  require(hfrac_sim_definition(sim, &definition), sim);
  return definition;
}

hfrac_sim_state state_of(const hfrac_sim* sim) {
  auto state = sized<hfrac_sim_state>();
  require(hfrac_sim_get_state(sim, &state), sim);
  return state;
}

hfrac_setup_report setup_of(const hfrac_sim* sim) {
  auto report = sized<hfrac_setup_report>();
  require(hfrac_sim_get_setup(sim, &report), sim);
  return report;
}

hfrac_balance balance_of(const hfrac_sim* sim) {
  auto balance = sized<hfrac_balance>();
  require(hfrac_get_balance(sim, &balance), sim);
  return balance;
}

hfrac_solver_report solver_of(const hfrac_sim* sim) {
  auto report = sized<hfrac_solver_report>();
  require(hfrac_sim_get_solver(sim, &report), sim);
  return report;
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
  const auto size = static_cast<int32_t>(sizeof(hfrac_crack));
  int64_t count = 0, next = 0;
  require(hfrac_cracks_since(sim, 0, size, nullptr, 0, &count, &next), sim);
  std::vector<hfrac_crack> cracks(static_cast<size_t>(count));
  if (count > 0) require(hfrac_cracks_since(sim, 0, size, cracks.data(), count, &count, &next), sim);
  return cracks;
}

std::vector<hfrac_fracture> fractures_of(hfrac_sim* sim) {
  const auto size = static_cast<int32_t>(sizeof(hfrac_fracture));
  int64_t count = 0;
  require(hfrac_fractures(sim, size, nullptr, 0, &count), sim);
  std::vector<hfrac_fracture> fractures(static_cast<size_t>(count));
  if (count > 0) require(hfrac_fractures(sim, size, fractures.data(), count, &count), sim);
  return fractures;
}

std::string version_of_library() {
  int32_t major = 0, minor = 0, patch = 0;
  require(hfrac_version(&major, &minor, &patch), nullptr);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string build_of_library() {
  return whole_text([](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_build_info(buffer, capacity, needed);
  });
}

std::string case_text(const hfrac_sim_def& definition) {
  return whole_text([&](char* buffer, int32_t capacity, int32_t* needed) {
    return hfrac_sim_def_write(&definition, buffer, capacity, needed);
  });
}

}  // namespace hfrac::output
