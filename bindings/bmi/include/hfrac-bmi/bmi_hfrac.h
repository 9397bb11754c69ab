/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * hfrac behind the Basic Model Interface (BMI 2.0), for frameworks that speak it.
 *
 *   Bmi model;
 *   register_bmi_hfrac(&model);
 *   model.initialize(&model, "case.toml");
 *   model.update_until(&model, 0.1);
 *   model.finalize(&model);
 *
 * The configuration file is a case file. SI units, unit thickness. Any number of models, on any threads, one thread at a
 * time each.
 *
 * Grids: 0 the rock, unstructured: discs are its nodes, bonds its edges, domains (pores, holes of wells) its faces;
 * 1 one value for the model; 2 the wells, unstructured points. A bond stays an edge when it breaks.
 *
 * Pointers of get_value_ptr stay the same until finalize; what they point to follows every update and every set_value.
 * update takes one step of stepping.flow_step; update_until takes as many as fit and a shorter one to end where it is told.
 * Stop conditions of the case (stop.*) are left to the framework.
 */
#ifndef BMI_HFRAC_H
#define BMI_HFRAC_H

#if defined(__cplusplus)
extern "C" {
#endif

#include <bmi.h>

#if defined(__GNUC__)
#define BMI_HFRAC_API __attribute__((visibility("default")))
#else
#define BMI_HFRAC_API
#endif

/** Fills `model` with this model's functions and returns it; NULL for NULL. */
BMI_HFRAC_API Bmi* register_bmi_hfrac(Bmi* model);

/** BMI has no texts for what went wrong; this copies the last one of `model` into `text` of `capacity` bytes, cut if it
 * has to be. Returns BMI_FAILURE for NULL or no room. */
BMI_HFRAC_API int bmi_hfrac_last_error(const Bmi* model, char* text, int capacity);

#if defined(__cplusplus)
}
#endif

#endif
