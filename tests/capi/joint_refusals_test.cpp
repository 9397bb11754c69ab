// SPDX-License-Identifier: BSD-3-Clause
// Every way to give a bad joint, in one table: each is refused by a sentence with the file, the line where there is one, the value and
// what is allowed.
#include <string>
#include <vector>

#include "sim_support.hpp"

namespace joint_refusals_test {

using namespace testing_capi;

struct BadJoint {
  const char* name;
  std::string keys;                // of [[joint]], which stands in line 5
  std::string traces;              // of traces.csv, if not empty
  std::vector<std::string> words;  // of the sentence
};

void PrintTo(const BadJoint& bad, std::ostream* out) {
  *out << bad.name;
}

// The table is made whenever the program starts, whatever test it runs: this text is made by its own test.
const std::string million_traces = "a million traces";
std::string a_million_traces() {
  std::string text = "START_X,START_Y,END_X,END_Y\n";
  for (int k = 0; k < 1'000'000; ++k) text += "1,2,3,4\n";
  return text;
}

class BadJoints : public testing::TestWithParam<BadJoint> {};

TEST_P(BadJoints, AreRefusedWithFileLineAndRange) {
  const TemporaryFolder folder;
  if (!GetParam().traces.empty())
    folder.write(GetParam().traces == million_traces ? a_million_traces() : GetParam().traces, "traces.csv");
  const std::string file =
      folder.write("[stress]\nsigma_Hmax = 40e6\nsigma_hmin = 30e6\n\n[[joint]]\n" + GetParam().keys + "\n");
  expect_refused(folder.path(), file, GetParam().words);
}

const std::string ends = "x1 = 10\ny1 = 10\nx2 = 60\ny2 = 40\n";
const std::string smooth = ends + "state = \"smooth-broken\"\n";  // lines 6 to 10
const std::string of_file = "file = \"traces.csv\"";
const std::string head = "START_X,START_Y,END_X,END_Y\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadJoints,
    testing::Values(
        BadJoint{"no-length",
                 "x1 = 10\ny1 = 10\nx2 = 10\ny2 = 10",
                 "",
                 {"case.toml:5: ", "joint[0] has no length: both ends are at (10, 10) m"}},
        BadJoint{
            "no-length-in-a-table", of_file, head + "1,2,3,4\n5,5,5,5\n", {"traces.csv:3: ", "no length"}},
        BadJoint{"outside",
                 "x1 = 500\ny1 = 10\nx2 = 600\ny2 = 10",
                 "",
                 {"case.toml:5: ", "joint[0] from (500, 10) to (600, 10) m",
                  "outside the model of 100 m x 100 m"}},
        BadJoint{"all-outside",
                 of_file,
                 head + "500,10,600,20\n-5,-5,-1,-1\n90,-20,120,20\n",
                 {"case.toml:5: ", "joint[0] from (500, 10)", "as do all others"}},
        BadJoint{"beyond-all-range",
                 "x1 = 2e6\ny1 = 10\nx2 = 600\ny2 = 10",
                 "",
                 {"case.toml:6: ", "joint[0].x1 = 2e6", "-1e6 to 1e6 m"}},
        BadJoint{"not-a-number",
                 "x1 = nan\ny1 = 10\nx2 = 600\ny2 = 10",
                 "",
                 {"case.toml:6: ", "joint[0].x1", "-1e6 to 1e6 m"}},
        BadJoint{"not-a-number-in-a-table",
                 of_file,
                 head + "1,2,nan,4\n",
                 {"traces.csv:2: ", "END_X = nan", "-1e6 to 1e6 m"}},
        BadJoint{"infinite-in-a-table",
                 of_file,
                 head + "1,2,inf,4\n",
                 {"traces.csv:2: ", "END_X = inf", "-1e6 to 1e6 m"}},
        BadJoint{"a-word-in-a-table", of_file, head + "1,2,3,four\n", {"traces.csv:2: ", "END_Y = four"}},
        BadJoint{"wrong-columns",
                 of_file,
                 "X1,Y1,X2,Y2\n1,2,3,4\n",
                 {"traces.csv:1: ", "no column START_X", "END_Y"}},
        BadJoint{
            "a-column-short", of_file, head + "1,2,3\n", {"traces.csv:2: ", "3 values and none for END_Y"}},
        BadJoint{"no-such-file", of_file, "", {"traces.csv: cannot be opened"}},
        BadJoint{"a-folder", "file = \".\"", "", {"is a directory, not a table of traces"}},
        BadJoint{"a-million",
                 of_file,
                 million_traces,
                 {"traces.csv:100002: ", "more than 100000 traces", "leave out"}},
        BadJoint{"an-end-missing", "x1 = 10\ny1 = 10\nx2 = 60", "", {"case.toml:5: ", "joint[0] has no y2"}},
        BadJoint{"file-and-ends", of_file + "\nx1 = 10", head, {"case.toml:5: ", "both file and x1"}},
        BadJoint{"file-of-a-number",
                 "file = 3",
                 "",
                 {"case.toml:6: ", "joint[0].file must be a text, not an integer"}},
        BadJoint{"unknown-key",
                 ends + "dilatation_angle = 0.1",
                 "",
                 {"case.toml:10: ", "joint.dilatation_angle", "joint.dilation_angle"}},
        BadJoint{"unknown-state",
                 ends + "state = \"smooth\"",
                 "",
                 {"case.toml:10: ", "joint[0].state", "smooth-bonded"}},
        BadJoint{"normal-stiffness",
                 smooth + "normal_stiffness = -1",
                 "",
                 {"case.toml:11: ", "joint[0].normal_stiffness = -1", "0 to 1e18 Pa/m"}},
        BadJoint{"shear-stiffness",
                 smooth + "shear_stiffness = -2e9",
                 "",
                 {"case.toml:11: ", "joint[0].shear_stiffness = -2e9", "0 to 1e18 Pa/m"}},
        BadJoint{"stiffness-of-a-set",
                 of_file + "\nstate = \"smooth-broken\"\nnormal_stiffness = -1",
                 head + "1,2,3,4\n",
                 {"case.toml:8: ", "normal_stiffness = -1", "0 to 1e18 Pa/m"}},
        BadJoint{"negative-friction",
                 ends + "friction = -0.5",
                 "",
                 {"case.toml:10: ", "joint[0].friction = -0.5", "0 to 10", "-1"}},
        BadJoint{"friction-below-residual",
                 smooth + "friction = 0.3\nresidual_friction = 0.5\nweakening_slip = 0.01",
                 "",
                 {"case.toml:12: ", "joint[0].residual_friction = 0.5", "above friction = 0.3"}},
        BadJoint{"the-rock's-friction-below-residual",
                 smooth + "residual_friction = 9\nweakening_slip = 0.01",
                 "",
                 {"case.toml:11: ", "joint[0].residual_friction = 9", "above contact.friction"}},
        BadJoint{"residual-without-slip",
                 smooth + "friction = 0.6\nresidual_friction = 0.5",
                 "",
                 {"case.toml:", "joint[0].weakening_slip = 0 m"}},
        BadJoint{"weakening-slip",
                 smooth + "weakening_slip = -0.01",
                 "",
                 {"case.toml:11: ", "joint[0].weakening_slip = -0.01", "0 to 1000 m"}},
        BadJoint{"dilation-of-90-degrees",
                 smooth + "dilation_angle = 1.5707963\ndilation_slip = 0.01",
                 "",
                 {"case.toml:11: ", "joint[0].dilation_angle = 1.5707963", "0 to 1.5 rad"}},
        BadJoint{"dilation-in-degrees",
                 smooth + "dilation_angle = 5\ndilation_slip = 0.01",
                 "",
                 {"case.toml:11: ", "joint[0].dilation_angle = 5", "0 to 1.5 rad"}},
        BadJoint{"dilation-without-end",
                 smooth + "dilation_angle = 0.1",
                 "",
                 {"case.toml:", "joint[0].dilation_slip = 0 m"}},
        BadJoint{"aperture",
                 smooth + "aperture = -1e-4",
                 "",
                 {"case.toml:11: ", "joint[0].aperture = -1e-4", "0 to 1 m"}},
        BadJoint{"closure-above-aperture",
                 smooth + "aperture = 1e-4\nmax_closure = 2e-4",
                 "",
                 {"case.toml:12: ", "joint[0].max_closure = 2e-4 m", "aperture of 1e-4 m"}},
        BadJoint{"roughness",
                 smooth + "aperture = 1e-4\nroughness = 21",
                 "",
                 {"case.toml:12: ", "joint[0].roughness = 21", "0 to 20"}},
        BadJoint{"storage-of-a-cubic-metre",
                 smooth + "aperture = 1e-4\nstorage = 1.0",
                 "",
                 {"case.toml:12: ", "joint[0].storage = 1", "0 to 1e-4 m/Pa"}},
        BadJoint{"storage-without-aperture",
                 smooth + "storage = 8e-9",
                 "",
                 {"case.toml:11: ", "joint[0].storage is for joints with an aperture", "residual_aperture"}},
        BadJoint{"storage-of-a-rough-joint",
                 ends + "storage = 8e-9",
                 "",
                 {"case.toml:10: ", "joint[0].storage is for smooth joints", "smooth-broken"}},
        BadJoint{"tensile-strength",
                 smooth + "tensile_strength = -1e6",
                 "",
                 {"case.toml:11: ", "joint[0].tensile_strength = -1e6", "0 to 1e12 Pa"}},
        BadJoint{"law-of-a-rough-joint",
                 ends + "aperture = 1e-4",
                 "",
                 {"case.toml:10: ", "joint[0].aperture is for smooth joints", "smooth-broken"}}),
    [](const auto& bad) {
      std::string name = bad.param.name;
      for (char& c : name)
        if (c == '-' || c == '\'') c = '_';
      return name;
    });

}  // namespace joint_refusals_test
