// SPDX-License-Identifier: BSD-3-Clause
// A host's grid: what its cells read, what they put in, and that the balance stays right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "sim_support.hpp"

namespace grid_test {

using namespace testing_capi;

hfrac_grid regular(int64_t nx, int64_t ny, double x, double y, double dx, double dy, double angle = 0.0) {
  hfrac_grid grid{};
  grid.struct_size = sizeof grid;
  grid.nx = nx;
  grid.ny = ny;
  grid.origin[0] = x;
  grid.origin[1] = y;
  grid.dx = dx;
  grid.dy = dy;
  grid.angle = angle;
  return grid;
}

std::vector<hfrac_cell> cells_of(hfrac_sim* sim, int32_t method = HFRAC_UPSCALE_ODA) {
  int64_t count = 0;
  EXPECT_EQ(hfrac_grid_cells(sim, method, sizeof(hfrac_cell), nullptr, 0, &count), HFRAC_OK)
      << last_error(sim);
  std::vector<hfrac_cell> cells(static_cast<std::size_t>(count));
  EXPECT_EQ(hfrac_grid_cells(sim, method, sizeof(hfrac_cell), cells.data(), count, &count), HFRAC_OK);
  return cells;
}

// The same cells as corners, every second one the other way round.
std::vector<double> corners_of(const hfrac_grid& g) {
  std::vector<double> corners;
  for (int64_t j = 0; j < g.ny; ++j) {
    for (int64_t i = 0; i < g.nx; ++i) {
      const double x = g.origin[0] + g.dx * static_cast<double>(i),
                   y = g.origin[1] + g.dy * static_cast<double>(j);
      std::vector<double> cell = {x, y, x + g.dx, y, x + g.dx, y + g.dy, x, y + g.dy};
      if ((i + j) % 2 == 1) {
        std::swap(cell[2], cell[6]);
        std::swap(cell[3], cell[7]);
      }
      corners.insert(corners.end(), cell.begin(), cell.end());
    }
  }
  return corners;
}

double sum_of(const std::vector<hfrac_cell>& cells, double hfrac_cell::*member) {
  double sum = 0.0;
  for (const auto& cell : cells) sum += cell.*member;
  return sum;
}

TEST(Grid, CellsShareOutTheCracks) {
  Sim sim(cracking_def());
  ASSERT_GE(hfrac_step(sim, 3), 0);
  const auto fractures = fractures_of(sim);
  double volume = 0.0, length = 0.0;
  for (const auto& f : fractures) volume += f.volume;
  for (const auto& c : cracks_of(sim)) length += c.length;
  ASSERT_GT(volume, 0.0);
  const auto check = [&](const hfrac_grid& grid) {
    ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK) << last_error(sim);
    const auto cells = cells_of(sim);
    double found = 0.0;
    for (const auto& cell : cells) found += cell.fracture_porosity * cell.area;
    EXPECT_NEAR(found, volume, 1e-9 * volume);
    EXPECT_NEAR(sum_of(cells, &hfrac_cell::crack_length), length, 1e-9 * length);
    double covered = 0.0;
    for (const auto& cell : cells) covered += cell.coverage * cell.area;
    EXPECT_GT(covered, 0.85 * 100.0 * 100.0);
    EXPECT_LT(covered, 100.0 * 100.0);
  };
  check(regular(7, 5, -10.0, -10.0, 18.0, 25.0));
  check(regular(1, 1, -500.0, -500.0, 1100.0, 1100.0));
  check(regular(12, 12, 50.0, -30.0, 10.0, 10.0, 0.785398163397448));
  auto by_corners = regular(6, 4, 0.0, 0.0, 17.0, 26.0);
  const auto corners = corners_of(by_corners);
  check(by_corners);
  const auto wanted = cells_of(sim);
  by_corners.corners = corners.data();
  check(by_corners);
  const auto found = cells_of(sim);
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    EXPECT_NEAR(found[c].permeability[2], wanted[c].permeability[2],
                1e-9 * (1e-30 + wanted[c].permeability[0]));
    EXPECT_EQ(found[c].crack_count, wanted[c].crack_count);
  }
}

TEST(Grid, FlowNeverExceedsTheUniformGradient) {
  Sim sim(cracking_def());
  ASSERT_GE(hfrac_step(sim, 3), 0);
  const auto grid = regular(2, 2, 0.0, 0.0, 50.0, 50.0);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  const auto oda = cells_of(sim, HFRAC_UPSCALE_ODA), flow = cells_of(sim, HFRAC_UPSCALE_FLOW);
  double most = 0.0;
  for (std::size_t c = 0; c < oda.size(); ++c) {
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GE(flow[c].permeability[k], -1e-9 * flow[c].matrix_permeability);
      EXPECT_LE(flow[c].permeability[k], oda[c].permeability[k] + flow[c].matrix_permeability);
      most = std::max(most, flow[c].permeability[k] / flow[c].matrix_permeability);
    }
  }
  EXPECT_GT(most, 0.1) << "the case must have cracks worth the name";
}

TEST(Grid, OutflowIsWhatLeaks) {
  hfrac::Definition def = quiet_def();
  def.flow_permeability = 1e-12;
  def.wells[0].pressure = 35e6;
  Sim sim(def);
  const auto grid = regular(5, 5, -10.0, 5.0, 30.0, 20.0, 0.2);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  for (int k = 0; k < 3; ++k) {
    const double before = balance_of(sim).leaked_volume;
    ASSERT_GE(hfrac_step(sim, 1), 0);
    const double leaked = balance_of(sim).leaked_volume - before;
    const auto cells = cells_of(sim);
    EXPECT_NEAR(sum_of(cells, &hfrac_cell::outflow) * def.stepping_flow_step, leaked,
                1e-9 * std::abs(leaked));
    for (const auto& cell : cells) EXPECT_TRUE(cell.outflow == 0.0 || cell.coverage < 0.5) << cell.coverage;
  }
  EXPECT_NE(balance_of(sim).leaked_volume, 0.0);
}

// What a Newton step of a coupled host needs: how `outflow` answers to the pressure beyond the edge.
TEST(Grid, ConductanceIsTheDerivativeOfTheOutflow) {
  hfrac::Definition def = quiet_def();
  def.flow_permeability = 1e-15;
  def.stepping_flow_step = 1e-9;  // too short for the pores to follow
  Sim low(def), high(def);
  const auto grid = regular(2, 1, -50.0, -50.0, 100.0, 200.0);
  const double p0 = def.fluid_formation_pressure, rise = 1e5;
  for (hfrac_sim* sim : {static_cast<hfrac_sim*>(low), static_cast<hfrac_sim*>(high)}) {
    ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
    ASSERT_GE(hfrac_step(sim, 1), 0);
  }
  const double conductance = cells_of(low)[0].conductance;  // at the apertures of the next step
  ASSERT_GT(conductance, 0.0);
  const double pressure[2] = {p0 + rise, p0};
  ASSERT_EQ(hfrac_set_boundary_pressure(high, pressure, 2), HFRAC_OK) << last_error(high);
  ASSERT_GE(hfrac_step(low, 1), 0);
  ASSERT_GE(hfrac_step(high, 1), 0);
  const auto before = cells_of(low), after = cells_of(high);
  EXPECT_NEAR((before[0].outflow - after[0].outflow) / rise / conductance, 1.0, 1e-6);
  EXPECT_EQ(before[1].outflow, after[1].outflow);
}

TEST(Grid, BoundaryPressureDrivesFlow) {
  for (const int32_t scheme : {0, 1}) {
    hfrac::Definition def = quiet_def();
    def.flow_scheme = scheme;
    def.flow_permeability = 1e-12;
    def.stepping_flow_step = scheme == 0 ? 100.0 : 0.1;
    def.wells[0].rate = 0.0;
    def.wells[0].control = HFRAC_WELL_RATE;
    Sim sim(def), plain(def);
    const auto grid = regular(2, 1, -50.0, -50.0, 100.0, 200.0);
    ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
    const double p0 = def.fluid_formation_pressure;
    double pressure[2] = {p0, p0};
    ASSERT_EQ(hfrac_set_boundary_pressure(sim, pressure, 2), HFRAC_OK) << last_error(sim);
    ASSERT_GE(hfrac_step(sim, 1), 0);
    ASSERT_GE(hfrac_step(plain, 1), 0);
    for (const int32_t field : {HFRAC_DISC_POSITION, HFRAC_DOMAIN_PRESSURE, HFRAC_PIPE_FLOW})
      EXPECT_EQ(doubles(sim, field), doubles(plain, field))
          << "the formation's pressure outside changes nothing";
    pressure[0] += 1e6;
    ASSERT_EQ(hfrac_set_boundary_pressure(sim, pressure, 2), HFRAC_OK);
    ASSERT_GE(hfrac_step(sim, 20), 0);
    const auto cells = cells_of(sim);
    EXPECT_LT(cells[0].outflow, 0.0) << "fluid enters from the cell of higher pressure";
    EXPECT_GT(cells[0].pressure, cells[1].pressure);
    const auto balance = balance_of(sim);
    EXPECT_NE(balance.leaked_volume, 0.0);
    EXPECT_LT(std::abs(balance.fluid_error), 1e-9 * std::abs(balance.stored_volume));
  }
}

// Two ways to say the same: what a host's grid says of the outer boundary is absolute, whatever the formation's pressure is.
TEST(Grid, ABoundaryPressureStaysUntilTheHostTakesItBack) {
  hfrac::Definition def = quiet_def();
  def.flow_permeability = 1e-12;
  def.stepping_flow_step = 100.0;
  const double p0 = def.fluid_formation_pressure, rim[2] = {p0 + 1e6, p0};
  const auto grid = regular(2, 1, -50.0, -50.0, 100.0, 200.0);
  Sim before(def), after(def), never(def);
  for (const Sim* sim : {&before, &after, &never}) ASSERT_EQ(hfrac_set_grid(*sim, &grid), HFRAC_OK);
  ASSERT_EQ(hfrac_set_boundary_pressure(before, rim, 2), HFRAC_OK);
  ASSERT_EQ(hfrac_set_formation_pressure(before, p0 + 2e6), HFRAC_OK) << last_error(before);
  ASSERT_EQ(hfrac_set_formation_pressure(after, p0 + 2e6), HFRAC_OK);
  ASSERT_EQ(hfrac_set_boundary_pressure(after, rim, 2), HFRAC_OK);
  ASSERT_EQ(hfrac_set_formation_pressure(never, p0 + 2e6), HFRAC_OK);
  for (const Sim* sim : {&before, &after, &never}) ASSERT_GE(hfrac_step(*sim, 3), 0);
  EXPECT_EQ(hash_of(before), hash_of(after));
  EXPECT_NE(hash_of(before), hash_of(never));
  const auto pressure = cells_of(before);
  EXPECT_GT(pressure[0].pressure, pressure[1].pressure) << "the host's difference still drives flow";
  // It is part of the state.
  std::vector<unsigned char> image(1U << 22U);
  int64_t size = 0;
  ASSERT_EQ(hfrac_state_save(before, image.data(), static_cast<int64_t>(image.size()), &size), HFRAC_OK);
  ASSERT_EQ(hfrac_state_restore(never, image.data(), size), HFRAC_OK) << last_error(never);
  for (const Sim* sim : {&before, &never}) ASSERT_EQ(hfrac_set_formation_pressure(*sim, p0), HFRAC_OK);
  for (const Sim* sim : {&before, &never}) ASSERT_GE(hfrac_step(*sim, 2), 0);
  EXPECT_EQ(hash_of(before), hash_of(never));
  // Kept by the tries of an open step, the formation's pressure set in between too.
  ASSERT_EQ(hfrac_step_prepare(before), HFRAC_OK);
  ASSERT_EQ(hfrac_set_formation_pressure(before, p0 + 1e6), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(before, 100.0), 0);
  ASSERT_GE(hfrac_step_do(before, 100.0), 0);
  ASSERT_EQ(hfrac_step_finalize(before), HFRAC_OK);
  ASSERT_EQ(hfrac_set_formation_pressure(never, p0 + 1e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(never, 1), 0);
  EXPECT_EQ(doubles(before, HFRAC_DOMAIN_PRESSURE), doubles(never, HFRAC_DOMAIN_PRESSURE));
  // Taken back: the formation's again, now and from then on.
  ASSERT_EQ(hfrac_set_boundary_pressure(before, nullptr, 0), HFRAC_OK) << last_error(before);
  for (const Sim* sim : {&before, &never}) ASSERT_EQ(hfrac_set_formation_pressure(*sim, p0), HFRAC_OK);
  const double uniform[2] = {p0, p0};
  ASSERT_EQ(hfrac_set_boundary_pressure(never, uniform, 2), HFRAC_OK);
  for (const Sim* sim : {&before, &never}) ASSERT_GE(hfrac_step(*sim, 1), 0);
  EXPECT_EQ(doubles(before, HFRAC_DOMAIN_PRESSURE), doubles(never, HFRAC_DOMAIN_PRESSURE));
}

TEST(Grid, CellPressureIsBookedAsTheHosts) {
  hfrac::Definition def = quiet_def();
  def.flow_outer = 1;  // closed
  def.wells[0].rate = 0.0;
  def.wells[0].control = HFRAC_WELL_RATE;
  Sim sim(def);
  const auto grid = regular(4, 4, 0.0, 0.0, 25.0, 25.0);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  std::vector<double> pressure(16), added(16);
  for (std::size_t c = 0; c < 16; ++c)
    pressure[c] = def.fluid_formation_pressure + 1e5 * static_cast<double>(c % 4);
  ASSERT_EQ(hfrac_set_cell_pressure(sim, pressure.data(), 16, added.data(), 16), HFRAC_OK) << last_error(sim);
  double sum = 0.0;
  for (const double a : added) sum += a;
  auto balance = balance_of(sim);
  EXPECT_GT(balance.host_volume, 0.0);
  EXPECT_NEAR(sum, balance.host_volume, 1e-12 * balance.host_volume);
  EXPECT_LT(std::abs(balance.fluid_error), 1e-12);
  const auto cells = cells_of(sim);
  for (std::size_t c = 0; c < 16; ++c) {
    // A pore on the line between two cells takes the mean of both, so a cell's mean may be off by a part of the step.
    EXPECT_NEAR(cells[c].pressure, pressure[c], 2.5e4) << c;
  }
  ASSERT_GE(hfrac_step(sim, 3), 0);
  balance = balance_of(sim);
  EXPECT_LT(std::abs(balance.fluid_error), 1e-9 * balance.host_volume);
  for (auto& p : pressure) p = def.fluid_formation_pressure;
  ASSERT_EQ(hfrac_set_cell_pressure(sim, pressure.data(), 16, nullptr, 0), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  EXPECT_LT(std::abs(balance_of(sim).fluid_error), 1e-12);

  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  EXPECT_EQ(hfrac_set_cell_pressure(sim, pressure.data(), 16, nullptr, 0), HFRAC_ERR_ARGUMENT);
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
}

TEST(Grid, UniformStressIsTheFarFields) {
  hfrac::Definition def = quiet_def();
  Sim by_cells(def), by_far_field(def);
  const auto grid = regular(3, 2, 0.0, 0.0, 34.0, 50.0);
  ASSERT_EQ(hfrac_set_grid(by_cells, &grid), HFRAC_OK);
  std::vector<double> stress;
  for (int c = 0; c < 6; ++c) stress.insert(stress.end(), {6e6, 2e6, 0.0});
  ASSERT_EQ(hfrac_set_cell_stress(by_cells, stress.data(), 18), HFRAC_OK) << last_error(by_cells);
  ASSERT_EQ(hfrac_set_far_field(by_far_field, 36e6, 32e6), HFRAC_OK);
  ASSERT_GE(hfrac_step(by_cells, 1), 0);
  ASSERT_GE(hfrac_step(by_far_field, 1), 0);
  const auto a = doubles(by_cells, HFRAC_DISC_STRESS), b = doubles(by_far_field, HFRAC_DISC_STRESS);
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 3e3) << k;
  const auto balance = balance_of(by_cells);
  EXPECT_LT(std::abs(balance.energy_error), 1e-2 * balance.boundary_work);

  // Zeros take it away; shear alone has no net moment left and comes to rest.
  std::fill(stress.begin(), stress.end(), 0.0);
  ASSERT_EQ(hfrac_set_cell_stress(by_cells, stress.data(), 18), HFRAC_OK);
  for (std::size_t c = 0; c < 6; ++c) stress[3 * c + 2] = 2e6;
  ASSERT_EQ(hfrac_set_cell_stress(by_cells, stress.data(), 18), HFRAC_OK);
  ASSERT_EQ(hfrac_step(by_cells, 1), HFRAC_OK) << "at rest";
  double shear = 0.0, count = 0.0;
  const auto s = doubles(by_cells, HFRAC_DISC_STRESS);
  for (std::size_t k = 2; k < s.size(); k += 3) {
    shear += s[k];
    count += 1.0;
  }
  EXPECT_NEAR(shear / count, 2e6, 0.15 * 2e6);
}

// Stress that grows along y, as on the side of a depleted zone: xx linear in y is in equilibrium (div = 0), so the rock
// inside must carry it row by row.
TEST(Grid, StressThatChangesFromCellToCellArrivesInside) {
  hfrac::Definition def = quiet_def(1500);
  def.packing_residual = 1e-4;
  def.contact_mode = 1;  // linear rock
  def.flow_scheme = 2;   // dry
  Sim sim(def);
  const auto grid = regular(1, 20, 0.0, 0.0, 100.0, 5.0);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  const auto before = doubles(sim, HFRAC_DISC_STRESS);
  std::vector<double> stress;
  for (int j = 0; j < 20; ++j) stress.insert(stress.end(), {1e6 * (j - 9.5) / 10.0, 0.0, 0.0});
  ASSERT_EQ(hfrac_set_cell_stress(sim, stress.data(), 60), HFRAC_OK) << last_error(sim);
  ASSERT_EQ(hfrac_step(sim, 1), HFRAC_OK);
  const auto after = doubles(sim, HFRAC_DISC_STRESS), place = doubles(sim, HFRAC_DISC_POSITION);
  // Slope of the change of xx against y over the inside, weighted alike.
  double n = 0.0, y = 0.0, s = 0.0, yy = 0.0, ys = 0.0;
  for (std::size_t i = 0; 2 * i < place.size(); ++i) {
    if (std::abs(place[2 * i] - 50.0) > 35.0 || std::abs(place[2 * i + 1] - 50.0) > 35.0) continue;
    if (std::hypot(place[2 * i] - 50.0, place[2 * i + 1] - 50.0) < 25.0) continue;  // the hole's own field
    const double change = after[3 * i] - before[3 * i];
    n += 1.0;
    y += place[2 * i + 1];
    s += change;
    yy += place[2 * i + 1] * place[2 * i + 1];
    ys += place[2 * i + 1] * change;
  }
  const double slope = (ys - y * s / n) / (yy - y * y / n);
  std::printf("  slope %.4g Pa/m, given 2e4\n", slope);
  EXPECT_NEAR(slope, 2e4, 0.1 * 2e4);
}

TEST(Grid, EverySolverTakesTheHostsValues) {
  struct Kind {
    int32_t solver, mode;
  };
  double mean[3] = {};
  int k = 0;
  for (const Kind kind : {Kind{0, 0}, Kind{1, 0}, Kind{1, 2}}) {  // explicit, quasi-static, coupled
    hfrac::Definition def = quiet_def();
    def.solver_kind = kind.solver;
    def.stepping_mode = kind.mode;
    Sim sim(def);
    const auto grid = regular(2, 1, -50.0, -50.0, 100.0, 200.0);
    ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
    const double stress[6] = {6e6, 2e6, 0.0, 6e6, 2e6, 0.0}, p0 = def.fluid_formation_pressure;
    const double rim[2] = {p0 + 1e6, p0};
    ASSERT_EQ(hfrac_set_cell_stress(sim, stress, 6), HFRAC_OK) << last_error(sim);
    ASSERT_EQ(hfrac_set_boundary_pressure(sim, rim, 2), HFRAC_OK) << last_error(sim);
    ASSERT_EQ(hfrac_step(sim, 2), HFRAC_OK) << last_error(sim);
    const auto balance = balance_of(sim);
    EXPECT_NE(balance.leaked_volume, 0.0);
    EXPECT_LT(std::abs(balance.fluid_error), 1e-6 * std::abs(balance.leaked_volume));
    const auto all = doubles(sim, HFRAC_DISC_STRESS);
    for (std::size_t i = 0; i < all.size(); i += 3) mean[k] += 3.0 * all[i] / static_cast<double>(all.size());
    ++k;
  }
  // xx, effective: 5 MPa of the far field, which alone cannot give more, and 6 of the host's.
  EXPECT_GT(mean[0], 6e6);
  EXPECT_NEAR(mean[1], mean[0], 1e-3 * mean[0]);
  EXPECT_NEAR(mean[2], mean[0], 1e-3 * mean[0]);
}

TEST(Grid, RejectedStepsTakeTheHostsValuesBack) {
  hfrac::Definition def = quiet_def();
  def.flow_permeability = 1e-13;
  Sim sim(def);
  const auto grid = regular(2, 2, 0.0, 0.0, 50.0, 50.0);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  ASSERT_GE(hfrac_step(sim, 1), 0);
  const auto before = hash_of(sim);
  const double p0 = def.fluid_formation_pressure;
  const double pressure[4] = {p0 + 1e6, p0, p0 + 2e6, p0};
  const double stress[12] = {1e6, 0, 0, 2e6, 0, 0, 1e6, 0, 0, 2e6, 0, 0};
  ASSERT_EQ(hfrac_step_prepare(sim), HFRAC_OK);
  ASSERT_EQ(hfrac_set_boundary_pressure(sim, pressure, 4), HFRAC_OK);
  ASSERT_EQ(hfrac_set_cell_stress(sim, stress, 12), HFRAC_OK);
  ASSERT_EQ(hfrac_set_far_field(sim, 33e6, 29e6), HFRAC_OK);
  ASSERT_GE(hfrac_step_do(sim, 1.0), 0);
  const auto once = hash_of(sim);
  ASSERT_GE(hfrac_step_do(sim, 7.0), 0);
  ASSERT_GE(hfrac_step_do(sim, 1.0), 0);
  EXPECT_EQ(hash_of(sim), once) << "what the host set stays for the next try";
  ASSERT_EQ(hfrac_step_reject(sim), HFRAC_OK);
  EXPECT_EQ(hash_of(sim), before);
}

TEST(Grid, MisuseIsRefused) {
  Sim sim(quiet_def());
  int64_t count = 0;
  double values[4] = {30e6, 30e6, 30e6, 30e6};
  EXPECT_EQ(hfrac_grid_cells(sim, 0, sizeof(hfrac_cell), nullptr, 0, &count), HFRAC_ERR_ARGUMENT);
  EXPECT_NE(last_error(sim).find("hfrac_set_grid"), std::string::npos);
  EXPECT_EQ(hfrac_set_boundary_pressure(sim, values, 4), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_cell_pressure(sim, values, 4, nullptr, 0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_cell_stress(sim, values, 4), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_write_grdecl(sim, "/tmp/nowhere.grdecl", 0, 0, 1, 0.0, 0.0), HFRAC_ERR_ARGUMENT);

  EXPECT_EQ(hfrac_set_grid(sim, nullptr), HFRAC_ERR_ARGUMENT);
  auto grid = regular(2, 2, 0.0, 0.0, 50.0, 50.0);
  grid.struct_size = 3;
  EXPECT_EQ(hfrac_set_grid(sim, &grid), HFRAC_ERR_STRUCT_SIZE);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& bad :
       {regular(0, 2, 0, 0, 1, 1), regular(-1, 2, 0, 0, 1, 1), regular(1LL << 40, 1LL << 40, 0, 0, 1, 1),
        regular(2, 2, 0, 0, 0, 1), regular(2, 2, 0, 0, 1, -1), regular(2, 2, nan, 0, 1, 1),
        regular(2, 2, 0, 0, 1, 1, nan)}) {
    EXPECT_EQ(hfrac_set_grid(sim, &bad), HFRAC_ERR_ARGUMENT);
  }
  grid = regular(1, 1, 0.0, 0.0, 1.0, 1.0);
  for (const auto& bad : {std::vector<double>{0, 0, 1, 1, 1, 0, 0, 1},       // crossed
                          std::vector<double>{0, 0, 1, 0, 2, 0, 0, 1},       // three on a line
                          std::vector<double>{0, 0, 4, 0, 1, 1, 0, 4},       // not convex
                          std::vector<double>{0, 0, nan, 0, 1, 1, 0, 1}}) {  // not a number
    grid.corners = bad.data();
    EXPECT_EQ(hfrac_set_grid(sim, &grid), HFRAC_ERR_ARGUMENT);
  }

  grid = regular(2, 2, 0.0, 0.0, 50.0, 50.0);
  ASSERT_EQ(hfrac_set_grid(sim, &grid), HFRAC_OK);
  const auto before = hash_of(sim);
  EXPECT_EQ(hfrac_grid_cells(sim, 2, sizeof(hfrac_cell), nullptr, 0, &count), HFRAC_ERR_ARGUMENT);
  std::vector<hfrac_cell> cells(4);
  EXPECT_EQ(hfrac_grid_cells(sim, 0, -5, cells.data(), 4, &count), HFRAC_ERR_STRUCT_SIZE);
  EXPECT_EQ(hfrac_grid_cells(sim, 0, sizeof(hfrac_cell), cells.data(), 4, nullptr), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_boundary_pressure(sim, values, 3), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_boundary_pressure(sim, nullptr, 4), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_boundary_pressure(sim, values, -4), HFRAC_ERR_ARGUMENT);
  values[2] = nan;
  EXPECT_EQ(hfrac_set_boundary_pressure(sim, values, 4), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_cell_pressure(sim, values, 4, nullptr, 0), HFRAC_ERR_ARGUMENT);
  values[2] = -1.0;
  EXPECT_EQ(hfrac_set_cell_pressure(sim, values, 4, nullptr, 0), HFRAC_ERR_ARGUMENT);
  values[2] = 30e6;
  double added[4];
  EXPECT_EQ(hfrac_set_cell_pressure(sim, values, 4, added, 3), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_cell_stress(sim, values, 4), HFRAC_ERR_ARGUMENT) << "three values a cell";
  EXPECT_EQ(hfrac_write_grdecl(sim, "/nonexistent/folder/x.grdecl", 0, 0, 1, 0.0, 0.0), HFRAC_ERR_FILE);
  EXPECT_EQ(hfrac_write_grdecl(sim, nullptr, 0, 0, 1, 0.0, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_write_grdecl(sim, "/tmp/x", 0, 2, 1, 0.0, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_write_grdecl(sim, "/tmp/x", 0, 0, 0, 0.0, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_write_grdecl(sim, "/tmp/x", 0, 0, 1, 1.5, 0.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_write_grdecl(sim, "/tmp/x", 0, 0, 1, 0.0, -1.0), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hash_of(sim), before) << "nothing refused has left a trace";

  hfrac::Definition walled_def = quiet_def();
  walled_def.boundary_kind = 1;
  walled_def.flow_outer = 1;
  Sim walled(walled_def);
  ASSERT_EQ(hfrac_set_grid(walled, &grid), HFRAC_OK);
  const double stress[12] = {};
  EXPECT_EQ(hfrac_set_cell_stress(walled, stress, 12), HFRAC_ERR_ARGUMENT);
  EXPECT_EQ(hfrac_set_boundary_pressure(walled, values, 4), HFRAC_ERR_ARGUMENT);
}

}  // namespace grid_test
