// SPDX-License-Identifier: BSD-3-Clause
// A field's record as a well's schedule: read in its units, thinned within what was allowed, the same run as its entries typed in.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "sim_support.hpp"

namespace record_test {

using namespace testing_capi;

const std::string head = "[stress]\nsigma_Hmax = 40e6\nsigma_hmin = 30e6\n[[well]]\nradius = 6.0\n";
const std::string by_rate = head + "control = \"rate\"\nschedule_file = \"record.csv\"\n";
const std::string by_pressure = head + "control = \"pressure\"\nschedule_file = \"record.csv\"\n";

// The schedule that a record gives.
std::vector<hfrac_schedule_def> entries_of(const std::string& record, const std::string& text = by_rate) {
  const TemporaryFolder folder;
  folder.write(record, "record.csv");
  hfrac::Definition def = new_def();
  const std::string file = folder.write(text);
  EXPECT_EQ(hfrac_sim_def_load(&def, file.c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(hfrac_sim_def_check_file(&def, file.c_str()), HFRAC_OK) << last_error();
  return {def.schedule, def.schedule + def.schedule_count};
}

struct Row {
  double time, value;
};
using Rows = std::vector<Row>;

std::string table(const Rows& rows, const std::string& names = "time_s,rate_m2_s") {
  std::string text = names + "\n";
  char line[64];
  for (const Row& row : rows) {
    std::snprintf(line, sizeof line, "%.17g,%.17g\n", row.time, row.value);
    text += line;
  }
  return text;
}

// What flows until `time` where each value holds until the next.
double volume(const Rows& rows, double time, bool flowed = false) {
  double sum = 0.0;
  for (std::size_t k = 0; k < rows.size() && rows[k].time < time; ++k) {
    const double end = k + 1 < rows.size() ? std::min(rows[k + 1].time, time) : time;
    sum += (flowed ? std::abs(rows[k].value) : rows[k].value) * (end - rows[k].time);
  }
  return sum;
}

Rows rows_of(const std::vector<hfrac_schedule_def>& entries) {
  Rows rows;
  for (const auto& entry : entries) rows.push_back({entry.time, entry.value});
  return rows;
}

// Four stages of a pump that wavers, with a stop and a flow-back.
Rows wavering(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> waver(0.0, 0.03);
  Rows rows;
  double time = 0.0;
  for (int k = 0; k < 6000; ++k) {
    const double stage = k < 1000 ? 0.002 : k < 3000 ? 0.01 : k < 4000 ? 0.0 : k < 5500 ? 0.006 : -0.001;
    rows.push_back({time, stage * (1.0 + waver(random))});
    time += 0.5 + static_cast<double>(random() % 100) * 0.01;
  }
  rows.push_back({time, 0.0});
  return rows;
}

TEST(Record, KeepsTheVolumeAndStaysWithinWhatIsAllowed) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    for (const double share : {0.001, 0.01, 0.05}) {
      const Rows rows = wavering(seed);
      const auto entries =
          rows_of(entries_of(table(rows), by_rate + "schedule_tolerance = " + std::to_string(share) + "\n"));
      const double end = rows.back().time, all = volume(rows, end, true);
      double off = 0.0;
      for (const Row& row : rows)
        off = std::max(off, std::abs(volume(entries, row.time) - volume(rows, row.time)));
      std::printf("seed %u, share %g: %zu rows gave %zu entries, at most %.3g of the volume off\n", seed,
                  share, rows.size(), entries.size(), off / all);
      EXPECT_LE(off, share * all * (1.0 + 1e-9));
      EXPECT_NEAR(volume(entries, end), volume(rows, end), 1e-12 * all);
      EXPECT_LT(entries.size(), 100U);
      EXPECT_EQ(entries.back().time, end);
      // The pump stops and starts when it did.
      for (const std::size_t turn : {3000U, 4000U, 5500U}) {
        const auto at = [&](const Row& entry) { return entry.time == rows[turn].time; };
        EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), at)) << turn;
      }
    }
  }
}

TEST(Record, OfSteadyStagesGivesTheirRatesToTheBit) {
  std::string text = "time_s,rate_m2_s\n";
  for (int k = 0; k < 3000; ++k) text += std::to_string(k) + (k < 2000 ? ",0.0123\n" : ",0.0\n");
  const auto entries = entries_of(text);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].value, 0.0123);
  EXPECT_EQ(entries[1].time, 2000.0);
  EXPECT_EQ(entries[1].value, 0.0);
}

// A step-rate test: its steps keep their rates and times, small ones at the beginning too.
TEST(Record, OfStepsHasThemWhereTheyAre) {
  std::string text = "time_s,rate_m2_s\n";
  const std::vector<double> steps{0.001, 0.002, 0.004, 0.006, 0.009, 0.012, 0.0};
  for (int k = 0; k < 6300; ++k)
    text += std::to_string(k) + "," + std::to_string(steps[static_cast<std::size_t>(k / 900)]) + "\n";
  const auto entries = entries_of(text);
  ASSERT_EQ(entries.size(), steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    EXPECT_EQ(entries[k].time, 900.0 * static_cast<double>(k));
    EXPECT_EQ(entries[k].value, steps[k]);
  }
}

TEST(Record, WithNothingAllowedLeavesOutRepeatedRowsOnly) {
  const Rows rows{{0, 1e-3}, {1, 1e-3}, {2, 2e-3}, {3, 2e-3}, {4, 1e-3}, {5, 0}, {6, 0}};
  const auto entries = entries_of(table(rows), by_rate + "schedule_tolerance = 0\n");
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(entries[1].time, 2.0);
  EXPECT_EQ(entries[2].time, 4.0);
}

TEST(Record, OfPressuresStaysWithinAShareOfTheirRange) {
  Rows rows;
  for (int k = 0; k <= 2000; ++k) rows.push_back({k * 1.0, 30e6 + 10e6 * std::sin(k * 1e-3)});
  const auto entries = rows_of(entries_of(table(rows, "time_s,pressure_Pa"), by_pressure));
  const double allowed = 0.01 * 10e6;
  EXPECT_LT(entries.size(), 110U);
  std::size_t held = 0;
  for (const Row& row : rows) {
    while (held + 1 < entries.size() && entries[held + 1].time <= row.time) ++held;
    EXPECT_LE(std::abs(entries[held].value - row.value), allowed * (1.0 + 1e-9)) << row.time;
  }
}

TEST(Record, IsReadInItsUnits) {
  const auto near = [](const std::string& record, const std::string& more, double time, double value) {
    const auto entries = entries_of(record, more);
    ASSERT_EQ(entries.size(), 2U) << record;
    EXPECT_DOUBLE_EQ(entries[1].time, time) << record;
    EXPECT_NEAR(entries[0].value, value, 1e-15 * std::abs(value)) << record;
  };
  const std::string thick = by_rate + "schedule_thickness = 20\n";
  near("time_min,rate_L_s\n0,5\n2,0\n", thick, 120.0, 5e-3 / 20);
  near("time_h,rate_L_min\n0,5\n2,0\n", thick, 7200.0, 5e-3 / 60 / 20);
  near("rate_m3_per_s,note,time_d\n0.5,a,0\n0,b,1\n", thick, 86400.0, 0.5 / 20);
  near("time_s,rate_m2_per_s\n0,0.5\n9,0\n", by_rate, 9.0, 0.5);
  near("time_s,pressure_MPa\n0,41\n9,30\n", by_pressure, 9.0, 41e6);
  // NIST Special Publication 811 (2008), appendix B.8.
  near("time_min,rate_bbl_min\n0,60\n1,0\n", thick, 60.0, 0.158987294928 / 20);
  near("time_min,rate_gal_min\n0,60\n1,0\n", thick, 60.0, 3.785411784e-3 / 20);
  const auto in_psi = entries_of("time_s,pressure_psi\n0,6000\n9,4000\n", by_pressure);
  ASSERT_EQ(in_psi.size(), 2U);
  EXPECT_NEAR(in_psi[0].value, 6000 * 6894.757, 6000 * 5e-4);
  near("time_s,pressure_bar,rate_stb\n0,410\n9,300\n", by_pressure, 9.0, 41e6);
  near(
      "\xEF\xBB\xBF# logger "
      "3\ntime,rate_m2_s\r\n2026-02-28T23:59:30.5+01:00,0.5\r\n\r\n2026-03-01T00:00:30.5+01:00,0\r\n",
      by_rate, 60.0, 0.5);
  near("time,rate_m2_s\n\"2024-02-28 12:00\",0.5\n2024-02-29T12:00:00Z,0\n", by_rate, 86400.0, 0.5);
}

TEST(Record, OfAWellWithoutAValueOfItsOwn) {
  const TemporaryFolder folder;
  folder.write("time_s,rate_m2_s,pressure_MPa\n10,0.01,41\n60,0,35\n", "record.csv");
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write(by_rate).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(def.wells[0].rate, 0.0);  // shut until the record begins
  EXPECT_EQ(def.wells[0].control, HFRAC_WELL_RATE);
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write(by_pressure).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(def.wells[0].pressure, 41e6);
  ASSERT_EQ(
      hfrac_sim_def_load(&def, folder.write(head + "rate = 0.002\nschedule_file = \"record.csv\"\n").c_str()),
      HFRAC_OK)
      << last_error();
  EXPECT_EQ(def.wells[0].rate, 0.002);
  EXPECT_EQ(def.schedule_count, 2);
}

TEST(Record, IsTheSameRunAsItsEntriesTypedIn) {
  const TemporaryFolder folder;
  folder.write("time_s,rate_L_s\n0,50\n1,50\n2,80\n3,0\n", "record.csv");
  const std::string common =
      "[model]\nwidth = 100\nheight = 100\n[packing]\ndisc_count = 500\n[stress]\nsigma_Hmax = "
      "30e6\nsigma_hmin = 30e6\n"
      "[stepping]\nflow_step = 0.5\n[[well]]\nradius = 10.0\nrate = 0.0\n";
  const auto run = [&](const std::string& text) {
    hfrac::Definition def = new_def();
    EXPECT_EQ(hfrac_sim_def_load(&def, folder.write(text).c_str()), HFRAC_OK) << last_error();
    const Sim sim(def);
    EXPECT_EQ(hfrac_step(sim, 8), HFRAC_OK) << last_error(sim);
    EXPECT_GT(well_of(sim).injected_volume, 0.0);
    return hash_of(sim);
  };
  const auto of_file =
      run(common + "schedule_file = \"record.csv\"\nschedule_thickness = 10\nschedule_tolerance = 0\n");
  const auto typed =
      run(common +
          "[[well.schedule]]\ntime = 0.0\nrate = 0.005\n[[well.schedule]]\ntime = 2.0\nrate = 0.008\n"
          "[[well.schedule]]\ntime = 3.0\nrate = 0.0\n");
  EXPECT_EQ(of_file, typed);
}

TEST(Record, WrittenBackStandsInTheCaseItself) {
  const TemporaryFolder folder;
  folder.write("time_s,rate_m2_s\n0,0.01\n60,0\n", "record.csv");
  hfrac::Definition def = new_def(), read = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write(by_rate).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(written(def).find("schedule_file"), std::string::npos);
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(written(def)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(written(def), written(read));
  EXPECT_EQ(read.schedule_count, 2);
}

TEST(Record, IsToldToTheListener) {
  const TemporaryFolder folder;
  folder.write("time_s,rate_m2_s\n0,0.01\n30,0.01\n60,0\n", "record.csv");
  hfrac::Definition def = new_def();
  std::string heard;
  def.log = [](void* user, int32_t level, const char* message) {
    *static_cast<std::string*>(user) += std::to_string(level) + message;
    return 0;
  };
  def.log_user = &heard;
  ASSERT_EQ(hfrac_sim_def_load(&def, folder.write(by_rate).c_str()), HFRAC_OK) << last_error();
  EXPECT_NE(heard.find("well[0]: the 3 rows of "), std::string::npos) << heard;
  EXPECT_NE(heard.find("s, gave 2 entries of its schedule, within 1 % of the volume"), std::string::npos)
      << heard;
}

// The same rows as a LAS file, with curves of no interest, lower-case sections, comments, tabs; plain and wrapped.
TEST(Record, IsReadFromALasFile) {
  const TemporaryFolder folder;
  const std::string csv = "time_min,rate_m3_min,pressure_MPa\n0,0.6,25\n0.5,0.6,31.5\n2,0,30.25\n";
  const std::string curves =
      "~Well\nSTRT.MIN 0 : start\nNULL. -999.25 : no value\nWELL. A.B: 1 : name with . and :\n~curve "
      "information\n#MNEM.UNIT\n"
      "ETIM.MIN : elapsed time\nTEMP.DEGC : of the fluid\n RateSlurry .M3/min 45 : pump\nPRES.mpa : at the "
      "well\n";
  const std::string plain =
      "# written by hand\n~V\n VERS. 2.0 : CWLS\n WRAP. NO : one line\n" + curves +
      "~A ETIM TEMP RATE PRES\n0 20 0.6 25\n0.5\t-999.25 0.6  31.5\n# a note\n2 21 0 30.25\n";
  const std::string wrapped = "~Version\nVERS.2.0:\nWRAP. yes :\n" + curves +
                              "~A\n0\n20 0.6\n25\n0.5\n-999.250 0.6 31.5\n2\n21 0\n30.25\n";
  folder.write(csv, "record.csv");
  folder.write(plain, "plain.las");
  folder.write(wrapped, "wrapped.las");
  const auto rows_in = [&](const char* name) {
    std::vector<double> rows(9, -1.0);
    int64_t count = 0;
    EXPECT_EQ(hfrac_read_record((folder.path() + "/" + name).c_str(), 20.0, rows.data(), 3, &count), HFRAC_OK)
        << last_error();
    EXPECT_EQ(count, 3);
    return rows;
  };
  EXPECT_EQ(rows_in("plain.las"), rows_in("record.csv"));
  EXPECT_EQ(rows_in("wrapped.las"), rows_in("record.csv"));
  folder.write("time_s,rate_bbl_min,pressure_psi\n0,6,4000\n1,6,4100\n2,0,3900\n", "record.csv");
  folder.write("~V\nVERS. 2.0 :\n~C\nTIME.SEC :\nRATE.BPM :\nPRES.PSIA :\n~A\n0 6 4000\n1 6 4100\n2 0 3900\n",
               "field.las");
  EXPECT_EQ(rows_in("field.las"), rows_in("record.csv"));
}

TEST(Record, OfARunHasItsNameOfThePressure) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/record.csv";
  std::vector<double> rows(3);
  int64_t count = 0;
  for (const char* text :
       {"time_s,well_pressure_Pa\n0,41\n", "time_s,well_pressure_Pa,pressure_Pa\n0,40,41\n"}) {
    folder.write(text, "record.csv");
    ASSERT_EQ(hfrac_read_record(path.c_str(), 1.0, rows.data(), 1, &count), HFRAC_OK) << last_error();
    EXPECT_EQ(rows[2], 41.0);
  }
}

TEST(Record, IsReadByAHost) {
  const TemporaryFolder folder;
  folder.write("time_s,pressure_kPa\n0,41\n9,30\n10,29\n", "record.csv");
  const std::string path = folder.path() + "/record.csv";
  int64_t count = 0;
  ASSERT_EQ(hfrac_read_record(path.c_str(), 1.0, nullptr, 0, &count), HFRAC_OK) << last_error();
  EXPECT_EQ(count, 3);
  std::vector<double> rows(6, -1.0);
  ASSERT_EQ(hfrac_read_record(path.c_str(), 1.0, rows.data(), 2, &count), HFRAC_OK);
  EXPECT_EQ(rows[3], 9.0);
  EXPECT_TRUE(std::isnan(rows[4]));
  EXPECT_EQ(rows[5], 30e3);
  // By the case that names it.
  const std::string named = folder.write(by_pressure);
  ASSERT_EQ(hfrac_read_record(named.c_str(), 1.0, rows.data(), 1, &count), HFRAC_OK) << last_error();
  EXPECT_EQ(count, 3);
  EXPECT_EQ(rows[2], 41e3);
  const std::string unnamed = folder.write(head + "pressure = 31e6\n");
  ASSERT_EQ(hfrac_read_record(unnamed.c_str(), 1.0, rows.data(), 1, &count), HFRAC_OK) << last_error();
  EXPECT_EQ(count, 0);
  const std::string thick = folder.write(by_rate + "schedule_thickness = 50.0\n");
  folder.write("time_s,rate_m3_s\n0,1\n1,0\n", "record.csv");
  ASSERT_EQ(hfrac_read_record(thick.c_str(), 1.0, rows.data(), 1, &count), HFRAC_OK) << last_error();
  EXPECT_EQ(rows[1], 0.02);
  EXPECT_EQ(hfrac_read_record(path.c_str(), 0.0, nullptr, 0, &count), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_read_record(path.c_str(), 1.0, rows.data(), -1, &count), HFRAC_ERR_ARGUMENT);
}

// A file of as many rows as are allowed is read in a moment and is few entries still.
TEST(Record, OfAMillionRows) {
  std::string text = "time_s,rate_m2_s\n";
  text.reserve(1U << 25U);
  for (int k = 0; k < 1'000'000; ++k) text += std::to_string(k) + (k % 2 == 0 ? ",0.010\n" : ",0.012\n");
  EXPECT_LT(entries_of(text).size(), 110U);
}

}  // namespace record_test
