/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * What a simulation is made of: the definition struct, the same options by key name, and case files.
 *
 * Order of calls: hfrac_sim_def_init, then any mix of plain assignment, hfrac_sim_def_set_*, and
 * hfrac_sim_def_load (a case file over what is set so far), then hfrac_sim_create (sim.h). The definition stays the
 * caller's; the library keeps a copy. All texts behind `const char *` are 0-terminated UTF-8.
 *
 * Wells, joints and schedule are lists: a pointer to the first item, how many there are, and the size of one item. There is no
 * limit to their number. Items may gain members at their end, so the size says which of them the items have: a host that fills a
 * list sets it to its own sizeof, what smaller items lack has its default, and larger ones with something in their unknown tail
 * are refused (HFRAC_ERR_STRUCT_SIZE). A list belongs either
 *   to the caller, who points the struct at an array: it is read while a call lasts, never written, never kept; or
 *   to the library, after hfrac_sim_def_load, after a key of an item or a count was set, and in what hfrac_sim_definition and
 *     hfrac_sim_def_copy give. Its items may be read and changed in place, and the count lowered, until the next call that changes
 *     the definition. They lie the list's size apart: that of this library, or whatever the host had set before.
 *
 * A program compiled with older headers has a shorter struct. What lies beyond it has its default; a call that would set it to
 * anything else fails with HFRAC_ERR_STRUCT_SIZE and names the option.
 *
 * hfrac_sim_def_free ends the library's lists; for a definition without, it does nothing. Assigning the struct copies pointers
 * only: of two such structs one is used and freed, or the other is made with hfrac_sim_def_copy.
 */
#ifndef HFRAC_DEF_H
#define HFRAC_DEF_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

enum hfrac_def_limits { HFRAC_TITLE_SIZE = 128, HFRAC_PATH_SIZE = 1024 };

/** How a well is driven. */
enum hfrac_well_control {
  HFRAC_WELL_PRESSURE = 0, /**< held at `pressure` from the first step */
  HFRAC_WELL_RAMP = 1,     /**< rises from the formation's pressure by `ramp_per_step` each sub-step, up to `pressure` */
  HFRAC_WELL_RATE = 2      /**< takes `rate`; its pressure follows */
};

/** What a well pumps. */
enum hfrac_well_fluid {
  HFRAC_WELL_FLUID_FIRST = 0, /**< the fluid */
  HFRAC_WELL_FLUID_SECOND = 1 /**< that of fluid.second_viscosity */
};

/** One wellbore: a round hole cut into the packing. */
typedef struct hfrac_well_def {
  double x;             /**< [m] centre, origin at the model's lower left corner */
  double y;             /**< [m] */
  double radius;        /**< [m] discs with their centre inside are removed */
  double pressure;      /**< [Pa] target; net of the formation pressure where stress.convention is effective, absolute where it is total */
  double ramp_per_step; /**< [Pa] rise per sub-step (control ramp) */
  double rate;          /**< [m2/s] injected volume per thickness and time (control rate) */
  int64_t control;      /**< enum hfrac_well_control */
  /* Of the wellbore and what lies between it and the hole; 0 is the default of each. */
  double storage;               /**< [m2/Pa] volume of the wellbore's fluid per metre of thickness times compressibility */
  double perforation_count;     /**< [1] perforations between wellbore and hole; 0: no perforation friction */
  double perforation_diameter;  /**< [m] of one */
  double discharge_coefficient; /**< [1] of one; 0: 0.6 */
  double near_well_friction;    /**< [Pa/(m3/s)^0.5] coefficient k of k sqrt(Q), Q = rate times height */
  double height;                /**< [m] of the well over which the rate per thickness is spread; 0: 1 m */
  double depth;                 /**< [m] of the perforations below the wellhead */
  double fluid_density;         /**< [kg/m3] in wellbore and perforations; 0: thermal.fluid_density */
  int64_t wellbore;             /**< number of the wellbore it is a cluster of, the first of which drives it; 0: one of its own */
  int64_t fluid;                /**< enum hfrac_well_fluid: what it pumps from the start on */
  double perforation_length;    /**< [m] of its slots (law facet); 0: fracture.perforation_length and fracture.perforation_azimuth hold */
  double perforation_azimuth;   /**< [rad] of its slots from the x axis, with a length of its own */
  double fluid_area;            /**< [m2] that the hole's fluid fills at formation pressure; 0: the void between the discs */
} hfrac_well_def;

/** Whether the bonds of a joint hold. */
enum hfrac_joint_state {
  HFRAC_JOINT_BONDED = 0,        /**< until their strength is reached */
  HFRAC_JOINT_BROKEN = 1,        /**< broken from the start, and counted as cracks of the initial equilibration in shear */
  HFRAC_JOINT_SMOOTH_BONDED = 2, /**< bonded, and smooth whatever the packing: contacts look along the joint's normal */
  HFRAC_JOINT_SMOOTH_BROKEN = 3  /**< broken and smooth */
};

/** A straight line along which the rock is weaker or broken: it takes the bonds between discs whose centres lie on different
 * sides of it, with the line between them meeting it between its ends. Of joints that share a bond the last counts. Set every
 * member up to `state`: zeros are not the defaults of those keys. The members after it are of smooth joints (state
 * HFRAC_JOINT_SMOOTH_BONDED or HFRAC_JOINT_SMOOTH_BROKEN), and 0 is the default of each. */
typedef struct hfrac_joint_def {
  double x1;             /**< [m] one end, origin at the model's lower left corner */
  double y1;             /**< [m] */
  double x2;             /**< [m] other end */
  double y2;             /**< [m] */
  double tensile_factor; /**< [1] normal strength of its bonds over that of the rock */
  double shear_factor;   /**< [1] shear strength of its bonds over that of the rock */
  double friction;       /**< [1] coefficient of its contacts, negative: contact.friction */
  int64_t state;         /**< enum hfrac_joint_state */

  double normal_stiffness;  /**< [Pa/m] per area, at no normal stress; 0: smooth_joint.normal_stiffness */
  double shear_stiffness;   /**< [Pa/m] per area; 0: smooth_joint.shear_stiffness */
  double max_closure;       /**< [m] largest closure (Bandis, Lumsden and Barton 1983); 0: linear */
  double tensile_strength;  /**< [Pa] while bonded; 0: tensile_factor times that of the rock's bonds */
  double cohesion;          /**< [Pa] while bonded; 0: shear_factor times that of the rock's bonds */
  double residual_friction; /**< [1] once slipped by weakening_slip */
  double weakening_slip;    /**< [m] over which friction falls; 0: it stays */
  double dilation_angle;    /**< [rad] at which the faces ride up as they slip */
  double dilation_slip;     /**< [m] at which dilation ends */
  double aperture;          /**< [m] open at no normal stress; 0, residual_aperture too: tight as the rock */
  double residual_aperture; /**< [m] hydraulic, on top of what it is open */
  double roughness;         /**< [1] joint roughness coefficient of the hydraulic aperture; 0: none */
  double storage;           /**< [m/Pa] fluid per length and pressure that pores and small fractures beside it take in */
} hfrac_joint_def;

/** From `time` on, a well is driven otherwise. Entries of one well stand in order of time. */
typedef struct hfrac_schedule_def {
  int64_t well;    /**< number of the well, from 0 */
  double time;     /**< [s] model time; steps end at it */
  double value;    /**< [Pa] with control pressure, [m2/s] with control rate */
  int64_t control; /**< HFRAC_WELL_PRESSURE or HFRAC_WELL_RATE of enum hfrac_well_control */
  int64_t fluid;   /**< what it pumps from then on: 0 as before, 1 the fluid, 2 that of fluid.second_viscosity */
} hfrac_schedule_def;

/** Called while a simulation is built and while it runs, on the calling thread, with the share done in [0, 1] and
 * what is being done. Nonzero return stops (HFRAC_STOPPED). Must not call back into the same simulation except to read. */
typedef int32_t (*hfrac_progress_fn)(void *user, double fraction, const char *what);

/** The definition of a simulation. Fill with hfrac_sim_def_init first. Members are only ever appended, options too, so
 * later ones stand at the end; capi/tools/def_struct.py writes them from the option table. */
typedef struct hfrac_sim_def {
  int32_t struct_size;    /**< sizeof(hfrac_sim_def) of the caller, set by init */
  int32_t struct_version; /**< set by init; 2 since lists are pointers */

  void *lists;                  /**< the library's own lists, not to be touched; NULL from init */
  hfrac_well_def *wells;        /**< the first well; NULL if there is none */
  int64_t well_count;           /**< wells */
  int64_t well_size;            /**< [bytes] from one well to the next: sizeof(hfrac_well_def) of whoever filled them */
  hfrac_joint_def *joints;      /**< the first line of weakness; NULL if there is none */
  int64_t joint_count;          /**< joints */
  int64_t joint_size;           /**< [bytes] from one joint to the next */
  hfrac_schedule_def *schedule; /**< the first entry of the wells' schedules; NULL if there is none */
  int64_t schedule_count;       /**< entries */
  int64_t schedule_size;        /**< [bytes] from one entry to the next */

  /** [m] Extent of the model along x, the direction of sigma_Hmax. Default 100.0. */
  double model_width;
  /** [m] Extent of the model along y, the direction of sigma_hmin. Default 100.0. */
  double model_height;
  /** Seed of the packing; the same seed gives the same model, bit for bit. Default 1. */
  int64_t model_seed;

  /** 0: total, 1: effective. How stresses and pressures are given. total: total stresses and absolute
   * pressures; pores start at the formation pressure. effective: effective stresses, pressures net of the
   * formation pressure (reproduces the paper's figures, no statement about stress in situ). Default 0. */
  int64_t stress_convention;

  /** Number of discs packed, before the well is cut. Default 10000. */
  int64_t packing_disc_count;
  /** [1] Largest over smallest disc radius (Table 1). Default 2.70. */
  double packing_radius_ratio;
  /** [1] Void fraction of the packing (Table 1). Default 0.15. */
  double packing_porosity;
  /** [1] Unbalanced over mean contact force at which the packing counts as relaxed. Default 1e-4. */
  double packing_residual;

  /** [kg/m3] Density of the disc material (Table 1). Default 2320.0. */
  double disc_density;

  /** [N/m] Normal stiffness of a disc contact, per metre of thickness (Table 1). Default 11.20e9. */
  double contact_normal_stiffness;
  /** [N/m] Tangential stiffness of a disc contact (Table 1). Default 11.20e9. */
  double contact_shear_stiffness;
  /** [1] Coulomb friction coefficient of contacts (Table 1). Default 0.22. */
  double contact_friction;
  /** 0: parallel, 1: after-break. parallel: contact and bond act together (the paper; soft in tension,
   * stiff in compression). after-break: the contact acts once the bond is broken (linear before failure).
   * Default 0. */
  int64_t contact_mode;

  /** [N/m] Normal stiffness of a parallel bond times its area (not given by the paper; 0.46 of the
   * contact's gives a stiffness near its E). Default 5.152e9. */
  double bond_normal_stiffness;
  /** [N/m] Shear stiffness of a parallel bond times its area. Default 5.152e9. */
  double bond_shear_stiffness;
  /** [Pa] Normal strength sigma_c (Table 1). Default 42.5e6. */
  double bond_tensile_strength;
  /** [Pa] Shear strength tau_c (Table 1). Default 42.5e6. */
  double bond_shear_strength;
  /** [1] Bond radius over the smaller disc radius (lambda). Default 1.0. */
  double bond_radius_factor;
  /** [1] Share beta of the bending stress in the tensile criterion. Default 1.0. */
  double bond_moment_contribution;
  /** [1] Discs closer than this fraction of the mean radius are bonded. Default 0.05. */
  double bond_gap_tolerance;
  /** [m] If positive, strengths hold for this mean radius and are scaled by sqrt(reference/mean radius), so
   * that the fracture toughness does not depend on resolution. 0: strengths as given. Default 0.0. */
  double bond_toughness_reference_radius;

  /** [Pa] Far-field stress along x, compression positive; at least sigma_hmin. Total or effective, as
   * stress.convention says. Default 33e6. */
  double stress_sigma_Hmax;
  /** [Pa] Far-field stress along y, compression positive. Default 25e6. */
  double stress_sigma_hmin;

  /** 0: stress, 1: walls, 2: infinite. stress: far-field stress as forces on the outermost discs. walls:
   * four rigid frictionless walls, servo-driven to the far-field stress. infinite: as stress, and the
   * elastic rock beyond answers to what wells and fractures do to the outer boundary. Default 0. */
  int64_t boundary_kind;
  /** 0: fixed, 1: servo. Walls after the initial equilibrium: fixed in place, or kept at their stress by
   * the servo. Default 0. */
  int64_t boundary_walls_after_equilibration;

  /** [Pa s] Dynamic viscosity (Table 2). Default 0.3. */
  double fluid_viscosity;
  /** [Pa] Bulk modulus (Table 2). Default 1.0e9. */
  double fluid_bulk_modulus;
  /** [Pa] Pore pressure of the formation before injection (Table 2). Default 25e6. */
  double fluid_formation_pressure;

  /** 0: implicit, 1: explicit, 2: off. implicit: unconditionally stable. explicit: the paper's eq. 8, sub-
   * cycled. off: dry model. Default 0. */
  int64_t flow_scheme;
  /** [m2] Permeability of the unfractured rock (Table 2: 5.6 mD); the aperture at zero stress is calibrated
   * to it on the network at hand. Default 5.527e-15. */
  double flow_permeability;
  /** [m] Aperture r0 of an unloaded pipe (eq. 7). 0: found from flow.permeability. Default 0.0. */
  double flow_zero_stress_aperture;
  /** [N] Compressive contact force at which a pipe has half of r0 (eq. 7). Default 50e6. */
  double flow_half_aperture_force;
  /** [1] Aperture gained per opening of a broken bond (lambda of eq. 7). Default 1.0. */
  double flow_gap_factor;
  /** [1] Aperture gained per elastic opening of an intact bond (lambda of eq. 7; 0: intact rock keeps r0 in
   * tension). Default 0.0. */
  double flow_bonded_gap_factor;
  /** [m] Hydraulic aperture is capped here: beyond it a crack has no resistance worth resolving. The
   * mechanical aperture is not capped. Default 0.01. */
  double flow_aperture_limit;
  /** 0: formation, 1: closed. Pores outside the outermost discs: held at formation pressure, or no flow
   * across the boundary. Default 0. */
  int64_t flow_outer;

  /** 0: substep, 1: dynamic, 2: coupled. substep: one flow step, then mechanics to rest, breakage included
   * (the paper's sub-step). dynamic: Newton's law in real time, flow_step seconds a step. coupled: flow,
   * equilibrium and breakage together in the fluid's time, flow_step seconds a step in as many increments
   * as it takes; needs the quasi-static solver. Default 0. */
  int64_t stepping_mode;
  /** [s] Fluid time of one step. Default 1.0. */
  double stepping_flow_step;
  /** Steps of a run by the hfrac command. Default 500. */
  int64_t stepping_steps;
  /** [s] Model time at which a run ends, with the step that reaches it; 0: after stepping.steps. Default
   * 0.0. */
  double stepping_end_time;
  /** [1] Mean unbalanced over mean contact force at which mechanics count as at rest. Default 1e-4. */
  double stepping_force_ratio;
  /** Mechanical cycles after which a sub-step is ended though not at rest (noted in the history). Default
   * 20000. */
  int64_t stepping_max_cycles;
  /** [1] Local damping: this share of each unbalanced force opposes the motion. Also used in dynamic mode.
   * Default 0.7. */
  double stepping_damping;
  /** [1] Share of the stable time step used. Default 0.8. */
  double stepping_safety;

  /** [1] A run ends when a crack tip lies farther from the well than this fraction of the smaller model
   * side. Default 0.42. */
  double stop_extent_fraction;
  /** A run ends at this number of cracks; 0: no limit. Default 0. */
  int64_t stop_cracks;

  /** Worker threads of one simulation; results do not depend on it. Default 1. */
  int64_t run_workers;

  /** Steps between the snapshots of a run by the hfrac command. Default 10. */
  int64_t output_every;

  char title[HFRAC_TITLE_SIZE];          /**< free text, ends up in the output */

  /** Own packing instead of ours: x, y, radius per disc [m], borrowed during hfrac_sim_create; NULL: the engine packs. */
  const double *given_discs;
  int64_t given_disc_count; /**< discs in given_discs */

  hfrac_progress_fn progress; /**< called while the simulation is built; may be NULL */
  void *progress_user;        /**< handed to `progress` */

  /** 0: relaxed, 1: tiled, 2: growth, 3: square. How discs are packed. relaxed: from a jittered lattice.
   * growth: grown at random places, without an underlying lattice, takes longer. tiled: periodic bricks
   * side by side, for more than some 100 000 discs; disc_count is rounded to whole bricks and the frame of
   * the bricks repeats. square: equal discs in rows and columns, in which cracks and joints along them are
   * smooth slits. Default 0. */
  int64_t packing_method;
  /** Discs in one brick of a tiled packing. Default 5000. */
  int64_t packing_brick_discs;

  /** 0: explicit, 1: quasi-static. How the rock comes to rest. explicit: by damped motion. quasi-static:
   * equilibrium is solved for directly and bonds break in order of how far they exceed their strength.
   * Default 0. */
  int64_t solver_kind;
  /** [1] quasi-static: mean unbalanced over mean contact force, and error of a pressure over the largest
   * pressure difference, at which equilibrium counts as found. Default 1e-6. */
  double solver_tolerance;
  /** [1] Mode coupled: error of a pressure per increment of a step, over the largest pressure difference,
   * that sets the length of the increment. Default 0.05. */
  double solver_pressure_change;
  /** [1] Mode coupled: an increment of a step in which a bond would exceed its strength by more than this
   * is tried again shorter. Default 0.02. */
  double solver_strength_overshoot;
  /** [s] Mode coupled: increments of a step are not made shorter; what happens within is taken as sudden.
   * Default 1e-6. */
  double solver_smallest_step;

  /** 0: auto, 1: direct, 2: iterative, 3: petsc. How the implicit scheme solves for pressures. direct:
   * factorisation. iterative: conjugate gradients, for large models, shared by all ranks. auto: direct up
   * to 20 000 domains, and up to 60 000 in steps in which more than one pore in eight depends on others.
   * petsc: PETSc's conjugate gradients with algebraic multigrid, over all ranks. Default 0. */
  int64_t flow_solver;

  /** 0: zlib, 1: lz4, 2: none. How arrays in VTU files are packed. lz4: twice as fast as zlib, files a
   * fifth larger. Default 0. */
  int64_t output_compression;

  hfrac_log_fn log;           /**< told what happens while a case file is read and the simulation is built; may be NULL. Later: hfrac_set_log */
  void *log_user;             /**< handed to `log` */
  int64_t log_level;          /**< enum hfrac_log_level, down to which level `log` gets messages. Default 3 */

  /** 0: uniform, 1: seepage. Pore pressure before the treatment. uniform: the formation's. seepage: what
   * one well held at initial.well_pressure leaves, found by the poroelastic continuum (eq. 1-3). Default
   * 0. */
  int64_t initial_state;
  /** [Pa] State seepage: pressure of the well before the treatment, as stress.convention says. Default 0.0. */
  double initial_well_pressure;
  /** [s] State seepage: how long the well has been at that pressure; 0: until nothing changes any more.
   * Default 0.0. */
  double initial_seepage_time;
  /** [Pa] State seepage: drained Young's modulus of the continuum; needed for a seepage_time above 0 only.
   * Default 14.2e9. */
  double initial_youngs_modulus;
  /** [1] State seepage: drained Poisson's ratio of the continuum in plane strain. Default 0.24. */
  double initial_poissons_ratio;

  /** [Pa m^0.5] If positive, strengths follow from it and the size of the discs around each bond: sigma_c =
   * K_Ic / (coefficient sqrt(R)); bond.shear_strength keeps its ratio to bond.tensile_strength. 0:
   * strengths as given. Default 0.0. */
  double bond_fracture_toughness;
  /** [1] K_Ic over sigma_c sqrt(R) of the packing, for bond.fracture_toughness; 'hfrac lab centre-crack'
   * measures it. 0: what it measured on the default rock of contact.mode. Default 0.0. */
  double bond_toughness_coefficient;

  /** [Pa s^n] Consistency K of a shear-thinning fluid: its rate of shear is tau / viscosity + (tau /
   * K)^(1/n), so fluid.viscosity is that at rest. 0: Newtonian, with fluid.viscosity. Default 0.0. */
  double fluid_consistency;
  /** [1] Index n of the power law; below 1 with fluid.consistency, 1 without. Default 1.0. */
  double fluid_power_index;

  /** 0: off, 1: uniform, 2: transport. Temperature. off: none. uniform: one temperature that a host may
   * change. transport: heat is conducted by the rock and carried by the fluid. Default 0. */
  int64_t thermal_mode;
  /** [K] Temperature of rock and fluid before injection; discs have their given radius at it (0 degrees C
   * is 273.15 K). Default 523.15. */
  double thermal_rock_temperature;
  /** [K] Temperature of the fluid injected into wells; a host may set each well's own. Default 293.15. */
  double thermal_fluid_temperature;
  /** [W/(m K)] Thermal conductivity of the rock with its fluid. Default 2.8. */
  double thermal_conductivity;
  /** [J/(kg K)] Specific heat of the disc material. Default 900.0. */
  double thermal_specific_heat;
  /** [J/(kg K)] Specific heat of the fluid. Default 4200.0. */
  double thermal_fluid_specific_heat;
  /** [kg/m3] Density of the fluid, for the heat it carries. Default 1000.0. */
  double thermal_fluid_density;
  /** [W/(m2 K)] Heat transfer between the fluid and the faces of discs. 0: faces have the fluid's
   * temperature. Default 0.0. */
  double thermal_film_coefficient;
  /** [1/K] Linear expansion of discs and bonds in the plane; for a rock in plane strain 1 + nu times the
   * rock's own (thermal strain of Timoshenko and Goodier). 0: temperature strains nothing. Default 0.0. */
  double thermal_expansion;
  /** 0: insulated, 1: held. Outermost discs: no heat passes them, or they keep their temperature. Default
   * 0. */
  int64_t thermal_outer;
  /** 0: constant, 1: table. constant: stiffness, strength and friction as given. table: multiplied by the
   * factors below at each disc's temperature, linear in between; temperatures outside the table are
   * refused. Default 0. */
  int64_t thermal_parameters;
  /** Rows of the table in use. Default 4. */
  int64_t thermal_table_rows;
  /** [K] Row 1 of the table (Table 3: 250 degrees C). Rows rise in temperature. Default 523.15. */
  double thermal_temperature_1;
  /** [K] Row 2 (Table 3: 300 degrees C). Default 573.15. */
  double thermal_temperature_2;
  /** [K] Row 3 (Table 3: 350 degrees C). Default 623.15. */
  double thermal_temperature_3;
  /** [K] Row 4 (Table 3: 400 degrees C). Default 673.15. */
  double thermal_temperature_4;
  /** [K] Row 5 (beyond Table 3; a row of your own). Default 773.15. */
  double thermal_temperature_5;
  /** [1] Factor on contact and bond stiffnesses at temperature_1 (Table 3: 11.20e9 N/m over 11.20e9; bonds
   * follow the contacts by assumption). Default 1.0. */
  double thermal_stiffness_1;
  /** [1] At temperature_2 (Table 3: 8.98e9 over 11.20e9). Default 0.8017857142857143. */
  double thermal_stiffness_2;
  /** [1] At temperature_3 (Table 3: 7.21e9 over 11.20e9). Default 0.64375. */
  double thermal_stiffness_3;
  /** [1] At temperature_4 (Table 3: 5.78e9 over 11.20e9). Default 0.5160714285714286. */
  double thermal_stiffness_4;
  /** [1] At temperature_5. Default 0.5160714285714286. */
  double thermal_stiffness_5;
  /** [1] Factor on bond strengths at temperature_1. The paper gives no strength by temperature: any value
   * but 1 is an assumption of yours. Default 1.0. */
  double thermal_strength_1;
  /** [1] At temperature_2. Default 1.0. */
  double thermal_strength_2;
  /** [1] At temperature_3. Default 1.0. */
  double thermal_strength_3;
  /** [1] At temperature_4. Default 1.0. */
  double thermal_strength_4;
  /** [1] At temperature_5. Default 1.0. */
  double thermal_strength_5;
  /** [1] Factor on contact.friction at temperature_1 (Table 3: 0.22 over 0.22). Default 1.0. */
  double thermal_friction_1;
  /** [1] At temperature_2 (Table 3: 0.22 over 0.22). Default 1.0. */
  double thermal_friction_2;
  /** [1] At temperature_3 (Table 3: 0.23 over 0.22). Default 1.0454545454545454. */
  double thermal_friction_3;
  /** [1] At temperature_4 (Table 3: 0.23 over 0.22). Default 1.0454545454545454. */
  double thermal_friction_4;
  /** [1] At temperature_5. Default 1.0454545454545454. */
  double thermal_friction_5;

  /** [s] Wall time between the checkpoints that hfrac resume goes on from; 0: none by time. Default 600.0. */
  double output_checkpoint_every;
  /** Steps between the checkpoints that hfrac resume goes on from; 0: none by steps. Default 0. */
  int64_t output_checkpoint_steps;
  /** With given_discs, which of them are bonded: two indices into given_discs per bond, from 0, borrowed during
   * hfrac_sim_create; NULL: all that are near (bond.gap_tolerance). Discs that are near but not in the list touch without a
   * bond: their contact carries compression and friction, as after breakage, and is no crack. */
  const int64_t *given_bonds;
  int64_t given_bond_count;   /**< bonds in given_bonds */

  /** [Pa/m] Normal stiffness of smooth joints, per area. 0: contact.normal_stiffness over the mean disc
   * diameter. Default 0.0. */
  double smooth_joint_normal_stiffness;
  /** [Pa/m] Shear stiffness of smooth joints, per area. 0: contact.shear_stiffness over the mean disc
   * diameter. Default 0.0. */
  double smooth_joint_shear_stiffness;

  /** 0: bond, 1: plane. What the aperture of a broken bond is taken from. bond: the gap of its two discs,
   * eq. 7 as printed. plane: the opening across the local plane of the crack, with pipes as long as the
   * way along it, whatever the angle of the bond. Default 0. */
  int64_t flow_fracture_aperture;

  /** A bond does not break if that would cut fewer discs than this from the rest: a disc that no bond holds
   * stops the flow in the fracture it lies in. 1: every bond may break. Default 1. */
  int64_t bond_smallest_fragment;

  /** 0: bond, 1: facet, 2: auto. What a broken bond becomes. auto: a facet where a bond.fracture_toughness
   * above 0, a fracture.perforation_length or a rock.biot_coefficient below 1 is given and the case is one
   * that facets go with, else a contact as with bond. bond: a contact of its two discs (the paper). facet:
   * a face between two pores on which the rock's mean stress before the treatment is released, with
   * bond.fracture_toughness judged at tips by the openings behind them and strengths as given elsewhere;
   * stepping.mode coupled with solver.kind quasi-static, or substep and dynamic with explicit; with fluid
   * and without rough joints; with temperature in mode coupled only. Default 2. */
  int64_t fracture_law;
  /** [Pa] Law facet: E' = E / (1 - nu^2) of the rock at a tip, undrained where its pores are tight. With
   * bond.fracture_toughness 0 means: measured on the model's own packing under the far field, undrained.
   * Default 0.0. */
  double fracture_plane_modulus;

  /** [1] Share of the bonds, or 10 of them if that is more, that may break in the initial equilibration;
   * where more break the rock does not bear the far field, and no simulation is built. Default 0.01. */
  double initial_broken_fraction;

  /** [m] Law facet: slots of this length are cut into the wall of every hole, on two opposite sides, before
   * injection; fluid enters them freely. 0: none. Default 0.0. */
  double fracture_perforation_length;
  /** [rad] Direction of the slots, from the x axis, along which stress.sigma_Hmax acts. Default 0.0. */
  double fracture_perforation_azimuth;

  /** [1] Biot coefficient alpha: share of a pore's pressure that the rock around it bears, 1 - K / K_s.
   * Granite: 0.3 to 0.6. Below 1 needs fracture.law = facet. Default 1.0. */
  double rock_biot_coefficient;
  /** [1] Share of the rock that fluid fills, at most alpha. 0: the packing's, some 0.15. Default 0.0. */
  double rock_porosity;
  /** [Pa] Bulk modulus K_s of the grains, which store (alpha - porosity) / K_s per pressure beside the
   * fluid's porosity / K_f. 0: grains that do not give. Default 0.0. */
  double rock_grain_modulus;

  /** [1] Mean disc radius far from where fractures go over that along them; disc_count is the number of all
   * discs, and the fine ones' radius follows. 1: the same everywhere. Above 1 with method relaxed only.
   * Default 1.0. */
  double packing_coarsening;
  /** [m] Coarsening above 1: discs are fine along a line of this half length through the centre of every
   * well (without wells, of the model). 0: as far as stop.extent_fraction lets a fracture grow. Default
   * 0.0. */
  double packing_fine_half_length;
  /** [m] Coarsening above 1: discs are fine within this distance of that line. 0: a twentieth of the
   * smaller model side. Default 0.0. */
  double packing_fine_half_width;
  /** [rad] Coarsening above 1: direction of that line, from the x axis, along which stress.sigma_Hmax acts.
   * Default 0.0. */
  double packing_fine_azimuth;
  /** [1] Coarsening above 1: metres that the mean radius grows by per metre beyond that distance, up to
   * coarsening times the fine discs'. Default 0.1. */
  double packing_radius_growth;

  /** [Pa] Kind infinite: E' = E / (1 - nu^2) of the rock beyond. 0: measured on the model's own packing at
   * its far field, and undrained where the model has flow. Default 0.0. */
  double boundary_exterior_modulus;
  /** [1] Kind infinite: Poisson's ratio of the rock beyond in plane strain; with boundary.exterior_modulus
   * only. Default 0.0. */
  double boundary_exterior_poisson_ratio;
  /** [m] Kind infinite: distance from the model's middle at which the pores have the formation pressure;
   * fluid flows there steadily through rock of the model's permeability. 0: at the outermost discs.
   * Default 0.0. */
  double boundary_flow_distance;

  /** 0: given, 1: water. given: fluid.viscosity, fluid.bulk_modulus and thermal.fluid_density. water: all
   * three are those of water (IAPWS R12-08 and R7-97) at thermal.rock_temperature and
   * fluid.formation_pressure; with thermal.mode other than off all three follow every pore's temperature,
   * step by step. Default 0. */
  int64_t fluid_kind;

  /** 0: round, 1: flat. round: a contact bears no moment. flat: one as wide as the bond, which opens from
   * one edge and hinders rolling (flat joint without bond, Potyondy 2012); with fracture.law = bond.
   * Default 0. */
  int64_t contact_shape;

  /** [1] Share of contacts drawn at random that are never bonded, closed cracks of the rock; every disc
   * keeps three bonds, so that a little less than asked come of large shares. Default 0.0. */
  double bond_open_share;
  /** [J/m2] Energy G_c that a bond takes per area while it softens beyond its strength; K_Ic^2 = E' G_c
   * where discs are small against E' G_c / sigma_c^2. 0: bonds break at their strength. With fracture.law
   * = bond. Default 0.0. */
  double bond_fracture_energy;

  /** [Pa s] Viscosity of a second fluid, which wells pump where their fluid is second; it displaces the
   * first. 0: there is none. Default 0.0. */
  double fluid_second_viscosity;
  /** [kg/m3] Density of the second fluid in wellbore and perforations. 0: that of the first. Default 0.0. */
  double fluid_second_density;

  /** 0: own, 1: petsc. quasi-static: whose factor of the tangent preconditions. own: hfrac's, shared by
   * ranks with the bits of one. petsc: MUMPS's through PETSc, shared, too. Default 0. */
  int64_t solver_factor;

  /** 0: cpu, 1: gpu, 2: auto. What runs the cycles of the explicit solver; results do not depend on it.
   * cpu: the processor. gpu: a card, by libhfrac_gpu; refused where there is none or the case has what
   * cards do not run (solver.kind quasi-static, fracture.law facet, boundary.kind infinite, several
   * ranks). auto: a card where there is one and the case allows it, else the processor. Default 0. */
  int64_t run_device;

  /** A file of hfrac_pack, from which the simulation begins instead of being packed and brought to rest, with the same result; {seed} in it
   * stands for model.seed. Case files give it relative to themselves (packing.file). Empty: the engine packs. */
  char packing_file[HFRAC_PATH_SIZE];

  /** 0: model, 1: discs. What is taken of packing.file. model: discs and their state at rest under the far
   * field. discs: the discs alone, which are brought to rest anew, so that stresses, rock and wells may be
   * others than those of the file. Default 0. */
  int64_t packing_reuse;

  /** Files that a snapshot's discs, bonds and flow are each cut into, with a PVTU file that lists them; the
   * processes of a run share the writing. 1: one VTU file each. Default 1. */
  int64_t output_pieces;
} hfrac_sim_def;

/** Defaults into `def`; `struct_size` is sizeof(hfrac_sim_def) in the caller. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_init(hfrac_sim_def *def, int32_t struct_size);

/** Ends the lists of `def` that belong to the library; they are empty then, and everything else stays. NULL and a definition
 * without such lists are fine. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_free(hfrac_sim_def *def);

/** Gives `to`, which hfrac_sim_def_init has filled, all values of `from` with lists of its own; lists that belonged to `to` end.
 * Given discs and bonds stay the caller's, shared by both. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_copy(const hfrac_sim_def *from, hfrac_sim_def *to);

/** Reads a TOML case file over `def`. Unknown keys, wrong types and values out of range are refused with file, line,
 * key, allowed range and the nearest known key (HFRAC_ERR_CASE_FILE); `def` is then unchanged. A well's record (schedule_file) becomes
 * entries of the schedule; def->log hears of how many rows (HFRAC_LOG_INFO). Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_load(hfrac_sim_def *def, const char *path);

/** Adds a joint for each trace of the file `path`, as [[joint]] file does: a table with the columns START_X, START_Y, END_X and END_Y, or
 * GeoJSON (.geojson, .json), in m. All values but the ends have their defaults; the host may change them in place. What is no trace
 * is refused with file and line (HFRAC_ERR_CASE_FILE); `def` is then unchanged. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_def_add_traces(hfrac_sim_def *def, const char *path);

/** The definition as a TOML text with every option filled in, but for a well those of its wellbore that are at their default;
 * loading it gives the same definition. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_write(const hfrac_sim_def *def, char *buffer, int32_t capacity, int32_t *needed);

/** Refuses what cannot be built: values out of range, contradictory stresses, wells outside the model or
 * overlapping, and so on; the text (hfrac_last_error(NULL, ...)) names the fix. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_check(const hfrac_sim_def *def);
/** The same for a definition that was read from the case file `path`: the text begins with the file, and with the line of the
 * first value it names that the file has (HFRAC_ERR_CASE_FILE). Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_def_check_file(const hfrac_sim_def *def, const char *path);

/** Mean radius [m] of the discs of the packing where they are fine, and where they are coarsest (packing.coarsening); in a uniform
 * packing both are the mean of all. As foreseen: the packing's own are within a hundredth (hfrac_sim_get_setup). Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_def_disc_radii(const hfrac_sim_def *def, double *fine, double *coarsest);

/** Sets an option by its key, e.g. "bond.tensile_strength", "well[0].pressure", "joint[0].x1" or "schedule[0].time". The first
 * value of the well, joint or entry after the last one adds it; a well's centre is then the model's, as wide and high as it is
 * at that moment. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_set_f64(hfrac_sim_def *def, const char *key, double value);
/** Sets an integer option, or a choice by its index. "well_count", "joint_count", "schedule_count": makes the list that long, as
 * the library's own; items added have the keys' defaults. Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_set_i64(hfrac_sim_def *def, const char *key, int64_t value);
/** Sets a choice by its word, or "title". Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_set_str(hfrac_sim_def *def, const char *key, const char *value);
/** Reads an option by its key as a double (integers and choices are converted). Stable since 0.1. */
HFRAC_API int32_t hfrac_sim_def_get_f64(const hfrac_sim_def *def, const char *key, double *value);
/** Reads an integer option, a choice's index, or "well_count", "joint_count", "schedule_count"; a real one is refused, since it would lose its fraction.
 * Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_def_get_i64(const hfrac_sim_def *def, const char *key, int64_t *value);
/** Reads any option as text: a choice's word, "title", numbers with all their digits, so that setting or loading the text
 * gives the value back bit for bit. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_def_get_str(const hfrac_sim_def *def, const char *key, char *buffer,
                                                 int32_t capacity, int32_t *needed);

/** What the table says of one option. Texts point into the library and live as long as it is loaded. */
typedef struct hfrac_option_info {
  int32_t struct_size;    /**< set by the caller before the call */
  int32_t type;           /**< 0 double, 1 integer, 2 choice */
  const char *key;        /**< "section.name" */
  const char *unit;       /**< SI unit, "1" for none */
  const char *choices;    /**< words split by '|', NULL unless a choice */
  const char *help;       /**< one sentence */
  double default_value;   /**< default; the index for a choice */
  double minimum;         /**< smallest value allowed */
  double maximum;         /**< largest value allowed */
} hfrac_option_info;

/** Number of options in the table. Stable since 0.1. */
HFRAC_API int32_t hfrac_option_count(int32_t *count);
/** Entry `index` (from 0) of the table. Stable since 0.1. */
HFRAC_API int32_t hfrac_option_at(int32_t index, hfrac_option_info *info);

/** Number of values a well has. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_option_count(int32_t *count);
/** Entry `index` (from 0) of a well's values; its key is "radius" where the keyed functions take "well[0].radius".
 * Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_well_option_at(int32_t index, hfrac_option_info *info);

/** Number of values a joint has. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_joint_option_count(int32_t *count);
/** Entry `index` (from 0) of a joint's values; its key is "x1" where the keyed functions take "joint[0].x1". Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_joint_option_at(int32_t index, hfrac_option_info *info);
/** Number of values a schedule's entry has. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_schedule_option_count(int32_t *count);
/** Entry `index` (from 0) of the values of a schedule's entry; its key is "time" where the keyed functions take
 * "schedule[0].time". Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_schedule_option_at(int32_t index, hfrac_option_info *info);

#ifdef __cplusplus
}
#endif
#endif
