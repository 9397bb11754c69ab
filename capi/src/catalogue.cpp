// SPDX-License-Identifier: BSD-3-Clause
// The seismic catalogue from C: cracks or slips in, events out.
#include "hfrac/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "frac/catalogue.hpp"
#include "frac/slip_events.hpp"
#include "internal.hpp"
#include "items.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

void require_at_least_zero(double value, const char* name) {
  if (!std::isfinite(value) || value < 0.0) {
    throw Error(ErrorKind::argument, std::string(name) + " = " + std::to_string(value) +
                                         " must be finite and 0 or more; 0 takes the default.");
  }
}

// So many items are in no host's memory; whoever says so has mixed up its arguments.
void require_fits(std::int64_t count, std::size_t bytes_each, const char* name) {
  const std::int64_t most = PTRDIFF_MAX / static_cast<std::int64_t>(bytes_each);
  if (count <= most) return;
  throw Error(ErrorKind::argument, std::string(name) + " = " + std::to_string(count) + " is above " +
                                       std::to_string(most) +
                                       ", more than memory can hold; give the number of items.");
}

// With the defaults filled in.
hfrac_catalogue_options read_options(const hfrac_catalogue_options* options) {
  hfrac_catalogue_options given{};
  if (options != nullptr) given = read_struct(options, given, "hfrac_catalogue_options");
  require_at_least_zero(given.distance, "distance");
  require_at_least_zero(given.time_window, "time_window");
  require_at_least_zero(static_cast<double>(given.cycle_window), "cycle_window");
  require_at_least_zero(given.thickness, "thickness");
  require_at_least_zero(given.shear_modulus, "shear_modulus");
  require_at_least_zero(given.slip_rate, "slip_rate");
  if (given.thickness == 0.0) given.thickness = 1.0;
  return given;
}

CatalogueRule rule_of(const hfrac_catalogue_options* options) {
  const auto given = read_options(options);
  return {{given.distance, given.time_window, given.cycle_window}, given.thickness};
}

CatalogueCrack crack_of(const hfrac_crack& from, std::int64_t index) {
  CatalogueCrack crack;
  crack.position = {from.position[0], from.position[1]};
  crack.normal = {from.normal[0], from.normal[1]};
  crack.distance = from.distance;
  crack.normal_force = from.normal_force;
  crack.shear_force = from.shear_force;
  crack.energy = from.energy;
  crack.length = from.length;
  crack.time = from.time;
  crack.cycle = from.cycle;
  crack.tensile = from.mode == HFRAC_CRACK_TENSION;
  const double sum = crack.position.x + crack.position.y + crack.normal.x + crack.normal.y + crack.distance +
                     crack.normal_force + crack.shear_force + crack.energy + crack.length + crack.time;
  if (!std::isfinite(sum) || crack.distance < 0.0) {
    throw Error(ErrorKind::argument, "cracks[" + std::to_string(index) +
                                         "] holds a value that is not finite, or a negative distance between "
                                         "its discs; give cracks as hfrac_cracks_since does.");
  }
  return crack;
}

CatalogueSlip slip_of(const hfrac_slip& from, double shear_modulus, std::int64_t index) {
  CatalogueSlip slip;
  slip.position = {from.position[0], from.position[1]};
  slip.normal = {from.normal[0], from.normal[1]};
  slip.length = from.length;
  slip.slip = from.slip;
  slip.disc_distance = from.distance;
  slip.shear_modulus = shear_modulus > 0.0 ? shear_modulus : from.shear_modulus;
  slip.time = from.time;
  slip.duration = from.duration;
  slip.id = from.id;
  slip.bond = from.bond;
  const double sum = slip.position.x + slip.position.y + slip.normal.x + slip.normal.y + slip.length +
                     slip.slip + slip.disc_distance + slip.shear_modulus + slip.time + slip.duration;
  if (!std::isfinite(sum) || slip.disc_distance < 0.0 || slip.length < 0.0 || slip.duration < 0.0) {
    throw Error(ErrorKind::argument,
                "slips[" + std::to_string(index) +
                    "] holds a value that is not finite, or a negative length, duration or distance between "
                    "its discs; give slips as hfrac_slips_since does.");
  }
  return slip;
}

hfrac_event describe(const SeismicEvent& from, std::int64_t index) {
  hfrac_event to{};
  to.index = index;
  to.first_crack = from.first_crack;
  to.crack_count = from.crack_count;
  to.tensile_cracks = from.tensile_cracks;
  to.first_cycle = from.first_cycle;
  to.last_cycle = from.last_cycle;
  to.time = from.time;
  to.position[0] = from.position.x;
  to.position[1] = from.position.y;
  to.moment_tensor[0] = from.xx;
  to.moment_tensor[1] = from.yy;
  to.moment_tensor[2] = from.xy;
  to.moment = from.moment;
  to.magnitude = from.magnitude;
  to.energy = from.energy;
  to.energy_magnitude = from.energy_magnitude;
  to.isotropic_fraction = from.isotropic_fraction;
  to.length = from.length;
  to.radius = from.radius;
  to.kind = static_cast<std::int32_t>(from.kind);
  to.first_slip = from.first_slip;
  to.slip_count = from.slip_count;
  to.slip = from.slip;
  to.duration = from.duration;
  return to;
}

void require_count(std::int64_t count, const char* name) {
  if (count < 0) throw Error(ErrorKind::argument, std::string(name) + " is negative.");
}

std::vector<CatalogueCrack> cracks_of(const hfrac_crack* cracks, std::int32_t size, std::int64_t count) {
  require_count(count, "crack_count");
  if (count > 0) require_not_null(cracks, "cracks");
  require_item_size(size, "crack_size");
  require_fits(count, static_cast<std::size_t>(size), "crack_count");
  if (size < static_cast<std::int32_t>(offsetof(hfrac_crack, distance) + sizeof(double))) {
    throw Error(ErrorKind::struct_size, "crack_size = " + std::to_string(size) +
                                            " is that of a hfrac_crack without `distance`; compile against a "
                                            "header that has it.");
  }
  std::vector<CatalogueCrack> list;
  list.reserve(static_cast<std::size_t>(count));
  for (std::int64_t c = 0; c < count; ++c) list.push_back(crack_of(take_item(cracks, c, size), c));
  return list;
}

std::vector<CatalogueSlip> slips_of(const hfrac_slip* slips, std::int32_t size, std::int64_t count,
                                    double shear_modulus) {
  require_count(count, "slip_count");
  if (count > 0) require_not_null(slips, "slips");
  require_item_size(size, "slip_size");
  require_fits(count, static_cast<std::size_t>(size), "slip_count");
  std::vector<CatalogueSlip> list;
  for (std::int64_t k = 0; k < count; ++k) {
    const hfrac_slip slip = take_item(slips, k, size);
    if (slip.step != 0) list.push_back(slip_of(slip, shear_modulus, k));
  }
  return list;
}

void put_events(const std::vector<SeismicEvent>& events, std::int32_t event_size, hfrac_event* buffer,
                std::int64_t capacity, std::int64_t* count) {
  *count = static_cast<std::int64_t>(events.size());
  if (buffer == nullptr) return;
  require_count(capacity, "capacity");
  for (std::int64_t e = 0; e < std::min(capacity, *count); ++e)
    put_item(buffer, e, event_size, describe(events[static_cast<std::size_t>(e)], e));
}

}  // namespace

int32_t hfrac_find_events(const hfrac_crack* cracks, int32_t crack_size, int64_t crack_count,
                          const hfrac_catalogue_options* options, int32_t event_size, hfrac_event* buffer,
                          int64_t capacity, int64_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    require_item_size(event_size, "event_size");
    std::vector<std::int64_t> event_of;
    put_events(find_events(cracks_of(cracks, crack_size, crack_count), rule_of(options), event_of),
               event_size, buffer, capacity, count);
  });
}

int32_t hfrac_find_slip_events(const hfrac_slip* slips, int32_t slip_size, int64_t slip_count,
                               const hfrac_catalogue_options* options, int32_t event_size,
                               hfrac_event* buffer, int64_t capacity, int64_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    require_item_size(event_size, "event_size");
    const auto given = read_options(options);
    put_events(find_slip_events(slips_of(slips, slip_size, slip_count, given.shear_modulus),
                                {{given.distance, given.time_window, 0}, given.thickness, given.slip_rate}),
               event_size, buffer, capacity, count);
  });
}

int32_t hfrac_find_event_of_cracks(const hfrac_crack* cracks, int32_t crack_size, int64_t crack_count,
                                   const hfrac_catalogue_options* options, int64_t* buffer, int64_t capacity,
                                   int64_t* count) {
  return guarded([&] {
    require_not_null(count, "count");
    std::vector<std::int64_t> event_of;
    find_events(cracks_of(cracks, crack_size, crack_count), rule_of(options), event_of);
    *count = crack_count;
    if (buffer == nullptr) return;
    require_count(capacity, "capacity");
    std::copy_n(event_of.begin(), std::min(capacity, crack_count), buffer);
  });
}

int32_t hfrac_find_magnitude_law(const double* magnitudes, int64_t magnitude_count, double completeness,
                                 hfrac_magnitude_law* law) {
  return guarded([&] {
    require_count(magnitude_count, "magnitude_count");
    require_fits(magnitude_count, sizeof(double), "magnitude_count");
    if (magnitude_count > 0) require_not_null(magnitudes, "magnitudes");
    if (std::isinf(completeness)) {
      throw Error(ErrorKind::argument,
                  "completeness is infinite; give a magnitude, or NaN to have it found.");
    }
    const MagnitudeLaw found =
        magnitude_law({magnitudes, static_cast<std::size_t>(magnitude_count)}, completeness);
    hfrac_magnitude_law full{};
    full.completeness = found.completeness;
    full.b = found.b;
    full.b_error = found.b_error;
    full.a = found.a;
    full.count = found.count;
    write_struct(law, full, "hfrac_magnitude_law");
  });
}
