// SPDX-License-Identifier: BSD-3-Clause
// hfrac options: the engine's own table of options, the same that reads case files.
//
// Wells, their schedules and joints are lists in a case file ([[well]], [[well.schedule]], [[joint]]); their values are listed
// after the options.
#include <fmt/format.h>

#include <array>

#include "command/commands.hpp"
#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

/** Default and range of one option, in its own terms: words for a choice, whole numbers for an integer. */
std::string values_of(const hfrac_option_info& option) {
  if (option.type == 2) {
    std::string words = option.choices;
    size_t begin = 0;
    for (int i = 0; i < static_cast<int>(option.default_value); ++i) begin = words.find('|', begin) + 1;
    const std::string chosen = words.substr(begin, words.find('|', begin) - begin);
    return fmt::format("\"{}\"  one of {}", chosen, words);
  }
  const std::string unit = std::string(option.unit) == "1" ? "" : fmt::format(" {}", option.unit);
  if (option.type == 1)
    return fmt::format("{:.0f}{}  from {:.0f} to {:.0f}", option.default_value, unit, option.minimum,
                       option.maximum);
  return fmt::format("{:g}{}  from {:g} to {:g}", option.default_value, unit, option.minimum, option.maximum);
}

/** One of the engine's tables, and how a case file writes its keys. */
struct Table {
  const char* before;  ///< the key
  int32_t (*count)(int32_t*);
  int32_t (*at)(int32_t, hfrac_option_info*);
};
constexpr std::array<Table, 4> tables = {
    {{"", hfrac_option_count, hfrac_option_at},
     {"well.", hfrac_well_option_count, hfrac_well_option_at},
     {"well.schedule.", hfrac_schedule_option_count, hfrac_schedule_option_at},
     {"joint.", hfrac_joint_option_count, hfrac_joint_option_at}}};

/** Below a well in a case file an entry names its value pressure or rate, and needs no number of the well. */
std::string key_in_case_file(const Table& table, const std::string& key) {
  if (table.count != hfrac_schedule_option_count) return table.before + key;
  if (key == "well" || key == "control") return {};
  return table.before + (key == "value" ? "pressure, or rate" : key);
}

ExitCode list_options(const std::string& part) {
  int shown = 0;
  for (const Table& table : tables) {
    int32_t count = 0;
    run::require(table.count(&count), nullptr);
    for (int32_t i = 0; i < count; ++i) {
      auto option = run::sized<hfrac_option_info>();
      run::require(table.at(i, &option), nullptr);
      const std::string key = key_in_case_file(table, option.key);
      if (key.empty() || key.find(part) == std::string::npos) continue;
      fmt::print("{:34} {}\n    {}\n", key, values_of(option), option.help);
      ++shown;
    }
  }
  if (shown == 0) throw BadInput(fmt::format("no option has '{}' in its name", part));
  return kGood;
}

}  // namespace

void add_options(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("options", "List the options of case files: unit, default, range, meaning");
  auto part = std::make_shared<std::string>();
  command->add_option("PART", *part, "Only options with this in their name, e.g. 'bond.'");
  command->callback([part, &action] { action = [part] { return list_options(*part); }; });
}

}  // namespace hfrac::command
