// SPDX-License-Identifier: BSD-3-Clause
// The fields of hfrac/field.h as arrays of the run folder's files.
//
// HFRAC_FIELD_LIST of that header is the one list: a field added there is in the VTU files, so in ParaView, in `hfrac render
// --view` and on the page, in the tables of `hfrac export`, and in the bindings, which are generated from the header. A name
// in a file is the field's without its location, with the unit at its end: domain.pressure is pressure_Pa.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hfrac::run {

enum class Location : int32_t { disc = 0, bond = 1, pipe = 2, domain = 3, corner = 4, joint = 5 };

struct Field {
  int32_t number;         ///< enum hfrac_field
  std::string_view key;   ///< "domain.pressure"
  std::string_view unit;  ///< SI; "1" for none
  Location location;
  bool real;  ///< doubles, else 32-bit integers
  int32_t components;
};

std::span<const Field> all_fields();

/** Those that snapshots show at `location`: all but what makes the geometry of a grid (positions, corners) and what tells
 * nothing about the rock at a moment. */
std::vector<Field> shown_fields(Location location);

/** "normal_force" for bond.normal_force. */
std::string_view bare_name(const Field& field);
/** "_N", "_m2_per_s"; empty for "1". */
std::string unit_ending(std::string_view unit);
/** "normal_force_N" */
std::string array_name(const Field& field);
/** Names of the components in a VTU file: x, y, z (a plane's vectors get a zero there) or xx, yy, xy; empty for scalars. */
std::vector<const char*> component_names(const Field& field);
/** The name of one component in a table: stress_xy_Pa; x_m of a position; disc_0 of several indices. */
std::string column_name(const Field& field, int32_t component);

}  // namespace hfrac::run
