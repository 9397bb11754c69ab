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
 * 1 one value for the model; 2 the wells, unstructured points; 3 once bmi_hfrac_set_grid has laid it, a framework's cells,
 * uniform_rectilinear, whose nodes are the middles of cells. A bond stays an edge when it breaks.
 *
 * Pointers of get_value_ptr stay the same until finalize; what they point to follows every update and every set_value.
 * update takes one step of stepping.flow_step; update_until takes as many as fit and a shorter one to end where it is told.
 * Stop conditions of the case (stop.*) are left to the framework. get_var_type names C types: "double", "int", "long".
 */
#ifndef BMI_HFRAC_H
#define BMI_HFRAC_H

#include <bmi.h>

/* The C++ face of the BMI (bmi.hxx) names constants as bmi.h names macros. In C++ these are constants here, too, so that both
 * headers can be used in one file, in either order. */
#if defined(__cplusplus)
#undef BMI_SUCCESS
#undef BMI_FAILURE
#undef BMI_MAX_UNITS_NAME
#undef BMI_MAX_TYPE_NAME
#undef BMI_MAX_COMPONENT_NAME
#undef BMI_MAX_VAR_NAME
enum {
  BMI_SUCCESS = 0,
  BMI_FAILURE = 1,
  BMI_MAX_UNITS_NAME = 2048,
  BMI_MAX_TYPE_NAME = 2048,
  BMI_MAX_COMPONENT_NAME = 2048,
  BMI_MAX_VAR_NAME = 2048
};
extern "C" {
#endif

#if defined(__GNUC__)
#define BMI_HFRAC_API __attribute__((visibility("default")))
#else
#define BMI_HFRAC_API
#endif

/** Fills `model` with this model's functions and returns it; NULL for NULL. */
BMI_HFRAC_API Bmi* register_bmi_hfrac(Bmi* model);

/** BMI has no texts for what went wrong; this copies the last one of `model` - before initialize and after it failed, the last one
 * of this thread - into `text` of `capacity` bytes, cut if it has to be. Returns BMI_FAILURE for NULL or no room. */
BMI_HFRAC_API int bmi_hfrac_last_error(const Bmi* model, char* text, int capacity);

/** Between initialize and finalize: lays `nx` by `ny` cells over the model, the first corner at `origin` (x, y) [m], each
 * `spacing` (dx, dy) [m] large, in place of earlier cells. From then on the model has grid 3 and the variables "cell_...":
 * boundary pressure (to be set), flow out of the model's edge and its conductance, leak-off, pressures, permeabilities.
 * Pointers that get_value_ptr gave out for earlier cells end. BMI_FAILURE: no model, NULL, or no such grid. */
BMI_HFRAC_API int bmi_hfrac_set_grid(Bmi* model, int nx, int ny, const double* origin, const double* spacing);

#if defined(__cplusplus)
}
#endif

#endif
