// SPDX-License-Identifier: BSD-3-Clause
// flow_*.vtu: each fluid domain as the polygon of the disc centres around it; the outside has no polygon.
#include <utility>

#include "output/snapshot_grids.hpp"
#include "output/vtu_grid.hpp"

namespace hfrac::output {
namespace {

constexpr int32_t kOutside = 2;  ///< value of the field domain.kind

/** The values of `all` that belong to the domains in `chosen`. */
template <class Value>
std::vector<Value> pick(const std::vector<Value>& all, const std::vector<int32_t>& chosen) {
  std::vector<Value> values;
  values.reserve(chosen.size());
  for (const int32_t i : chosen) values.push_back(all.at(static_cast<size_t>(i)));
  return values;
}

}  // namespace

std::string flow_vtu(const SnapshotFrame& frame) {
  const auto kind = integers(frame.sim, HFRAC_DOMAIN_KIND);
  const auto first = integers(frame.sim, HFRAC_DOMAIN_OFFSET);
  const auto corners = integers(frame.sim, HFRAC_DOMAIN_CORNERS);

  std::vector<int32_t> inside, offsets{0}, connectivity;
  for (size_t i = 0; i < kind.size(); ++i) {
    if (kind[i] == kOutside) continue;
    const auto begin = corners.begin() + first.at(i);
    const auto end = i + 1 < kind.size() ? corners.begin() + first.at(i + 1) : corners.end();
    inside.push_back(static_cast<int32_t>(i));
    connectivity.insert(connectivity.end(), begin, end);
    offsets.push_back(static_cast<int32_t>(connectivity.size()));
  }

  VtuGrid grid;
  grid.positions = frame.positions;
  grid.cell_type = CellType::polygon;
  grid.offsets = std::move(offsets);
  grid.connectivity = std::move(connectivity);
  auto& data = grid.cell_data;
  data.push_back(floats("pressure_Pa", "Pa", pick(doubles(frame.sim, HFRAC_DOMAIN_PRESSURE), inside)));
  data.push_back(floats("volume_m2", "m2", pick(doubles(frame.sim, HFRAC_DOMAIN_VOLUME), inside)));
  if (frame.warm)
    data.push_back(floats("temperature_K", "K", pick(doubles(frame.sim, HFRAC_DOMAIN_TEMPERATURE), inside)));
  data.push_back(whole("domain_id", inside));
  data.push_back(whole("kind", pick(kind, inside)));
  return encode(grid, frame.state, frame.wells, frame.coding);
}

}  // namespace hfrac::output
