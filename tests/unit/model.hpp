// SPDX-License-Identifier: BSD-3-Clause
// A small model for the tests of the engine's parts: discs, graph, faces, bonds, pores, boundary and solver,
// built the way build_model.cpp does it but open to the test's hands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/workers.hpp"
#include "geom/contact_graph.hpp"
#include "geom/faces.hpp"
#include "geom/packing.hpp"
#include "model/model.hpp"
#include "options/choices.hpp"
#include "options/options.hpp"
#include "solid/bond_law.hpp"
#include "solid/boundary.hpp"
#include "solid/explicit_solver.hpp"
#include "solid/softening.hpp"
#include "solid/toughness.hpp"

namespace testing_unit {

using namespace hfrac;

constexpr double pi = 3.14159265358979323846;

struct Discs {
  Array<double> x, y, radius;
  Grading sizes = {};  // of a graded packing
};

// Rows and columns of equal discs that just touch; the first centre lies at (radius, radius).
inline Discs square_lattice(int columns, int rows, double radius) {
  Discs discs;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      discs.x.push_back(radius * (1.0 + 2.0 * column));
      discs.y.push_back(radius * (1.0 + 2.0 * row));
      discs.radius.push_back(radius);
    }
  }
  return discs;
}

inline Discs packed(const Options& o) {
  CaseDefinition definition;
  definition.options = o;
  PackingOptions asked = packing_options(o);
  asked.sizes = grading_of(definition);
  const Packing packing = pack_discs(asked);
  return {packing.x, packing.y, packing.radius, packing.sizes};
}

class TestModel {
 public:
  TestModel(const Options& given, const Discs& discs, const std::vector<Hole>& holes = {},
            int worker_count = 1)
      : options(given),
        graph(build_contact_graph(discs.x, discs.y, discs.radius, holes, given.bond_gap_tolerance, {},
                                  discs.sizes)),
        faces(build_faces(graph)) {
    assembly = build_assembly(graph, options);
    if (options.bond_fracture_toughness > 0.0) apply_fracture_toughness(assembly, options);
    if (options.bond_fracture_energy > 0.0) begin_softening(assembly, options);
    for (const auto& hole : holes) well_domains.push_back(face_around(graph, faces, hole.centre));
    network = build_network(faces, assembly, well_domains, options);
    boundary = std::make_unique<Boundary>(data, options);
    workers = std::make_unique<Workers>(worker_count);
    solver = std::make_unique<ExplicitSolver>(data, *boundary, options, *workers);
  }

  TestModel(const TestModel&) = delete;  // the solver holds the parts' addresses
  TestModel& operator=(const TestModel&) = delete;

  // Displacements and rotations at random, up to `size` radii and radians.
  void shake(double size, std::uint64_t seed) {
    Random random(seed);
    for (std::int64_t i = 0; i < assembly.disc_count(); ++i) {
      assembly.ux[i] = size * assembly.radius[i] * (2.0 * random.uniform() - 1.0);
      assembly.uy[i] = size * assembly.radius[i] * (2.0 * random.uniform() - 1.0);
      assembly.rotation[i] = size * (2.0 * random.uniform() - 1.0);
    }
  }

  // Pores answer to their change of volume from here on, wells and outside excepted.
  void fill_pores() {
    for (std::int64_t d = 0; d < network.domain_count(); ++d) {
      const bool rock = network.kind[d] == DomainKind::rock;
      network.stiffness[d] = rock ? options.fluid_bulk_modulus / network.volume[d] : 0.0;
    }
  }

  [[nodiscard]] double elastic_energy() const {
    double energy = boundary->walled() ? boundary->wall_energy(assembly) : 0.0;
    for (std::int64_t e = 0; e < assembly.bond_count(); ++e) {
      const BondView bond = view_bond(assembly, options, e);
      energy += bond.bond_energy + bond.contact_energy;
    }
    return energy;
  }

  Options options;
  ContactGraph graph;
  Faces faces;
  hfrac::Model data;
  Assembly& assembly = data.assembly;
  Network& network = data.network;
  std::vector<std::int32_t> well_domains;
  std::unique_ptr<Boundary> boundary;
  std::unique_ptr<Workers> workers;
  std::unique_ptr<ExplicitSolver> solver;
};

template <class Choice>
std::int64_t choice(Choice one) {
  return static_cast<std::int64_t>(one);
}

// A dry rock of a few hundred discs that does not break.
inline Options dry_options(std::int64_t discs) {
  Options o;
  o.model_width = o.model_height = 20.0;
  o.packing_disc_count = discs;
  o.flow_scheme = choice(FlowScheme::off);
  o.bond_tensile_strength = o.bond_shear_strength = 1e12;
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 0.0;
  return o;
}

inline double sum(const Array<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

template <class Values>
bool same_bits(const Values& a, const Values& b) {
  return a.size() == b.size() && __builtin_memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace testing_unit
