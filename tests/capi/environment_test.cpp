// SPDX-License-Identifier: BSD-3-Clause
// The host's environment is the host's: floating-point traps, rounding, flags and locale neither change
// results nor are changed. Fortran hosts run with traps (-ffpe-trap), and many German ones with a decimal
// comma.
#include <fenv.h>
#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <locale>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "sim_support.hpp"

namespace environment_test {

using namespace testing_capi;

TEST(Environment, TrapsOfTheHostDoNotFireInsideAndStayOn) {
  const TemporaryFolder folder;
  const std::string path = folder.write("[disc]\ndensity = nan\n");
  hfrac::Definition def = sound_def();
  feclearexcept(FE_ALL_EXCEPT);
  const int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  feenableexcept(traps);
  EXPECT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "disc.density", std::nan("")), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK);
  EXPECT_EQ(fegetexcept() & traps, traps);
  fedisableexcept(FE_ALL_EXCEPT);
}

TEST(Environment, FlagsAndRoundingOfTheHostStay) {
  hfrac::Definition def = sound_def();
  const std::string expected = written(def);
  feclearexcept(FE_ALL_EXCEPT);
  feraiseexcept(FE_OVERFLOW);
  fesetround(FE_UPWARD);
  EXPECT_EQ(written(def), expected);
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK);
  EXPECT_EQ(fegetround(), FE_UPWARD);
  EXPECT_EQ(fetestexcept(FE_ALL_EXCEPT), FE_OVERFLOW);
  fesetround(FE_TONEAREST);
  feclearexcept(FE_ALL_EXCEPT);
}

#if defined(__SSE__)
TEST(Environment, DenormalsAreKeptInsideThoughTheHostFlushesThem) {
  const TemporaryFolder folder;
  const std::string path = folder.write("[[well]]\nradius = 3\nrate = 1e-310\n");
  hfrac::Definition def = new_def();
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040U);  // flush to zero, denormals are zero
  const int32_t status = hfrac_sim_def_load(&def, path.c_str());
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(status, HFRAC_OK) << last_error();
  EXPECT_EQ(after & 0x8040U, 0x8040U);
  EXPECT_EQ(def.wells[0].rate, 1e-310);
}
#endif

// A signal that the host's thread holds back waits for it; no thread of ours takes it instead.
TEST(Environment, SignalsOfTheHostStayWithItsThreads) {
  static volatile sig_atomic_t handled = 0;
  struct sigaction ours {
  }, before{};
  ours.sa_handler = [](int) { handled = handled + 1; };
  sigaction(SIGALRM, &ours, &before);
  hfrac::Definition def = cracking_def();
  def.run_workers = 3;
  const Sim sim(def);
  sigset_t alarm_only;
  sigemptyset(&alarm_only);
  sigaddset(&alarm_only, SIGALRM);
  pthread_sigmask(SIG_BLOCK, &alarm_only, nullptr);
  handled = 0;
  ::kill(::getpid(), SIGALRM);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  EXPECT_EQ(handled, 0);
  sigset_t waiting;
  sigpending(&waiting);
  EXPECT_EQ(sigismember(&waiting, SIGALRM), 1);
  pthread_sigmask(SIG_UNBLOCK, &alarm_only, nullptr);
  EXPECT_EQ(handled, 1);
  sigaction(SIGALRM, &before, nullptr);
}

// A host in Germany: its C and its C++ locale write 1.234,5.
class GermanNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

bool use_decimal_comma() {
  if (const char* folder = std::getenv("HFRAC_TEST_LOCALES")) ::setenv("LOCPATH", folder, 1);
  const bool found = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  ::unsetenv("LOCPATH");
  std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
  return found && std::setlocale(LC_ALL, nullptr) != std::string("C");
}

TEST(Environment, LocaleOfTheHostChangesNothing) {
  const TemporaryFolder folder;
  if (!use_decimal_comma()) {
    std::locale::global(std::locale::classic());
    GTEST_SKIP() << "no locale with a decimal comma can be had";
  }
  EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  hfrac::Definition def = sound_def();
  def.model_width = 100.5;
  def.packing_disc_count = 1234567;
  const std::string text = written(def);
  EXPECT_NE(text.find("width = 100.5\n"), std::string::npos);
  EXPECT_NE(text.find("disc_count = 1234567\n"), std::string::npos);
  hfrac::Definition read = new_def();
  EXPECT_EQ(hfrac_sim_def_load(&read, folder.write(text).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(read.model_width, 100.5);
  def.packing_porosity = 0.9;
  def.packing_disc_count = 1000000000;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(last_error(), "packing.disc_count = 1000000000 is outside 20 to 100000000.");
  EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  std::locale::global(std::locale::classic());  // C's too
}

}  // namespace environment_test
