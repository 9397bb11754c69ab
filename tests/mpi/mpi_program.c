/* SPDX-License-Identifier: BSD-3-Clause
 * hfrac_mpi_program STEPS: an MPI program of two simulations, one over all ranks, one over each half of them; prints their state hashes,
 * which are to be alike. hfrac_mpi_program fail: the last rank gives up, and the others print which one did and why. */
#define HFRAC_ENABLE_UNSTABLE
#include <hfrac/hfrac.h>
#include <hfrac/mpi.h>

#include <inttypes.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void require(int32_t status, const hfrac_sim* sim) {
  char text[1000];
  if (status >= 0) return;
  hfrac_last_error(sim, text, sizeof text, NULL);
  fprintf(stderr, "mpi_program: %s\n", text);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static int64_t hash_over(MPI_Comm comm, int64_t steps) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  int64_t hash = 0;
  require(hfrac_sim_def_init(&def, sizeof def), NULL);
  require(hfrac_sim_def_set_i64(&def, "packing.disc_count", 2000), NULL);
  require(hfrac_sim_def_set_f64(&def, "stepping.flow_step", 1e-2), NULL);
  require(hfrac_sim_def_set_f64(&def, "well[0].pressure", 65e6), NULL);
  require(hfrac_sim_def_set_f64(&def, "well[0].radius", 10.0), NULL);
  require(hfrac_sim_create_mpi(&def, (int32_t)MPI_Comm_c2f(comm), &sim), NULL);
  require(hfrac_step(sim, steps), sim);
  require(hfrac_state_hash(sim, &hash), sim);
  require(hfrac_sim_destroy(&sim), NULL);
  require(hfrac_sim_def_free(&def), NULL);
  return hash;
}

static void give_up_on_the_last(int rank, int size) {
  hfrac_exchange table;
  char text[100];
  int32_t by = -1;
  int64_t one = 1;
  require(hfrac_mpi_exchange((int32_t)MPI_Comm_c2f(MPI_COMM_WORLD), &table), NULL);
  if (rank == size - 1) {
    table.fail_text(table.user, "no room");
    table.fail(table.user);
  } else {
    while (table.sum(table.user, &one, 1) == 0) continue;
    if (table.failed(table.user, &by, text, (int32_t)sizeof text) == 0) printf("%d: %s\n", (int)by, text);
  }
}

int main(int count, char** arguments) {
  MPI_Init(&count, &arguments);
  const int64_t steps = count > 1 ? atoll(arguments[1]) : 1;
  int rank = 0;
  MPI_Comm half = MPI_COMM_NULL;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (count > 1 && strcmp(arguments[1], "fail") == 0) {
    int size = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    give_up_on_the_last(rank, size);
    fflush(stdout);
    MPI_Barrier(MPI_COMM_WORLD);
    _Exit(
        0); /* a collective call is under way in the communicator of the table: MPI_Finalize might wait for it */
  }
  MPI_Comm_split(MPI_COMM_WORLD, rank % 2, rank, &half);
  const int64_t all = hash_over(MPI_COMM_WORLD, steps), of_half = hash_over(half, steps);
  MPI_Comm_free(&half);
  printf("%016" PRIx64 " %016" PRIx64 "\n", (uint64_t)all, (uint64_t)of_half);
  MPI_Finalize();
  return 0;
}
