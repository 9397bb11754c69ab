/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * A rock laboratory: standard tests on specimens of the rock a definition describes, and the way back, from what a rock is
 * known to have to the micro-parameters that give it.
 *
 * Of the definition only contacts, bonds, fluid and packing count; shape, wells, stresses and stepping do not. Nothing here
 * belongs to a simulation: errors are those of hfrac_last_error(NULL, ...). Tests are quasi-static, so no rate, mass or
 * damping enters. Specimens are made by the same packing as models; discs and seed decide, and give the same bits again.
 *
 * Elastic constants: a specimen between frictionless platens gives the slopes E' and nu' of the two-dimensional model,
 * eps_y = s_y / E', eps_x = -nu' s_y / E'. Read as plane strain of a three-dimensional rock: nu = nu' / (1 + nu'),
 * E = E' (1 - nu^2) (Timoshenko and Goodier, Theory of Elasticity).
 */
#ifndef HFRAC_LAB_H
#define HFRAC_LAB_H

#include "def.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The tests. What each gives as `value` of its report stands in brackets. */
enum hfrac_lab_test {
  HFRAC_LAB_ELASTIC = 0,           /**< square pressed by 1e-5: E in plane strain [Pa]; one linear solve where the rock is linear */
  HFRAC_LAB_TENSION = 1,           /**< direct tension, height twice the width: strength [Pa] */
  HFRAC_LAB_UNIAXIAL = 2,          /**< compression, height twice the width: UCS [Pa] */
  HFRAC_LAB_BIAXIAL = 3,           /**< the same under `confining` on the sides: axial stress at failure [Pa] */
  HFRAC_LAB_BRAZILIAN = 4,         /**< round disc pressed on two arcs of 30 degrees: indirect strength [Pa] (Hondros 1959) */
  HFRAC_LAB_CENTRE_CRACK = 5,      /**< plate with a slit in the middle, constant load: K_Ic [Pa m^0.5] */
  HFRAC_LAB_SENT = 6,              /**< plate slit from one side, constant load: K_Ic [Pa m^0.5] */
  HFRAC_LAB_PRESSURISED_CRACK = 7, /**< slit in the middle under fluid pressure: K_Ic [Pa m^0.5], and its opening */
  HFRAC_LAB_PERMEABILITY = 8       /**< of the unloaded network, mean of both directions [m2] */
};

/** Which test on which specimen. Fill with hfrac_lab_spec_init first. */
typedef struct hfrac_lab_spec {
  int32_t struct_size;  /**< sizeof(hfrac_lab_spec) of the caller, set by init */
  int32_t test;         /**< enum hfrac_lab_test; default HFRAC_LAB_ELASTIC */
  int64_t disc_count;   /**< discs packed, 100 to 2000000; default 2000 */
  int64_t seed;         /**< of the packing; default 1 */
  double width;         /**< [m] of the specimen; default 10. Sets the disc size, which K_Ic goes with */
  double confining;     /**< [Pa] on the sides, HFRAC_LAB_BIAXIAL, compression positive; default 0 */
  double slit_fraction; /**< length of a slit over the width, 0.05 to 0.6; default 0.3 */
} hfrac_lab_spec;

/** Defaults into `spec`; `struct_size` is sizeof(hfrac_lab_spec) in the caller. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_lab_spec_init(hfrac_lab_spec *spec, int32_t struct_size);

/** How a test ended. */
enum hfrac_lab_end {
  HFRAC_LAB_FAILED = 0,         /**< the specimen failed, as it should */
  HFRAC_LAB_LOAD_REACHED = 1,   /**< the load asked for was reached; the end of tests without failure */
  HFRAC_LAB_NO_EQUILIBRIUM = 2, /**< no equilibrium was found at the last load; values are those up to it */
  HFRAC_LAB_STOPPED = 3         /**< the progress callback asked for it; values are those up to then */
};

/** What a test found; 0 where a test has no such thing. Set struct_size before the call. */
typedef struct hfrac_lab_report {
  int32_t struct_size;          /**< sizeof(hfrac_lab_report) of the caller */
  int32_t end;                  /**< enum hfrac_lab_end */
  double value;                 /**< what the test is for, see enum hfrac_lab_test */
  double modulus;               /**< [Pa] E in plane strain */
  double poisson;               /**< nu in plane strain */
  double plane_modulus;         /**< [Pa] E', slope of the two-dimensional model */
  double plane_poisson;         /**< nu', likewise */
  double peak_stress;           /**< [Pa] largest stress (or fluid pressure) borne */
  double strain_at_peak;        /**< axial strain there, extension positive */
  double first_crack_stress;    /**< [Pa] at the first broken bond */
  double slit_half_length;      /**< [m] a: half the slit, or the depth of a notch, as cut between bonds */
  double geometry_factor;       /**< F of K = F sigma sqrt(pi a), or the Brazilian's sigma over P / D */
  double toughness_coefficient; /**< K_Ic over sigma_c sqrt(mean radius) */
  double permeability_x;        /**< [m2] along x */
  double permeability_y;        /**< [m2] along y */
  double zero_stress_aperture;  /**< [m] r0 in use (eq. 7) */
  double mean_radius;           /**< [m] of the discs packed */
  double coordination;          /**< bonds per disc times two */
  double force_ratio;           /**< largest mean unbalanced over mean contact force of all equilibria */
  double worst_overshoot;       /**< largest stress over strength less 1 at which a bond broke, up to the peak */
  double packing_seconds;       /**< wall time of the packing */
  double test_seconds;          /**< wall time of the test */
  int64_t disc_count;           /**< discs of the specimen */
  int64_t bond_count;           /**< bonds of the specimen */
  int64_t tensile_cracks;       /**< bonds broken in tension */
  int64_t shear_cracks;         /**< bonds broken in shear */
  int64_t factor_count;         /**< sparse factors computed */
  int64_t relaxation_count;     /**< equilibria that took the explicit solver */
} hfrac_lab_report;

/** One test done. Opaque. */
typedef struct hfrac_lab hfrac_lab;

/** Does a test. `progress` (may be NULL) is called now and then with the share 0 and what is done; nonzero ends the test, and
 * HFRAC_STOPPED comes back with what there is. *lab is to be destroyed; on failure it is NULL. HFRAC_ERR_ARGUMENT: the spec is
 * out of range; HFRAC_ERR_MODEL: no specimen comes of it. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_lab_run(const hfrac_sim_def *def, const hfrac_lab_spec *spec, hfrac_progress_fn progress, void *user,
                                hfrac_lab **lab);

/** Frees a test and sets *lab to NULL; NULL and *lab == NULL are fine. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_lab_destroy(hfrac_lab **lab);

/** What the test found. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_lab_get_report(const hfrac_lab *lab, hfrac_lab_report *report);

/** Tables of a test. Each row has as many values as stand in brackets. */
enum hfrac_lab_table {
  HFRAC_LAB_CURVE = 0,   /**< (7) load, stress [Pa], axial and lateral strain, largest stress over strength, tensile cracks, shear
                              cracks. The load is a strain between platens, else in units of 1 MPa */
  HFRAC_LAB_DISCS = 1,   /**< (5) x, y, radius at bonding, displacement x, y [m] */
  HFRAC_LAB_CRACKS = 2,  /**< (5) x, y of one end, x, y of the other [m], enum hfrac_crack_mode; in order of breakage */
  HFRAC_LAB_OPENING = 3  /**< (3) x from the slit's middle [m], opening [m], pressure it holds for [Pa]; pressurised crack only */
};

/** Copies up to `capacity` values of a table (enum hfrac_lab_table), row by row; *count is how many there are. buffer NULL: only
 * *count. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_lab_copy_f64(const hfrac_lab *lab, int32_t table, double *buffer, int64_t capacity, int64_t *count);

/** What a rock is to have; NaN: not asked. Fill with hfrac_targets_init first. */
typedef struct hfrac_targets {
  int32_t struct_size;          /**< sizeof(hfrac_targets) of the caller, set by init */
  int32_t plane_slopes;         /**< nonzero: modulus and poisson are E' and nu'; default 0, plane strain */
  double modulus;               /**< [Pa] */
  double poisson;               /**< 1 */
  double compressive_strength;  /**< [Pa] UCS */
  double tensile_strength;      /**< [Pa] direct */
  double toughness;             /**< [Pa m^0.5] K_Ic */
  double permeability;          /**< [m2] */
  int64_t packings;             /**< specimens a value is the mean of; default 4 */
  int64_t disc_count;           /**< of elastic and permeability specimens; default 4000 */
  int64_t strength_disc_count;  /**< of the others; default 2000 */
  int64_t seed;                 /**< of the first packing; default 1 */
} hfrac_targets;

/** Defaults into `targets`; `struct_size` is sizeof(hfrac_targets) in the caller. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_targets_init(hfrac_targets *targets, int32_t struct_size);

/** Number of values of hfrac_targets, in its order: E, nu, UCS, tensile strength, K_Ic, permeability. */
#define HFRAC_MACRO_COUNT 6

/** What a calibration came to. Arrays are in the order of hfrac_targets, NaN where not asked. Set struct_size before the call. */
typedef struct hfrac_calibration {
  int32_t struct_size;                   /**< sizeof(hfrac_calibration) of the caller */
  int32_t reached;                       /**< 1: all targets reached, within a tenth on other packings or two standard errors of their mean; 0: `text` says which not */
  double achieved[HFRAC_MACRO_COUNT];    /**< mean over as many packings again, not those calibrated on */
  double spread[HFRAC_MACRO_COUNT];      /**< standard deviation over them */
  double lowest[HFRAC_MACRO_COUNT];      /**< least that can be had with the other targets as they are; NaN: no bound known */
  double highest[HFRAC_MACRO_COUNT];     /**< most, likewise */
  double zero_stress_aperture;           /**< [m] r0 at the model's disc size, if permeability was asked */
  double toughness_coefficient;          /**< K_Ic over sigma_c sqrt(R), if K_Ic was asked */
  double seconds;                        /**< wall time */
  int64_t test_count;                    /**< tests done */
  char text[1024];                       /**< what could not be reached, and the nearest; empty if all was */
} hfrac_calibration;

/** Finds micro-parameters that give `targets`, starting from those of `def`, and puts them into it: stiffnesses of contacts and
 * bonds (their share of each other kept), strengths, flow.permeability, and packing.disc_count if both K_Ic and a strength are
 * asked (the two together fix the disc size). Targets that cannot be had give the nearest, reached 0 and HFRAC_OK.
 * `progress` as in hfrac_lab_run; stopped, HFRAC_STOPPED comes back and `def` is as it was. Unstable since 0.1. */
HFRAC_UNSTABLE_API int32_t hfrac_calibrate(hfrac_sim_def *def, const hfrac_targets *targets, hfrac_progress_fn progress, void *user,
                                  hfrac_calibration *calibration);

#ifdef __cplusplus
}
#endif
#endif
