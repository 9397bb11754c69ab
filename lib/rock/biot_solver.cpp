// SPDX-License-Identifier: BSD-3-Clause
#include "rock/biot_solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "rock/biquadratic.hpp"

namespace hfrac {
namespace {

std::size_t index_of(RockSide side) {
  return static_cast<std::size_t>(side);
}

// The axis along a side's normal: 0 for x, 1 for y.
std::size_t normal_axis(RockSide side) {
  return side == RockSide::left || side == RockSide::right ? 0 : 1;
}

std::array<std::int32_t, 3> nodes_of(const RockMesh::Edge& edge) {
  return {edge.from, edge.middle, edge.to};
}

}  // namespace

BiotSolver::BiotSolver(RockMesh mesh, const BiotMaterial& material, const std::vector<Side>& sides)
    : mesh_(std::move(mesh)), material_(material) {
  number_motion(sides);
  number_pressures(sides);
  assemble();
  u_ = Vector::Zero(motions_);
  p_ = Vector::Zero(pressures_);
}

void BiotSolver::number_motion(const std::vector<Side>& sides) {
  constexpr std::int32_t unset = -2, held = -1;
  equation_.assign(mesh_.node.size(), {unset, unset});
  std::array<bool, 2> guided{};
  for (const auto& given : sides) {
    if (given.motion == SideMotion::free) continue;
    if (given.side == RockSide::well)
      throw Error(ErrorKind::argument,
                  "the wall of a well is curved: it can be free, not held or tied along its normal");
    const std::size_t axis = normal_axis(given.side);
    std::int32_t number = held;
    if (given.motion == SideMotion::rigid_plate) number = motions_++;
    if (given.motion == SideMotion::held) guided[axis] = true;
    for (const auto& edge : mesh_.edge) {
      if (edge.side != given.side) continue;
      for (const auto node : nodes_of(edge)) equation_[static_cast<std::size_t>(node)][axis] = number;
    }
  }
  // What no side holds is held at corners of the outer boundary: the loads are in balance, so these carry nothing.
  const auto corner = [&](double sx, double sy) {
    std::size_t best = 0;
    for (std::size_t k = 0; k < mesh_.node.size(); ++k) {
      if (sx * mesh_.node[k].x + sy * mesh_.node[k].y < sx * mesh_.node[best].x + sy * mesh_.node[best].y)
        best = k;
    }
    return best;
  };
  if (!guided[0]) equation_[corner(1.0, 1.0)][0] = held;
  if (!guided[1]) equation_[corner(1.0, 1.0)][1] = held;
  if (!guided[0] && !guided[1]) equation_[corner(-1.0, 1.0)][1] = held;
  for (auto& pair : equation_) {
    for (auto& number : pair) {
      if (number == unset) number = motions_++;
    }
  }
}

void BiotSolver::number_pressures(const std::vector<Side>& sides) {
  corner_.assign(mesh_.node.size(), -1);
  for (const auto& element : mesh_.element) {
    for (std::size_t k = 0; k < 4; ++k) {
      auto& number = corner_[static_cast<std::size_t>(element[k])];
      if (number < 0) number = pressures_++;
    }
  }
  drained_side_.assign(static_cast<std::size_t>(pressures_), -1);
  for (const auto& given : sides) {
    if (!given.drained) continue;
    for (const auto& edge : mesh_.edge) {
      if (edge.side != given.side) continue;
      for (const auto node : {edge.from, edge.to}) {
        drained_side_[static_cast<std::size_t>(corner_[static_cast<std::size_t>(node)])] =
            static_cast<std::int32_t>(given.side);
      }
    }
  }
}

void BiotSolver::assemble() {
  using Triplets = std::vector<Eigen::Triplet<double>>;
  Triplets stiffness, coupling, storage, flow;
  const double e = material_.youngs_modulus, lambda = material_.lambda() / e,
               g = material_.shear_modulus() / e;
  for (const auto& element : mesh_.element) {
    std::array<std::array<double, 18>, 18> k{};
    std::array<std::array<double, 4>, 18> q{};
    std::array<std::array<double, 4>, 4> s{}, h{};
    for (std::size_t gauss = 0; gauss < 9; ++gauss) {
      const ElementPoint p = at_point(mesh_, element, gauss_place[gauss % 3], gauss_place[gauss / 3]);
      const double area = gauss_weight[gauss % 3] * gauss_weight[gauss / 3] * p.jacobian;
      for (std::size_t a = 0; a < 9; ++a) {
        const Vec2 da = p.gradient[a];
        for (std::size_t b = 0; b < 9; ++b) {
          const Vec2 db = p.gradient[b];
          const double inner = g * dot(da, db);
          k[2 * a][2 * b] += area * ((lambda + g) * da.x * db.x + inner);
          k[2 * a][2 * b + 1] += area * (lambda * da.x * db.y + g * da.y * db.x);
          k[2 * a + 1][2 * b] += area * (lambda * da.y * db.x + g * da.x * db.y);
          k[2 * a + 1][2 * b + 1] += area * ((lambda + g) * da.y * db.y + inner);
        }
        for (std::size_t b = 0; b < 4; ++b) {
          q[2 * a][b] += area * material_.biot * da.x * p.pressure[b];
          q[2 * a + 1][b] += area * material_.biot * da.y * p.pressure[b];
        }
      }
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          s[a][b] += area * material_.storage * e * p.pressure[a] * p.pressure[b];
          h[a][b] += area * material_.mobility * e * dot(p.pressure_gradient[a], p.pressure_gradient[b]);
        }
      }
    }
    std::array<std::int32_t, 18> row{};
    std::array<std::int32_t, 4> column{};
    for (std::size_t a = 0; a < 18; ++a) row[a] = equation_[static_cast<std::size_t>(element[a / 2])][a % 2];
    for (std::size_t b = 0; b < 4; ++b) column[b] = corner_[static_cast<std::size_t>(element[b])];
    for (std::size_t a = 0; a < 18; ++a) {
      if (row[a] < 0) continue;
      for (std::size_t b = 0; b < 18; ++b) {
        if (row[b] >= 0) stiffness.emplace_back(row[a], row[b], k[a][b]);
      }
      for (std::size_t b = 0; b < 4; ++b) coupling.emplace_back(row[a], column[b], q[a][b]);
    }
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < 4; ++b) {
        storage.emplace_back(column[a], column[b], s[a][b]);
        flow.emplace_back(column[a], column[b], h[a][b]);
      }
    }
  }
  const auto build = [](Matrix& matrix, int rows, int columns, const Triplets& entries) {
    matrix.resize(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
  };
  build(stiffness_, motions_, motions_, stiffness);
  build(coupling_, motions_, pressures_, coupling);
  build(storage_, pressures_, pressures_, storage);
  build(flow_, pressures_, pressures_, flow);
}

void BiotSolver::set_stress(RockSide side, const PlaneStress2& total) {
  stress_[index_of(side)] = total;
  fresh_ = true;
}

void BiotSolver::set_pressure(RockSide side, double pressure) {
  imposed_pressure_[index_of(side)] = pressure;
  fresh_ = true;
}

// Work of the stress on the sides: the traction is -sigma n, n outward, and the side's normal times its length is its tangent
// turned clockwise.
void BiotSolver::fill_loads() {
  load_ = Vector::Zero(motions_);
  for (const auto& edge : mesh_.edge) {
    const PlaneStress2& stress = stress_[index_of(edge.side)];
    const auto node = nodes_of(edge);
    for (std::size_t gauss = 0; gauss < 3; ++gauss) {
      const double s = gauss_place[gauss];
      const std::array<double, 3> value = {parabola(-1.0, s), parabola(0.0, s), parabola(1.0, s)};
      const std::array<double, 3> slope = {parabola_slope(-1.0, s), parabola_slope(0.0, s),
                                           parabola_slope(1.0, s)};
      Vec2 tangent{};
      for (std::size_t k = 0; k < 3; ++k)
        tangent = tangent + slope[k] * mesh_.node[static_cast<std::size_t>(node[k])];
      const Vec2 normal{tangent.y, -tangent.x};
      const Vec2 push{-(stress.xx * normal.x + stress.xy * normal.y),
                      -(stress.xy * normal.x + stress.yy * normal.y)};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& number = equation_[static_cast<std::size_t>(node[k])];
        const double weight = gauss_weight[gauss] * value[k] / material_.youngs_modulus;
        if (number[0] >= 0) load_[number[0]] += weight * push.x;
        if (number[1] >= 0) load_[number[1]] += weight * push.y;
      }
    }
  }
}

// storing (Q' u + S p) + flowing H p = right, together with K u - Q p = load.
void BiotSolver::solve(double storing, double flowing, bool imposed, const Vector& right) {
  fill_loads();
  Vector known = Vector::Zero(pressures_);
  if (storing != factored_storing_ || flowing != factored_flowing_ || imposed != factored_imposed_) {
    unknown_.assign(static_cast<std::size_t>(pressures_), -1);
    std::int32_t size = motions_;
    for (std::int32_t k = 0; k < pressures_; ++k) {
      if (!imposed || drained_side_[static_cast<std::size_t>(k)] < 0)
        unknown_[static_cast<std::size_t>(k)] = size++;
    }
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](const Matrix& matrix, double factor, bool row_pressure, bool column_pressure,
                         bool turned) {
      for (int outer = 0; outer < matrix.outerSize(); ++outer) {
        for (Matrix::InnerIterator it(matrix, outer); it; ++it) {
          std::int32_t row = static_cast<std::int32_t>(turned ? it.col() : it.row());
          std::int32_t column = static_cast<std::int32_t>(turned ? it.row() : it.col());
          if (row_pressure) row = unknown_[static_cast<std::size_t>(row)];
          if (column_pressure) column = unknown_[static_cast<std::size_t>(column)];
          if (row >= 0 && column >= 0) entries.emplace_back(row, column, factor * it.value());
        }
      }
    };
    add(stiffness_, 1.0, false, false, false);
    add(coupling_, -1.0, false, true, false);
    add(coupling_, -storing, true, false, true);
    add(storage_, -storing, true, true, false);
    add(flow_, -flowing, true, true, false);
    system_.resize(size, size);
    system_.setFromTriplets(entries.begin(), entries.end());
    factor_.compute(system_);
    if (factor_.info() != Eigen::Success)
      throw Error(ErrorKind::model,
                  "the continuum's equations have no single solution: " + factor_.lastErrorMessage());
    factored_storing_ = storing;
    factored_flowing_ = flowing;
    factored_imposed_ = imposed;
  }
  for (std::int32_t k = 0; k < pressures_; ++k) {
    const auto side = drained_side_[static_cast<std::size_t>(k)];
    if (imposed && side >= 0)
      known[k] = imposed_pressure_[static_cast<std::size_t>(side)] / material_.youngs_modulus;
  }
  const Vector forces = load_ + coupling_ * known;
  const Vector fluid = -right + storing * (storage_ * known) + flowing * (flow_ * known);
  Vector all(system_.rows());
  all.head(motions_) = forces;
  for (std::int32_t k = 0; k < pressures_; ++k) {
    if (unknown_[static_cast<std::size_t>(k)] >= 0) all[unknown_[static_cast<std::size_t>(k)]] = fluid[k];
  }
  const Vector found = factor_.solve(all);
  u_ = found.head(motions_);
  for (std::int32_t k = 0; k < pressures_; ++k) {
    const auto row = unknown_[static_cast<std::size_t>(k)];
    p_[k] = row >= 0 ? found[row] : known[k];
  }
}

BiotSolver::Vector BiotSolver::stored() const {
  return coupling_.transpose() * u_ + storage_ * p_;
}

void BiotSolver::load_undrained() {
  solve(1.0, 0.0, false, Vector::Zero(pressures_));
  fresh_ = true;
}

void BiotSolver::load_steady() {
  const bool drains =
      std::any_of(drained_side_.begin(), drained_side_.end(), [](std::int32_t side) { return side >= 0; });
  if (!drains) return load_undrained();
  solve(0.0, 1.0, true, Vector::Zero(pressures_));
  fresh_ = true;
}

void BiotSolver::advance(double step) {
  const Vector before = stored();
  if (fresh_) {
    solve(1.0, step, true, before);
    fresh_ = false;
    return;
  }
  const double share = 2.0 - std::sqrt(2.0);  // of the step done by the trapezoidal rule
  const double flowing = 0.5 * share * step;
  solve(1.0, flowing, true, before - flowing * (flow_ * p_));
  const Vector between = stored();
  const double c = 1.0 / (share * (2.0 - share));
  solve(1.0, flowing, true, c * (between - (1.0 - share) * (1.0 - share) * before));
}

Vec2 BiotSolver::displacement(std::int32_t node) const {
  const auto& number = equation_[static_cast<std::size_t>(node)];
  return {number[0] >= 0 ? u_[number[0]] : 0.0, number[1] >= 0 ? u_[number[1]] : 0.0};
}

double BiotSolver::pressure(std::int32_t corner) const {
  return material_.youngs_modulus * p_[corner_[static_cast<std::size_t>(corner)]];
}

double BiotSolver::steady_outflow(RockSide side) const {
  const Vector inflow = flow_ * p_;
  double sum = 0.0;
  for (std::int32_t k = 0; k < pressures_; ++k) {
    if (drained_side_[static_cast<std::size_t>(k)] == static_cast<std::int32_t>(side)) sum -= inflow[k];
  }
  return sum;
}

BiotSolver::Sample BiotSolver::sample(std::size_t element, double s, double t) const {
  const auto& nodes = mesh_.element[element];
  const ElementPoint point = at_point(mesh_, nodes, s, t);
  Sample result{point.place, {}, 0.0, {}};
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < 9; ++k) {
    const Vec2 u = displacement(nodes[k]), gradient = point.gradient[k];
    result.displacement = result.displacement + point.value[k] * u;
    xx += gradient.x * u.x;
    yy += gradient.y * u.y;
    xy += 0.5 * (gradient.y * u.x + gradient.x * u.y);
  }
  for (std::size_t k = 0; k < 4; ++k) result.pressure += point.pressure[k] * pressure(nodes[k]);
  const double g = material_.shear_modulus();
  const double mean = material_.lambda() * (xx + yy) - material_.biot * result.pressure;
  result.total = {-(mean + 2.0 * g * xx), -(mean + 2.0 * g * yy), -2.0 * g * xy};
  return result;
}

}  // namespace hfrac
