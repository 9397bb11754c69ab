// SPDX-License-Identifier: BSD-3-Clause
// The rock laboratory and the calibration from C.
#include "hfrac/lab.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <string>

#include "def_image.hpp"
#include "frac/fractures.hpp"
#include "internal.hpp"
#include "lab/calibration.hpp"
#include "lab/laboratory.hpp"

using namespace hfrac;
using namespace hfrac::capi;

struct hfrac_lab : HandleBase {
  LabResult result;
};

namespace {

static_assert(HFRAC_MACRO_COUNT == macro_count);
static_assert(HFRAC_LAB_PERMEABILITY + 1 == lab_test_count);

// Asks the host now and then whether to go on.
class Patience {
 public:
  Patience(hfrac_progress_fn function, void* user, const char* what)
      : function_(function), user_(user), what_(what) {}
  bool stop() {
    if (function_ == nullptr || stopped_) return stopped_;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return false;
    last_ = now;
    stopped_ = call_host(nullptr, [&] { return function_(user_, 0.0, what_); }) != 0;
    return stopped_;
  }

 private:
  hfrac_progress_fn function_;
  void* user_;
  const char* what_;
  std::chrono::steady_clock::time_point last_;
  bool stopped_ = false;
};

hfrac_lab_spec default_spec() {
  const LabSpec from;
  hfrac_lab_spec spec{};
  spec.struct_size = sizeof spec;
  spec.test = static_cast<std::int32_t>(from.test);
  spec.disc_count = from.discs;
  spec.seed = from.seed;
  spec.width = from.width;
  spec.confining = from.confining;
  spec.slit_fraction = from.slit_fraction;
  return spec;
}

hfrac_targets default_targets() {
  const CalibrationTargets from;
  hfrac_targets targets{};
  targets.struct_size = sizeof targets;
  targets.modulus = targets.poisson = targets.compressive_strength = targets.tensile_strength =
      targets.toughness = targets.permeability = std::numeric_limits<double>::quiet_NaN();
  targets.packings = from.packings;
  targets.disc_count = from.discs;
  targets.strength_disc_count = from.strength_discs;
  targets.seed = from.seed;
  return targets;
}

hfrac_lab_report describe(const LabReport& r) {
  hfrac_lab_report to{};
  to.struct_size = sizeof to;
  to.end = static_cast<std::int32_t>(r.end);
  to.value = r.value;
  to.modulus = r.modulus;
  to.poisson = r.poisson;
  to.plane_modulus = r.plane_modulus;
  to.plane_poisson = r.plane_poisson;
  to.peak_stress = r.peak_stress;
  to.strain_at_peak = r.strain_at_peak;
  to.first_crack_stress = r.first_crack_stress;
  to.slit_half_length = r.slit_half_length;
  to.geometry_factor = r.geometry_factor;
  to.toughness_coefficient = r.toughness_coefficient;
  to.permeability_x = r.permeability_x;
  to.permeability_y = r.permeability_y;
  to.zero_stress_aperture = r.zero_stress_aperture;
  to.mean_radius = r.mean_radius;
  to.coordination = r.coordination;
  to.force_ratio = r.force_ratio;
  to.worst_overshoot = r.worst_overshoot;
  to.packing_seconds = r.packing_seconds;
  to.test_seconds = r.test_seconds;
  to.disc_count = r.discs;
  to.bond_count = r.bonds;
  to.tensile_cracks = r.tensile_cracks;
  to.shear_cracks = r.shear_cracks;
  to.factor_count = r.factors;
  to.relaxation_count = r.relaxations;
  return to;
}

std::vector<double> table_of(const LabResult& result, std::int32_t table) {
  std::vector<double> values;
  const auto row = [&](std::initializer_list<double> more) { values.insert(values.end(), more); };
  switch (table) {
    case HFRAC_LAB_CURVE:
      for (const auto& p : result.curve) {
        row({p.load, p.stress, p.axial, p.lateral, p.excess, static_cast<double>(p.tensile),
             static_cast<double>(p.shear)});
      }
      break;
    case HFRAC_LAB_DISCS:
      if (!result.specimen) break;
      for (std::size_t i = 0; i < result.specimen->assembly().x.size(); ++i) {
        const auto& a = result.specimen->assembly();
        row({a.x[i], a.y[i], a.radius[i], a.ux[i], a.uy[i]});
      }
      break;
    case HFRAC_LAB_CRACKS:
      if (!result.specimen) break;
      for (const auto& crack : result.specimen->cracks()) {
        const auto line = crack_line(result.specimen->assembly(), result.specimen->options(), crack.bond);
        const Vec2 along{-0.5 * line.length * line.normal.y, 0.5 * line.length * line.normal.x};
        const Vec2 from = line.middle - along, to = line.middle + along;
        row({from.x, from.y, to.x, to.y, static_cast<double>(crack.mode)});
      }
      break;
    case HFRAC_LAB_OPENING:
      for (const auto& p : result.opening) row({p.x, p.y, result.opening_pressure});
      break;
    default:
      throw Error(ErrorKind::argument,
                  "table = " + std::to_string(table) +
                      " is no table of a test; give one of enum hfrac_lab_table, 0 to 3.");
  }
  return values;
}

}  // namespace

int32_t hfrac_lab_spec_init(hfrac_lab_spec* spec, int32_t struct_size) {
  return guarded([&] { put_defaults(spec, struct_size, default_spec(), "spec"); });
}

int32_t hfrac_targets_init(hfrac_targets* targets, int32_t struct_size) {
  return guarded([&] { put_defaults(targets, struct_size, default_targets(), "targets"); });
}

int32_t hfrac_lab_run(const hfrac_sim_def* def, const hfrac_lab_spec* spec, hfrac_progress_fn progress,
                      void* user, hfrac_lab** lab) {
  return guarded([&]() -> std::int32_t {
    require_not_null(lab, "lab");
    *lab = nullptr;
    const CaseDefinition definition = case_of(read_def(def));
    check_ranges(definition);
    const hfrac_lab_spec given = read_struct(spec, default_spec(), "hfrac_lab_spec");
    const LabSpec what{LabTest{given.test}, given.disc_count, given.seed,
                       given.width,         given.confining,  given.slit_fraction};
    auto handle = std::make_unique<hfrac_lab>();
    Patience patience(progress, user, "testing a specimen");
    handle->result = run_lab(definition.options, what, [&] { return patience.stop(); });
    const bool stopped = handle->result.report.end == TestEnd::stopped;
    *lab = handle.release();
    return stopped ? HFRAC_STOPPED : HFRAC_OK;
  });
}

int32_t hfrac_lab_destroy(hfrac_lab** lab) {
  return guarded([&] {
    if (lab == nullptr || *lab == nullptr) return;
    require_handle(*lab);
    delete *lab;
    *lab = nullptr;
  });
}

int32_t hfrac_lab_get_report(const hfrac_lab* lab, hfrac_lab_report* report) {
  return guarded([&] {
    require_handle(lab);
    write_struct(report, describe(lab->result.report), "hfrac_lab_report");
  });
}

int32_t hfrac_lab_copy_f64(const hfrac_lab* lab, int32_t table, double* buffer, int64_t capacity,
                           int64_t* count) {
  return guarded([&] {
    require_handle(lab);
    require_not_null(count, "count");
    const std::vector<double> values = table_of(lab->result, table);
    *count = static_cast<std::int64_t>(values.size());
    if (buffer == nullptr) return;
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    std::copy_n(values.begin(), std::min(*count, capacity), buffer);
  });
}

int32_t hfrac_calibrate(hfrac_sim_def* def, const hfrac_targets* targets, hfrac_progress_fn progress,
                        void* user, hfrac_calibration* calibration) {
  return guarded([&]() -> std::int32_t {
    hfrac_sim_def full = read_def(def);
    const CaseDefinition definition = case_of(full);
    check_ranges(definition);
    const hfrac_targets t = read_struct(targets, default_targets(), "hfrac_targets");
    CalibrationTargets wanted;
    wanted.target = {t.modulus,          t.poisson,   t.compressive_strength,
                     t.tensile_strength, t.toughness, t.permeability};
    wanted.plane_slopes = t.plane_slopes != 0;
    wanted.packings = t.packings;
    wanted.discs = t.disc_count;
    wanted.strength_discs = t.strength_disc_count;
    wanted.seed = t.seed;
    require_not_null(calibration, "calibration");
    require_struct_size(calibration->struct_size, "hfrac_calibration");  // not after minutes of work
    Patience patience(progress, user, "calibrating");
    const CalibrationResult found =
        calibrate(definition, wanted, [&](std::int64_t /*tests*/) { return patience.stop(); });
    hfrac_calibration to{};
    to.struct_size = sizeof to;
    to.reached = !found.stopped && found.text.empty() ? 1 : 0;
    std::copy(found.achieved.begin(), found.achieved.end(), to.achieved);
    std::copy(found.spread.begin(), found.spread.end(), to.spread);
    std::copy(found.lowest.begin(), found.lowest.end(), to.lowest);
    std::copy(found.highest.begin(), found.highest.end(), to.highest);
    to.zero_stress_aperture = found.zero_stress_aperture;
    to.toughness_coefficient = found.toughness_coefficient;
    to.seconds = found.seconds;
    to.test_count = found.tests;
    copy_text(found.text, to.text, sizeof to.text, nullptr);
    write_struct(calibration, to, "hfrac_calibration");
    if (found.stopped) return HFRAC_STOPPED;
    put_options(found.options, full);
    write_def(def, full, "def");
    return HFRAC_OK;
  });
}
