/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The seismic catalogue: cracks that broke together as one event, its moment, magnitude and energy, and the b value.
 *
 * Cracks are what hfrac_cracks_since gives, or what a host has kept of them; no simulation is needed. Clustering after
 * Hazzard and Young (2000, 2004): cracks within `distance` of each other that broke within the windows of time and cycles
 * are linked, and what is linked is one event. Moment after Hazzard and Young (2002): force drop times lever arm, of the bonds
 * that broke; what discs around them shift afterwards is not in it, so moments are lower bounds. Energy is the elastic
 * energy of those bonds, more than what they radiate. Forces are per thickness of the plane: `thickness` makes them an event.
 * The mechanical cycles between two flow steps are no time (masses are scaled), so by default the step is the window.
 */
#ifndef HFRAC_CATALOGUE_H
#define HFRAC_CATALOGUE_H

#include "crack.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How cracks make events. Set struct_size; zeros elsewhere are the defaults. */
typedef struct hfrac_catalogue_options {
  int32_t struct_size;  /**< sizeof(hfrac_catalogue_options) of the caller */
  int32_t struct_pad;   /**< 0 */
  double distance;      /**< [m] 0 or more; 0: twice the mean distance between the discs of the cracks */
  double time_window;   /**< [s] 0 or more; 0: cracks of the same step only */
  int64_t cycle_window; /**< 0 or more mechanical cycles; 0: no limit within the time window */
  double thickness;     /**< [m] of rock that the plane stands for; 0: 1 m */
} hfrac_catalogue_options;

/** One event. */
typedef struct hfrac_event {
  int64_t index;           /**< from 0, in order of the first crack */
  int64_t first_crack;     /**< id of that crack */
  int64_t crack_count;     /**< cracks in it */
  int64_t tensile_cracks;  /**< of them in tension */
  int64_t first_cycle;     /**< mechanical cycle of its first break */
  int64_t last_cycle;      /**< and of its last */
  double time;             /**< [s] of its first crack */
  double position[2];      /**< [m] mean place of its cracks */
  double moment_tensor[3]; /**< [N m] xx, yy, xy; outward positive */
  double moment;           /**< [N m] sqrt(m_ij m_ij / 2) (Silver and Jordan 1982) */
  double magnitude;        /**< of the moment (Hanks and Kanamori 1979); NaN without one */
  double energy;           /**< [J] elastic energy of the broken bonds */
  double energy_magnitude; /**< 2/3 log10 energy - 2.9 (Choy and Boatwright 1995), an upper bound; NaN without energy */
  double isotropic_fraction; /**< -1 to 1 (Feignier and Young 1992, in the plane): 0.5 opens as one crack, 0 shears, below 0 closes */
  double length;           /**< [m] summed over its cracks */
  double radius;           /**< [m] from its position to the farthest of its cracks */
} hfrac_event;

/** The events of `crack_count` cracks, given in order of breakage. `crack_size` and `event_size` are the sizes of the two
 * structs in the caller. options NULL: the defaults. Copies up to `capacity` events; *count is how many there are; buffer NULL:
 * only *count. Needs no simulation; any thread. HFRAC_ERR_ARGUMENT: a value that is not finite, or negative where it must
 * not be. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_find_events(const hfrac_crack *cracks, int32_t crack_size, int64_t crack_count,
                                    const hfrac_catalogue_options *options, int32_t event_size, hfrac_event *buffer,
                                    int64_t capacity, int64_t *count);

/** The index of the event that each crack belongs to, as hfrac_find_events numbers them: up to `capacity` indices, in the
 * order of the cracks, into `buffer`; *count is crack_count. Needs no simulation; any thread. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_find_event_of_cracks(const hfrac_crack *cracks, int32_t crack_size, int64_t crack_count,
                                             const hfrac_catalogue_options *options, int64_t *buffer, int64_t capacity,
                                             int64_t *count);

/** The law log10 N = a - b M of Gutenberg and Richter, N the events of magnitude M or more. */
typedef struct hfrac_magnitude_law {
  int32_t struct_size; /**< sizeof(hfrac_magnitude_law) of the caller */
  int32_t struct_pad;  /**< 0 */
  double completeness; /**< magnitude from which on events are counted */
  double b;            /**< log10 e / (mean magnitude - completeness) (Aki 1965); 0: fewer than two different magnitudes */
  double b_error;      /**< b / sqrt(count), its standard error (Aki 1965) */
  double a;            /**< log10 of the events from magnitude 0 on that the law gives */
  int64_t count;       /**< events at or above completeness */
} hfrac_magnitude_law;

/** The law of `magnitude_count` magnitudes; those that are not finite are left out. completeness NaN: the fullest tenth
 * of a magnitude (maximum curvature, Wiemer and Wyss 2000). Set law->struct_size. Needs no simulation; any thread.
 * Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_find_magnitude_law(const double *magnitudes, int64_t magnitude_count, double completeness,
                                           hfrac_magnitude_law *law);

#ifdef __cplusplus
}
#endif
#endif
