// SPDX-License-Identifier: BSD-3-Clause
// The ledger: energy, fluid and heat of a model, counted from the end of its initial equilibration.
//
//   energy  works of fluid, far field and temperature = change of stored energy + friction + damping + what breaking bonds took along.
//           Found by the explicit solver in every cycle, so that the error says something. The quasi-static solver does not follow
//           the motion from one equilibrium to the next: what the works did beyond what is stored is accounted for as damping, the balance
//           closes by that and its error is not checked.
//   fluid   injected + put in by a host = stored + leaked, to rounding, with any solver
//   heat    from wells, outside, held discs and a host = stored
#pragma once

#include "step/engine.hpp"

namespace hfrac {

struct Balance {
  double kinetic, bond_elastic, contact_elastic, fluid_work, boundary_work, friction, damping,
      fracture;                                  // J/m
  bool energy_checked;                           // the energy was counted independently on both sides
  double energy_error;                           // J/m; not a number unless checked
  double injected, stored, leaked, fluid_error;  // m2
  double host;                                   // m2, put into pores by the host
};
Balance balance_of(const Engine& engine);

// Heat of rock and pores [J/m], counted from the temperature at the start.
struct HeatBalance {
  double stored, from_wells, from_outside, from_held, from_host, error;
  double thermal_work;     // J/m of elastic energy put in by changes of temperature
  double lowest, highest;  // K, of the discs
};
HeatBalance heat_balance_of(const Engine& engine);
// Throws Error(argument) if there is no temperature.
void require_heat(const Engine& engine);
double stored_heat(const Engine& engine);  // J/m

struct ElasticEnergy {
  double bonds = 0.0,
         contacts =
             0.0;  // J/m; contacts with walls, non-bonded ones, and the rock beyond (boundary.kind infinite)
};
ElasticEnergy elastic_energy(const Engine& engine);

// Counts from here on.
void begin_ledger(Engine& engine);
// What `duration` seconds of flow injected and leaked.
void accumulate_flow(Engine& engine, double duration);
// Fluid that a host put into a domain [m2], and the heat it brings.
void book_host_fluid(Engine& engine, std::size_t domain, double gain);
// Works that nothing in the balance accounts for yet [J/m]: with the quasi-static solver, since book_damping.
double unaccounted_work(const Engine& engine);
// What the quasi-static solver left of the energy balance, as damping.
void book_damping(Engine& engine);
// Before the pressure outside changes: the work it did so far.
void keep_outside_work(Model& model);

}  // namespace hfrac
