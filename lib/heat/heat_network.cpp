// SPDX-License-Identifier: BSD-3-Clause
#include "heat/heat_network.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "linear/conjugate_gradient.hpp"
#include "linear/symmetric_factor.hpp"
#include "options/choices.hpp"

namespace hfrac {
namespace {

// Width of the face between two discs: the distance of the two pores' centroids across the line of centres. On the outer boundary and
// at wells only the side that is rock counts.
double face_width(const Assembly& a, const Network& n, std::size_t e) {
  const auto i = static_cast<std::size_t>(a.first[e]), j = static_cast<std::size_t>(a.second[e]);
  const Vec2 line{a.x[j] - a.x[i], a.y[j] - a.y[i]}, across{-line.y / a.length(e), line.x / a.length(e)};
  const Vec2 middle{0.5 * (a.x[i] + a.x[j]), 0.5 * (a.y[i] + a.y[j])};
  double width = 0.0;
  for (const auto d : {n.left[e], n.right[e]}) {
    if (n.kind[static_cast<std::size_t>(d)] == DomainKind::rock)
      width += std::abs(dot(n.centroid[static_cast<std::size_t>(d)] - middle, across));
  }
  return width;
}

Vec2 centre_of(const Assembly& a, std::int32_t disc) {
  return {a.x[disc], a.y[disc]};
}

double polygon_area(const Assembly& a, const Network& n, std::int64_t d) {
  double twice = 0.0;
  for (auto k = n.corner_start[static_cast<std::size_t>(d)];
       k < n.corner_start[static_cast<std::size_t>(d) + 1]; ++k) {
    const auto corner = n.corner(d, k);
    twice += cross(centre_of(a, corner.disc), centre_of(a, corner.after));
  }
  return 0.5 * std::abs(twice);
}

// Conductivity of the network with f = 1: the discs of outer boundary and well walls follow a uniform gradient, and the rest is as warm as
// heat flow wants it; what is then dissipated, over gradient squared and area. Mean of both directions.
class Conductivity {
 public:
  Conductivity(const Assembly& a, const Network& n, const HeatNetwork& h) : a_(a), n_(n), h_(h) {
    const auto discs = static_cast<std::size_t>(a.disc_count());
    const auto domains = h.face.empty() ? std::size_t{0} : n.kind.size();
    unknown_.assign(discs + domains, 0);
    for (std::size_t d = 0; d < n.kind.size(); ++d) {
      if (n.kind[d] == DomainKind::rock) continue;
      for (auto k = n.corner_start[d]; k < n.corner_start[d + 1]; ++k)
        unknown_[static_cast<std::size_t>(n.corner_disc[static_cast<std::size_t>(k)])] = -1;
      if (domains > 0) unknown_[discs + d] = -2;  // takes no part
    }
    for (auto& place : unknown_) {
      if (place == 0) place = count_++;
    }
  }

  double measure() {
    double area = 0.0;
    for (std::size_t d = 1; d < n_.kind.size(); ++d) {
      if (n_.kind[d] == DomainKind::rock) area += polygon_area(a_, n_, static_cast<std::int64_t>(d));
    }
    return 0.5 * (dissipation(a_.x) + dissipation(a_.y)) / area;
  }

 private:
  // fn(node, node, conductance)
  template <class Function>
  void each_way(Function&& fn) const {
    for (std::size_t e = 0; e < a_.first.size(); ++e)
      fn(static_cast<std::size_t>(a_.first[e]), static_cast<std::size_t>(a_.second[e]), h_.contact[e]);
    const auto discs = static_cast<std::size_t>(a_.disc_count());
    for (std::size_t d = 0; !h_.face.empty() && d < n_.kind.size(); ++d) {
      if (n_.kind[d] != DomainKind::rock) continue;
      for (auto k = n_.corner_start[d]; k < n_.corner_start[d + 1]; ++k) {
        const auto c = static_cast<std::size_t>(k);
        fn(static_cast<std::size_t>(n_.corner_disc[c]), discs + d, h_.face[c]);
      }
    }
  }

  double dissipation(const Array<double>& along) {
    const auto imposed = [&](std::size_t node) { return node < along.size() ? along[node] : 0.0; };
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(count_), t = Eigen::VectorXd::Zero(count_);
    each_way([&](std::size_t p, std::size_t q, double g) {
      for (const auto& [node, other] : {std::pair{p, q}, std::pair{q, p}}) {
        const auto row = unknown_[node], column = unknown_[other];
        if (row < 0) continue;
        entries.emplace_back(row, row, g);
        if (column < 0) {
          rhs[row] += g * imposed(other);
        } else if (row > column) {
          entries.emplace_back(row, column, -g);
        }
      }
    });
    SparseMatrix matrix(count_, count_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (count_ <= largest_to_factorise) {
      const SymmetricFactor factor(matrix);
      if (factor.succeeded()) t = factor.solve(rhs);
    } else {
      ConjugateGradient solver;
      if (!solver.prepare(matrix) || solver.solve(rhs, t, 1e-8, 20000) < 0) t.setConstant(NAN);
    }
    double sum = 0.0;
    const auto temperature = [&](std::size_t node) {
      return unknown_[node] >= 0 ? t[unknown_[node]] : imposed(node);
    };
    each_way([&](std::size_t p, std::size_t q, double g) {
      const double drop = temperature(p) - temperature(q);
      sum += g * drop * drop;
    });
    return sum;
  }

  const Assembly& a_;
  const Network& n_;
  const HeatNetwork& h_;
  std::vector<std::int32_t> unknown_;
  std::int32_t count_ = 0;
};

}  // namespace

double sector_angle(const Assembly& a, const Network& n, std::int64_t d, std::int32_t k) {
  const auto [disc, before, after] = n.corner(d, k);
  const Vec2 centre = centre_of(a, disc);
  return angle_between(centre_of(a, after) - centre, centre_of(a, before) - centre);
}

HeatNetwork build_heat_network(const Assembly& a, const Network& n, const Options& o) {
  HeatNetwork h;
  for (std::int64_t i = 0; i < a.disc_count(); ++i) h.capacity.push_back(a.mass(i) * o.thermal_specific_heat);
  if (ThermalMode{o.thermal_mode} != ThermalMode::transport) return h;
  for (std::size_t e = 0; e < a.first.size(); ++e) h.contact.push_back(face_width(a, n, e) / a.length(e));
  if (FlowScheme{o.flow_scheme} != FlowScheme::off) {
    h.face.assign(n.corner_disc.size(), 0.0);
    for (std::int64_t d = 1; d < n.domain_count(); ++d) {
      for (auto k = n.corner_start[static_cast<std::size_t>(d)];
           k < n.corner_start[static_cast<std::size_t>(d) + 1]; ++k)
        h.face[static_cast<std::size_t>(k)] = 4.0 * sector_angle(a, n, d, k);
    }
  }
  const double bare = Conductivity(a, n, h).measure();
  if (!(bare > 0.0) || !std::isfinite(bare)) {
    throw Error(ErrorKind::model,
                "the model is too small to conduct heat: it has no disc away from its outer boundary and "
                "wells; raise "
                "packing.disc_count, or set thermal.mode = \"uniform\".");
  }
  h.factor = o.thermal_conductivity / bare;
  for (auto& g : h.contact) g *= h.factor;
  for (std::size_t k = 0; k < h.face.size(); ++k) {
    if (h.face[k] == 0.0) continue;
    const double inside = h.face[k] * h.factor,  // 4 f angle
        film = o.thermal_film_coefficient * a.radius[static_cast<std::size_t>(n.corner_disc[k])] * 0.25 *
               h.face[k];
    h.face[k] = film > 0.0 ? 1.0 / (1.0 / inside + 1.0 / film) : inside;
  }
  return h;
}

}  // namespace hfrac
