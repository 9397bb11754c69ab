// SPDX-License-Identifier: BSD-3-Clause
// What the four kinds of VTU files share: making an unstructured grid from plain vectors, and turning it into
// text.
//
// The files are inline binary with zlib level 1: every ParaView can read that, and a higher level costs time
// but no less space. Coordinates and times are doubles; all other numbers are floats, whose seven digits are
// more than a picture shows. Exact values are in the CSV files and behind the C interface.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cstdint>
#include <string>
#include <vector>

#include "output/engine_call.hpp"

namespace hfrac::output {

/** Points with z = 0 from x0 y0 x1 y1 ... */
void set_points(vtkUnstructuredGrid& grid, const std::vector<double>& positions);

/** Cells of one type. Cell i has the points connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1]. */
void set_cells(vtkUnstructuredGrid& grid, int cell_type, const std::vector<int32_t>& offsets,
               const std::vector<int32_t>& connectivity);

/** Offsets of `count` cells with `corners` points each. */
std::vector<int32_t> even_offsets(size_t count, int32_t corners);

/** Arrays with their unit as ParaView shows it (UNITS_LABEL). Values are flat, components innermost. */
void add_floats(vtkFieldData& data, const char* name, const char* unit, const std::vector<double>& values,
                const std::vector<const char*>& components = {});
void add_doubles(vtkFieldData& data, const char* name, const char* unit, const std::vector<double>& values);
void add_integers(vtkFieldData& data, const char* name, const std::vector<int32_t>& values);

/** 0, 1, 2, ... as the name a disc, bond, crack or domain has in every file. */
void add_numbering(vtkFieldData& data, const char* name, size_t count);

/** x0 y0 x1 y1 ... with a zero after each pair, since VTK knows vectors in space only. */
std::vector<double> in_space(const std::vector<double>& plane);

/** The file's text, with time, step and well pressures in its field data. */
std::string encode(vtkUnstructuredGrid& grid, const hfrac_sim_state& state,
                   const std::vector<hfrac_well_state>& wells);

}  // namespace hfrac::output
