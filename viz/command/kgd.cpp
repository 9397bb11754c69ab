// SPDX-License-Identifier: BSD-3-Clause
#include "command/kgd.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hfrac::command {
namespace {

struct Row {
  double log_m, a, b, c;
  std::array<double, KgdFracture::places.size()> opening, pressure;
};

#define KGD_LIST(...) \
  { __VA_ARGS__ }
#define KGD_ROW(log_m, a, b, c, opening, pressure) Row{log_m, a, b, c, opening, pressure},
constexpr std::array rows = {
#include "command/kgd_table.inc"
};
#undef KGD_ROW
#undef KGD_LIST

double between(double from, double to, double share) {
  return from + share * (to - from);
}

/** Of M; a, b and c are powers of it between two rows, and beyond the table the regime's limit. */
Row row_at(double m) {
  const double log_m = std::clamp(std::log10(m), rows.front().log_m, rows.back().log_m);
  const auto place = (log_m - rows.front().log_m) / (rows[1].log_m - rows[0].log_m);
  const auto k = std::min(static_cast<std::size_t>(place), rows.size() - 2);
  const double share = place - static_cast<double>(k);
  const Row &low = rows[k], &high = rows[k + 1];
  const auto power = [&](double Row::*of) { return low.*of * std::pow(high.*of / low.*of, share); };
  Row row{log_m, power(&Row::a), power(&Row::b), power(&Row::c), {}, {}};
  for (std::size_t i = 0; i < row.opening.size(); ++i) {
    row.opening[i] = between(low.opening[i], high.opening[i], share);
    row.pressure[i] = between(low.pressure[i], high.pressure[i], share);
  }
  return row;
}

}  // namespace

KgdFracture kgd_fracture(const KgdCase& given, double volume) {
  const double thick = 12.0 * given.viscosity, modulus = given.modulus, rate = given.rate;
  const double tough = 4.0 * std::sqrt(2.0 / std::numbers::pi) * given.toughness;
  const Row row = row_at(thick * std::pow(modulus, 3.0) * rate / std::pow(tough, 4.0));
  KgdFracture found;
  found.half_length =
      row.a * std::pow(modulus * std::pow(rate, 3.0) / thick, 1.0 / 6.0) * std::pow(volume / rate, 2.0 / 3.0);
  const double width = std::sqrt(row.b * std::sqrt(thick * rate / modulus) * found.half_length);
  const double pressure = row.c * std::sqrt(thick * rate * modulus) / width;
  for (std::size_t i = 0; i < found.opening.size(); ++i) {
    found.opening[i] = width * row.opening[i];
    found.pressure[i] = pressure * row.pressure[i];
  }
  return found;
}

}  // namespace hfrac::command
