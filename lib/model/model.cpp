// SPDX-License-Identifier: BSD-3-Clause
#include "model/model.hpp"

namespace hfrac {

std::vector<WellPlace> Model::well_places() const {
  std::vector<WellPlace> places;
  for (const auto& well : wells) places.push_back(well.place);
  return places;
}

}  // namespace hfrac
