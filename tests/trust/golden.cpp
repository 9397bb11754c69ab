// SPDX-License-Identifier: BSD-3-Clause
// Not hfrac_state_hash: that changes whenever the state gets another member. Here only a result that is another one counts.
#include "golden.hpp"

#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace golden {
namespace {

void require(int32_t status, const hfrac_sim* sim) {
  if (status >= 0) return;
  char text[1024];
  hfrac_last_error(sim, text, sizeof text, nullptr);
  throw std::runtime_error(text);
}

hfrac::Definition base(int64_t discs) {
  hfrac::Definition def;
  def.packing_disc_count = discs;
  def.stress_convention = 1;
  def.boundary_kind = 1;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  def.stepping_flow_step = 1e-2;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 10.0;
  def.wells[0].pressure = 70e6;
  return def;
}

/** FNV-1a over 64-bit words. */
class Fold {
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3ULL, value_ ^= value_ >> 29U; }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

void add_field(Fold& fold, hfrac_sim* sim, int32_t field) {
  int64_t count = 0;
  require(hfrac_field_copy_f64(sim, field, nullptr, 0, &count), sim);
  std::vector<double> values(static_cast<std::size_t>(count));
  if (count > 0) require(hfrac_field_copy_f64(sim, field, values.data(), count, &count), sim);
  for (const double value : values) fold.add(value);
}

}  // namespace

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, int64_t discs, int64_t steps, auto&& change) {
    hfrac::Definition def = base(discs);
    change(def);
    all.push_back({name, def, steps});
  };
  add("explicit_substep", 1200, 3, [](auto&) {});
  add("explicit_iterative", 600, 3, [](auto& def) { def.flow_solver = 2; });
  add("explicit_flow", 600, 3, [](auto& def) {
    def.flow_scheme = 1;
    def.flow_aperture_limit = 1e-4;
  });
  add("dynamic", 1200, 3, [](auto& def) {
    def.stepping_mode = 1;
    def.stepping_flow_step = 2e-3;
  });
  add("far_field_after_break", 600, 3, [](auto& def) {
    def.stress_convention = 0;
    def.boundary_kind = 0;
    def.contact_mode = 1;
    def.stress_sigma_Hmax = 33e6;
    def.stress_sigma_hmin = 28e6;
    def.wells[0].pressure = 80e6;
  });
  add("quasi_static_substep", 600, 3, [](auto& def) { def.solver_kind = 1; });
  add("quasi_static_coupled", 600, 3, [](auto& def) {
    def.solver_kind = 1;
    def.stepping_mode = 2;
  });
  add("dry_packing_by_growth", 400, 2, [](auto& def) {
    def.packing_method = 2;
    def.flow_scheme = 2;
  });
  return all;
}

std::uint64_t fingerprint(const Case& which, int64_t workers) {
  hfrac::Definition def = which.def;
  def.run_workers = workers;
  hfrac_sim* sim = nullptr;
  require(hfrac_sim_create(&def, &sim), nullptr);
  Fold fold;
  try {
    require(hfrac_step(sim, which.steps), sim);
    for (const int32_t field : {HFRAC_DISC_POSITION, HFRAC_DISC_RADIUS}) add_field(fold, sim, field);
    if (def.flow_scheme != 2) {
      for (const int32_t field : {HFRAC_DOMAIN_PRESSURE, HFRAC_PIPE_APERTURE}) add_field(fold, sim, field);
    }
    int64_t count = 0, next = 0;
    require(hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), nullptr, 0, &count, &next), sim);
    std::vector<hfrac_crack> cracks(static_cast<std::size_t>(count) + 1);
    require(hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), cracks.data(), count + 1, &count, &next), sim);
    for (int64_t k = 0; k < count; ++k) {
      const hfrac_crack& crack = cracks[static_cast<std::size_t>(k)];
      for (const int64_t number : {crack.bond, crack.step, crack.cycle, static_cast<int64_t>(crack.mode)})
        fold.add(static_cast<std::uint64_t>(number));
      for (const double number : {crack.time, crack.normal_force, crack.shear_force, crack.aperture})
        fold.add(number);
    }
    hfrac_balance balance{};
    balance.struct_size = sizeof balance;
    require(hfrac_get_balance(sim, &balance), sim);
    for (const double number :
         {balance.kinetic, balance.bond_elastic, balance.contact_elastic, balance.fluid_work,
          balance.friction, balance.damping, balance.fracture, balance.injected_volume})
      fold.add(number);
  } catch (...) {
    hfrac_sim_destroy(&sim);
    throw;
  }
  hfrac_sim_destroy(&sim);
  return fold.value();
}

std::map<std::string, std::uint64_t> wanted(const char* file) {
  std::map<std::string, std::uint64_t> numbers;
  std::ifstream lines(file);
  for (std::string name, number; lines >> name >> number;) numbers[name] = std::stoull(number, nullptr, 16);
  return numbers;
}

}  // namespace golden
