// SPDX-License-Identifier: BSD-3-Clause
// cracks_*.vtu: one line per broken bond, drawn where the rock parts: across the contact, not along the bond.
#include <numeric>
#include <utility>

#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {
namespace {

/** The two ends of each crack, x0 y0 x1 y1 ... */
std::vector<double> crack_ends(const std::vector<hfrac_crack>& cracks) {
  std::vector<double> ends;
  ends.reserve(cracks.size() * 4);
  for (const auto& crack : cracks) {
    const double along_x = -0.5 * crack.length * crack.normal[1];
    const double along_y = 0.5 * crack.length * crack.normal[0];
    ends.insert(ends.end(), {crack.position[0] - along_x, crack.position[1] - along_y,  //
                             crack.position[0] + along_x, crack.position[1] + along_y});
  }
  return ends;
}

/** Pressure in each crack: the mean of the two domains that its pipe joins. */
std::vector<double> crack_pressures(const SnapshotFrame& frame) {
  const auto domains = integers(frame.sim, HFRAC_PIPE_DOMAINS);
  const auto pressure = doubles(frame.sim, HFRAC_DOMAIN_PRESSURE);
  std::vector<double> mean;
  mean.reserve(frame.cracks.size());
  for (const auto& crack : frame.cracks) {
    const auto pipe = static_cast<size_t>(crack.bond) * 2;
    const auto left = static_cast<size_t>(domains.at(pipe)),
               right = static_cast<size_t>(domains.at(pipe + 1));
    mean.push_back(0.5 * (pressure.at(left) + pressure.at(right)));
  }
  return mean;
}

template <class Value, class Member>
std::vector<Value> column(const std::vector<hfrac_crack>& cracks, Member member) {
  std::vector<Value> values;
  values.reserve(cracks.size());
  for (const auto& crack : cracks) values.push_back(static_cast<Value>(crack.*member));
  return values;
}

}  // namespace

std::string crack_vtu(const SnapshotFrame& frame) {
  const auto& cracks = frame.cracks;
  std::vector<int32_t> ends(cracks.size() * 2);
  std::iota(ends.begin(), ends.end(), 0);

  VtuGrid grid;
  grid.positions = crack_ends(cracks);
  grid.cell_type = CellType::line;
  grid.offsets = even_offsets(cracks.size(), 2);
  grid.connectivity = std::move(ends);
  auto& data = grid.cell_data;
  data.push_back(whole("mode", column<int32_t>(cracks, &hfrac_crack::mode)));
  data.push_back(floats("aperture_m", "m", column<double>(cracks, &hfrac_crack::aperture)));
  data.push_back(floats("pressure_Pa", "Pa", crack_pressures(frame)));
  data.push_back(exact("time_s", "s", column<double>(cracks, &hfrac_crack::time)));
  data.push_back(whole("step", column<int32_t>(cracks, &hfrac_crack::step)));
  data.push_back(whole("fracture", column<int32_t>(cracks, &hfrac_crack::fracture)));
  data.push_back(whole("crack_id", column<int32_t>(cracks, &hfrac_crack::id)));
  return encode(grid, frame.state, frame.wells, frame.coding);
}

}  // namespace hfrac::output
