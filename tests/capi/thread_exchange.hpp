// SPDX-License-Identifier: BSD-3-Clause
// Tables of hfrac/exchange.h for ranks that are threads of one process.
#pragma once

#include "../rank_threads.hpp"
#include "support.hpp"

namespace testing_capi {

class Meeting : public rank_threads::Meeting {
 public:
  using rank_threads::Meeting::Meeting;

  hfrac_exchange exchange(int32_t rank) {
    hfrac_exchange table;
    hfrac_exchange_init(&table, sizeof table);
    fill<hfrac_message>(table, rank);
    return table;
  }
};

}  // namespace testing_capi
