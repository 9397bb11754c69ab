// SPDX-License-Identifier: BSD-3-Clause
// Temperature in a simulation: its beginning, when it moves, when the rock feels it, and what a host says of it.
//
// Heat moves with the flow of a step (or of an increment of one, in mode coupled) once that is known. The rock feels it when
// equilibrium is next sought: in the same step in modes substep and dynamic, in the next increment in mode coupled. So the state
// after a step is one of equilibrium with the temperatures in `felt`.
#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "couple/simulation.hpp"
#include "heat/expansion.hpp"
#include "options/choices.hpp"

namespace hfrac {

void Simulation::begin_heat() {
  const Options& o = options();
  if (ThermalMode{o.thermal_mode} == ThermalMode::off) return;
  heat_ = std::make_unique<Heat>(o);
  heat_->network = build_heat_network(assembly_, network_, o);
  if (ThermalMode{o.thermal_mode} == ThermalMode::transport)
    heat_->solver = std::make_unique<HeatSolver>(assembly_, network_, heat_->network, o);
  auto& s = heat_->state;
  const auto discs = static_cast<std::size_t>(assembly_.disc_count());
  s.disc.assign(discs, o.thermal_rock_temperature);
  s.felt = s.disc;
  s.fluid.assign(network_.kind.size(), o.thermal_rock_temperature);
  s.held.assign(discs, 0);
  s.well.assign(wells_.size(), o.thermal_fluid_temperature);
  for (const auto& well : wells_) heat_->well_domain.push_back(well.place.domain);
  if (ThermalOuter{o.thermal_outer} == ThermalOuter::held) {
    for (auto k = network_.corner_start[0]; k < network_.corner_start[1]; ++k)
      s.held[static_cast<std::size_t>(network_.corner_disc[static_cast<std::size_t>(k)])] = 1;
  }
  feel_temperature(assembly_, s.felt, heat_->table, o);
}

void Simulation::move_heat(double duration) {
  if (heat_ && heat_->solver) heat_->solver->advance(heat_->state, heat_->well_domain, duration);
}

void Simulation::feel_heat() {
  if (!heat_ || heat_->state.felt == heat_->state.disc) return;
  double bonds = 0.0, contacts = 0.0, bonds_after = 0.0, contacts_after = 0.0;
  elastic_energy(bonds, contacts);
  heat_->state.felt = heat_->state.disc;
  feel_temperature(assembly_, heat_->state.felt, heat_->table, options());
  elastic_energy(bonds_after, contacts_after);
  heat_->state.thermal_work += bonds_after + contacts_after - bonds - contacts;
  if (!heat_->table.empty()) solver_->refresh_stiffness();
}

void Simulation::feel_again() {
  if (heat_) feel_temperature(assembly_, heat_->state.felt, heat_->table, options());
}

double Simulation::stored_heat() const {
  const auto& s = heat_->state;
  if (heat_->solver) return heat_->solver->stored(s);
  double heat = 0.0;
  for (std::size_t i = 0; i < s.disc.size(); ++i)
    heat += heat_->network.capacity[i] * (s.disc[i] - options().thermal_rock_temperature);
  return heat;
}

void Simulation::book_host_fluid(std::size_t domain, double gain) {
  if (!heat_ || !heat_->solver) return;
  const Options& o = options();
  heat_->state.from_host += gain * o.thermal_fluid_density * o.thermal_fluid_specific_heat *
                            (heat_->state.fluid[domain] - o.thermal_rock_temperature);
}

HeatBalance Simulation::heat_balance() const {
  require_heat();
  const auto& s = heat_->state;
  HeatBalance b{};
  b.stored = stored_heat();
  b.from_wells = s.from_wells;
  b.from_outside = s.from_outside;
  b.from_held = s.from_held;
  b.from_host = s.from_host;
  b.error = b.from_wells + b.from_outside + b.from_held + b.from_host - b.stored;
  b.thermal_work = s.thermal_work;
  b.lowest = *std::min_element(s.disc.begin(), s.disc.end());
  b.highest = *std::max_element(s.disc.begin(), s.disc.end());
  return b;
}

void Simulation::require_heat() const {
  if (heat_) return;
  throw Error(ErrorKind::argument,
              "this simulation has no temperature; set thermal.mode = \"uniform\" or \"transport\".");
}

void Simulation::require_no_open_step() const {
  if (!step_open_) return;
  throw Error(ErrorKind::argument,
              "a step is open, and tries start from where it was opened; set temperatures before "
              "hfrac_step_prepare.");
}

// New temperatures of discs; pores take the mean of the discs around them.
void Simulation::put_temperatures(const Array<double>& disc) {
  auto& s = heat_->state;
  const double before = stored_heat();
  s.disc = disc;
  for (std::size_t d = 1; d < network_.kind.size(); ++d) {
    const auto begin = network_.corner_start[d], end = network_.corner_start[d + 1];
    double sum = 0.0;
    for (auto k = begin; k < end; ++k)
      sum += disc[static_cast<std::size_t>(network_.corner_disc[static_cast<std::size_t>(k)])];
    s.fluid[d] = sum / static_cast<double>(end - begin);
  }
  s.from_host += stored_heat() - before;
}

void Simulation::set_temperature(double kelvin) {
  require_heat();
  require_no_open_step();
  heat_->table.require(kelvin, "the temperature");
  put_temperatures(Array<double>(heat_->state.disc.size(), kelvin));
}

void Simulation::require_transport(const char* what) const {
  require_heat();
  if (heat_->solver) return;
  throw Error(ErrorKind::argument, std::string(what) +
                                       " needs thermal.mode = \"transport\"; with \"uniform\" there is one "
                                       "temperature, and hfrac_set_temperature changes it.");
}

void Simulation::set_disc_temperature(std::span<const double> kelvin) {
  require_transport("a temperature by disc");
  require_no_open_step();
  const auto& s = heat_->state;
  if (kelvin.size() != s.disc.size()) {
    throw Error(ErrorKind::argument, "temperature has " + std::to_string(kelvin.size()) +
                                         " values; there are " + std::to_string(s.disc.size()) + " discs.");
  }
  for (std::size_t i = 0; i < kelvin.size(); ++i)
    heat_->table.require(kelvin[i], "the temperature of disc " + std::to_string(i));
  put_temperatures(Array<double>(kelvin.begin(), kelvin.end()));
}

void Simulation::set_cell_temperature(std::span<const double> kelvin) {
  require_transport("a temperature by cell");
  require_cells(kelvin.size(), 1, "temperature");
  require_no_open_step();
  for (std::size_t c = 0; c < kelvin.size(); ++c)
    heat_->table.require(kelvin[c], "the temperature of cell " + std::to_string(c));
  Array<double> disc = heat_->state.disc;
  for (std::size_t i = 0; i < disc.size(); ++i) {
    const auto c = grid_->cell_at({assembly_.x[i], assembly_.y[i]});
    if (c >= 0) disc[i] = kelvin[static_cast<std::size_t>(c)];
  }
  put_temperatures(disc);
}

std::vector<double> Simulation::cell_temperature() const {
  require_heat();
  const auto cells = static_cast<std::size_t>(grid().count());
  std::vector<double> sum(cells, 0.0), weight(cells, 0.0);
  for (std::size_t i = 0; i < heat_->state.disc.size(); ++i) {
    const auto at = grid_->cell_at({assembly_.x[i], assembly_.y[i]});
    if (at < 0) continue;
    const auto c = static_cast<std::size_t>(at);
    sum[c] += heat_->network.capacity[i] * heat_->state.disc[i];
    weight[c] += heat_->network.capacity[i];
  }
  for (std::size_t c = 0; c < cells; ++c)
    sum[c] = weight[c] > 0.0 ? sum[c] / weight[c] : options().thermal_rock_temperature;
  return sum;
}

void Simulation::hold_temperature(std::span<const std::int32_t> held) {
  require_transport("holding the temperature of discs");
  require_no_open_step();
  auto& s = heat_->state;
  if (held.size() != s.held.size()) {
    throw Error(ErrorKind::argument, "held has " + std::to_string(held.size()) + " values; there are " +
                                         std::to_string(s.held.size()) + " discs.");
  }
  for (std::size_t i = 0; i < held.size(); ++i) s.held[i] = held[i] != 0 ? 1 : 0;
}

void Simulation::set_well_temperature(std::size_t well, double kelvin) {
  require_transport("the temperature of a well's fluid");
  heat_->table.require(kelvin, "the temperature of well " + std::to_string(well));
  heat_->state.well[well] = kelvin;
}

}  // namespace hfrac
