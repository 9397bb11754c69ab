// SPDX-License-Identifier: BSD-3-Clause
#include "command/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

#include "command/exit_code.hpp"

namespace hfrac::command {
namespace {

constexpr double kMostCells = 1e6;  // along one side

/** All of `text` as a number. */
template <class Number>
bool read(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

CLI::Validator count_number() {
  return {[](std::string& text) {
            int64_t value = -1;
            return read(text, value) && value >= 0
                       ? std::string()
                       : fmt::format("'{}' is not a whole number from 0 to 9223372036854775807", text);
          },
          "COUNT"};
}

CLI::Validator positive_length() {
  return {[](std::string& text) {
            double value = 0.0;
            return read(text, value) && value > 0.0 && std::isfinite(value)
                       ? std::string()
                       : fmt::format("'{}' is not a number above 0", text);
          },
          "METRES"};
}

void require_grid(const std::vector<double>& numbers) {
  if (numbers.empty()) return;
  const size_t count = numbers.size();
  if (count != 4 && count != 6 && count != 7)
    throw BadInput(fmt::format(
        "--grid has {} numbers; give NX NY DX DY, X0 Y0 after them or not, and DEGREES after those", count));
  for (size_t i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i]))
      throw BadInput(fmt::format("--grid: {} is not a finite number", numbers[i]));
  for (size_t i = 0; i < 2; ++i)
    if (numbers[i] != std::floor(numbers[i]) || numbers[i] < 1.0 || numbers[i] > kMostCells)
      throw BadInput(fmt::format("--grid: {} {} is not a whole number of cells from 1 to {:.0f}",
                                 i == 0 ? "NX" : "NY", numbers[i], kMostCells));
  for (size_t i = 2; i < 4; ++i)
    if (!(numbers[i] > 0.0))
      throw BadInput(
          fmt::format("--grid: {} {} is not a length above 0 m", i == 2 ? "DX" : "DY", numbers[i]));
}

}  // namespace hfrac::command
