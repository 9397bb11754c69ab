// SPDX-License-Identifier: BSD-3-Clause
// The laboratory for verification cases, through hfrac.h as a user would.
#pragma once

#include <cmath>
#include <memory>

#include "support.hpp"

namespace verification {

// The linear rock of physics.md 2: contacts act once the bond is broken.
inline hfrac::Definition linear_rock() {
  hfrac::Definition def = new_def();
  def.contact_mode = 1;
  def.bond_normal_stiffness = 16e9;
  def.bond_shear_stiffness = 5.6e9;
  return def;
}

inline hfrac_lab_spec specimen(int32_t test, int64_t discs, double width) {
  hfrac_lab_spec spec;
  hfrac_lab_spec_init(&spec, sizeof spec);
  spec.test = test;
  spec.disc_count = discs;
  spec.width = width;
  return spec;
}

class Lab {
 public:
  Lab(const hfrac_sim_def& def, const hfrac_lab_spec& spec) {
    if (hfrac_lab_run(&def, &spec, nullptr, nullptr, &lab_) < 0) {
      char text[1024] = "";
      hfrac_last_error(nullptr, text, sizeof text, nullptr);
      throw std::runtime_error(text);
    }
  }
  ~Lab() { hfrac_lab_destroy(&lab_); }
  Lab(const Lab&) = delete;
  Lab& operator=(const Lab&) = delete;

  [[nodiscard]] hfrac_lab_report report() const {
    hfrac_lab_report r{};
    r.struct_size = sizeof r;
    hfrac_lab_get_report(lab_, &r);
    return r;
  }
  [[nodiscard]] std::vector<double> table(int32_t which) const {
    int64_t count = 0;
    hfrac_lab_copy_f64(lab_, which, nullptr, 0, &count);
    std::vector<double> values(static_cast<std::size_t>(count));
    hfrac_lab_copy_f64(lab_, which, values.data(), count, &count);
    return values;
  }

 private:
  hfrac_lab* lab_ = nullptr;
};

// Mean of a test's value over `packings` seeds from 1, and the standard deviation of one.
struct Sample {
  double mean = 0.0, spread = 0.0;
};
inline Sample sample(const hfrac_sim_def& def, hfrac_lab_spec spec, int packings) {
  double sum = 0.0, squares = 0.0;
  for (spec.seed = 1; spec.seed <= packings; ++spec.seed) {
    const double value = Lab(def, spec).report().value;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / packings;
  return {mean, packings > 1
                    ? std::sqrt(std::max(0.0, squares / packings - mean * mean) * packings / (packings - 1))
                    : 0.0};
}

}  // namespace verification
