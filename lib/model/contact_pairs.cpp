// SPDX-License-Identifier: BSD-3-Clause
#include "model/contact_pairs.hpp"

namespace hfrac {

bool ContactPairs::fits(std::int64_t disc_count) const {
  const auto ascending = [disc_count](const std::vector<std::int32_t>& list) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (list[k] < 0 || list[k] >= disc_count || (k > 0 && list[k] <= list[k - 1])) return false;
    }
    return true;
  };
  for (const auto& pair : pairs) {
    if (pair.first < 0 || pair.second <= pair.first || pair.second >= disc_count) return false;
  }
  return ascending(discs) && ascending(cracked) && searched_x.size() == cracked.size() &&
         searched_y.size() == cracked.size();
}

}  // namespace hfrac
