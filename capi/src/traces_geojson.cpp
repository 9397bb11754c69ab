// SPDX-License-Identifier: BSD-3-Clause
// Traces as GeoJSON (RFC 7946), as QGIS writes lines: a FeatureCollection, each feature a line or several, each piece of a line a trace.
//
// Features are taken one by one as they end and then forgotten, so the memory needed does not grow with the file. The parser follows
// nesting without recursion; what nests deeper than any geometry is refused all the same. A feature's fault is told by the line it
// ends on: QGIS writes a feature a line.
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "options/number_text.hpp"
#include "trace_list.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

using json = nlohmann::json;

constexpr int deepest = 32;                     // a MultiLineString's numbers are 6 deep
constexpr std::size_t most_values = 1'000'000;  // of one feature

// The text, a letter at a time. `line` lags by a letter: the parser reads one beyond a number's end.
class CountingLetters {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  CountingLetters(const char* at, std::size_t* line) : at_(at), line_(line) {}
  char operator*() const { return *at_; }
  CountingLetters& operator++() {
    *line_ += ended_ ? 1U : 0U;
    ended_ = *at_++ == '\n';
    return *this;
  }
  bool operator==(const CountingLetters& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* line_;
  bool ended_ = false;
};

std::string kind_of(const json& value) {
  const auto type = value.is_object() ? value.find("type") : value.end();
  return type != value.end() && type->is_string() ? printable(type->get<std::string>()) : value.type_name();
}

Vec2 place_of(const json& position, const TraceList& traces) {
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
    traces.refuse("a position of a line is [x, y], two numbers in m, not " +
                  printable(position.dump(-1, ' ', true, json::error_handler_t::replace)) + ".");
  const Vec2 place{position[0].get<double>(), position[1].get<double>()};
  traces.check_coordinate(place.x, "x", number_text(place.x));
  traces.check_coordinate(place.y, "y", number_text(place.y));
  return place;
}

void add_line(const json& line, TraceList& traces) {
  if (!line.is_array() || line.size() < 2)
    traces.refuse("the coordinates of a line are an array of two positions or more.");
  Vec2 from = place_of(line[0], traces);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vec2 to = place_of(line[k], traces);
    traces.add(from, to);
    from = to;
  }
}

void add_feature(const json& feature, TraceList& traces) {
  if (kind_of(feature) != "Feature")
    traces.refuse("an item of features is a Feature, not " + kind_of(feature) + ".");
  const auto geometry = feature.find("geometry");
  if (geometry == feature.end()) traces.refuse("the feature has no geometry.");
  if (geometry->is_null()) return;  // a record without a place
  const std::string kind = kind_of(*geometry);
  const auto coordinates = geometry->is_object() ? geometry->find("coordinates") : geometry->end();
  if (kind != "LineString" && kind != "MultiLineString")
    traces.refuse("the geometry is " + kind +
                  "; traces are LineString or MultiLineString, leave out others.");
  if (coordinates == geometry->end()) traces.refuse("the geometry has no coordinates.");
  if (kind == "LineString") return add_line(*coordinates, traces);
  if (!coordinates->is_array()) traces.refuse("the coordinates of a MultiLineString are an array of lines.");
  for (const json& line : *coordinates) add_line(line, traces);
}

// QGIS names the coordinate system where it is not the RFC's, which is in degrees.
void check_system(const json& root, const TraceList& traces) {
  const auto name = root.value(json::json_pointer("/crs/properties/name"), json());
  if (!name.is_string()) return;
  const auto text = name.get<std::string>();
  if (text.ends_with("CRS84") || text.ends_with(":4326"))
    traces.refuse(
        "crs = " + printable(text) +
        " is in degrees; export in a coordinate system in metres, with its origin at the model's lower "
        "left corner.");
}

// Decides what of the tree is kept while it is read.
class Features {
 public:
  explicit Features(TraceList& traces) : traces_(traces) {}

  bool keep(int depth, json::parse_event_t event, const json& value) {
    using Event = json::parse_event_t;
    if (depth > deepest)
      traces_.refuse("nested deeper than " + std::to_string(deepest) + " levels; this is not GeoJSON.");
    if (event == Event::key && depth == 1) {
      key_ = value.get<std::string>();
      return key_ == "type" || key_ == "features" || key_ == "crs";
    }
    if (event == Event::value && ++values_ > most_values)
      traces_.refuse("more than " + std::to_string(most_values) + " values in one feature.");
    if (key_ != "features" || depth != 2) return true;
    if (event == Event::object_end) {
      begin();
      add_feature(value, traces_);
      traces_.part.clear();
      return false;
    }
    if (event != Event::value && event != Event::array_start) return true;
    begin();
    traces_.refuse("an item of features is a Feature, an object.");
  }

 private:
  void begin() {
    values_ = 0;
    traces_.part = "feature " + std::to_string(++number_) + ": ";
  }

  TraceList& traces_;
  std::string key_;  // of the outermost object
  std::size_t values_ = 0, number_ = 0;
};

json parsed(std::string_view text, TraceList& traces) {
  Features features(traces);
  const char* const begin = text.data();
  try {
    return json::parse(CountingLetters(begin, &traces.line),
                       CountingLetters(begin + text.size(), &traces.line),
                       [&](int depth, json::parse_event_t event, const json& value) {
                         return features.keep(depth, event, value);
                       });
  } catch (const json::exception& fault) {
    const std::string what = fault.what();  // "[json.exception...] parse error at ...: syntax error ..."
    traces.refuse("is not JSON: " + printable(what.substr(std::min(what.find("] ") + 2, what.size())), 200));
  }
}

}  // namespace

void read_geojson(std::string_view text, TraceList& traces) {
  const json root = parsed(text, traces);
  traces.line = 1;
  if (kind_of(root) != "FeatureCollection")
    traces.refuse("is " + kind_of(root) + ", not a FeatureCollection, as GeoJSON of traces is.");
  const auto features = root.find("features");
  if (features == root.end() || !features->is_array())
    traces.refuse("has no features; a FeatureCollection has an array of them.");
  check_system(root, traces);
}

}  // namespace hfrac::capi
