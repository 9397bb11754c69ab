// SPDX-License-Identifier: BSD-3-Clause
// Between the C struct hfrac_sim_def, of whatever size the caller's is, and the engine's CaseDefinition.
#pragma once

#include <span>

#include "hfrac/def.h"
#include "options/options.hpp"

namespace hfrac::capi {

// Every option at its default, no wells.
hfrac_sim_def default_def();

// The caller's definition at this library's size. Throws Error(argument) for NULL, Error(struct_size) unless
// init ran.
hfrac_sim_def read_def(const hfrac_sim_def* def);

// The parts, one by one. Values are taken as they are; only what has no meaning in C++ is refused.
Options options_of(const hfrac_sim_def& def);
WellOptions well_of(const hfrac_well_def& well);
JointOptions joint_of(const hfrac_joint_def& joint);
ScheduleEntry entry_of(const hfrac_schedule_def& entry);
CaseDefinition case_of(const hfrac_sim_def& def);
std::span<const double> given_discs_of(const hfrac_sim_def& def);
std::span<const std::int64_t> given_bonds_of(const hfrac_sim_def& def);

void put_options(const Options& options, hfrac_sim_def& def);
void put_well(const WellOptions& from, hfrac_well_def& well);
void put_joint(const JointOptions& from, hfrac_joint_def& joint);
void put_entry(const ScheduleEntry& from, hfrac_schedule_def& entry);
// Options, wells, joints, schedule and title; pointers and callbacks stay.
void put_case(const CaseDefinition& definition, hfrac_sim_def& def);
// Throws Error(argument) unless `title` is UTF-8 without a 0, short enough for the struct.
void put_title(std::string_view title, hfrac_sim_def& def);

}  // namespace hfrac::capi
