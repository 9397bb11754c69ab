/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * A simulation's life: create, step, ask how it stands, destroy.
 *
 * hfrac_sim_create packs the discs, cuts the wells, bonds, builds the flow network and brings the model to rest under
 * the far-field stress. Then step or advance, reading anything in between. One simulation belongs to one thread at a
 * time; different ones may run at once. Results do not depend on run.workers.
 */
#ifndef HFRAC_SIM_H
#define HFRAC_SIM_H

#include "def.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Builds a simulation. On failure *sim is NULL and hfrac_last_error(NULL, ...) says why. HFRAC_ERR_COLLAPSED: more than
 * initial.broken_fraction of the bonds broke under the far field, or the rock found no rest at all. HFRAC_ERR_MEMORY: also, before
 * anything is made, where this machine's memory, swap included, is less than the model takes at the very least: a system that
 * lends more than it has would end the program later. HFRAC_ERR_MODEL: also for more discs than the way of solving takes, 1e7
 * quasi-static, with facets or with flow.solver "direct", 5e7 with transported heat, else 1e8. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_create(const hfrac_sim_def *def, hfrac_sim **sim);

/** Frees a simulation and sets *sim to NULL; NULL and *sim == NULL are fine. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_destroy(hfrac_sim **sim);

/** The definition the simulation was built from, defaults filled in, into `def`, which hfrac_sim_def_init has filled; its lists
 * are the library's then (hfrac_sim_def_free). Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_definition(const hfrac_sim *sim, hfrac_sim_def *def);

/* A run goes on in one of three ways, and says in its status how it ended. Of several notes the first counts:
 *   HFRAC_STOPPED         a callback asked for it; the simulation is at its last whole step
 *   HFRAC_STOP_CONDITION  stop.extent_fraction or stop.cracks is reached (hfrac_set_stop lets the run go on)
 *   HFRAC_NOT_AT_REST     the last step (hfrac_advance: a step) did not reach stepping.force_ratio */

/* HFRAC_ERR_COLLAPSED from any of them: in one step a disc moved by more than its diameter, so the discs are no rock any more and
 * numbers made of them would mean nothing. The step is undone, earlier ones stand, and the text names disc and displacement. */

/** Takes `count` steps (sub-steps in mode "substep", stepping.flow_step seconds of real motion each in mode "dynamic",
 * stepping.flow_step seconds of flow and equilibrium together in mode "coupled").
 * All of them, whatever stop conditions say; HFRAC_STOP_CONDITION if one holds at the end. Stable since 0.1. */
HFRAC_API int32_t hfrac_step(hfrac_sim *sim, int64_t count);

/** Why hfrac_advance returned. */
enum hfrac_stop_reason {
  HFRAC_REASON_TARGET = 0,   /**< target time reached */
  HFRAC_REASON_CALLBACK = 1, /**< the progress callback asked for it */
  HFRAC_REASON_EXTENT = 2,   /**< a crack tip passed stop.extent_fraction: what follows is the boundary's doing */
  HFRAC_REASON_CRACKS = 3    /**< stop.cracks reached */
};

/** Steps until model time `target` [s] is reached: time moves in whole steps, so *reached >= target on success (HFRAC_OK or
 * HFRAC_NOT_AT_REST), and equal to it where whole steps add up to it, rounding or not. Ends before, without a step if it holds
 * already, at a stop condition (HFRAC_STOP_CONDITION). A target in the past is reached. Stable since 0.1. */
HFRAC_API int32_t hfrac_advance(hfrac_sim *sim, double target, double *reached, int32_t *reason);

/** The same, with the last step shortened so that *reached == target on success. HFRAC_ERR_ARGUMENT: the target lies before
 * the model's time. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_advance_to(hfrac_sim *sim, double target, double *reached, int32_t *reason);

/** Other limits than stop.extent_fraction (0.01 to 1) and stop.cracks (0: no limit) from now on, so that a run that ended at one
 * goes on. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_stop(hfrac_sim *sim, double extent_fraction, int64_t cracks);

/** Sets the callback of hfrac_step and hfrac_advance, called about every `seconds` of wall time (0: between any two
 * steps and often within one); NULL removes it. Stable since 0.1. */
HFRAC_API int32_t hfrac_set_progress(hfrac_sim *sim, hfrac_progress_fn progress, void *user, double seconds);

/** Called after every whole step of hfrac_step and hfrac_advance (not of hfrac_step_do, whose host is in control anyway), on
 * the calling thread. It may read `sim`; calls that would change it return HFRAC_ERR_BUSY. Nonzero stops after this step,
 * which is kept (HFRAC_STOPPED). `step` counts from 1, `time` [s] is the model's. */
typedef int32_t (*hfrac_step_fn)(void *user, hfrac_sim *sim, int64_t step, double time);

/** Sets the callback after every step; NULL removes it. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_on_step(hfrac_sim *sim, hfrac_step_fn on_step, void *user);

/** Sets who is told what happens, up to `level` (enum hfrac_log_level); NULL removes it. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_log(hfrac_sim *sim, hfrac_log_fn log, void *user, int32_t level);

/** How the simulation stands. Set struct_size before the call. */
typedef struct hfrac_sim_state {
  int32_t struct_size;        /**< sizeof(hfrac_sim_state) of the caller */
  int32_t at_rest;            /**< 1 if the last step's mechanics reached stepping.force_ratio */
  double time;                /**< [s] model (fluid) time */
  int64_t step;               /**< steps taken since creation */
  int64_t cycles;             /**< mechanical cycles since creation */
  double force_ratio;         /**< mean unbalanced over mean contact force */
  int64_t crack_count;        /**< bonds broken, all modes, the initial equilibration included */
  int64_t tensile_cracks;     /**< of them in tension */
  int64_t shear_cracks;       /**< of them in shear */
  int64_t equilibration_cracks; /**< of them before injection, while the model came to rest */
  int64_t disc_count;         /**< discs */
  int64_t bond_count;         /**< bonded contacts, intact or broken */
  int64_t domain_count;       /**< fluid domains, wells included */
  double mechanical_step;     /**< [s] time of one mechanical cycle with real masses (stable step times safety) */
  double tip_distance;        /**< [m] farthest crack end from the nearest well centre, 0 without cracks */
  int32_t stop_reason;        /**< enum hfrac_stop_reason that holds now, 0 if none */
  int32_t flow_subcycles;     /**< explicit flow: sub-cycles of the last step; implicit: iterations */
  double sigma_Hmax;          /**< [Pa] far-field stress along x in force, as stress.convention says */
  double sigma_hmin;          /**< [Pa] along y */
  double formation_pressure;  /**< [Pa] absolute, in the pores outside the model */
} hfrac_sim_state;
/** How the simulation stands now. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_get_state(const hfrac_sim *sim, hfrac_sim_state *state);

/** What the set-up made. Set struct_size before the call. */
typedef struct hfrac_setup_report {
  int32_t struct_size;           /**< sizeof(hfrac_setup_report) of the caller */
  int32_t struct_pad;            /**< 0 */
  double mean_radius;            /**< [m] mean radius of all discs packed; of a graded packing (packing.coarsening) that of its fine discs */
  double porosity;               /**< void fraction of the packing before the well is cut */
  double packing_residual;       /**< unbalanced over mean contact force of the relaxed packing */
  double coordination;           /**< bonds per disc times two */
  int64_t packed_discs;          /**< discs packed */
  int64_t removed_in_wells;      /**< discs removed to cut the wells */
  int64_t removed_floaters;      /**< discs removed because they had fewer than two bonds */
  int64_t removed_crossings;     /**< near contacts not bonded because they cross another */
  double strength_factor;        /**< strengths used, at the mean radius, over strengths given (bond.fracture_toughness and
                                      bond.toughness_reference_radius) */
  double zero_stress_aperture;   /**< [m] r0 in use (eq. 7) */
  double permeability;           /**< [m2] of the network after the initial equilibrium, without joints that conduct */
  double equilibration_force_ratio; /**< unbalanced over mean contact force after the initial equilibrium */
  double packing_seconds;        /**< wall time of the packing */
  double setup_seconds;          /**< wall time of all of hfrac_sim_create */
  double coarsest_radius;        /**< [m] mean radius of the discs farthest from the fine ones of a graded packing; uniform: mean_radius */
  int64_t fine_discs;            /**< discs packed where a graded packing is fine; uniform: all */
  double exterior_modulus;       /**< [Pa] E' of the rock beyond with boundary.kind infinite, given or measured; else 0 */
  double exterior_poisson_ratio; /**< its Poisson's ratio in plane strain */
  double plane_modulus;          /**< [Pa] E' at tips: fracture.plane_modulus, given or measured; else 0 */
} hfrac_setup_report;
/** What the set-up made. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_get_setup(const hfrac_sim *sim, hfrac_setup_report *report);

/** Energy and fluid mass since the end of the initial equilibration. Set struct_size before the call. */
typedef struct hfrac_balance {
  int32_t struct_size;       /**< sizeof(hfrac_balance) of the caller */
  int32_t energy_checked;    /**< 1: energy_error says something; 0: the quasi-static solver closes its balance by `damping` */
  double kinetic;            /**< [J/m] kinetic energy now */
  double bond_elastic;       /**< [J/m] stored in intact bonds now */
  double contact_elastic;    /**< [J/m] stored in contacts now (discs and walls), and in the rock beyond (boundary.kind infinite) */
  double fluid_work;         /**< [J/m] work of fluid pressure on the discs since the initial equilibration */
  double boundary_work;      /**< [J/m] work of the far field on the model since the initial equilibration */
  double friction;           /**< [J/m] dissipated by sliding since the initial equilibration */
  double damping;            /**< [J/m] dissipated by damping since the initial equilibration; unless checked, whatever the works left over */
  double fracture;           /**< [J/m] elastic energy of bonds lost as they broke since the initial equilibration */
  double energy_error;       /**< [J/m] what is missing in: works = change of stored + dissipated; not a number unless checked */
  double injected_volume;    /**< [m2] fluid put in through all wells, at formation pressure */
  double stored_volume;      /**< [m2] change of content of all domains, wells included */
  double leaked_volume;      /**< [m2] out through the outer boundary */
  double fluid_error;        /**< [m2] injected + host - stored - leaked */
  double host_volume;        /**< [m2] put into pores by the host (hfrac_set_cell_pressure), negative: taken out */
} hfrac_balance;
/** Energy and fluid balance now. Stable since 0.1. */
HFRAC_API int32_t hfrac_get_balance(const hfrac_sim *sim, hfrac_balance *balance);

/** What the quasi-static solver did since the initial equilibration; all 0 with solver.kind "explicit". Set struct_size before the call. */
typedef struct hfrac_solver_report {
  int32_t struct_size;         /**< sizeof(hfrac_solver_report) of the caller */
  int32_t kind;                /**< 0 explicit, 1 quasi-static */
  double increment;            /**< [s] mode "coupled": length of the next increment of a step */
  int64_t increments;          /**< mode "coupled": accepted increments */
  int64_t rounds;              /**< equilibria found: one a solve, and one more each time bonds broke */
  int64_t newton_iterations;   /**< of Newton's method */
  int64_t linear_iterations;   /**< of the linear solver */
  int64_t factors;             /**< factors of a tangent computed */
  int64_t rejected_error;      /**< increments rejected because of solver.pressure_change */
  int64_t rejected_strength;   /**< increments rejected because of solver.strength_overshoot */
  int64_t rejected_divergence; /**< increments rejected because no equilibrium was found */
} hfrac_solver_report;
/** What the quasi-static solver did since the initial equilibration. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_get_solver(const hfrac_sim *sim, hfrac_solver_report *report);

/** What limits a step binds. */
enum hfrac_step_limit {
  HFRAC_LIMIT_NONE = 0,      /**< none: stepping.flow_step is a matter of accuracy */
  HFRAC_LIMIT_MECHANICS = 1, /**< the rock's motion: a step takes several mechanical cycles */
  HFRAC_LIMIT_FLOW = 2       /**< explicit flow: a step takes several sub-cycles */
};

/** How long a step could be, and how it is divided. Set struct_size before the call. */
typedef struct hfrac_step_limits {
  int32_t struct_size;    /**< sizeof(hfrac_step_limits) of the caller */
  int32_t binding;        /**< enum hfrac_step_limit: what divides a step of stepping.flow_step most finely */
  double flow_step;       /**< [s] what hfrac_step takes next: stepping.flow_step, or what is left to a schedule's next time */
  double mechanical_step; /**< [s] of one mechanical cycle with real masses, stable step times stepping.safety; binds in mode
                               dynamic only, since in the others the rock moves to rest in no time of its own */
  double explicit_step;   /**< [s] largest stable step of explicit flow at today's apertures (half of it is used), at most
                               1e300; binds with flow.scheme explicit only */
} hfrac_step_limits;
/** How long a step could be now. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_get_step_limits(const hfrac_sim *sim, hfrac_step_limits *limits);

/** One wall of a model with boundary.kind walls. Set struct_size before the call. */
typedef struct hfrac_wall_state {
  int32_t struct_size;  /**< sizeof(hfrac_wall_state) of the caller */
  int32_t moves;        /**< 1: its servo keeps it at `target`, 0: fixed in place */
  double normal[2];     /**< unit vector into the model */
  double position;      /**< [m] x of a wall across x, y of one across y, now */
  double displacement;  /**< [m] inward, since bonding */
  double stress;        /**< [Pa] on it now, compression positive, effective: without what the pores outside carry */
  double target;        /**< [Pa] of the servo, likewise effective */
  int64_t disc_count;   /**< discs that can touch it */
} hfrac_wall_state;
/** Number of walls: 4 (left, right, lower, upper), or 0 with boundary.kind stress. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_wall_count(const hfrac_sim *sim, int32_t *count);
/** Wall `index` (from 0) now. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_wall_get(const hfrac_sim *sim, int32_t index, hfrac_wall_state *state);

/** A number that is equal if and only if (up to collision) the state is equal, bit for bit. Stable since 0.1. */
HFRAC_API int32_t hfrac_state_hash(const hfrac_sim *sim, int64_t *hash);

/** One well as it stands. Set struct_size before the call. */
typedef struct hfrac_well_state {
  int32_t struct_size;       /**< sizeof(hfrac_well_state) of the caller */
  int32_t control;           /**< enum hfrac_well_control in force */
  double x;                  /**< [m] centre */
  double y;                  /**< [m] */
  double equivalent_radius;  /**< [m] sqrt(area / pi) of the hole between disc centres */
  double pressure;           /**< [Pa] now, as stress.convention says */
  double target_pressure;    /**< [Pa] */
  double rate;               /**< [m2/s] into the well in the last step */
  double injected_volume;    /**< [m2] since the initial equilibration, at formation pressure */
  int64_t domain;            /**< index of its domain */
  double radius;             /**< [m] of the hole that was asked for; its wall follows discs (equivalent_radius); 0: a pore (hfrac_well_add) */
  double wellbore_pressure;  /**< [Pa] before the perforations, as stress.convention says; without friction that of the hole */
  double wellhead_pressure;  /**< [Pa] absolute: that of the wellbore less rho g depth */
  double wellbore_rate;      /**< [m2/s] that the pump gave the wellbore, with all its clusters, in the last step */
  int64_t fluid;             /**< enum hfrac_well_fluid: what it pumps; of a wellbore's clusters all that the first does */
} hfrac_well_state;
/** Number of wells. Stable since 0.1. */
HFRAC_API int32_t hfrac_well_count(const hfrac_sim *sim, int32_t *count);
/** Well `index` (from 0) now. Stable since 0.1. */
HFRAC_API int32_t hfrac_well_get(const hfrac_sim *sim, int32_t index, hfrac_well_state *state);
/** Adds a well at any time between two steps: the pore of the rock nearest to (`x`, `y`) [m] takes or gives fluid where it lies. No hole is
 * cut, and no disc, bond or domain is renumbered. *index is its number, the next one; its x, y and domain are the pore's, its radius
 * is 0. It is shut in, and nothing changes, until hfrac_well_set_... drives it. Wells added belong to the state: an image brings them
 * to any simulation built from the same definition, one from before takes them away (told as a warning), and hfrac_sim_definition is
 * what was built. HFRAC_ERR_ARGUMENT: the place is outside the rock or another well's, pores hold no fluid (flow.scheme "off"), or a
 * step is open. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_add(hfrac_sim *sim, double x, double y, int32_t *index);
/** From the next step on, holds a well at `pressure` [Pa]. Stable since 0.1. */
HFRAC_API int32_t hfrac_well_set_pressure(hfrac_sim *sim, int32_t index, double pressure);
/** From the next step on, ramps a well from where it is by `per_step` [Pa] up or down to `pressure` [Pa]. Stable since 0.1. */
HFRAC_API int32_t hfrac_well_set_ramp(hfrac_sim *sim, int32_t index, double pressure, double per_step);
/** From the next step on, injects `rate` [m2/s] (negative: takes out; 0: shut in). Stable since 0.1. */
HFRAC_API int32_t hfrac_well_set_rate(hfrac_sim *sim, int32_t index, double rate);
/** Replaces a well's schedule: from model time time[k] [s] on, held at value[k] [Pa] (control[k] HFRAC_WELL_PRESSURE) or taking
 * value[k] [m2/s] (HFRAC_WELL_RATE). `count` entries in order of time, copied; 0 ends the schedule and leaves the well as it is
 * driven. Of entries already past the last takes effect with the next step. Steps of hfrac_step and hfrac_advance end at the
 * times; a host that sets its own durations (hfrac_step_do) gets what is due when its step begins. hfrac_well_set_pressure,
 * _ramp and _rate end a well's schedule. HFRAC_ERR_ARGUMENT or HFRAC_ERR_MODEL, and the old schedule stays, if times fall or
 * repeat, or a value is none a well can have. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_set_schedule(hfrac_sim *sim, int32_t index, int32_t count, const double *time,
                                          const int32_t *control, const double *value);
/** From the next step on, a well pumps `fluid` (enum hfrac_well_fluid). It stays driven as it is, and its schedule goes on; an entry of
 * a case file's that names a fluid changes it again. HFRAC_ERR_ARGUMENT: the model has no second fluid (fluid.second_viscosity), or
 * another well drives this one's wellbore. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_well_set_fluid(hfrac_sim *sim, int32_t index, int32_t fluid);

#ifdef __cplusplus
}
#endif
#endif
