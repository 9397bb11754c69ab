// SPDX-License-Identifier: BSD-3-Clause
// Sparse L U factors side by side on the quasi-static solver's own matrix: the multifrontal factor of lib/linear, Eigen's SparseLU,
// SuperLU (Demmel, Eisenstat, Gilbert, Li and Liu 1999) and serial MUMPS (Amestoy, Duff, Koster and L'Excellent 2001).
//
//     bench_sparse [DISCS [STEPS]]     10 000 discs, 10 steps: by then the fracture has opened
//
// One worker. Each solver orders by its own means and, where it takes an order, by our nested dissection, too ("ours"). `again` is what
// a Newton iteration pays: numbers changed, pattern kept. MB is what the factor holds. `off` is the largest component of A x - b over the
// largest of b. SuperLU and MUMPS call the BLAS that the system has (ldd); MUMPS in single precision is what corresponds to the engine's factor.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "equilibrium/coupled_system.hpp"
#include "linear/multifrontal.hpp"
#include "linear/sparse.hpp"
#include "options/choices.hpp"
#include "step/simulation.hpp"
#ifdef HFRAC_SUPERLU
#include <Eigen/SuperLUSupport>
#endif
#ifdef HFRAC_MUMPS
#include <dmumps_c.h>
#include <smumps_c.h>
#endif

using namespace hfrac;

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

struct System {
  CoupledSystem::Structure structure;
  std::vector<double> values;
  Matrix matrix;
  Vector right;
};

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void row(const std::string& name, double first, double again, double solve, double bytes, const System& s,
         const Vector& x) {
  const double off = (s.matrix * x - s.right).cwiseAbs().maxCoeff() / s.right.cwiseAbs().maxCoeff();
  std::printf("%-44s %9.3f %9.3f %9.4f %9.1f %9.1e\n", name.c_str(), first, again, solve, 1e-6 * bytes, off);
  std::fflush(stdout);
}

template <class Real>
std::vector<std::int32_t> ours(const System& s, const char* name) {
  FrontTree tree;
  Workers one(1);
  Multifrontal<Real> factor;
  const auto& t = s.structure;
  const std::vector<Real> values(s.values.begin(), s.values.end());
  const double first = seconds([&] {
    tree.analyse(t.node_start, t.position, t.graph, t.late, t.each_place);
    factor.factorise(tree, values, one);
  });
  const double again = seconds([&] { factor.factorise(tree, values, one); });
  Vector x = s.right;
  const double solve = seconds([&] { factor.solve(tree, x.data(), one); });
  row(name, first, again, solve, static_cast<double>(tree.columns + tree.rows) * sizeof(Real), s, x);
  std::vector<std::int32_t> order;
  for (const auto& front : tree.fronts)
    order.insert(order.end(), tree.unknowns.begin() + front.unknowns,
                 tree.unknowns.begin() + front.unknowns + front.pivots);
  return order;
}

void eigens(const System& s) {
  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> factor;
  const double first = seconds([&] {
    factor.analyzePattern(s.matrix);
    factor.factorize(s.matrix);
  });
  const double again = seconds([&] { factor.factorize(s.matrix); });
  Vector x;
  const double solve = seconds([&] { x = factor.solve(s.right); });
  row("Eigen SparseLU, double, COLAMD", first, again, solve,
      12.0 * static_cast<double>(factor.nnzL() + factor.nnzU()), s, x);
}

#ifdef HFRAC_SUPERLU
template <class Real>
struct SuperLu : Eigen::SuperLU<Eigen::SparseMatrix<Real>> {
  [[nodiscard]] double entries() const {
    return static_cast<double>(static_cast<const SCformat*>(this->m_sluL.Store)->nnz) +
           static_cast<double>(static_cast<const NCformat*>(this->m_sluU.Store)->nnz);
  }
};

template <class Real>
void superlu(const System& s, const char* name, colperm_t column, const std::vector<std::int32_t>& order) {
  using Sparse = Eigen::SparseMatrix<Real>;
  Eigen::PermutationMatrix<Eigen::Dynamic> p(s.matrix.rows());
  p.setIdentity();
  if (column == NATURAL)
    for (std::size_t k = 0; k < order.size(); ++k) p.indices()[order[k]] = static_cast<int>(k);
  const Sparse matrix = (p * s.matrix * p.transpose()).template cast<Real>();
  SuperLu<Real> factor;
  factor.options().ColPerm = column;
  factor.options().SymmetricMode = YES;
  factor.options().DiagPivotThresh = 0.01;
  factor.options().Equil = NO;
  const double first = seconds([&] {
    factor.analyzePattern(matrix);
    factor.factorize(matrix);
  });
  const double again = seconds([&] { factor.factorize(matrix); });
  const Eigen::Matrix<Real, Eigen::Dynamic, 1> right = (p * s.right).template cast<Real>();
  Eigen::Matrix<Real, Eigen::Dynamic, 1> y;
  const double solve = seconds([&] { y = factor.solve(right); });
  const Vector x = p.transpose() * y.template cast<double>();
  row(name, first, again, solve, (sizeof(Real) + 4.0) * factor.entries(), s, x);
}
#endif

#ifdef HFRAC_MUMPS
void call(DMUMPS_STRUC_C& m) {
  dmumps_c(&m);
}
void call(SMUMPS_STRUC_C& m) {
  smumps_c(&m);
}

template <class Structure, class Real>
void mumps(const System& s, const char* name, const std::vector<std::int32_t>& order) {
  std::vector<int> rows, columns, place(order.size());
  std::vector<Real> values, x(static_cast<std::size_t>(s.right.size()));
  for (int c = 0; c < s.matrix.outerSize(); ++c)
    for (Matrix::InnerIterator it(s.matrix, c); it; ++it) {
      rows.push_back(static_cast<int>(it.row()) + 1);
      columns.push_back(c + 1);
      values.push_back(static_cast<Real>(it.value()));
    }
  for (std::size_t k = 0; k < order.size(); ++k)
    place[static_cast<std::size_t>(order[k])] = static_cast<int>(k) + 1;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<Real>(s.right[static_cast<Eigen::Index>(k)]);
  Structure m{};
  m.par = 1;
  m.comm_fortran = -987654;  // MPI_COMM_WORLD of the serial library
  m.job = -1;
  call(m);
  for (int k = 0; k < 4; ++k) m.icntl[k] = k == 3 ? 0 : -1;  // silent
  m.n = static_cast<int>(s.matrix.rows());
  m.nnz = static_cast<MUMPS_INT8>(values.size());
  m.irn = rows.data();
  m.jcn = columns.data();
  m.a = values.data();
  m.icntl[5] = 0;  // no exchange of columns beforehand: the pattern is symmetric
  m.icntl[6] = order.empty() ? 7 : 1;
  m.icntl[13] = 50;  // per cent of spare room
  if (!order.empty()) m.perm_in = place.data();
  const auto run = [&](int job) {
    m.job = job;
    call(m);
    if (m.infog[0] < 0) std::printf("%s: error %d in job %d\n", name, m.infog[0], job);
  };
  const double first = seconds([&] { run(4); });
  const double again = seconds([&] { run(2); });
  m.rhs = x.data();
  m.nrhs = 1;
  const double solve = seconds([&] { run(3); });
  const double entries = m.infog[28] < 0 ? -1e6 * m.infog[28] : m.infog[28];
  const Vector found =
      Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, 1>>(x.data(), s.right.size()).template cast<double>();
  row(name, first, again, solve, sizeof(Real) * entries, s, found);
  m.job = -2;
  call(m);
}
#endif

System tangent(std::int64_t discs, int steps) {
  CaseDefinition definition;
  Options& o = definition.options;
  o.packing_disc_count = discs;
  o.stress_convention = static_cast<std::int64_t>(StressConvention::effective);
  o.stress_sigma_Hmax = o.stress_sigma_hmin = 0.0;
  o.boundary_kind = static_cast<std::int64_t>(BoundaryKind::walls);
  o.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  o.stepping_mode = static_cast<std::int64_t>(SteppingMode::coupled);
  o.stepping_flow_step = 1e-3;
  WellOptions well;
  well.x = well.y = 50.0;
  well.radius = 8.5;
  well.pressure = 45e6;
  definition.wells.push_back(well);
  Simulation sim(definition, {}, {});
  for (int k = 0; k < steps; ++k) sim.step();
  std::size_t cracks = 0;
  for (const char intact : sim.assembly().intact) cracks += intact == 0 ? 1 : 0;
  Workers one(1);
  Facets facets;
  CoupledSystem system(const_cast<Assembly&>(sim.assembly()), const_cast<Network&>(sim.network()),
                       *sim.engine().boundary, sim.engine().mechanics->non_bonded_contacts(), sim.options(),
                       one, facets);
  system.begin(o.stepping_flow_step, {});
  system.evaluate();
  System s;
  s.structure = system.structure();
  std::vector<MatrixPlace> places;
  s.structure.each_place([&](MatrixPlace place) { places.push_back(place); });
  s.structure.each_place = [places](const auto& visit) {  // the system goes
    for (const auto& place : places) visit(place);
  };
  system.entries(s.values, 0, system.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < s.values.size(); ++k)
    entries.emplace_back(places[k].row, places[k].column, s.values[k]);
  s.matrix.resize(system.size(), system.size());
  s.matrix.setFromTriplets(entries.begin(), entries.end());
  Random random(11);
  s.right.resize(system.size());
  for (auto& value : s.right) value = random.uniform() - 0.5;
  std::printf("%lld discs, %zu cracks: %lld unknowns, %lld entries\n", static_cast<long long>(discs), cracks,
              static_cast<long long>(system.size()), static_cast<long long>(s.matrix.nonZeros()));
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t discs = argc > 1 ? std::atoll(argv[1]) : 10000;
  const System s = tangent(discs, argc > 2 ? std::atoi(argv[2]) : 10);
  std::printf("%-44s %9s %9s %9s %9s %9s\n", "factor, precision, order", "first, s", "again, s", "solve, s",
              "MB", "off");
  ours<float>(s, "hfrac multifrontal, single, ours");
  const auto order = ours<double>(s, "hfrac multifrontal, double, ours");
#ifdef HFRAC_MUMPS
  mumps<SMUMPS_STRUC_C, float>(s, "MUMPS, single, its own", {});
  mumps<SMUMPS_STRUC_C, float>(s, "MUMPS, single, ours", order);
  mumps<DMUMPS_STRUC_C, double>(s, "MUMPS, double, its own", {});
  mumps<DMUMPS_STRUC_C, double>(s, "MUMPS, double, ours", order);
#endif
#ifdef HFRAC_SUPERLU
  superlu<float>(s, "SuperLU, single, minimum degree", MMD_AT_PLUS_A, order);
  superlu<float>(s, "SuperLU, single, ours", NATURAL, order);
  superlu<double>(s, "SuperLU, double, minimum degree", MMD_AT_PLUS_A, order);
  superlu<double>(s, "SuperLU, double, ours", NATURAL, order);
#endif
  eigens(s);
  return 0;
}
