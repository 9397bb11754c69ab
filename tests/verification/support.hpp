// SPDX-License-Identifier: BSD-3-Clause
// What the verification cases share: simulations made and read through hfrac.h as a user would, linear fits, elasticity of a
// block, the line each case prints for every figure it checks, and the curves behind the pictures.
//
// Variants. Test suites ...Smoke take seconds at most, those without an ending some more, those ...Long minutes:
// `tests/verify V7 --smoke` runs the first, `tests/verify V7` all but the last, `tests/verify V7 --full` everything.
#pragma once

#include <gtest/gtest.h>
#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/plane_fit.hpp"

namespace verification {

constexpr double pi = 3.14159265358979323846;

inline hfrac::Definition new_def() {
  hfrac::Definition def;
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
  void set_rate(int32_t well, double rate) { check(hfrac_well_set_rate(sim_, well, rate)); }
  void set_far_field(double sigma_Hmax, double sigma_hmin) {
    check(hfrac_set_far_field(sim_, sigma_Hmax, sigma_hmin));
  }
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
  [[nodiscard]] std::vector<hfrac_fracture> fractures() {
    int64_t count = 0;
    check(hfrac_fractures(sim_, sizeof(hfrac_fracture), nullptr, 0, &count));
    std::vector<hfrac_fracture> all(static_cast<std::size_t>(count));
    check(hfrac_fractures(sim_, sizeof(hfrac_fracture), all.data(), count, &count));
    return all;
  }
  // With the fracture each belongs to as `fractures` numbers them.
  [[nodiscard]] std::vector<hfrac_crack> cracks() {
    int64_t count = 0, next = 0;
    check(hfrac_cracks_since(sim_, 0, sizeof(hfrac_crack), nullptr, 0, &count, &next));
    std::vector<hfrac_crack> all(static_cast<std::size_t>(count));
    check(hfrac_cracks_since(sim_, 0, sizeof(hfrac_crack), all.data(), count, &count, &next));
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

// Slope and offset of the line of least squares.
struct Line {
  double slope, offset;
};
inline Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  double mx = 0.0, my = 0.0, xx = 0.0, xy = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    mx += x[k] / n;
    my += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
  }
  return {xy / xx, my - xy / xx * mx};
}

// b - a.
inline std::vector<double> moved(const std::vector<double>& a, std::vector<double> b) {
  for (std::size_t k = 0; k < b.size(); ++k) b[k] -= a[k];
  return b;
}

// Strains along x and y, extension positive, of the inner 70 % of either side of a block of 100 m: slopes of the displacement
// (x, y of each disc) at the places (likewise).
inline std::array<double, 2> inner_strain(const std::vector<double>& place,
                                          const std::vector<double>& displacement) {
  hfrac::PlaneFit along, across;
  for (std::size_t i = 0; i < place.size(); i += 2) {
    const double x = place[i], y = place[i + 1];
    if (std::abs(x - 50.0) >= 35.0 || std::abs(y - 50.0) >= 35.0) continue;
    along.add(x, y, displacement[i]);
    across.add(x, y, displacement[i + 1]);
  }
  return {along.plane().by_x, across.plane().by_y};
}

// E' and nu' of the two-dimensional model: what the block of `def` (100 m, without a well) does under `stress` along x. Read
// as plane strain of a three-dimensional rock, nu = nu' / (1 + nu') and E = E' (1 - nu^2) (Timoshenko and Goodier).
struct Elasticity {
  double modulus, poisson;  // Pa, 1: E', nu'
  [[nodiscard]] double plane_strain_poisson() const { return poisson / (1.0 + poisson); }
  [[nodiscard]] double plane_strain_modulus() const {
    return modulus * (1.0 - plane_strain_poisson() * plane_strain_poisson());
  }
};
inline Elasticity elasticity(hfrac::Definition def, double stress) {
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  const auto before = Simulation(def).values(HFRAC_DISC_POSITION);
  def.stress_sigma_Hmax = stress;
  const auto strain = inner_strain(before, moved(before, Simulation(def).values(HFRAC_DISC_POSITION)));
  return {-stress / strain[0], -strain[1] / strain[0]};
}

// Table 1's rock with effective stresses, between walls without stress, a well of 8.5 m in the middle: 2 000 discs.
inline hfrac::Definition paper_rock(int64_t seed) {
  hfrac::Definition def = new_def();
  def.model_seed = seed;
  def.stress_convention = 1;
  def.boundary_kind = 1;
  def.packing_disc_count = 2000;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 0.0;
  def.stepping_flow_step = 1e-3;
  hfrac_sim_def_set_i64(&def, "well_count", 1);
  def.wells[0].x = def.wells[0].y = 50.0;
  def.wells[0].radius = 8.5;
  return def;
}

// The curves behind a page's figure. With the environment variable HFRAC_CURVES a folder, they are written there as a table
// that `hfrac plot --compare` draws: columns are the series' name, x and up to six quantities, names with their units.
// `tests/verify V5 --pictures DIR` sets the variable and draws; the line printed here tells it what there is. Tests of one
// run that name the same figure add to it.
class Curves {
 public:
  Curves(const std::string& figure, const std::string& title, const std::string& columns) {
    const char* folder = std::getenv("HFRAC_CURVES");
    if (folder == nullptr) return;
    static std::set<std::string> begun;
    const bool first = begun.insert(figure).second;
    file_.open(std::string(folder) + "/" + figure + ".csv", first ? std::ios::out : std::ios::app);
    file_.precision(9);
    if (!first) return;
    file_ << "series," << columns << '\n';
    std::printf("  curves %s.csv: %s\n", figure.c_str(), title.c_str());
  }
  // A row; NaN leaves a quantity out.
  void point(const std::string& series, const std::vector<double>& values) {
    ASSERT_EQ(series.find_first_of(",\"\n"), std::string::npos) << series << ": not a word of a table";
    if (!file_.is_open()) return;
    file_ << series;
    for (const double value : values) {
      file_ << ',';
      if (!std::isnan(value)) file_ << value;
    }
    file_ << '\n';
  }
  // A formula as a smooth line: more points than are drawn one by one. Each row is x and what `values(x)` gives.
  template <class Values>
  void line(const std::string& series, double from, double to, const Values& values) {
    constexpr int pieces = 80;
    for (int k = 0; k <= pieces; ++k) {
      const double x = from + (to - from) * k / pieces;
      std::vector<double> row{x};
      for (const double value : values(x)) row.push_back(value);
      point(series, row);
    }
  }

 private:
  std::ofstream file_;
};

// Figures printed so far: a test that printed none fails (main.cpp).
inline int figure_count = 0;

// One line of the case's record: what, measured, analytic, error, tolerance (both relative to the analytic
// value). tests/verify reads these lines.
inline void report(const std::string& what, double measured, double analytic, double tolerance) {
  ++figure_count;
  std::printf("  %-52s measured %12.6g  analytic %12.6g  error %+9.2e  tolerance %.1e\n", what.c_str(),
              measured, analytic, measured / analytic - 1.0, tolerance);
  EXPECT_NEAR(measured, analytic, tolerance * std::abs(analytic)) << what;
}

// The same with error and tolerance in the figure's own unit: where the analytic value is zero, or passes through it.
inline void report_absolute(const std::string& what, double measured, double analytic, double tolerance) {
  ++figure_count;
  std::printf("  %-52s measured %12.6g  analytic %12.6g  error %+9.2e  tolerance %.1e abs\n", what.c_str(),
              measured, analytic, measured - analytic, tolerance);
  EXPECT_NEAR(measured, analytic, tolerance) << what;
}

}  // namespace verification
