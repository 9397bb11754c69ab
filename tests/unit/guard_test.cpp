// SPDX-License-Identifier: BSD-3-Clause
// The wrapping of every C function: exceptions become codes, conditions of a handle are kept, the host's
// floating-point environment comes back in callbacks and after the call.
#include <fenv.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "internal.hpp"

namespace guard_test {

using namespace hfrac;
using namespace hfrac::capi;

TEST(Guarded, TurnsExceptionsIntoCodesAndTexts) {
  EXPECT_EQ(guarded([] {}), HFRAC_OK);
  EXPECT_EQ(guarded([] { return std::int32_t{HFRAC_STOPPED}; }), HFRAC_STOPPED);
  EXPECT_EQ(guarded([] { throw Error(ErrorKind::diverged, "The pressure is not finite."); }),
            HFRAC_ERR_DIVERGED);
  EXPECT_EQ(thread_error().get(), "The pressure is not finite.");
  EXPECT_EQ(guarded([] { throw std::bad_alloc(); }), HFRAC_ERR_MEMORY);
  EXPECT_EQ(guarded([] { throw std::logic_error("wrong"); }), HFRAC_ERR_INTERNAL);
  EXPECT_EQ(thread_error().get(), "wrong");
  EXPECT_EQ(guarded([] { throw 7; }), HFRAC_ERR_INTERNAL);
}

TEST(Guarded, LongTextsAreCutBetweenCharacters) {
  ErrorText text;
  std::string longer(1022, 'x');
  longer += "\xC3\xA4\xC3\xA4";
  text.set(longer);
  EXPECT_EQ(text.get(), std::string(1022, 'x'));
}

TEST(GuardedSim, NullAndStrangersAreBadHandles) {
  HandleBase* none = nullptr;
  EXPECT_EQ(guarded_sim(none, [] {}), HFRAC_ERR_BAD_HANDLE);
  HandleBase stranger;
  stranger.cookie = 1;
  EXPECT_EQ(guarded_sim(&stranger, [] {}), HFRAC_ERR_BAD_HANDLE);
  EXPECT_EQ(stranger.last_error.get(), "");
  EXPECT_EQ(thread_error().get(), "sim is not a living simulation: never created, or destroyed already.");
}

TEST(GuardedSim, ErrorsStayWithTheirHandle) {
  thread_error().set("before");
  HandleBase one, other;
  EXPECT_EQ(guarded_sim(&one, [] { throw Error(ErrorKind::argument, "index = 9"); }), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(one.last_error.get(), "index = 9");
  EXPECT_EQ(other.last_error.get(), "");
  EXPECT_EQ(thread_error().get(), "before");
  EXPECT_FALSE(one.poisoned);
}

TEST(GuardedSim, UnknownStatesPoison) {
  HandleBase sim;
  const HandleBase& reader = sim;
  EXPECT_EQ(guarded_sim(&reader, [] { throw std::logic_error("while reading"); }), HFRAC_ERR_INTERNAL);
  EXPECT_FALSE(sim.poisoned);
  EXPECT_EQ(guarded_sim(&sim, [] { throw std::logic_error("while changing"); }), HFRAC_ERR_INTERNAL);
  EXPECT_TRUE(sim.poisoned);
  EXPECT_EQ(guarded_sim(&sim, [] {}), HFRAC_ERR_POISONED);
  EXPECT_EQ(guarded_sim(&reader, [] {}), HFRAC_ERR_POISONED);
  EXPECT_EQ(sim.last_error.get(), "while changing");
}

TEST(CallHost, ReadingIsAllowedChangingIsNot) {
  HandleBase sim;
  const HandleBase& reader = sim;
  std::int32_t read = -1, changed = -1;
  EXPECT_EQ(guarded_sim(&sim,
                        [&] {
                          call_host(&sim, [&] {
                            read = guarded_sim(&reader, [] {});
                            changed = guarded_sim(&sim, [] {});
                          });
                        }),
            HFRAC_OK);
  EXPECT_EQ(read, HFRAC_OK);
  EXPECT_EQ(changed, HFRAC_ERR_BUSY);
  EXPECT_EQ(guarded_sim(&sim, [] {}), HFRAC_OK);
}

TEST(CallHost, ExceptionsOfTheHostLeaveNoTrace) {
  HandleBase sim;
  EXPECT_EQ(guarded_sim(&sim, [&] { call_host(&sim, [] { throw 1; }); }), HFRAC_ERR_CALLBACK);
  EXPECT_FALSE(sim.in_callback);
}

TEST(CallHost, GivesTheHostItsOwnEnvironment) {
  fesetround(FE_DOWNWARD);
  int inside = -1, in_callback = -1, deeper = -1, after_callback = -1;
  guarded([&] {
    inside = fegetround();
    call_host(nullptr, [&] {
      in_callback = fegetround();
      guarded([&] { deeper = fegetround(); });
    });
    after_callback = fegetround();
  });
  const int after = fegetround();
  fesetround(FE_TONEAREST);
  EXPECT_EQ(inside, FE_TONEAREST);
  EXPECT_EQ(in_callback, FE_DOWNWARD);
  EXPECT_EQ(deeper, FE_TONEAREST);
  EXPECT_EQ(after_callback, FE_TONEAREST);
  EXPECT_EQ(after, FE_DOWNWARD);
}

}  // namespace guard_test
