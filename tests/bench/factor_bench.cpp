// SPDX-License-Identifier: BSD-3-Clause
// The factor of flow matrices beside Eigen's SimplicialLDLT, whose bits it has: pores on a square grid, numbers anew in a pattern that
// stays, as in a flow step; then two triangular solutions.
//
//     bench_factor [--benchmark_filter=...]
#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>

#include "../unit/pore_grid.hpp"
#include "core/workers.hpp"
#include "linear/symmetric_factor.hpp"

namespace {
using namespace hfrac;

SparseMatrix pores(const benchmark::State& state) {
  return grid(static_cast<int>(state.range(0)), 1e-3, 1e4);
}

void ours(benchmark::State& state) {
  const SparseMatrix matrix = pores(state);
  SymmetricFactor factor;
  factor.analyse(matrix);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorise(matrix));
  state.counters["bytes"] = static_cast<double>(factor.bytes());
}

// By so many workers.
void ours_shared(benchmark::State& state) {
  const SparseMatrix matrix = pores(state);
  Workers workers(static_cast<int>(state.range(1)));
  SymmetricFactor factor;
  factor.analyse(matrix);
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorise(matrix, &workers));
}

void eigen(benchmark::State& state) {
  const SparseMatrix matrix = pores(state);
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factor;
  factor.analyzePattern(matrix);
  for (auto _ : state) {
    factor.factorize(matrix);
    benchmark::DoNotOptimize(factor.info());
  }
}

void ours_solve(benchmark::State& state) {
  const SparseMatrix matrix = pores(state);
  const SymmetricFactor factor(matrix);
  const Eigen::VectorXd rhs = Eigen::VectorXd::Ones(matrix.cols());
  for (auto _ : state) benchmark::DoNotOptimize(factor.solve(rhs).data());
}

void eigen_solve(benchmark::State& state) {
  const SparseMatrix matrix = pores(state);
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factor(matrix);
  const Eigen::VectorXd rhs = Eigen::VectorXd::Ones(matrix.cols());
  for (auto _ : state) {
    const Eigen::VectorXd x = factor.solve(rhs);
    benchmark::DoNotOptimize(x.data());
  }
}

}  // namespace

BENCHMARK(ours)->Arg(50)->Arg(110)->Arg(240)->Unit(benchmark::kMillisecond);
BENCHMARK(ours_shared)
    ->ArgsProduct({{50, 110, 240}, {1, 2, 4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(eigen)->Arg(50)->Arg(110)->Arg(240)->Unit(benchmark::kMillisecond);
BENCHMARK(ours_solve)->Arg(110)->Unit(benchmark::kMillisecond);
BENCHMARK(eigen_solve)->Arg(110)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
