// SPDX-License-Identifier: BSD-3-Clause
// From options to a model that nothing loads yet: pack, cut the wells, bond, find the pores. step/initial_equilibration.hpp brings it
// to rest.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "geom/packing.hpp"
#include "model/model.hpp"
#include "options/options.hpp"

namespace hfrac {

// progress(fraction done, what): true asks to stop.
using Progress = std::function<bool(double, const char*)>;

// Thrown when progress asked to stop.
struct Stopped {};

// What building and the initial equilibration came to.
struct SetupReport {
  double packing_residual = 0.0, porosity = 0.0, coordination = 0.0, permeability = 0.0, force_ratio = 0.0;
  std::int64_t packed = 0, removed_in_wells = 0, removed_floaters = 0, removed_crossings = 0;
  std::int64_t unbonded = 0;                     // contacts that a host's list of bonds left out
  std::int64_t joints = 0, joints_left_out = 0;  // solid/joints.hpp
  std::int64_t fine_discs = 0;                   // packed where a graded packing is fine; uniform: all
  double coarsest_radius = 0.0;                  // m
  std::uint64_t bonded = 0;                      // hash of which contacts are bonded
  double plane_modulus = 0.0;  // Pa, E' at tips: fracture.plane_modulus as given or measured; 0: none
  double exterior_modulus = 0.0,
         exterior_poisson_ratio = 0.0;  // Pa, 1: E' and nu of the rock beyond; 0: none
  double packing_seconds = 0.0, setup_seconds = 0.0;
  std::string device,
      why_no_device;  // what runs the cycles, if not the processor; why run.device = "auto" found none
  std::int64_t cracks = 0,
               broken_joints = 0;  // of the cracks, bonds of joints that were broken from the start
};

// The host's own discs (x, y, radius each), or those of a packing made before, or else a packing by the options, which ranks may share.
Packing take_discs(const CaseDefinition& definition, std::span<const double> given_discs,
                   const Progress& progress, SetupReport& report, const Packing* made = nullptr,
                   const Ranks& ranks = {});

// Discs, bonds, joints, pores and wells of the definition; `given_bonds` (two indices each): which discs are bonded, empty for all
// that are near. Throws Error(model).
Model build_model(const CaseDefinition& definition, Packing packing,
                  std::span<const std::int64_t> given_bonds, SetupReport& report);

}  // namespace hfrac
