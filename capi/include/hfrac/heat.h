/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Temperature: what a host sets and reads of it. All temperatures are in kelvin (0 degrees C is 273.15 K).
 *
 * thermal.mode says what there is. "off": no temperature; the functions here answer HFRAC_ERR_ARGUMENT. "uniform": one
 * temperature, which hfrac_set_temperature changes. "transport": one by disc and one by fluid domain; heat is conducted by
 * the rock, exchanged with the fluid and carried by it, once a step (once an increment in mode "coupled").
 * The rock feels temperature in three ways: discs and bonds grow (thermal.expansion), and stiffness, strength and friction
 * follow the table (thermal.parameters "table"). What is set here is in force at once and felt by the rock in the next step.
 * Setting temperatures of discs is refused while a step is open (hfrac_step_prepare); a well's may be set at any time.
 *
 * Read by disc and by domain: the fields disc.temperature and domain.temperature (field.h).
 */
#ifndef HFRAC_HEAT_H
#define HFRAC_HEAT_H

#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Gives rock and fluid one temperature [K]. HFRAC_ERR_ARGUMENT: no temperature in this simulation, a step is open, or the
 * value lies outside the table of micro-parameters. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_temperature(hfrac_sim *sim, double temperature);

/** Gives every disc its temperature [K], `count` values, one per disc; the fluid in a pore takes the mean of the discs around
 * it. What heat this takes goes to `host` of hfrac_get_heat. Needs mode "transport". HFRAC_ERR_ARGUMENT as above; nothing
 * changes then. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_disc_temperature(hfrac_sim *sim, const double *temperature, int64_t count);

/** The same by cell of the host's grid (hfrac_set_grid), `count` values [K], one per cell (nx * ny, i fastest): a disc takes the
 * temperature of the cell that held its centre at bonding, discs outside the grid keep theirs. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_cell_temperature(hfrac_sim *sim, const double *temperature, int64_t count);

/** Temperature [K] of the rock by cell of the host's grid: mean of the discs with their centre in it, by heat capacity; a cell
 * without discs gives thermal.rock_temperature. Copies up to `capacity` values; *count is nx * ny. buffer NULL: only *count.
 * Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_get_cell_temperature(hfrac_sim *sim, double *buffer, int64_t capacity, int64_t *count);

/** Which discs keep their temperature whatever flows: `count` values, one per disc, not 0: held; in place of what was held
 * before (thermal.outer "held" begins with the outermost discs). Part of the state. Needs mode "transport". Unstable since
 * 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_hold_disc_temperature(hfrac_sim *sim, const int32_t *held, int64_t count);

/** Temperature [K] of what well `index` injects, from the next step on; thermal.fluid_temperature at first. Kept by the tries
 * of an open step. Needs mode "transport". Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_set_temperature(hfrac_sim *sim, int32_t index, double temperature);

/** Temperature [K] of the fluid in well `index`: that injected while it feeds the rock, else the mixture of what flows in.
 * thermal.rock_temperature before the first step. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_get_temperature(const hfrac_sim *sim, int32_t index, double *temperature);

/** Heat of rock and pores, wells excluded, counted from thermal.rock_temperature. Set struct_size before the call. */
typedef struct hfrac_heat {
  int32_t struct_size;  /**< sizeof(hfrac_heat) of the caller */
  int32_t mode;         /**< 0 off, 1 uniform, 2 transport */
  double stored;        /**< [J/m] in rock and pores beyond that after the initial equilibration */
  double wells;         /**< [J/m] from wells since the initial equilibration: carried and through their walls */
  double outside;       /**< [J/m] carried in through the outer boundary */
  double held;          /**< [J/m] from discs that are held */
  double host;          /**< [J/m] put in by the host: temperatures it set, fluid it put into pores */
  double error;         /**< [J/m] wells + outside + held + host - stored: rounding */
  double thermal_work;  /**< [J/m] elastic energy that changes of temperature put in; one of the works of hfrac_balance */
  double lowest;        /**< [K] coldest disc */
  double highest;       /**< [K] warmest disc */
} hfrac_heat;
/** The heat balance now. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_get_heat(const hfrac_sim *sim, hfrac_heat *heat);

#ifdef __cplusplus
}
#endif
#endif
