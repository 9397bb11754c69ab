// SPDX-License-Identifier: BSD-3-Clause
#include "build/wellbores.hpp"

#include <map>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr double gravity = 9.80665;  // m/s2, standard

}  // namespace

void begin_wellbores(Model& model, const CaseDefinition& definition) {
  std::map<std::int64_t, std::int32_t> shared;  // by the number in the case
  for (std::size_t w = 0; w < definition.wells.size(); ++w) {
    const WellOptions& given = definition.wells[w];
    Well& well = model.wells[w];
    const double density =
        given.fluid_density > 0.0 ? given.fluid_density : definition.options.thermal_fluid_density;
    const double second_density =
        definition.options.fluid_second_density > 0.0 ? definition.options.fluid_second_density : density;
    const auto friction_of = [&given](double rho) {
      return well_friction(rho, given.perforation_count, given.perforation_diameter,
                           given.discharge_coefficient, given.near_well_friction, given.height);
    };
    const WellFriction friction = friction_of(density);
    well.head = density * gravity * given.depth;
    well.second_head = second_density * gravity * given.depth;
    if (!friction.any()) {
      well.storage = given.storage;
      continue;
    }
    const auto fresh = static_cast<std::int32_t>(model.wellbores.size());
    well.wellbore = given.wellbore == 0 ? fresh : shared.try_emplace(given.wellbore, fresh).first->second;
    if (well.wellbore == fresh) model.wellbores.emplace_back();
    Wellbore& wellbore = model.wellbores[static_cast<std::size_t>(well.wellbore)];
    for (const auto& other : wellbore.clusters) {
      if (other.domain == well.place.domain)
        throw Error(ErrorKind::model,
                    "well[" + std::to_string(w) + "] and well[" + std::to_string(other.well) +
                        "] of one wellbore lie in the same hole; place them farther apart.");
    }
    wellbore.clusters.push_back({static_cast<std::int64_t>(w),
                                 well.place.domain,
                                 friction,
                                 0.0,
                                 {friction.square, friction_of(second_density).square}});
    wellbore.storage += given.storage;
  }
}

void begin_holes(Model& model, const CaseDefinition& definition) {
  Network& n = model.network;
  for (std::size_t w = 0; w < model.wells.size(); ++w) {
    const auto d = static_cast<std::size_t>(model.wells[w].place.domain);
    const double area = definition.wells[w].fluid_area;
    if (area == 0.0) continue;
    for (std::size_t other = 0; other < w; ++other) {
      if (model.wells[other].place.domain == model.wells[w].place.domain &&
          definition.wells[other].fluid_area > 0.0)
        throw Error(ErrorKind::model,
                    "well[" + std::to_string(other) + "] and well[" + std::to_string(w) +
                        "] lie in the same hole, and each gives it a fluid_area; give one, or place them "
                        "farther apart.");
    }
    n.volume[d] = n.storing[d] = area;
  }
  for (const auto& well : model.wells)
    n.storing[well.place.domain] += well.storage * definition.options.fluid_bulk_modulus;
}

}  // namespace hfrac
