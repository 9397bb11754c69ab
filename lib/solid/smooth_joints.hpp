// SPDX-License-Identifier: BSD-3-Clause
// Smooth joints: planes along which discs slide past each other, whatever the packing.
//
// A joint of weakened contacts is as rough as the packing, since each contact looks along the line of its two discs. In the
// smooth-joint law (Pierce, Cundall, Potyondy and Mas Ivars 2007; Mas Ivars et al. 2011) a contact that the joint crosses looks
// along the joint's own normal n instead, with t = n turned by 90 degrees:
//   opening   U_n = U.n,   slide  U_s = U.t,   U = u_j + theta_j x r_j - u_i - theta_i x r_i
//             the displacement of the two faces at the contact; r from a disc's centre to it
//   holds     F_n = k_n A U_n, F_s = k_s A U_s;   breaks at F_n >= T A (tension) or |F_s| >= c A + mu max(0, -F_n) (shear)
//   broken    N = A sigma_n(D - U_n), S = k_s A (U_s - slip), |S| <= mu N
//             sigma_n, mu and the dilation D by the joint's law (model/joint_law.hpp); as given by no more than the joint's line:
//             N = k_n A max(0, -U_n), a constant mu, no dilation
//   forces    on i: F_n n + F_s t, on j the opposite; moments r x force
// There is one contact per bond that the joint crosses, or that it was led across (discs_on_one_bond.hpp). A is its piece of the joint and it lies in the middle of that; pieces add up
// to the joint, so k_n, k_s, T and c are per area, free of disc size, and they are cut where the faces of the discs end, so that
// pressure on the joint hardly turns the discs (where the lines of the two centres meet the joint it would break their bonds).
// Both discs see the joint as it was at bonding: planes do not turn with the rock, and the pairs across it stay the ones of the
// set-up. Slides up to a mean radius are within that (farthest_slide, Simulation refuses more).
//
// In the step loop a contact answers in place of its bond, with the bonds of its tile (kernels.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/assembly.hpp"
#include "options/options.hpp"
#include "solid/bond_law.hpp"
#include "solid/kernels.hpp"

namespace hfrac {

// What a contact answers to the displacements as they stand.
struct SmoothResponse {
  double opening, slide;                     // m
  double normal, shear;                      // N; tension positive
  double slipped;                            // m, slip after it
  double normal_stiffness, shear_stiffness;  // N/m, of the tangent: 0 where open, or sliding
  double shear_by_opening;                   // N/m, where sliding
  double normal_by_slide;                    // N/m, where dilating
  double shear_limit = 0.0;                  // N, what friction bears; 0 where the contact holds or is open
};

// `joint_of`: the joint each bond belongs to, -1 of none. `idle`: bonds whose contacts get next to no piece of it, if others are near, ascending.
// Fills assembly.smooth, if any is smooth; what moved is there before.
void begin_smooth_joints(Assembly& assembly, const std::vector<JointOptions>& joints,
                         const std::vector<std::int32_t>& joint_of, const std::vector<std::int64_t>& idle,
                         const Options& options);

// What a contact of a joint bears: the part that its faces do, so the effective stress. Compression positive; shear as the slide.
struct JointStress {
  double normal = 0.0, shear = 0.0;  // Pa
};

// Rock at rest: what a packing's contacts bear scatters along a joint by factors, and what stress there is in the rock does not. So joints
// that conduct count their openings and slides from now on from where the stress `wanted`, one per contact (frac/joint_stress.hpp), would
// have left them; what each contact bears beyond that stays as a force on its discs (as facets do it, frac/facets.hpp).
void settle_smooth(Assembly& assembly, const std::vector<JointStress>& wanted);

double smooth_opening(const Assembly& assembly, const SmoothContact& contact);  // m, U_n
// Opening of the broken joint a bond belongs to, across the joint [m]; 0 if closed or of no joint.
double joint_opening(const Assembly& assembly, std::int64_t bond);
SmoothResponse smooth_response(const Assembly& assembly, const SmoothContact& contact);
BondView view_smooth(const Assembly& assembly, const SmoothContact& contact);
// Farthest slide of a contact [m], and which (nullptr: there are none), of those whose first disc is among [first_disc, last_disc).
const SmoothContact* farthest_slide(const Assembly& assembly, double& slide, std::int64_t first_disc,
                                    std::int64_t last_disc);
inline const SmoothContact* farthest_slide(const Assembly& assembly, double& slide) {
  return farthest_slide(assembly, slide, 0, assembly.disc_count());
}

// For the explicit solver.
// Whether the kernels know the laws of all contacts, and those laws, by SmoothJoints::law_number. They do not where temperature or size
// changes them, or friction and dilation follow the slip.
bool kernels_know(const Assembly& assembly);
Array<SmoothLaw> laws_for_kernels(const Assembly& assembly);
// Otherwise: a contact's forces, and what it slid to the displacements as they stand. Adds friction work to `friction`.
SmoothForces answer_of(const Assembly& assembly, const SmoothContact& contact, double& slip,
                       double& friction);
// Their part of the row sums that set the stable step.
void add_smooth_stiffness(const Assembly& assembly, std::span<double> row_x, std::span<double> row_y,
                          std::span<double> row_rotation);

}  // namespace hfrac
