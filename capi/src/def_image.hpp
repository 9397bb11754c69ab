// SPDX-License-Identifier: BSD-3-Clause
// Between the C struct hfrac_sim_def, of whatever size the caller's is, and the engine's CaseDefinition.
#pragma once

#include <span>

#include "hfrac/def.h"
#include "options/options.hpp"

namespace hfrac::capi {

// Every option at its default, no wells.
hfrac_sim_def default_def();

// Throws Error(struct_size) unless a definition of that size holds its lists.
void require_def_size(std::int32_t size);

// The caller's definition at this library's size. Throws Error(argument) for NULL, Error(struct_size) unless
// init ran.
hfrac_sim_def read_def(const hfrac_sim_def* def);
// Into the caller's struct, which may be of an older header: an option that it has no place for must be as by default.
void write_def(hfrac_sim_def* to, const hfrac_sim_def& full, const char* name);

// The parts, one by one. Values are taken as they are; only what has no meaning in C++ is refused.
Options options_of(const hfrac_sim_def& def);
CaseDefinition case_of(const hfrac_sim_def& def);
std::span<const double> given_discs_of(const hfrac_sim_def& def);
std::span<const std::int64_t> given_bonds_of(const hfrac_sim_def& def);

void put_options(const Options& options, hfrac_sim_def& def);
// Options, lists and title into the caller's struct; other pointers and callbacks are those of `full`. The lists become the
// library's, in place of those that `full` owned before. If that throws, those still stand.
void write_case(hfrac_sim_def* to, const CaseDefinition& definition, hfrac_sim_def full, const char* name);
// Throws Error(argument) unless `title` is UTF-8 without a 0, short enough for the struct.
void put_title(std::string_view title, hfrac_sim_def& def);
// Likewise of a model file's path.
void put_packing_file(std::string_view path, hfrac_sim_def& def);

}  // namespace hfrac::capi
