// SPDX-License-Identifier: BSD-3-Clause
// The message: arrays are copied as they lie in memory, so this is for little-endian machines, as the VTU
// files are.
#include "web/server/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hfrac::web {
namespace {

static_assert(std::endian::native == std::endian::little, "messages are little-endian");

using json = nlohmann::ordered_json;

constexpr size_t kAlignment = 8;

size_t padded(size_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

template <class Value>
const char* type_name();
template <>
const char* type_name<float>() {
  return "f32";
}
template <>
const char* type_name<int32_t>() {
  return "i32";
}
template <>
const char* type_name<double>() {
  return "f64";
}

struct Described {
  json head;
  const void* data = nullptr;
  size_t bytes = 0;
};

Described describe(const GridArray& array) {
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        json head = {{"name", array.name}, {"of", array.of},       {"type", type_name<Value>()},
                     {"unit", array.unit}, {"parts", array.parts}, {"components", array.components}};
        head["length"] = values.size();
        return Described{std::move(head), values.data(), values.size() * sizeof(Value)};
      },
      array.values);
}

/** JSON has no infinities; the page shows null as "not a number". */
template <class Value>
json number(Value value) {
  if constexpr (std::is_floating_point_v<Value>)
    if (!std::isfinite(value)) return nullptr;
  return value;
}

}  // namespace

size_t Grid::bytes() const {
  size_t sum = 0;
  for (const auto& array : arrays) sum += describe(array).bytes;
  return sum;
}

std::string grid_message(const Grid& grid, const std::vector<std::string>& chosen) {
  const auto wanted = [&](const GridArray& array) {
    return chosen.empty() || array.of == "geometry" || array.of == "run" ||
           std::find(chosen.begin(), chosen.end(), array.name) != chosen.end();
  };
  json head = {{"points", grid.points}, {"cells", grid.cells}, {"time_s", grid.time}};
  head["arrays"] = json::array();
  head["others"] = json::array();
  std::vector<Described> sent;
  size_t body = 0;
  for (const auto& array : grid.arrays) {
    if (!wanted(array)) {
      head["others"].push_back(describe(array).head);
      continue;
    }
    auto& one = sent.emplace_back(describe(array));
    one.head["offset"] = body;
    head["arrays"].push_back(one.head);
    body += padded(one.bytes);
  }
  std::string text = head.dump();
  text.resize(padded(text.size()), ' ');

  std::string message(2 * sizeof(uint32_t) + text.size() + body, '\0');
  const auto length = static_cast<uint32_t>(text.size());
  std::memcpy(message.data(), "HFG1", 4);
  std::memcpy(message.data() + 4, &length, sizeof length);
  std::memcpy(message.data() + 8, text.data(), text.size());
  char* place = message.data() + 8 + text.size();
  for (const auto& one : sent) {
    if (one.bytes > 0) std::memcpy(place, one.data, one.bytes);
    place += padded(one.bytes);
  }
  return message;
}

json values_of(const Grid& grid, const std::string& of, int64_t index) {
  const int64_t count = of == "points" ? grid.points : grid.cells;
  if (index < 0 || index >= count)
    throw GridError(fmt::format("there is no number {}; they go from 0 to {}", index, count - 1));
  json list = json::array();
  for (const auto& array : grid.arrays) {
    const bool is_place = array.of == "geometry" && array.name == "position" && of == "points";
    if (array.of != of && !is_place) continue;
    json item = {{"name", array.name}, {"unit", array.unit}, {"parts", array.parts}};
    item["values"] = json::array();
    std::visit(
        [&](const auto& values) {
          for (int32_t i = 0; i < array.components; ++i)
            item["values"].push_back(number(values.at(static_cast<size_t>(index * array.components + i))));
        },
        array.values);
    list.push_back(std::move(item));
  }
  return list;
}

}  // namespace hfrac::web
