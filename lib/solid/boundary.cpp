// SPDX-License-Identifier: BSD-3-Clause
#include "solid/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "options/choices.hpp"

namespace hfrac {

Boundary::Boundary(Model& model, const Options& o)
    : state_(model.boundary),
      sigma_Hmax_(o.stress_sigma_Hmax),
      sigma_hmin_(o.stress_sigma_hmin),
      walled_(BoundaryKind{o.boundary_kind} == BoundaryKind::walls),
      wet_(FlowScheme{o.flow_scheme} != FlowScheme::off),
      stiffness_(o.contact_normal_stiffness) {
  const Assembly& a = model.assembly;
  const Network& n = model.network;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    mass_ += a.mass(i);
    centre_ = centre_ + a.mass(i) * Vec2{a.x[i], a.y[i]};
  }
  centre_ = (1.0 / mass_) * centre_;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) {
    const Vec2 r = Vec2{a.x[i], a.y[i]} - centre_;
    inertia_ += a.mass(i) * dot(r, r);
  }
  if (!walled_) {
    const auto begin = n.corner_start[0], end = n.corner_start[1];
    edge_.assign(n.corner_disc.begin() + begin, n.corner_disc.begin() + end);
    std::sort(edge_.begin(), edge_.end());
    edge_.erase(std::unique(edge_.begin(), edge_.end()), edge_.end());
    for (auto* values : {&pore_, &weight_, &state_.cell_load, &load_on_})
      values->assign(edge_.size(), Vec2{});
    state_.loaded_discs = edge_.size();
    for (auto k = begin; k < end; ++k) {
      const auto [i, from, to] = n.corner(0, k);
      const std::size_t at = place_of(i);
      // Half of the edge behind and half of the one ahead, turned inward.
      weight_[at] = weight_[at] + 0.5 * Vec2{a.y[to] - a.y[from], a.x[from] - a.x[to]};
    }
    put_outside_pressure(n);
    put_far_field(o.stress_sigma_Hmax, o.stress_sigma_hmin);
    return;
  }
  put_outside_pressure(n);
  // Walls carry effective stress: the pores outside push with the formation's pressure.
  const double width = o.model_width, height = o.model_height;
  state_.walls[0] = {{1.0, 0.0}, height, 0.0, 0.0, 0.0, {}};
  state_.walls[1] = {{-1.0, 0.0}, height, 0.0, 0.0, 0.0, {}};
  state_.walls[2] = {{0.0, 1.0}, width, 0.0, 0.0, 0.0, {}};
  state_.walls[3] = {{0.0, -1.0}, width, 0.0, 0.0, 0.0, {}};
  wall_start_ = {0.0, width, 0.0, height};
  put_far_field(o.stress_sigma_Hmax, o.stress_sigma_hmin);
  for (std::int32_t i = 0; i < a.disc_count(); ++i) {
    const double tolerance = std::max(o.bond_gap_tolerance, 0.01) * a.mean_radius_at({a.x[i], a.y[i]});
    const double distance[4] = {a.x[i] - a.radius[i], width - a.x[i] - a.radius[i], a.y[i] - a.radius[i],
                                height - a.y[i] - a.radius[i]};
    for (std::size_t w = 0; w < 4; ++w) {
      if (distance[w] >= tolerance) continue;
      state_.walls[w].discs.push_back(i);
      if (edge_.empty() || edge_.back() != i) edge_.push_back(i);
    }
  }
}

void Boundary::put_outside_pressure(const Network& n) {
  // In a dry model nothing pushes from inside, and stresses are all there is.
  outside_pressure_ = wet_ ? n.pressure[0] : 0.0;
  if (walled_) return;
  const auto begin = n.corner_start[0], end = n.corner_start[1];
  std::fill(pore_.begin(), pore_.end(), Vec2{});
  for (auto k = begin; k < end; ++k) {
    Vec2& on_disc = pore_[place_of(n.corner_disc[k])];
    on_disc = on_disc + outside_pressure_ * Vec2{n.corner_weight[2 * k], n.corner_weight[2 * k + 1]};
  }
}

void Boundary::put_far_field(double sigma_Hmax, double sigma_hmin) {
  if (walled_) {
    state_.walls[0].target = state_.walls[1].target = sigma_Hmax - outside_pressure_;
    state_.walls[2].target = state_.walls[3].target = sigma_hmin - outside_pressure_;
    return;
  }
  if (exterior_) exterior_->add_far_field(sigma_Hmax - sigma_Hmax_, sigma_hmin - sigma_hmin_);
  for (std::size_t k = 0; k < edge_.size(); ++k) {
    load_on_[k] = pore_[k] +
                  Vec2{(sigma_Hmax - outside_pressure_) * weight_[k].x,
                       (sigma_hmin - outside_pressure_) * weight_[k].y} +
                  state_.cell_load[k];
  }
}

std::size_t Boundary::place_of(std::int32_t disc) const {
  return static_cast<std::size_t>(std::lower_bound(edge_.begin(), edge_.end(), disc) - edge_.begin());
}

Vec2 Boundary::load_on(std::int32_t disc) const {
  if (walled_) return {};
  const std::size_t at = place_of(disc);
  if (at == edge_.size() || edge_[at] != disc) return {};
  return answer_.empty() ? state_.load * load_on_[at] : state_.load * load_on_[at] + answer_[at];
}

void Boundary::engage(std::unique_ptr<Exterior> exterior) {
  exterior_ = std::move(exterior);
  for (const auto& place : exterior_->rim()) rim_place_.push_back(place_of(place.disc));
  answer_.assign(edge_.size(), Vec2{});
}

void Boundary::answer(const Assembly& a) {
  if (!exterior_) return;
  exterior_->answer(a, state_.load);
  std::fill(answer_.begin(), answer_.end(), Vec2{});
  for (std::size_t k = 0; k < rim_place_.size(); ++k) {
    Vec2& on_disc = answer_[rim_place_[k]];
    on_disc = on_disc + exterior_->force_on(exterior_->rim()[k]);
  }
}

void Boundary::push_rim(Assembly& a) {
  answer(a);
  for (std::size_t k = 0; k < edge_.size(); ++k) {
    const Vec2 force = state_.load * load_on_[k] + answer_[k];
    a.external_x[edge_[k]] = force.x;
    a.external_y[edge_[k]] = force.y;
  }
}

bool Boundary::touches_wall(std::int32_t disc) const {
  if (std::any_of(grips_.begin(), grips_.end(), [&](const Grip& grip) { return grip.disc == disc; }))
    return true;
  return (walled_ || exterior_) && std::binary_search(edge_.begin(), edge_.end(), disc);
}

void Boundary::set_far_field(Assembly& a, double sigma_Hmax, double sigma_hmin) {
  // The work done so far stays what it was: load_work() measures from where displacements began.
  const double before = load_work(a) - exterior_energy(a);
  put_far_field(sigma_Hmax, sigma_hmin);
  if (!walled_) {
    set_load(a, state_.load);
    // What strains the rock beyond from far away is work of the far field.
    state_.carried_work += before - (load_work(a) - exterior_energy(a));
  }
}

void Boundary::set_outside_pressure(Assembly& a, const Network& n, double sigma_Hmax, double sigma_hmin) {
  put_outside_pressure(n);
  set_far_field(a, sigma_Hmax, sigma_hmin);
}

void Boundary::restore_load(Assembly& a, const Network& n, double sigma_Hmax, double sigma_hmin) {
  put_outside_pressure(n);
  put_far_field(sigma_Hmax, sigma_hmin);
  if (exterior_)
    answer(a);  // the forces on its discs are those of the last cycle, and were saved with the state
  else if (!walled_)
    set_load(a, state_.load);
}

std::vector<Vec2> Boundary::load_of_stress(const Assembly& a, const Network& n,
                                           std::span<const double> stress) const {
  std::vector<Vec2> load(edge_.size(), Vec2{});
  const auto begin = n.corner_start[0], end = n.corner_start[1];
  const auto discs = static_cast<double>(end - begin);
  Vec2 force{}, centre{};
  for (auto k = begin; k < end; ++k) {
    const auto [i, from, to] = n.corner(0, k);
    const Vec2 inward{0.5 * (a.y[to] - a.y[from]), -0.5 * (a.x[to] - a.x[from])};  // times length
    const auto* s = stress.data() + 3 * static_cast<std::size_t>(k - begin);
    const Vec2 push{s[0] * inward.x + s[2] * inward.y, s[2] * inward.x + s[1] * inward.y};
    load[place_of(i)] = load[place_of(i)] + push;
    force = force + push;
    centre = centre + (1.0 / discs) * Vec2{a.x[i], a.y[i]};
  }
  // What is left over the host balances by forces in the volume that it knows of; here the loop carries it, evenly for the
  // force and as a turn about its middle for the moment.
  double moment = 0.0, inertia = 0.0;
  for (auto k = begin; k < end; ++k) {
    Vec2& on_disc = load[place_of(n.corner_disc[k])];
    on_disc = on_disc - (1.0 / discs) * force;
  }
  for (auto k = begin; k < end; ++k) {
    const auto i = n.corner_disc[k];
    const Vec2 arm = Vec2{a.x[i], a.y[i]} - centre;
    inertia += dot(arm, arm);
  }
  for (std::size_t q = 0; q < load.size(); ++q)
    moment += cross(Vec2{a.x[edge_[q]], a.y[edge_[q]]} - centre, load[q]);
  for (auto k = begin; k < end; ++k) {
    const auto i = n.corner_disc[k];
    const Vec2 arm = Vec2{a.x[i], a.y[i]} - centre;
    load[place_of(i)] = load[place_of(i)] + (moment / inertia) * Vec2{arm.y, -arm.x};
  }
  return load;
}

void Boundary::set_load(Assembly& a, double share) {
  state_.load = share;
  if (walled_) return;
  std::fill(a.external_x.begin(), a.external_x.end(), 0.0);
  std::fill(a.external_y.begin(), a.external_y.end(), 0.0);
  for (std::size_t k = 0; k < edge_.size(); ++k) {
    a.external_x[edge_[k]] = share * load_on_[k].x;
    a.external_y[edge_[k]] = share * load_on_[k].y;
  }
  if (exterior_) push_rim(a);
}

// About the centre of mass, whose first moments vanish: so turns follow without the shift.
Boundary::RigidMotion Boundary::momenta(const Assembly& a, std::int64_t first, std::int64_t last) const {
  RigidMotion sum{};
  for (auto i = first; i < last; ++i) {
    const double m = a.mass(i);
    const Vec2 r = Vec2{a.x[i], a.y[i]} - centre_, u{a.ux[i], a.uy[i]}, v{a.vx[i], a.vy[i]};
    const RigidMotion of_disc{m * u.x, m * u.y, m * cross(r, u), m * v.x, m * v.y, m * cross(r, v)};
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += of_disc[k];
  }
  return sum;
}

Boundary::RigidMotion Boundary::motion_of(RigidMotion momenta) const {
  for (std::size_t k = 0; k < momenta.size(); ++k) momenta[k] /= k % 3 == 2 ? inertia_ : mass_;
  return momenta;
}

void Boundary::take_out(Assembly& a, const RigidMotion& motion, std::int64_t i) const {
  const auto& [shift_x, shift_y, turn, drift_x, drift_y, spin] = motion;
  const Vec2 r = Vec2{a.x[i], a.y[i]} - centre_;
  a.ux[i] -= shift_x - turn * r.y;
  a.uy[i] -= shift_y + turn * r.x;
  a.rotation[i] -= turn;
  a.vx[i] -= drift_x - spin * r.y;
  a.vy[i] -= drift_y + spin * r.x;
  a.spin[i] -= spin;
}

void Boundary::remove_rigid_motion(Assembly& a) const {
  if (!holds_still()) return;
  const RigidMotion motion = motion_of(momenta(a, 0, a.disc_count()));
  for (std::int64_t i = 0; i < a.disc_count(); ++i) take_out(a, motion, i);
}

void Boundary::cycle(Assembly& a, double step, double safety, double damping) {
  for (auto& wall : state_.walls) {
    for (const auto i : wall.discs) a.external_x[i] = a.external_y[i] = 0.0;
  }
  if (exterior_) push_rim(a);
  for (const auto& grip : grips_) {
    const Vec2 load = load_on(grip.disc);
    a.external_x[grip.disc] = load.x;
    a.external_y[grip.disc] = load.y;
  }
  for (const auto& grip : grips_) {
    const double force = grip_force(a, grip);
    a.external_x[grip.disc] += force * grip.along.x;
    a.external_y[grip.disc] += force * grip.along.y;
  }
  state_.imbalance = 0.0;
  for (auto& wall : state_.walls) {
    double push = 0.0;
    for (const auto i : wall.discs) {
      const double force = push_of(a, wall, i, stiffness_);
      push += force;
      a.external_x[i] += force * wall.inward.x;
      a.external_y[i] += force * wall.inward.y;
    }
    if (!state_.servo || wall.discs.empty()) continue;
    const double target = state_.load * wall.target * wall.length;
    const double force = target - push;
    state_.imbalance = std::max(
        state_.imbalance, std::abs(force) / std::max(std::abs(target), 1e-9 * stiffness_ * wall.length));
    const double mass = wall_mass(wall, step, safety);
    const double drag =
        damping * std::abs(force) * (wall.velocity > 0.0 ? 1.0 : (wall.velocity < 0.0 ? -1.0 : 0.0));
    wall.velocity += step * (force - drag) / mass;
    wall.displacement += step * wall.velocity;
    state_.work += target * step * wall.velocity;
  }
}

void Boundary::press(Assembly& a, std::int64_t first, std::int64_t last) const {
  const auto among = [&](const std::vector<std::int32_t>& discs) {
    return std::span(std::lower_bound(discs.begin(), discs.end(), first),
                     std::lower_bound(discs.begin(), discs.end(), last));
  };
  if (!walled_ || among(edge_).empty()) return;
  for (const auto& wall : state_.walls) {
    for (const auto i : among(wall.discs)) a.external_x[i] = a.external_y[i] = 0.0;
  }
  for (const auto& wall : state_.walls) {
    for (const auto i : among(wall.discs)) {
      const double force = push_of(a, wall, i, stiffness_);
      a.external_x[i] += force * wall.inward.x;
      a.external_y[i] += force * wall.inward.y;
    }
  }
}

void Boundary::add_stiffness(std::span<double> row_x, std::span<double> row_y) const {
  for (const auto& wall : state_.walls) {
    for (const auto i : wall.discs) {
      row_x[i] += 2.0 * stiffness_ * std::abs(wall.inward.x);
      row_y[i] += 2.0 * stiffness_ * std::abs(wall.inward.y);
    }
  }
  for (const auto& grip : grips_) {
    row_x[grip.disc] += stiffness_;
    row_y[grip.disc] += stiffness_;
  }
  if (exterior_) exterior_->add_stiffness(row_x, row_y);
}

double Boundary::wall_stress(const Assembly& a, std::size_t w) const {
  const Wall& wall = state_.walls[w];
  double sum = 0.0;
  for (const auto i : wall.discs) sum += push_of(a, wall, i, stiffness_) / wall.length;
  return sum;
}

Vec2 Boundary::wall_stress(const Assembly& a) const {
  return {0.5 * (wall_stress(a, 0) + wall_stress(a, 1)), 0.5 * (wall_stress(a, 2) + wall_stress(a, 3))};
}

double Boundary::wall_energy(const Assembly& a) const {
  double energy = 0.0;
  for (const auto& wall : state_.walls) {
    for (const auto i : wall.discs) {
      const double closing = std::max(0.0, closing_of(a, wall, i));
      energy += 0.5 * stiffness_ * closing * closing;
    }
  }
  return energy;
}

double Boundary::load_work(const Assembly& a) const {
  if (walled_) return state_.work;
  double work = state_.carried_work;
  for (std::size_t k = 0; k < edge_.size(); ++k)
    work += state_.load * (load_on_[k].x * a.ux[edge_[k]] + load_on_[k].y * a.uy[edge_[k]]);
  return work;
}

}  // namespace hfrac
