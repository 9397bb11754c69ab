// SPDX-License-Identifier: BSD-3-Clause
// How large a model may be.
//
// What moves disc by disc takes up to packing.disc_count's limit. What solves for all discs at once keeps the entries of a matrix, whose
// number 32 bits have to hold, and takes more memory a disc; it ends earlier. A model that the machine's memory cannot hold is refused before
// it is made: a system that lends more than it has would end the host's program later, without a word.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "options/options.hpp"

namespace hfrac {

// Of a host's discs, three numbers each, or to be packed.
inline std::int64_t disc_count_of(const Options& o, std::span<const double> given_discs) {
  return given_discs.empty() ? o.packing_disc_count : static_cast<std::int64_t>(given_discs.size() / 3);
}

// Why a case takes no model of so many discs; empty: it does.
std::string why_too_large(const CaseDefinition& definition, std::int64_t discs);

// What a model of so many discs takes at the very least [bytes]. `alone`: a factor is not shared out over ranks.
double least_memory(const CaseDefinition& definition, std::int64_t discs, bool alone);
// Why it does not fit into a machine with so many bytes; empty: it may.
std::string why_no_memory(const CaseDefinition& definition, std::int64_t discs, bool alone, double machine);
// Memory of this machine, swap included [bytes]; infinite where the system does not tell.
double machine_memory();

}  // namespace hfrac
