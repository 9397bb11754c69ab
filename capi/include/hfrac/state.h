/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Going back: images of the state in memory and in files, steps that may be rejected, and a host that changes what acts from
 * outside.
 *
 * A host that couples iteratively uses the three-part step:
 *
 *   hfrac_step_prepare(sim);
 *   do { ... set wells or far field ...; hfrac_step_do(sim, dt); ... } while (not content, perhaps with a smaller dt);
 *   hfrac_step_finalize(sim);            or hfrac_step_reject(sim) to go back to where prepare was called
 *
 * Every hfrac_step_do starts from where prepare was called. hfrac_step_more goes on from where the last one ended, so that a host's
 * step may be several of ours (a longer one first, then another) and still be rejected as one. While a step is open, hfrac_step, hfrac_advance and
 * hfrac_state_restore are refused (HFRAC_ERR_ARGUMENT).
 *
 * An image holds all that a run changes. Restored into the simulation it was taken from, or one created from the same
 * definition in another process, the run goes on bit for bit. It knows its format, its byte order, its length, its checksum
 * and its model (discs, wells, and the options of model, disc, contact, bond, boundary, fluid and flow; lengths of steps and
 * limits of a run may differ), and is refused with a text if one of them is wrong.
 */
#ifndef HFRAC_STATE_H
#define HFRAC_STATE_H

#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes an image needs now; it grows with the crack log. Stable since 0.1. */
HFRAC_API int32_t hfrac_state_size(const hfrac_sim *sim, int64_t *size);
/** Writes an image into the caller's `buffer` of `capacity` bytes; *size gets the bytes written. Stable since 0.1. */
HFRAC_API int32_t hfrac_state_save(const hfrac_sim *sim, void *buffer, int64_t capacity, int64_t *size);
/** Restores an image. One that is damaged, of another model or another format is refused and changes nothing. Wells added to a
 * living simulation (hfrac_well_add) come and go with it. Stable since 0.1. */
HFRAC_API int32_t hfrac_state_restore(hfrac_sim *sim, const void *image, int64_t size);

/** Saves an image as file `path`: beside it first (`path`.part), synced, then renamed. After a crash or a power cut there is
 * the old file or the new one; if it fails (HFRAC_ERR_FILE: no such folder, no rights, disk full) the old one is left and
 * nothing else. One writer per path at a time. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_state_save_file(const hfrac_sim *sim, const char *path);
/** Restores an image from a file. One that cannot be read, is cut, damaged, of another model, of another format or no image
 * at all is refused (HFRAC_ERR_FILE) and changes nothing. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_state_load_file(hfrac_sim *sim, const char *path);

/** Packs a model, brings it to rest under the far field and keeps it as file `path`, from which simulations begin that name it
 * (packing_file of hfrac_sim_def): on any number of ranks, with other wells' rates and pressures, schedules, viscosity, permeability,
 * toughness at tips, lengths of steps and outputs, and with the result they would have without it. A simulation that differs in what the
 * model was made from is refused (HFRAC_ERR_MODEL), with the first value that differs, the file's and what to do. The file holds about 200
 * bytes a disc, is replaced as hfrac_state_save_file does it, and is read by the version that wrote it. HFRAC_STOPPED: def->progress stopped
 * it, and there is no file. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_pack(const hfrac_sim_def *def, const char *path);

/** Opens a step: remembers the state. Stable since 0.1. */
HFRAC_API int32_t hfrac_step_prepare(hfrac_sim *sim);
/** Takes the open step, `duration` [s] of fluid time long, from where it was opened; wells and far field as they are set
 * now. May be called again. Status as hfrac_step. Stable since 0.1. */
HFRAC_API int32_t hfrac_step_do(hfrac_sim *sim, double duration);
/** Takes another step of `duration` [s] within the open one, from where the last hfrac_step_do or hfrac_step_more ended. Fails or
 * is stopped alone: what came before it stands. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_step_more(hfrac_sim *sim, double duration);
/** Closes the open step and keeps what the last hfrac_step_do gave and hfrac_step_more added. Stable since 0.1. */
HFRAC_API int32_t hfrac_step_finalize(hfrac_sim *sim);
/** Closes the open step and goes back to where it was opened, wells and far field included. Stable since 0.1. */
HFRAC_API int32_t hfrac_step_reject(hfrac_sim *sim);

/** From the next step on, another far-field stress [Pa], as stress.convention says; needs boundary.kind stress, or walls kept
 * on their servo. sigma_hmin must not exceed sigma_Hmax, nor with walls, which only push, be below the pressure in the pores outside
 * (HFRAC_ERR_ARGUMENT, nothing changes). Stable since 0.1. */
HFRAC_API int32_t hfrac_set_far_field(hfrac_sim *sim, double sigma_Hmax, double sigma_hmin);
/** From the next step on, another pressure [Pa, absolute, 0 to 1e10] in the pores outside the model, in both stress conventions; the
 * paper's other pressures stay net of fluid.formation_pressure as defined. Total far-field stresses stay as they are; pores
 * inside follow by flow. Where a host's grid has said what the outer boundary feels (hfrac_set_boundary_pressure), that stays until the host
 * takes it back; what lies beyond still changes then, and the load on the edge with it. Needs flow, and flow.outer formation.
 * With total stresses it must not exceed sigma_hmin where the far field acts, nor in either one leave walls to pull. Unstable
 * since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_set_formation_pressure(hfrac_sim *sim, double pressure);

#ifdef __cplusplus
}
#endif
#endif
