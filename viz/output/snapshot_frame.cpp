// SPDX-License-Identifier: BSD-3-Clause
// Fractures are found before the cracks are read, so that every crack carries the fracture it belongs to now.
#include "output/snapshot_grids.hpp"

namespace hfrac::output {
namespace {

Coding coding_of(const hfrac_sim_def& definition) {
  return {static_cast<Compression>(definition.output_compression),
          static_cast<Layout>(definition.output_layout)};
}

}  // namespace

SnapshotFrame::SnapshotFrame(hfrac_sim* simulation)
    : sim(simulation),
      state(state_of(simulation)),
      wells(wells_of(simulation)),
      fractures(fractures_of(simulation)),
      cracks(cracks_of(simulation)),
      positions(doubles(simulation, HFRAC_DISC_POSITION)),
      coding(coding_of(definition_of(simulation))),
      warm(definition_of(simulation).thermal_mode != 0) {}

}  // namespace hfrac::output
