// SPDX-License-Identifier: BSD-3-Clause
// Contacts of smooth joints in the kernels (kernels_body.hpp): they answer in place of their bonds, four at a time, by the law of
// smooth_joints.hpp where it has no dilation and a constant friction, else with forces found before.
#pragma once

#include "solid/kernels_chunk.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// SmoothContact, read as two rows of four.
struct SmoothRecord {
  int32_t bond, joint;
  double values[7];
};

// Four contacts of smooth joints, by the law of solid/smooth_joints.hpp, in place of their bonds, which are e + lane[].
inline __attribute__((always_inline)) void answer_four(const KernelArrays& a,
                                                       const SmoothRecord* const* contact,
                                                       const int64_t* lane, int64_t e, Chunk& c) {
  const Quad zero = {0.0, 0.0, 0.0, 0.0}, one = {1.0, 1.0, 1.0, 1.0};
  const auto row = [&](int64_t w, int64_t part) -> const Quad& {
    return reinterpret_cast<const Quad*>(contact[w])[part];
  };
  const auto law = [&](int64_t w, int64_t part) -> const Quad& {
    return reinterpret_cast<const Quad*>(a.smooth.laws + a.smooth.law_number[contact[w]->joint])[part];
  };
  const auto gather = [&](const double* of, Quad& to) {
    to = Quad{of[lane[0]], of[lane[1]], of[lane[2]], of[lane[3]]};
  };
  const auto put = [&](double* to, const Quad& values) {
    for (int64_t w = 0; w < 4; ++w) to[lane[w]] = values[w];
  };
  Quad bonds = row(0, 0), nx = row(1, 0), ny = row(2, 0), area = row(3, 0);
  transpose(bonds, nx, ny, area);
  Quad opens_i = row(0, 1), opens_j = row(1, 1), slides_i = row(2, 1), slides_j = row(3, 1);
  transpose(opens_i, opens_j, slides_i, slides_j);
  Quad normal_stiffness = law(0, 0), shear_stiffness = law(1, 0), inverse_closure = law(2, 0),
       last_closure = law(3, 0);
  transpose(normal_stiffness, shear_stiffness, inverse_closure, last_closure);
  Quad friction = law(0, 1), tensile = law(1, 1), cohesion = law(2, 1), intact_friction = law(3, 1);
  transpose(friction, tensile, cohesion, intact_friction);
  Quad open_before = zero, slid_before = zero, locked_normal = zero, locked_shear = zero;
  if (a.smooth.settled != nullptr) {
    const SmoothRecord* first = static_cast<const SmoothRecord*>(a.smooth.contacts);
    const auto settled = [&](int64_t w) -> const Quad& {
      return reinterpret_cast<const Quad*>(a.smooth.settled)[contact[w] - first];
    };
    open_before = settled(0);
    slid_before = settled(1);
    locked_normal = settled(2);
    locked_shear = settled(3);
    transpose(open_before, slid_before, locked_normal, locked_shear);
  }
  Quad dux, duy, theta_i, turn, slip, intact;
  gather(c.dux, dux);
  gather(c.duy, duy);
  gather(c.theta_i, theta_i);
  gather(c.turn, turn);
  gather(c.intact, intact);
  gather(a.slip + e, slip);
  const Quad theta_j = theta_i + turn;
  const auto holds = intact > zero;

  const Quad opening = dux * nx + duy * ny + opens_i * theta_i + opens_j * theta_j - open_before;
  const Quad slide = duy * nx - dux * ny + slides_i * theta_i + slides_j * theta_j - slid_before;
  const Quad closure = opening < zero ? -opening : zero, open = opening > zero ? opening : zero;
  const Quad bent = closure < last_closure ? closure : last_closure;
  const Quad room = one / (one - bent * inverse_closure);
  const Quad kn = area * normal_stiffness, ks = area * shear_stiffness;
  const Quad pressed = kn * room * (bent + room * (closure - bent));
  const Quad trial = ks * (slide - (holds ? zero : slip)), limit = friction * pressed;
  const Quad at_limit = trial < zero ? -limit : limit;
  const auto slides = ((trial > limit) | (-trial > limit)) & ~holds;
  const Quad shear = slides ? at_limit : trial;
  const Quad slipped = slides ? slide - (ks > zero ? shear / ks : zero) : slip;
  const Quad normal = (holds ? kn * open : zero) - pressed;
  const Quad pull = normal - tensile * area,
             push = (shear < zero ? -shear : shear) - (cohesion * area + intact_friction * pressed);
  const auto breaks = ((pull > push ? pull : push) >= zero) & holds;
  const Quad along = normal + locked_normal, across = shear + locked_shear;
  const Quad fx = along * nx - across * ny, fy = along * ny + across * nx;
  // Once the faces have moved apart the two forces lie on two lines: what that turns is shared.
  const Quad couple = 0.5 * (dux * fy - duy * fx);
  put(c.fx, fx);
  put(c.fy, fy);
  put(c.moment_i, couple - (opens_i * along + slides_i * across));
  put(c.minus_moment_j, opens_j * along + slides_j * across - couple);
  put(c.slip, slipped);
  const Quad work = shear * (slipped - slip);
  put(c.friction, work < zero ? -work : work);
  put(c.over, breaks ? one : zero);
  put(c.force, zero);  // the mean that rest is measured by is that of bonds
}

// Contacts of smooth joints from number q on, those of bonds e to e + n - 1, answer in place of them. Returns the number that follows.
int64_t answer_smooth(const KernelArrays& a, int64_t e, int64_t n, int64_t q, Chunk& c) {
  const SmoothRecord* contacts = static_cast<const SmoothRecord*>(a.smooth.contacts);
  int64_t last = q;
  while (last < a.smooth.count && contacts[last].bond < e + n) ++last;
  for (int64_t k = q; k < last && a.smooth.forces == nullptr; k += 4) {
    // The last stands in for those missing.
    const SmoothRecord* four[4];
    int64_t lane[4];
    for (int64_t w = 0; w < 4; ++w) {
      four[w] = contacts + (k + w < last ? k + w : last - 1);
      lane[w] = four[w]->bond - e;
    }
    answer_four(a, four, lane, e, c);
  }
  for (int64_t k = q; k < last && a.smooth.forces != nullptr; ++k) {
    const SmoothForces& f = a.smooth.forces[k];
    const int64_t lane = contacts[k].bond - e;
    c.fx[lane] = f.fx;
    c.fy[lane] = f.fy;
    c.moment_i[lane] = f.moment_i;
    c.minus_moment_j[lane] = -f.moment_j;
    c.slip[lane] = a.slip[e + lane];
    c.friction[lane] = c.over[lane] = c.force[lane] = 0.0;
  }
  return last;
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
