/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * A reservoir simulator's grid: what its cells read of the model, and what they put into it.
 *
 * The host describes its areal grid once (hfrac_set_grid). Cells lie in the model's plane, in its coordinates; the grid may
 * be larger or smaller than the model, and turned. Cell (i, j), both from 0, has the index i + nx * j: i runs fastest, as in
 * Eclipse, and arrays read as (nx, ny) in Fortran.
 *
 * Out of the model, by cell: permeability of the cracks as a tensor, porosities, leak-off, pressures (hfrac_grid_cells), or
 * an Eclipse include file (hfrac_write_grdecl).
 *
 * Into the model, by cell:
 *   hfrac_set_boundary_pressure    what lies beyond the model's edge; fluid passes there as the pressures say (conservative)
 *   hfrac_set_cell_pressure   the rock's pores take the host's pressure; the fluid this takes is the host's to account for
 *   hfrac_set_cell_stress     stress on top of the far field, as tractions on the model's edge
 *   hfrac_set_cell_temperature  the rock's temperature, with thermal.mode "transport" (heat.h)
 * Without a temperature in the model a host's thermal stress comes in as stress.
 *
 * Fluid balance: injected + host = stored + leaked (hfrac_balance), to rounding, whatever the host does.
 */
#ifndef HFRAC_GRID_H
#define HFRAC_GRID_H

#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The host's areal grid. Set struct_size, and 0 what does not apply. Either regular cells (origin, dx, dy, angle) or
 * `corners`; nx and ny always. */
typedef struct hfrac_grid {
  int32_t struct_size; /**< sizeof(hfrac_grid) of the caller */
  int32_t struct_pad;  /**< 0 */
  int64_t nx;          /**< cells along i, from 1 */
  int64_t ny;          /**< cells along j, from 1 */
  double origin[2];    /**< [m] first corner of cell (0, 0), in the model's coordinates */
  double dx;           /**< [m] size of regular cells along i */
  double dy;           /**< [m] along j */
  double angle;        /**< [rad] from the model's x axis to the direction of i, anticlockwise */
  const double *corners; /**< NULL, or [m] x, y of the 4 corners of every cell: shape (2, 4, nx, ny), first index fastest;
                            (i, j), (i+1, j), (i+1, j+1), (i, j+1); convex; copied */
} hfrac_grid;

/** Lays the host's grid over the model, in place of an earlier one. Valid at any time after creation; the grid is no part of
 * the state and stays over restore and reject. HFRAC_ERR_ARGUMENT: a cell without area or not convex. Costs about as much as
 * one flow step. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_grid(hfrac_sim *sim, const hfrac_grid *grid);

/** How permeability is brought to the host's cells. */
enum hfrac_upscaling {
  HFRAC_UPSCALE_ODA = 0, /**< crack tensor (Oda 1985): fast; takes all cracks as connected, so an upper bound */
  HFRAC_UPSCALE_FLOW = 1 /**< flow through the cell's own pipes, linear pressure on its boundary (Durlofsky 1991) */
};

/** One cell of the host's grid as the model fills it. */
typedef struct hfrac_cell {
  double area;                /**< [m2] of the cell */
  double coverage;            /**< share of it that the model covers, 0 to 1 */
  double permeability[3];     /**< [m2] that the cracks add: xx, yy, xy in the model's axes, over the cell's whole area */
  double matrix_permeability; /**< [m2] of the rock between the cracks, over the part covered; 0 if not covered */
  double fracture_porosity;   /**< opening times length of the cracks over the cell's area */
  double matrix_porosity;     /**< pore volume of the network over area, of the part covered */
  double crack_length;        /**< [m] length of crack lines in the cell */
  double leak_off;            /**< [m2/s] from pores beside cracks into others, in the last step */
  double outflow;             /**< [m2/s] out of the model through its edge into this cell, in the last step */
  double pressure;            /**< [Pa] of pores beside no crack, mean by volume; formation pressure if there are none */
  double fracture_pressure;   /**< [Pa] of pores beside cracks, mean by opening; as `pressure` without cracks */
  int64_t crack_count;        /**< cracks with some length in the cell */
  double conductance;         /**< [m2/(Pa s)] of the pipes through the model's edge to this cell: `outflow` falls by so much for each
                                   Pa the cell's pressure (hfrac_set_boundary_pressure) is raised while the pores inside keep theirs;
                                   over a long step pores follow and it falls by less. At the apertures as they are now, those of the next step */
} hfrac_cell;

/** Every cell as it is now. `method`: enum hfrac_upscaling. `cell_size` is sizeof(hfrac_cell) in the caller. Copies up to
 * `capacity` cells in the grid's order; *count is nx * ny. buffer NULL: only *count. The sum of `outflow` times the step's
 * duration is what hfrac_balance says has leaked in it. Dry models (flow.scheme "off") give 0 for what flows. Unstable since
 * 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_grid_cells(hfrac_sim *sim, int32_t method, int32_t cell_size, hfrac_cell *buffer,
                                            int64_t capacity, int64_t *count);

/** From the next step on, pressure [Pa, as stress.convention says] beyond the model's edge: every pipe there feels that of the
 * nearest cell of which the model covers less than half (of all cells, if it covers more of each). `count` values, one per cell
 * (nx * ny); only those cells are looked at. It stays as it is, absolute, whatever hfrac_set_formation_pressure says later,
 * until it is set anew or taken back: with count 0 (pressure may be NULL) the outer boundary feels the formation's pressure again. What passes
 * is `outflow` by cell and `leaked_volume` in all. The stress on the edge does not change. Part of the state; kept by the
 * tries of an open step. Needs flow.outer "formation". Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_boundary_pressure(hfrac_sim *sim, const double *pressure, int64_t count);

/** At once, gives the rock's pores the host's pressure [Pa, as stress.convention says]: each the mean of the cells it lies in, by
 * area. Pores beside cracks, wells, and pores outside the grid keep theirs; the rock answers in the next step. `count`
 * values, one per cell. `added` (may be NULL; `capacity` at least count) gets the fluid [m2] that each cell gave, negative:
 * took; their sum goes to `host_volume` of hfrac_balance. HFRAC_ERR_ARGUMENT while a step is open. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_cell_pressure(hfrac_sim *sim, const double *pressure, int64_t count, double *added,
                                                   int64_t capacity);

/** From the next step on, stress [Pa, compression positive] on top of the far field: xx, yy, xy of every cell, shape (3, nx,
 * ny), `count` values in all. It acts as traction on the model's edge, by the cell each disc of the edge lies in or
 * is nearest to; inside, the model finds its own. What net force and moment the tractions have is taken out (a host balances
 * it by forces in the volume). Zeros take it away. Kept by the tries of an open step. Needs boundary.kind "stress". Unstable
 * since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_cell_stress(hfrac_sim *sim, const double *stress, int64_t count);

/** What an include file holds. Not both in one model: the cracks would count twice. */
enum hfrac_grdecl_kind {
  HFRAC_GRDECL_PERM = 0, /**< PERMX, PERMY [mD], PORO: rock and cracks together */
  HFRAC_GRDECL_MULT = 1  /**< MULTX, MULTY, MULTPV: how far the cracks raise transmissibilities and pore volume */
};

/** Writes an include file for the GRID section of an Eclipse deck, cells in Eclipse's order, the areal grid repeated for
 * `layers` (from 1) layers. `method`: enum hfrac_upscaling; `kind`: enum hfrac_grdecl_kind. `porosity` (0 to 1) and
 * `permeability` [m2] are the host's own of the rock; 0: the network's. PERMX and PERMY are along the cell's i and j; a
 * tensor's off-diagonal part has no place there and is left out, as the file says. Cells the model does not cover get the
 * rock's values and multipliers of 1; rock the host gives no value for and no cell covers takes the mean of the covered cells.
 * The file appears whole or not at all (written aside, synced, renamed). HFRAC_ERR_FILE: it cannot be written.
 * Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_write_grdecl(hfrac_sim *sim, const char *path, int32_t method, int32_t kind,
                                              int64_t layers, double porosity, double permeability);

#ifdef __cplusplus
}
#endif
#endif
