// SPDX-License-Identifier: BSD-3-Clause
// What `hfrac analyse` reads from a fall-off and from a step-rate test, against records made from known closure: Carter's leak-off
// before it, P = ISIP - slope G, and another slope after it, without and with noise. Tolerance: 3 % of time, G and pressure drop at closure.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

#include "command/falloff.hpp"
#include "command/step_rate.hpp"

namespace {

using namespace hfrac::command;

struct Made {
  double injection = 600.0;         // s
  double closure = 1.5;             // G
  double isip = 32e6, slope = 2e6;  // Pa, Pa over G
  double after = 0.4;               // slope after closure over that before it
  double length = 6000.0;           // s
  double every = 1.0;               // s
  double noise = 0.0;               // Pa
  unsigned seed = 1;
  LeakOff leak_off = LeakOff::little;
};

Falloff made(const Made& m) {
  std::mt19937_64 random(m.seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  Falloff falloff{m.injection, {}, {}};
  for (double since = 0.0; since <= m.length; since += m.every) {
    const double g = nolte_g(since / m.injection, m.leak_off);
    falloff.since.push_back(since);
    falloff.pressure.push_back(m.isip -
                               m.slope * (std::min(g, m.closure) + m.after * std::max(0.0, g - m.closure)) +
                               m.noise * noise(random));
  }
  return falloff;
}

/** Time of a G, by halving. */
double since_of(double g, const Made& m) {
  double low = 0.0, high = 1e6;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (nolte_g(middle, m.leak_off) < g ? low : high) = middle;
  }
  return low * m.injection;
}

void expect_at(const char* what, const std::optional<Closure>& found, const Made& m) {
  const double drop = m.slope * m.closure, since = since_of(m.closure, m);
  ASSERT_TRUE(found.has_value()) << what;
  std::printf(", %s %.4g s, %.3f MPa", what, found->since, found->pressure * 1e-6);
  EXPECT_NEAR(found->since, since, 0.03 * since) << what;
  EXPECT_NEAR(found->pressure, m.isip - drop, 0.03 * drop) << what;
}

// By G and by the root of time where the pressure falls slower after closure, by stiffness where it falls faster; not otherwise.
void expect_closure(const Made& m) {
  const FalloffReading found = read_falloff(made(m), m.leak_off);
  ASSERT_TRUE(found.isip.has_value());
  std::printf("seed %u, noise %g Pa, closure made at %.4g s, %.3f MPa: ISIP %.3f MPa", m.seed, m.noise,
              since_of(m.closure, m), (m.isip - m.slope * m.closure) * 1e-6, *found.isip * 1e-6);
  EXPECT_NEAR(*found.isip, m.isip, 0.03 * m.slope * m.closure);
  ASSERT_TRUE(found.line.has_value());
  EXPECT_NEAR(found.line->slope, -m.slope, 0.03 * m.slope);
  if (m.after < 1.0) {
    expect_at("by G", found.by_g, m);
    expect_at("by root", found.by_root, m);
    EXPECT_FALSE(found.by_stiffness.has_value()) << found.by_stiffness->x;
    EXPECT_NEAR(found.by_g->x, m.closure, 0.03 * m.closure);
  } else {
    expect_at("by stiffness", found.by_stiffness, m);
    EXPECT_FALSE(found.by_g.has_value()) << found.by_g->x;
  }
  std::printf("\n");
}

TEST(NolteTime, IsThatOfTheLimits) {
  for (const LeakOff leak_off : {LeakOff::little, LeakOff::most})
    EXPECT_NEAR(nolte_g(0.0, leak_off), 0.0, 1e-15);
  // g(1) = 4/3 (2^1.5 - 1) and 2 asin(2^-0.5) + 1 = pi/2 + 1 (Nolte 1979).
  EXPECT_NEAR(nolte_g(1.0, LeakOff::little), 16.0 / (3.0 * M_PI) * (std::sqrt(8.0) - 2.0), 1e-14);
  EXPECT_NEAR(nolte_g(1.0, LeakOff::most), 4.0 / M_PI, 1e-14);
  // Long after shut-in both are 4 d^0.5 / pi times a number: 4/3 * 3/2 = 2 and 2.
  EXPECT_NEAR(nolte_g(1e8, LeakOff::little) / 1e4, 8.0 / M_PI, 1e-3);
  EXPECT_NEAR(nolte_g(1e8, LeakOff::most) / 1e4, 8.0 / M_PI, 1e-3);
}

TEST(Closure, IsFoundWithoutNoise) {
  for (const double closure : {0.4, 0.8, 1.5, 3.0}) {
    for (const double after : {0.3, 0.6, 2.0}) {
      Made m;
      m.closure = closure;
      m.after = after;
      m.length = 4.0 * since_of(closure, m);
      m.every = m.length / 4000.0;
      expect_closure(m);
    }
  }
}

TEST(Closure, IsFoundWithMostLeakOff) {
  Made m;
  m.leak_off = LeakOff::most;
  expect_closure(m);
}

TEST(Closure, IsFoundInNoise) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Made m;
    m.seed = seed;
    m.noise = seed <= 6 ? 2e3 : 1e4;  // a gauge of 0.01 % of 20 MPa, and a poor one
    m.after = seed % 3 == 0 ? 2.0 : 0.4;
    expect_closure(m);
  }
}

TEST(Closure, IsFoundInFewRows) {
  Made m;
  m.every = 20.0;
  expect_closure(m);
}

TEST(Closure, IsFoundInAMillionRows) {
  Made m;
  m.every = 0.006;
  m.noise = 1e4;
  expect_closure(m);
}

TEST(Closure, IsNotThereInAFallOffThatIsTooShort) {
  Made m;
  m.length = 0.9 * since_of(m.closure, m);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    m.seed = seed;
    m.noise = seed == 1 ? 0.0 : 1e4;
    const auto found = read_falloff(made(m), m.leak_off);
    EXPECT_FALSE(found.by_g.has_value()) << "seed " << seed << " G " << found.by_g->x;
    EXPECT_FALSE(found.by_root.has_value()) << "seed " << seed << " " << found.by_root->since;
    ASSERT_EQ(found.notes.size(), 2U);
    EXPECT_NE(found.notes[0].find("does not fall below its line"), std::string::npos) << found.notes[0];
    EXPECT_NE(found.notes[1].find("inflection"), std::string::npos) << found.notes[1];
  }
}

TEST(Closure, IsNotThereInAFewRowsOrInNoiseAlone) {
  Made m;
  m.length = 10.0;
  EXPECT_NE(read_falloff(made(m), m.leak_off).notes.at(0).find("20 are needed"), std::string::npos);
  m.length = 6000.0;
  m.slope = 100.0;
  m.noise = 1e5;
  const auto found = read_falloff(made(m), m.leak_off);
  EXPECT_FALSE(found.by_g.has_value());
  EXPECT_NE(found.notes.at(0).find("no straight line"), std::string::npos);
}

/** Steps of ten minutes; the pressure of each rises to its end. */
InjectionRecord stepped(const std::vector<double>& rates, double slope, double extension, double flatter,
                        double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> waver(0.0, 1.0);
  InjectionRecord record;
  for (int k = 0; k <= static_cast<int>(rates.size()) * 600; ++k) {
    const auto step = static_cast<std::size_t>(k / 600);
    const bool shut = step >= rates.size();
    const double rate = shut ? 0.0 : rates[step];
    const double q = rates[std::min(static_cast<std::size_t>(std::max(0, k - 1) / 600), rates.size() - 1)];
    const double end = 20e6 + slope * std::min(q, extension) + flatter * slope * std::max(0.0, q - extension);
    const double wait = std::max(0, k - 1) % 600;
    record.time.push_back(k);
    record.rate.push_back(shut ? 0.0 : rate * (1.0 + 0.005 * waver(random)));
    record.pressure.push_back(end - 1e5 * std::exp(-wait / 60.0) + noise * waver(random));
  }
  return record;
}

TEST(StepRate, FindsThePressureOfExtension) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto record = stepped({1e-3, 2e-3, 3e-3, 4e-3, 6e-3, 8e-3, 10e-3}, 2e9, 4.5e-3, 0.25, 2e4, seed);
    const auto found = read_step_rate(record, find_shut_in(record));
    ASSERT_EQ(found.steps.size(), 7U);
    ASSERT_TRUE(found.pressure.has_value()) << found.note;
    std::printf("seed %u: extension at %.3f MPa, %.3g m2/s\n", seed, *found.pressure * 1e-6, *found.rate);
    EXPECT_NEAR(*found.pressure, 29e6, 0.03 * 9e6);
    EXPECT_NEAR(found.slope_after / found.slope_before, 0.25, 0.03);
  }
}

TEST(StepRate, SaysThatNothingOpened) {
  const auto record = stepped({1e-3, 2e-3, 3e-3, 4e-3, 5e-3}, 2e9, 1.0, 0.25, 1e3, 1);
  const auto found = read_step_rate(record, find_shut_in(record));
  EXPECT_EQ(found.steps.size(), 5U);
  EXPECT_FALSE(found.pressure.has_value());
  EXPECT_NE(found.note.find("flatter"), std::string::npos);
}

TEST(StepRate, IsNoneOfThreeSteps) {
  const auto record = stepped({1e-3, 2e-3, 3e-3}, 2e9, 1.5e-3, 0.25, 1e3, 1);
  EXPECT_TRUE(read_step_rate(record, find_shut_in(record)).steps.empty());
}

}  // namespace
