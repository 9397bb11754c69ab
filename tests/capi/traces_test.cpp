// SPDX-License-Identifier: BSD-3-Clause
// Natural fractures as a table of traces beside the case file, and the values of smooth joints: read, written back, refused.
#include <string>

#include "sim_support.hpp"

namespace traces_test {

using namespace testing_capi;

const char* const set_of_traces =
    "[[joint]]\nfile = \"traces.csv\"\nstate = \"smooth-broken\"\nfriction = 0.6\naperture = "
    "2e-4\nmax_closure = 1e-4\n";

std::string fault_of(const std::string& traces, const std::string& text = set_of_traces) {
  const TemporaryFolder folder;
  folder.write(traces, "traces.csv");
  hfrac::Definition def = new_def();
  EXPECT_EQ(hfrac_sim_def_load(&def, folder.write(text).c_str()), HFRAC_ERR_CASE_FILE);
  EXPECT_EQ(def.joint_count, 0);
  return last_error();
}

TEST(Traces, AreJointsOfOneSet) {
  const TemporaryFolder folder;
  folder.write("FID,START_X,START_Y,END_X,END_Y\n0,10,20,30,40.5\n# a comment\n\n1, 50, 50, 60, 50\r\n",
               "traces.csv");
  hfrac::Definition def = new_def();
  const std::string file =
      folder.write(std::string(set_of_traces) + "[[joint]]\nx1 = 1\ny1 = 2\nx2 = 3\ny2 = 4\n");
  ASSERT_EQ(hfrac_sim_def_load(&def, file.c_str()), HFRAC_OK) << last_error();
  ASSERT_EQ(def.joint_count, 3);
  EXPECT_EQ(def.joints[0].y2, 40.5);
  EXPECT_EQ(def.joints[1].x2, 60.0);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(def.joints[k].state, HFRAC_JOINT_SMOOTH_BROKEN);
    EXPECT_EQ(def.joints[k].aperture, 2e-4);
  }
  EXPECT_EQ(def.joints[2].aperture, 0.0);
  // Written back they stand in the case itself.
  hfrac::Definition read = new_def();
  ASSERT_EQ(hfrac_sim_def_load(&read, folder.write(written(def)).c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(written(def), written(read));
  EXPECT_EQ(hfrac_sim_def_check_file(&def, file.c_str()), HFRAC_OK) << last_error();
}

TEST(Traces, ThatAreNoneAreRefusedByFileAndLine) {
  const std::string head = "START_X,START_Y,END_X,END_Y\n";
  const auto expect = [](const std::string& told, const std::string& part) {
    EXPECT_NE(told.find(part), std::string::npos) << told;
  };
  expect(fault_of("X1,Y1,X2,Y2\n1,2,3,4\n"), "traces.csv:1: no column START_X");
  expect(fault_of(head + "1,2,3,nan\n"), "traces.csv:2: END_Y = nan is not a number from -1e6 to 1e6 m");
  expect(fault_of(head + "1,2,3,4\n1,2,3\n"), "traces.csv:3: the line has 3 values and none for END_Y");
  expect(fault_of(head + "5,5,5,5\n"), "traces.csv:2: the trace has no length");
  expect(fault_of(head + "1,2,3,1e9\n"), "1e9 is not a number from -1e6");
  expect(fault_of(""), "traces.csv:1: the table of traces is empty");
  expect(fault_of(head + std::string(5000, '1')), "traces.csv: line 2 is longer than 4096 bytes");
  expect(fault_of(std::string(1U << 26U, '\n') + head), "traces.csv: is larger than 64 MiB");
  std::string many = head;
  for (int k = 0; k < 100'001; ++k) many += "1,2,3,4\n";
  expect(fault_of(many), "more than 100000 traces");
  expect(fault_of(head, "[[joint]]\nfile = \"other.csv\"\n"), "other.csv: cannot be opened");
  expect(fault_of(head, "[[joint]]\nfile = 3\n"), ":2: joint[0].file must be a text, not an integer");
  expect(fault_of(head, "[[joint]]\nfile = \"traces.csv\"\nx1 = 3.0\n"), "has both file and x1");
}

TEST(SmoothJoints, ValuesThatMeanNothingAreRefused) {
  const auto refused = [](auto&& change) {
    hfrac::Definition def = new_def();
    EXPECT_EQ(hfrac_sim_def_set_f64(&def, "joint[0].x2", 30.0), HFRAC_OK);
    EXPECT_EQ(hfrac_sim_def_set_str(&def, "joint[0].state", "smooth-broken"), HFRAC_OK);
    change(def);
    EXPECT_NE(hfrac_sim_def_check(&def), HFRAC_OK);
    return last_error();
  };
  const auto expect = [](const std::string& told, const std::string& part) {
    EXPECT_NE(told.find(part), std::string::npos) << told;
  };
  expect(refused([](auto& d) { d.joints[0].dilation_angle = 0.1; }), "joint[0].dilation_slip = 0 m");
  expect(refused([](auto& d) { d.joints[0].dilation_angle = 1.571; }),
         "dilation_angle = 1.571 is outside 0 to 1.5");
  expect(refused([](auto& d) { d.joints[0].normal_stiffness = -1.0; }), "normal_stiffness = -1 is outside");
  expect(refused([](auto& d) { d.joints[0].residual_friction = 0.2; }), "joint[0].weakening_slip = 0 m");
  expect(refused([](auto& d) {
           d.joints[0].friction = 0.3;
           d.joints[0].residual_friction = 0.5;
           d.joints[0].weakening_slip = 0.01;
         }),
         "joint[0].residual_friction = 0.5 is above friction = 0.3");
  expect(refused([](auto& d) {
           d.joints[0].aperture = 1e-4;
           d.joints[0].max_closure = 2e-4;
         }),
         "joint[0].max_closure = 2e-4 m is more than the aperture");
  expect(refused([](auto& d) {
           d.joints[0].state = HFRAC_JOINT_BROKEN;
           d.joints[0].aperture = 1e-4;
         }),
         "joint[0].aperture is for smooth joints");
}

// What a program of an older header filled has the defaults of what came later.
TEST(SmoothJoints, OfAnOlderHeaderHaveNoLawOfTheirOwn) {
  hfrac::Definition def = new_def();
  double old[2][8] = {{10, 10, 40, 40, 1, 1, -1, 0}, {50, 50, 80, 50, 1, 1, 0.5, 0}};
  def.joints = reinterpret_cast<hfrac_joint_def*>(old);
  def.joint_count = 2;
  def.joint_size = sizeof old[0];
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
  double aperture = -1.0;
  EXPECT_EQ(hfrac_sim_def_get_f64(&def, "joint[1].aperture", &aperture), HFRAC_OK);
  EXPECT_EQ(aperture, 0.0);
  // and no place for them: it is told so instead of running without.
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "joint[1].aperture", 1e-4), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_NE(last_error().find("joint_size = 64 has no place"), std::string::npos) << last_error();
  EXPECT_EQ(hfrac_sim_def_set_f64(&def, "joint[1].friction", 0.4), HFRAC_OK) << last_error();
}

}  // namespace traces_test
