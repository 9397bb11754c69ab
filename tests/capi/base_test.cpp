// SPDX-License-Identifier: BSD-3-Clause
// Versions, status texts, the rules of text buffers, the last error.
#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "support.hpp"

namespace base_test {

using namespace testing_capi;

TEST(Base, VersionsAreThoseOfTheHeader) {
  int32_t major = -1, minor = -1, patch = -1, abi = -1;
  ASSERT_EQ(hfrac_version(&major, &minor, &patch), HFRAC_OK);
  EXPECT_EQ(major, HFRAC_VERSION_MAJOR);
  EXPECT_EQ(minor, HFRAC_VERSION_MINOR);
  EXPECT_EQ(patch, HFRAC_VERSION_PATCH);
  ASSERT_EQ(hfrac_abi_version(&abi), HFRAC_OK);
  EXPECT_EQ(abi, HFRAC_ABI_VERSION);
}

TEST(Base, VersionsRefuseNull) {
  int32_t number = 0;
  EXPECT_EQ(hfrac_version(nullptr, &number, &number), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_version(&number, nullptr, &number), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_version(&number, &number, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_abi_version(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "abi is NULL.");
}

TEST(Base, BuildInfoIsOneLine) {
  char text[256];
  int32_t needed = 0;
  ASSERT_EQ(hfrac_build_info(text, sizeof text, &needed), HFRAC_OK);
  EXPECT_EQ(std::string(text).size() + 1, static_cast<std::size_t>(needed));
  EXPECT_EQ(std::string(text).find('\n'), std::string::npos);
  EXPECT_EQ(std::string(text).rfind("hfrac 0.2.0, ", 0), 0u) << text;
}

TEST(Base, DevicesAreListedOrItIsSaidWhyThereAreNone) {
  char text[4096];
  int32_t count = -1, needed = 0;
  ASSERT_EQ(hfrac_devices(&count, text, sizeof text, &needed), HFRAC_OK);
  EXPECT_EQ(std::string(text).size() + 1, static_cast<std::size_t>(needed));
  EXPECT_GT(needed, 1);
  EXPECT_GE(count, 0);
  EXPECT_EQ(hfrac_devices(nullptr, text, sizeof text, &needed), HFRAC_ERR_ARGUMENT);
}

TEST(Base, EveryStatusHasItsOwnText) {
  std::set<std::string> texts;
#define HFRAC_ONE(name, value, text)                                              \
  {                                                                               \
    char buffer[256];                                                             \
    ASSERT_EQ(hfrac_status_text(name, buffer, sizeof buffer, nullptr), HFRAC_OK); \
    EXPECT_STREQ(buffer, text);                                                   \
    EXPECT_TRUE(texts.insert(buffer).second);                                     \
    EXPECT_EQ(static_cast<int>(name), value);                                     \
  }
  HFRAC_STATUS_LIST(HFRAC_ONE)
#undef HFRAC_ONE
  int32_t needed = 0;
  EXPECT_EQ(hfrac_status_text(-12345, nullptr, 0, &needed), HFRAC_ERR_ARGUMENT);
}

TEST(Base, TextsAreCutAndNeverOverrun) {
  char buffer[8] = {'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x'};
  int32_t needed = 0;
  ASSERT_EQ(hfrac_status_text(HFRAC_ERR_MEMORY, buffer, 4, &needed), HFRAC_OK);
  EXPECT_STREQ(buffer, "out");
  EXPECT_EQ(buffer[4], 'x');
  EXPECT_EQ(needed, 14);
  ASSERT_EQ(hfrac_status_text(HFRAC_ERR_MEMORY, buffer, 1, nullptr), HFRAC_OK);
  EXPECT_STREQ(buffer, "");
  EXPECT_EQ(hfrac_status_text(HFRAC_OK, nullptr, 0, &needed), HFRAC_OK);
  EXPECT_EQ(needed, 5);
}

TEST(Base, TextBuffersUsedWronglyAreRefused) {
  char buffer[8];
  int32_t needed = 0;
  EXPECT_EQ(hfrac_status_text(HFRAC_OK, nullptr, 8, &needed), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_status_text(HFRAC_OK, buffer, -1, &needed), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_status_text(HFRAC_OK, nullptr, 0, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_build_info(nullptr, 8, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_last_error(nullptr, nullptr, 8, nullptr), HFRAC_ERR_ARGUMENT);
}

TEST(Base, TextsAreNotCutInsideACharacter) {
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_set_str(&def, "title", "\xC3\xA4\xC3\xA4"), HFRAC_OK);
  char buffer[12];
  ASSERT_EQ(hfrac_sim_def_write(&def, buffer, sizeof buffer, nullptr), HFRAC_OK);
  EXPECT_STREQ(buffer, "title = \"\xC3\xA4");
  ASSERT_EQ(hfrac_sim_def_write(&def, buffer, sizeof buffer - 1, nullptr), HFRAC_OK);
  EXPECT_STREQ(buffer, "title = \"");
}

TEST(Base, AskingForTheLastErrorKeepsIt) {
  ASSERT_EQ(hfrac_abi_version(nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_last_error(nullptr, nullptr, -1, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "abi is NULL.");
  EXPECT_EQ(last_error(), "abi is NULL.");
}

TEST(Base, LastErrorsBelongToTheirThread) {
  ASSERT_EQ(hfrac_abi_version(nullptr), HFRAC_ERR_ARGUMENT);
  std::string other = "unset";
  std::thread([&] { other = last_error(); }).join();
  EXPECT_EQ(other, "");
  EXPECT_EQ(last_error(), "abi is NULL.");
}

TEST(Base, WhatIsNoSimulationIsRefused) {
  alignas(16) char memory[8192] = {};
  const auto* const no_sim = reinterpret_cast<const hfrac_sim*>(memory);
  int32_t needed = 0;
  EXPECT_EQ(hfrac_last_error(no_sim, nullptr, 0, &needed), HFRAC_ERR_BAD_HANDLE);
}

}  // namespace base_test
