// SPDX-License-Identifier: BSD-3-Clause
// V34  Wells: friction of perforations and of the way behind them, storage, head, clusters, and how they are driven.
//
// Formula    Perforations are orifices, 8 rho Q^2 / (pi^2 n^2 D^4 C_d^2) (Crump and Conway 1988; Economides and Nolte 2000, ch. 6); the way from them
//            into the fracture takes k sqrt(Q); a wellbore of storage S rises by dp = dV / (S + C), C what the hole stores; it empties into rock
//            that flows steadily (conductance G) as exp(-G t / S), and through perforations (drop a q^2) into a hole at p_i as
//            sqrt(p - p_i) = sqrt(p_0 - p_i) - t / (2 S sqrt(a)); clusters of one wellbore share its pressure; its wellhead is rho g z lower.
// Set-up     A small packing that does not break, through hfrac.h alone, mode coupled with the quasi-static solver. Friction and clusters: rock that
//            lets fluid in, rates at which drops are MPa. Stages: two wellbores in rock that lets nothing in, 60 m apart, driven by schedules.
//            C is measured by a run without storage: it is no part of what is tested, and at most 5 % of S.
// Tolerance  1 %.
// Page       docs/verification/V34.md
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support.hpp"

namespace V34_wells {

using namespace verification;
using verification::Simulation;

constexpr double tolerance = 0.01;
constexpr double formation = 25e6, density = 1000.0, gravity = 9.80665;  // Pa, kg/m3, m/s2
constexpr double height = 20.0, diameter = 0.01, discharge = 0.8;        // m, m, 1

hfrac::Definition rock(double permeability, const std::vector<double>& places) {
  hfrac::Definition def = new_def();
  def.packing_disc_count = 600;
  def.stress_convention = 0;
  def.stress_sigma_Hmax = def.stress_sigma_hmin = 30e6;
  def.fluid_formation_pressure = formation;
  def.bond_tensile_strength = def.bond_shear_strength = 1e12;
  def.flow_permeability = permeability;
  def.stepping_mode = 2;
  def.solver_kind = 1;
  def.stepping_flow_step = 1.0;
  hfrac_sim_def_set_i64(&def, "well_count", static_cast<int64_t>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    def.wells[k].x = places[k];
    def.wells[k].y = 50.0;
    def.wells[k].radius = 8.0;
    def.wells[k].control = HFRAC_WELL_RATE;
  }
  return def;
}

void perforate(hfrac_well_def& well, double count) {
  well.height = height;
  well.perforation_count = count;
  well.perforation_diameter = diameter;
  well.discharge_coefficient = discharge;
}

// By hand, of a rate per thickness q [m2/s].
double orifices(double q, double count) {
  const double flow = q * height;
  return 8.0 * density * flow * flow /
         (pi * pi * count * count * std::pow(diameter, 4) * discharge * discharge);
}

struct Turn {
  int64_t well;
  double time, rate;  // s, m2/s
};
void schedule(hfrac::Definition& def, const std::vector<Turn>& turns) {
  hfrac_sim_def_set_i64(&def, "schedule_count", static_cast<int64_t>(turns.size()));
  for (std::size_t k = 0; k < turns.size(); ++k) {
    def.schedule[k].well = turns[k].well;
    def.schedule[k].time = turns[k].time;
    def.schedule[k].value = turns[k].rate;
    def.schedule[k].control = HFRAC_WELL_RATE;
  }
}

// Until then, in the steps that the schedule asks for.
void go_on(Simulation& sim, double time) {
  while (sim.state().time < time - 1e-6) sim.step(1);
}

double drop(const Simulation& sim, int32_t well = 0) {
  const auto state = sim.well(well);
  return state.wellbore_pressure - state.pressure;
}

// A step-rate test up and down: drops at four rates of one schedule, and what the wellhead shows.
TEST(V34WellsSmoke, FrictionAtStepsOfRateAndHead) {
  constexpr double rough = 4e6, depth = 2000.0;  // Pa/(m3/s)^0.5, m
  const std::array<double, 4> rates{1e-3, 2e-3, 3e-3, 1.5e-3};
  for (const auto& [name, count, near_well] :
       {std::tuple{"perforations", 6.0, 0.0}, std::tuple{"near well", 0.0, rough},
        std::tuple{"both", 6.0, rough}}) {
    hfrac::Definition def = rock(1e-13, {50.0});
    auto& well = def.wells[0];
    perforate(well, count);
    well.near_well_friction = near_well;
    well.depth = depth;
    well.rate = rates[0];
    schedule(def, {{0, 3.0, rates[1]}, {0, 6.0, rates[2]}, {0, 9.0, rates[3]}});
    Simulation sim(def);
    for (std::size_t k = 0; k < rates.size(); ++k) {
      go_on(sim, 3.0 * static_cast<double>(k + 1));
      const double by_hand =
          (count > 0.0 ? orifices(rates[k], count) : 0.0) + near_well * std::sqrt(rates[k] * height);
      report(std::string(name) + ", Pa at " + std::to_string(1e3 * rates[k]).substr(0, 3) + "e-3 m2/s",
             drop(sim), by_hand, tolerance);
    }
    const auto state = sim.well(0);
    report(std::string(name) + ", head, Pa", state.wellbore_pressure - state.wellhead_pressure,
           density * gravity * depth, tolerance);
  }
}

// m2/Pa that a hole stores by itself, in rock that lets nothing in.
double own_storage(const std::vector<double>& places, int32_t well) {
  hfrac::Definition def = rock(1e-22, places);
  def.wells[well].rate = 1e-3;
  Simulation sim(def);
  sim.step(1);
  return 1e-3 / (sim.well(well).pressure - formation);
}

// Stepped, cyclic, shut in, flowing back: pressure follows the volume that is in.
TEST(V34WellsSmoke, StorageUnderCyclesShutInAndFlowBack) {
  const double own = own_storage({50.0}, 0), storage = 20.0 * own;
  hfrac::Definition def = rock(1e-22, {50.0});
  def.wells[0].storage = storage;
  const std::vector<std::pair<double, double>> parts{{4.0, 1e-3}, {3.0, 0.0},   {4.0, 1e-3},
                                                     {3.0, 0.0},  {5.0, -1e-3}, {2.0, 3e-3}};
  std::vector<Turn> turns;
  double time = 0.0;
  for (const auto& [length, rate] : parts) {
    if (time == 0.0)
      def.wells[0].rate = rate;
    else
      turns.push_back({0, time, rate});
    time += length;
  }
  schedule(def, turns);
  Simulation sim(def);
  double volume = 0.0;
  time = 0.0;
  for (const auto& [length, rate] : parts) {
    time += length;
    volume += length * rate;
    go_on(sim, time);
    report("rise, Pa, after " + std::to_string(static_cast<int>(time)) + " s",
           sim.well(0).pressure - formation, volume / (storage + own), tolerance);
  }
  hfrac_balance balance{};
  balance.struct_size = sizeof balance;
  sim.balance(&balance);
  report("injected, m2", balance.injected_volume, volume, 1e-9);
}

// Shut in at a pressure, into a hole that hardly answers.
TEST(V34WellsSmoke, AWellboreEmptiesThroughPerforations) {
  hfrac::Definition def = rock(1e-8, {50.0});
  auto& well = def.wells[0];
  constexpr double storage = 1e-8;
  perforate(well, 1.0);
  well.storage = storage;
  well.control = HFRAC_WELL_PRESSURE;
  well.pressure = formation + 4e6;
  def.stepping_flow_step = 0.1;
  Simulation sim(def);
  sim.step(10);
  EXPECT_LT(sim.well(0).pressure - formation, 2e-3 * drop(sim));  // or the hole would answer
  const double resistance = orifices(1.0, 1.0), from = std::sqrt(drop(sim)),
               whole = 2.0 * storage * std::sqrt(resistance) * from;  // s until it is empty
  sim.set_rate(0, 0.0);
  for (int part = 1; part <= 3; ++part) {
    for (int k = 0; k < 200; ++k) sim.step_for(whole / 800.0);
    const double left = from * (1.0 - 0.25 * part);
    report("drop left, Pa, after " + std::to_string(part) + "/4 of the time", drop(sim), left * left,
           tolerance);
  }
}

TEST(V34WellsSmoke, AWellboreEmptiesIntoRock) {
  hfrac::Definition def = rock(1e-11, {50.0});
  constexpr double storage = 1e-3;  // m2/Pa, far above what the rock stores as it gives
  constexpr double excess = 2e4;    // Pa, too little to change the rock's apertures
  def.fluid_bulk_modulus = 1e11;
  def.stepping_flow_step = 2000.0;  // 20 of them to come to a steady flow
  def.wells[0].storage = storage;
  def.wells[0].control = HFRAC_WELL_PRESSURE;
  def.wells[0].pressure = formation + excess;
  Simulation sim(def);
  sim.step(20);
  const double time = storage * excess / sim.well(0).rate;  // S / G
  sim.set_rate(0, 0.0);
  for (int part = 1; part <= 2; ++part) {
    for (int k = 0; k < 400; ++k) sim.step_for(time / 400.0);  // Euler's rule: + 0.12 % a part
    report("pressure left, over that at shut-in, after " + std::to_string(part) + " S / G",
           (sim.well(0).pressure - formation) / excess, std::exp(-part), tolerance);
  }
}

// Three clusters of 8, 4 and 2 perforations: at one drop rates go with the counts. With tortuosity at the last: its square root by hand.
TEST(V34WellsSmoke, ClustersShareTheRate) {
  constexpr double rate = 6e-3;
  const std::array<double, 3> count{8.0, 4.0, 2.0};
  for (const double near_well : {0.0, 8e6}) {
    hfrac::Definition def = rock(1e-11, {20.0, 50.0, 80.0});
    for (std::size_t k = 0; k < 3; ++k) {
      perforate(def.wells[k], count[k]);
      def.wells[k].wellbore = 1;
      if (k > 0) def.wells[k].control = HFRAC_WELL_PRESSURE;
    }
    def.wells[0].rate = rate;
    def.wells[2].near_well_friction = near_well;
    Simulation sim(def);
    sim.step(5);
    // One drop P in all: sum of q_i(P) = Q, q_0 and q_1 by their orifices, q_2 between both laws by halving.
    const auto third = [&](double shared) {
      double low = 0.0, high = rate;
      for (int k = 0; k < 200; ++k) {
        const double q = 0.5 * (low + high);
        (orifices(q, count[2]) + near_well * std::sqrt(q * height) < shared ? low : high) = q;
      }
      return low;
    };
    const auto orifice = [&](double shared, double n) { return std::sqrt(shared / orifices(1.0, n)); };
    double low = 0.0, high = 1e9;
    for (int k = 0; k < 200; ++k) {
      const double p = 0.5 * (low + high);
      (orifice(p, count[0]) + orifice(p, count[1]) + third(p) < rate ? low : high) = p;
    }
    const std::array<double, 3> by_hand{orifice(low, count[0]), orifice(low, count[1]), third(low)};
    for (int32_t k = 0; k < 3; ++k) {
      report("cluster " + std::to_string(k) + (near_well > 0.0 ? " with tortuosity at 2" : "") + ", m2/s",
             sim.well(k).rate, by_hand[static_cast<std::size_t>(k)], tolerance);
    }
  }
}

// Two stages with a wellbore each, one after the other (the first stays shut in and holds its pressure) and at once.
TEST(V34WellsSmoke, StagesOneAfterTheOtherAndAtOnce) {
  const std::vector<double> places{20.0, 80.0};
  const std::array<double, 2> own{own_storage(places, 0), own_storage(places, 1)};
  const double storage = 20.0 * own[0];
  const auto two_stages = [&] {
    hfrac::Definition def = rock(1e-22, places);
    def.wells[0].storage = def.wells[1].storage = storage;
    return def;
  };
  hfrac::Definition def = two_stages();
  def.wells[0].rate = 2e-3;
  schedule(def, {{0, 5.0, 0.0}, {1, 6.0, 1e-3}, {1, 12.0, 0.0}});
  Simulation after(def);
  const auto rise = [&](const Simulation& sim, int32_t well) {
    return sim.well(well).wellbore_pressure - formation;
  };
  const double first = 5.0 * 2e-3 / (storage + own[0]), second = 6.0 * 1e-3 / (storage + own[1]);
  go_on(after, 6.0);
  report("stage 1 pumped and shut in, rise, Pa", rise(after, 0), first, tolerance);
  report_absolute("stage 2 not yet, rise over that, 1", rise(after, 1) / first, 0.0, tolerance);
  go_on(after, 13.0);
  report("stage 2 pumped, rise, Pa", rise(after, 1), second, tolerance);
  report("stage 1 still shut in, rise, Pa", rise(after, 0), first, tolerance);

  def = two_stages();
  def.wells[0].rate = 2e-3;
  def.wells[1].rate = 1e-3;
  schedule(def, {{0, 5.0, 0.0}, {1, 6.0, 0.0}});
  Simulation at_once(def);
  go_on(at_once, 7.0);
  report("at once, stage 1, rise, Pa", rise(at_once, 0), first, tolerance);
  report("at once, stage 2, rise, Pa", rise(at_once, 1), second, tolerance);
}

}  // namespace V34_wells
