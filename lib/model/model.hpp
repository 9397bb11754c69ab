// SPDX-License-Identifier: BSD-3-Clause
// The model: all a simulation is made of, as plain data. What works on it (lib/solid, lib/flow, ...) keeps nothing of its own that
// a step changes, so that what visit_state walks is the state: kept before a step, put back, written to images, hashed.
#pragma once

#include <optional>
#include <vector>

#include "model/assembly.hpp"
#include "model/boundary_state.hpp"
#include "model/clock.hpp"
#include "model/contact_pairs.hpp"
#include "model/crack_log.hpp"
#include "model/heat_state.hpp"
#include "model/network.hpp"
#include "model/slip_log.hpp"
#include "model/well.hpp"
#include "model/wellbore.hpp"

namespace hfrac {

// The far field and the pressure of the pores outside, as they act now.
struct FarField {
  double sigma_Hmax = 0.0, sigma_hmin = 0.0;  // Pa along x and y, compression positive
  double formation_pressure = 0.0;            // Pa, absolute
  bool boundary_pressure_set = false;         // a host set the pressure beyond the outer boundary by cell
};

struct Model {
  Assembly assembly;           // discs and bonds
  Network network;             // pores and pipes
  ContactPairs contact_pairs;  // contacts that were never bonded
  BoundaryState boundary;      // walls and far-field loads
  FarField far_field;
  std::vector<Well> wells;
  std::vector<Wellbore> wellbores;  // those with friction or several clusters
  std::size_t well_count = 0;       // as built, whatever an image says
  CrackLog cracks;
  SlipLog slips;                  // of smooth joints
  std::optional<HeatState> heat;  // none with thermal.mode = "off"
  Clock clock;
  SolverWork work;
  IncrementState increment;
  Accounts accounts;
  StartState start;

  [[nodiscard]] std::vector<WellPlace> well_places() const;
  // How a well is driven: of a wellbore's clusters, as the first of them.
  [[nodiscard]] const WellDrive& drive_of(const Well& well) const {
    return well.wellbore < 0
               ? well.drive
               : wells[static_cast<std::size_t>(
                           wellbores[static_cast<std::size_t>(well.wellbore)].clusters.front().well)]
                     .drive;
  }
};

}  // namespace hfrac
