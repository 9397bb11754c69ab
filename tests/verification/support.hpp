// SPDX-License-Identifier: BSD-3-Clause
// What the verification cases share: simulations made and read through hfrac.h as a user would, linear fits,
// and the line each case prints for every figure it checks.
#pragma once

#include <gtest/gtest.h>
#include <hfrac/hfrac.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace verification {

constexpr double pi = 3.14159265358979323846;

inline hfrac_sim_def new_def() {
  hfrac_sim_def def;
  hfrac_sim_def_init(&def, sizeof def);
  return def;
}

class Simulation {
 public:
  explicit Simulation(const hfrac_sim_def& def) { check(hfrac_sim_create(&def, &sim_)); }
  ~Simulation() { hfrac_sim_destroy(&sim_); }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  // Not being at rest is for the case to judge.
  int32_t step(int64_t count) { return check(hfrac_step(sim_, count)); }
  void ramp(int32_t well, double pressure, double per_step) {
    check(hfrac_well_set_ramp(sim_, well, pressure, per_step));
  }
  void set_far_field(double sigma_H, double sigma_h) { check(hfrac_set_far_field(sim_, sigma_H, sigma_h)); }
  // One step of that many seconds.
  void step_for(double duration) {
    check(hfrac_step_prepare(sim_));
    check(hfrac_step_do(sim_, duration));
    check(hfrac_step_finalize(sim_));
  }
  void balance(hfrac_balance* into) { check(hfrac_get_balance(sim_, into)); }
  [[nodiscard]] hfrac_sim_state state() const {
    hfrac_sim_state state{};
    state.struct_size = sizeof state;
    check(hfrac_sim_get_state(sim_, &state));
    return state;
  }
  [[nodiscard]] hfrac_setup_report setup() const {
    hfrac_setup_report report{};
    report.struct_size = sizeof report;
    check(hfrac_sim_get_setup(sim_, &report));
    return report;
  }
  [[nodiscard]] hfrac_well_state well(int32_t index) const {
    hfrac_well_state state{};
    state.struct_size = sizeof state;
    check(hfrac_well_get(sim_, index, &state));
    return state;
  }
  [[nodiscard]] std::vector<double> values(int32_t field) {
    int64_t count = 0;
    check(hfrac_field_copy_f64(sim_, field, nullptr, 0, &count));
    std::vector<double> all(static_cast<std::size_t>(count));
    check(hfrac_field_copy_f64(sim_, field, all.data(), count, &count));
    return all;
  }
  [[nodiscard]] std::vector<int32_t> indices(int32_t field) {
    int64_t count = 0;
    check(hfrac_field_copy_i32(sim_, field, nullptr, 0, &count));
    std::vector<int32_t> all(static_cast<std::size_t>(count));
    check(hfrac_field_copy_i32(sim_, field, all.data(), count, &count));
    return all;
  }

 private:
  int32_t check(int32_t status) const {
    if (status >= 0) return status;
    char text[1024] = "";
    hfrac_last_error(sim_, text, sizeof text, nullptr);
    throw std::runtime_error(text);
  }
  hfrac_sim* sim_ = nullptr;
};

// value = a + b x + c y by least squares, over the points whose `use` is not 0.
struct Plane {
  double a, b, c;
};
inline Plane fit_plane(const std::vector<double>& x, const std::vector<double>& y,
                       const std::vector<double>& value, const std::vector<char>& use) {
  double n = 0.0, mx = 0.0, my = 0.0, mv = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (use[i] == 0) continue;
    n += 1.0;
    mx += x[i];
    my += y[i];
    mv += value[i];
  }
  mx /= n;
  my /= n;
  mv /= n;
  double xx = 0.0, xy = 0.0, yy = 0.0, xv = 0.0, yv = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (use[i] == 0) continue;
    const double dx = x[i] - mx, dy = y[i] - my, dv = value[i] - mv;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xv += dx * dv;
    yv += dy * dv;
  }
  const double determinant = xx * yy - xy * xy, b = (xv * yy - yv * xy) / determinant,
               c = (yv * xx - xv * xy) / determinant;
  return {mv - b * mx - c * my, b, c};
}

// One line of the case's record: what, measured, analytic, error, tolerance (both relative to the analytic
// value).
inline void report(const char* what, double measured, double analytic, double tolerance) {
  std::printf("  %-52s measured %12.6g  analytic %12.6g  error %+9.2e  tolerance %.1e\n", what, measured,
              analytic, measured / analytic - 1.0, tolerance);
  EXPECT_NEAR(measured, analytic, tolerance * std::abs(analytic)) << what;
}

}  // namespace verification
