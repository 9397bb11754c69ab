// SPDX-License-Identifier: BSD-3-Clause
// Models packed before, in files.
#pragma once

#include <optional>

#include "core/ranks.hpp"
#include "step/packed_model.hpp"

namespace hfrac::capi {

// Of the file that the definition names, if it does; several ranks read a part of it each. Throws Error(file) if it cannot be read or is no such
// file, on all ranks if one cannot or if theirs are different files; Error(model) if a host gives discs, too.
std::optional<PackedModel> packed_model_of(const CaseDefinition& definition, bool discs_given,
                                           const Ranks& ranks = {});

}  // namespace hfrac::capi
