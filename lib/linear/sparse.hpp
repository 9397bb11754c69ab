// SPDX-License-Identifier: BSD-3-Clause
// The sparse solvers taken from Eigen, named by what they are for. Only MPL2 parts of Eigen (EIGEN_MPL2_ONLY).
//
//   GeneralFactor     L U with column ordering: the poroelastic continuum
//   OrderedFactor     L U of a matrix of symmetric pattern: heat, where iteration fails
//   BiconjugateGradients  stabilised (van der Vorst 1992), preconditioned by the diagonal: heat
// Our own stand beside: SymmetricFactor (flow, heat at rest, flow through a cell), ConjugateGradient (large flow matrices), Multifrontal
// and Krylov (equilibrium).
#pragma once

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstdint>

namespace hfrac {

using SparseMatrix = Eigen::SparseMatrix<double>;
using GeneralFactor = Eigen::SparseLU<SparseMatrix>;
using OrderedFactor = Eigen::SparseLU<SparseMatrix, Eigen::AMDOrdering<int>>;
using BiconjugateGradients = Eigen::BiCGSTAB<SparseMatrix, Eigen::DiagonalPreconditioner<double>>;

// Unknowns of a symmetric matrix up to which its factor is the faster way, whose cost grows with the power 1.5 of their number; beyond,
// conjugate gradients.
constexpr std::int64_t largest_to_factorise = 60000;

}  // namespace hfrac
