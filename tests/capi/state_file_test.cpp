// SPDX-License-Identifier: BSD-3-Clause
// States in files: there whole or not at all, and refused unless they are what they should be.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "sim_support.hpp"

namespace state_file_test {

using namespace testing_capi;
namespace fs = std::filesystem;

class StateFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "hfrac_state_XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::string file(const char* name = "state") const { return (folder_ / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().filename());
    return found;
  }
  static std::vector<char> bytes_of(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& path, const std::vector<char>& bytes) const {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  // Loading `path` is refused with a text that has `words`, and changes nothing.
  static void expect_refused(hfrac_sim* sim, const std::string& path, const char* words) {
    const int64_t before = hash_of(sim);
    EXPECT_EQ(hfrac_state_load_file(sim, path.c_str()), HFRAC_ERR_FILE) << words;
    EXPECT_NE(last_error(sim).find(words), std::string::npos) << last_error(sim);
    EXPECT_NE(last_error(sim).find(path), std::string::npos) << last_error(sim);
    EXPECT_EQ(hash_of(sim), before) << words;
  }

  fs::path folder_;
};

TEST_F(StateFile, LoadThenRunEqualsRun) {
  const Sim sim(cracking_def());
  ASSERT_GE(hfrac_step(sim, 2), 0);
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK) << last_error(sim);
  EXPECT_EQ(names(), std::vector<std::string>{"state"});
  const int64_t saved = hash_of(sim);
  ASSERT_GE(hfrac_step(sim, 2), 0);
  const int64_t end = hash_of(sim);

  const Sim other(cracking_def());  // as another process would
  ASSERT_EQ(hfrac_state_load_file(other, file().c_str()), HFRAC_OK) << last_error(other);
  EXPECT_EQ(hash_of(other), saved);
  EXPECT_EQ(state_of(other).step, 2);
  ASSERT_GE(hfrac_step(other, 2), 0);
  EXPECT_EQ(hash_of(other), end);
  EXPECT_GT(state_of(other).crack_count, 0);
}

TEST_F(StateFile, AnOlderFileIsReplaced) {
  const Sim sim(cracking_def());
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  const int64_t saved = hash_of(sim);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  ASSERT_EQ(hfrac_state_load_file(sim, file().c_str()), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), saved);
}

TEST_F(StateFile, WhatIsNotASavedStateIsRefused) {
  const Sim sim(cracking_def());
  ASSERT_GE(hfrac_step(sim, 1), 0);
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  const auto good = bytes_of(file());
  ASSERT_GT(good.size(), 1000U);

  expect_refused(sim, file("missing"), "cannot be read");
  expect_refused(sim, folder_.string(), "not a regular file");
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  expect_refused(sim, file("pipe"), "not a regular file");
  write(file("empty"), {});
  expect_refused(sim, file("empty"), "shorter");
  write(file("text"), std::vector<char>(5000, 'x'));
  expect_refused(sim, file("text"), "not an image of this library");
  auto cut = good;
  cut.resize(cut.size() - 1);
  write(file("cut"), cut);
  expect_refused(sim, file("cut"), "was cut");
  auto longer = good;
  longer.push_back(0);
  write(file("longer"), longer);
  expect_refused(sim, file("longer"), "something was added");
  auto newer = good;
  newer[8] = 77;  // the format
  write(file("newer"), newer);
  expect_refused(sim, file("newer"), "its format is 77");
  auto foreign = good;
  std::swap(foreign[12], foreign[15]);  // the byte order
  std::swap(foreign[13], foreign[14]);
  write(file("foreign"), foreign);
  expect_refused(sim, file("foreign"), "byte order");
  fs::resize_file(file("text"), 1ULL << 40U);  // a terabyte of nothing
  expect_refused(sim, file("text"), "more than any state");
}

// Wherever a byte flips, the file is refused.
TEST_F(StateFile, EveryDamageIsSeen) {
  const Sim sim(quiet_def(300));
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  const auto good = bytes_of(file());
  const int64_t before = hash_of(sim);
  const std::size_t stride = std::max<std::size_t>(1, good.size() / 200);
  for (std::size_t at = 0; at < good.size(); at += at < 64 ? 1 : stride) {
    auto damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write(file("damaged"), damaged);
    ASSERT_EQ(hfrac_state_load_file(sim, file("damaged").c_str()), HFRAC_ERR_FILE) << "byte " << at;
    ASSERT_EQ(hash_of(sim), before) << "byte " << at;
  }
  EXPECT_EQ(hfrac_state_load_file(sim, file().c_str()), HFRAC_OK);
}

TEST_F(StateFile, AnotherModelIsRefused) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  const auto another = [&](auto&& change) {
    hfrac::Definition def = quiet_def();
    change(def);
    return def;
  };
  const hfrac::Definition others[] = {
      another([](auto& def) { def.model_seed = 2; }),
      another([](auto& def) { def.packing_disc_count = 400; }),
      another([](auto& def) { def.bond_normal_stiffness *= 1.0 + 1e-12; }),
      another([](auto& def) { def.fluid_viscosity = 0.2; }),
      another([](auto& def) { def.flow_gap_factor = 0.5; }),
      another([](auto& def) { def.wells[0].radius = 12.0; }),
  };
  for (const auto& def : others) {
    const Sim other(def);
    expect_refused(other, file(), "another model");
  }
  // What only says how long a run is, or how many work on it, may differ.
  const Sim same(another([](auto& def) {
    def.run_workers = 2;
    def.stepping_flow_step = 0.5;
    def.stop_cracks = 7;
    def.output_every = 3;
  }));
  EXPECT_EQ(hfrac_state_load_file(same, file().c_str()), HFRAC_OK) << last_error(same);
  EXPECT_EQ(hash_of(same), hash_of(sim));
}

TEST_F(StateFile, WhereNothingCanBeWrittenNothingIsLeft) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  const auto old = bytes_of(file());
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);

  EXPECT_EQ(hfrac_state_save_file(sim, "/nonexistent/folder/state"), HFRAC_ERR_FILE);
  EXPECT_NE(last_error(sim).find("/nonexistent/folder/state"), std::string::npos) << last_error(sim);
  EXPECT_EQ(hfrac_state_save_file(sim, ""), HFRAC_ERR_FILE);
  EXPECT_EQ(hfrac_state_save_file(sim, folder_.c_str()), HFRAC_ERR_FILE) << "a folder";
  EXPECT_FALSE(fs::exists(folder_.string() + ".part"));

  // A full disk, as a process sees it that may write no larger files.
  const ::pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const ::rlimit few{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &few);
    const bool refused = hfrac_state_save_file(sim, file().c_str()) == HFRAC_ERR_FILE &&
                         last_error(sim).find("room") != std::string::npos;
    ::_exit(refused ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(names(), std::vector<std::string>{"state"});
  EXPECT_EQ(bytes_of(file()), old) << "the file that was there is as it was";
  EXPECT_EQ(hfrac_step(sim, 1), HFRAC_OK);
}

TEST_F(StateFile, DevicesAreNoStates) {
  const Sim sim(quiet_def());
  EXPECT_EQ(hfrac_state_load_file(sim, "/dev/null"), HFRAC_ERR_FILE);
  EXPECT_EQ(hfrac_state_load_file(sim, "/dev/zero"), HFRAC_ERR_FILE);
}

TEST_F(StateFile, AnOpenStepRefusesToLoad) {
  const Sim sim(quiet_def());
  ASSERT_EQ(hfrac_state_save_file(sim, file().c_str()), HFRAC_OK);
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_state_load_file(sim, file().c_str()), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_state_load_file(sim, file().c_str()), HFRAC_OK);
}

}  // namespace state_file_test
