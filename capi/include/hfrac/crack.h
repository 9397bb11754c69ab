/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Cracks as a log with a cursor, fractures as objects.
 *
 * A crack is one broken bond; the log only grows, in order of breakage. A fracture is a set of cracks connected
 * through domains they share; fractures are found anew when asked for, the largest first.
 */
#ifndef HFRAC_CRACK_H
#define HFRAC_CRACK_H

#include "field.h"

#ifdef __cplusplus
extern "C" {
#endif

enum hfrac_crack_mode { HFRAC_CRACK_TENSION = 1, HFRAC_CRACK_SHEAR = 2 };

/** One broken bond. */
typedef struct hfrac_crack {
  int64_t id;          /**< from 0, in order of breakage, never reused */
  int64_t bond;        /**< index of the bond */
  int64_t disc[2];     /**< indices of the discs */
  int64_t step;        /**< step in which it broke; 0: during the initial equilibration */
  int64_t cycle;       /**< mechanical cycle in which it broke */
  double time;         /**< [s] model time of that step */
  double position[2];  /**< [m] middle of the contact now */
  double normal[2];    /**< unit vector from disc 0 to disc 1 now; the crack runs across it */
  double length;       /**< [m] length of the crack line (bond diameter) */
  double aperture;     /**< [m] mechanical opening now, 0 if closed */
  double normal_force; /**< [N] per thickness at failure, tension positive */
  double shear_force;  /**< [N] per thickness at failure */
  double energy;       /**< [J/m] elastic energy of the bond at failure; with bond.fracture_energy what it took */
  int32_t mode;        /**< enum hfrac_crack_mode */
  int32_t fracture;    /**< index of its fracture now, as hfrac_fractures gives them */
  double distance;     /**< [m] between the centres of its discs when they were bonded */
  double pressure;     /**< [Pa] now, mean of the pores it lies between; 0 in a dry model */
  double hydraulic_aperture; /**< [m] of its pipe now (eq. 7), which the cubic law takes; 0 in a dry model */
} hfrac_crack;

/** Cracks with id >= cursor, at most `capacity` of them; *next is the cursor for the next call. `crack_size` is
 * sizeof(hfrac_crack) in the caller. buffer NULL: only *count of what there is. Stable since 0.1. */
HFRAC_API int32_t hfrac_cracks_since(hfrac_sim *sim, int64_t cursor, int32_t crack_size, hfrac_crack *buffer,
                                     int64_t capacity, int64_t *count, int64_t *next);

/** One fracture. */
typedef struct hfrac_fracture {
  int64_t index;           /**< from 0, most cracks first */
  int64_t crack_count;     /**< cracks in it */
  int64_t tensile_cracks;  /**< of them in tension */
  double length;           /**< [m] longest way along it: from the two longest wings if it starts at a well, the hole left out */
  double extent;           /**< [m] largest distance between two of its crack ends */
  double reach;            /**< [m] farthest crack end from the wall of its well; 0 if not connected */
  double azimuth;          /**< [rad] direction of its long axis against x (sigma_Hmax), -pi/2 to pi/2 */
  double mean_aperture;    /**< [m] mechanical, weighted by crack length */
  double largest_aperture; /**< [m] the fracture's width */
  double volume;           /**< [m2] aperture times length, summed */
  double mean_pressure;    /**< [Pa] of the domains along it */
  int64_t well;            /**< index of the well it is connected to, -1 if none */
  int64_t wings;           /**< separate branches that start at its well; 1 if not connected to one */
} hfrac_fracture;

/** Finds the fractures as they are now and copies up to `capacity`; *count is how many there are. `fracture_size` is
 * sizeof(hfrac_fracture) in the caller; buffer NULL: only *count. Stable since 0.1. */
HFRAC_API int32_t hfrac_fractures(hfrac_sim *sim, int32_t fracture_size, hfrac_fracture *buffer, int64_t capacity,
                                  int64_t *count);

/** A place on the line of a fracture: one of its cracks. */
typedef struct hfrac_fracture_point {
  double position[2];        /**< [m] middle of the crack now */
  double distance;           /**< [m] along the line from the centre of the well, below 0 on wing 0; without a well from its middle */
  double length;             /**< [m] of the line that this crack stands for */
  double aperture;           /**< [m] mechanical opening now, 0 if closed */
  double hydraulic_aperture; /**< [m] that the cubic law takes; 0 in a dry model */
  double pressure;           /**< [Pa] now, mean of the pores it lies between; 0 in a dry model */
  double saturation;         /**< [1] share of these pores that fluid fills; 0 in a dry model */
  int64_t bond;              /**< bond that broke */
  int32_t wing;              /**< 0: towards smaller x (y, if the fracture stands upright), 1: the other; -1 without a well */
  int32_t tip;               /**< 1: the line ends here */
} hfrac_fracture_point;

/** A fracture as an ordered line, from the tip of one wing to that of the other: the longest ways from its well, or from end to
 * end if no well feeds it; side branches are left out. `fracture` is its index as hfrac_fractures gives it now; before anything
 * broke, fracture 0 has no points. Copies up to `capacity` points, *count is how many there are; `point_size` is
 * sizeof(hfrac_fracture_point) in the caller; buffer NULL: only *count. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_fracture_line(hfrac_sim *sim, int64_t fracture, int32_t point_size,
                                               hfrac_fracture_point *buffer, int64_t capacity, int64_t *count);

#ifdef __cplusplus
}
#endif
#endif
