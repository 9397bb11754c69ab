// SPDX-License-Identifier: BSD-3-Clause
#include "solid/exterior.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace hfrac {
namespace {

constexpr std::size_t discs_per_point = 4, most_points = 96, fewest_points = 8;

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::model, "boundary.kind = \"infinite\": " + why +
                                    "; raise packing.disc_count, or use boundary.kind = \"stress\".");
}

// Discs of the outer loop anticlockwise, from the one at the lower left corner on.
std::vector<std::int32_t> loop_of(const Assembly& a, const Network& n) {
  std::vector<std::int32_t> loop(n.corner_disc.begin() + n.corner_start[0],
                                 n.corner_disc.begin() + n.corner_start[1]);
  double area = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const auto i = loop[k], j = loop[(k + 1) % loop.size()];
    area += cross({a.x[i], a.y[i]}, {a.x[j], a.y[j]});
  }
  if (area < 0.0) std::reverse(loop.begin(), loop.end());
  const auto first = std::min_element(loop.begin(), loop.end(), [&](std::int32_t i, std::int32_t j) {
    return a.x[i] + a.y[i] < a.x[j] + a.y[j];
  });
  std::rotate(loop.begin(), first, loop.end());
  return loop;
}

}  // namespace

Exterior::Exterior(const Assembly& a, const Network& n, const PlaneElasticity& rock) : rock_(rock) {
  lay_points(a, n);
  const auto points = static_cast<Eigen::Index>(point_.size());
  mass_ = Eigen::MatrixXd::Zero(points, points);
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(points, 2);
  for (const auto& at : rim_) {
    const double whole = at.weight[0] + at.weight[1];
    for (std::size_t p = 0; p < 2; ++p) {
      places(at.point[p], 0) += at.weight[p] * a.x[at.disc];
      places(at.point[p], 1) += at.weight[p] * a.y[at.disc];
      for (std::size_t q = 0; q < 2; ++q)
        mass_(at.point[p], at.point[q]) += at.weight[p] * at.weight[q] / whole;
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(mass_);
  if (factor.info() != Eigen::Success)
    refuse("the outer loop has too few discs, " + std::to_string(rim_.size()));
  const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(points, points));
  places = inverse * places;
  Vec2 centre{};
  for (Eigen::Index p = 0; p < points; ++p)
    centre = centre + (1.0 / static_cast<double>(points)) * Vec2{places(p, 0), places(p, 1)};
  for (Eigen::Index p = 0; p < points; ++p)
    point_[static_cast<std::size_t>(p)] = Vec2{places(p, 0), places(p, 1)} - centre;
  const Eigen::MatrixXd plane = infinite_plane_stiffness(point_, {}, rock);
  if (plane.size() == 0)
    refuse("the outline of the discs is not seen whole from its middle, as the rock beyond needs it");
  // Inverse of M for both components, interleaved.
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * points, 2 * points), masses = both;
  for (Eigen::Index p = 0; p < points; ++p) {
    for (Eigen::Index q = 0; q < points; ++q) {
      both(2 * p, 2 * q) = both(2 * p + 1, 2 * q + 1) = inverse(p, q);
      masses(2 * p, 2 * q) = masses(2 * p + 1, 2 * q + 1) = mass_(p, q);
    }
  }
  stiffness_ = both * plane * both;
  stiffness_ = (0.5 * (stiffness_ + stiffness_.transpose())).eval();
  compliance_ = masses * Eigen::LLT<Eigen::MatrixXd>(plane).solve(masses);
  compliance_ = (0.5 * (compliance_ + compliance_.transpose())).eval();
  rest_.assign(size(), 0.0);
  far_rest_ = displaced_ = traction_ = rest_;
}

// Along each side between corners, at equal distances; an even number to a side, so that no piece of the rim bends round a corner.
void Exterior::lay_points(const Assembly& a, const Network& n) {
  const auto loop = loop_of(a, n);
  if (loop.size() < 3 * fewest_points)
    refuse("the outer loop has too few discs, " + std::to_string(loop.size()) + " where " +
           std::to_string(3 * fewest_points) + " are needed");
  std::vector<double> way{0.0};  // m, along the loop to each disc
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const auto i = loop[k], j = loop[(k + 1) % loop.size()];
    way.push_back(way.back() + std::hypot(a.x[j] - a.x[i], a.y[j] - a.y[i]));
  }
  const auto farthest = [&](double by_x, double by_y) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < loop.size(); ++k) {
      if (by_x * (a.x[loop[k]] - a.x[loop[best]]) + by_y * (a.y[loop[k]] - a.y[loop[best]]) > 0.0) best = k;
    }
    return best;
  };
  std::vector<std::size_t> corner{0, farthest(1.0, -1.0), farthest(1.0, 1.0), farthest(-1.0, 1.0),
                                  loop.size()};
  if (!std::is_sorted(corner.begin(), corner.end())) refuse("the outline of the discs has no four corners");
  const double wanted =
      static_cast<double>(std::clamp(loop.size() / discs_per_point, fewest_points, most_points));
  for (std::size_t side = 0; side < 4; ++side) {
    const double from = way[corner[side]], length = way[corner[side + 1]] - from;
    const auto pairs = std::max(1.0, std::round(0.5 * wanted * length / way.back()));
    const auto pieces = static_cast<std::size_t>(2.0 * pairs);
    const auto first = static_cast<std::int32_t>(point_.size());
    for (std::size_t k = corner[side]; k < corner[side + 1]; ++k) {
      const double at = (way[k] - from) / length * static_cast<double>(pieces), piece = std::floor(at);
      const double behind = k > 0 ? way[k] - way[k - 1] : way.back() - way[loop.size() - 1];
      const double own = 0.5 * (behind + way[k + 1] - way[k]);
      const auto point = first + static_cast<std::int32_t>(piece);
      rim_.push_back({loop[k], {point, point + 1}, {own * (1.0 - (at - piece)), own * (at - piece)}});
    }
    point_.resize(point_.size() + pieces);
  }
  for (auto& at : rim_) at.point[1] %= static_cast<std::int32_t>(point_.size());
}

void Exterior::rest_at(std::span<const Vec2> displacement) {
  std::fill(rest_.begin(), rest_.end(), 0.0);
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    for (std::size_t p = 0; p < 2; ++p) {
      const auto point = 2 * static_cast<std::size_t>(rim_[k].point[p]);
      rest_[point] += rim_[k].weight[p] * displacement[k].x;
      rest_[point + 1] += rim_[k].weight[p] * displacement[k].y;
    }
  }
  far_rest_ = rest_;
}

void Exterior::add_far_field(double along_x, double along_y) {
  const double strain_x = -(along_x - rock_.poisson * along_y) / rock_.modulus,
               strain_y = -(along_y - rock_.poisson * along_x) / rock_.modulus;
  const auto points = static_cast<Eigen::Index>(point_.size());
  for (Eigen::Index p = 0; p < points; ++p) {
    double x = 0.0, y = 0.0;
    for (Eigen::Index q = 0; q < points; ++q) {
      x += mass_(p, q) * point_[static_cast<std::size_t>(q)].x;
      y += mass_(p, q) * point_[static_cast<std::size_t>(q)].y;
    }
    const auto at = 2 * static_cast<std::size_t>(p);
    far_rest_[at] = rest_[at] + strain_x * x;
    far_rest_[at + 1] = rest_[at + 1] + strain_y * y;
  }
}

void Exterior::sum_up(const Assembly& a, double share, std::vector<double>& sums) const {
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = -share * far_rest_[k];
  for (const auto& at : rim_) {
    for (std::size_t p = 0; p < 2; ++p) {
      const auto point = 2 * static_cast<std::size_t>(at.point[p]);
      sums[point] += at.weight[p] * a.ux[at.disc];
      sums[point + 1] += at.weight[p] * a.uy[at.disc];
    }
  }
}

// Column by column: no sum waits for the one before it.
void Exterior::answer(const Assembly& a, double share) {
  sum_up(a, share, displaced_);
  std::fill(traction_.begin(), traction_.end(), 0.0);
  for (std::size_t column = 0; column < traction_.size(); ++column) {
    const double* h = stiffness_.data() + column * traction_.size();
    const double by = displaced_[column];
    for (std::size_t row = 0; row < traction_.size(); ++row) traction_[row] -= h[row] * by;
  }
}

Vec2 Exterior::force_on(const RimDisc& at) const {
  const double* one = &traction_[2 * static_cast<std::size_t>(at.point[0])];
  const double* other = &traction_[2 * static_cast<std::size_t>(at.point[1])];
  return {at.weight[0] * one[0] + at.weight[1] * other[0], at.weight[0] * one[1] + at.weight[1] * other[1]};
}

double Exterior::energy(const Assembly& a, double share) const {
  std::vector<double> sums(size());
  sum_up(a, share, sums);
  const auto displaced = Eigen::Map<const Eigen::VectorXd>(sums.data(), static_cast<Eigen::Index>(size()));
  return 0.5 * displaced.dot(stiffness_ * displaced);
}

// |w N H N' w| by the triangle inequality.
void Exterior::add_stiffness(std::span<double> row_x, std::span<double> row_y) const {
  Eigen::VectorXd length = Eigen::VectorXd::Zero(stiffness_.rows());
  for (const auto& at : rim_) {
    for (std::size_t p = 0; p < 2; ++p) length.segment<2>(2 * at.point[p]).array() += at.weight[p];
  }
  const Eigen::VectorXd rows = stiffness_.cwiseAbs() * length;
  for (const auto& at : rim_) {
    for (std::size_t p = 0; p < 2; ++p) {
      row_x[at.disc] += at.weight[p] * rows[2 * at.point[p]];
      row_y[at.disc] += at.weight[p] * rows[2 * at.point[p] + 1];
    }
  }
}

}  // namespace hfrac
