// SPDX-License-Identifier: BSD-3-Clause
// The sheet: equal discs on a hexagonal lattice, neighbours bonded, free edges, small random velocities, damping, breakage
// checked in every cycle though nothing breaks, real masses.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/random.hpp"
#include "core/workers.hpp"
#include "geom/contact_graph.hpp"
#include "geom/faces.hpp"
#include "geom/packing.hpp"
#include "model/model.hpp"
#include "options/choices.hpp"
#include "solid/explicit_solver.hpp"

namespace hfrac::bench {

inline ContactGraph hexagonal(std::int64_t wanted) {
  const auto columns = static_cast<std::int64_t>(std::lround(std::sqrt(static_cast<double>(wanted))));
  const std::int64_t rows = std::max<std::int64_t>(2, wanted / std::max<std::int64_t>(2, columns));
  Array<double> x, y;
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      x.push_back(0.5 + static_cast<double>(column) + 0.5 * static_cast<double>(row % 2));
      y.push_back(0.5 + std::sqrt(0.75) * static_cast<double>(row));
    }
  }
  const auto order = hilbert_order(x, y);
  Array<double> sorted_x(x.size()), sorted_y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    sorted_x[i] = x[order[i]];
    sorted_y[i] = y[order[i]];
  }
  return build_contact_graph(sorted_x, sorted_y, Array<double>(x.size(), 0.5), {}, 0.05);
}

inline Options sheet_options(ContactMode mode) {
  Options options;
  options.flow_scheme = static_cast<std::int64_t>(FlowScheme::off);
  options.contact_mode = static_cast<std::int64_t>(mode);
  options.bond_tensile_strength = options.bond_shear_strength = 1e9;
  options.stepping_damping = 0.4;
  options.stress_sigma_Hmax = options.stress_sigma_hmin = 0.0;
  return options;
}

struct Sheet {
  Sheet(std::int64_t count, const Options& options) {
    ContactGraph graph = hexagonal(count);
    Faces faces = build_faces(graph);
    assembly = build_assembly(graph, options);
    graph = {};
    network = build_network(std::move(faces), assembly, {}, options);
  }
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;
  // The solver moves discs from here on.
  void stir() {
    Random random(1);
    for (std::int64_t i = 0; i < assembly.disc_count(); ++i) {
      assembly.vx[i] = 2e-3 * (random.uniform() - 0.5);
      assembly.vy[i] = 2e-3 * (random.uniform() - 0.5);
    }
  }
  Model model;
  Assembly& assembly = model.assembly;
  Network& network = model.network;
};

}  // namespace hfrac::bench
