// SPDX-License-Identifier: BSD-3-Clause
// Fields: what they say of themselves, how they are copied and viewed, and that they fit together.
#include <algorithm>
#include <cmath>
#include <map>

#include "sim_support.hpp"

namespace field_test {

using namespace testing_capi;

struct Entry {
  int32_t field;
  const char *name, *unit;
  int32_t location, dtype, components;
  const char* help;
};
#define HFRAC_ENTRY(name, value, key, unit, location, dtype, components, help) \
  {name, key, unit, location, dtype, components, help},
constexpr Entry entries[] = {HFRAC_FIELD_LIST(HFRAC_ENTRY)};
#undef HFRAC_ENTRY

constexpr std::size_t at(int32_t index) {
  return static_cast<std::size_t>(index);
}

// The bytes of a field, copied or viewed.
std::vector<unsigned char> copied(hfrac_sim* sim, const Entry& entry) {
  const auto bytes_of = [](const auto& values) {
    const auto* first = reinterpret_cast<const unsigned char*>(values.data());
    return std::vector<unsigned char>(first, first + values.size() * sizeof values[0]);
  };
  return entry.dtype == 0 ? bytes_of(doubles(sim, entry.field)) : bytes_of(indices(sim, entry.field));
}
struct View {
  const void* data = nullptr;
  int64_t count = 0, epoch = 0;
  std::vector<unsigned char> bytes(const Entry& entry) const {
    const auto* first = static_cast<const unsigned char*>(data);
    return {first, first + count * (entry.dtype == 0 ? 8 : 4)};
  }
};
View viewed(hfrac_sim* sim, const Entry& entry) {
  View view;
  EXPECT_EQ(hfrac_field_view(sim, entry.field, &view.data, &view.count, &view.epoch), HFRAC_OK);
  return view;
}

// One cracked simulation for all tests that only look at it.
class Fields : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const hfrac::Definition def = cracking_def(700);
    ASSERT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
    start = doubles(sim, HFRAC_DISC_POSITION);
    ASSERT_EQ(hfrac_step(sim, 3), HFRAC_OK) << last_error(sim);
  }
  static void TearDownTestSuite() { hfrac_sim_destroy(&sim); }

  static hfrac_sim* sim;
  static std::vector<double> start;  // positions at creation
};
hfrac_sim* Fields::sim = nullptr;
std::vector<double> Fields::start;

TEST_F(Fields, DescribeThemselves) {
  const auto state = state_of(sim);
  for (const auto& entry : entries) {
    SCOPED_TRACE(entry.name);
    const auto desc = desc_of(sim, entry.field);
    EXPECT_EQ(desc.struct_size, static_cast<int32_t>(sizeof desc));
    EXPECT_EQ(desc.field, entry.field);
    EXPECT_STREQ(desc.name, entry.name);
    EXPECT_STREQ(desc.unit, entry.unit);
    EXPECT_STREQ(desc.help, entry.help);
    EXPECT_EQ(desc.location, entry.location);
    EXPECT_EQ(desc.dtype, entry.dtype);
    EXPECT_EQ(desc.components, entry.components);
    EXPECT_EQ(desc.struct_pad, 0);
    EXPECT_EQ(desc.epoch, epoch_of(sim));
    const int64_t there[] = {state.disc_count, state.bond_count, state.bond_count, state.domain_count};
    if (entry.location < 4) {
      EXPECT_EQ(desc.count, there[entry.location]);
    } else if (entry.location == 5) {
      EXPECT_EQ(desc.count, 0);  // without smooth joints; with them: joint_field_test.cpp
    }
    int64_t values = -1;
    const auto count = entry.dtype == 0 ? hfrac_field_copy_f64(sim, entry.field, nullptr, 0, &values)
                                        : hfrac_field_copy_i32(sim, entry.field, nullptr, 0, &values);
    EXPECT_EQ(count, HFRAC_OK);
    EXPECT_EQ(values, desc.count * desc.components);
  }
}

TEST_F(Fields, AreFoundByName) {
  for (const auto& entry : entries) {
    int32_t field = -1;
    EXPECT_EQ(hfrac_field_find(entry.name, &field), HFRAC_OK) << entry.name;
    EXPECT_EQ(field, entry.field) << entry.name;
  }
  int32_t field = -1;
  for (const char* name : {"", "disc", "disc.positio", "disc.positions", "DISC.POSITION"}) {
    EXPECT_EQ(hfrac_field_find(name, &field), HFRAC_ERR_UNKNOWN_KEY) << name;
  }
  EXPECT_EQ(field, -1);
}

TEST_F(Fields, ThatAreNoneAreRefused) {
  hfrac_field_desc desc{};
  desc.struct_size = sizeof desc;
  double value = 0.0;
  int32_t index = 0;
  int64_t count = -1, epoch = -1;
  const void* data = nullptr;
  for (const int32_t field : {-1, 15, 19, 35, 79, INT32_MAX, INT32_MIN}) {
    EXPECT_EQ(hfrac_field_info(sim, field, &desc), HFRAC_ERR_ARGUMENT) << field;
    EXPECT_EQ(last_error(sim).rfind("field " + std::to_string(field) + " is not", 0), 0u) << last_error(sim);
    EXPECT_EQ(hfrac_field_copy_f64(sim, field, &value, 1, &count), HFRAC_ERR_ARGUMENT) << field;
    EXPECT_EQ(hfrac_field_copy_i32(sim, field, &index, 1, &count), HFRAC_ERR_ARGUMENT) << field;
    EXPECT_EQ(hfrac_field_view(sim, field, &data, &count, &epoch), HFRAC_ERR_ARGUMENT) << field;
  }
  EXPECT_EQ(count, -1);
  EXPECT_EQ(data, nullptr);
}

TEST_F(Fields, CopyNoMoreThanThereIsRoomFor) {
  for (const auto& entry : entries) {
    SCOPED_TRACE(entry.name);
    const auto desc = desc_of(sim, entry.field);
    const int64_t values = desc.count * desc.components;
    std::vector<double> reals(at(static_cast<int32_t>(values)) + 1, -77.0);
    std::vector<int32_t> whole(reals.size(), -77);
    int64_t count = -1;
    const auto copy = [&](int64_t capacity) {
      return entry.dtype == 0 ? hfrac_field_copy_f64(sim, entry.field, reals.data(), capacity, &count)
                              : hfrac_field_copy_i32(sim, entry.field, whole.data(), capacity, &count);
    };
    for (const int64_t capacity : {values - 1, int64_t{0}, int64_t{-1}, INT64_MIN}) {
      if (capacity >= values) continue;  // of a field without values
      EXPECT_EQ(copy(capacity), HFRAC_ERR_ARGUMENT) << capacity;
      EXPECT_NE(last_error(sim).find("capacity = " + std::to_string(capacity)), std::string::npos);
      EXPECT_NE(last_error(sim).find(std::to_string(values) + " values of " + entry.name), std::string::npos);
    }
    EXPECT_TRUE(std::all_of(reals.begin(), reals.end(), [](double v) { return v == -77.0; }));
    EXPECT_EQ(copy(values + 1), HFRAC_OK);
    EXPECT_EQ(count, values);
    EXPECT_EQ(reals.back(), -77.0);
    EXPECT_EQ(whole.back(), -77);
    // Of the other type it is refused, though only the count is asked for.
    const auto wrong = entry.dtype == 0 ? hfrac_field_copy_i32(sim, entry.field, nullptr, 0, &count)
                                        : hfrac_field_copy_f64(sim, entry.field, nullptr, 0, &count);
    EXPECT_EQ(wrong, HFRAC_ERR_ARGUMENT);
    EXPECT_EQ(last_error(sim),
              std::string(entry.name) + (entry.dtype == 0 ? " holds doubles; use hfrac_field_copy_f64."
                                                          : " holds int32; use hfrac_field_copy_i32."));
  }
}

TEST_F(Fields, AreViewedAsTheyAreCopied) {
  for (const auto& entry : entries) {
    SCOPED_TRACE(entry.name);
    const View view = viewed(sim, entry);
    EXPECT_TRUE(view.bytes(entry) == copied(sim, entry));
    EXPECT_EQ(view.epoch, epoch_of(sim));
    const void* data = nullptr;
    int64_t count = 0;
    EXPECT_EQ(hfrac_field_view(sim, entry.field, &data, &count, nullptr), HFRAC_OK);  // epoch not wanted
    EXPECT_EQ(data, view.data);
  }
}

TEST_F(Fields, HoldFiniteNumbersOnly) {
  for (const auto& entry : entries) {
    if (entry.dtype != 0) continue;
    const auto values = doubles(sim, entry.field);
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        << entry.name;
  }
}

TEST(FieldEpoch, RisesWithEveryChangeAndNothingElse) {
  const Sim sim(quiet_def());
  int64_t epoch = epoch_of(sim);
  const auto risen = [&] {
    const int64_t before = epoch;
    epoch = epoch_of(sim);
    return epoch > before;
  };
  double reached = 0.0;
  int32_t reason = 0;
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  EXPECT_TRUE(risen());
  ASSERT_EQ(hfrac_advance(sim, 2.0, &reached, &reason), HFRAC_OK);
  EXPECT_TRUE(risen());
  ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 29e6), HFRAC_OK);
  EXPECT_TRUE(risen());
  ASSERT_EQ(hfrac_well_set_ramp(sim, 0, 29e6, 1e6), HFRAC_OK);
  EXPECT_TRUE(risen());
  ASSERT_EQ(hfrac_well_set_rate(sim, 0, 0.0), HFRAC_OK);
  EXPECT_TRUE(risen());
  sight_of(sim);
  fractures_of(sim);
  for (const auto& entry : entries) viewed(sim, entry);
  ASSERT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
  EXPECT_EQ(hfrac_well_set_pressure(sim, 3, 29e6), HFRAC_ERR_ARGUMENT);
  EXPECT_FALSE(risen());
}

TEST(FieldViews, KeepTheirPlaceAndValuesUntilTheEpochRises) {
  const Sim sim(cracking_def());
  std::vector<View> views;
  std::vector<std::vector<unsigned char>> bytes;
  for (const auto& entry : entries) {
    views.push_back(viewed(sim, entry));
    bytes.push_back(views.back().bytes(entry));
  }
  sight_of(sim);
  fractures_of(sim);
  for (std::size_t k = 0; k < views.size(); ++k) {
    EXPECT_TRUE(views[k].bytes(entries[k]) == bytes[k]) << entries[k].name;
    EXPECT_EQ(viewed(sim, entries[k]).data, views[k].data) << entries[k].name;
  }
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  for (std::size_t k = 0; k < views.size(); ++k) {
    EXPECT_LT(views[k].epoch, epoch_of(sim));
    const View now = viewed(sim, entries[k]);
    EXPECT_EQ(now.epoch, epoch_of(sim));
    EXPECT_TRUE(now.bytes(entries[k]) == copied(sim, entries[k])) << entries[k].name;
  }
}

// What belongs together.

TEST_F(Fields, DiscsAreWhereTheyWerePlusTheirDisplacement) {
  const auto position = doubles(sim, HFRAC_DISC_POSITION),
             displacement = doubles(sim, HFRAC_DISC_DISPLACEMENT);
  double farthest = 0.0;
  for (std::size_t k = 0; k < position.size(); ++k) {
    EXPECT_NEAR(position[k] - displacement[k], start[k], 1e-11);
    farthest = std::max(farthest, std::abs(displacement[k]));
  }
  EXPECT_GT(farthest, 1e-5);
  double mean = 0.0;
  for (const double radius : doubles(sim, HFRAC_DISC_RADIUS)) {
    EXPECT_GT(radius, 0.0);
    mean += radius / static_cast<double>(state_of(sim).disc_count);
  }
  EXPECT_NEAR(mean, setup_of(sim).mean_radius, 0.02 * mean);  // which is that of all discs packed
}

TEST(FieldStart, NothingHasMovedAtFirst) {
  const Sim sim(quiet_def());
  for (const int32_t field : {HFRAC_DISC_DISPLACEMENT, HFRAC_DISC_ROTATION, HFRAC_DISC_VELOCITY}) {
    for (const double value : doubles(sim, field)) EXPECT_EQ(value, 0.0) << field;
  }
  for (const int32_t state : indices(sim, HFRAC_BOND_STATE)) EXPECT_EQ(state, 0);
  for (const double pressure : doubles(sim, HFRAC_DOMAIN_PRESSURE)) EXPECT_EQ(pressure, 25e6);
  for (const double flow : doubles(sim, HFRAC_PIPE_FLOW)) EXPECT_EQ(flow, 0.0);
}

TEST(FieldStart, ContactsCarryTheFarFieldLessThePressure) {
  hfrac::Definition def = quiet_def(1000);
  def.stress_sigma_Hmax = 40e6;
  const Sim sim(def);
  const auto stress = doubles(sim, HFRAC_DISC_STRESS);
  const auto position = doubles(sim, HFRAC_DISC_POSITION);
  double xx = 0.0, yy = 0.0, xy = 0.0, discs = 0.0;
  for (std::size_t k = 0; k < position.size() / 2; ++k) {
    const double x = position[2 * k] - 50.0, y = position[2 * k + 1] - 50.0;
    const double r = std::hypot(x, y);
    if (r < 25.0 || r > 45.0) continue;  // away from the hole and the boundary
    xx += stress[3 * k];
    yy += stress[3 * k + 1];
    xy += stress[3 * k + 2];
    discs += 1.0;
  }
  EXPECT_NEAR(xx / discs, 15e6, 3e6);
  EXPECT_NEAR(yy / discs, 5e6, 3e6);
  EXPECT_NEAR(xy / discs, 0.0, 2e6);
}

TEST_F(Fields, BondsJoinTwoDiscs) {
  const auto discs = indices(sim, HFRAC_BOND_DISCS);
  const auto state = indices(sim, HFRAC_BOND_STATE);
  const auto intact_bonds = indices(sim, HFRAC_DISC_INTACT_BONDS);
  const auto summary = state_of(sim);
  std::vector<int32_t> intact(intact_bonds.size(), 0);
  int64_t tension = 0, shear = 0;
  for (std::size_t e = 0; e < state.size(); ++e) {
    for (const int32_t disc : {discs[2 * e], discs[2 * e + 1]}) {
      ASSERT_GE(disc, 0);
      ASSERT_LT(disc, summary.disc_count);
      intact[at(disc)] += state[e] == 0 ? 1 : 0;
    }
    EXPECT_NE(discs[2 * e], discs[2 * e + 1]);
    ASSERT_TRUE(state[e] >= 0 && state[e] <= 2);
    tension += state[e] == 1 ? 1 : 0;
    shear += state[e] == 2 ? 1 : 0;
  }
  EXPECT_GT(tension, 0);
  EXPECT_EQ(tension, summary.tensile_cracks);
  EXPECT_EQ(shear, summary.shear_cracks);
  EXPECT_TRUE(intact == intact_bonds);
}

TEST_F(Fields, OpenBrokenBondsCarryNothing) {
  const auto state = indices(sim, HFRAC_BOND_STATE);
  const auto gap = doubles(sim, HFRAC_BOND_GAP), normal = doubles(sim, HFRAC_BOND_NORMAL_FORCE),
             shear = doubles(sim, HFRAC_BOND_SHEAR_FORCE), moment = doubles(sim, HFRAC_BOND_MOMENT);
  int open = 0;
  for (std::size_t e = 0; e < state.size(); ++e) {
    if (state[e] == 0) continue;
    EXPECT_EQ(moment[e], 0.0);
    EXPECT_LE(normal[e], 0.0);  // no tension without a bond
    if (gap[e] <= 0.0) continue;
    ++open;
    EXPECT_EQ(normal[e], 0.0);
    EXPECT_EQ(shear[e], 0.0);
  }
  EXPECT_GT(open, 0);
}

TEST_F(Fields, DomainsArePolygonsOfBondedDiscs) {
  const auto discs = indices(sim, HFRAC_BOND_DISCS), domains = indices(sim, HFRAC_PIPE_DOMAINS);
  const auto offset = indices(sim, HFRAC_DOMAIN_OFFSET), corners = indices(sim, HFRAC_DOMAIN_CORNERS);
  const auto summary = state_of(sim);
  // The bond of two discs, and the domain on its left if walked from the first named to the second.
  std::map<std::pair<int32_t, int32_t>, int32_t> left_of;
  for (std::size_t e = 0; e < discs.size() / 2; ++e) {
    for (const int32_t domain : {domains[2 * e], domains[2 * e + 1]}) {
      ASSERT_GE(domain, 0);
      ASSERT_LT(domain, summary.domain_count);
    }
    left_of[{discs[2 * e], discs[2 * e + 1]}] = domains[2 * e];
    left_of[{discs[2 * e + 1], discs[2 * e]}] = domains[2 * e + 1];
  }
  ASSERT_EQ(static_cast<int64_t>(left_of.size()), 2 * summary.bond_count) << "two bonds join the same discs";
  EXPECT_EQ(static_cast<int64_t>(corners.size()), 2 * summary.bond_count);
  EXPECT_EQ(summary.disc_count - summary.bond_count + summary.domain_count, 2);  // Euler

  ASSERT_EQ(offset.front(), 0);
  for (int32_t d = 0; d < summary.domain_count; ++d) {
    const int32_t first = offset[at(d)];
    const int32_t end =
        d + 1 < summary.domain_count ? offset[at(d + 1)] : static_cast<int32_t>(corners.size());
    ASSERT_GE(end - first, 3) << "domain " << d;
    double area = 0.0;
    for (int32_t c = first; c < end; ++c) {
      const int32_t from = corners[at(c)], to = corners[at(c + 1 < end ? c + 1 : first)];
      ASSERT_TRUE(left_of.count({from, to}) == 1) << "corners " << from << " and " << to << " are not bonded";
      EXPECT_EQ(left_of.at({from, to}), d);
      const double* p = &start[at(2 * from)];
      const double* q = &start[at(2 * to)];
      area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
    }
    EXPECT_GT(d == 0 ? -area : area, 0.0) << "domain " << d;
  }
}

TEST_F(Fields, OneDomainIsOutsideAndOnePerWellIsAWell) {
  const auto kind = indices(sim, HFRAC_DOMAIN_KIND);
  const auto pressure = doubles(sim, HFRAC_DOMAIN_PRESSURE), centre = doubles(sim, HFRAC_DOMAIN_CENTRE);
  EXPECT_EQ(kind[0], 2);
  EXPECT_EQ(std::count(kind.begin(), kind.end(), 2), 1);
  EXPECT_EQ(std::count(kind.begin(), kind.end(), 1), 1);
  const auto well = well_of(sim);
  const std::size_t domain = at(static_cast<int32_t>(well.domain));
  EXPECT_EQ(kind[domain], 1);
  EXPECT_EQ(pressure[domain], well.pressure);
  EXPECT_NEAR(centre[2 * domain], well.x, 2.0);
  EXPECT_NEAR(centre[2 * domain + 1], well.y, 2.0);
  EXPECT_EQ(pressure[0], 0.0);  // the formation's, net
  const auto volume = doubles(sim, HFRAC_DOMAIN_VOLUME);
  for (std::size_t d = 1; d < volume.size(); ++d) EXPECT_GT(volume[d], 0.0) << "domain " << d;
  EXPECT_EQ(std::max_element(volume.begin() + 1, volume.end()) - volume.begin(),
            static_cast<int64_t>(domain));
}

TEST(FieldSecondFluid, IsTheShareOfWhatAWellPumped) {
  hfrac::Definition def = quiet_def();
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 1e-3;
  def.wells[0].fluid = 1;
  EXPECT_EQ(hfrac_sim_def_check(&def), HFRAC_ERR_MODEL);
  EXPECT_NE(last_error().find("fluid.second_viscosity"), std::string::npos) << last_error();
  def.fluid_second_viscosity = 1.0;
  const Sim sim(def);
  for (const double share : doubles(sim, HFRAC_DOMAIN_SECOND_FLUID)) EXPECT_EQ(share, 0.0);
  ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
  const auto share = doubles(sim, HFRAC_DOMAIN_SECOND_FLUID);
  EXPECT_EQ(share[static_cast<std::size_t>(well_of(sim).domain)], 1.0);
  EXPECT_EQ(share[0], 0.0);
  double most = 0.0;
  for (std::size_t d = 1; d < share.size(); ++d)
    if (static_cast<int64_t>(d) != well_of(sim).domain) most = std::max(most, share[d]);
  EXPECT_GT(most, 0.0);
  EXPECT_LE(most, 1.0);
}

// A host that changes the fluid gets what a schedule gives that changes it at the same time; the rest of the schedule goes on.
TEST(FieldSecondFluid, IsChangedByAHostAsByASchedule) {
  hfrac::Definition def = quiet_def();
  def.fluid_second_viscosity = 0.1;
  def.stepping_flow_step = 1.0;
  def.wells[0].control = HFRAC_WELL_RATE;
  def.wells[0].rate = 1e-3;
  hfrac_schedule_def turns[2] = {{0, 2.0, 1e-3, HFRAC_WELL_RATE, 2},  // the second fluid
                                 {0, 5.0, 0.0, HFRAC_WELL_RATE, 0}};  // shut in
  const auto with = [&](int64_t first) {
    def.schedule = turns + first;
    def.schedule_count = 2 - first;
    def.schedule_size = sizeof(hfrac_schedule_def);
    hfrac_sim* sim = nullptr;
    EXPECT_EQ(hfrac_sim_create(&def, &sim), HFRAC_OK) << last_error();
    return sim;
  };
  hfrac_sim *scheduled = with(0), *told = with(1);
  def.schedule = nullptr;
  def.schedule_count = 0;
  const auto same = [&] {
    return doubles(scheduled, HFRAC_DOMAIN_SECOND_FLUID) == doubles(told, HFRAC_DOMAIN_SECOND_FLUID) &&
           doubles(scheduled, HFRAC_DOMAIN_PRESSURE) == doubles(told, HFRAC_DOMAIN_PRESSURE);
  };
  const auto step_both = [&](int64_t count) {
    for (hfrac_sim* sim : {scheduled, told}) EXPECT_GE(hfrac_step(sim, count), 0) << last_error(sim);
  };
  step_both(2);
  EXPECT_EQ(hfrac_well_set_fluid(told, 0, HFRAC_WELL_FLUID_SECOND), HFRAC_OK) << last_error(told);
  EXPECT_EQ(well_of(told).fluid, HFRAC_WELL_FLUID_SECOND);
  step_both(2);
  EXPECT_EQ(well_of(scheduled).fluid, HFRAC_WELL_FLUID_SECOND);
  EXPECT_TRUE(same());
  const auto well = static_cast<std::size_t>(well_of(told).domain);
  EXPECT_EQ(doubles(told, HFRAC_DOMAIN_SECOND_FLUID)[well], 1.0);
  // Back, also where the schedule chose the fluid; a step that is tried again keeps it.
  for (hfrac_sim* sim : {scheduled, told}) {
    ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK) << last_error(sim);
    ASSERT_GE(hfrac_step_do(sim, 1.0), 0) << last_error(sim);
    EXPECT_EQ(hfrac_well_set_fluid(sim, 0, HFRAC_WELL_FLUID_FIRST), HFRAC_OK) << last_error(sim);
    ASSERT_GE(hfrac_step_do(sim, 1.0), 0) << last_error(sim);
    ASSERT_EQ(hfrac_step_finalize(sim), HFRAC_OK) << last_error(sim);
    EXPECT_EQ(well_of(sim).fluid, HFRAC_WELL_FLUID_FIRST);
    EXPECT_EQ(doubles(sim, HFRAC_DOMAIN_SECOND_FLUID)[well], 0.0);
    EXPECT_EQ(well_of(sim).rate, 1e-3);
  }
  EXPECT_TRUE(same());
  step_both(1);
  EXPECT_EQ(well_of(told).rate, 0.0) << "the schedule's shut-in";
  EXPECT_TRUE(same());
  EXPECT_EQ(hfrac_well_set_fluid(told, 0, 2), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(told).find("fluid = 2"), std::string::npos) << last_error(told);
  for (hfrac_sim* sim : {scheduled, told}) hfrac_sim_destroy(&sim);
  const Sim plain(quiet_def());
  EXPECT_EQ(hfrac_well_set_fluid(plain, 0, HFRAC_WELL_FLUID_SECOND), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(plain).find("fluid.second_viscosity"), std::string::npos) << last_error(plain);
}

// A fracture that opens faster than it fills has a tip without fluid: the front is where domain.saturation falls below one.
TEST(FieldSaturation, PoresAheadOfTheFluidHaveRoomLeft) {
  hfrac::Definition def = cracking_def();
  def.stress_convention = 0;  // total: the floor is no pressure at all
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 20e6;
  def.fluid_formation_pressure = 1e5;
  def.wells[0].pressure = 80e6;
  const Sim sim(def);
  for (const double share : doubles(sim, HFRAC_DOMAIN_SATURATION)) EXPECT_EQ(share, 1.0);
  ASSERT_GE(hfrac_step(sim, 3), 0) << last_error(sim);
  ASSERT_GT(state_of(sim).crack_count, 0);
  const auto filled = doubles(sim, HFRAC_DOMAIN_SATURATION), pressure = doubles(sim, HFRAC_DOMAIN_PRESSURE);
  ASSERT_EQ(filled.size(), pressure.size());
  int partly = 0;
  for (std::size_t d = 0; d < filled.size(); ++d) {
    EXPECT_GE(filled[d], 0.0) << "domain " << d;
    EXPECT_LE(filled[d], 1.0) << "domain " << d;
    if (filled[d] == 1.0) continue;
    ++partly;
    EXPECT_EQ(pressure[d], 0.0) << "domain " << d;
  }
  EXPECT_GT(partly, 0);
}

TEST(FieldFlow, WhatLeavesThroughPipesIsWhatTheBalanceSays) {
  hfrac::Definition def = quiet_def();
  def.stepping_flow_step = 1e6;  // long enough to reach the boundary
  const Sim sim(def);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const auto domains = indices(sim, HFRAC_PIPE_DOMAINS);
  const auto flow = doubles(sim, HFRAC_PIPE_FLOW), aperture = doubles(sim, HFRAC_PIPE_APERTURE);
  double out = 0.0;
  for (std::size_t e = 0; e < flow.size(); ++e) {
    EXPECT_GT(aperture[e], 0.0);
    EXPECT_LE(aperture[e], def.flow_aperture_limit);
    if (domains[2 * e + 1] == 0) out += flow[e];
    if (domains[2 * e] == 0) out -= flow[e];
  }
  const double leaked = balance_of(sim).leaked_volume;
  EXPECT_GT(leaked, 0.0);
  EXPECT_NEAR(out * def.stepping_flow_step, leaked, 1e-12 * leaked);
}

}  // namespace field_test
