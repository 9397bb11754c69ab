/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Going back: images of the state, steps that may be rejected, and a host that changes the far field.
 *
 * A host that couples iteratively uses the three-part step:
 *
 *   hfrac_step_prepare(sim);
 *   do { ... set wells or far field ...; hfrac_step_do(sim, dt); ... } while (not content, perhaps with a smaller dt);
 *   hfrac_step_finalize(sim);            or hfrac_step_reject(sim) to go back to where prepare was called
 *
 * Every hfrac_step_do starts from where prepare was called. While a step is open, hfrac_step, hfrac_advance and
 * hfrac_state_restore are refused (HFRAC_ERR_ARGUMENT).
 *
 * An image holds all that a run changes. Restored into the simulation it was taken from, or one created from the same
 * definition in another process, the run goes on bit for bit.
 */
#ifndef HFRAC_STATE_H
#define HFRAC_STATE_H

#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes an image needs now; it grows with the crack log. Unstable since 0.1. */
HFRAC_API int32_t hfrac_state_size(const hfrac_sim *sim, int64_t *size);
/** Writes an image into the caller's `buffer` of `capacity` bytes; *size gets the bytes written. Unstable since 0.1. */
HFRAC_API int32_t hfrac_state_save(const hfrac_sim *sim, void *buffer, int64_t capacity, int64_t *size);
/** Restores an image. One that is damaged, of another model or another format is refused and changes nothing.
 * Unstable since 0.1. */
HFRAC_API int32_t hfrac_state_restore(hfrac_sim *sim, const void *image, int64_t size);

/** Opens a step: remembers the state. Unstable since 0.1. */
HFRAC_API int32_t hfrac_step_prepare(hfrac_sim *sim);
/** Takes the open step, `duration` [s] of fluid time long, from where it was opened; wells and far field as they are set
 * now. May be called again. Status as hfrac_step. Unstable since 0.1. */
HFRAC_API int32_t hfrac_step_do(hfrac_sim *sim, double duration);
/** Closes the open step and keeps what the last hfrac_step_do gave. Unstable since 0.1. */
HFRAC_API int32_t hfrac_step_finalize(hfrac_sim *sim);
/** Closes the open step and goes back to where it was opened, wells and far field included. Unstable since 0.1. */
HFRAC_API int32_t hfrac_step_reject(hfrac_sim *sim);

/** From the next step on, another far-field stress [Pa], as stress.convention says; needs boundary.kind stress, or walls kept
 * on their servo. sigma_hmin must not exceed sigma_Hmax. Unstable since 0.1. */
HFRAC_API int32_t hfrac_set_far_field(hfrac_sim *sim, double sigma_Hmax, double sigma_hmin);

#ifdef __cplusplus
}
#endif
#endif
