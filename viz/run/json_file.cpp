// SPDX-License-Identifier: BSD-3-Clause
#include "run/json_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/files.hpp"
#include "run/text.hpp"

namespace hfrac::run {
namespace {

using json = nlohmann::ordered_json;

void make_printable(json& value) {
  if (value.is_string()) value = printable(value.get_ref<const std::string&>());
  if (value.is_structured())
    for (auto& part : value) make_printable(part);
}

}  // namespace

json read_json(const std::filesystem::path& file) {
  json object;
  try {
    object = json::parse(read_whole(file));
  } catch (const json::parse_error& error) {
    fail_reading(fmt::format("'{}' is not valid JSON: it is damaged at byte {}", file.string(), error.byte));
  } catch (const json::exception&) {
    fail_reading(fmt::format("'{}' is not valid JSON", file.string()));
  }
  if (!object.is_object())
    fail_reading(fmt::format("'{}' is not valid JSON: it holds no object", file.string()));
  make_printable(object);
  return object;
}

const json* member(const json& object, std::string_view path) {
  const json* found = &object;
  for (;;) {
    const size_t dot = std::min(path.find('.'), path.size());
    const auto name = path.substr(0, dot);
    if (found->is_array()) {
      const auto index = number_in<size_t>(name);
      if (!index || *index >= found->size()) return nullptr;
      found = &(*found)[*index];
    } else {
      const auto next = found->is_object() ? found->find(std::string(name)) : found->end();
      if (!found->is_object() || next == found->end()) return nullptr;
      found = &*next;
    }
    if (dot == path.size()) return found;
    path.remove_prefix(dot + 1);
  }
}

double number_at(const json& object, std::string_view path) {
  const json* found = member(object, path);
  return found != nullptr && found->is_number() ? found->get<double>() : std::nan("");
}

std::string text_at(const json& object, std::string_view path) {
  const json* found = member(object, path);
  return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace hfrac::run
