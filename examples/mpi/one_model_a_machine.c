/* A parallel program with a rank on every core, and one model for each machine: of the ranks of a machine the first has it, with as many
 * workers as there are ranks, and the others sleep meanwhile. Eight ranks then need the memory of one. Over several machines those first
 * ranks share the model's cycles.
 *   mpicc one_model_a_machine.c $(pkg-config --cflags hfrac) -lhfrac_mpi -lhfrac && mpirun --bind-to none -n 8 ./a.out case.toml */
#define HFRAC_ENABLE_UNSTABLE 1
#include <hfrac/hfrac.h>
#include <hfrac/mpi.h>
#include <mpi.h>
#include <stdio.h>
#include <time.h>

static int failed(int32_t status, const hfrac_sim* sim) {
  char text[512];
  if (status >= 0) return 0;
  hfrac_last_error(sim, text, sizeof text, NULL);
  fprintf(stderr, "%s\n", text);
  return 1;
}

/* The length of the longest fracture [m], -1 after a failure. */
static double fracture_length(MPI_Comm leaders, int workers, const char* case_file) {
  hfrac_sim_def def;
  hfrac_sim* sim = NULL;
  hfrac_fracture longest;
  int64_t count = 0;
  double length = -1.0;
  if (failed(hfrac_sim_def_init(&def, sizeof def), NULL)) return -1.0;
  if (!failed(hfrac_sim_def_load(&def, case_file), NULL)) {
    def.run_workers = workers;
    if (!failed(hfrac_sim_create_mpi(&def, (int32_t)MPI_Comm_c2f(leaders), &sim), NULL) &&
        !failed(hfrac_step(sim, def.stepping_steps), sim) &&
        !failed(hfrac_fractures(sim, sizeof longest, &longest, 1, &count), sim))
      length = count > 0 ? longest.length : 0.0;
  }
  hfrac_sim_destroy(&sim);
  hfrac_sim_def_free(&def);
  return length;
}

/* Until all have come. MPI's own barrier would keep the cores busy that the workers need. */
static void sleep_until_all_are_here(MPI_Comm comm) {
  const struct timespec nap = {0, 1000000};
  MPI_Request request;
  int here = 0;
  MPI_Ibarrier(comm, &request);
  for (;;) {
    MPI_Test(&request, &here, MPI_STATUS_IGNORE);
    if (here) return;
    nanosleep(&nap, NULL);
  }
}

int main(int argc, char** argv) {
  MPI_Comm machine, leaders;
  int rank, place, ranks_here;
  double length = 0.0;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_rank(machine, &place);
  MPI_Comm_size(machine, &ranks_here);
  MPI_Comm_split(MPI_COMM_WORLD, place == 0 ? 0 : MPI_UNDEFINED, rank, &leaders);

  if (argc > 1 && leaders != MPI_COMM_NULL) length = fracture_length(leaders, ranks_here, argv[1]);
  sleep_until_all_are_here(machine);
  MPI_Bcast(&length, 1, MPI_DOUBLE, 0, machine);
  printf("rank %d, of %d on its machine: fracture of %.1f m\n", rank, ranks_here, length);

  if (leaders != MPI_COMM_NULL) MPI_Comm_free(&leaders);
  MPI_Comm_free(&machine);
  MPI_Finalize();
  return length < 0.0;
}
