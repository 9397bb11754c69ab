/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Arrays of a simulation, self-describing: discs, bonds, pipes, domains and contacts of joints.
 *
 * Fields are flat, components innermost: position is x0 y0 x1 y1 ..., which Fortran reads as (2, n). Copying is the
 * plain way. A view borrows the library's own memory: it is valid until the next call that may change the simulation,
 * which raises the epoch; compare hfrac_epoch with the view's.
 *
 * Bonds and pipes have the same count and order: every bonded contact is crossed by one pipe. A bond keeps its
 * index when it breaks. Domains are faces of the contact graph; domain 0 is the outside (formation). Smooth joints have
 * one contact per bond that they cross, which stands for a piece of the joint; models without smooth joints have none, and
 * rough joints (HFRAC_JOINT_BONDED, HFRAC_JOINT_BROKEN) are bonds and cracks like others.
 */
#ifndef HFRAC_FIELD_H
#define HFRAC_FIELD_H

#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Fields: X(name, value, "name", "unit", location, dtype, components, "help").
 * location: 0 disc, 1 bond, 2 pipe, 3 domain, 4 corner of a domain (flat list), 5 contact of a smooth joint.
 * dtype: 0 double, 1 int32. */
#define HFRAC_FIELD_LIST(X)                                                                                        \
  X(HFRAC_DISC_POSITION, 0, "disc.position", "m", 0, 0, 2, "centre now")                                           \
  X(HFRAC_DISC_RADIUS, 1, "disc.radius", "m", 0, 0, 1, "radius")                                                   \
  X(HFRAC_DISC_DISPLACEMENT, 2, "disc.displacement", "m", 0, 0, 2, "since the end of the initial equilibration")                      \
  X(HFRAC_DISC_ROTATION, 3, "disc.rotation", "rad", 0, 0, 1, "since the end of the initial equilibration, anticlockwise")             \
  X(HFRAC_DISC_VELOCITY, 4, "disc.velocity", "m/s", 0, 0, 2, "velocity (dynamic mode; scaled in substep mode)")    \
  X(HFRAC_DISC_STRESS, 5, "disc.stress", "Pa", 0, 0, 3, "xx, yy, xy averaged over the disc's cell, from bond, contact and wall forces; compression positive") \
  X(HFRAC_DISC_INTACT_BONDS, 6, "disc.intact_bonds", "1", 0, 1, 1, "number of intact bonds")                       \
  X(HFRAC_DISC_TEMPERATURE, 7, "disc.temperature", "K", 0, 0, 1, "of the rock; thermal.rock_temperature without a temperature in the model") \
  X(HFRAC_BOND_DISCS, 20, "bond.discs", "1", 1, 1, 2, "indices of the two discs")                                  \
  X(HFRAC_BOND_STATE, 21, "bond.state", "1", 1, 1, 1, "0 intact, 1 broken in tension, 2 broken in shear, 3 never bonded")          \
  X(HFRAC_BOND_NORMAL_FORCE, 22, "bond.normal_force", "N", 1, 0, 1, "bond and contact together, per thickness, tension positive") \
  X(HFRAC_BOND_SHEAR_FORCE, 23, "bond.shear_force", "N", 1, 0, 1, "bond and contact together, per thickness")      \
  X(HFRAC_BOND_MOMENT, 24, "bond.moment", "N m", 1, 0, 1, "bending moment of the bond, per thickness")             \
  X(HFRAC_BOND_GAP, 25, "bond.gap", "m", 1, 0, 1, "opening of the contact since bonding, negative: pressed together") \
  X(HFRAC_PIPE_DOMAINS, 40, "pipe.domains", "1", 2, 1, 2, "domains left and right of the line from disc 0 to disc 1") \
  X(HFRAC_PIPE_APERTURE, 41, "pipe.aperture", "m", 2, 0, 1, "hydraulic aperture (eq. 7)")                          \
  X(HFRAC_PIPE_FLOW, 42, "pipe.flow", "m2/s", 2, 0, 1, "volume rate from the left to the right domain in the last step") \
  X(HFRAC_DOMAIN_PRESSURE, 60, "domain.pressure", "Pa", 3, 0, 1, "pressure, as stress.convention says")               \
  X(HFRAC_DOMAIN_VOLUME, 61, "domain.volume", "m2", 3, 0, 1, "fluid volume now")                                   \
  X(HFRAC_DOMAIN_CENTRE, 62, "domain.centre", "m", 3, 0, 2, "centroid of the polygon of disc centres")             \
  X(HFRAC_DOMAIN_KIND, 63, "domain.kind", "1", 3, 1, 1, "0 rock, 1 well, 2 outside")                               \
  X(HFRAC_DOMAIN_SATURATION, 67, "domain.saturation", "1", 3, 0, 1, "fluid saturation of the pore: volume of fluid over pore volume; below 1 where the pressure is at its floor, as near the tip of a fracture that opens faster than fluid arrives") \
  X(HFRAC_DOMAIN_TEMPERATURE, 66, "domain.temperature", "K", 3, 0, 1, "of the fluid; thermal.rock_temperature without a temperature in the model") \
  X(HFRAC_DOMAIN_SECOND_FLUID, 68, "domain.second_fluid", "1", 3, 0, 1, "share of the second fluid (fluid.second_viscosity) in what the pore holds; 0 without one") \
  X(HFRAC_DOMAIN_OFFSET, 64, "domain.corner_offset", "1", 3, 1, 1, "first corner of each domain in domain.corners; the next domain's is its end") \
  X(HFRAC_DOMAIN_CORNERS, 65, "domain.corners", "1", 4, 1, 1, "disc indices around each domain, anticlockwise (outside: clockwise)") \
  X(HFRAC_JOINT_NUMBER, 80, "joint.number", "1", 5, 1, 1, "the joint's place in the definition, from 0")            \
  X(HFRAC_JOINT_BOND, 81, "joint.bond", "1", 5, 1, 1, "the bond, and pipe, that the contact stands for; ascending") \
  X(HFRAC_JOINT_CONTACT_STATE, 82, "joint.state", "1", 5, 1, 1, "0 holds, 1 sticks, 2 slips (friction is used up), 3 open (faces bear nothing)") \
  X(HFRAC_JOINT_BEGIN, 83, "joint.begin", "m", 5, 0, 2, "one end of the contact's piece of the joint now, halfway between the faces") \
  X(HFRAC_JOINT_END, 84, "joint.end", "m", 5, 0, 2, "the other end")                                               \
  X(HFRAC_JOINT_OPENING, 85, "joint.opening", "m", 5, 0, 1, "how far the faces are apart since they bore nothing; negative: pressed together") \
  X(HFRAC_JOINT_MECHANICAL_APERTURE, 86, "joint.mechanical_aperture", "m", 5, 0, 1, "the joint's aperture plus opening, at least 0") \
  X(HFRAC_JOINT_HYDRAULIC_APERTURE, 87, "joint.hydraulic_aperture", "m", 5, 0, 1, "of its pipe, by the joint's law where it conducts; 0 in a dry model") \
  X(HFRAC_JOINT_SLIP, 88, "joint.slip", "m", 5, 0, 1, "net slip since the end of the initial equilibration; positive: seen across the joint the far side went left") \
  X(HFRAC_JOINT_NORMAL_STRESS, 89, "joint.normal_stress", "Pa", 5, 0, 1, "effective, of the joint's law; compression positive") \
  X(HFRAC_JOINT_SHEAR_STRESS, 90, "joint.shear_stress", "Pa", 5, 0, 1, "of the joint's law; positive: drives slip that is positive") \
  X(HFRAC_JOINT_PRESSURE, 91, "joint.pressure", "Pa", 5, 0, 1, "mean of the two pores it lies between, as stress.convention says") \
  X(HFRAC_JOINT_TOTAL_SLIP, 92, "joint.total_slip", "m", 5, 0, 1, "with what it slid in the initial equilibration: friction and dilation go by it")

#define HFRAC_FIELD_ENUM_(name, value, key, unit, location, dtype, components, help) name = value,
enum hfrac_field { HFRAC_FIELD_LIST(HFRAC_FIELD_ENUM_) HFRAC_FIELD_END_ = 0x7fffffff };
#undef HFRAC_FIELD_ENUM_

/** What a field is. Texts point into the library. */
typedef struct hfrac_field_desc {
  int32_t struct_size; /**< set by the caller before the call */
  int32_t field;       /**< enum hfrac_field */
  const char *name;    /**< e.g. "disc.position" */
  const char *unit;    /**< SI unit */
  const char *help;    /**< one phrase */
  int32_t location;    /**< 0 disc, 1 bond, 2 pipe, 3 domain, 4 corner, 5 contact of a joint */
  int32_t dtype;       /**< 0 double, 1 int32 */
  int32_t components;  /**< values per item */
  int32_t struct_pad;  /**< 0 */
  int64_t count;       /**< items now (values: count * components) */
  int64_t epoch;       /**< epoch of the simulation now */
} hfrac_field_desc;

/** Describes field `field` of `sim`. Stable since 0.1. */
HFRAC_API int32_t hfrac_field_info(const hfrac_sim *sim, int32_t field, hfrac_field_desc *desc);
/** The field of a name, e.g. "domain.pressure". Stable since 0.1. */
HFRAC_API int32_t hfrac_field_find(const char *name, int32_t *field);
/** Copies a double field; `capacity` and *count in values, components counted. destination NULL: only *count. Stable since 0.1. */
HFRAC_API int32_t hfrac_field_copy_f64(hfrac_sim *sim, int32_t field, double *destination, int64_t capacity, int64_t *count);
/** Copies an int32 field, likewise. Stable since 0.1. */
HFRAC_API int32_t hfrac_field_copy_i32(hfrac_sim *sim, int32_t field, int32_t *destination, int64_t capacity, int64_t *count);
/** Borrows a field: pointer to its first value, number of values, epoch at which it was taken. Stable since 0.1. */
HFRAC_API int32_t hfrac_field_view(hfrac_sim *sim, int32_t field, const void **data, int64_t *count, int64_t *epoch);
/** Raised by every call that may change the simulation; a view of an older epoch is stale. Stable since 0.1. */
HFRAC_API int32_t hfrac_epoch(const hfrac_sim *sim, int64_t *epoch);

#ifdef __cplusplus
}
#endif
#endif
