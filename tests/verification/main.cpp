// SPDX-License-Identifier: BSD-3-Clause
// Runs the verification cases. A test that printed no figure (report in support.hpp) fails, so that the table of tests/verify has
// measured, analytic, error and tolerance for each.
#include <gtest/gtest.h>

#include "support.hpp"

namespace {

class FigureCheck : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& /*test*/) override { verification::figure_count = 0; }
  void OnTestEnd(const testing::TestInfo& test) override {
    if (verification::figure_count == 0 && !test.result()->Skipped())
      ADD_FAILURE() << test.name() << " printed no figure; see report() in tests/verification/support.hpp";
  }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new FigureCheck);  // owned by the list
  return RUN_ALL_TESTS();
}
