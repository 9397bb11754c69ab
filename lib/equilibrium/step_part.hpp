// SPDX-License-Identifier: BSD-3-Clause
// How much of a step of Newton's method is taken, where contacts open, close, stick and slide.
//
// Those are kinks, and a step that goes past some of them may go too far by any factor: a joint stiffer than the rock sends Newton's method
// from one set of sliding contacts to another for ever. How far is far enough the forces that are left say. Along the step they do work: at its
// beginning `push`, less the farther it goes, as in minimizing an energy, and none where the step should end; beyond, they push back
// (Crisfield 1991, Non-linear Finite Element Analysis of Solids and Structures 1, 9.2). The residual is no such measure: what stiff pores
// are off by rules it.
#pragma once

#include <algorithm>
#include <cmath>

namespace hfrac {

constexpr double far_beyond = 0.3;  // of the work at the beginning

// Whether forces push back, at the end of the step, by more than is left of the way.
inline bool goes_too_far(double push, double at_end) {
  return push > 0.0 && at_end < -far_beyond * push;
}

// The part of such a step at whose end hardly any work is left; work(part) of it is asked for a few times. Regula falsi, which may not
// come nearer to either end than a tenth of what is between them.
template <class Work>
double part_by_work(double push, double at_end, const Work& work) {
  constexpr int most_looks = 6;
  double near = 0.0, far = 1.0, ahead = push, behind = at_end, part = 1.0;
  for (int look = 0; look < most_looks; ++look) {
    part = near + (far - near) * std::clamp(ahead / (ahead - behind), 0.1, 0.9);
    const double left = work(part);
    if (std::abs(left) < far_beyond * push) break;
    (left > 0.0 ? near : far) = part;
    (left > 0.0 ? ahead : behind) = left;
  }
  return part;
}

// The part of a step that leaves least of the residual; left(part) is its norm, `whole` that after all of the step.
template <class Left>
double part_that_leaves_least(double whole, const Left& left) {
  double best = 1.0;
  for (const double part : {0.75, 0.5, 0.25, 0.1, 0.03}) {
    const double now = left(part);
    if (!(now < whole)) continue;
    whole = now;
    best = part;
  }
  return best;
}

}  // namespace hfrac
