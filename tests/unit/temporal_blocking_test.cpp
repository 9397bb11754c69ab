// SPDX-License-Identifier: BSD-3-Clause
// Several cycles in one pass give what one cycle at a time gives, to the last bit: for any number of cycles and workers, with
// bonds breaking and contacts sliding on the way, and where it hands over to single cycles because discs without a bond touch.
#include "solid/temporal_blocking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include "../thread_sanitizer.hpp"
#include "core/hash.hpp"
#include "model.hpp"
#include "solid/blocked_batch.hpp"

namespace temporal_blocking_test {

using namespace testing_unit;

Discs hexagonal(int columns, int rows) {
  Discs discs;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      discs.x.push_back(0.5 + column + 0.5 * (row % 2));
      discs.y.push_back(0.5 + std::sqrt(0.75) * row);
      discs.radius.push_back(0.5);
    }
  }
  const auto order = hilbert_order(discs.x, discs.y);
  Discs sorted = discs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.x[i] = discs.x[order[i]];
    sorted.y[i] = discs.y[order[i]];
  }
  return sorted;
}

struct Result {
  std::uint64_t state = 0;
  std::size_t cracks = 0;
  std::int64_t loose = 0;
  double friction = 0.0;
};

Result fingerprint(const TestModel& m, const CrackLog& log) {
  Hash hash;
  const auto& a = m.assembly;
  const auto& n = m.network;
  for (const auto* values : {&a.ux, &a.uy, &a.rotation, &a.vx, &a.vy, &a.spin, &a.external_x, &a.external_y,
                             &a.external_moment, &a.slip, &n.pressure, &n.volume_change})
    hash.add_all(*values);
  hash.add_all(a.intact);
  const auto& e = m.solver->energies();
  for (const double energy : {e.friction, e.damping, e.fluid, e.fracture}) hash.add(energy);
  for (const auto& crack : log) {
    hash.add(static_cast<std::uint64_t>(crack.bond));
    hash.add(static_cast<std::uint64_t>(crack.cycle));
    hash.add(crack.energy);
  }
  for (const auto& wall : m.boundary->walls()) hash.add(wall.displacement);
  return {hash.value(), log.size(), static_cast<std::int64_t>(m.solver->non_bonded_contacts().pairs().size()),
          e.friction};
}

// Velocities at random [m/s].
void stir(TestModel& m, double speed) {
  Random random(3);
  for (std::int64_t i = 0; i < m.assembly.disc_count(); ++i) {
    m.assembly.vx[i] = speed * (random.uniform() - 0.5);
    m.assembly.vy[i] = speed * (random.uniform() - 0.5);
  }
}

// 21 tiles with free edges.
Result sheet(const BlockingShape& shape, int workers) {
  static const Discs discs = hexagonal(104, 102);
  Options o = dry_options(100);
  o.bond_tensile_strength = o.bond_shear_strength = 6e6;
  TestModel m(o, discs, {}, workers);
  m.solver->set_blocking(shape);
  m.solver->use_real_masses();
  stir(m, 40.0);
  CrackLog log;
  m.solver->run(37, log);
  m.solver->run(26, log);
  return fingerprint(m, log);
}

// The same rock with pores that answer, pushed apart from a hole under pressure.
Result pores(const BlockingShape& shape, int workers) {
  static const Discs discs = packed(dry_options(4000));
  Options o = dry_options(4000);
  o.flow_scheme = choice(FlowScheme::implicit_scheme);
  o.stress_convention = choice(StressConvention::effective);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 1e7;
  o.bond_tensile_strength = 4e6;
  o.bond_shear_strength = 2e7;
  TestModel m(o, discs, {{{10.0, 10.0}, 3.0}}, workers);
  m.solver->set_blocking(shape);
  m.boundary->set_load(m.assembly, 1.0);
  m.fill_pores();
  m.solver->set_undrained(true);
  m.network.pressure[m.well_domains[0]] = 3e7;
  CrackLog log;
  m.solver->run(150, log);
  m.solver->set_undrained(false);
  m.solver->run(25, log);
  return fingerprint(m, log);
}

// 8 tiles between walls, around a hole, pressed and then shaken; at the end discs that were never bonded touch.
Result rock(const BlockingShape& shape, int workers) {
  static const Discs discs = packed(dry_options(4000));
  Options o = dry_options(4000);
  o.stress_convention = choice(StressConvention::effective);
  o.boundary_kind = choice(BoundaryKind::walls);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 2e7;
  o.bond_tensile_strength = o.bond_shear_strength = 8e6;
  TestModel m(o, discs, {{{10.0, 10.0}, 3.0}}, workers);
  m.solver->set_blocking(shape);
  m.boundary->set_load(m.assembly, 1.0);
  CrackLog log;
  m.solver->relax(1e-2, 200, log);
  m.boundary->fix_walls();
  m.solver->use_real_masses();
  stir(m, 30.0);
  m.solver->run(50, log);
  m.solver->search_contacts(log);
  m.solver->run(30, log);
  return fingerprint(m, log);
}

TEST(TemporalBlocking, GivesTheBitsOfSingleCycles) {
  for (const auto model : {&sheet, &rock, &pores}) {
    const Result alone = model({1, 1, 1}, 1);
    EXPECT_GT(alone.cracks, 20U);
    EXPECT_GT(alone.friction, 0.0);
    EXPECT_EQ(alone.loose > 0, model == &rock);
    for (const int cycles : thread_sanitizer::numbers({2, 4, 8}, {4})) {
      for (const int workers : thread_sanitizer::numbers({1, 2, 3}, {3})) {
        const Result swept = model({cycles, 2, workers}, workers);
        EXPECT_EQ(swept.state, alone.state) << cycles << " cycles, " << workers << " workers";
        EXPECT_EQ(swept.cracks, alone.cracks);
      }
    }
  }
}

// The list holds every item once a cycle, and what an item needs before it.
TEST(TemporalBlocking, ListsEverythingAfterWhatItNeeds) {
  Options o = dry_options(100);
  TestModel m(o, hexagonal(104, 102));
  const TilePlan plan = plan_tiles(m.assembly, m.network, false, false);
  const TemporalBlocking blocking = plan_blocking(plan, m.assembly, m.network, {6, 2, 3}, 3);
  std::vector<std::int32_t> tiles(plan.tiles.size(), 0), parts(plan.tiles.size(), 0);
  for (const auto& task : blocking.tasks) {
    if (task.item < 0) {
      const auto part = static_cast<std::size_t>(~task.item);
      for (auto k = blocking.part_start[part]; k < blocking.part_start[part + 1]; ++k)
        ASSERT_EQ(tiles[static_cast<std::size_t>(blocking.part_tile[static_cast<std::size_t>(k)])],
                  task.cycle - 1);
      ASSERT_EQ(++parts[part], task.cycle);
    } else {
      const auto tile = static_cast<std::size_t>(task.item);
      for (auto k = blocking.tile_start[tile]; k < blocking.tile_start[tile + 1]; ++k)
        ASSERT_EQ(parts[static_cast<std::size_t>(blocking.tile_part[static_cast<std::size_t>(k)])],
                  task.cycle);
      ASSERT_EQ(++tiles[tile], task.cycle);
    }
  }
  EXPECT_TRUE(std::all_of(tiles.begin(), tiles.end(), [](auto done) { return done == 6; }));
  EXPECT_TRUE(std::all_of(parts.begin(), parts.end(), [](auto done) { return done == 6; }));
}

// A worker that lost its core, here one that stands in its first item until another has done one of its region, holds up nobody for good.
TEST(TemporalBlocking, AWorkerIsHelpedWhileItStands) {
  Options o = dry_options(100);
  TestModel m(o, hexagonal(104, 102));
  const TilePlan plan = plan_tiles(m.assembly, m.network, false, false);
  const TemporalBlocking blocking = plan_blocking(plan, m.assembly, m.network, {3, 2, 3}, 2);
  std::vector<std::int32_t> region_of(plan.tiles.size());
  for (const auto& task : blocking.tasks)
    if (task.item >= 0) region_of[static_cast<std::size_t>(task.item)] = task.region;
  ASSERT_TRUE(std::count(region_of.begin(), region_of.end(), 1) > 4);
  BlockedBatch batch;
  batch.use(blocking);
  Workers team(2);
  for (const int stands : {0, 1}) {
    std::atomic<int> helped{0}, wrong{0};
    std::vector<std::atomic<std::int32_t>> done(2 * plan.tiles.size());
    batch.begin(7);
    const std::function<void(int)> task = [&](int worker) {
      batch.work(team, worker, [&](std::int32_t item, std::int32_t cycle) {
        const auto at = static_cast<std::size_t>(item >= 0 ? item : ~item);
        if (region_of[at] != worker) ++helped;
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (worker == stands && helped == 0 && std::chrono::steady_clock::now() < limit) {
        }
        if (done[item >= 0 ? at : at + plan.tiles.size()].exchange(cycle) != cycle - 1) ++wrong;
      });
    };
    team.run(task, false);  // both workers both times, however long one stood
    EXPECT_GT(helped, 0);
    EXPECT_EQ(wrong, 0) << "done twice, or in another order";
    EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const auto& cycle) { return cycle == 7; }));
  }
}

// Who could know of distant discs in every cycle keeps a model from temporal blocking: servo walls, here, move as without.
TEST(TemporalBlocking, LeavesMovingWallsToSingleCycles) {
  const auto squeezed = [](const BlockingShape& shape) {
    static const Discs discs = packed(dry_options(1500));
    Options o = dry_options(1500);
    o.boundary_kind = choice(BoundaryKind::walls);
    o.stress_sigma_Hmax = o.stress_sigma_hmin = 1e7;
    TestModel m(o, discs);
    m.solver->set_blocking(shape);
    m.boundary->set_load(m.assembly, 1.0);
    CrackLog log;
    m.solver->run(40, log);
    EXPECT_GT(m.boundary->walls()[0].displacement, 0.0);
    return fingerprint(m, log).state;
  };
  EXPECT_EQ(squeezed({4, 2, 1}), squeezed({1, 1, 1}));
}

}  // namespace temporal_blocking_test
