// SPDX-License-Identifier: BSD-3-Clause
// discs_*.vtu: one vertex per disc; scale glyphs by radius_m to see the packing.
#include <numeric>
#include <utility>

#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {

std::string disc_vtu(const SnapshotFrame& frame) {
  const size_t count = frame.positions.size() / 2;
  std::vector<int32_t> vertices(count);
  std::iota(vertices.begin(), vertices.end(), 0);

  VtuGrid grid;
  grid.positions = frame.positions;
  grid.offsets = even_offsets(count, 1);
  grid.connectivity = std::move(vertices);
  auto& data = grid.point_data;
  data.push_back(floats("radius_m", "m", doubles(frame.sim, HFRAC_DISC_RADIUS)));
  data.push_back(
      floats("displacement_m", "m", in_space(doubles(frame.sim, HFRAC_DISC_DISPLACEMENT)), {"x", "y", "z"}));
  data.push_back(floats("rotation_rad", "rad", doubles(frame.sim, HFRAC_DISC_ROTATION)));
  data.push_back(floats("stress_Pa", "Pa", doubles(frame.sim, HFRAC_DISC_STRESS), {"xx", "yy", "xy"}));
  data.push_back(whole("intact_bonds", integers(frame.sim, HFRAC_DISC_INTACT_BONDS)));
  if (frame.warm) data.push_back(floats("temperature_K", "K", doubles(frame.sim, HFRAC_DISC_TEMPERATURE)));
  data.push_back(numbering("disc_id", count));
  return encode(grid, frame.state, frame.wells, frame.coding);
}

}  // namespace hfrac::output
