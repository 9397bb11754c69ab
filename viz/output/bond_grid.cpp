// SPDX-License-Identifier: BSD-3-Clause
// bonds_*.vtu: one line per bonded contact, whole or broken. The pipe that crosses a bond has the bond's
// index.
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>

#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {

std::string bond_vtu(const SnapshotFrame& frame) {
  const auto discs = integers(frame.sim, HFRAC_BOND_DISCS);
  const size_t count = discs.size() / 2;

  vtkNew<vtkUnstructuredGrid> grid;
  set_points(*grid, frame.positions);
  set_cells(*grid, VTK_LINE, even_offsets(count, 2), discs);
  auto& data = *grid->GetCellData();
  add_integers(data, "state", integers(frame.sim, HFRAC_BOND_STATE));
  add_floats(data, "normal_force_N", "N", doubles(frame.sim, HFRAC_BOND_NORMAL_FORCE));
  add_floats(data, "shear_force_N", "N", doubles(frame.sim, HFRAC_BOND_SHEAR_FORCE));
  add_floats(data, "moment_Nm", "N m", doubles(frame.sim, HFRAC_BOND_MOMENT));
  add_floats(data, "gap_m", "m", doubles(frame.sim, HFRAC_BOND_GAP));
  add_floats(data, "aperture_m", "m", doubles(frame.sim, HFRAC_PIPE_APERTURE));
  add_floats(data, "flow_m2_per_s", "m2/s", doubles(frame.sim, HFRAC_PIPE_FLOW));
  add_numbering(data, "bond_id", count);
  return encode(*grid, frame.state, frame.wells);
}

}  // namespace hfrac::output
