// SPDX-License-Identifier: BSD-3-Clause
#include "record_columns.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <span>

#include "core/error.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

struct Unit {
  std::string_view name;
  double scale;
  bool whole = false;  // of the whole thickness
};
constexpr double gallon =
    231.0 * 0.0254 * 0.0254 * 0.0254;  // m3, of the United States; a barrel of oil has 42
constexpr Unit time_units[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
constexpr Unit rate_units[] = {{"m2_s", 1.0},
                               {"m3_s", 1.0, true},
                               {"m3_min", 1.0 / 60.0, true},
                               {"m3_h", 1.0 / 3600.0, true},
                               {"L_s", 1e-3, true},
                               {"L_min", 1e-3 / 60.0, true},
                               {"bbl_min", 42.0 * gallon / 60.0, true},
                               {"gal_min", gallon / 60.0, true}};
constexpr Unit pressure_units[] = {
    {"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"bar", 1e5}, {"psi", 4.4482216152605 / (0.0254 * 0.0254)}};

struct Quantity {
  std::string_view name;
  std::span<const Unit> units;
};

std::string allowed_names(const Quantity& quantity) {
  std::string names;
  for (const Unit& unit : quantity.units)
    names.append(names.empty() ? "" : ", ").append(quantity.name).append("_").append(unit.name);
  return quantity.name == "time" ? names + " or time (ISO 8601)" : names;
}

// "L_per_s" is "L_s".
std::string without_per(std::string_view unit) {
  std::string text(unit);
  if (const auto at = text.find("per_"); at != std::string::npos) text.erase(at, 4);
  return text;
}

class Header {
 public:
  Header(const std::vector<std::string_view>& names, const RecordWishes& wishes, const std::string& path,
         std::size_t line)
      : names_(names), wishes_(wishes), path_(path), line_(line) {}

  std::optional<RecordColumn> find(const Quantity& quantity, Wish wish) const {
    if (wish == Wish::none) return std::nullopt;
    std::optional<RecordColumn> found;
    std::string_view unknown;
    for (std::size_t place = 0; place < names_.size(); ++place) {
      if (!name_at(place).starts_with(quantity.name)) continue;
      const auto column = column_of(quantity, place);
      if (column && found)
        refuse("both " + found->name + " and " + column->name + "; leave one of them out.");
      if (column) found = column;
      const auto rest = name_at(place).substr(quantity.name.size());
      if (!column && (rest.empty() || rest.front() == '_')) unknown = names_[place];
    }
    if (!found && !unknown.empty())
      refuse("the name " + printable(unknown) + " ends with no known unit; it may be " +
             allowed_names(quantity) + ".");
    if (!found && wish == Wish::must)
      refuse("no column of " + std::string(quantity.name) + "; the first line of a record names " +
             allowed_names(quantity) + ".");
    return found;
  }

 private:
  [[noreturn]] void refuse(const std::string& fault) const { refuse_record(path_, line_, fault); }

  // Where there is no other, a run's own name of the pressure, well_pressure_Pa, is one too.
  std::string_view name_at(std::size_t place) const {
    std::string_view name = names_[place];
    const auto plain = [](std::string_view other) { return other.starts_with("pressure"); };
    if (name.starts_with("well_pressure_") && std::none_of(names_.begin(), names_.end(), plain))
      name.remove_prefix(std::string_view("well_").size());
    return name;
  }

  std::optional<RecordColumn> column_of(const Quantity& quantity, std::size_t place) const {
    const std::string_view name = name_at(place);
    if (name == "time" && quantity.name == "time") return RecordColumn{place, std::string(name), 1.0, true};
    if (name.size() <= quantity.name.size() || name[quantity.name.size()] != '_') return std::nullopt;
    const std::string unit_name = without_per(name.substr(quantity.name.size() + 1));
    const auto unit = std::find_if(quantity.units.begin(), quantity.units.end(),
                                   [&](const Unit& one) { return one.name == unit_name; });
    if (unit == quantity.units.end()) return std::nullopt;
    if (unit->whole && wishes_.thickness == 0.0)
      refuse(std::string(name) +
             " is the rate of the whole thickness, and the model's is per metre of it; give that "
             "thickness in metres as schedule_thickness, or a column rate_m2_s.");
    return RecordColumn{place, std::string(name),
                        unit->whole ? unit->scale / wishes_.thickness : unit->scale};
  }

  const std::vector<std::string_view>& names_;
  const RecordWishes& wishes_;
  const std::string& path_;
  std::size_t line_;
};

}  // namespace

void refuse_record(const std::string& path, std::size_t line, const std::string& fault) {
  throw Error(ErrorKind::case_file, printable(path, 400) + ":" + std::to_string(line) + ": " + fault);
}

RecordColumns columns_of_record(const std::vector<std::string_view>& names, const RecordWishes& wishes,
                                const std::string& path, std::size_t line) {
  const Header header(names, wishes, path, line);
  return {*header.find({"time", time_units}, Wish::must), header.find({"rate", rate_units}, wishes.rate),
          header.find({"pressure", pressure_units}, wishes.pressure)};
}

std::optional<double> seconds_of_date(std::string_view text) {
  // A number of `digits` digits, and one of the characters `after` it, or the end if `after` is empty.
  const auto take = [&](std::size_t digits, std::string_view after) -> std::optional<int> {
    int value = 0;
    if (text.size() < digits) return std::nullopt;
    for (std::size_t i = 0; i < digits; ++i) {
      if (text[i] < '0' || text[i] > '9') return std::nullopt;
      value = 10 * value + (text[i] - '0');
    }
    text.remove_prefix(digits);
    if (after.empty()) return value;
    if (text.empty() || after.find(text.front()) == std::string_view::npos) return std::nullopt;
    text.remove_prefix(1);
    return value;
  };
  const auto year = take(4, "-"), month = take(2, "-"), day = take(2, "T "), hour = take(2, ":"),
             minute = take(2, "");
  if (!year || !month || !day || !hour || !minute || *hour > 24 || *minute > 59) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(unsigned(*month)),
                                         std::chrono::day(unsigned(*day))};
  if (!date.ok()) return std::nullopt;
  double second = 0.0;
  if (text.starts_with(':')) {
    text.remove_prefix(1);
    const std::size_t length = std::min(text.find_first_not_of("0123456789."), text.size());
    const auto [end, fault] = std::from_chars(text.data(), text.data() + length, second);
    if (length < 2 || fault != std::errc() || end != text.data() + length || second >= 61.0)
      return std::nullopt;
    text.remove_prefix(length);
  }
  double zone = 0.0;  // s
  if (text.starts_with('Z')) {
    text.remove_prefix(1);
  } else if (text.starts_with('+') || text.starts_with('-')) {
    const double sign = text.front() == '+' ? 1.0 : -1.0;
    text.remove_prefix(1);
    const auto hours = take(2, ":"), minutes = take(2, "");
    if (!hours || !minutes) return std::nullopt;
    zone = sign * (3600.0 * *hours + 60.0 * *minutes);
  }
  if (!text.empty()) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * *hour + 60.0 * *minute + second - zone;
}

}  // namespace hfrac::capi
