// SPDX-License-Identifier: BSD-3-Clause
// Models packed once (hfrac_pack): what may differ does, with the result of a model of its own; what may not is refused by name.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "sim_support.hpp"
#include "thread_exchange.hpp"

namespace packed_model_test {

using namespace testing_capi;

class PackedModel : public testing::Test {
 protected:
  void TearDown() override { std::remove(file_.c_str()); }
  void pack(const hfrac_sim_def& def) const {
    ASSERT_EQ(hfrac_pack(&def, file_.c_str()), HFRAC_OK) << last_error();
  }
  hfrac::Definition from_file(hfrac::Definition def) const {
    EXPECT_EQ(hfrac_sim_def_set_str(&def, "packing.file", file_.c_str()), HFRAC_OK);
    return def;
  }
  // After two steps.
  static int64_t end_of(const hfrac_sim_def& def) {
    EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_OK) << last_error();
    const Sim sim(def);
    EXPECT_GE(hfrac_step(sim, 2), 0) << last_error(sim);
    return hash_of(sim);
  }
  void expect_refused(const hfrac::Definition& def, int32_t status,
                      const std::vector<std::string>& words) const {
    hfrac_sim* sim = nullptr;
    const hfrac::Definition asked = from_file(def);
    EXPECT_EQ(hfrac_sim_create(&asked, &sim), status);
    EXPECT_EQ(sim, nullptr);
    for (const auto& word : words) EXPECT_NE(last_error().find(word), std::string::npos) << last_error();
    EXPECT_EQ(hfrac_sim_def_check(&asked), status);
  }
  std::string file_ = testing::TempDir() + "hfrac_packed_model_" + std::to_string(getpid());
};

hfrac::Definition facet_def() {
  hfrac::Definition def = cracking_def(1000);
  def.stress_convention = 0;
  def.boundary_kind = 0;
  def.stress_sigma_Hmax = 12e6;
  def.stress_sigma_hmin = 10e6;
  def.fluid_formation_pressure = 1e6;
  def.bond_fracture_toughness = 2e6;  // E' at tips is measured
  def.solver_kind = 1;
  def.stepping_mode = 2;
  def.wells[0].pressure = 30e6;
  return def;
}

TEST_F(PackedModel, ServesCasesWithOtherFluidWellsAndToughness) {
  hfrac::Definition def = facet_def();
  pack(def);
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
  def.fluid_viscosity = 0.05;
  def.flow_permeability = 1e-15;
  def.flow_aperture_limit = 5e-3;
  def.bond_fracture_toughness = 1e6;
  def.fracture_perforation_length = 8.0;
  def.stepping_flow_step = 0.5;
  def.solver_pressure_change = 0.1;
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 1e-3;
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
}

TEST_F(PackedModel, ServesCasesWithHeatAndConductingJoints) {
  hfrac::Definition def = quiet_def(1000);
  def.thermal_mode = 2;
  def.thermal_expansion = 1e-5;
  ASSERT_EQ(hfrac_sim_def_set_i64(&def, "joint_count", 1), HFRAC_OK);
  auto& joint = def.joints[0];
  joint.x1 = 60.0;
  joint.y1 = 20.0;
  joint.x2 = 90.0;
  joint.y2 = 70.0;
  joint.state = HFRAC_JOINT_SMOOTH_BROKEN;
  joint.friction = 0.6;
  joint.aperture = 1e-4;
  pack(def);
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
  def.thermal_fluid_temperature = 320.0;
  def.thermal_conductivity = 3.5;
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
}

TEST_F(PackedModel, DiscsAloneServeOtherStressesAndRock) {
  hfrac::Definition def = quiet_def();
  pack(def);
  def.stress_sigma_hmin = 27e6;
  def.contact_friction = 0.5;
  def.wells[0].radius = 12.0;
  def.packing_reuse = 1;
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
  def.packing_porosity = 0.14;
  expect_refused(def, HFRAC_ERR_MODEL, {"packing.porosity = 0.14, but the model", "with 0.15", "hfrac pack"});
}

TEST_F(PackedModel, OneModelMayBeMadeFromAnothersDiscs) {
  hfrac::Definition def = quiet_def();
  pack(def);
  def.stress_sigma_hmin = 27e6;
  hfrac::Definition other = from_file(def);
  other.packing_reuse = 1;
  const std::string second = file_ + "_second";
  ASSERT_EQ(hfrac_pack(&other, second.c_str()), HFRAC_OK) << last_error();
  std::rename(second.c_str(), file_.c_str());
  EXPECT_EQ(end_of(from_file(def)), end_of(def));
}

TEST_F(PackedModel, OwnDiscsAndBondsAreKeptInIt) {
  hfrac::Definition def = quiet_def(300);
  std::vector<double> discs;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      discs.insert(discs.end(), {2.5 + 5.0 * column, 2.5 + 5.0 * row, 2.5});
  def.given_discs = discs.data();
  def.given_disc_count = 400;
  pack(def);
  const int64_t own = end_of(def);
  def.given_discs = nullptr;
  def.given_disc_count = 0;
  EXPECT_EQ(end_of(from_file(def)), own);
}

TEST_F(PackedModel, WhatDiffersIsNamed) {
  const hfrac::Definition def = quiet_def();
  pack(def);
  hfrac::Definition other = def;
  other.stress_sigma_Hmax = 31e6;
  expect_refused(other, HFRAC_ERR_MODEL,
                 {"stress.sigma_Hmax = 3.1e7 Pa", "with 3e7 Pa", "packing.reuse = \"discs\""});
  other = def;
  other.model_seed = 2;
  expect_refused(other, HFRAC_ERR_MODEL, {"model.seed = 2", "with 1"});
  other = def;
  other.contact_mode = 1;
  expect_refused(other, HFRAC_ERR_MODEL, {"contact.mode = \"after-break\"", "with \"parallel\""});
  other = def;
  other.wells[0].radius = 9.0;
  expect_refused(other, HFRAC_ERR_MODEL, {"well[0].radius = 9 m", "with 10 m"});
  other = def;
  ASSERT_EQ(hfrac_sim_def_set_i64(&other, "well_count", 0), HFRAC_OK);
  expect_refused(other, HFRAC_ERR_MODEL, {"well_count = 0", "with 1"});
  std::vector<double> discs = {1.0, 1.0, 1.0};
  other = def;
  other.given_discs = discs.data();
  other.given_disc_count = 1;
  expect_refused(other, HFRAC_ERR_MODEL, {});
}

TEST_F(PackedModel, WhatIsNoModelFileIsRefused) {
  const hfrac::Definition def = quiet_def(200);
  expect_refused(def, HFRAC_ERR_FILE, {"packing.file", file_, "packed anew"});
  std::ofstream(file_) << "not a model";
  expect_refused(def, HFRAC_ERR_FILE, {"packing.file", file_, "header"});
  pack(def);
  std::string bytes;
  {
    std::ifstream in(file_, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  const auto write = [&](const std::string& changed) {
    std::ofstream(file_, std::ios::binary)
        .write(changed.data(), static_cast<std::streamsize>(changed.size()));
  };
  write(bytes.substr(0, bytes.size() / 2));
  expect_refused(def, HFRAC_ERR_FILE, {"it was cut"});
  std::string damaged = bytes;
  damaged[bytes.size() / 3] = static_cast<char>(damaged[bytes.size() / 3] ^ 4);
  write(damaged);
  expect_refused(def, HFRAC_ERR_FILE, {"checksum"});
  damaged = bytes;
  ++damaged[8];
  write(damaged);
  expect_refused(def, HFRAC_ERR_FILE, {"its format is", "hfrac pack"});
  EXPECT_EQ(hfrac_pack(&def, "/nonexistent/model"), HFRAC_ERR_FILE);
  EXPECT_EQ(hfrac_pack(&def, nullptr), HFRAC_ERR_ARGUMENT);
}

// Text and copies carry the name; {seed} stands for the case's own.
TEST_F(PackedModel, ItsNameIsPartOfTheDefinition) {
  hfrac::Definition def = quiet_def(200);
  def.model_seed = 7;
  const std::string whole = file_;
  file_ += "-7";
  pack(def);
  hfrac::Definition named = def;
  ASSERT_EQ(hfrac_sim_def_set_str(&named, "packing.file", (whole + "-{seed}").c_str()), HFRAC_OK);
  const hfrac::Definition copy = named;
  EXPECT_STREQ(copy.packing_file, named.packing_file);
  EXPECT_EQ(end_of(copy), end_of(def));
  const std::string folder = std::filesystem::path(file_).parent_path().string();
  const std::string case_file = folder + "/hfrac_packed_case_" + std::to_string(getpid()) + ".toml";
  std::ofstream(case_file) << "[packing]\nfile = \"" << std::filesystem::path(whole).filename().string()
                           << "-{seed}\"\n";
  hfrac::Definition loaded;
  ASSERT_EQ(hfrac_sim_def_load(&loaded, case_file.c_str()), HFRAC_OK) << last_error();
  EXPECT_EQ(std::filesystem::path(loaded.packing_file),
            std::filesystem::path(whole + "-{seed}").lexically_normal());
  std::vector<char> text(20000);
  ASSERT_EQ(hfrac_sim_def_write(&loaded, text.data(), static_cast<int32_t>(text.size()), nullptr), HFRAC_OK);
  EXPECT_NE(std::string(text.data()).find(loaded.packing_file), std::string::npos);
  std::remove(case_file.c_str());
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "packing.file", std::string(2000, 'x').c_str()), HFRAC_ERR_ARGUMENT);
}

TEST_F(PackedModel, StopsIfAsked) {
  hfrac::Definition def = quiet_def(20000);  // long enough to be asked
  def.progress = [](void*, double, const char*) { return 1; };
  EXPECT_EQ(hfrac_pack(&def, file_.c_str()), HFRAC_STOPPED);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

// A rank that cannot read it, or reads another, ends all.
TEST_F(PackedModel, AllRanksReadTheSame) {
  const hfrac::Definition def = quiet_def(300);
  pack(def);
  const std::string other = file_ + "_other";
  hfrac::Definition changed = def;
  changed.wells[0].pressure = 31e6;
  ASSERT_EQ(hfrac_pack(&changed, other.c_str()), HFRAC_OK);
  const auto create_with = [&](const std::string& last, const std::string& words) {
    Meeting meeting(3);
    std::vector<std::string> texts(3);
    meeting.run([&](int32_t rank) {
      const auto exchange = meeting.exchange(rank);
      hfrac::Definition mine = from_file(def);
      if (rank == 2) {
        ASSERT_EQ(hfrac_sim_def_set_str(&mine, "packing.file", last.c_str()), HFRAC_OK);
      }
      hfrac_sim* sim = nullptr;
      EXPECT_EQ(hfrac_sim_create_on(&mine, &exchange, &sim), HFRAC_ERR_FILE);
      texts[static_cast<std::size_t>(rank)] = last_error();
    });
    EXPECT_NE(texts[0].find(words), std::string::npos) << texts[0];
  };
  create_with("/nonexistent/model", "another rank");
  create_with(other, "not the same file");
  std::remove(other.c_str());
}

}  // namespace packed_model_test
