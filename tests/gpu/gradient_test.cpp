// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients on a device beside those of workers: the same bits, whether levels are many, one, or none is merged; and what is sent.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "core/device.hpp"
#include "emulated.hpp"
#include "linear/conjugate_gradient.hpp"
#include "pore_grid.hpp"

namespace {
using namespace hfrac;

constexpr PassRules rules{1e-6, 1e-11, 20, 2000};

class GradientOnADevice : public testing::Test {
 protected:
  void SetUp() override {
    std::string why_none;
    device_ = Device::open_first(why_none);
    ASSERT_NE(device_, nullptr) << why_none;
  }
  std::unique_ptr<Device> device_;
};

TEST_F(GradientOnADevice, HasTheBitsOfWorkers) {
  for (const int side : {7, 40, 150}) {
    ConjugateGradient here, there(nullptr, device_.get());
    // One pattern, other values: with much stored hardly a row is merged.
    for (const auto& [storage, crack] : {std::pair{1e-3, 1e6}, {0.0, 1.0}, {1e3, 1e2}, {1e-3, 1e2}}) {
      const auto lower = grid(side, storage, crack);
      Eigen::VectorXd rhs = Eigen::VectorXd::Zero(lower.cols()), x = rhs, y = rhs;
      rhs[lower.cols() / 2] = 1.0;
      ASSERT_TRUE(here.prepare(lower) && there.prepare(lower));
      ASSERT_TRUE(here.settle(rhs, x, rules));
      ASSERT_TRUE(there.settle(rhs, y, rules));
      EXPECT_GT(x.maxCoeff(), 0.0);
      EXPECT_TRUE((x.array() == y.array()).all()) << side << ' ' << storage << ' ' << crack;
      x.setZero();
      EXPECT_TRUE(there.settle(x, x, rules)) << "nothing to do";
      EXPECT_EQ(x.cwiseAbs().maxCoeff(), 0.0);
    }
  }
}

// Matrices of many levels, of one, of cracks that are a level as they are, and of other places by turns: nothing of one stays for the next.
TEST_F(GradientOnADevice, HasTheBitsOfWorkersWhateverCameBefore) {
  ConjugateGradient there(nullptr, device_.get());
  const auto deep = grid(150, 1e-3, 1e6), other = with_a_shortcut(deep), shallow = grid(150, 1e3, 1e2),
             cracked = crossing_cracks(150, 1e-10, 1);
  for (const auto* lower : {&deep, &shallow, &other, &cracked, &shallow, &cracked, &deep}) {
    ConjugateGradient here;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(lower->cols()), x = rhs, y = rhs;
    rhs[lower->cols() / 2] = 1.0;
    ASSERT_TRUE(here.prepare(*lower) && there.prepare(*lower));
    ASSERT_TRUE(here.settle(rhs, x, rules));
    ASSERT_TRUE(there.settle(rhs, y, rules));
    EXPECT_TRUE((x.array() == y.array()).all());
  }
}

TEST_F(GradientOnADevice, SaysSoWhereIterationsOrPassesAreNotEnough) {
  const auto lower = grid(60, 0.0, 1e4);
  for (const PassRules& few : {PassRules{1e-6, 1e-11, 20, 5}, PassRules{1e-1, 1e-11, 2, 2000}}) {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(lower.cols()), x = rhs, y = rhs;
    rhs[lower.cols() / 2] = 1.0;
    ConjugateGradient here, there(nullptr, device_.get());
    ASSERT_TRUE(here.prepare(lower) && there.prepare(lower));
    EXPECT_FALSE(here.settle(rhs, x, few));
    EXPECT_FALSE(there.settle(rhs, y, few));
  }
}

// Of the finest level a second matrix of the same pattern sends no pattern; an emulated driver counts bytes.
TEST_F(GradientOnADevice, SendsAPatternOnce) {
  if (emulated::bytes().sent < 0) GTEST_SKIP() << "not the emulated driver";
  ConjugateGradient there(nullptr, device_.get());
  const auto sent = [&](double storage) {
    const auto lower = grid(60, storage, 1.0);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(lower.cols()), x = rhs;
    rhs[0] = 1.0;
    const auto before = emulated::bytes().sent;
    EXPECT_TRUE(there.prepare(lower) && there.settle(rhs, x, rules));
    return emulated::bytes().sent - before;
  };
  const auto first = sent(1e3), second = sent(2e3);  // one level, of 3600 rows and 14 160 entries
  EXPECT_GE(first - second, 4 * (3601 + 2 * 3600 + 14160));
  EXPECT_LT(second, 8 * (14160 + 4 * 3600) + 4 * 3600 + 2000) << "values, diagonal, weight, b, x, aggregates";
}

}  // namespace
