// SPDX-License-Identifier: BSD-3-Clause
// The server's rules: who may ask, and which files may be had.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>

#include "web/server/guards.hpp"

namespace {

namespace fs = std::filesystem;
using hfrac::web::file_inside;
using hfrac::web::is_loopback_host;

TEST(Guards, AnswersToLoopbackNamesOnly) {
  for (const char* host :
       {"localhost", "LOCALHOST:8020", "127.0.0.1", "127.0.0.1:1", "127.1.2.3:65535", "[::1]", "[::1]:8020"})
    EXPECT_TRUE(is_loopback_host(host)) << host;
  for (const char* host : {"",
                           ":8020",
                           "evil.example",
                           "localhost.evil.example",
                           "127.0.0.1.evil.example",
                           "127.0.0.1:80:80",
                           "127.0.0.1@evil.example",
                           "evil.example:127.0.0.1",
                           "128.0.0.1",
                           "127.0.0",
                           "127.0.0.0.1",
                           "127.0.0.256",
                           "127.0.0.1:65536",
                           "127.0.0.1:",
                           "localhost:-1",
                           "0.0.0.0",
                           "[::]",
                           "::1",
                           "10.0.0.1",
                           "127.0.0.1 "})
    EXPECT_FALSE(is_loopback_host(host)) << host;
}

TEST(Guards, KeysAreLongAndDiffer) {
  std::set<std::string> keys;
  for (int i = 0; i < 100; ++i) {
    const std::string key = hfrac::web::random_key();
    EXPECT_EQ(key.size(), 32U);
    for (const char digit : key) EXPECT_TRUE(std::isxdigit(static_cast<unsigned char>(digit)));
    keys.insert(key);
  }
  EXPECT_EQ(keys.size(), 100U);
}

class Files : public testing::Test {
 protected:
  void SetUp() override {
    top_ = fs::temp_directory_path() / ("hfrac-guards-" + hfrac::web::random_key());
    run_ = top_ / "run";
    fs::create_directories(run_ / "pictures");
    fs::create_directories(run_ / "folder.csv");
    fs::create_directories(top_ / "run-other");
    for (const char* name :
         {"run/history.csv", "run/discs_00000.vtu", "run/pictures/growth.png", "run/.hidden.csv",
          "run/notes.txt", "run/odd name é.csv", "secret.csv", "run-other/a.csv"})
      std::ofstream(top_ / name) << "x";
    fs::create_symlink(top_ / "secret.csv", run_ / "out.csv");
    fs::create_symlink("../secret.csv", run_ / "up.csv");
    fs::create_symlink(top_ / "run-other", run_ / "other");
    fs::create_symlink("history.csv", run_ / "inside.csv");
    fs::create_symlink("nowhere.csv", run_ / "dangling.csv");
    fs::create_symlink("loop.csv", run_ / "loop.csv");
  }
  void TearDown() override { fs::remove_all(top_); }

  fs::path top_, run_;
};

TEST_F(Files, OfTheRunAreServed) {
  for (const char* name : {"history.csv", "discs_00000.vtu", "pictures/growth.png", "odd name é.csv"})
    EXPECT_EQ(file_inside(run_, name), fs::canonical(run_ / name)) << name;
  EXPECT_EQ(file_inside(run_, "inside.csv"), fs::canonical(run_ / "history.csv"));
}

TEST_F(Files, AreFoundThroughALinkToTheFolder) {
  fs::create_directory_symlink(run_, top_ / "link");
  EXPECT_EQ(file_inside(top_ / "link", "history.csv"), fs::canonical(run_ / "history.csv"));
}

TEST_F(Files, OutsideAreNot) {
  for (const char* name :
       {"../secret.csv", "pictures/../../secret.csv", "pictures/../history.csv", "/etc/passwd", "/secret.csv",
        "//secret.csv", "..", ".", "", "./history.csv", "..\\secret.csv", "pictures\\growth.png",
        "%2e%2e/secret.csv", "../run-other/a.csv"})
    EXPECT_EQ(file_inside(run_, name), std::nullopt) << name;
  EXPECT_EQ(file_inside(run_, (top_ / "secret.csv").string()), std::nullopt);
  EXPECT_EQ(file_inside(run_, std::string("history.csv\0.png", 16)), std::nullopt);
}

TEST_F(Files, BehindLinksThatLeadOutAreNot) {
  for (const char* name : {"out.csv", "up.csv", "other/a.csv", "dangling.csv", "loop.csv"})
    EXPECT_EQ(file_inside(run_, name), std::nullopt) << name;
}

TEST_F(Files, ThatAreNoFilesOfARunAreNot) {
  for (const char* name : {".hidden.csv", "notes.txt", "pictures", "pictures/", "folder.csv", "history.csv/",
                           "missing.csv", "history"})
    EXPECT_EQ(file_inside(run_, name), std::nullopt) << name;
  EXPECT_EQ(file_inside(top_ / "missing", "history.csv"), std::nullopt);
}

}  // namespace
