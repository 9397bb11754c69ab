// SPDX-License-Identifier: BSD-3-Clause
#include "rock/seeping_well.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rock/biot_solver.hpp"

namespace hfrac {
namespace {

constexpr int around = 48, outward = 24;  // elements
constexpr int steps_per_doubling = 6;     // of the time passed

std::vector<BiotSolver::Side> sides_of(const SeepingWell& well) {
  const auto motion = well.outer_held ? SideMotion::held : SideMotion::free;
  std::vector<BiotSolver::Side> sides{{RockSide::well, SideMotion::free, true}};
  for (const auto side : {RockSide::left, RockSide::right, RockSide::bottom, RockSide::top})
    sides.push_back({side, motion, well.outer_drained});
  return sides;
}

void seep(BiotSolver& rock, const SeepingWell& well, const BiotMaterial& material) {
  rock.set_pressure(RockSide::well, well.excess);
  rock.set_stress(RockSide::well, {well.excess, well.excess, 0.0});
  if (well.duration == 0.0) return rock.load_steady();
  rock.load_undrained();
  // The first step is what diffuses through a tenth of the finest element; or all, if that is short.
  const double element = 2.0 * std::numbers::pi * well.radius / around;
  double time = 0.0, step = std::min(well.duration, 0.01 * element * element / material.consolidation());
  while (time < well.duration * (1.0 - 1e-12)) {
    step = std::min(step, well.duration - time);
    rock.advance(step);
    time += step;
    // Equal steps share a factorisation: they double rather than grow.
    if (time > steps_per_doubling * step) step *= 2.0;
  }
}

}  // namespace

std::vector<double> seepage_pressure(const SeepingWell& well, const BiotMaterial& material,
                                     std::span<const Vec2> places) {
  BiotSolver rock(plate_mesh(well.width, well.height, well.centre, well.radius, around, outward), material,
                  sides_of(well));
  seep(rock, well, material);
  // The elements again, by corners: the mesh is a block, outward first.
  const auto element_at = [](int a, int b) {
    return static_cast<std::size_t>(b) * outward + static_cast<std::size_t>(a);
  };
  std::vector<double> pressure;
  pressure.reserve(places.size());
  for (const Vec2 place : places) {
    const Vec2 from = place - well.centre;
    const double distance = std::hypot(from.x, from.y);
    if (distance <= well.radius) {
      pressure.push_back(well.excess);
      continue;
    }
    // The element whose rays hold the place, then the one along it; an element is nearly a piece of a ring.
    const auto node = [&](int a, int b, std::size_t corner) {
      return rock.mesh().node[static_cast<std::size_t>(rock.mesh().element[element_at(a, b)][corner])] -
             well.centre;
    };
    int b = 0;
    while (b + 1 < around && !(cross(node(0, b, 0), from) >= 0.0 && cross(from, node(0, b, 3)) > 0.0 &&
                               dot(from, node(0, b, 0)) > 0.0))
      ++b;
    const double right = std::atan2(cross(node(0, b, 0), from), dot(node(0, b, 0), from)),
                 all = std::atan2(cross(node(0, b, 0), node(0, b, 3)), dot(node(0, b, 0), node(0, b, 3)));
    const double across = std::clamp(right / all, 0.0, 1.0);
    const auto ray = [&](int a, bool outer) {
      const Vec2 p = node(a, b, outer ? 1 : 0), q = node(a, b, outer ? 2 : 3);
      return (1.0 - across) * std::hypot(p.x, p.y) + across * std::hypot(q.x, q.y);
    };
    int a = 0;
    while (a + 1 < outward && ray(a, true) < distance) ++a;
    const double along = std::clamp((distance - ray(a, false)) / (ray(a, true) - ray(a, false)), 0.0, 1.0);
    pressure.push_back(rock.sample(element_at(a, b), 2.0 * along - 1.0, 2.0 * across - 1.0).pressure);
  }
  return pressure;
}

}  // namespace hfrac
