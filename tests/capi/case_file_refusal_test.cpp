// SPDX-License-Identifier: BSD-3-Clause
// Case files that are wrong: each is refused with one sentence that names file, line and fault, and changes
// nothing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstring>
#include <random>

#include "support.hpp"

namespace case_file_refusal_test {

using namespace testing_capi;

void expect_refused(const std::string& path, const std::string& told) {
  hfrac::Definition def = sound_def();
  const hfrac_sim_def before = def;  // the bytes, pointers included
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  EXPECT_EQ(std::memcmp(&def, &before, sizeof def), 0) << "the definition was changed";
  const std::string text = last_error();
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.rfind(path, 0), 0u) << text;
  EXPECT_NE(text.find(told), std::string::npos) << text;
}

struct Fault {
  const char* name;
  const char* text;
  const char* told;
};

// Instead of the bytes of the struct, which differ from run to run.
void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

const Fault faults[] = {
    {"UnknownKey", "[bond]\n\ntensile_strengh = 1e6\n",
     ":3: bond.tensile_strengh is not a known key; did you mean bond.tensile_strength?"},
    {"UnknownSection", "[bonds]\nshear_strength = 1e6\n",
     ":1: bonds is not a known section; did you mean bond?"},
    {"KeyWithoutSection", "disc_count = 100\n",
     ":1: disc_count is not a known key; did you mean packing.disc_count?"},
    {"UnknownWellKey", "[[well]]\nradus = 1.0\n",
     ":2: well.radus is not a known key; did you mean well.radius?"},
    {"OutOfRange", "[packing]\nporosity = 0.9\n", ":2: packing.porosity = 0.9 is outside 0.08 to 0.2."},
    {"OutOfRangeInteger", "[packing]\ndisc_count = 3\n",
     ":2: packing.disc_count = 3 is outside 20 to 100000000."},
    {"FirstFaultFirst", "[stop]\ncracks = -1\n[bond]\nshear_strength = -1\n", ":2: stop.cracks = -1"},
    {"NotANumber", "[disc]\ndensity = nan\n",
     ":2: disc.density = nan is not a finite number; allowed is 1 to 1e5 kg/m3."},
    {"Infinite", "[disc]\ndensity = -inf\n", ":2: disc.density = -inf is not a finite number"},
    {"Overflow", "[disc]\ndensity = 1e999\n", "case.toml:2: "},
    {"IntegerOverflow", "[packing]\ndisc_count = 99999999999999999999\n", ":2: not valid TOML"},
    {"RealForInteger", "[packing]\ndisc_count = 100.0\n",
     ":2: packing.disc_count must be an integer, not a real number."},
    {"TextForReal", "[disc]\ndensity = \"2000\"\n", ":2: disc.density must be a number, not a text."},
    {"TruthForReal", "[disc]\ndensity = true\n", ":2: disc.density must be a number, not true or false."},
    {"DateForReal", "[disc]\ndensity = 1979-05-27\n",
     ":2: disc.density must be a number, not a date or time."},
    {"ListForReal", "[disc]\ndensity = [1.0]\n", ":2: disc.density must be a number, not a list."},
    {"TableForReal", "[disc.density]\nvalue = 1.0\n", "disc.density must be a number, not a table."},
    {"IndexForChoice", "[contact]\nmode = 1\n", ":2: contact.mode must be a word in quotes, not an integer."},
    {"WrongWord", "[contact]\nmode = \"serial\"\n",
     ":2: contact.mode = \"serial\" is not one of parallel or after-break."},
    {"ValueForSection", "packing = 5\n", ":1: packing is a section, not a value"},
    {"ListOfSections", "[[packing]]\ndisc_count = 100\n", ":1: packing is a section"},
    {"NumberForTitle", "title = 5\n", ":1: title must be a text, not an integer."},
    {"ZeroInTitle", "title = \"a\\u0000b\"\n", ":1: title holds a character 0."},
    {"WellAsTable", "[well]\nradius = 1.0\n", ":1: well must be a list of tables; write [[well]]"},
    {"WellAsNumber", "well = [1]\n", ":1: well must be a list of tables"},
    {"WellRadiusNegative", "[[well]]\npressure = 1e6\nradius = -1.0\n",
     ":3: well[0].radius = -1 is outside 1e-6 to 1e6 m."},
    {"WellWithoutRadius", "\n[[well]]\npressure = 1e6\n", ":2: well[0] has no radius"},
    {"WellWithoutDrive", "[[well]]\nradius = 1.0\n", ":1: well[0] has neither pressure nor rate"},
    {"WellWithBoth", "[[well]]\nradius = 1.0\npressure = 1e6\nrate = 1.0\n",
     ":1: well[0] has both pressure and rate"},
    {"WellRampWithoutRise", "[[well]]\nradius = 1.0\npressure = 1e6\ncontrol = \"ramp\"\n",
     "no ramp_per_step"},
    {"WellRateWithoutRate", "[[well]]\nradius = 1.0\npressure = 1e6\ncontrol = \"rate\"\n",
     "control = \"rate\" but no rate"},
    {"WellPlaceNotANumber", "[[well]]\nradius = 1.0\npressure = 1e6\nx = nan\n",
     ":4: well[0].x = nan is not a finite number"},
    {"ElevenWells",
     "well = [{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},"
     "{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},{radius=5,rate=1},{}]\n",
     ":1: well[10] has no radius"},
    {"NotToml", "width: 100\n", ":1: not valid TOML"},
    {"DuplicateKey", "[disc]\ndensity = 1.0\ndensity = 2.0\n", ":3: not valid TOML"},
    {"UnclosedText", "title = \"abc\n", ":1: not valid TOML"},
    {"BrokenUtf8", "title = \"\xFF\xFE\"\n", ":1: not valid TOML"},
    {"LetterBeyondAscii", "title = \"\xC3\xA4\" # \xC3\xA4\n\xC3\xA4 = 1\n",
     "a quote or a character beyond ASCII"},
    {"BeyondAsciiAfterTriple", "title = \"\"\"\xC3\xA4\"\"\"\"\" \xC3\xA4\n",
     "a quote or a character beyond ASCII"},
    {"QuoteInsideAWord", "[disc]\ndensity = 60z\'\'\'\xC3\xA4\n", ":2: not a case file: a quote"},
    {"EscapedLetter", "title = \"\\\xC3\xA4\"\n", ":1: not a case file: a quote"},
    {"ControlCharacterAsName", "[\x1e[mo = 1\n",
     ":1: not valid TOML: the line holds the control character 30"},
    {"ControlCharacterFurtherDown", "[disc]\ndensity = 1.0\n\n[\x1e[mo = 1\n[bond]\n",
     ":4: not valid TOML: the line holds the control character 30"},
    {"ControlCharacter", "[\x01]\n", ":1: not valid TOML"},
};

class RefusedCase : public testing::TestWithParam<Fault> {};
TEST_P(RefusedCase, WithFileLineAndFault) {
  const TemporaryFolder folder;
  expect_refused(folder.write(GetParam().text), GetParam().told);
}
INSTANTIATE_TEST_SUITE_P(CaseFile, RefusedCase, testing::ValuesIn(faults),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(CaseFileRefused, TitleTooLong) {
  const TemporaryFolder folder;
  expect_refused(folder.write("title = \"" + std::string(128, 't') + "\"\n"),
                 ":1: title has 128 bytes; at most 127 fit.");
}

TEST(CaseFileRefused, MissingFile) {
  expect_refused("/nonexistent/case.toml", ": cannot be opened: No such file");
}
TEST(CaseFileRefused, EmptyPath) {
  expect_refused("", "cannot be opened");
}
TEST(CaseFileRefused, Directory) {
  const TemporaryFolder folder;
  expect_refused(folder.path(), ": is a directory, not a case file.");
}
TEST(CaseFileRefused, Device) {
  expect_refused("/dev/zero", ": is a device or pipe, not a case file.");
}

TEST(CaseFileRefused, PipeNobodyWritesTo) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file().c_str(), 0600), 0);
  expect_refused(folder.file(), ": is a device or pipe, not a case file.");
}

TEST(CaseFileRefused, GigabyteOfZeros) {
  const TemporaryFolder folder;
  folder.write("");
  ASSERT_EQ(::truncate(folder.file().c_str(), 1'000'000'000), 0);
  expect_refused(folder.file(), ": is larger than 1 MiB");
}

TEST(CaseFileRefused, ZeroBytes) {
  const TemporaryFolder folder;
  expect_refused(folder.write(std::string("title = \"a\"\n\0", 13)),
                 ": holds bytes 0; this is not a text file.");
}

TEST(CaseFileRefused, BinaryGarbage) {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::string garbage(2000, ' ');
    for (char& c : garbage) c = static_cast<char>(1 + random() % 255);
    expect_refused(folder.write(garbage), ": not ");
  }
}

TEST(CaseFileRefused, LongLinesAndDeepNesting) {
  const TemporaryFolder folder;
  std::string deep = "a";
  for (int i = 0; i < 500'000; ++i) deep += ".a";
  expect_refused(folder.write(deep + " = 1\n"), "line 1 is longer than 4096 bytes");
  expect_refused(folder.write(deep.substr(0, 4001) + " = 1\n"), ":1: a is not a known section");
  expect_refused(folder.write("[" + deep.substr(0, 4001) + "]\n"), ":1: a is not a known section");
  expect_refused(folder.write("a = " + std::string(4000, '[') + "\n"), "not valid TOML");
  std::string lists = "a = \n";
  for (int i = 0; i < 200'000; ++i) lists += "[\n";
  expect_refused(folder.write(lists), "not valid TOML");
}

TEST(CaseFileRefused, TruncatedAnywhere) {
  const TemporaryFolder folder;
  const std::string whole = written(sound_def());
  for (std::size_t length = 1; length < whole.size(); length += 7) {
    hfrac::Definition def = new_def();
    const int32_t status = hfrac_sim_def_load(&def, folder.write(whole.substr(0, length)).c_str());
    EXPECT_TRUE(status == HFRAC_OK || status == HFRAC_ERR_CASE_FILE) << status << " " << last_error();
  }
}

// What is wrong only together with other values: the line of the first one at fault that the file has.
struct Contradiction {
  const char* name;
  const char* text;
  const char* told;
};
void PrintTo(const Contradiction& one, std::ostream* out) {
  *out << one.name;
}

const Contradiction contradictions[] = {
    {"Option", "[bond]\nfracture_toughness = 1e6\n\ntoughness_reference_radius = 0.5\n",
     ":2: bond.fracture_toughness = 1e6 Pa m^0.5 and bond.toughness_reference_radius"},
    {"AgainstADefault", "title = \"a\"\n[flow]\n# r0\naperture_limit = 1e-9\nzero_stress_aperture = 1e-3\n",
     ":5: flow.zero_stress_aperture"},
    {"NamedOnlyAsTheFix", "title = \"a\"\n[packing]\ndisc_count = 20\n[model]\nwidth = 10.0\n",
     ":3: The smaller model side of 10 m"},
    {"Well", "[[well]]\nradius = 6.0\npressure = 30e6\n\n[[well]]\nx = 55.0\nradius = 6.0\npressure = 30e6\n",
     ":1: well[0] and well[1] overlap"},
    {"ValueOfAWell", "[[well]]\npressure = 30e6\n\nradius = 60.0\n", ":4: well[0].radius = 60 m"},
    {"Joint", "\n[[joint]]\nx1 = 1.0\ny1 = 1.0\nx2 = 1.0\ny2 = 1.0\n", ":2: joint[0] has no length"},
    {"ScheduleOfTheSecondWell",
     "[[well]]\nx = 30.0\nradius = 6.0\npressure = 30e6\n[[well.schedule]]\ntime = 5.0\npressure = 31e6\n"
     "[[well]]\nx = 70.0\nradius = 6.0\npressure = 30e6\n[[well.schedule]]\ntime = 5.0\npressure = 31e6\n"
     "[[well.schedule]]\ntime = 4.0\npressure = 31e6\n",
     ":16: schedule[2].time = 4 s is not after 5 s"},
};

class ContradictoryCase : public testing::TestWithParam<Contradiction> {};
TEST_P(ContradictoryCase, IsRefusedWithFileAndLine) {
  const TemporaryFolder folder;
  const std::string path = folder.write(GetParam().text);
  hfrac::Definition def = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&def, path.c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(hfrac_sim_def_check_file(&def, path.c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(last_error().rfind(path + GetParam().told, 0), 0u) << last_error();
}
INSTANTIATE_TEST_SUITE_P(CaseFile, ContradictoryCase, testing::ValuesIn(contradictions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ContradictoryCase, ValuesFromElsewhereNameTheFileAlone) {
  const TemporaryFolder folder;
  const std::string path = folder.write("title = \"only that\"\n");
  hfrac::Definition def = sound_def();
  EXPECT_EQ(hfrac_sim_def_check_file(&def, path.c_str()), HFRAC_OK) << last_error();
  def.wells[0].radius = 60.0;
  EXPECT_EQ(hfrac_sim_def_check_file(&def, path.c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(last_error().rfind(path + ": well[0].radius = 60 m", 0), 0u) << last_error();
}

}  // namespace case_file_refusal_test
