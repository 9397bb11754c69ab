// SPDX-License-Identifier: BSD-3-Clause
#include "step/packed_state.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "model/visit_state.hpp"
#include "step/snapshot.hpp"

namespace hfrac {

void keep_rest(const Engine& e, PackedModel& kept) {
  e.mechanics->bring_home();
  const auto& settled = e.model.assembly.smooth.settled;
  kept.settled.assign(settled.begin(), settled.end());
  Counter counter;
  visit_state(counter, e.model, e.wet());
  kept.state.resize(counter.size());
  Saver saver(kept.state);
  visit_state(saver, e.model, e.wet());
}

void load_rest(Engine& e, const PackedModel& kept, const std::vector<double>& pressure) {
  e.mechanics->forget_device();
  Model& m = e.model;
  e.boundary->set_load(m.assembly, 1.0);
  auto& smooth = m.assembly.smooth;
  Loader loader(kept.state);
  loader.require(kept.settled.empty() || kept.settled.size() == smooth.contacts.size());
  smooth.settled.assign(kept.settled.begin(), kept.settled.end());
  const auto wells = m.wells;
  const auto wellbores = m.wellbores;
  const auto heat = m.heat;
  const double zero_stress_aperture = m.network.zero_stress_aperture;
  visit_state(loader, m, e.wet());
  loader.require(loader.left() == 0);
  m.wells = wells;
  m.wellbores = wellbores;
  m.heat = heat;
  m.network.zero_stress_aperture = zero_stress_aperture;
  std::copy(pressure.begin(), pressure.end(), m.network.pressure.begin());
  follow_state(e);
}

}  // namespace hfrac
