// SPDX-License-Identifier: BSD-3-Clause
// discs_*.vtu: one vertex per disc; scale glyphs by radius_m to see the packing.
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <numeric>

#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {

std::string disc_vtu(const SnapshotFrame& frame) {
  const size_t count = frame.positions.size() / 2;
  std::vector<int32_t> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0);

  vtkNew<vtkUnstructuredGrid> grid;
  set_points(*grid, frame.positions);
  set_cells(*grid, VTK_VERTEX, even_offsets(count, 1), vertices);
  auto& data = *grid->GetPointData();
  add_floats(data, "radius_m", "m", doubles(frame.sim, HFRAC_DISC_RADIUS));
  add_floats(data, "displacement_m", "m", in_space(doubles(frame.sim, HFRAC_DISC_DISPLACEMENT)),
             {"x", "y", "z"});
  add_floats(data, "rotation_rad", "rad", doubles(frame.sim, HFRAC_DISC_ROTATION));
  add_floats(data, "stress_Pa", "Pa", doubles(frame.sim, HFRAC_DISC_STRESS), {"xx", "yy", "xy"});
  add_integers(data, "intact_bonds", integers(frame.sim, HFRAC_DISC_INTACT_BONDS));
  add_numbering(data, "disc_id", count);
  return encode(*grid, frame.state, frame.wells);
}

}  // namespace hfrac::output
