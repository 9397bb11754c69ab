// SPDX-License-Identifier: BSD-3-Clause
#include "solid/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "options/choices.hpp"

namespace hfrac {

Boundary::Boundary(const Assembly& a, const Network& n, const Options& o)
    : walled_(BoundaryKind{o.boundary_kind} == BoundaryKind::walls), stiffness_(o.contact_normal_stiffness) {
  if (!walled_) {
    load_x_.assign(a.x.size(), 0.0);
    load_y_.assign(a.x.size(), 0.0);
    // The outside's weights are force per pressure; a stress presses with its own component along each axis.
    for (auto k = n.corner_start[0]; k < n.corner_start[1]; ++k) {
      load_x_[n.corner_disc[k]] += o.stress_sigma_H * n.corner_weight[2 * k];
      load_y_[n.corner_disc[k]] += o.stress_sigma_h * n.corner_weight[2 * k + 1];
    }
    return;
  }
  // Walls carry effective stress: the pores outside push with the formation's pressure.
  const double outside = n.reference_pressure;
  const double width = o.model_width, height = o.model_height;
  walls_[0] = {{1.0, 0.0}, height, o.stress_sigma_H - outside, 0.0, 0.0, {}};
  walls_[1] = {{-1.0, 0.0}, height, o.stress_sigma_H - outside, 0.0, 0.0, {}};
  walls_[2] = {{0.0, 1.0}, width, o.stress_sigma_h - outside, 0.0, 0.0, {}};
  walls_[3] = {{0.0, -1.0}, width, o.stress_sigma_h - outside, 0.0, 0.0, {}};
  const double tolerance = std::max(o.bond_gap_tolerance, 0.01) * a.mean_radius;
  at_wall_.assign(a.x.size(), 0);
  for (std::int32_t i = 0; i < a.disc_count(); ++i) {
    const double distance[4] = {a.x[i] - a.radius[i], width - a.x[i] - a.radius[i], a.y[i] - a.radius[i],
                                height - a.y[i] - a.radius[i]};
    for (std::size_t w = 0; w < 4; ++w) {
      if (distance[w] >= tolerance) continue;
      walls_[w].discs.push_back(i);
      at_wall_[static_cast<std::size_t>(i)] = 1;
    }
  }
}

void Boundary::set_load(Assembly& a, double share) {
  load_ = share;
  if (walled_) return;
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    a.external_x[i] = share * load_x_[i];
    a.external_y[i] = share * load_y_[i];
  }
}

void Boundary::cycle(Assembly& a, double step, double safety, double damping) {
  for (auto& wall : walls_) {
    for (const auto i : wall.discs) a.external_x[i] = a.external_y[i] = 0.0;
  }
  imbalance_ = 0.0;
  for (auto& wall : walls_) {
    double push = 0.0;
    for (const auto i : wall.discs) {
      const double closing = wall.displacement - (a.ux[i] * wall.inward.x + a.uy[i] * wall.inward.y);
      const double force = stiffness_ * std::max(0.0, closing);
      push += force;
      a.external_x[i] += force * wall.inward.x;
      a.external_y[i] += force * wall.inward.y;
    }
    if (!servo_ || wall.discs.empty()) continue;
    const double target = load_ * wall.target * wall.length;
    const double force = target - push;
    imbalance_ = std::max(imbalance_, std::abs(force) / std::max(std::abs(target), 1e-9 * stiffness_ * wall.length));
    // Mass of the wall: stable with the step in use, as light as that allows (a servo has no inertia of its own).
    const double mass = 0.5 * step * step * stiffness_ * static_cast<double>(wall.discs.size()) / (safety * safety);
    const double drag = damping * std::abs(force) * (wall.velocity > 0.0 ? 1.0 : (wall.velocity < 0.0 ? -1.0 : 0.0));
    wall.velocity += step * (force - drag) / mass;
    wall.displacement += step * wall.velocity;
    work_ += target * step * wall.velocity;
  }
}

void Boundary::add_stiffness(std::vector<double>& row_x, std::vector<double>& row_y) const {
  for (const auto& wall : walls_) {
    for (const auto i : wall.discs) {
      row_x[i] += 2.0 * stiffness_ * std::abs(wall.inward.x);
      row_y[i] += 2.0 * stiffness_ * std::abs(wall.inward.y);
    }
  }
}

Vec2 Boundary::wall_stress(const Assembly& a) const {
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  for (std::size_t w = 0; w < 4; ++w) {
    for (const auto i : walls_[w].discs) {
      const double closing = walls_[w].displacement - (a.ux[i] * walls_[w].inward.x + a.uy[i] * walls_[w].inward.y);
      sum[w] += stiffness_ * std::max(0.0, closing) / walls_[w].length;
    }
  }
  return {0.5 * (sum[0] + sum[1]), 0.5 * (sum[2] + sum[3])};
}

double Boundary::wall_energy(const Assembly& a) const {
  double energy = 0.0;
  for (const auto& wall : walls_) {
    for (const auto i : wall.discs) {
      const double closing = std::max(0.0, wall.displacement - (a.ux[i] * wall.inward.x + a.uy[i] * wall.inward.y));
      energy += 0.5 * stiffness_ * closing * closing;
    }
  }
  return energy;
}

double Boundary::load_work(const Assembly& a) const {
  if (walled_) return work_;
  double work = 0.0;
  for (std::size_t i = 0; i < a.x.size(); ++i) work += load_ * (load_x_[i] * a.ux[i] + load_y_[i] * a.uy[i]);
  return work;
}

}  // namespace hfrac
