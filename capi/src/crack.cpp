// SPDX-License-Identifier: BSD-3-Clause
// Cracks and fractures from C.
#include "hfrac/crack.h"

#include <algorithm>
#include <string>
#include <vector>

#include "internal.hpp"
#include "items.hpp"
#include "options/choices.hpp"
#include "sim_handle.hpp"
#include "step/simulation.hpp"

using namespace hfrac;
using namespace hfrac::capi;

namespace {

hfrac_crack describe(const Simulation& s, std::int64_t id) {
  const Crack& crack = s.cracks()[static_cast<std::size_t>(id)];
  const CrackLine line = crack_line(s.network(), s.assembly(), s.options(), crack.bond);
  hfrac_crack c{};
  c.id = id;
  c.bond = crack.bond;
  c.disc[0] = s.assembly().first[static_cast<std::size_t>(crack.bond)];
  c.disc[1] = s.assembly().second[static_cast<std::size_t>(crack.bond)];
  c.step = crack.step;
  c.cycle = crack.cycle;
  c.time = crack.time;
  c.position[0] = line.middle.x;
  c.position[1] = line.middle.y;
  c.normal[0] = line.normal.x;
  c.normal[1] = line.normal.y;
  c.length = line.length;
  c.aperture = line.aperture;
  c.normal_force = crack.normal_force;
  c.shear_force = crack.shear_force;
  c.energy = crack.energy;
  c.mode = static_cast<std::int32_t>(crack.mode);
  c.fracture = crack.fracture;
  const Network& n = s.network();
  const auto pipe = static_cast<std::size_t>(crack.bond);
  if (FlowScheme{s.options().flow_scheme} != FlowScheme::off) {
    c.pressure = 0.5 * (n.pressure[static_cast<std::size_t>(n.left[pipe])] +
                        n.pressure[static_cast<std::size_t>(n.right[pipe])]);
    c.hydraulic_aperture = n.aperture_of(pipe);
  }
  c.distance = s.assembly().length(static_cast<std::size_t>(crack.bond));
  return c;
}

hfrac_fracture describe(const Fracture& f, std::int64_t index) {
  return {.index = index,
          .crack_count = f.crack_count,
          .tensile_cracks = f.tensile_cracks,
          .length = f.length,
          .extent = f.extent,
          .reach = f.reach,
          .azimuth = f.azimuth,
          .mean_aperture = f.mean_aperture,
          .largest_aperture = f.largest_aperture,
          .volume = f.volume,
          .mean_pressure = f.mean_pressure,
          .well = f.well,
          .wings = f.wings};
}

hfrac_fracture_point describe(const FracturePoint& p) {
  hfrac_fracture_point c{};
  c.position[0] = p.at.x;
  c.position[1] = p.at.y;
  c.distance = p.distance;
  c.length = p.length;
  c.aperture = p.aperture;
  c.hydraulic_aperture = p.hydraulic_aperture;
  c.pressure = p.pressure;
  c.saturation = p.saturation;
  c.bond = p.bond;
  c.wing = p.wing;
  c.tip = p.tip ? 1 : 0;
  return c;
}

// The cracks' fractures, found anew where they may have changed since.
void number_cracks(hfrac_sim* sim) {
  if (!sim->in_callback && sim->numbered == sim->epoch) return;
  (void)sim->simulation->fractures();
  sim->numbered = sim->epoch;
}

}  // namespace

int32_t hfrac_cracks_since(hfrac_sim* sim, int64_t cursor, int32_t crack_size, hfrac_crack* buffer,
                           int64_t capacity, int64_t* count, int64_t* next) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    require_item_size(crack_size, "crack_size");
    const Simulation& s = *sim->simulation;
    const auto there = static_cast<std::int64_t>(s.cracks().size());
    if (cursor < 0 || cursor > there) {
      throw Error(ErrorKind::argument, "cursor = " + std::to_string(cursor) + " is outside 0 to " +
                                           std::to_string(there) + ", the cracks there are.");
    }
    if (buffer == nullptr) {
      *count = there - cursor;
      if (next != nullptr) *next = cursor;
      return;
    }
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    const std::int64_t taken = std::min(capacity, there - cursor);
    if (taken > 0) number_cracks(sim);
    for (std::int64_t k = 0; k < taken; ++k) put_item(buffer, k, crack_size, describe(s, cursor + k));
    *count = taken;
    if (next != nullptr) *next = cursor + taken;
  });
}

int32_t hfrac_fractures(hfrac_sim* sim, int32_t fracture_size, hfrac_fracture* buffer, int64_t capacity,
                        int64_t* count) {
  // Finding fractures numbers the cracks anew but moves nothing, so it counts as reading.
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    require_item_size(fracture_size, "fracture_size");
    const std::vector<Fracture> found = sim->simulation->fractures();
    sim->numbered = sim->epoch;
    *count = static_cast<std::int64_t>(found.size());
    if (buffer == nullptr) return;
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    const std::int64_t taken = std::min(capacity, *count);
    for (std::int64_t k = 0; k < taken; ++k)
      put_item(buffer, k, fracture_size, describe(found[static_cast<std::size_t>(k)], k));
  });
}

int32_t hfrac_fracture_line(hfrac_sim* sim, int64_t fracture, int32_t point_size,
                            hfrac_fracture_point* buffer, int64_t capacity, int64_t* count) {
  return guarded_sim(sim, Access::read, [&] {
    require_not_null(count, "count");
    require_item_size(point_size, "point_size");
    number_cracks(sim);
    std::int64_t there = 0;
    for (const Crack& crack : sim->simulation->cracks())
      there = std::max<std::int64_t>(there, crack.fracture + 1);
    if (fracture == 0 && there == 0) {
      *count = 0;
      return;
    }
    if (fracture < 0 || fracture >= there) {
      throw Error(ErrorKind::argument, "fracture = " + std::to_string(fracture) + " is outside 0 to " +
                                           std::to_string(there) + " - 1, the fractures there are.");
    }
    const auto line = sim->simulation->fracture_line(static_cast<std::int32_t>(fracture));
    *count = static_cast<std::int64_t>(line.size());
    if (buffer == nullptr) return;
    if (capacity < 0) throw Error(ErrorKind::argument, "capacity is negative.");
    for (std::int64_t k = 0; k < std::min(capacity, *count); ++k)
      put_item(buffer, k, point_size, describe(line[static_cast<std::size_t>(k)]));
  });
}
