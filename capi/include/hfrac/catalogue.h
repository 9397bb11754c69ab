/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * The seismic catalogue: cracks that broke together, and contacts of joints that slipped together, as events; their moments,
 * magnitudes and energies, and the b value.
 *
 * Cracks are what hfrac_cracks_since gives, or what a host has kept of them; no simulation is needed. Clustering after
 * Hazzard and Young (2000, 2004): cracks within `distance` of each other that broke within the windows of time and cycles
 * are linked, and what is linked is one event. Moment after Hazzard and Young (2002): force drop times lever arm, of the bonds
 * that broke; what discs around them shift afterwards is not in it, so moments are lower bounds. Energy is the elastic
 * energy of those bonds, more than what they radiate. Forces are per thickness of the plane: `thickness` makes them an event.
 * The mechanical cycles between two flow steps are no time (masses are scaled), so by default the step is the window.
 *
 * Slips are what hfrac_slips_since gives. Those within `distance` of each other in one increment (or within `time_window`) are one event,
 * over several joints where they meet. Its moment is G times length times slip times `thickness` (Aki and Richards 2002). ALL slip counts:
 * a quasi-static solver knows no speeds, so nothing tells fast slip, which shakes, from slow slip, which does not. Such moments are upper
 * bounds of what could be felt; most of the slip that injection causes can be slow (Guglielmi et al. 2015).
 */
#ifndef HFRAC_CATALOGUE_H
#define HFRAC_CATALOGUE_H

#include "crack.h"
#include "slip.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How cracks and slips make events. Set struct_size; zeros elsewhere are the defaults. */
typedef struct hfrac_catalogue_options {
  int32_t struct_size;  /**< sizeof(hfrac_catalogue_options) of the caller */
  int32_t struct_pad;   /**< 0 */
  double distance;      /**< [m] 0 or more; 0: twice the mean distance between the discs of the cracks (or slips) */
  double time_window;   /**< [s] 0 or more; 0: cracks of the same step only, slips of the same increment only */
  int64_t cycle_window; /**< 0 or more mechanical cycles; 0: no limit within the time window */
  double thickness;     /**< [m] of rock that the plane stands for; 0: 1 m */
  double shear_modulus; /**< [Pa] of the rock, for slips; 0: the one that each slip gives */
  double slip_rate;     /**< [m/s] 0 or more: slips slower than this, over their increment, are left out; 0: none. It says something
                             where increments are as short as slip is fast, so in mode "dynamic" */
} hfrac_catalogue_options;

/** What an event is made of. */
enum hfrac_event_kind { HFRAC_EVENT_CRACKS = 0, HFRAC_EVENT_SLIP = 1 };

/** One event. */
typedef struct hfrac_event {
  int64_t index;           /**< from 0, in order of the first crack or slip */
  int64_t first_crack;     /**< id of that crack; -1 of an event from slip */
  int64_t crack_count;     /**< cracks in it */
  int64_t tensile_cracks;  /**< of them in tension */
  int64_t first_cycle;     /**< mechanical cycle of its first break */
  int64_t last_cycle;      /**< and of its last */
  double time;             /**< [s] of its first crack or slip */
  double position[2];      /**< [m] mean place of its cracks or slips */
  double moment_tensor[3]; /**< [N m] xx, yy, xy; outward positive */
  double moment;           /**< [N m] sqrt(m_ij m_ij / 2) (Silver and Jordan 1982) */
  double magnitude;        /**< of the moment (Hanks and Kanamori 1979); NaN without one */
  double energy;           /**< [J] elastic energy of the broken bonds; 0 of an event from slip */
  double energy_magnitude; /**< 2/3 log10 energy - 2.9 (Choy and Boatwright 1995), an upper bound; NaN without energy */
  double isotropic_fraction; /**< -1 to 1 (Feignier and Young 1992, in the plane): 0.5 opens as one crack, 0 shears, below 0 closes */
  double length;           /**< [m] summed over its cracks, or over its contacts that slipped */
  double radius;           /**< [m] from its position to the farthest of its cracks or slips */
  int32_t kind;            /**< enum hfrac_event_kind */
  int32_t pad;             /**< 0 */
  int64_t first_slip;      /**< id of its first slip; -1 of an event from cracks */
  int64_t slip_count;      /**< slips in it */
  double slip;             /**< [m] mean over its length; 0 of an event from cracks */
  double duration;         /**< [s] from its first crack or slip to its last */
} hfrac_event;

/** The events of `crack_count` cracks, given in order of breakage. `crack_size` and `event_size` are the sizes of the two
 * structs in the caller. options NULL: the defaults. Copies up to `capacity` events; *count is how many there are; buffer NULL:
 * only *count. Needs no simulation; any thread. HFRAC_ERR_ARGUMENT: a value that is not finite, or negative where it must
 * not be. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_find_events(const hfrac_crack *cracks, int32_t crack_size, int64_t crack_count,
                                    const hfrac_catalogue_options *options, int32_t event_size, hfrac_event *buffer,
                                    int64_t capacity, int64_t *count);

/** The events of `slip_count` slips, given in order of time; otherwise as hfrac_find_events. Slips of the initial equilibration (step 0) are
 * no events. `cycle_window` is not used. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_find_slip_events(const hfrac_slip *slips, int32_t slip_size, int64_t slip_count,
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
