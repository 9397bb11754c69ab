// SPDX-License-Identifier: BSD-3-Clause
// Natural fractures as GeoJSON, as QGIS writes it: read, refused by line and feature, and not brought down by any bytes.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim_support.hpp"

namespace geojson_test {

using namespace testing_capi;

// As QGIS 3 exports a layer of lines: a feature a line.
const std::string exported =
    R"({
"type": "FeatureCollection",
"name": "traces",
"crs": { "type": "name", "properties": { "name": "urn:ogc:def:crs:EPSG::25832" } },
"features": [
{ "type": "Feature", "properties": { "id": 1, "note": "a \"joint\", [1,2]" }, "geometry": { "type": "LineString", "coordinates": [ [ 10.0, 20.0 ], [ 30.0, 40.5 ] ] } },
{ "type": "Feature", "properties": { "id": 2 }, "geometry": null },
{ "type": "Feature", "properties": { "id": null }, "geometry": { "type": "MultiLineString", "coordinates": [ [ [ 50, 50, 7.5 ], [ 60, 50, 7.5 ], [ 6.5e1, 55 ] ], [ [ 1, 2 ], [ 3, 4 ] ] ] } }
]
}
)";

hfrac::Definition read_from(const std::string& text, int32_t& status) {
  const TemporaryFolder folder;
  folder.write(text, "traces.geojson");
  hfrac::Definition def = new_def();
  status = hfrac_sim_def_add_traces(&def, (folder.path() + "/traces.geojson").c_str());
  return def;
}

TEST(GeoJson, LinesAreTracesPieceByPiece) {
  const TemporaryFolder folder;
  folder.write(exported, "traces.JSON");
  hfrac::Definition def = new_def();
  const std::string file =
      folder.write("[[joint]]\nfile = \"traces.JSON\"\nstate = \"smooth-broken\"\nfriction = 0.6\n");
  ASSERT_EQ(hfrac_sim_def_load(&def, file.c_str()), HFRAC_OK) << last_error();
  const double ends[][4] = {{10, 20, 30, 40.5}, {50, 50, 60, 50}, {60, 50, 65, 55}, {1, 2, 3, 4}};
  ASSERT_EQ(def.joint_count, 4);
  for (int k = 0; k < 4; ++k) {
    const hfrac_joint_def& joint = def.joints[k];
    EXPECT_EQ(joint.x1, ends[k][0]);
    EXPECT_EQ(joint.y1, ends[k][1]);
    EXPECT_EQ(joint.x2, ends[k][2]);
    EXPECT_EQ(joint.y2, ends[k][3]);
    EXPECT_EQ(joint.friction, 0.6);
  }
  EXPECT_EQ(hfrac_sim_def_check_file(&def, file.c_str()), HFRAC_OK) << last_error();
}

TEST(GeoJson, TracesAreAddedToTheJointsThereAre) {
  const TemporaryFolder folder;
  folder.write("start_x,start_y,end_x,end_y\n1,2,3,4\n", "traces.csv");
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_f64(&def, "joint[0].x2", 30.0), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_def_add_traces(&def, (folder.path() + "/traces.csv").c_str()), HFRAC_OK)
      << last_error();
  ASSERT_EQ(def.joint_count, 2);
  EXPECT_EQ(def.joints[0].x2, 30.0);
  EXPECT_EQ(def.joints[1].y2, 4.0);
  EXPECT_EQ(def.joints[1].friction, -1.0);  // the default
  const std::string before = written(def);
  EXPECT_EQ(hfrac_sim_def_add_traces(&def, (folder.path() + "/none.csv").c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(written(def), before);
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}
std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":{},"geometry":)" + geometry + "}";
}
std::string line(const std::string& coordinates) {
  return feature(R"({"type":"LineString","coordinates":)" + coordinates + "}");
}

TEST(GeoJson, ThatIsNoneIsRefusedByLineAndFeature) {
  const std::string good = line("[[1,2],[3,4]]"), many_lines = good + ",\n" + good + ",\n";
  std::string crowd = line("[[1,2],[3,4]]");
  for (int k = 1; k < 100'001; ++k) crowd += "," + good;
  const std::string deep(1'000'000, '[');
  const std::pair<std::string, std::string> table[] = {
      {"", ":1: is not JSON: "},
      {"{\"type\": \"FeatureCollection\",\n\"features\": [,]}", ":2: is not JSON: "},
      {"[]", ":1: is array, not a FeatureCollection"},
      {good, ":1: is Feature, not a FeatureCollection"},
      {R"({"type":"FeatureCollection"})", "has no features"},
      {R"({"type":"FeatureCollection","features":7})", "has no features"},
      {collection("7"), "feature 1: an item of features is a Feature"},
      {collection("[]"), "feature 1: an item of features is a Feature"},
      {collection("{}"), "feature 1: an item of features is a Feature, not object"},
      {collection(R"({"type":"Feature"})"), "the feature has no geometry"},
      {collection(feature("[]")), "the geometry is array"},
      {collection(feature(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})")),
       "feature 1: the geometry is Polygon; traces are LineString"},
      {collection(feature(R"({"type":"LineString"})")), "the geometry has no coordinates"},
      {collection(feature(R"({"type":"MultiLineString","coordinates":3})")), "an array of lines"},
      {collection(many_lines + line("[[1,2]]")), ":3: feature 3: the coordinates of a line are"},
      {collection(line("7")), "the coordinates of a line are"},
      {collection(many_lines + line("[[1,2],[3]]")),
       "feature 3: a position of a line is [x, y], two numbers in m"},
      {collection(line("[[1,2],[\"3\",4]]")), "two numbers in m, not [\"3\",4]"},
      {collection(line("[[1,2],[null,4]]")), "two numbers in m, not [null,4]"},
      {collection(line("[[1,2],[NaN,4]]")), "is not JSON: "},
      {collection(line("[[1,2],[1e999,4]]")), "is not JSON: "},
      {collection(good + ",\n" + line("[[1,2],[3,1e9]]")),
       ":2: feature 2: y = 1e9 is not a number from -1e6 to 1e6 m"},
      {collection(line("[[1,2],[3,4],[3,4]]")), "feature 1: the trace has no length"},
      {collection(crowd), "feature 100001: more than 100000 traces"},
      {deep, "nested deeper than 32 levels"},
      {R"({"type":)" + deep, "nested deeper than 32 levels"},
      {R"({"type":"FeatureCollection","crs":{"properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},"features":[]})",
       "is in degrees; export in a coordinate system in metres"},
  };
  for (const auto& [text, fault] : table) {
    int32_t status = HFRAC_OK;
    const hfrac::Definition def = read_from(text, status);
    EXPECT_EQ(status, HFRAC_ERR_CASE_FILE) << text.substr(0, 200);
    EXPECT_EQ(def.joint_count, 0);
    EXPECT_NE(last_error().find("traces.geojson:"), std::string::npos) << last_error();
    EXPECT_NE(last_error().find(fault), std::string::npos) << last_error() << "\n  not: " << fault;
  }
  int32_t status = HFRAC_OK;
  EXPECT_EQ(read_from(collection(""), status).joint_count, 0);  // no traces are traces, too
  EXPECT_EQ(status, HFRAC_OK) << last_error();
}

// Cut off at each place, and with bytes changed: refused with a sentence, or read as numbers that a joint may have.
TEST(GeoJson, AnyBytesAreReadOrRefused) {
  const std::string letters = "{}[]\",:0e-.\\\n\0n\xFF";
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < exported.size(); ++k) texts.push_back(exported.substr(0, k));
  std::uint32_t dice = 1;  // Numerical Recipes' generator
  const auto random_below = [&](std::size_t count) {
    dice = 1664525U * dice + 1013904223U;
    return static_cast<std::size_t>(dice >> 8U) % count;
  };
  for (int k = 0; k < 2000; ++k) {
    std::string text = exported;
    for (std::size_t changes = 1 + random_below(4); changes > 0; --changes)
      text[random_below(text.size())] = letters[random_below(letters.size())];
    texts.push_back(text);
  }
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/traces.geojson";
  int good = 0, refused = 0;
  for (const auto& text : texts) {
    folder.write(text, "traces.geojson");
    hfrac::Definition def = new_def();
    const int32_t status = hfrac_sim_def_add_traces(&def, path.c_str());
    if (status == HFRAC_OK) {
      ++good;
      for (int64_t i = 0; i < def.joint_count; ++i)
        EXPECT_LE(std::abs(def.joints[i].x1) + std::abs(def.joints[i].y2), 2e6) << text;
      continue;
    }
    ++refused;
    ASSERT_EQ(status, HFRAC_ERR_CASE_FILE) << last_error() << "\n" << text;
    EXPECT_EQ(def.joint_count, 0);
    EXPECT_TRUE(last_error().starts_with(path)) << last_error();
  }
  EXPECT_GT(good, 100);  // properties are not looked at
  EXPECT_GT(refused, 1500);
}

}  // namespace geojson_test
