// SPDX-License-Identifier: BSD-3-Clause
// Which law the fractures of a case follow, where fracture.law leaves it open.
//
// A case that gives a toughness asks for fractures of linear elastic fracture mechanics, which contacts do not give under stress: a tip of
// contacts asks for K_Ic + 0.8 sigma' sqrt(R) (docs/verification/kgd-random.md). So auto means facets wherever a toughness is given, or
// what only facets have (slots, a Biot coefficient), and they go with the rest of the case; contacts otherwise, as in the paper, whose
// rock is given by its bonds' strengths.
#pragma once

#include <string>

#include "options/choices.hpp"
#include "options/options.hpp"

namespace hfrac {

// Never automatic.
FractureLaw fracture_law_of(const CaseDefinition& definition);

// Some well has slots.
bool is_perforated(const CaseDefinition& definition);

// What law facet does not go with in this case, and what to do about it; empty: it goes.
std::string why_no_facets(const CaseDefinition& definition);

}  // namespace hfrac
