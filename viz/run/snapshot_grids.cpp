// SPDX-License-Identifier: BSD-3-Clause
// Fractures are found before the cracks are read, so that every crack carries the fracture it belongs to now.
#include "run/snapshot_grids.hpp"

#include <numeric>
#include <utility>

#include "run/fields.hpp"

namespace hfrac::run {
namespace {

constexpr int32_t outer_domain = 2;  ///< value of the field domain.kind

std::vector<int32_t> counted_up(Part::Range range) {
  std::vector<int32_t> numbers(static_cast<size_t>(range.last - range.first));
  std::iota(numbers.begin(), numbers.end(), range.first);
  return numbers;
}
std::vector<int32_t> counted_up(size_t count) {
  return counted_up({0, static_cast<int32_t>(count)});
}

/** The values of `all` that belong to the items in `chosen`, `components` values each. */
template <class Value>
std::vector<Value> pick(const std::vector<Value>& all, const std::vector<int32_t>& chosen,
                        int32_t components) {
  std::vector<Value> values;
  values.reserve(chosen.size() * static_cast<size_t>(components));
  for (const int32_t i : chosen)
    for (int32_t c = 0; c < components; ++c)
      values.push_back(
          all.at(static_cast<size_t>(i) * static_cast<size_t>(components) + static_cast<size_t>(c)));
  return values;
}

/** Adds the fields at `location`, of the items in `chosen` (nullptr: of all). */
void add_fields(std::vector<VtuArray>& data, const SnapshotFrame& frame, Location location,
                const std::vector<int32_t>* chosen = nullptr) {
  for (const Field& field : shown_fields(location)) {
    if (!frame.warm && (field.number == HFRAC_DISC_TEMPERATURE || field.number == HFRAC_DOMAIN_TEMPERATURE))
      continue;
    if (!frame.two_fluids && field.number == HFRAC_DOMAIN_SECOND_FLUID) continue;
    if (!field.real) {
      auto values = integers(frame.sim, field.number);
      data.push_back(whole(array_name(field),
                           chosen != nullptr ? pick(values, *chosen, field.components) : std::move(values)));
      continue;
    }
    auto values = doubles(frame.sim, field.number);
    if (chosen != nullptr) values = pick(values, *chosen, field.components);
    if (field.components == 2) values = in_space(values);
    data.push_back(floats(array_name(field), field.unit == "1" ? "" : std::string(field.unit), values,
                          component_names(field)));
  }
}

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

template <class Value, class Item, class Member>
std::vector<Value> column(const std::vector<Item>& items, Member member) {
  std::vector<Value> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(static_cast<Value>(item.*member));
  return values;
}

Moment moment_of(const SnapshotFrame& frame) {
  Moment moment{frame.state.time, frame.state.step, {}};
  for (const auto& well : frame.wells) moment.well_pressure.push_back(well.pressure);
  return moment;
}

}  // namespace

SnapshotFrame::SnapshotFrame(hfrac_sim* simulation)
    : sim(simulation),
      state(state_of(simulation)),
      wells(wells_of(simulation)),
      fractures(fractures_of(simulation)),
      cracks(cracks_of(simulation)),
      positions(doubles(simulation, HFRAC_DISC_POSITION)),
      warm(definition_of(simulation).thermal_mode != 0),
      two_fluids(definition_of(simulation).fluid_second_viscosity > 0.0),
      jointed(!integers(simulation, HFRAC_JOINT_BOND).empty()),
      moment(moment_of(*this)) {}

VtuGrid disc_grid(const SnapshotFrame& frame, Part part) {
  const auto chosen = counted_up(part.of(frame.positions.size() / 2));
  VtuGrid grid;
  grid.positions = part.whole() ? frame.positions : pick(frame.positions, chosen, 2);
  grid.offsets = even_offsets(chosen.size(), 1);
  grid.connectivity = counted_up(chosen.size());
  add_fields(grid.point_data, frame, Location::disc, part.whole() ? nullptr : &chosen);
  grid.point_data.push_back(whole("disc_id", chosen));
  return grid;
}

VtuGrid bond_grid(const SnapshotFrame& frame, Part part) {
  VtuGrid grid;
  grid.positions = frame.positions;
  grid.cell_type = CellType::line;
  grid.connectivity = integers(frame.sim, HFRAC_BOND_DISCS);
  const auto chosen = counted_up(part.of(grid.connectivity.size() / 2));
  if (!part.whole()) {
    grid.connectivity = pick(grid.connectivity, chosen, 2);
    keep_used_points(grid);
  }
  grid.offsets = even_offsets(chosen.size(), 2);
  const auto* of_part = part.whole() ? nullptr : &chosen;
  add_fields(grid.cell_data, frame, Location::bond, of_part);
  add_fields(grid.cell_data, frame, Location::pipe,
             of_part);  // the pipe that crosses a bond has the bond's index
  grid.cell_data.push_back(whole("bond_id", chosen));
  return grid;
}

VtuGrid crack_grid(const SnapshotFrame& frame) {
  const auto& cracks = frame.cracks;
  VtuGrid grid;
  grid.positions = crack_ends(cracks);
  grid.cell_type = CellType::line;
  grid.offsets = even_offsets(cracks.size(), 2);
  grid.connectivity = counted_up(cracks.size() * 2);
  grid.cell_data = {whole("mode", column<int32_t>(cracks, &hfrac_crack::mode)),
                    floats("aperture_m", "m", column<double>(cracks, &hfrac_crack::aperture)),
                    floats("pressure_Pa", "Pa", crack_pressures(frame)),
                    exact("time_s", "s", column<double>(cracks, &hfrac_crack::time)),
                    whole("step", column<int32_t>(cracks, &hfrac_crack::step)),
                    whole("fracture", column<int32_t>(cracks, &hfrac_crack::fracture)),
                    whole("crack_id", column<int32_t>(cracks, &hfrac_crack::id))};
  return grid;
}

VtuGrid fracture_grid(const SnapshotFrame& frame) {
  std::vector<hfrac_fracture_point> points;
  std::vector<int32_t> numbers, wells;
  VtuGrid grid;
  grid.cell_type = CellType::polyline;
  grid.offsets = {0};
  for (const auto& fracture : frame.fractures) {
    if (fracture.crack_count < 2) continue;
    const auto line = line_of(frame.sim, fracture.index);
    if (line.size() < 2) continue;
    points.insert(points.end(), line.begin(), line.end());
    grid.offsets.push_back(static_cast<int32_t>(points.size()));
    numbers.push_back(static_cast<int32_t>(fracture.index));
    wells.push_back(static_cast<int32_t>(fracture.well));
  }
  for (const auto& point : points)
    grid.positions.insert(grid.positions.end(), {point.position[0], point.position[1]});
  grid.connectivity = counted_up(points.size());
  using Point = hfrac_fracture_point;
  grid.point_data = {exact("distance_m", "m", column<double>(points, &Point::distance)),
                     floats("length_m", "m", column<double>(points, &Point::length)),
                     floats("aperture_m", "m", column<double>(points, &Point::aperture)),
                     floats("hydraulic_aperture_m", "m", column<double>(points, &Point::hydraulic_aperture)),
                     floats("pressure_Pa", "Pa", column<double>(points, &Point::pressure)),
                     floats("saturation", "", column<double>(points, &Point::saturation)),
                     whole("bond_id", column<int32_t>(points, &Point::bond)),
                     whole("wing", column<int32_t>(points, &Point::wing)),
                     whole("tip", column<int32_t>(points, &Point::tip))};
  grid.cell_data = {whole("fracture", std::move(numbers)), whole("well", std::move(wells))};
  return grid;
}

VtuGrid joint_grid(const SnapshotFrame& frame) {
  const auto begin = doubles(frame.sim, HFRAC_JOINT_BEGIN), end = doubles(frame.sim, HFRAC_JOINT_END);
  VtuGrid grid;
  for (size_t i = 0; i + 1 < begin.size(); i += 2)
    grid.positions.insert(grid.positions.end(), {begin[i], begin[i + 1], end[i], end[i + 1]});
  grid.cell_type = CellType::line;
  grid.offsets = even_offsets(begin.size() / 2, 2);
  grid.connectivity = counted_up(begin.size());
  add_fields(grid.cell_data, frame, Location::joint);
  grid.cell_data.push_back(whole("contact_id", counted_up(begin.size() / 2)));
  return grid;
}

VtuGrid flow_grid(const SnapshotFrame& frame, Part part) {
  const auto kind = integers(frame.sim, HFRAC_DOMAIN_KIND);
  const auto first = integers(frame.sim, HFRAC_DOMAIN_OFFSET);
  const auto corners = integers(frame.sim, HFRAC_DOMAIN_CORNERS);
  std::vector<int32_t> inside;
  for (size_t i = 0; i < kind.size(); ++i)
    if (kind[i] != outer_domain) inside.push_back(static_cast<int32_t>(i));
  const auto range = part.of(inside.size());
  inside = {inside.begin() + range.first, inside.begin() + range.last};
  VtuGrid grid;
  grid.positions = frame.positions;
  grid.cell_type = CellType::polygon;
  grid.offsets = {0};
  for (const int32_t domain : inside) {
    const auto i = static_cast<size_t>(domain);
    const auto begin = corners.begin() + first.at(i);
    const auto end = i + 1 < kind.size() ? corners.begin() + first.at(i + 1) : corners.end();
    grid.connectivity.insert(grid.connectivity.end(), begin, end);
    grid.offsets.push_back(static_cast<int32_t>(grid.connectivity.size()));
  }
  if (!part.whole()) keep_used_points(grid);
  add_fields(grid.cell_data, frame, Location::domain, &inside);
  grid.cell_data.push_back(whole("domain_id", inside));
  return grid;
}

}  // namespace hfrac::run
