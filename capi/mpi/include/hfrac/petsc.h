/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * PETSc as the solver of linear_solver.h: conjugate gradients with algebraic multigrid (hypre's BoomerAMG, or PETSc's own where there is no
 * hypre) for the flow step, a factor by MUMPS for the quasi-static tangent. In a library of its own, libhfrac_petsc, so that libhfrac_mpi
 * needs no PETSc. What a binary that is linked with PETSc is under, docs/scale.md says.
 *
 * PETSc leaves the host alone: it is initialised here only if the host has not, without rc files and signal handlers, and ends with MPI; it
 * prints nothing, its errors become statuses, its objects live on a duplicate of the communicator. Options go by the environment
 * (PETSC_OPTIONS) or the host's database, with the prefixes -hfrac_flow_ and -hfrac_tangent_. PETSc is for one thread at a time: one
 * simulation that uses it in a process after the other, not at once.
 *
 * PETSc waits for other ranks without looking whether they have gone: a rank that is killed while it solves is found by the launcher, which
 * ends all.
 */
#ifndef HFRAC_PETSC_H
#define HFRAC_PETSC_H

#include <hfrac/linear_solver.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The table over the ranks of a communicator, collective; for hfrac_exchange::linear_solver. It holds as long as the communicator. With it
 * hfrac_sim_destroy is collective, too. HFRAC_ERR_EXCHANGE: MPI is not initialised, or PETSc cannot be. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_petsc_solver(int32_t fortran_comm, hfrac_linear_solver *solver);

/** The table over all processes that were started together, after hfrac_mpi_begin. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_petsc_begin(hfrac_linear_solver *solver);

#ifdef __cplusplus
}
#endif

#endif
