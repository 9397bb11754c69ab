// SPDX-License-Identifier: BSD-3-Clause
// A wellbore with friction between it and its holes: one pressure, a storage, and a cluster of perforations at each of its wells.
//
// From the wellbore to the hole of a cluster the pressure falls by
//     dp = 8 rho Q |Q| / (pi^2 n^2 D^4 C_d^2) + k sqrt(|Q|) sign(Q),     Q = q h     [m3/s],
// perforations as orifices (Crump and Conway 1988; Economides and Nolte 2000, ch. 6) and what the way from them into the fracture takes
// (tortuosity). q [m2/s] is the rate per thickness of the plane, h the well's length it is spread over. Slow flow through an orifice is
// laminar: a term linear in Q takes over below 1e-8 m2/s, so that the law has a finite slope at rest.
//
// Wells without friction and with a wellbore of their own are none of these: wellbore and hole are one, and the storage is the hole's.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace hfrac {

struct WellFriction {
  double square = 0.0;  // Pa s2/m4: dp = square q^2
  double root = 0.0;    // Pa (s/m2)^0.5: dp = root sqrt(q)

  [[nodiscard]] bool any() const { return square > 0.0 || root > 0.0; }
  [[nodiscard]] double drop(double rate) const;  // Pa
  // Rate [m2/s] under a pressure drop [Pa], and its change with it [m2/(Pa s)].
  struct Response {
    double rate, slope;
  };
  [[nodiscard]] Response respond(double drop) const;
};

// What a well's numbers make of the law; a length of 0 is 1 m, a coefficient of 0 is 0.6.
WellFriction well_friction(double density, double count, double diameter, double discharge, double near_well,
                           double height);

struct Cluster {
  std::int64_t well = 0;  // number of the well
  std::int32_t domain = 0;
  WellFriction friction;
  double rate = 0.0;                 // m2/s into the hole, in the last increment: state
  double square_of[2] = {0.0, 0.0};  // friction.square with either fluid in the perforations
};

struct Wellbore {
  std::vector<Cluster> clusters;  // the first one's well drives it
  double storage = 0.0;           // m2/Pa
  double start_pressure = 0.0;    // Pa, of content 0
  // State:
  double pressure = 0.0;   // Pa
  double content = 0.0;    // m2 more than at the start
  double pumped = 0.0;     // m2 since the model came to rest
  double taken = 0.0;      // m2 pumped in the increments of the step so far
  double pump_rate = 0.0;  // m2/s, mean of the last step
  // As driven in the step at hand:
  bool held = false;  // at `pressure`
  double rate = 0.0;  // m2/s that the pump gives; not held
};

}  // namespace hfrac
