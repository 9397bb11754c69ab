/* SPDX-License-Identifier: BSD-3-Clause
 * bench_ranks DISCS dry|coupled|direct WORKERS [MICROSECONDS], over as many ranks as mpirun starts: real motion of a tiled packing under far-field
 * stress; prints milliseconds a cycle, what a rank receives in one, and what a step takes beyond its cycles, found by steps of ten cycles: what
 * every rank does for all of the model. direct: coupled, with flow.solver = "direct". Beside each other: mpirun -n 1 and -n 2, 1 and 2 workers.
 * MICROSECONDS: messages count as received no sooner than that after they were sent, as over a network that takes so long.
 */
#define HFRAC_ENABLE_UNSTABLE
#include <hfrac/hfrac.h>
#include <hfrac/mpi.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void require(int32_t status, const hfrac_sim* sim) {
  char text[1000];
  if (status >= 0) return;
  hfrac_last_error(sim, text, sizeof text, NULL);
  fprintf(stderr, "bench_ranks: %s\n", text);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

/* MPI's table with a slow network. */
static hfrac_exchange fast;
static double latency, sent;

static int32_t start(void* user, const hfrac_message* messages, int32_t number) {
  const int32_t status = fast.start(user, messages, number);
  sent = MPI_Wtime();
  return status;
}

static int32_t finish(void* user) {
  const int32_t status = fast.finish(user);
  while (MPI_Wtime() - sent < latency) {
  }
  return status;
}

static int32_t create(const hfrac_sim_def* def, hfrac_sim** sim) {
  require(hfrac_mpi_exchange((int32_t)MPI_Comm_c2f(MPI_COMM_WORLD), &fast), NULL);
  hfrac_exchange slow = fast;
  if (latency > 0.0) {
    slow.start = start;
    slow.finish = finish;
  }
  return hfrac_sim_create_on(def, &slow, sim);
}

/* Seconds of so many steps of so long, and their cycles. */
static double steps_of(hfrac_sim* sim, int number, double duration, int64_t* cycles) {
  hfrac_sim_state state;
  memset(&state, 0, sizeof state);
  state.struct_size = sizeof state;
  require(hfrac_sim_get_state(sim, &state), sim);
  const int64_t before = state.cycles;
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  for (int k = 0; k < number; ++k) {
    require(hfrac_step_prepare(sim), sim);
    require(hfrac_step_do(sim, duration), sim);
    require(hfrac_step_finalize(sim), sim);
  }
  const double seconds = MPI_Wtime() - begin;
  require(hfrac_sim_get_state(sim, &state), sim);
  *cycles = state.cycles - before;
  return seconds;
}

int main(int count, char** arguments) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  hfrac_sim_state state;
  hfrac_traffic traffic;
  MPI_Init(&count, &arguments);
  if (count != 4 && count != 5) {
    fprintf(stderr, "usage: bench_ranks DISCS dry|coupled|direct WORKERS [MICROSECONDS]\n");
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  if (count == 5) latency = 1e-6 * atof(arguments[4]);
  const int dry = strcmp(arguments[2], "dry") == 0;
  memset(&state, 0, sizeof state);
  memset(&traffic, 0, sizeof traffic);
  state.struct_size = sizeof state;
  traffic.struct_size = sizeof traffic;
  require(hfrac_sim_def_init(&def, sizeof def), NULL);
  require(hfrac_sim_def_set_i64(&def, "packing.disc_count", atoll(arguments[1])), NULL);
  require(hfrac_sim_def_set_i64(&def, "run.workers", atoll(arguments[3])), NULL);
  require(hfrac_sim_def_set_str(&def, "packing.method", "tiled"), NULL);
  require(hfrac_sim_def_set_str(&def, "stepping.mode", "dynamic"), NULL);
  /* Steps are long here, and contacts around what breaks are searched for once a step. */
  require(hfrac_sim_def_set_f64(&def, "bond.tensile_strength", 1e12), NULL);
  require(hfrac_sim_def_set_f64(&def, "bond.shear_strength", 1e12), NULL);
  require(hfrac_sim_def_set_str(&def, "flow.scheme", dry ? "off" : "implicit"), NULL);
  if (strcmp(arguments[2], "direct") == 0)
    require(hfrac_sim_def_set_str(&def, "flow.solver", "direct"), NULL);
  require(create(&def, &sim), NULL);
  require(hfrac_sim_get_state(sim, &state), sim);
  enum { short_steps = 30 };
  int64_t cycles = 0, short_cycles = 0;
  steps_of(sim, 1, 400.0 * state.mechanical_step, &cycles);
  const double cycle = steps_of(sim, 1, 2000.0 * state.mechanical_step, &cycles) / (double)cycles;
  const double in_short = steps_of(sim, short_steps, 10.0 * state.mechanical_step, &short_cycles);
  const double beyond = (in_short - cycle * (double)short_cycles) / short_steps;
  require(hfrac_get_traffic(sim, &traffic), sim);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (rank == 0)
    printf(
        "%s discs, %s, %d ranks x %s workers: %.4f ms a cycle over %lld cycles, %lld messages and %.1f kB "
        "received a cycle, %.2f ms a step beyond its cycles\n",
        arguments[1], arguments[2], ranks, arguments[3], 1e3 * cycle, (long long)cycles,
        (long long)traffic.messages, 1e-3 * (double)traffic.bytes, 1e3 * beyond);
  require(hfrac_sim_destroy(&sim), NULL);
  require(hfrac_sim_def_free(&def), NULL);
  MPI_Finalize();
  return 0;
}
