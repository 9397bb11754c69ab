// SPDX-License-Identifier: BSD-3-Clause
// hfrac options: the engine's own table of options, the same that reads case files.
#include <fmt/format.h>

#include "command/commands.hpp"
#include "output/engine_call.hpp"

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

ExitCode list_options(const std::string& part) {
  int32_t count = 0;
  output::require(hfrac_option_count(&count), nullptr);
  int shown = 0;
  for (int32_t i = 0; i < count; ++i) {
    auto option = output::sized<hfrac_option_info>();
    output::require(hfrac_option_at(i, &option), nullptr);
    if (std::string(option.key).find(part) == std::string::npos) continue;
    fmt::print("{:34} {}\n    {}\n", option.key, values_of(option), option.help);
    ++shown;
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
