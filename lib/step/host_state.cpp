// SPDX-License-Identifier: BSD-3-Clause
#include "step/host_state.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace hfrac {
namespace {

// New temperatures of discs; pores take the mean of the discs around them.
void put_temperatures(Engine& e, const Array<double>& disc) {
  HeatState& s = *e.model.heat;
  const Network& n = e.model.network;
  const double before = stored_heat(e);
  s.disc = disc;
  for (std::size_t d = 1; d < n.kind.size(); ++d) {
    const auto begin = n.corner_start[d], end = n.corner_start[d + 1];
    double sum = 0.0;
    for (auto k = begin; k < end; ++k)
      sum += disc[static_cast<std::size_t>(n.corner_disc[static_cast<std::size_t>(k)])];
    s.fluid[d] = sum / static_cast<double>(end - begin);
  }
  s.from_host += stored_heat(e) - before;
}

}  // namespace

std::string cell_name(const HostGrid& grid, std::size_t c) {
  const auto at = static_cast<std::int64_t>(c);
  return "cell (" + std::to_string(at % grid.nx()) + ", " + std::to_string(at / grid.nx()) + ")";
}

void require_cells(const Simulation& s, std::size_t given, std::size_t per_cell, const char* what) {
  const auto cells = static_cast<std::size_t>(s.grid().count());
  if (given == per_cell * cells) return;
  throw Error(ErrorKind::argument, std::string(what) + " has " + std::to_string(given) +
                                       " values; the grid has " + std::to_string(cells) + " cells, so " +
                                       std::to_string(per_cell * cells) + " are needed.");
}

void require_transport(const Engine& e, const char* what) {
  require_heat(e);
  if (e.heat->solver) return;
  throw Error(ErrorKind::argument, std::string(what) +
                                       " needs thermal.mode = \"transport\"; with \"uniform\" there is one "
                                       "temperature, set as a whole.");
}

void require_no_open_step(const Simulation& s, const char* what) {
  if (!s.step_open()) return;
  throw Error(ErrorKind::argument,
              std::string("a step is open, and tries start from where it was opened; set ") + what +
                  " before the step is opened.");
}

void set_cell_pressure(Simulation& s, std::span<const double> pressure, std::span<double> added) {
  require_cells(s, pressure.size(), 1, "pressure");
  if (!s.engine().flow)
    throw Error(ErrorKind::argument, "flow.scheme is \"off\", so pores have no pressure of their own.");
  require_no_open_step(s, "the pressures of pores");
  Network& n = s.engine().model.network;
  const HostGrid& grid = s.grid();
  const auto count = static_cast<std::size_t>(n.domain_count());
  std::vector<double> sum(count, 0.0), area(count, 0.0), gain(count, 0.0);
  for (const auto& part : grid.pores()) {
    const auto d = static_cast<std::size_t>(part.item), c = static_cast<std::size_t>(part.cell);
    const double p = pressure[c];
    if (!std::isfinite(p) || p < n.floor_pressure) {
      throw Error(ErrorKind::argument, "pressure of " + cell_name(grid, c) + " is " + std::to_string(p) +
                                           " Pa; it must be finite and at least " +
                                           std::to_string(n.floor_pressure) + " Pa.");
    }
    sum[d] += part.amount * p;
    area[d] += part.amount;
  }
  const std::vector<char> fractured = fractured_pores(s.assembly(), n);
  for (std::size_t d = 1; d < count; ++d) {
    if (!n.is_own(d) || fractured[d] != 0 || area[d] <= 0.0) continue;
    const double p = sum[d] / area[d];
    const double content = content_at(n, static_cast<std::int64_t>(d), s.options().fluid_bulk_modulus, p);
    gain[d] = content - n.content[d];
    n.content[d] = content;
    n.pressure[d] = p;
    book_host_fluid(s.engine(), d, gain[d]);
  }
  if (added.empty()) return;
  std::fill(added.begin(), added.end(), 0.0);
  for (const auto& part : grid.pores()) {
    const auto d = static_cast<std::size_t>(part.item);
    if (gain[d] != 0.0) added[static_cast<std::size_t>(part.cell)] += gain[d] * part.amount / area[d];
  }
}

void set_temperature(Simulation& s, double kelvin) {
  Engine& e = s.engine();
  require_heat(e);
  require_no_open_step(s, "temperatures");
  e.heat->table.require(kelvin, "the temperature");
  put_temperatures(e, Array<double>(e.model.heat->disc.size(), kelvin));
}

void set_disc_temperature(Simulation& s, std::span<const double> kelvin) {
  Engine& e = s.engine();
  require_transport(e, "a temperature by disc");
  require_no_open_step(s, "temperatures");
  const auto& disc = e.model.heat->disc;
  if (kelvin.size() != disc.size()) {
    throw Error(ErrorKind::argument, "temperature has " + std::to_string(kelvin.size()) +
                                         " values; there are " + std::to_string(disc.size()) + " discs.");
  }
  for (std::size_t i = 0; i < kelvin.size(); ++i)
    e.heat->table.require(kelvin[i], "the temperature of disc " + std::to_string(i));
  put_temperatures(e, Array<double>(kelvin.begin(), kelvin.end()));
}

void set_cell_temperature(Simulation& s, std::span<const double> kelvin) {
  Engine& e = s.engine();
  require_transport(e, "a temperature by cell");
  require_cells(s, kelvin.size(), 1, "temperature");
  require_no_open_step(s, "temperatures");
  const Assembly& a = s.assembly();
  for (std::size_t c = 0; c < kelvin.size(); ++c)
    e.heat->table.require(kelvin[c], "the temperature of cell " + std::to_string(c));
  Array<double> disc = e.model.heat->disc;
  for (std::size_t i = 0; i < disc.size(); ++i) {
    const auto c = s.grid().cell_at({a.x[i], a.y[i]});
    if (c >= 0) disc[i] = kelvin[static_cast<std::size_t>(c)];
  }
  put_temperatures(e, disc);
}

std::vector<CellReport> report_cells(const Simulation& s, Upscaling rule) {
  return report_cells(s.grid(), s.assembly(), s.network(), s.options(), rule, s.oda_matrix());
}

std::vector<double> cell_temperature(const Simulation& s) {
  const Engine& e = s.engine();
  require_heat(e);
  const HeatState& heat = *s.model().heat;
  const auto& capacity = e.heat->network.capacity;
  const auto cells = static_cast<std::size_t>(s.grid().count());
  std::vector<double> sum(cells, 0.0), weight(cells, 0.0);
  for (std::size_t i = 0; i < heat.disc.size(); ++i) {
    const auto at = s.grid().cell_at({s.assembly().x[i], s.assembly().y[i]});
    if (at < 0) continue;
    const auto c = static_cast<std::size_t>(at);
    sum[c] += capacity[i] * heat.disc[i];
    weight[c] += capacity[i];
  }
  for (std::size_t c = 0; c < cells; ++c)
    sum[c] = weight[c] > 0.0 ? sum[c] / weight[c] : s.options().thermal_rock_temperature;
  return sum;
}

}  // namespace hfrac
