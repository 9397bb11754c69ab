// SPDX-License-Identifier: BSD-3-Clause
#include "output/quakeml.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace hfrac::output {

namespace {

namespace chr = std::chrono;

/** To the microsecond. */
std::string date_of(int64_t start, double seconds) {
  const chr::sys_time<chr::microseconds> moment{chr::seconds(start) +
                                                chr::microseconds(std::llround(1e6 * seconds))};
  const auto day = chr::floor<chr::days>(moment);
  const chr::year_month_day date{day};
  const chr::hh_mm_ss time{moment - day};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:06}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     time.hours().count(), time.minutes().count(), time.seconds().count(),
                     time.subseconds().count());
}

/** What identifiers may hold; anything else is an underscore. */
std::string identifier(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    safe += plain || c == '-' || c == '.' ? c : '_';
  }
  return safe.empty() ? "run" : safe;
}

/** A vector or tensor of the model in terms of east and north. */
struct Turn {
  double x_east, x_north, y_east, y_north;
  explicit Turn(double azimuth) {
    const double angle = azimuth * std::numbers::pi / 180.0;
    x_east = std::sin(angle);
    x_north = std::cos(angle);
    y_east = -x_north;
    y_north = x_east;
  }
  static double part(const double (&tensor)[3], double xa, double ya, double xb, double yb) {
    return tensor[0] * xa * xb + tensor[1] * ya * yb + tensor[2] * (xa * yb + ya * xb);
  }
};

std::string value(const char* name, const std::string& text) {
  return fmt::format("<{0}><value>{1}</value></{0}>", name, text);
}
std::string value(const char* name, double number) {
  return value(name, fmt::format("{}", number));
}

/** The tensor's axes are up, south and east. */
std::string tensor_text(const hfrac_event& event, const Turn& turn) {
  const auto& m = event.moment_tensor;
  const double south_south = Turn::part(m, turn.x_north, turn.y_north, turn.x_north, turn.y_north);
  const double east_east = Turn::part(m, turn.x_east, turn.y_east, turn.x_east, turn.y_east);
  const double south_east = -Turn::part(m, turn.x_north, turn.y_north, turn.x_east, turn.y_east);
  return "<tensor>" + value("Mrr", 0.0) + value("Mtt", south_south) + value("Mpp", east_east) +
         value("Mrt", 0.0) + value("Mrp", 0.0) + value("Mtp", south_east) + "</tensor>";
}

std::string what_it_was(const hfrac_event& event) {
  if (event.kind == HFRAC_EVENT_SLIP) {
    return fmt::format("slip of joints over {:.4g} m by {:.4g} m on average", event.length, event.slip);
  }
  return fmt::format("{} broken bonds, {} of them in tension", event.crack_count, event.tensile_cracks);
}

}  // namespace

int64_t seconds_of_date(const std::string& date) {
  int year = 0, hour = 0, minute = 0, second = 0, end = 0;
  unsigned month = 0, day = 0;
  const int found = std::sscanf(date.c_str(), "%4d-%2u-%2uT%2d:%2d:%2dZ%n", &year, &month, &day, &hour,
                                &minute, &second, &end);
  const chr::year_month_day whole{chr::year(year), chr::month(month), chr::day(day)};
  if (found != 6 || static_cast<size_t>(end) != date.size() || !whole.ok() || hour < 0 || hour > 23 ||
      minute < 0 || minute > 59 || second < 0 || second > 59)
    throw std::invalid_argument("'" + date + "' is no date in UTC such as 2026-05-01T12:00:00Z");
  const chr::seconds since = chr::sys_days(whole).time_since_epoch() + chr::hours(hour) +
                             chr::minutes(minute) + chr::seconds(second);
  return since.count();
}

std::string quakeml_text(const std::vector<hfrac_event>& events, const EarthPlace& place,
                         const std::string& name) {
  constexpr double earth_radius = 6371008.8;  // m
  constexpr double degrees = 180.0 / std::numbers::pi;
  const Turn turn(place.azimuth);
  const std::string root = "smi:local/hfrac/" + identifier(name);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<q:quakeml xmlns=\"http://quakeml.org/xmlns/bed/1.2\" "
      "xmlns:q=\"http://quakeml.org/xmlns/quakeml/1.2\">\n"
      "<eventParameters publicID=\"{}\">\n<comment><text>simulated by hfrac {}</text></comment>\n",
      root, run::version_of_library());
  for (const auto& event : events) {
    if (!std::isfinite(event.magnitude)) continue;
    const auto id = [&](const char* what) { return fmt::format("{}/{}/{}", root, what, event.index); };
    const double east = event.position[0] * turn.x_east + event.position[1] * turn.y_east;
    const double north = event.position[0] * turn.x_north + event.position[1] * turn.y_north;
    const double longitude =
        place.longitude + east / (earth_radius * std::cos(place.latitude / degrees)) * degrees;
    text += fmt::format(
        "<event publicID=\"{}\"><preferredOriginID>{}</preferredOriginID>"
        "<preferredMagnitudeID>{}</preferredMagnitudeID><type>induced or triggered event</type>"
        "<comment><text>{}</text></comment>\n",
        id("event"), id("origin"), id("magnitude"), what_it_was(event));
    text += fmt::format("  <origin publicID=\"{}\">", id("origin")) +
            value("time", date_of(place.start, event.time)) +
            value("latitude", place.latitude + north / earth_radius * degrees) +
            value("longitude", longitude) + value("depth", place.depth) +
            "<depthType>operator assigned</depthType></origin>\n";
    text += fmt::format("  <magnitude publicID=\"{}\">{}<type>Mw</type><originID>{}</originID></magnitude>\n",
                        id("magnitude"), value("mag", event.magnitude), id("origin"));
    text += fmt::format("  <focalMechanism publicID=\"{}\"><momentTensor publicID=\"{}\">",
                        id("focalmechanism"), id("momenttensor")) +
            fmt::format("<derivedOriginID>{}</derivedOriginID>", id("origin")) +
            value("scalarMoment", event.moment) + tensor_text(event, turn) +
            "</momentTensor></focalMechanism>\n</event>\n";
  }
  return text + "</eventParameters>\n</q:quakeml>\n";
}

}  // namespace hfrac::output
