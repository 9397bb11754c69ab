// SPDX-License-Identifier: BSD-3-Clause
// From the name of a case file to a definition that can be built.
#pragma once

#include <hfrac/hfrac.h>
#include <hfrac/definition.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hfrac::command {

/** The user's own discs and bonds (output/disc_file.hpp); empty: a packing, all that are near. */
struct GivenParts {
  std::vector<double> discs;
  std::vector<int64_t> bonds;

  GivenParts() = default;
  /** From files; an empty name is none. Throws BadInput. */
  GivenParts(const std::filesystem::path& disc_file, const std::filesystem::path& bond_file);
  /** Those that a run folder keeps. */
  explicit GivenParts(const std::filesystem::path& run_folder);
};

/** The options --discs and --bonds. */
void add_given_parts(CLI::App& command, std::filesystem::path& disc_file, std::filesystem::path& bond_file);

/** Once the model is built it has its own copy: takes the user's discs and bonds out of `definition`. */
void forget_given(hfrac_sim_def& definition);

/** Reads and checks a case file; BadInput with the engine's own sentence if it is wrong. `workers` > 0
 * replaces run.workers; with 0 a case that does not say gets the machine's cores, at most four. The definition borrows
 * `given`, if there is anything, in place of a packing. `notes`, if not nullptr, gets what the engine told while it read: how many
 * entries of a schedule a record gave. */
Definition load_case(const std::string& file, int64_t workers, const GivenParts& given = {},
                     std::vector<std::string>* notes = nullptr);

// Values that are allowed but can only have been meant in MPa or GPa: all values are in SI units.

/** A sentence for each value of the definition that is plainly in another unit. */
std::vector<std::string> unlikely_values(const hfrac_sim_def& definition);

/** Refuses a target that is plainly in another unit, by the name of its option. */
void require_likely_targets(const hfrac_targets& targets);

}  // namespace hfrac::command
