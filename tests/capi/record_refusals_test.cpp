// SPDX-License-Identifier: BSD-3-Clause
// Every way to give a bad record, in one table: each is refused by a sentence with the file, the line, the value and what is allowed.
#include <string>
#include <vector>

#include "sim_support.hpp"

namespace record_refusals_test {

using namespace testing_capi;

struct BadRecord {
  const char* name;
  std::string record;                                                       // of record.csv, if not empty
  std::vector<std::string> words;                                           // of the sentence
  std::string keys = "control = \"rate\"\nschedule_file = \"record.csv\"";  // of [[well]], from line 7 on
};

void PrintTo(const BadRecord& bad, std::ostream* out) {
  *out << bad.name;
}

// The table is made whenever the program starts, whatever test it runs: long texts are made by their own tests.
const std::string too_many_rows = "a million rows", too_large = "64 MiB and more";
std::string text_of(const std::string& record) {
  if (record == too_large) return std::string((1U << 26U) + 1, '\n');
  if (record != too_many_rows) return record;
  std::string text = "time_s,rate_m2_s\n";
  for (int k = 0; k <= 1'000'000; ++k) text += std::to_string(k) + ",0.01\n";
  return text;
}

class BadRecords : public testing::TestWithParam<BadRecord> {};

TEST_P(BadRecords, AreRefusedWithFileLineAndWhatIsAllowed) {
  const TemporaryFolder folder;
  if (!GetParam().record.empty()) folder.write(text_of(GetParam().record), "record.csv");
  const std::string file = folder.write(
      "[stress]\nsigma_Hmax = 40e6\nsigma_hmin = 30e6\n\n[[well]]\nradius = 6.0\n" + GetParam().keys + "\n");
  expect_refused(folder.path(), file, GetParam().words);
}

const std::string rates = "time_s,rate_m2_s\n";
const std::string by_rate = "control = \"rate\"\n";
const std::string file_key = "schedule_file = \"record.csv\"";
const std::string las = "~Version\n";
const std::string good = rates + "0,0.01\n60,0\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadRecords,
    testing::Values(
        BadRecord{"empty", "\n", {"record.csv:1: ", "the record is empty", "names its columns"}},
        BadRecord{"no-rows", rates, {"record.csv:1: ", "no rows"}},
        BadRecord{"a-gap",
                  rates + "0,0.01\n1,\n2,0\n",
                  {"record.csv:3: ", "the row has no rate_m2_s", "fill it in"}},
        BadRecord{"a-gap-in-time", rates + "0,0.01\n,0.02\n", {"record.csv:3: ", "the row has no time_s"}},
        BadRecord{"a-short-row", rates + "0,0.01\n1\n", {"record.csv:3: ", "the row has no rate_m2_s"}},
        BadRecord{"not-a-number",
                  rates + "0,0.01\n1,nan\n",
                  {"record.csv:3: ", "rate_m2_s = nan", "-1e6 to 1e6 m2/s"}},
        BadRecord{"infinite", rates + "0,inf\n", {"record.csv:2: ", "rate_m2_s = inf", "-1e6 to 1e6 m2/s"}},
        BadRecord{"a-word", rates + "0,pump off\n", {"record.csv:2: ", "rate_m2_s = pump off"}},
        BadRecord{"decimal-comma",
                  "time_s;rate_m2_s\n0,5;0,01\n",
                  {"record.csv:1: ", "no known unit", "time_s, time_min"}},
        BadRecord{"backwards",
                  rates + "0,0.01\n5,0.01\n4,0\n",
                  {"record.csv:4: ", "time_s = 4 is not after 5", "in order of time"}},
        BadRecord{"twice-the-same-time",
                  rates + "0,0.01\n5,0.01\n5,0\n",
                  {"record.csv:4: ", "time_s = 5 is not after 5"}},
        BadRecord{"before-the-model", rates + "-5,0.01\n", {"record.csv:2: ", "time_s = -5", "0 to 1e15 s"}},
        BadRecord{
            "unknown-unit", "time_s,rate_stb\n0,5\n", {"record.csv:1: ", "rate_stb", "rate_m2_s, rate_m3_s"}},
        BadRecord{"unknown-unit-of-time",
                  "time_weeks,rate_m2_s\n0,5\n",
                  {"record.csv:1: ", "time_weeks", "time_h"}},
        BadRecord{
            "no-unit", "time_s,rate\n0,5\n", {"record.csv:1: ", "the name rate ends with no known unit"}},
        BadRecord{"unknown-columns",
                  "clock,flow\n0,5\n",
                  {"record.csv:1: ", "no column of time", "time (ISO 8601)"}},
        BadRecord{
            "no-rate", "time_s,pressure_Pa\n0,5\n", {"record.csv:1: ", "no column of rate", "rate_L_s"}},
        BadRecord{"two-rates",
                  "time_s,rate_m2_s,rate_m2_per_s\n0,5,5\n",
                  {"record.csv:1: ", "both rate_m2_s and rate_m2_per_s"}},
        BadRecord{"no-pressure",
                  good,
                  {"record.csv:1: ", "no column of pressure", "pressure_MPa"},
                  "control = \"pressure\"\n" + file_key},
        BadRecord{"a-rate-without-thickness",
                  "time_s,rate_L_s\n0,5\n",
                  {"record.csv:1: ", "rate_L_s", "schedule_thickness", "in metres"}},
        BadRecord{"a-date-that-is-none",
                  "time,rate_m2_s\n2026-02-30T00:00:00,5\n",
                  {"record.csv:2: ", "time = 2026-02-30T00:00:00", "ISO 8601"}},
        BadRecord{
            "a-time-of-day", "time,rate_m2_s\n12:00:00,5\n", {"record.csv:2: ", "time = 12:00:00", "time_s"}},
        BadRecord{"dates-backwards",
                  "time,rate_m2_s\n2026-02-28T01:00:00,5\n2026-02-28T00:59:59,5\n",
                  {"record.csv:3: ", "2026-02-28T00:59:59 is not after 2026-02-28T01:00:00"}},
        BadRecord{
            "too-many", too_many_rows, {"record.csv:1000002: ", "more than 1000000 rows", "log less often"}},
        BadRecord{"too-long-a-line",
                  rates + std::string(5000, '1'),
                  {"record.csv: line 2 is longer than 4096 bytes"}},
        BadRecord{"too-large", too_large, {"record.csv: is larger than 64 MiB", "not a record"}},
        BadRecord{"las-version", las + "VERS. 3.0 :\n", {"record.csv:2: ", "VERS = 3.0", "2.0 and 1.2"}},
        BadRecord{"las-without-curves", las + "~A\n0 1\n", {"record.csv:2: ", "no curves", "~C"}},
        BadRecord{"las-without-values", las + "~C\nTIME.S :\n", {"record.csv:1: ", "no section ~A"}},
        BadRecord{"las-of-depths",
                  las + "~C\nDEPT.M :\nGR.API :\n~A\n1 2\n",
                  {"record.csv:5: ", "no column of time"}},
        BadRecord{"las-unknown-unit",
                  las + "~C\nTIME.S :\nRATE.STB :\n~A\n0 1\n",
                  {"record.csv:5: ", "rate_STB ends with no known unit", "rate_m3_s"}},
        BadRecord{"las-a-null",
                  las + "~W\nNULL. -999.25 :\n~C\nTIME.S :\nRATE.M2/S :\n~A\n0 1\n1 -999.2500\n",
                  {"record.csv:9: ", "the row has no rate_m2_s", "leave the row out"}},
        BadRecord{"las-a-short-row",
                  las + "~C\nTIME.S :\nRATE.M2/S :\n~A\n0 1\n1\n",
                  {"record.csv:7: ", "the row has no rate_m2_s"}},
        BadRecord{"las-backwards",
                  las + "~C\nTIME.S :\nRATE.M2/S :\n~A\n5 1\n4 1\n",
                  {"record.csv:7: ", "time_s = 4 is not after 5"}},
        BadRecord{
            "las-a-line-that-is-none", las + "RATE\n", {"record.csv:2: ", "MNEM.UNIT DATA : DESCRIPTION"}},
        BadRecord{"no-such-file", "", {"record.csv: cannot be opened"}},
        BadRecord{"a-folder", "", {"is a directory, not a record"}, by_rate + "schedule_file = \".\""},
        BadRecord{"file-of-a-number",
                  "",
                  {"case.toml:8: ", "well[0].schedule_file must be a text"},
                  by_rate + "schedule_file = 3"},
        BadRecord{"no-control",
                  good,
                  {"case.toml:5: ", "neither pressure nor rate", "control", "schedule_file"},
                  file_key},
        BadRecord{"ramp",
                  good,
                  {"case.toml:7: ", "control = \"ramp\"", "\"pressure\" or \"rate\""},
                  file_key + "\ncontrol = \"ramp\"\npressure = 45e6\nramp_per_step = 1e6"},
        BadRecord{"file-and-entries",
                  good,
                  {"case.toml:8: ", "both schedule_file and schedule"},
                  by_rate + file_key + "\n[[well.schedule]]\ntime = 60\nrate = 0"},
        BadRecord{"thickness",
                  good,
                  {"case.toml:9: ", "well[0].schedule_thickness = 0 is outside above 0 to 1e6 m"},
                  by_rate + file_key + "\nschedule_thickness = 0"},
        BadRecord{"tolerance",
                  good,
                  {"case.toml:9: ", "well[0].schedule_tolerance = 0.6 is outside 0 to 0.5"},
                  by_rate + file_key + "\nschedule_tolerance = 0.6"},
        BadRecord{"tolerance-not-a-number",
                  good,
                  {"case.toml:9: ", "well[0].schedule_tolerance"},
                  by_rate + file_key + "\nschedule_tolerance = nan"},
        BadRecord{"tolerance-of-a-word",
                  good,
                  {"case.toml:9: ", "schedule_tolerance must be a number, not a text"},
                  by_rate + file_key + "\nschedule_tolerance = \"1 %\""},
        BadRecord{"thickness-without-a-file",
                  "",
                  {"case.toml:8: ", "schedule_thickness is for a schedule_file"},
                  "rate = 0.01\nschedule_thickness = 10"},
        BadRecord{"a-pressure-no-well-may-have",
                  "time_s,pressure_Pa\n0,-1e11\n9,3e7\n",
                  {"case.toml:8: ", "schedule[0].pressure = -1e11 Pa"},
                  "control = \"pressure\"\n" + file_key}),
    [](const auto& bad) {
      std::string name = bad.param.name;
      for (char& c : name)
        if (c == '-') c = '_';
      return name;
    });

}  // namespace record_refusals_test
