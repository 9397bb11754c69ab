// SPDX-License-Identifier: BSD-3-Clause
// A model packed once and kept: its discs, what was measured of the rock that they make, and their state at rest under the far field, so
// that many runs begin from it (`hfrac pack`, packing.file).
//
// Setting up is packing, bringing to rest, and what depends on fluid and fractures. The first two take nearly all of the time and do not
// depend on how wells are driven, on viscosity, permeability or toughness at tips; they are what is kept. The last is done anew in every run,
// and so is bonding, which is quick. A simulation from a kept model has the bits of one set up from the beginning.
//
// A model fits a case if all that its making depended on is the same; the rest may differ. What differs is refused by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geom/packing.hpp"
#include "model/smooth_contacts.hpp"
#include "options/options.hpp"

namespace hfrac {

// What a block of the packing without holes told (rock_block.hpp), as far as it was asked.
struct RockAtRest {
  double modulus = 0.0, poisson = 0.0;  // Pa, 1: E' and nu'
  std::vector<Vec2> rim;                // m: where the far field alone leaves the outermost discs
};

struct PackedModel {
  struct Value {
    std::string key;
    double value = 0.0;
  };
  // What it was made from: options (fracture.law as decided), wells and joints in the order of their tables.
  std::vector<Value> options;
  std::vector<std::vector<double>> wells, joints;

  Packing packing;
  std::vector<std::int64_t> bonds;  // of a host's list: two indices each; empty: all that are near

  RockAtRest rock;

  std::vector<SettledContact> settled;  // of joints that conduct
  std::vector<std::byte> state;         // of visit_state, at rest

  // With its law of fractures decided.
  void take_definition(const CaseDefinition& definition);
};

std::vector<std::byte> bytes_of(const PackedModel& model);
// Throws Error(argument) for what is not such bytes. Without its state where `discs_alone`.
PackedModel packed_model(std::span<const std::byte> bytes, bool discs_alone = false);

// Throws Error(model) unless the model fits the case: its packing alone where packing.reuse says so. `definition` with its law decided.
void require_fit(const PackedModel& model, const CaseDefinition& definition);

}  // namespace hfrac
