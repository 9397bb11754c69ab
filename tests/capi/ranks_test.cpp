// SPDX-License-Identifier: BSD-3-Clause
// One simulation on several ranks gives what one alone gives, to the last bit: any number of ranks and workers, all ways of
// stepping, both laws of fractures, walls, rock beyond, joints. And no rank waits for one that has gone.
#include <cstdio>
#include <string>
#include <vector>

#include "sim_support.hpp"
#include "thread_exchange.hpp"

namespace ranks_test {

using namespace testing_capi;

struct Case {
  const char* name;
  int64_t discs;
  int64_t steps;
  void (*change)(hfrac::Definition&);
  int64_t fewest_cracks;
  friend std::ostream& operator<<(std::ostream& out, const Case& which) { return out << which.name; }
};

// Bricks whose relaxations take longer or shorter, and report more or less often.
constexpr Case tiled{"tiled", 6000, 1,
                     [](auto& def) {
                       def.packing_method = 1;
                       def.packing_brick_discs = 600;
                       def.flow_scheme = 2;
                     },
                     0};

constexpr Case cases[] = {
    {"walls", 2400, 2, [](auto&) {}, 3},
    {"far_field", 2400, 2,
     [](auto& def) {
       def.stress_convention = 0;
       def.boundary_kind = 0;
       def.stress_sigma_Hmax = 33e6;
       def.stress_sigma_hmin = 28e6;
       def.wells[0].pressure = 80e6;
     },
     3},
    {"real_motion", 2400, 2,
     [](auto& def) {
       def.stepping_mode = 1;
       def.stepping_flow_step = 2e-2;
     },
     3},
    {"dry", 2400, 1, [](auto& def) { def.flow_scheme = 2; }, 0},
    tiled,
    {"rock_beyond", 1200, 1,
     [](auto& def) {
       def.stress_convention = 0;
       def.boundary_kind = 2;
       def.stress_sigma_Hmax = 33e6;
       def.stress_sigma_hmin = 28e6;
       def.wells[0].pressure = 80e6;
     },
     1},
    {"facets", 1600, 2,
     [](auto& def) {
       def.stress_convention = 0;
       def.boundary_kind = 0;
       def.stress_sigma_Hmax = 12e6;
       def.stress_sigma_hmin = 10e6;
       def.fluid_formation_pressure = 0.0;
       def.bond_fracture_toughness = 2e6;
       def.fracture_plane_modulus = 18.6e9;
       def.wells[0].pressure = 90e6;
     },
     1},
    {"softening", 1600, 1, [](auto& def) { def.bond_fracture_energy = 2e6; }, 0},
    {"quasi_static", 1200, 2,
     [](auto& def) {
       def.solver_kind = 1;
       def.stepping_mode = 2;
     },
     1},
    {"joint", 1600, 2,
     [](auto& def) {
       ASSERT_EQ(hfrac_sim_def_set_i64(&def, "joint_count", 1), HFRAC_OK);
       auto& joint = def.joints[0];
       joint.x1 = 20.0;
       joint.y1 = 20.0;
       joint.x2 = 80.0;
       joint.y2 = 75.0;
     },
     1},
};

struct End {
  std::uint64_t hash = 0;
  std::vector<unsigned char> image;
  std::vector<hfrac_crack> cracks;
  double permeability = 0.0;
};

End end_of(hfrac_sim* sim) {
  End end;
  end.hash = hash_of(sim);
  int64_t size = 0, next = 0, count = 0;
  EXPECT_EQ(hfrac_state_size(sim, &size), HFRAC_OK);
  end.image.resize(static_cast<std::size_t>(size));
  EXPECT_EQ(hfrac_state_save(sim, end.image.data(), size, &size), HFRAC_OK);
  EXPECT_EQ(hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), nullptr, 0, &count, &next), HFRAC_OK);
  end.cracks.resize(static_cast<std::size_t>(count) + 1);
  EXPECT_EQ(hfrac_cracks_since(sim, 0, sizeof(hfrac_crack), end.cracks.data(), count + 1, &count, &next),
            HFRAC_OK);
  end.cracks.resize(static_cast<std::size_t>(count));
  return end;
}

hfrac::Definition def_of(const Case& which, int64_t workers) {
  hfrac::Definition def = cracking_def(which.discs);
  def.stepping_flow_step = 1e-2;
  def.wells[0].pressure = 70e6;
  which.change(def);
  def.run_workers = workers;
  return def;
}

// All ranks' ends. `first`: what each goes on from, if anything; steps are those after it.
std::vector<End> on_ranks(const Case& which, int32_t size, int64_t workers, int64_t steps,
                          const std::vector<unsigned char>& first = {}, const std::string& packed = {}) {
  hfrac::Definition def = def_of(which, workers);
  EXPECT_EQ(hfrac_sim_def_set_str(&def, "packing.file", packed.c_str()), HFRAC_OK);
  Meeting meeting(size);
  std::vector<End> ends(static_cast<std::size_t>(size));
  meeting.run([&](int32_t rank) {
    const auto exchange = meeting.exchange(rank);
    hfrac_sim* sim = nullptr;
    ASSERT_EQ(hfrac_sim_create_on(&def, &exchange, &sim), HFRAC_OK) << last_error();
    if (!first.empty()) {
      EXPECT_EQ(hfrac_state_restore(sim, first.data(), static_cast<int64_t>(first.size())), HFRAC_OK);
    }
    EXPECT_GE(hfrac_step(sim, steps), 0) << last_error(sim);
    ends[static_cast<std::size_t>(rank)] = end_of(sim);
    hfrac_sim_destroy(&sim);
  });
  return ends;
}

class Ranks : public testing::TestWithParam<Case> {};

// Numbers of ranks, and workers of each.
void expect_the_bits_of_one(const Case& which, const std::vector<std::pair<int32_t, int64_t>>& teams) {
  const Sim sim(def_of(which, 1));
  ASSERT_GE(hfrac_step(sim, which.steps), 0);
  const End alone = end_of(sim);
  EXPECT_GE(static_cast<int64_t>(alone.cracks.size()), which.fewest_cracks);
  for (const auto& [size, workers] : teams) {
    for (const auto& end : on_ranks(which, size, workers, which.steps)) {
      EXPECT_EQ(end.hash, alone.hash) << size << " ranks, " << workers << " workers";
      EXPECT_EQ(end.image, alone.image) << size << " ranks, " << workers << " workers";
    }
  }
}

TEST_P(Ranks, GiveTheBitsOfOne) {
  expect_the_bits_of_one(GetParam(), {{2, 1}, {3, 2}, {5, 1}});
}

// Of so many discs each answers for its own rows of the tangent only, and has its part of the factor.
TEST(RanksShare, TheTangentOfAQuasiStaticModel) {
  constexpr Case large{"quasi_static", 2400, 1,
                       [](auto& def) {
                         def.solver_kind = 1;
                         def.stepping_mode = 2;
                         def.wells[0].pressure = 55e6;
                       },
                       1};
  expect_the_bits_of_one(large, {{3, 2}});
}

// What was packed by one is what any number begins from, to the last bit; how wells are driven may differ.
TEST_P(Ranks, BeginFromAPackedModel) {
  const Case& which = GetParam();
  const std::string file = testing::TempDir() + "hfrac_packed_" + which.name;
  hfrac::Definition def = def_of(which, 1);
  const double pressure = def.wells[0].pressure;
  def.wells[0].pressure = 1e6;
  ASSERT_EQ(hfrac_pack(&def, file.c_str()), HFRAC_OK) << last_error();
  def.wells[0].pressure = pressure;
  const Sim sim(def);
  ASSERT_GE(hfrac_step(sim, which.steps), 0);
  const End straight = end_of(sim);
  for (const int32_t size : {1, 2, 3})
    for (const auto& end : on_ranks(which, size, 1, which.steps, {}, file)) {
      EXPECT_EQ(end.hash, straight.hash) << size << " ranks";
      EXPECT_EQ(end.image, straight.image) << size << " ranks";
    }
  std::remove(file.c_str());
}

INSTANTIATE_TEST_SUITE_P(Cases, Ranks, testing::ValuesIn(cases),
                         [](const auto& which) { return std::string(which.param.name); });

// 1, 3, 2 ranks one after the other, each from the state of the one before.
TEST(RanksGoOn, FromWhatAnyOtherNumberWrote) {
  const Case& which = cases[1];
  const Sim sim(def_of(which, 1));
  ASSERT_GE(hfrac_step(sim, 3), 0);
  const End straight = end_of(sim);
  std::vector<unsigned char> image;
  for (const int32_t size : {1, 3, 2}) image = on_ranks(which, size, 1, 1, image)[0].image;
  EXPECT_EQ(image, straight.image);
}

// work(rank, its simulation, its table) on each of some ranks.
template <class Work>
void on_each(int32_t size, const hfrac::Definition& def, const Work& work) {
  Meeting meeting(size);
  meeting.run([&](int32_t rank) {
    const auto exchange = meeting.exchange(rank);
    hfrac_sim* sim = nullptr;
    ASSERT_EQ(hfrac_sim_create_on(&def, &exchange, &sim), HFRAC_OK) << last_error();
    work(rank, sim, exchange);
    EXPECT_EQ(hfrac_sim_destroy(&sim), HFRAC_OK);
  });
}

TEST(RanksStop, AllIfOneAsksTo) {
  on_each(3, def_of(cases[0], 1), [](int32_t rank, hfrac_sim* sim, const hfrac_exchange&) {
    const auto before = hash_of(sim);
    const auto stop = [](void*, double, const char*) { return 1; };
    ASSERT_EQ(hfrac_set_progress(sim, rank == 1 ? +stop : nullptr, nullptr, 0.0), HFRAC_OK);
    EXPECT_EQ(hfrac_step(sim, 1), HFRAC_STOPPED);
    EXPECT_EQ(hash_of(sim), before);
    ASSERT_EQ(hfrac_set_progress(sim, nullptr, nullptr, 0.0), HFRAC_OK);
    EXPECT_GE(hfrac_step(sim, 1), 0);
  });
}

// Ranks relax bricks of their own, which takes each as long as it takes.
TEST(RanksStop, WhileBricksAreRelaxed) {
  const hfrac::Definition def = def_of(tiled, 2);
  Meeting meeting(3);
  meeting.run([&](int32_t rank) {
    const auto exchange = meeting.exchange(rank);
    hfrac_sim_def mine = def;
    if (rank == 1) mine.progress = [](void*, double done, const char*) { return done > 0.1 ? 1 : 0; };
    hfrac_sim* sim = nullptr;
    EXPECT_EQ(hfrac_sim_create_on(&mine, &exchange, &sim), HFRAC_STOPPED) << last_error();
    EXPECT_EQ(sim, nullptr);
  });
}

// A host that told its ranks different things is told which, on all ranks, before any waits for another.
TEST(RanksRefuse, DefinitionsThatDiffer) {
  struct Difference {
    const char* named;
    void (*make)(hfrac::Definition&);
  };
  for (const auto& [named, make] :
       {Difference{"bond.tensile_strength", [](auto& def) { def.bond_tensile_strength *= 1.0 + 1e-15; }},
        Difference{"model.seed", [](auto& def) { def.model_seed = 2; }},
        Difference{"output.pieces", [](auto& def) { def.output_pieces = 3; }},
        Difference{"the list of wells", [](auto& def) { def.wells[0].pressure += 1.0; }},
        Difference{"the list of joints", [](auto& def) { hfrac_sim_def_set_i64(&def, "joint_count", 1); }},
        Difference{"the list of given discs",
                   [](auto& def) {
                     static const double discs[] = {50.0, 50.0, 1.0};
                     def.given_discs = discs;
                     def.given_disc_count = 1;
                   }},
        Difference{"packing.file",
                   [](auto& def) { hfrac_sim_def_set_str(&def, "packing.file", "nowhere.model"); }}}) {
    Meeting meeting(3);
    meeting.run([&](int32_t rank) {
      const auto exchange = meeting.exchange(rank);
      hfrac::Definition def = def_of(cases[0], 1 + rank);  // workers may differ
      if (rank == 1) make(def);
      hfrac_sim* sim = nullptr;
      EXPECT_EQ(hfrac_sim_create_on(&def, &exchange, &sim), HFRAC_ERR_ARGUMENT);
      EXPECT_NE(last_error().find(named), std::string::npos) << last_error();
    });
  }
}

// The same of calls on the way: what differs is refused before the step, and forgiven once it is the same.
TEST(RanksRefuse, StepsThatDiffer) {
  on_each(3, def_of(cases[1], 1), [](int32_t rank, hfrac_sim* sim, const hfrac_exchange&) {
    const auto cycles = [&] {
      return read_struct<hfrac_sim_state>([&](auto* to) { return hfrac_sim_get_state(sim, to); }).cycles;
    };
    const auto before = cycles();
    const auto refused = [&](int32_t status, const char* named) {
      EXPECT_EQ(status, HFRAC_ERR_ARGUMENT);
      EXPECT_NE(last_error(sim).find(named), std::string::npos) << last_error(sim);
      EXPECT_EQ(cycles(), before);
    };
    ASSERT_EQ(hfrac_well_set_pressure(sim, 0, rank == 2 ? 71e6 : 70e6), HFRAC_OK);
    refused(hfrac_step(sim, 1), "how wells are driven");
    ASSERT_EQ(hfrac_well_set_pressure(sim, 0, 70e6), HFRAC_OK);
    ASSERT_EQ(hfrac_set_far_field(sim, 33e6, rank == 0 ? 28e6 : 29e6), HFRAC_OK);
    refused(hfrac_step(sim, 1), "the far field");
    ASSERT_EQ(hfrac_set_far_field(sim, 33e6, 28e6), HFRAC_OK);
    ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
    refused(hfrac_step_do(sim, rank == 1 ? 1e-3 : 2e-3), "the length of the step");
    EXPECT_GE(hfrac_step_do(sim, 1e-3), 0) << last_error(sim);
    EXPECT_EQ(hfrac_step_finalize(sim), HFRAC_OK);
  });
}

// One goes away, as a killed process does: the others' calls end, and the state they had stands.
TEST(RanksFail, AllIfOneIsGone) {
  on_each(3, def_of(cases[1], 1), [](int32_t rank, hfrac_sim* sim, const hfrac_exchange& exchange) {
    if (rank == 2) {
      exchange.fail(exchange.user);
    } else {
      const auto before = hash_of(sim);
      EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_EXCHANGE);
      EXPECT_NE(last_error(sim).find("another rank"), std::string::npos);
      EXPECT_EQ(hash_of(sim), before);
      EXPECT_EQ(hfrac_step(sim, 1), HFRAC_ERR_EXCHANGE);
    }
  });
}

// A host's function that throws does so on one rank only.
TEST(RanksFail, AllIfACallbackThrowsOnOne) {
  on_each(2, def_of(cases[1], 1), [](int32_t rank, hfrac_sim* sim, const hfrac_exchange&) {
    const auto thrower = [](void*, double, const char*) -> int32_t { throw 1; };
    ASSERT_EQ(hfrac_set_progress(sim, rank == 1 ? +thrower : nullptr, nullptr, 0.0), HFRAC_OK);
    EXPECT_EQ(hfrac_step(sim, 1), rank == 1 ? HFRAC_ERR_CALLBACK : HFRAC_ERR_EXCHANGE);
    // The others say which rank it was, and what it ran into.
    const std::string said = last_error(sim);
    EXPECT_NE(said.find("callback"), std::string::npos) << said;
    EXPECT_EQ(said.find("rank 1 has failed") != std::string::npos, rank == 0) << said;
  });
}

TEST(RanksRefuse, WhatIsNoTable) {
  const hfrac::Definition def = quiet_def();
  Meeting meeting(2);
  hfrac_sim* sim = nullptr;
  const auto refused = [&](const hfrac_exchange& table, const std::string& word) {
    EXPECT_LT(hfrac_sim_create_on(&def, &table, &sim), 0);
    EXPECT_EQ(sim, nullptr);
    EXPECT_NE(last_error().find(word), std::string::npos) << last_error();
  };
  auto table = meeting.exchange(0);
  table.size = 0;
  refused(table, "size is 0");
  table = meeting.exchange(0);
  table.rank = 2;
  refused(table, "rank is 2");
  table = meeting.exchange(0);
  table.sum = nullptr;
  refused(table, "NULL");
  table = meeting.exchange(0);
  table.struct_size = 0;
  refused(table, "struct_size");
  EXPECT_EQ(hfrac_sim_create_on(&def, nullptr, &sim), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_exchange_init(nullptr, sizeof table), HFRAC_ERR_ARGUMENT);
  // One rank needs nobody.
  ASSERT_EQ(hfrac_exchange_init(&table, sizeof table), HFRAC_OK);
  ASSERT_EQ(hfrac_sim_create_on(&def, &table, &sim), HFRAC_OK) << last_error();
  const auto traffic = read_struct<hfrac_traffic>([&](auto* to) { return hfrac_get_traffic(sim, to); });
  EXPECT_EQ(traffic.messages, 0);
  EXPECT_EQ(traffic.bytes, 0);
  hfrac_sim_destroy(&sim);
}

// What goes from rank to rank is what lies at the edge between them.
TEST(RanksTalk, OfTheDiscsBetweenThemOnly) {
  hfrac::Definition def = quiet_def(6000);
  def.flow_scheme = 2;
  std::vector<hfrac_traffic> traffic(2);
  on_each(2, def, [&](int32_t rank, hfrac_sim* sim, const hfrac_exchange&) {
    traffic[static_cast<std::size_t>(rank)] =
        read_struct<hfrac_traffic>([&](auto* to) { return hfrac_get_traffic(sim, to); });
  });
  for (const auto& of : traffic) {
    EXPECT_EQ(of.messages, 1);
    EXPECT_EQ(of.bytes, 24 * of.foreign_discs);
    EXPECT_GT(of.foreign_discs, 20);
    EXPECT_LT(of.foreign_discs, 300);  // sqrt(6000) = 77 lie along a straight cut
  }
  EXPECT_EQ(traffic[0].shared_bonds, 0);  // the first rank counts them
  EXPECT_GT(traffic[1].shared_bonds, 20);
}

}  // namespace ranks_test
