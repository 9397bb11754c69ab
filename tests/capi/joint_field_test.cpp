// SPDX-License-Identifier: BSD-3-Clause
// Fields of the contacts of smooth joints: that they fit the other fields and the joint's law, and come back with the state.
#include <algorithm>
#include <cmath>
#include <vector>

#include "../joint_def.hpp"
#include "sim_support.hpp"

namespace joint_field_test {

using namespace testing_capi;

constexpr double stiffness = 1e10, max_closure = 5e-3, aperture = 5e-3, friction = 0.3, dilation_angle = 0.1,
                 dilation_slip = 0.01;

// A joint that conducts, through the well, which presses 5 MPa more than the formation into it.
hfrac::Definition jointed_def() {
  hfrac::Definition def = quiet_def(600);
  def.contact_mode = 1;
  def.stress_sigma_Hmax = 45e6;
  def.fluid_formation_pressure = 10e6;
  def.fluid_viscosity = 1.0;
  def.flow_permeability = 1e-18;
  def.flow_aperture_limit = 0.1;
  def.stepping_mode = 2;
  def.solver_kind = 1;
  def.stepping_flow_step = 1.0;
  def.wells[0].pressure = 15e6;
  hfrac_sim_def_set_i64(&def, "joint_count", 1);
  def.joints[0] = joint_def(20.0, 38.0, 80.0, 62.0, 1.0, 1.0, friction, HFRAC_JOINT_SMOOTH_BROKEN);
  def.joints[0].normal_stiffness = stiffness;
  def.joints[0].shear_stiffness = 5e9;
  def.joints[0].max_closure = max_closure;
  def.joints[0].aperture = aperture;
  def.joints[0].dilation_angle = dilation_angle;
  def.joints[0].dilation_slip = dilation_slip;
  return def;
}

struct Joint {
  std::vector<int32_t> number, bond, state;
  std::vector<double> begin, end, opening, mechanical, hydraulic, slip, total_slip, normal, shear, pressure;
  explicit Joint(hfrac_sim* sim)
      : number(indices(sim, HFRAC_JOINT_NUMBER)),
        bond(indices(sim, HFRAC_JOINT_BOND)),
        state(indices(sim, HFRAC_JOINT_CONTACT_STATE)),
        begin(doubles(sim, HFRAC_JOINT_BEGIN)),
        end(doubles(sim, HFRAC_JOINT_END)),
        opening(doubles(sim, HFRAC_JOINT_OPENING)),
        mechanical(doubles(sim, HFRAC_JOINT_MECHANICAL_APERTURE)),
        hydraulic(doubles(sim, HFRAC_JOINT_HYDRAULIC_APERTURE)),
        slip(doubles(sim, HFRAC_JOINT_SLIP)),
        total_slip(doubles(sim, HFRAC_JOINT_TOTAL_SLIP)),
        normal(doubles(sim, HFRAC_JOINT_NORMAL_STRESS)),
        shear(doubles(sim, HFRAC_JOINT_SHEAR_STRESS)),
        pressure(doubles(sim, HFRAC_JOINT_PRESSURE)) {}
  bool operator==(const Joint&) const = default;
};

TEST(JointFields, FitTheOtherFieldsAndTheLaw) {
  const Sim sim(jointed_def());
  const Joint start(sim);
  ASSERT_GE(hfrac_step(sim, 3), HFRAC_OK) << last_error(sim);
  const Joint joint(sim);
  const auto broken = indices(sim, HFRAC_BOND_STATE), domains = indices(sim, HFRAC_PIPE_DOMAINS);
  const auto pipe = doubles(sim, HFRAC_PIPE_APERTURE), pore = doubles(sim, HFRAC_DOMAIN_PRESSURE);
  ASSERT_GT(joint.bond.size(), 10U);
  EXPECT_TRUE(std::is_sorted(joint.bond.begin(), joint.bond.end()));
  double slid = 0.0, length = 0.0;
  for (std::size_t k = 0; k < joint.bond.size(); ++k) {
    SCOPED_TRACE(k);
    const auto bond = static_cast<std::size_t>(joint.bond[k]);
    EXPECT_EQ(joint.number[k], 0);
    EXPECT_EQ(broken[bond], 2);
    EXPECT_EQ(joint.hydraulic[k], pipe[bond]);
    EXPECT_DOUBLE_EQ(joint.pressure[k], 0.5 * (pore[static_cast<std::size_t>(domains[2 * bond])] +
                                               pore[static_cast<std::size_t>(domains[2 * bond + 1])]));
    EXPECT_DOUBLE_EQ(joint.mechanical[k], std::max(0.0, aperture + joint.opening[k]));
    const double lifted = std::min(std::abs(joint.total_slip[k]), dilation_slip) * std::tan(dilation_angle);
    const double closure = lifted - joint.opening[k];
    if (closure <= 0.0) {
      EXPECT_EQ(joint.state[k], 3);
      EXPECT_EQ(joint.normal[k], 0.0);
    } else {
      const double bandis = stiffness * closure / (1.0 - closure / max_closure);
      EXPECT_NEAR(joint.normal[k], bandis, 1e-6 * bandis);
      EXPECT_LE(std::abs(joint.shear[k]), friction * bandis * (1.0 + 1e-9));
      EXPECT_EQ(joint.state[k], std::abs(joint.shear[k]) > (1.0 - 1e-6) * friction * bandis ? 2 : 1);
    }
    EXPECT_EQ(start.slip[k], 0.0);
    EXPECT_DOUBLE_EQ(joint.slip[k], joint.total_slip[k] - start.total_slip[k]);
    slid = std::max(slid, std::abs(joint.slip[k]));
    length +=
        std::hypot(joint.end[2 * k] - joint.begin[2 * k], joint.end[2 * k + 1] - joint.begin[2 * k + 1]);
  }
  EXPECT_GT(slid, 1e-5);
  EXPECT_GT(length, 35.0);  // 64.6 m less the hole and its rims
  EXPECT_LT(length, 64.7);
  int32_t state = 0;
  int64_t count = 0;
  EXPECT_EQ(hfrac_field_copy_i32(sim, HFRAC_JOINT_CONTACT_STATE, &state, 1, &count), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("values of joint.state"), std::string::npos) << last_error(sim);
}

TEST(JointFields, ComeBackWithTheState) {
  const Sim sim(jointed_def());
  ASSERT_GE(hfrac_step(sim, 2), HFRAC_OK) << last_error(sim);
  const Joint then(sim);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  std::vector<char> image(static_cast<std::size_t>(size));
  ASSERT_EQ(hfrac_state_save(sim, image.data(), size, &size), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_FALSE(Joint(sim) == then);
  const Sim other(jointed_def());
  for (hfrac_sim* into : {static_cast<hfrac_sim*>(sim), static_cast<hfrac_sim*>(other)}) {
    ASSERT_EQ(hfrac_state_restore(into, image.data(), size), HFRAC_OK) << last_error(into);
    EXPECT_TRUE(Joint(into) == then);
  }
}

}  // namespace joint_field_test
