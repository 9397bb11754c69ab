// SPDX-License-Identifier: BSD-3-Clause
#include "heat/heat_solver.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Residual over right-hand side, both of the change of temperature.
constexpr double tolerance = 1e-12;
constexpr int most_iterations = 2000;

}  // namespace

HeatSolver::HeatSolver(const Assembly& a, const Network& n, const HeatNetwork& heat, const Options& o)
    : assembly_(a),
      network_(n),
      heat_(heat),
      start_(o.thermal_rock_temperature),
      carrier_(o.thermal_fluid_density * o.thermal_fluid_specific_heat),
      discs_(static_cast<std::size_t>(a.disc_count())),
      wet_(!heat.face.empty()) {
  nodes_ = discs_ + (wet_ ? n.kind.size() : 0);
  fixed_.assign(nodes_, 0);
  fixed_at_.assign(nodes_, 0.0);
  net_.assign(n.kind.size(), 0.0);
  const auto size = static_cast<Eigen::Index>(nodes_);
  rhs_.setZero(size);
  temperature_.setZero(size);

  const auto domain_node = [&](std::int32_t d) { return static_cast<int>(discs_) + d; };
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(nodes_ + 8 * nodes_);
  for (int node = 0; node < static_cast<int>(nodes_); ++node) entries.emplace_back(node, node, 1.0);
  const auto join = [&](int p, int q) {
    if (p == q) return;
    entries.emplace_back(p, q, 0.0);
    entries.emplace_back(q, p, 0.0);
  };
  for (std::size_t e = 0; e < a.first.size(); ++e) join(a.first[e], a.second[e]);
  for (std::size_t d = 0; wet_ && d < n.kind.size(); ++d) {
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
      join(n.corner_disc[static_cast<std::size_t>(k)], domain_node(static_cast<std::int32_t>(d)));
  }
  for (std::size_t e = 0; wet_ && e < n.left.size(); ++e)
    join(domain_node(n.left[e]), domain_node(n.right[e]));
  matrix_.resize(size, size);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();

  const auto place = [&](int row, int column) {
    const auto* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const auto* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return static_cast<std::int32_t>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr());
  };
  const auto both = [&](std::vector<std::int32_t>& to, int p, int q) {
    to.push_back(place(p, q));
    to.push_back(place(q, p));
  };
  for (int node = 0; node < static_cast<int>(nodes_); ++node) diagonal_.push_back(place(node, node));
  for (std::size_t e = 0; e < a.first.size(); ++e) both(bond_place_, a.first[e], a.second[e]);
  for (std::size_t d = 0; wet_ && d < n.kind.size(); ++d) {
    for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
      both(face_place_, n.corner_disc[static_cast<std::size_t>(k)],
           domain_node(static_cast<std::int32_t>(d)));
  }
  for (std::size_t e = 0; wet_ && e < n.left.size(); ++e)
    both(pipe_place_, domain_node(n.left[e]), domain_node(n.right[e]));
}

double HeatSolver::fluid_capacity(std::size_t d) const {
  const double held = network_.is_own(d) ? network_.content[d] : 0.0;
  return carrier_ * std::max(0.0, network_.volume[d] + held);
}

// Nodes that keep their temperature in this step.
void HeatSolver::choose_fixed(const HeatState& s, const std::vector<std::int32_t>& well_domain) {
  for (std::size_t i = 0; i < discs_; ++i) {
    fixed_[i] = static_cast<char>(s.held[i]);
    fixed_at_[i] = s.disc[i];
  }
  if (!wet_) return;
  std::fill(net_.begin(), net_.end(), 0.0);
  for (std::size_t e = 0; e < network_.left.size(); ++e) {
    net_[static_cast<std::size_t>(network_.left[e])] -= network_.flow[e];
    net_[static_cast<std::size_t>(network_.right[e])] += network_.flow[e];
  }
  std::fill(fixed_.begin() + static_cast<std::ptrdiff_t>(discs_), fixed_.end(), 0);
  fixed_[discs_] = 1;
  fixed_at_[discs_] = start_;
  for (std::size_t w = 0; w < well_domain.size(); ++w) {
    const auto d = static_cast<std::size_t>(well_domain[w]);
    fixed_[discs_ + d] = net_[d] < 0.0 ? 1 : 0;
    fixed_at_[discs_ + d] = s.well[w];
  }
}

void HeatSolver::fill(const HeatState& s, double duration) {
  double* value = matrix_.valuePtr();
  std::fill(value, value + matrix_.nonZeros(), 0.0);
  const auto old = [&](std::size_t node) { return node < discs_ ? s.disc[node] : s.fluid[node - discs_]; };
  for (std::size_t node = 0; node < nodes_; ++node) {
    double capacity = 0.0;
    if (node < discs_) {
      capacity = heat_.capacity[node];
    } else {
      const std::size_t d = node - discs_;
      capacity = network_.is_own(d) ? std::max(0.0, fluid_capacity(d) - carrier_ * duration * net_[d])
                                    : fluid_capacity(d);
    }
    const bool fixed = fixed_[node] != 0;
    // Rows of nodes that keep their temperature weigh as much as others. A pore that holds nothing is as warm as its discs.
    const double weight = fixed ? std::max(capacity, carrier_) / duration : capacity / duration;
    value[diagonal_[node]] = weight;
    rhs_[static_cast<Eigen::Index>(node)] = weight * (fixed ? fixed_at_[node] : old(node));
  }
  const auto exchange = [&](std::size_t p, std::size_t q, double g, const std::int32_t* place) {
    if (fixed_[p] == 0) {
      value[diagonal_[p]] += g;
      value[place[0]] -= g;
    }
    if (fixed_[q] == 0) {
      value[diagonal_[q]] += g;
      value[place[1]] -= g;
    }
  };
  for (std::size_t e = 0; e < heat_.contact.size(); ++e) {
    exchange(static_cast<std::size_t>(assembly_.first[e]), static_cast<std::size_t>(assembly_.second[e]),
             heat_.contact[e], &bond_place_[2 * e]);
  }
  if (!wet_) return;
  for (std::size_t d = 1; d < network_.kind.size(); ++d) {
    for (auto k = network_.corner_start[d]; k < network_.corner_start[d + 1]; ++k) {
      const auto c = static_cast<std::size_t>(k);
      exchange(static_cast<std::size_t>(network_.corner_disc[c]), discs_ + d, heat_.face[c],
               &face_place_[2 * c]);
    }
  }
  for (std::size_t e = 0; e < network_.left.size(); ++e) {
    const auto l = discs_ + static_cast<std::size_t>(network_.left[e]),
               r = discs_ + static_cast<std::size_t>(network_.right[e]);
    if (l == r) continue;
    const double c = carried(e);
    const std::size_t into = c > 0.0 ? r : l;
    if (fixed_[into] != 0) continue;
    value[diagonal_[into]] += std::abs(c);
    value[pipe_place_[2 * e + (c > 0.0 ? 1 : 0)]] -= std::abs(c);
  }
}

// From temperature_ as it was to what it is after the step.
void HeatSolver::solve() {
  residual_ = rhs_ - matrix_ * temperature_;
  if (residual_.squaredNorm() == 0.0) return;
  gradients_.setTolerance(tolerance);
  gradients_.setMaxIterations(most_iterations);
  gradients_.compute(matrix_);
  change_ = gradients_.solve(residual_);
  if (gradients_.info() != Eigen::Success || !std::isfinite(change_.squaredNorm())) {
    if (!analysed_) factor_.analyzePattern(matrix_);
    analysed_ = true;
    factor_.factorize(matrix_);
    if (factor_.info() == Eigen::Success) change_ = factor_.solve(residual_);
  }
  temperature_ += change_;
  if (std::isfinite(temperature_.squaredNorm())) return;
  throw Error(ErrorKind::diverged,
              "the temperatures of the step could not be solved for; use a shorter stepping.flow_step");
}

// What came in from nodes that are no part of rock and pores, or keep their temperature.
void HeatSolver::accumulate(HeatState& s, double duration) const {
  const auto t = [&](std::size_t node) { return temperature_[static_cast<Eigen::Index>(node)]; };
  const auto conduct = [&](std::size_t p, std::size_t q, double g, double& in) {
    in += duration * g * (t(p) - t(q));  // from p to q
  };
  for (std::size_t e = 0; e < heat_.contact.size(); ++e) {
    const auto i = static_cast<std::size_t>(assembly_.first[e]),
               j = static_cast<std::size_t>(assembly_.second[e]);
    if (fixed_[i] != 0 && fixed_[j] == 0) conduct(i, j, heat_.contact[e], s.from_held);
    if (fixed_[j] != 0 && fixed_[i] == 0) conduct(j, i, heat_.contact[e], s.from_held);
  }
  if (!wet_) return;
  for (std::size_t d = 1; d < network_.kind.size(); ++d) {
    const bool well = network_.is_well(d);
    for (auto k = network_.corner_start[d]; k < network_.corner_start[d + 1]; ++k) {
      const auto c = static_cast<std::size_t>(k), i = static_cast<std::size_t>(network_.corner_disc[c]);
      if (well && fixed_[i] == 0) conduct(discs_ + d, i, heat_.face[c], s.from_wells);
      if (!well && fixed_[i] != 0) conduct(i, discs_ + d, heat_.face[c], s.from_held);
    }
  }
  for (std::size_t e = 0; e < network_.left.size(); ++e) {
    const auto l = static_cast<std::size_t>(network_.left[e]),
               r = static_cast<std::size_t>(network_.right[e]);
    const bool rock_l = network_.is_own(l), rock_r = network_.is_own(r);
    if (rock_l == rock_r) continue;
    const double c = carried(e);
    const double rightwards = duration * c * (t(discs_ + (c > 0.0 ? l : r)) - start_);
    double& total = network_.is_well(rock_l ? r : l) ? s.from_wells : s.from_outside;
    total += rock_r ? rightwards : -rightwards;
  }
}

void HeatSolver::advance(HeatState& s, const std::vector<std::int32_t>& well_domain, double duration) {
  choose_fixed(s, well_domain);
  fill(s, duration);
  for (std::size_t node = 0; node < nodes_; ++node)
    temperature_[static_cast<Eigen::Index>(node)] = node < discs_ ? s.disc[node] : s.fluid[node - discs_];
  solve();
  accumulate(s, duration);
  // Those that keep their temperature do so to the last bit.
  for (std::size_t node = 0; node < nodes_; ++node) {
    const double t = fixed_[node] != 0 ? fixed_at_[node] : temperature_[static_cast<Eigen::Index>(node)];
    (node < discs_ ? s.disc[node] : s.fluid[node - discs_]) = t;
  }
}

double HeatSolver::stored(const HeatState& s) const {
  double heat = 0.0;
  for (std::size_t i = 0; i < discs_; ++i) heat += heat_.capacity[i] * (s.disc[i] - start_);
  for (std::size_t d = 1; wet_ && d < network_.kind.size(); ++d) {
    if (network_.is_own(d)) heat += fluid_capacity(d) * (s.fluid[d] - start_);
  }
  return heat;
}

}  // namespace hfrac
