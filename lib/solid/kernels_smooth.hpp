// SPDX-License-Identifier: BSD-3-Clause
// Contacts of smooth joints in the kernels (kernels_body.hpp): they answer in place of their bonds, four at a time, by the law of
// smooth_joints.hpp where it has no dilation and a constant friction, else with forces found before.
#pragma once

#include "solid/kernels_chunk.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

struct FourLanes {
  using Value = Quad;
};

// Four contacts of smooth joints, by the law of solid/smooth_joints.hpp, in place of their bonds, which are e + lane[].
inline __attribute__((always_inline)) void answer_four(const KernelArrays& a,
                                                       const ContactRecord* const* contact,
                                                       const int64_t* lane, int64_t e, Chunk& c) {
  // A record as two rows of four.
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
  ContactPlace<FourLanes> place{};
  Quad bonds = row(0, 0);
  place.nx = row(1, 0);
  place.ny = row(2, 0);
  place.area = row(3, 0);
  transpose(bonds, place.nx, place.ny, place.area);
  place.opens_i = row(0, 1);
  place.opens_j = row(1, 1);
  place.slides_i = row(2, 1);
  place.slides_j = row(3, 1);
  transpose(place.opens_i, place.opens_j, place.slides_i, place.slides_j);
  ContactLaw<FourLanes> l;
  l.normal = law(0, 0);
  l.shear = law(1, 0);
  l.inverse_closure = law(2, 0);
  l.last_closure = law(3, 0);
  transpose(l.normal, l.shear, l.inverse_closure, l.last_closure);
  l.friction = law(0, 1);
  l.tensile = law(1, 1);
  l.cohesion = law(2, 1);
  l.intact_friction = law(3, 1);
  transpose(l.friction, l.tensile, l.cohesion, l.intact_friction);
  if (a.smooth.settled != nullptr) {
    const ContactRecord* first = static_cast<const ContactRecord*>(a.smooth.contacts);
    const auto settled = [&](int64_t w) -> const Quad& {
      return reinterpret_cast<const Quad*>(a.smooth.settled)[contact[w] - first];
    };
    place.open_before = settled(0);
    place.slid_before = settled(1);
    place.locked_normal = settled(2);
    place.locked_shear = settled(3);
    transpose(place.open_before, place.slid_before, place.locked_normal, place.locked_shear);
  }
  ContactMotion<FourLanes> m;
  gather(c.dux, m.dux);
  gather(c.duy, m.duy);
  gather(c.theta_i, m.theta_i);
  gather(c.turn, m.turn);
  gather(c.intact, m.intact);
  gather(a.slip + e, m.slip);
  const ContactAnswer<FourLanes> r = answer_contact(place, l, m);
  put(c.fx, r.fx);
  put(c.fy, r.fy);
  put(c.moment_i, r.moment_i);
  put(c.minus_moment_j, r.minus_moment_j);
  put(c.slip, r.slip);
  put(c.friction, r.friction);
  put(c.over, r.over);
  put(c.force, Quad{});  // the mean that rest is measured by is that of bonds
}

// Contacts of smooth joints from number q on, those of bonds e to e + n - 1, answer in place of them. Returns the number that follows.
int64_t answer_smooth(const KernelArrays& a, int64_t e, int64_t n, int64_t q, Chunk& c) {
  const ContactRecord* contacts = static_cast<const ContactRecord*>(a.smooth.contacts);
  int64_t last = q;
  while (last < a.smooth.count && contacts[last].bond < e + n) ++last;
  for (int64_t k = q; k < last && a.smooth.forces == nullptr; k += 4) {
    // The last stands in for those missing.
    const ContactRecord* four[4];
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
