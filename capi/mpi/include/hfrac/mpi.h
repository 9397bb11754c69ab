/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * One simulation over the ranks of an MPI communicator: hfrac/exchange.h carried by MPI.
 *
 * In a library of its own, libhfrac_mpi, so that libhfrac needs no MPI. Communicators are given as Fortran's integer handles, which
 * are the same for every MPI: MPI_Comm_c2f(comm) in C, `comm%MPI_VAL` or the integer itself in Fortran, comm.py2f() in mpi4py. MPI
 * has to be initialised; MPI_THREAD_SINGLE is enough. Messages go by a duplicate of the communicator, which is freed with it.
 * What is shared, and what fails, stands in exchange.h.
 */
#ifndef HFRAC_MPI_H
#define HFRAC_MPI_H

#include <hfrac/exchange.h>

#ifdef __cplusplus
extern "C" {
#endif

/** hfrac_sim_create on every rank of a communicator, collective. HFRAC_ERR_EXCHANGE: MPI is not initialised, or a rank failed.
 * Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_create_mpi(const hfrac_sim_def *def, int32_t fortran_comm, hfrac_sim **sim);

/** The table by which ranks of a communicator talk, for hfrac_sim_create_on; collective. It holds as long as the communicator.
 * Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_mpi_exchange(int32_t fortran_comm, hfrac_exchange *exchange);

/** For programs that are not MPI's own: initialises MPI and gives the table over all processes that were started together.
 * Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_mpi_begin(hfrac_exchange *exchange);

/** The same for one model on each machine: of the processes there the first takes part, with the table over those of all machines, and may run
 * on the cores of all of them; `processes_here` is how many they are, for run.workers. The others get 0, and hfrac_mpi_end says on them whether
 * the first has come to its end; they sleep until it has. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_mpi_begin_on_machines(hfrac_exchange *exchange, int32_t *processes_here);

/** The end of that: all processes wait for each other, unless one has failed. Nonzero `failed` says that this one has.
 * Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_mpi_end(int32_t failed);

#ifdef __cplusplus
}
#endif

#endif
