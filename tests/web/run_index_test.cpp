// SPDX-License-Identifier: BSD-3-Clause
// The index of a run folder, whole, growing, empty or damaged.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "web/server/guards.hpp"
#include "web/server/run_index.hpp"

namespace {

namespace fs = std::filesystem;
using hfrac::web::describe_run;

class Index : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("hfrac-index-" + hfrac::web::random_key());
    fs::create_directories(folder_ / "pictures");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  void list(const char* series, const std::vector<int>& steps) const {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>\n";
    for (const int step : steps)
      text += "<DataSet timestep=\"" + std::to_string(0.5 * step) + "\" group=\"\" part=\"0\" file=\"" +
              series + "_" + std::to_string(step) + ".vtu\"/>\n";
    write((std::string(series) + ".pvd").c_str(), text + "</Collection></VTKFile>\n");
  }

  fs::path folder_;
};

TEST_F(Index, OfAnEmptyFolderHasNothing) {
  for (const auto& folder : {folder_, folder_ / "missing"}) {
    const auto index = describe_run(folder);
    EXPECT_TRUE(index["snapshots"].empty());
    EXPECT_TRUE(index["summary"].is_null());
    EXPECT_FALSE(index["running"]);
    EXPECT_EQ(index["age_s"], -1);
    EXPECT_EQ(index["identity"], "");
  }
}

TEST_F(Index, ListsSnapshotsInOrderOfSteps) {
  list("discs", {0, 5, 100});
  list("cracks", {0, 5});  // the lists are written one after the other
  list("flow", {0, 5, 100, 105});
  const auto index = describe_run(folder_);
  ASSERT_EQ(index["snapshots"].size(), 3U);
  EXPECT_EQ(index["snapshots"][1]["step"], 5);
  EXPECT_EQ(index["snapshots"][1]["time_s"], 2.5);
  EXPECT_EQ(index["snapshots"][1]["files"]["cracks"], "cracks_5.vtu");
  EXPECT_EQ(index["snapshots"][2]["files"].size(), 2U);
}

TEST_F(Index, TellsOneRunFromTheNext) {
  write("case.toml", "a");
  write("summary.json", R"({"ended": "running", "title": "T"})");
  write("history.csv", "step\n");
  const auto first = describe_run(folder_);
  EXPECT_TRUE(first["running"]);
  EXPECT_GE(first["age_s"], 0);
  EXPECT_EQ(first["identity"], describe_run(folder_)["identity"]);
  write("case.new", "a");
  fs::rename(folder_ / "case.new", folder_ / "case.toml");  // as hfrac writes files
  EXPECT_NE(first["identity"], describe_run(folder_)["identity"]);
}

TEST_F(Index, ListsTablesAndPictures) {
  write("history.csv", "12345");
  write("pictures/growth.png", "123");
  write("pictures/.growth.png.tmp", "1");
  write("notes.txt", "mine");
  const auto files = describe_run(folder_)["files"];
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0]["name"], "history.csv");
  EXPECT_EQ(files[0]["bytes"], 5);
  EXPECT_EQ(files[1]["name"], "pictures/growth.png");
}

TEST_F(Index, SurvivesDamage) {
  for (const char* text : {"", "{", "[1]", "nonsense", "\xff\xfe"}) {
    write("summary.json", text);
    write("discs.pvd", text);
    write("cracks.pvd",
          "<?xml version=\"1.0\"?><VTKFile><Collection><DataSet file=\"x\"/></Collection></VTKFile>");
    const auto index = describe_run(folder_);
    EXPECT_TRUE(index["summary"].is_null()) << text;
    EXPECT_TRUE(index["snapshots"].empty()) << text;
  }
}

}  // namespace
