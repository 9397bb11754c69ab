// SPDX-License-Identifier: BSD-3-Clause
#include "lab/crack_tests.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hfrac {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

double crack_geometry_factor(LabTest test, double s) {
  const double half = 0.5 * pi * s;
  if (test == LabTest::sent) {
    const double bent = 1.0 - std::sin(half);
    return std::sqrt(std::tan(half) / half) * (0.752 + 2.02 * s + 0.37 * bent * bent * bent) / std::cos(half);
  }
  return (1.0 - 0.025 * s * s + 0.06 * s * s * s * s) / std::sqrt(std::cos(half));
}

LabResult test_crack(const Options& material, const LabSpec& spec, const Packing& packing,
                     const std::function<bool()>& interrupt) {
  LabResult result;
  const bool notch = spec.test == LabTest::sent, fluid = spec.test == LabTest::pressurised_crack;
  SpecimenShape shape;
  shape.width = spec.width;
  shape.height = specimen_aspect(spec.test) * spec.width;
  shape.wet = fluid;
  shape.slit_begin = notch ? -spec.width : 0.5 * spec.width * (1.0 - spec.slit_fraction);
  shape.slit_end = notch ? spec.slit_fraction * spec.width : 0.5 * spec.width * (1.0 + spec.slit_fraction);
  shape.stress_y = fluid ? 0.0 : -1e6;  // Pa at load 1
  auto s = std::make_unique<Specimen>(packing, material, shape);

  double load_now = 0.0;
  Loading loading;
  loading.first = 1e-3;
  loading.constant = true;
  loading.apply = [&](double load) {
    load_now = load;
    if (fluid) {
      s->pressurise(1e6 * load);
    } else {
      s->load_sides(load);
    }
  };
  loading.stress = [&] { return 1e6 * load_now; };
  // Under constant load a slit that has grown by a third of the ligament does not stop any more.
  const double ligament =
      notch ? (1.0 - spec.slit_fraction) * spec.width : 0.5 * (1.0 - spec.slit_fraction) * spec.width;
  loading.runaway = std::max<std::int64_t>(
      6, static_cast<std::int64_t>(ligament / (6.0 * s->assembly().mean_radius)) * (notch ? 1 : 2));
  take_loading(result, load_to_failure(*s, loading, interrupt));

  LabReport& r = result.report;
  const Vec2 tips = s->tips();
  r.slit_half_length = notch ? tips.y : 0.5 * (tips.y - tips.x);
  const double share = (notch ? 1.0 : 2.0) * r.slit_half_length / spec.width;
  r.geometry_factor = crack_geometry_factor(spec.test, share);
  r.value = r.geometry_factor * r.peak_stress * std::sqrt(pi * r.slit_half_length);
  const auto& a = s->assembly();
  const double strength = 0.5 * a.tensile_per_radius;
  r.toughness_coefficient = r.value / (strength * std::sqrt(a.mean_radius));
  if (fluid) {
    // Opening of the slit as cut: a fresh specimen, far from failure.
    Specimen fresh(packing, material, shape);
    result.opening_pressure = 0.01 * r.peak_stress;
    fresh.pressurise(result.opening_pressure);
    fresh.solve(1e300, interrupt);
    result.opening = fresh.opening();
  }
  result.specimen = std::move(s);
  return result;
}

}  // namespace hfrac
