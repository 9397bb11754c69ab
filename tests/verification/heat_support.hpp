// SPDX-License-Identifier: BSD-3-Clause
// What the cases of heat share: a simulation in a host's hands, and a warm block.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "support.hpp"

namespace verification {

class HostedSimulation {
 public:
  explicit HostedSimulation(const hfrac_sim_def& def) { check(hfrac_sim_create(&def, &sim_)); }
  ~HostedSimulation() { hfrac_sim_destroy(&sim_); }
  HostedSimulation(const HostedSimulation&) = delete;
  HostedSimulation& operator=(const HostedSimulation&) = delete;
  operator hfrac_sim*() const { return sim_; }

  void check(int32_t status) const {
    if (status >= 0) return;
    char text[1024] = "";
    hfrac_last_error(sim_, text, sizeof text, nullptr);
    throw std::runtime_error(text);
  }
  [[nodiscard]] std::vector<double> values(int32_t field) const {
    int64_t count = 0;
    check(hfrac_field_copy_f64(sim_, field, nullptr, 0, &count));
    std::vector<double> all(static_cast<std::size_t>(count));
    check(hfrac_field_copy_f64(sim_, field, all.data(), count, &count));
    return all;
  }
  [[nodiscard]] hfrac_heat heat() const {
    hfrac_heat heat{};
    heat.struct_size = sizeof heat;
    check(hfrac_get_heat(sim_, &heat));
    return heat;
  }
  void set(const std::vector<double>& temperature) const {
    check(hfrac_set_disc_temperature(sim_, temperature.data(), static_cast<int64_t>(temperature.size())));
  }
  void hold(const std::vector<int32_t>& held) const {
    check(hfrac_hold_disc_temperature(sim_, held.data(), static_cast<int64_t>(held.size())));
  }

 private:
  hfrac_sim* sim_ = nullptr;
};

// A dry block of rock that does not break, in walls, with temperatures.
inline hfrac::Definition warm_block(int64_t discs, int64_t seed) {
  hfrac::Definition def = new_def();
  def.packing_disc_count = discs;
  def.model_seed = seed;
  def.flow_scheme = 2;  // off
  def.boundary_kind = 1;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.solver_kind = 1;  // quasi-static
  return def;
}

}  // namespace verification
