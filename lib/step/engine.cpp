// SPDX-License-Identifier: BSD-3-Clause
#include "step/engine.hpp"

#include "heat/expansion.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Temperatures before the first step, and what moves them.
std::unique_ptr<Heat> begin_heat(const Options& o, Model& model) {
  if (ThermalMode{o.thermal_mode} == ThermalMode::off) return nullptr;
  auto heat = std::make_unique<Heat>(o);
  heat->network = build_heat_network(model.assembly, model.network, o);
  if (ThermalMode{o.thermal_mode} == ThermalMode::transport)
    heat->solver = std::make_unique<HeatSolver>(model.assembly, model.network, heat->network, o);
  HeatState& s = model.heat.emplace();
  const auto discs = static_cast<std::size_t>(model.assembly.disc_count());
  s.disc.assign(discs, o.thermal_rock_temperature);
  s.felt = s.disc;
  s.fluid.assign(model.network.kind.size(), o.thermal_rock_temperature);
  s.held.assign(discs, 0);
  s.well.assign(model.wells.size(), o.thermal_fluid_temperature);
  if (ThermalOuter{o.thermal_outer} == ThermalOuter::held) {
    const Network& n = model.network;
    for (auto k = n.corner_start[0]; k < n.corner_start[1]; ++k)
      s.held[static_cast<std::size_t>(n.corner_disc[static_cast<std::size_t>(k)])] = 1;
  }
  feel_temperature(model.assembly, s.felt, heat->table, o);
  return heat;
}

}  // namespace

Engine::Engine(const Options& given, Model& of, const Ranks& of_ranks, std::unique_ptr<Device> on)
    : options(given),
      model(of),
      ranks(of_ranks),
      workers(new Workers(static_cast<int>(given.run_workers))),
      heat(begin_heat(given, of)),
      boundary(std::make_unique<Boundary>(of, given)),
      device(std::move(on)),
      mechanics(std::make_unique<ExplicitSolver>(of, *boundary, given, *workers, ranks)) {
  mechanics->use_device(device.get());
  take_wells();
}

void Engine::take_wells() {
  auto& fed = model.network.fed;
  fed.clear();
  if (model.wells.size() > model.well_count) fed.assign(model.network.kind.size(), 0);
  for (std::size_t w = model.well_count; w < model.wells.size(); ++w)
    fed[static_cast<std::size_t>(model.wells[w].place.domain)] = 1;
  if (!heat) return;
  heat->well_domain.clear();
  for (const auto& well : model.wells) heat->well_domain.push_back(well.place.domain);
}

bool Engine::wet() const {
  return FlowScheme{options.flow_scheme} != FlowScheme::off;
}

}  // namespace hfrac
