// SPDX-License-Identifier: BSD-3-Clause
#include "options/grading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hfrac {
namespace {

constexpr double default_width = 0.05;  // of the smaller model side
constexpr double places = 4e4;          // that the integral over the model is a sum of
constexpr int halvings = 60;

// Distances to the nearest line at the middles of equal squares that cover the model.
std::vector<double> distances(const Grading& grading, double width, double height) {
  const double side = std::sqrt(width * height / places);
  const auto columns = static_cast<int>(std::ceil(width / side)),
             rows = static_cast<int>(std::ceil(height / side));
  std::vector<double> all;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      all.push_back(grading.distance({(column + 0.5) * width / columns, (row + 0.5) * height / rows}));
  return all;
}

double radius_at(const Grading& g, double distance) {
  return std::min(g.coarsening * g.fine, g.fine + g.growth * std::max(0.0, distance - g.half_width));
}

}  // namespace

double Grading::distance(Vec2 place) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2 centre : centres) {
    const Vec2 d = place - centre;
    const double beyond = std::max(0.0, std::abs(dot(d, along)) - half_length), across = cross(along, d);
    nearest = std::min(nearest, beyond * beyond + across * across);
  }
  return std::sqrt(nearest);
}

double Grading::at(Vec2 place) const {
  return graded() ? radius_at(*this, distance(place)) : fine;
}

Grading grading_of(const CaseDefinition& definition) {
  const Options& o = definition.options;
  Grading g;
  const double uniform = g.fine = expected_mean_radius(o);
  if (o.packing_coarsening <= 1.0) return g;
  const double side = std::min(o.model_width, o.model_height);
  g.coarsening = o.packing_coarsening;
  g.growth = o.packing_radius_growth;
  g.half_width = o.packing_fine_half_width > 0.0 ? o.packing_fine_half_width : default_width * side;
  g.half_length =
      o.packing_fine_half_length > 0.0 ? o.packing_fine_half_length : o.stop_extent_fraction * side;
  g.along = {std::cos(o.packing_fine_azimuth), std::sin(o.packing_fine_azimuth)};
  for (const auto& well : definition.wells) g.centres.push_back({well.x, well.y});
  if (g.centres.empty()) g.centres.push_back({0.5 * o.model_width, 0.5 * o.model_height});

  // A uniform packing has the count with R = `uniform`: the mean of (uniform / R)^2 over the model is 1. It falls with `fine`.
  const std::vector<double> all = distances(g, o.model_width, o.model_height);
  double low = uniform / g.coarsening, high = uniform;
  for (int k = 0; k < halvings; ++k) {
    g.fine = 0.5 * (low + high);
    double sum = 0.0;
    for (const double distance : all) {
      const double share = uniform / radius_at(g, distance);
      sum += share * share;
    }
    (sum > static_cast<double>(all.size()) ? low : high) = g.fine;
  }
  // What is nowhere that coarse is said to be as coarse as it is.
  double farthest = *std::max_element(all.begin(), all.end());
  for (const Vec2 corner :
       {Vec2{}, {o.model_width, 0.0}, {0.0, o.model_height}, {o.model_width, o.model_height}})
    farthest = std::max(farthest, g.distance(corner));
  g.coarsening = radius_at(g, farthest) / g.fine;
  return g;
}

}  // namespace hfrac
