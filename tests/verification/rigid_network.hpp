// SPDX-License-Identifier: BSD-3-Clause
// Pores and pipes of a packing that does not move: what the flow cases drive directly.
#pragma once

#include <algorithm>
#include <cstdint>

#include "flow/aperture.hpp"
#include "model.hpp"

namespace verification {

using namespace hfrac;

class RigidNetwork {
 public:
  // 100 m x 100 m, no well, no flow across the outside.
  RigidNetwork(std::int64_t discs, std::int64_t seed) : RigidNetwork(options_of(discs, seed)) {}
  explicit RigidNetwork(const Options& o) : model_(o, testing_unit::packed(o)) {
    model_.fill_pores();
    for (std::int64_t d = 0; d < network().domain_count(); ++d)
      network().pressure[d] = network().reference_pressure;
  }

  void calibrate(double permeability) {
    model_.options.flow_permeability = permeability;
    std::vector<double> pressure;  // the measurement's own
    calibrate_aperture(network(), model_.assembly, model_.options, {}, pressure);
    for (std::size_t e = 0; e < network().left.size(); ++e) {
      if (network().left[e] == 0 || network().right[e] == 0) network().conductance[e] = 0.0;
    }
  }

  void impose(std::int64_t domain, double pressure) {
    network().stiffness[domain] = 0.0;
    network().pressure[domain] = pressure;
  }

  // Flow in +x through the pipes that join a domain left of x with one right of it, in the last flow step
  // [m2/s].
  [[nodiscard]] double flow_across(double x) const {
    double flow = 0.0;
    const Network& n = model_.network;
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      const bool from = n.centroid[n.left[e]].x < x, to = n.centroid[n.right[e]].x < x;
      if (n.left[e] == 0 || n.right[e] == 0 || from == to) continue;
      flow += from ? n.flow[e] : -n.flow[e];
    }
    return flow;
  }

  // Between the outermost disc edges [m].
  [[nodiscard]] double height() const {
    const auto [low, high] = std::minmax_element(model_.assembly.y.begin(), model_.assembly.y.end());
    return *high - *low + 2.0 * model_.assembly.mean_radius;
  }

  // Pore volume over area of the domains between two abscissas.
  [[nodiscard]] double porosity(double from, double to) const {
    double pores = 0.0, area = 0.0;
    for (std::int64_t d = 1; d < model_.network.domain_count(); ++d) {
      if (model_.network.centroid[d].x < from || model_.network.centroid[d].x > to) continue;
      pores += model_.network.volume[d];
      area += model_.faces.polygon_area[static_cast<std::size_t>(d)];
    }
    return pores / area;
  }

  // Of a domain [m2].
  [[nodiscard]] double area(std::int64_t d) const {
    return model_.faces.polygon_area[static_cast<std::size_t>(d)];
  }
  Network& network() { return model_.network; }
  Assembly& assembly() { return model_.assembly; }
  [[nodiscard]] const Options& options() const { return model_.options; }

  static Options options_of(std::int64_t discs, std::int64_t seed) {
    Options o = testing_unit::dry_options(discs);
    o.model_width = o.model_height = 100.0;
    o.model_seed = seed;
    o.stress_convention = testing_unit::choice(StressConvention::effective);
    o.flow_scheme = testing_unit::choice(FlowScheme::implicit_scheme);
    return o;
  }

 private:
  testing_unit::TestModel model_;
};

}  // namespace verification
