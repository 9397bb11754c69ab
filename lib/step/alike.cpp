// SPDX-License-Identifier: BSD-3-Clause
#include "step/alike.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace hfrac {
namespace {

struct Named {
  std::string_view name;
  std::uint64_t hash;
};

// The first that is not the same on all ranks; empty: there is none. Numbers a of n ranks are all the same where n sum(a^2) is the square of
// sum(a) (Cauchy and Schwarz), so one sum tells all ranks alike. Of each hash 32 bits, in two numbers whose squares add up without overflow.
std::string_view find_differing(const Ranks& ranks, const std::vector<Named>& values) {
  std::vector<std::int64_t> sums;
  for (const auto& value : values) {
    for (const int shift : {0, 16}) {
      const auto number = static_cast<std::int64_t>((value.hash >> shift) & 0xffffU);
      sums.push_back(number);
      sums.push_back(number * number);
    }
  }
  ranks.sum(sums);
  const auto n = static_cast<std::uint64_t>(ranks.size());
  for (std::size_t k = 0; k < sums.size(); k += 2) {
    const auto sum = static_cast<std::uint64_t>(sums[k]),
               of_squares = static_cast<std::uint64_t>(sums[k + 1]);
    if (n * of_squares != sum * sum) return values[k / 4].name;
  }
  return {};
}

template <class Items, class Table>
std::uint64_t hash_of_items(const Items& items, const Table& table) {
  Hash hash;
  hash.add(static_cast<std::int64_t>(items.size()));
  for (const auto& item : items)
    for (const auto& info : table) hash.add(get_value(item, info));
  return hash.value();
}

template <class... Values>
std::uint64_t hash_of(const Values&... values) {
  Hash hash;
  (hash.add(values), ...);
  return hash.value();
}

template <class Values>
std::uint64_t hash_of_all(const Values& values) {
  Hash hash;
  hash.add(static_cast<std::int64_t>(values.size()));
  hash.add_all(values);
  return hash.value();
}

std::uint64_t hash_of_wells(const std::vector<WellLoad>& wells) {
  Hash hash;
  hash.add(static_cast<std::int64_t>(wells.size()));
  for (const auto& well : wells) {
    hash.add(static_cast<std::int64_t>(well.drive.control));
    for (const double value : {well.drive.target_pressure, well.drive.ramp_per_step, well.drive.set_rate})
      hash.add(value);
    hash.add(static_cast<std::int64_t>(well.drive.fluid));
    hash.add(hash_of_items(well.schedule, schedule_table()));
  }
  return hash.value();
}

std::uint64_t hash_of_books(const Model& m) {
  const auto& [friction, damping, fluid, fracture, held] = m.accounts.energies;
  Hash hash;
  for (const double value : {m.clock.time, friction, damping, fluid, fracture, held, m.accounts.leaked,
                             m.accounts.host_added, m.accounts.outside_work})
    hash.add(value);
  for (const auto count : {m.clock.step, m.clock.cycles, static_cast<std::int64_t>(m.cracks.size())})
    hash.add(count);
  for (const auto& well : m.wells) {
    hash.add(static_cast<std::int64_t>(well.place.domain));
    hash.add(well.injected);
  }
  return hash.value();
}

[[noreturn]] void refuse(std::string_view what, const char* fix) {
  throw Error(ErrorKind::argument, std::string(what) + " is not the same on all ranks; " + fix);
}

}  // namespace

void require_same_definition(const Ranks& ranks, const CaseDefinition& definition,
                             std::span<const double> discs, std::span<const std::int64_t> bonds) {
  if (ranks.alone()) return;
  std::vector<Named> values;
  for (const auto& info : option_table()) {
    if (std::string_view(info.key) != "run.workers")
      values.push_back({info.key, hash_of(get_value(definition.options, info))});
  }
  values.push_back({"packing.file (given or not)", definition.packing_file.empty() ? 0U : 1U});
  values.push_back({"the list of wells", hash_of_items(definition.wells, well_option_table())});
  values.push_back({"the list of joints", hash_of_items(definition.joints, joint_table())});
  values.push_back({"the schedule", hash_of_items(definition.schedule, schedule_table())});
  values.push_back({"the list of given discs", hash_of_all(discs)});
  values.push_back({"the list of given bonds", hash_of_all(bonds)});
  const auto differs = find_differing(ranks, values);
  if (!differs.empty())
    refuse(differs, "give each the whole definition, for instance by sending to all what one has read.");
}

void require_same_step(const Ranks& ranks, const Model& model, const Loads& loads, double duration) {
  if (ranks.alone()) return;
  Hash cells;
  cells.add(static_cast<std::int64_t>(loads.cell_load.size()));
  for (const auto& load : loads.cell_load) {
    cells.add(load.x);
    cells.add(load.y);
  }
  const auto differs = find_differing(
      ranks, {{"the length of the step", hash_of(duration)},
              {"the far field", hash_of(loads.sigma_Hmax, loads.sigma_hmin)},
              {"the formation's pressure", hash_of(loads.formation_pressure)},
              {"the pressure beyond the boundary",
               hash_of(hash_of_all(loads.boundary_excess), std::uint64_t{loads.boundary_pressure_set})},
              {"the stress of the host's cells", cells.value()},
              {"how wells are driven", hash_of_wells(loads.wells)},
              {"the temperature of what is injected", hash_of_all(loads.well_temperature)},
              {"which discs are held at a temperature", hash_of_all(loads.held_temperature)},
              {"the state before the step", hash_of_books(model)}});
  if (!differs.empty())
    refuse(differs,
           "the state before the step stands. Make each call that changes the simulation on all "
           "ranks, with the same arguments.");
}

}  // namespace hfrac
