// SPDX-License-Identifier: BSD-3-Clause
// What pushes discs on a device beside bonds and pores: walls, whose motion under servo control follows, and non-bonded contacts around cracks.
#pragma once

#include "gpu/device_sums.hpp"
#include "solid/kernels_law.hpp"

namespace hfrac {
namespace HFRAC_KERNEL_NAMESPACE {
namespace {

// Boundary::cycle: what walls do to their discs, wall by wall on a disc in a corner, which two press.
template <class Block>
void press_walls(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  block.each(device_threads, [&](int64_t k) {
    const int64_t at = block.number * device_threads + k;
    if (at >= d.wall_disc_count) return;
    const DeviceWallDisc disc = d.wall_discs[at];
    const double ux = a.ux[disc.disc], uy = a.uy[disc.disc];
    double fx = 0.0, fy = 0.0;
    for (int side = 0; side < 2 && disc.wall[side] >= 0; ++side) {
      const DeviceWall& wall = d.outside->walls[disc.wall[side]];
      const double closing = wall.displacement - (ux * wall.inward_x + uy * wall.inward_y) + disc.growth;
      const double force = d.wall_stiffness * positive(closing);
      d.wall_force[disc.place[side]] = force;
      fx += force * wall.inward_x;
      fy += force * wall.inward_y;
    }
    d.external_x[disc.disc] = fx;
    d.external_y[disc.disc] = fy;
  });
}

// Likewise: the motion of walls under servo control.
template <class Block>
void move_walls(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  double* push = block.shared;
  block.each(4 * 32, [&](int64_t k) {
    if (k % 32 != 0) return;  // each in a warp of its own
    const DeviceWall& wall = d.outside->walls[k / 32];
    push[k / 32] =
        sum_of_every(1, d.wall_force, static_cast<int32_t>(wall.first), static_cast<int32_t>(wall.last), 0.0);
  });
  block.each(1, [&](int64_t) {
    d.outside->imbalance = 0.0;
    for (int w = 0; w < 4; ++w) {
      DeviceWall& wall = d.outside->walls[w];
      if (wall.first == wall.last) continue;
      const double force = wall.target - push[w];
      const double least = magnitude(wall.target) < wall.floor ? wall.floor : magnitude(wall.target);
      const double share = magnitude(force) / least;
      d.outside->imbalance = d.outside->imbalance < share ? share : d.outside->imbalance;
      const double drag =
          d.a.damping * magnitude(force) * (wall.velocity > 0.0 ? 1.0 : (wall.velocity < 0.0 ? -1.0 : 0.0));
      wall.velocity += d.a.step * (force - drag) / wall.mass;
      wall.displacement += d.a.step * wall.velocity;
      d.outside->work += wall.target * d.a.step * wall.velocity;
    }
  });
}

// NonBondedContacts::cycle: contacts first, then every disc collects its own.
template <class Block>
void press_contacts(Block& block, const DeviceTask& t) {
  const DeviceArrays& d = t.d;
  const KernelArrays& a = d.a;
  block.each(d.contact_count, [&](int64_t k) {
    DevicePair& pair = d.pairs[k];
    const int32_t i = pair.first, j = pair.second;
    const double dx = (d.x[j] + a.ux[j]) - (d.x[i] + a.ux[i]), dy = (d.y[j] + a.uy[j]) - (d.y[i] + a.uy[i]);
    const double distance = __builtin_sqrt(dx * dx + dy * dy);
    const double gap =
        distance - d.radius[i] - d.radius[j] - pair.reference_gap - pair.growth_first - pair.growth_second;
    pair.touches = gap < 0.0 ? 1 : 0;
    if (gap >= 0.0) {
      pair.shear_force = pair.normal_force = 0.0;
      return;
    }
    const double inverse = 1.0 / distance;
    const double nx = inverse * dx, ny = inverse * dy, tx = -ny, ty = nx;
    const double share = distance / (d.radius[i] + d.radius[j]), arm_i = share * d.radius[i],
                 arm_j = share * d.radius[j];
    const double speed = (a.vx[j] - a.vx[i]) * tx + (a.vy[j] - a.vy[i]) * ty;
    const double slide = a.step * (speed - a.spin[i] * arm_i - a.spin[j] * arm_j);
    pair.normal_force = -pair.normal * gap;
    const double limit = pair.friction * pair.normal_force;
    const double trial = pair.shear_force + pair.shear * slide;
    pair.shear_force = trial < -limit ? -limit : (limit < trial ? limit : trial);
    pair.friction_work =
        pair.shear > 0.0 ? magnitude(pair.shear_force * (trial - pair.shear_force)) / pair.shear : 0.0;
    pair.on_first_x = -pair.normal_force * nx + pair.shear_force * tx;
    pair.on_first_y = -pair.normal_force * ny + pair.shear_force * ty;
    pair.arm_first = arm_i;
    pair.arm_second = arm_j;
  });
  block.each(d.pushed_count + 1, [&](int64_t k) {
    if (k == d.pushed_count) {
      for (int64_t p = 0; p < d.contact_count; ++p) {
        if (d.pairs[p].touches != 0) d.outside->friction += d.pairs[p].friction_work;
      }
      return;
    }
    const DevicePushedDisc& disc = d.pushed[k];
    double fx = disc.keeps_load != 0 ? d.external_x[disc.disc] : disc.load_x,
           fy = disc.keeps_load != 0 ? d.external_y[disc.disc] : disc.load_y, moment = 0.0;
    for (int64_t q = disc.first; q < disc.last; ++q) {
      const DevicePair& pair = d.pairs[d.pushed_pairs[q] / 2];
      if (pair.touches == 0) continue;
      const bool first = d.pushed_pairs[q] % 2 == 0;
      fx = first ? fx + pair.on_first_x : fx - pair.on_first_x;
      fy = first ? fy + pair.on_first_y : fy - pair.on_first_y;
      moment += pair.shear_force * (first ? pair.arm_first : pair.arm_second);
    }
    d.external_x[disc.disc] = fx;
    d.external_y[disc.disc] = fy;
    d.external_moment[disc.disc] = moment;
  });
}

template <class Block>
void push(Block& block, const DeviceTask& t) {
  if (*t.d.stop < t.stage) return;
  if (t.d.walled != 0 && t.d.servo != 0) move_walls(block, t);
  if (t.d.pushed_count > 0) press_contacts(block, t);
}

}  // namespace
}  // namespace HFRAC_KERNEL_NAMESPACE
}  // namespace hfrac
