// SPDX-License-Identifier: BSD-3-Clause
// A definition written as a case file.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "case_file.hpp"
#include "options/number_text.hpp"

namespace hfrac::capi {
namespace {

// A TOML basic string.
std::string toml_string(std::string_view text) {
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7F) {
      result += std::string("\\u00") + digits[byte >> 4U] + digits[byte & 15U];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

// With a point or an exponent, so that a reader sees what is a real number.
std::string real_text(double value) {
  const std::string text = number_text(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string value_text(const OptionInfo& info, const Options& values) {
  switch (info.type) {
    case ValueType::real:
      return real_text(values.*info.real);
    case ValueType::integer:
      return number_text(values.*info.integer);
    case ValueType::choice:
      return toml_string(choice_word(info.choices, values.*info.integer));
  }
  return {};
}

std::string value_text(const WellOptionInfo& info, const WellOptions& values) {
  if (info.real != nullptr) return real_text(values.*info.real);
  if (info.type == ValueType::integer) return number_text(values.*info.integer);
  return toml_string(choice_word(info.choices, static_cast<std::int64_t>(get_value(values, info))));
}

}  // namespace

std::string case_text(const CaseDefinition& definition) {
  check_ranges(definition);
  std::string text = "title = " + toml_string(definition.title) + "\n";
  // A section stands once, wherever in the table its later options are.
  std::vector<std::pair<std::string_view, std::string>> sections;
  for (const auto& info : option_table()) {
    const std::string_view key = info.key;
    const auto dot = key.find('.');
    const auto name = key.substr(0, dot);
    auto section =
        std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.first == name; });
    if (section == sections.end()) section = sections.insert(sections.end(), {name, {}});
    section->second += std::string(key.substr(dot + 1)) + " = " + value_text(info, definition.options) + "\n";
  }
  for (auto& [name, lines] : sections)
    if (name == "packing" && !definition.packing_file.empty())
      lines += "file = " + toml_string(definition.packing_file) + "\n";
  for (const auto& [name, lines] : sections) text += "\n[" + std::string(name) + "]\n" + lines;
  for (std::size_t w = 0; w < definition.wells.size(); ++w) {
    text += "\n[[well]]\n";
    bool of_wellbore = false;  // what stands after `control`, most of it as a rule at its default
    for (const auto& info : well_option_table()) {
      const std::string value = value_text(info, definition.wells[w]);
      if (!of_wellbore || value != value_text(info, WellOptions{}))
        text += std::string(info.key) + " = " + value + "\n";
      of_wellbore = of_wellbore || std::string_view(info.key) == "control";
    }
    for (const auto& entry : definition.schedule) {
      if (entry.well != static_cast<std::int64_t>(w)) continue;
      const bool by_rate = WellControl{entry.control} == WellControl::rate;
      text += "\n[[well.schedule]]\ntime = " + real_text(entry.time) + "\n" +
              (by_rate ? "rate" : "pressure") + " = " + real_text(entry.value) + "\n";
      if (ScheduleFluid{entry.fluid} != ScheduleFluid::same)
        text +=
            "fluid = " + toml_string(choice_word(find_schedule_value("fluid")->choices, entry.fluid)) + "\n";
    }
  }
  for (const auto& joint : definition.joints) {
    text += "\n[[joint]]\n";
    for (const auto& info : joint_table()) {
      const std::string value = info.real != nullptr ? real_text(joint.*info.real)
                                                     : toml_string(choice_word(info.choices, joint.state));
      text += std::string(info.key) + " = " + value + "\n";
    }
  }
  if (definition.joints.empty()) text.insert(text.find('\n') + 1, "joint = []\n");
  if (definition.wells.empty()) text.insert(text.find('\n') + 1, "well = []\n");
  return text;
}

}  // namespace hfrac::capi
