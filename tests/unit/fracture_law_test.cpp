// SPDX-License-Identifier: BSD-3-Clause
// fracture.law = "auto": facets where a case asks for what they alone give and goes with them, contacts elsewhere.
#include "options/fracture_law.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "small_case.hpp"
#include "step/simulation.hpp"

namespace fracture_law_test {

using namespace testing_unit;

CaseDefinition with_toughness() {
  CaseDefinition definition = quiet_case();
  definition.options.bond_fracture_toughness = 2e6;
  return definition;
}

TEST(FractureLawAuto, IsContactsWithoutAToughness) {
  EXPECT_EQ(FractureLaw{quiet_case().options.fracture_law}, FractureLaw::automatic);
  EXPECT_EQ(fracture_law_of(quiet_case()), FractureLaw::bond);
}

TEST(FractureLawAuto, IsFacetsWhereOnlyTheyGiveWhatIsAskedFor) {
  EXPECT_EQ(fracture_law_of(with_toughness()), FractureLaw::facet);
  CaseDefinition slots = quiet_case();
  slots.options.fracture_perforation_length = 2.0;
  EXPECT_EQ(fracture_law_of(slots), FractureLaw::facet);
  CaseDefinition granite = quiet_case();
  granite.options.rock_biot_coefficient = 0.5;
  EXPECT_EQ(fracture_law_of(granite), FractureLaw::facet);
}

TEST(FractureLawAuto, IsContactsWhereFacetsDoNotGo) {
  const auto law = [](const auto& change) {
    CaseDefinition definition = with_toughness();
    change(definition);
    return fracture_law_of(definition);
  };
  EXPECT_EQ(law([](auto& d) { d.options.flow_scheme = choice(FlowScheme::off); }), FractureLaw::bond);
  EXPECT_EQ(law([](auto& d) { d.options.solver_kind = choice(SolverKind::quasi_static); }),
            FractureLaw::bond);
  EXPECT_EQ(law([](auto& d) { d.options.thermal_mode = choice(ThermalMode::uniform); }), FractureLaw::bond);
  EXPECT_EQ(law([](auto& d) { d.options.contact_shape = choice(ContactShape::flat); }), FractureLaw::bond);
  EXPECT_EQ(law([](auto& d) { d.joints.emplace_back(); }), FractureLaw::bond);  // a rough one
}

TEST(FractureLawAuto, GivesWayToAChoice) {
  CaseDefinition definition = with_toughness();
  definition.options.fracture_law = choice(FractureLaw::bond);
  EXPECT_EQ(fracture_law_of(definition), FractureLaw::bond);
}

// What is asked for by name is refused with what is in the way, not left out.
TEST(FractureLawAuto, DoesNotLeaveOutSlots) {
  CaseDefinition definition = with_toughness();
  definition.options.fracture_perforation_length = 2.0;
  definition.options.flow_scheme = choice(FlowScheme::off);
  try {
    validate(definition);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("flow.scheme"), std::string::npos) << error.what();
  }
}

// The simulation says what it took, and gives its definition back as it was.
TEST(FractureLawAuto, IsDecidedWhenTheModelIsBuilt) {
  CaseDefinition definition = with_toughness();
  definition.options.fracture_plane_modulus = 18.6e9;
  const Simulation s(definition, {}, {});
  EXPECT_EQ(FractureLaw{s.options().fracture_law}, FractureLaw::facet);
  EXPECT_EQ(FractureLaw{s.given_definition().options.fracture_law}, FractureLaw::automatic);
}

}  // namespace fracture_law_test
