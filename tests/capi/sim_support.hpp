// SPDX-License-Identifier: BSD-3-Clause
// Small simulations for the tests of the C interface, and short ways to read them.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "support.hpp"

namespace testing_capi {

// Effective stresses in rigid walls without a far field: cracks in its first step.
inline hfrac::Definition cracking_def(int64_t discs = 500) {
  hfrac::Definition def = new_def();
  def.stress_convention = 1;
  def.boundary_kind = 1;
  def.packing_disc_count = discs;
  def.packing_residual = 1e-3;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 10.0;
  def.wells[0].pressure = 60e6;
  return def;
}

// Total stresses and rock too strong to break.
inline hfrac::Definition quiet_def(int64_t discs = 500) {
  hfrac::Definition def = cracking_def(discs);
  def.stress_convention = 0;
  def.boundary_kind = 0;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 30e6;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.wells[0].pressure = 30e6;
  return def;
}

// A simulation that is destroyed with its scope.
class Sim {
 public:
  explicit Sim(const hfrac_sim_def& def) {
    EXPECT_EQ(hfrac_sim_create(&def, &sim_), HFRAC_OK) << last_error();
  }
  ~Sim() { hfrac_sim_destroy(&sim_); }
  Sim(const Sim&) = delete;
  Sim& operator=(const Sim&) = delete;
  operator hfrac_sim*() const { return sim_; }

 private:
  hfrac_sim* sim_ = nullptr;
};

template <class Struct, class Call>
Struct read_struct(Call&& call) {
  Struct value{};
  value.struct_size = sizeof value;
  EXPECT_EQ(call(&value), HFRAC_OK);
  return value;
}
inline hfrac_sim_state state_of(const hfrac_sim* sim) {
  return read_struct<hfrac_sim_state>([&](auto* to) { return hfrac_sim_get_state(sim, to); });
}
inline hfrac_setup_report setup_of(const hfrac_sim* sim) {
  return read_struct<hfrac_setup_report>([&](auto* to) { return hfrac_sim_get_setup(sim, to); });
}
inline hfrac_balance balance_of(const hfrac_sim* sim) {
  return read_struct<hfrac_balance>([&](auto* to) { return hfrac_get_balance(sim, to); });
}
inline hfrac_solver_report solver_of(const hfrac_sim* sim) {
  return read_struct<hfrac_solver_report>([&](auto* to) { return hfrac_sim_get_solver(sim, to); });
}
inline hfrac_well_state well_of(const hfrac_sim* sim, int32_t index = 0) {
  return read_struct<hfrac_well_state>([&](auto* to) { return hfrac_well_get(sim, index, to); });
}
inline hfrac_field_desc desc_of(const hfrac_sim* sim, int32_t field) {
  return read_struct<hfrac_field_desc>([&](auto* to) { return hfrac_field_info(sim, field, to); });
}

inline int64_t hash_of(const hfrac_sim* sim) {
  int64_t hash = 0;
  EXPECT_EQ(hfrac_state_hash(sim, &hash), HFRAC_OK);
  return hash;
}
inline int64_t epoch_of(const hfrac_sim* sim) {
  int64_t epoch = 0;
  EXPECT_EQ(hfrac_epoch(sim, &epoch), HFRAC_OK);
  return epoch;
}

inline std::vector<double> doubles(hfrac_sim* sim, int32_t field) {
  int64_t count = 0;
  EXPECT_EQ(hfrac_field_copy_f64(sim, field, nullptr, 0, &count), HFRAC_OK);
  std::vector<double> values(static_cast<std::size_t>(count));
  EXPECT_EQ(hfrac_field_copy_f64(sim, field, values.data(), count, &count), HFRAC_OK);
  return values;
}
inline std::vector<int32_t> indices(hfrac_sim* sim, int32_t field) {
  int64_t count = 0;
  EXPECT_EQ(hfrac_field_copy_i32(sim, field, nullptr, 0, &count), HFRAC_OK);
  std::vector<int32_t> values(static_cast<std::size_t>(count));
  EXPECT_EQ(hfrac_field_copy_i32(sim, field, values.data(), count, &count), HFRAC_OK);
  return values;
}

inline std::vector<hfrac_crack> cracks_of(hfrac_sim* sim, int64_t cursor = 0) {
  int64_t count = 0;
  EXPECT_EQ(hfrac_cracks_since(sim, cursor, sizeof(hfrac_crack), nullptr, 0, &count, nullptr), HFRAC_OK);
  std::vector<hfrac_crack> cracks(static_cast<std::size_t>(count) + 1);
  EXPECT_EQ(hfrac_cracks_since(sim, cursor, sizeof(hfrac_crack), cracks.data(), count + 1, &count, nullptr),
            HFRAC_OK);
  cracks.resize(static_cast<std::size_t>(count));
  return cracks;
}
inline std::vector<hfrac_fracture> fractures_of(hfrac_sim* sim) {
  int64_t count = 0;
  EXPECT_EQ(hfrac_fractures(sim, sizeof(hfrac_fracture), nullptr, 0, &count), HFRAC_OK);
  std::vector<hfrac_fracture> fractures(static_cast<std::size_t>(count) + 1);
  EXPECT_EQ(hfrac_fractures(sim, sizeof(hfrac_fracture), fractures.data(), count + 1, &count), HFRAC_OK);
  fractures.resize(static_cast<std::size_t>(count));
  return fractures;
}

// All fields by name, and the numbers of the structs: whatever a host can see of a simulation.
using Sight = std::map<std::string, std::vector<double>>;
inline Sight sight_of(hfrac_sim* sim) {
  Sight sight;
#define HFRAC_LOOK(name, value, key, unit, location, dtype, components, help) \
  if ((dtype) == 0) {                                                         \
    sight[key] = doubles(sim, name);                                          \
  } else {                                                                    \
    const auto whole = indices(sim, name);                                    \
    sight[key].assign(whole.begin(), whole.end());                            \
  }
  HFRAC_FIELD_LIST(HFRAC_LOOK)
#undef HFRAC_LOOK
  const auto s = state_of(sim);
  sight["state: clock"] = {s.time, static_cast<double>(s.step), static_cast<double>(s.cycles)};
  sight["state: rest"] = {s.force_ratio, static_cast<double>(s.at_rest)};
  sight["state: cracks"] = {static_cast<double>(s.crack_count), static_cast<double>(s.tensile_cracks),
                            static_cast<double>(s.shear_cracks), s.tip_distance,
                            static_cast<double>(s.stop_reason)};
  sight["state: flow_subcycles"] = {static_cast<double>(s.flow_subcycles)};
  sight["state: mechanical_step"] = {s.mechanical_step};
  const auto b = balance_of(sim);
  sight["balance"] = {b.kinetic,       b.bond_elastic,  b.contact_elastic, b.fluid_work,   b.boundary_work,
                      b.friction,      b.damping,       b.fracture,        b.energy_error, b.injected_volume,
                      b.stored_volume, b.leaked_volume, b.fluid_error};
  const auto w = well_of(sim);
  sight["well"] = {w.pressure, w.target_pressure, w.rate, w.injected_volume, static_cast<double>(w.control)};
  auto& cracks = sight["cracks"];
  for (const auto& c : cracks_of(sim)) {
    cracks.insert(cracks.end(), {static_cast<double>(c.bond), static_cast<double>(c.cycle), c.time, c.length,
                                 c.aperture, c.normal_force, c.shear_force, c.energy});
  }
  sight["hash"] = {static_cast<double>(hash_of(sim))};
  return sight;
}
inline void expect_same(const Sight& found, const Sight& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [name, values] : wanted) {
    const auto& others = found.at(name);
    ASSERT_EQ(others.size(), values.size()) << name;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (others[k] == values[k]) continue;
      ADD_FAILURE() << name << "[" << k << "] is " << others[k] << " instead of " << values[k];
      break;
    }
  }
}

// A case file is refused, by what it says or what its files do, in a sentence that begins with the folder and holds these words.
inline void expect_refused(const std::string& folder, const std::string& file,
                           const std::vector<std::string>& words) {
  hfrac::Definition def = new_def();
  int32_t status = hfrac_sim_def_load(&def, file.c_str());
  if (status == HFRAC_OK) status = hfrac_sim_def_check_file(&def, file.c_str());
  EXPECT_EQ(status, HFRAC_ERR_CASE_FILE);
  EXPECT_TRUE(last_error().starts_with(folder)) << last_error();
  EXPECT_TRUE(last_error().ends_with('.') || last_error().ends_with('?')) << last_error();
  for (const auto& word : words)
    EXPECT_NE(last_error().find(word), std::string::npos) << "no '" << word << "' in: " << last_error();
}

// A progress callback made of any function: Host host([&](double, const char*) { return 0; }).
template <class Function>
class Host {
 public:
  explicit Host(Function function) : function_(function) {}
  static int32_t call(void* user, double fraction, const char* what) {
    return static_cast<Host*>(user)->function_(fraction, what);
  }
  void attach(hfrac_sim* sim, double seconds = 0.0) {
    EXPECT_EQ(hfrac_set_progress(sim, call, this, seconds), HFRAC_OK) << last_error(sim);
  }

 private:
  Function function_;
};

}  // namespace testing_capi
