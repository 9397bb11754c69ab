/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * What smooth joints slipped, as a log with a cursor.
 *
 * A contact of a smooth joint gets an entry once its slip has gone on by 1e-5 of the mean disc diameter since its last one, and no
 * more than one for each increment of a step (mode "coupled"; in the others: each step). So entries of a contact add up to its slip, to within
 * that, and the log is part of the state: a step that is undone takes its entries with it. Events made of them: catalogue.h.
 */
#ifndef HFRAC_SLIP_H
#define HFRAC_SLIP_H

#include "crack.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a contact of a smooth joint slipped since its last entry. */
typedef struct hfrac_slip {
  int64_t id;           /**< from 0, in order of time, never reused */
  int64_t bond;         /**< index of the contact's bond */
  int64_t disc[2];      /**< indices of its discs */
  int64_t joint;        /**< index of the joint in the definition */
  int64_t step;         /**< step in which it slipped; 0: during the initial equilibration */
  double time;          /**< [s] end of the increment in which it slipped */
  double duration;      /**< [s] of that increment */
  double position[2];   /**< [m] of the contact, where it was bonded */
  double normal[2];     /**< unit normal of the joint, from disc 0 to disc 1 */
  double length;        /**< [m] of the joint that the contact stands for */
  double slip;          /**< [m] above 0: disc 1 moved along the normal turned by +90 degrees against disc 0 */
  double distance;      /**< [m] between the centres of its discs when they were bonded */
  double shear_modulus; /**< [Pa] of the rock, estimated from its bonds as if discs moved with the mean strain (Agnolin and Kruyt
                             2008): an upper bound */
} hfrac_slip;

/** Slips with id >= cursor, at most `capacity` of them; *next is the cursor for the next call. `slip_size` is sizeof(hfrac_slip) in
 * the caller. buffer NULL: only *count of what there is. HFRAC_ERR_ARGUMENT: a cursor outside the log. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_slips_since(hfrac_sim *sim, int64_t cursor, int32_t slip_size, hfrac_slip *buffer,
                                             int64_t capacity, int64_t *count, int64_t *next);

#ifdef __cplusplus
}
#endif
#endif
