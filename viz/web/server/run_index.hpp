// SPDX-License-Identifier: BSD-3-Clause
// What there is to show of a run: its snapshots, what summary.json says, and the files to download.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace hfrac::web {

/** A folder in which nothing was written yet gives an index without snapshots; so does one of a run that is
 * about to be overwritten. Never throws for what is in the folder.
 *
 *   there       whether the folder exists now
 *   identity    differs between two runs in the same folder, one after the other
 *   running     summary.json says so; a killed run says so for ever, hence
 *   age_s       seconds since the history was last written; -1 if there is none
 *   snapshots   [{step, time_s, files: {discs, bonds, cracks, flow}}], those with a file in every list it is in
 *   summary     summary.json as it is, or null
 *   files       [{name, bytes}]: tables, case and pictures
 *   views       the list in run/views.hpp, by which the page colours what it shows
 */
nlohmann::ordered_json describe_run(const std::filesystem::path& folder);

}  // namespace hfrac::web
