// SPDX-License-Identifier: BSD-3-Clause
// Solvers over ranks on a sheet of hexagonally packed discs (two pores a disc), hfrac's own or PETSc's (libhfrac_petsc):
//
//     mpirun -n RANKS bench_petsc flow DISCS [petsc|iterative [WORKERS]]   a long flow step out of a hole: rock of random conductance (standard
//         deviation of its logarithm 1), a crack of 1e3 times that through a third of the model
//     mpirun -n RANKS bench_petsc tangent DISCS [petsc|own]         factor of the undrained quasi-static tangent, one solve to 1e-3 by GMRES
//
// flow: iterations of conjugate gradients of the two steps, the second beginning from the first's pressures; the largest difference of a pressure from
// those of hfrac's own factorisation (up to 100 000 domains), over the hole's; fluid lost over fluid injected.
// tangent: memory of each rank before, what the factor took at most, and what it keeps (resident set). Exits with 1 where a promise of
// docs/scale.md is broken.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "equilibrium/coupled_factor.hpp"
#include "flow/flow_solver.hpp"
#include "hfrac/mpi.h"
#include "hfrac/petsc.h"
#include "linear/krylov.hpp"
#include "sheet_model.hpp"

using namespace hfrac;

namespace {

constexpr std::int64_t most_compared = 100000;  // domains
constexpr double closest_pressure = 1e-9, closest_fluid = 1e-12;

double now() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// MB, of /proc/self/status.
double memory(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0.0;
    if (word == what + ":" && status >> kilobytes) return 1e-3 * 1.024 * kilobytes;
  }
  return 0.0;
}

// VmHWM counts from here on.
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

// The tables as the engine takes them, counting iterations on the way.
struct Outside {
  hfrac_exchange exchange{};
  hfrac_linear_solver solver{};
  OutsideSolver counted;
  std::vector<int> iterations;

  Ranks ranks() {
    if (hfrac_mpi_begin(&exchange) != HFRAC_OK || hfrac_petsc_begin(&solver) != HFRAC_OK) {
      std::fprintf(stderr, "bench_petsc: no MPI, or no PETSc\n");
      std::exit(2);
    }
    counted.user = this;
    counted.prepare = [](void* user, const MatrixRows* rows, void** prepared) {
      const auto& s = static_cast<Outside*>(user)->solver;
      return s.prepare(s.user, reinterpret_cast<const hfrac_matrix*>(rows), prepared);
    };
    counted.solve = [](void* user, void* prepared, const double* right, double* x, double tolerance,
                       std::int32_t* taken) {
      auto& self = *static_cast<Outside*>(user);
      const auto status = self.solver.solve(self.solver.user, prepared, right, x, tolerance, taken);
      self.iterations.push_back(*taken);
      return status;
    };
    counted.release = [](void* user, void* prepared) {
      const auto& s = static_cast<Outside*>(user)->solver;
      return s.release(s.user, prepared);
    };
    counted.reason = [](void* user, char* text, std::int64_t size) {
      const auto& s = static_cast<Outside*>(user)->solver;
      return s.reason(s.user, text, size);
    };
    Exchange of{exchange.rank, exchange.size, exchange.user};
    of.start = reinterpret_cast<decltype(of.start)>(exchange.start);
    of.finish = exchange.finish;
    of.sum = exchange.sum;
    of.gather = exchange.gather;
    of.fail = exchange.fail;
    of.solver = &counted;
    return Ranks(of);
  }
};

Options wet_options() {
  Options options = bench::sheet_options(ContactMode::parallel);
  options.flow_scheme = static_cast<std::int64_t>(FlowScheme::implicit_scheme);
  options.solver_kind = static_cast<std::int64_t>(SolverKind::quasi_static);
  return options;
}

// Returns the hole's domain.
std::size_t make_rock(Network& n, const Options& o) {
  Random random(5);
  double side = 0.0;
  for (const auto& at : n.centroid) side = std::max(side, at.x);
  std::size_t hole = 1;
  const auto distance = [&](std::size_t d) {
    return std::hypot(n.centroid[d].x - 0.5 * side, n.centroid[d].y - 0.5 * side);
  };
  for (std::size_t d = 1; d < n.centroid.size(); ++d)
    if (distance(d) < distance(hole)) hole = d;
  for (std::size_t e = 0; e < n.left.size(); ++e) {
    const double normal =
        std::sqrt(-2.0 * std::log(1.0 - random.uniform())) * std::cos(6.283185307179586 * random.uniform());
    const auto l = static_cast<std::size_t>(n.left[e]), r = static_cast<std::size_t>(n.right[e]);
    const bool cracked = l != 0 && r != 0 && std::abs(n.centroid[l].y - 0.5 * side) < 0.6 &&
                         std::abs(n.centroid[r].y - 0.5 * side) < 0.6 &&
                         std::abs(n.centroid[l].x - 0.5 * side) < side / 6.0;
    n.conductance[e] = 1e-12 * std::exp(normal) * (cracked ? 1e3 : 1.0);
  }
  for (std::size_t d = 1; d < n.stiffness.size(); ++d)
    n.stiffness[d] = d == hole ? 0.0 : o.fluid_bulk_modulus / n.volume[d];
  n.reference_pressure = 0.0;
  n.floor_pressure = -1e9;
  std::fill(n.content.begin(), n.content.end(), 0.0);
  std::fill(n.pressure.begin(), n.pressure.end(), 0.0);
  n.pressure[hole] = 1e7;
  return hole;
}

int flow(Outside& outside, const Ranks& ranks, std::int64_t discs, bool petsc, int workers) {
  Options o = wet_options();
  bench::Sheet sheet(discs, o);
  Network& n = sheet.network;
  const std::size_t hole = make_rock(n, o);
  const double step = 30.0 / (n.stiffness[hole + 1] * 1e-12);
  const auto solver = petsc ? FlowMatrixSolver::petsc : FlowMatrixSolver::iterative;
  o.flow_solver = static_cast<std::int64_t>(solver);
  Network alike = n;
  Workers team(workers);
  FlowSolver by(n, o, nullptr, ranks, &team);
  double lost = 0.0, seconds = 0.0, off = 0.0;
  std::string counts;
  for (int k = 0; k < 2; ++k) {
    const std::vector<double> before(n.content.begin(), n.content.end());
    const double start = now();
    by.advance(n, step, {});
    seconds = now() - start;
    double injected = 0.0, leaked = 0.0, stored = 0.0;
    for (std::size_t e = 0; e < n.left.size(); ++e) {
      for (const double sign : {1.0, -1.0}) {
        const auto d = static_cast<std::size_t>(sign > 0.0 ? n.left[e] : n.right[e]);
        if (d == hole) injected += sign * step * n.flow[e];
        if (d == 0) leaked -= sign * step * n.flow[e];
      }
    }
    for (std::size_t d = 0; d < before.size(); ++d) stored += n.content[d] - before[d];
    lost = std::max(lost, std::abs(injected - leaked - stored) / injected);
    for (const int count : outside.iterations) counts.append(" ").append(std::to_string(count));
    if (k == 0) counts.append(" |");
    outside.iterations.clear();
  }
  const bool compared = n.domain_count() <= most_compared;
  if (ranks.rank() == 0 && compared) {
    o.flow_solver = static_cast<std::int64_t>(FlowMatrixSolver::direct);
    FlowSolver own(alike, o);
    for (int k = 0; k < 2; ++k) own.advance(alike, step, {});
    for (std::size_t d = 0; d < n.pressure.size(); ++d)
      off = std::max(off, std::abs(n.pressure[d] - alike.pressure[d]) / n.pressure[hole]);
  }
  if (ranks.rank() == 0) {
    std::printf(
        "flow, %s, %d ranks, %lld domains: iterations%s, second step %.2f s, pressures off %s, fluid lost "
        "%.1e\n",
        petsc ? "petsc" : "iterative", ranks.size(), static_cast<long long>(n.domain_count()), counts.c_str(),
        seconds, compared ? std::to_string(1e9 * off).append("e-9").c_str() : "-", lost);
  }
  return ranks.any(off > closest_pressure || lost > closest_fluid) ? 1 : 0;
}

int tangent(Outside& outside, const Ranks& ranks, std::int64_t discs, bool petsc) {
  const Options o = wet_options();
  bench::Sheet sheet(discs, o);
  make_rock(sheet.network, o);
  Workers workers(1);
  Facets facets;
  Boundary boundary(sheet.model, o);
  ExplicitSolver mechanics(sheet.model, boundary, o, workers);
  CoupledSystem system(sheet.assembly, sheet.network, boundary, mechanics.non_bonded_contacts(), o, workers,
                       facets);
  system.begin(0.0, {});
  system.evaluate();
  CoupledFactor factor(workers, ranks, petsc);
  Random random(3);
  CoupledSystem::Vector right(system.size()), x;
  for (Eigen::Index k = 0; k < right.size(); ++k) right[k] = random.uniform() - 0.5;
  const double before = memory("VmRSS");
  forget_peak();
  const double start = now();
  factor.compute(system);
  factor.solve(right, x);  // a factor from outside is made with the first solve
  const double factored = now();
  factor.compute(system);
  factor.solve(right, x);
  const double again = now();
  const auto outcome =
      Krylov(workers, ranks)
          .solve([&](const auto& in, auto& out) { system.product(in, out); },
                 [&](const auto& in, auto& out) { factor.solve(in, out); }, right, 1e-3, 40, x);
  std::vector<std::int64_t> figures;
  for (const double figure : {before, memory("VmHWM") - before, memory("VmRSS") - before})
    figures.push_back(std::llround(figure));
  const auto all = ranks.gather(figures);
  if (ranks.rank() == 0) {
    std::printf(
        "tangent, %s, %d ranks, %lld discs: factor %.1f s, again %.1f s, GMRES %d iterations, MB a rank",
        petsc ? "petsc" : "own", ranks.size(), static_cast<long long>(sheet.assembly.disc_count()),
        factored - start, again - factored, outcome.iterations);
    for (std::size_t k = 0; k < all.size(); k += 3)
      std::printf(" %lld + %lld (%lld)", static_cast<long long>(all[k]), static_cast<long long>(all[k + 1]),
                  static_cast<long long>(all[k + 2]));
    std::printf("\n");
  }
  outside.iterations.clear();
  return outcome.converged ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string what = count > 2 ? arguments[1] : "", by = count > 3 ? arguments[3] : "petsc";
  const std::int64_t discs = count > 2 ? std::atoll(arguments[2]) : 0;
  const int workers = count > 4 ? std::atoi(arguments[4]) : 1;
  if ((what != "flow" && what != "tangent") || discs < 100 || discs > 100000000 || workers < 1) {
    std::fprintf(stderr, "usage: bench_petsc flow|tangent DISCS [petsc|iterative|own [WORKERS]]\n");
    return 2;
  }
  Outside outside;
  const Ranks ranks = outside.ranks();
  int status = 1;
  try {
    status = what == "flow" ? flow(outside, ranks, discs, by == "petsc", workers)
                            : tangent(outside, ranks, discs, by == "petsc");
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_petsc: %s\n", error.what());
    ranks.fail(error.what());
  }
  hfrac_mpi_end(status);
  return status;
}
