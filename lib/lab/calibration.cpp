// SPDX-License-Identifier: BSD-3-Clause
#include "lab/calibration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/error.hpp"
#include "lab/laboratory.hpp"
#include "options/choices.hpp"
#include "options/number_text.hpp"

namespace hfrac {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double specimen_width = 10.0;                 // m, of specimens; nothing but R over it counts
constexpr double least_ratio = 0.02, most_ratio = 5.0;  // k_s / k_n looked at
constexpr double least_strengths = 0.25, most_strengths = 4.0;  // tau_c / sigma_c looked at
constexpr double poisson_tolerance = 5e-4, ratio_tolerance = 0.02;

// What makes UCS over tensile strength larger, in order: bending that breaks no bond and contacts that hinder rolling; closed
// cracks, which take more of the tensile strength than of the UCS; friction of rock on rock (Byerlee 1978), and that of rough faces under low stress (Barton 1973).
struct HarderRock {
  double open_share, friction;
};
constexpr HarderRock harder_rocks[] = {{0.0, 0.0}, {0.15, 0.0}, {0.3, 0.0}, {0.3, 0.85}, {0.3, 1.2}};

struct Stop {};

struct Mean {
  double value = 0.0, spread = 0.0;
};
Mean mean_of(const std::vector<double>& values) {
  Mean m;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) m.value += v / n;
  for (const double v : values) m.spread += (v - m.value) * (v - m.value);
  m.spread = values.size() > 1 ? std::sqrt(m.spread / (n - 1.0)) : 0.0;
  return m;
}

class Calibrator {
 public:
  Calibrator(const CaseDefinition& definition, const CalibrationTargets& targets,
             const std::function<bool(std::int64_t)>& step)
      : targets_(targets), step_(step), started_(definition.options) {
    result_.options = definition.options;
    result_.options.bond_fracture_toughness = result_.options.bond_toughness_reference_radius = 0.0;
    for (auto* values : {&result_.achieved, &result_.spread, &result_.lowest, &result_.highest})
      values->fill(unknown);
    result_.reachable.fill(true);
  }

  CalibrationResult run() {
    const auto start = std::chrono::steady_clock::now();
    try {
      if (asked(Macro::modulus) || asked(Macro::poisson)) fit_elastic();
      if (asked(Macro::compressive) || asked(Macro::tensile)) fit_strength();
      if (asked(Macro::toughness)) fit_toughness();
      if (asked(Macro::permeability)) result_.options.flow_permeability = target(Macro::permeability);
      verify();
    } catch (const Stop&) {
      result_.stopped = true;
    }
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result_;
  }

 private:
  [[nodiscard]] double target(Macro m) const { return targets_.target[static_cast<std::size_t>(m)]; }
  [[nodiscard]] bool asked(Macro m) const { return !std::isnan(target(m)); }

  LabReport test(LabTest which, const Options& material, std::int64_t seed) {
    if (step_ && step_(result_.tests)) throw Stop{};
    ++result_.tests;
    LabSpec spec;
    spec.test = which;
    spec.width = specimen_width;
    spec.seed = seed;
    spec.end_share = 0.85;  // only the peak is wanted
    spec.discs = which == LabTest::elastic || which == LabTest::permeability ? targets_.discs
                                                                             : targets_.strength_discs;
    const auto key = std::pair(specimen_aspect(which) * static_cast<double>(spec.discs), seed);
    auto& packing = packings_[key];
    if (packing.x.empty()) packing = pack_specimen(material, which, specimen_width, spec.discs, seed);
    LabReport report = run_lab(material, spec, packing).report;
    if (report.end == TestEnd::no_equilibrium && which == LabTest::elastic)
      throw Error(ErrorKind::diverged, "no equilibrium was found in the elastic test of seed " +
                                           number_text(seed) + "; use other stiffnesses to start from");
    return report;
  }
  // Of the k-th packing calibrated on, or of the k-th of those that what is achieved is measured on.
  [[nodiscard]] std::int64_t seed_of(std::int64_t k, bool other) const {
    return targets_.seed + k + (other ? targets_.packings : 0);
  }
  template <class Value>
  Mean over_packings(LabTest which, const Options& material, const Value& value, bool other = false) {
    std::vector<double> values;
    for (std::int64_t k = 0; k < targets_.packings; ++k)
      values.push_back(value(test(which, material, seed_of(k, other))));
    return mean_of(values);
  }
  struct Elasticity {
    Mean modulus, poisson;
  };
  Elasticity elasticity(const Options& material, bool other) {
    std::vector<double> moduli, ratios;
    for (std::int64_t k = 0; k < targets_.packings; ++k) {
      const LabReport r = test(LabTest::elastic, material, seed_of(k, other));
      moduli.push_back(targets_.plane_slopes ? r.plane_modulus : r.modulus);
      ratios.push_back(targets_.plane_slopes ? r.plane_poisson : r.poisson);
    }
    return {mean_of(moduli), mean_of(ratios)};
  }

  // The start's stiffnesses, the bonds' k_s / k_n made `ratio` and the contacts' changed with it, then all by `scale`.
  Options with_stiffness(double ratio, double scale) const {
    Options o = result_.options;
    const double own = started_.bond_normal_stiffness > 0.0 && started_.bond_shear_stiffness > 0.0
                           ? started_.bond_shear_stiffness / started_.bond_normal_stiffness
                           : 1.0;
    o.contact_normal_stiffness = scale * started_.contact_normal_stiffness;
    o.bond_normal_stiffness = scale * started_.bond_normal_stiffness;
    o.contact_shear_stiffness = scale * ratio / own * started_.contact_shear_stiffness;
    o.bond_shear_stiffness = scale * ratio / own * started_.bond_shear_stiffness;
    return o;
  }

  void fit_elastic() {
    double ratio = started_.bond_shear_stiffness / std::max(started_.bond_normal_stiffness, 1e-300);
    double modulus = 0.0;
    const auto measure = [&](double at) {
      const Elasticity found = elasticity(with_stiffness(at, 1.0), false);
      modulus = found.modulus.value;
      return found.poisson.value;
    };
    if (asked(Macro::poisson)) {
      const auto m = static_cast<std::size_t>(Macro::poisson);
      // nu falls with the ratio: bracket, then false position (Illinois) on its logarithm.
      double low = std::log(least_ratio), high = std::log(most_ratio);
      const double most = measure(least_ratio), least = measure(most_ratio), wanted = target(Macro::poisson);
      result_.lowest[m] = least;
      result_.highest[m] = most;
      if (wanted > most || wanted < least) {
        ratio = wanted > most ? least_ratio : most_ratio;
        result_.reachable[m] = false;
      } else {
        double at_low = most - wanted, at_high = least - wanted, now = 1.0;
        int side = 0;
        for (int round = 0; round < 30 && std::abs(now) > poisson_tolerance; ++round) {
          const double middle = (low * at_high - high * at_low) / (at_high - at_low);
          ratio = std::exp(middle);
          now = measure(ratio) - wanted;
          if (now > 0.0) {
            low = middle;
            at_low = now;
            if (side == 1) at_high *= 0.5;
            side = 1;
          } else {
            high = middle;
            at_high = now;
            if (side == -1) at_low *= 0.5;
            side = -1;
          }
        }
      }
    }
    measure(ratio);
    const double scale = asked(Macro::modulus) ? target(Macro::modulus) / modulus : 1.0;
    result_.options = with_stiffness(ratio, scale);
  }

  Options with_strengths(double sigma, double ratio) const {
    Options o = result_.options;
    o.bond_tensile_strength = sigma;
    o.bond_shear_strength = ratio * sigma;
    return o;
  }

  [[nodiscard]] bool asks_ratio() const { return asked(Macro::compressive) && asked(Macro::tensile); }
  [[nodiscard]] double wanted_ratio() const { return target(Macro::compressive) / target(Macro::tensile); }

  // UCS over tensile strength, with tau_c at `at` sigma_c.
  double strengths_at(double at) {
    const auto peak = [](const LabReport& r) { return r.value; };
    const Options o = with_strengths(started_.bond_tensile_strength, at);
    if (asked(Macro::tensile)) tensile_ = over_packings(LabTest::tension, o, peak).value;
    if (asked(Macro::compressive)) compressive_ = over_packings(LabTest::uniaxial, o, peak).value;
    return asks_ratio() ? compressive_ / tensile_ : 0.0;
  }

  // Rock that is stronger in compression than the start's can be at any tau_c / sigma_c: one change more each time, until one
  // reaches what is asked. What each gives stands in docs/laboratory.md.
  void harden() {
    if (!asks_ratio()) return;
    const bool facets = FractureLaw{started_.fracture_law} == FractureLaw::facet;  // it takes round contacts
    for (const HarderRock& harder : harder_rocks) {
      most_ratio_ = strengths_at(most_strengths);
      if (most_ratio_ > wanted_ratio()) return;
      if (harder.open_share < started_.bond_open_share) continue;
      started_.bond_moment_contribution = 0.0;
      if (!facets) started_.contact_shape = static_cast<std::int64_t>(ContactShape::flat);
      started_.contact_friction = std::max(started_.contact_friction, harder.friction);
      started_.bond_open_share = harder.open_share;
      result_.options.bond_moment_contribution = started_.bond_moment_contribution;
      result_.options.contact_shape = started_.contact_shape;
      result_.options.contact_friction = started_.contact_friction;
      result_.options.bond_open_share = started_.bond_open_share;
      if (asked(Macro::modulus) || asked(Macro::poisson)) fit_elastic();
    }
    most_ratio_ = strengths_at(most_strengths);
  }

  void fit_strength() {
    const double sigma = started_.bond_tensile_strength;
    double ratio = started_.bond_shear_strength / sigma, scale = 1.0;
    harden();
    if (asks_ratio()) {
      const double wanted = wanted_ratio(), least = strengths_at(least_strengths), most = most_ratio_;
      double low = std::log(least_strengths), high = std::log(most_strengths);
      const auto t = static_cast<std::size_t>(Macro::tensile),
                 c = static_cast<std::size_t>(Macro::compressive);
      if (wanted <= least || wanted >= most) {
        ratio = wanted <= least ? least_strengths : most_strengths;
        result_.reachable[t] = result_.reachable[c] = false;
      } else {
        for (double found = 0.0; std::abs(found / wanted - 1.0) > ratio_tolerance && high - low > 0.02;) {
          ratio = std::exp(0.5 * (low + high));
          found = strengths_at(ratio);
          (found < wanted ? low : high) = std::log(ratio);
        }
      }
      strengths_at(ratio);
      // Both off by the same factor, if both cannot be had.
      scale = std::sqrt(target(Macro::tensile) / tensile_ * target(Macro::compressive) / compressive_);
      result_.lowest[c] = least * target(Macro::tensile);
      result_.highest[c] = most * target(Macro::tensile);
      result_.lowest[t] = target(Macro::compressive) / most;
      result_.highest[t] = target(Macro::compressive) / least;
    } else {
      strengths_at(ratio);
      scale = asked(Macro::tensile) ? target(Macro::tensile) / tensile_
                                    : target(Macro::compressive) / compressive_;
    }
    result_.options = with_strengths(scale * sigma, ratio);
  }

  void fit_toughness() {
    Options o = result_.options;
    const double c = over_packings(LabTest::centre_crack, o, [](const LabReport& r) {
                       return r.toughness_coefficient;
                     }).value;
    result_.toughness_coefficient = c;
    const double wanted = target(Macro::toughness), radius = expected_mean_radius(o);
    if (!asked(Macro::compressive) && !asked(Macro::tensile)) {
      const double shear = o.bond_shear_strength / o.bond_tensile_strength;
      result_.options = with_strengths(wanted / (c * std::sqrt(radius)), shear);
      return;
    }
    // Strengths are spoken for: the disc size is what is left.
    const double asked_radius = std::pow(wanted / (c * o.bond_tensile_strength), 2.0);
    const double count = static_cast<double>(o.packing_disc_count) * std::pow(radius / asked_radius, 2.0);
    const auto m = static_cast<std::size_t>(Macro::toughness);
    const double at_radius = c * o.bond_tensile_strength * std::sqrt(radius);
    const double discs = static_cast<double>(o.packing_disc_count);
    result_.lowest[m] = at_radius * std::pow(discs / most_model_discs, 0.25);
    result_.highest[m] = at_radius * std::pow(discs / fewest_model_discs, 0.25);
    result_.reachable[m] = count >= fewest_model_discs && count <= most_model_discs;
    result_.options.packing_disc_count =
        std::llround(std::clamp(count, fewest_model_discs, most_model_discs));
  }

  void verify() {
    const Options& o = result_.options;
    const auto put = [&](Macro m, Mean mean) {
      const auto k = static_cast<std::size_t>(m);
      result_.achieved[k] = mean.value;
      result_.spread[k] = mean.spread;
      if (!result_.reachable[k])
        explain(m);
      else if (std::abs(mean.value - target(m)) > tolerance(m, mean))
        explain_miss(m);
    };
    if (asked(Macro::modulus) || asked(Macro::poisson)) {
      const Elasticity found = elasticity(o, true);
      if (asked(Macro::modulus)) put(Macro::modulus, found.modulus);
      if (asked(Macro::poisson)) put(Macro::poisson, found.poisson);
    }
    const auto value = [](const LabReport& r) { return r.value; };
    if (asked(Macro::compressive)) put(Macro::compressive, over_packings(LabTest::uniaxial, o, value, true));
    if (asked(Macro::tensile)) put(Macro::tensile, over_packings(LabTest::tension, o, value, true));
    if (asked(Macro::toughness)) {
      const double at_model = o.bond_tensile_strength * std::sqrt(expected_mean_radius(o));
      put(Macro::toughness,
          over_packings(
              LabTest::centre_crack, o,
              [&](const LabReport& r) { return r.toughness_coefficient * at_model; }, true));
    }
    if (asked(Macro::permeability)) {
      double aperture = 0.0, radius = 0.0;
      put(Macro::permeability, over_packings(
                                   LabTest::permeability, o,
                                   [&](const LabReport& r) {
                                     aperture +=
                                         r.zero_stress_aperture / static_cast<double>(targets_.packings);
                                     radius = r.mean_radius;
                                     return r.value;
                                   },
                                   true));
      result_.zero_stress_aperture = aperture * std::cbrt(expected_mean_radius(o) / radius);
    }
  }

  void explain(Macro m) {
    const auto k = static_cast<std::size_t>(m);
    std::string text = std::string(macro_name[k]) + " = " + rounded_text(target(m)) + macro_unit[k] +
                       " cannot be reached: the nearest set has " + rounded_text(result_.achieved[k]) +
                       macro_unit[k];
    if (!std::isnan(result_.lowest[k])) {
      text += "; with the other targets as they are it lies between " + rounded_text(result_.lowest[k]) +
              " and " + rounded_text(result_.highest[k]) + macro_unit[k];
    }
    result_.text += (result_.text.empty() ? "" : ". ") + text;
  }

  // Packings differ: a target is missed if those not calibrated on are further off than a tenth, and than two standard errors
  // of their mean.
  [[nodiscard]] double tolerance(Macro m, const Mean& mean) const {
    const double error = mean.spread / std::sqrt(static_cast<double>(targets_.packings));
    return std::max(0.1 * std::abs(target(m)), 2.0 * error);
  }
  void explain_miss(Macro m) {
    const auto k = static_cast<std::size_t>(m);
    const std::string text = std::string(macro_name[k]) + " = " + rounded_text(target(m)) + macro_unit[k] +
                             " is missed: packings other than those calibrated on have " +
                             rounded_text(result_.achieved[k]) + macro_unit[k] +
                             " in the mean; calibrate on more packings or larger specimens";
    result_.text += (result_.text.empty() ? "" : ". ") + text;
  }

  static constexpr const char* macro_name[macro_count] = {"E",    "nu",          "UCS", "tensile strength",
                                                          "K_Ic", "permeability"};
  static constexpr const char* macro_unit[macro_count] = {" Pa", "", " Pa", " Pa", " Pa m^0.5", " m2"};
  static constexpr double fewest_model_discs = 500.0, most_model_discs = 5e6;

  CalibrationTargets targets_;
  std::function<bool(std::int64_t)> step_;
  Options started_;
  CalibrationResult result_;
  double tensile_ = 0.0, compressive_ = 0.0, most_ratio_ = 0.0;  // Pa, Pa, 1: as measured last
  std::map<std::pair<double, std::int64_t>, Packing> packings_;
};

void check(const CaseDefinition& definition, const CalibrationTargets& t) {
  static constexpr const char* name[macro_count] = {"modulus",          "poisson",   "compressive_strength",
                                                    "tensile_strength", "toughness", "permeability"};
  bool any = false;
  for (std::size_t k = 0; k < macro_count; ++k) {
    const double value = t.target[k];
    if (std::isnan(value)) continue;
    any = true;
    const double most = k == static_cast<std::size_t>(Macro::poisson) ? (t.plane_slopes ? 1.0 : 0.5) : 1e15;
    if (!(value > 0.0) || !(value < most)) {
      throw Error(ErrorKind::argument, std::string(name[k]) + " = " + number_text(value) +
                                           " is out of range; give a value between 0 and " +
                                           number_text(most) + ", or NaN not to ask for it.");
    }
  }
  if (!any) throw Error(ErrorKind::argument, "no target is given; give at least one.");
  if (t.packings < 1 || t.packings > 1000)
    throw Error(ErrorKind::argument, "packings = " + number_text(t.packings) + "; give 1 to 1000.");
  if (t.seed < 0) throw Error(ErrorKind::argument, "seed = " + number_text(t.seed) + "; give 0 or more.");
  const Options& o = definition.options;
  if (o.packing_coarsening > 1.0) {
    throw Error(
        ErrorKind::argument,
        "packing.coarsening = " + number_text(o.packing_coarsening) +
            " has no one disc size to calibrate strengths and apertures for; calibrate with 1, then set it: "
            "stiffnesses and bond.toughness_coefficient hold for discs of any size.");
  }
  if (!(o.bond_normal_stiffness > 0.0) || !(o.bond_shear_stiffness > 0.0) ||
      !(o.bond_tensile_strength > 0.0) || !(o.bond_shear_strength > 0.0)) {
    throw Error(ErrorKind::argument,
                "the material to start from has a bond stiffness or strength of 0; calibration keeps the "
                "bonds' share "
                "of the stiffness, so give bond.normal_stiffness, bond.shear_stiffness and both strengths.");
  }
}

}  // namespace

CalibrationResult calibrate(const CaseDefinition& definition, const CalibrationTargets& targets,
                            const std::function<bool(std::int64_t)>& step) {
  check(definition, targets);
  return Calibrator(definition, targets, step).run();
}

}  // namespace hfrac
