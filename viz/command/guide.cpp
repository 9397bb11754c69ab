// SPDX-License-Identifier: BSD-3-Clause
#include "command/guide.hpp"

#include <hfrac/hfrac.h>

#include <algorithm>
#include <array>

#include "run/engine_call.hpp"

namespace hfrac::command {
namespace {

/** Section of an option by its key; empty if it is none. */
std::string section_of(std::string_view key) {
  int32_t count = 0;
  if (hfrac_option_count(&count) < 0) return {};
  for (int32_t i = 0; i < count; ++i) {
    auto option = run::sized<hfrac_option_info>();
    if (hfrac_option_at(i, &option) >= 0 && key == option.key)
      return std::string(key.substr(0, key.find('.')));
  }
  return {};
}

/** Heading of the guide that a word of a sentence belongs to. */
std::string heading_of(std::string_view word) {
  // Lists, as a refusal numbers their items.
  constexpr std::array<std::array<std::string_view, 2>, 5> lists = {{{"schedule[", "wellschedule"},
                                                                     {"].schedule", "wellschedule"},
                                                                     {"well.schedule", "wellschedule"},
                                                                     {"well[", "well"},
                                                                     {"joint[", "joint"}}};
  for (const auto& [part, heading] : lists)
    if (word.find(part) != std::string_view::npos) return std::string(heading);
  return word.find('.') == std::string_view::npos ? std::string() : section_of(word);
}

}  // namespace

std::string guide_place(std::string_view sentence) {
  constexpr std::string_view of_a_key = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]";
  for (size_t begin = sentence.find_first_of(of_a_key); begin != std::string_view::npos;) {
    const size_t end = std::min(sentence.find_first_not_of(of_a_key, begin), sentence.size());
    std::string_view word = sentence.substr(begin, end - begin);
    while (word.ends_with('.')) word.remove_suffix(1);
    if (const std::string heading = heading_of(word); !heading.empty())
      return "docs/user-guide.md#" + heading;
    begin = sentence.find_first_of(of_a_key, end);
  }
  return {};
}

}  // namespace hfrac::command
