/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What hfrac/exchange.h asks of a transport, by MPI. Nobody waits in MPI itself: every wait looks whether it is over and whether some
 * rank has failed, which that rank says by a message to all others with the reason in it. Nothing here ends the process: errors of MPI are returned.
 */
#define _GNU_SOURCE /* sched_setaffinity */
#define HFRAC_ENABLE_UNSTABLE
#include "hfrac/mpi.h"

#include <limits.h>
#include <mpi.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { tag_message = 1, tag_failed = 2, longest_reason = 512 };
static const double longest_spin = 2e-4; /* s */

/* Of one communicator. */
typedef struct Talk {
  MPI_Comm comm;
  int rank, size, failed;
  MPI_Request* requests; /* of the messages under way */
  int count, capacity;
  char reason
      [longest_reason]; /* of this rank's failure; sent from here, and Talks that have failed are kept */
  int told_by;          /* the lowest rank whose reason is in `told`; -1: none */
  char told[longest_reason];
} Talk;

static int has_failed(Talk* talk) {
  int there = 0;
  if (!talk->failed &&
      (MPI_Iprobe(MPI_ANY_SOURCE, tag_failed, talk->comm, &there, MPI_STATUS_IGNORE) != MPI_SUCCESS || there))
    talk->failed = 1;
  return talk->failed;
}

/* Gives the core to others. A rank that has waited longer than ranks on cores of their own do waits for one that has no core, or shares it:
 * there sched_yield does little beside a busy program, and a sleeper is woken at once when its turn comes. */
static void let_others(double since) {
  const struct timespec nap = {0, 20000};
  if (MPI_Wtime() - since > longest_spin) {
    nanosleep(&nap, NULL);
  } else {
    sched_yield();
  }
}

/* Until all requests are done; nonzero once a rank has failed. */
static int wait_for(Talk* talk, MPI_Request* requests, int count) {
  double since = 0.0;
  for (int64_t turn = 1;; ++turn) {
    int done = 0;
    if (MPI_Testall(count, requests, &done, MPI_STATUSES_IGNORE) != MPI_SUCCESS) return talk->failed = 1;
    if (done) return 0;
    if (turn % 64 == 0) {
      if (has_failed(talk)) return 1;
      if (turn == 64) since = MPI_Wtime();
      let_others(since);
    }
  }
}

static int32_t start(void* user, const hfrac_message* messages, int32_t count) {
  Talk* talk = user;
  if (talk->failed) return 1;
  if (2 * count > talk->capacity) {
    MPI_Request* more = realloc(talk->requests, 2 * (size_t)count * sizeof *more);
    if (more == NULL) return talk->failed = 1;
    talk->requests = more;
    talk->capacity = 2 * count;
  }
  talk->count = 0;
  for (int32_t k = 0; k < count; ++k) {
    const hfrac_message* m = &messages[k];
    if (m->receive_bytes > INT_MAX || m->send_bytes > INT_MAX) return talk->failed = 1;
    if (m->receive_bytes > 0 && MPI_Irecv(m->receive, (int)m->receive_bytes, MPI_BYTE, m->rank, tag_message,
                                          talk->comm, &talk->requests[talk->count++]) != MPI_SUCCESS)
      return talk->failed = 1;
    if (m->send_bytes > 0 && MPI_Isend(m->send, (int)m->send_bytes, MPI_BYTE, m->rank, tag_message,
                                       talk->comm, &talk->requests[talk->count++]) != MPI_SUCCESS)
      return talk->failed = 1;
  }
  return 0;
}

static int32_t finish(void* user) {
  Talk* talk = user;
  if (talk->failed) return 1;
  const int status = wait_for(talk, talk->requests, talk->count);
  talk->count = 0;
  return status;
}

static int32_t sum(void* user, int64_t* values, int32_t count) {
  Talk* talk = user;
  if (talk->failed) return 1;
  MPI_Request request;
  if (MPI_Iallreduce(MPI_IN_PLACE, values, count, MPI_INT64_T, MPI_SUM, talk->comm, &request) != MPI_SUCCESS)
    return talk->failed = 1;
  return wait_for(talk, &request, 1);
}

/* In pieces that MPI's int counts: one rank after the other tells all. */
static int32_t gather(void* user, void* all, const int64_t* begin) {
  Talk* talk = user;
  const int64_t most = INT64_C(1) << 30;
  for (int r = 0; r < talk->size; ++r) {
    for (int64_t at = begin[r]; at < begin[r + 1]; at += most) {
      const int64_t bytes = begin[r + 1] - at < most ? begin[r + 1] - at : most;
      MPI_Request request;
      if (talk->failed) return 1;
      if (MPI_Ibcast((char*)all + at, (int)bytes, MPI_BYTE, r, talk->comm, &request) != MPI_SUCCESS)
        return talk->failed = 1;
      if (wait_for(talk, &request, 1)) return 1;
    }
  }
  return talk->failed;
}

static int32_t fail_text(void* user, const char* text) {
  Talk* talk = user;
  if (!talk->failed && text != NULL) strncpy(talk->reason, text, longest_reason - 1);
  return 0;
}

static int32_t fail(void* user) {
  Talk* talk = user;
  const int bytes = (int)strlen(talk->reason);
  for (int r = 0; r < talk->size; ++r) {
    MPI_Request request;
    if (r != talk->rank &&
        MPI_Isend(talk->reason, bytes, MPI_BYTE, r, tag_failed, talk->comm, &request) == MPI_SUCCESS)
      MPI_Request_free(&request);
  }
  talk->failed = 1;
  return 0;
}

/* Of what has come so far; a rank's message has come whole once it can be seen. */
static int32_t failed(void* user, int32_t* rank, char* text, int32_t size) {
  Talk* talk = user;
  if (rank == NULL || text == NULL || size < 1) return 1;
  for (int r = 0; r < (talk->told_by < 0 ? talk->size : talk->told_by); ++r) {
    int there = 0, bytes = 0;
    MPI_Status status;
    if (MPI_Iprobe(r, tag_failed, talk->comm, &there, &status) != MPI_SUCCESS || !there) continue;
    char reason[longest_reason] = "";
    if (MPI_Get_count(&status, MPI_BYTE, &bytes) != MPI_SUCCESS || bytes >= longest_reason ||
        MPI_Recv(reason, bytes, MPI_BYTE, r, tag_failed, talk->comm, MPI_STATUS_IGNORE) != MPI_SUCCESS ||
        bytes == 0)
      continue;
    talk->told_by = r;
    memcpy(talk->told, reason, longest_reason);
    break;
  }
  if (talk->told_by < 0) return 1;
  *rank = talk->told_by;
  strncpy(text, talk->told, (size_t)size - 1);
  text[size - 1] = 0;
  return 0;
}

/* With the communicator goes what belongs to it. After a failure messages may still be under way: their memory is left to them. */
static int forget(MPI_Comm comm, int key, void* attribute, void* extra) {
  (void)comm, (void)key, (void)extra;
  Talk* talk = attribute;
  if (!talk->failed) {
    MPI_Comm_free(&talk->comm);
    free(talk->requests);
    free(talk);
  }
  return MPI_SUCCESS;
}

static int talk_key = MPI_KEYVAL_INVALID;

/* The one of a communicator, made when it is first asked for. */
static Talk* talk_of(MPI_Comm comm) {
  Talk* talk = NULL;
  int found = 0;
  if (talk_key == MPI_KEYVAL_INVALID &&
      MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, forget, &talk_key, NULL) != MPI_SUCCESS)
    return NULL;
  if (MPI_Comm_get_attr(comm, talk_key, &talk, &found) != MPI_SUCCESS) return NULL;
  if (found) return talk;
  talk = calloc(1, sizeof *talk);
  if (talk == NULL) return NULL;
  talk->told_by = -1;
  if (MPI_Comm_dup(comm, &talk->comm) != MPI_SUCCESS) {
    free(talk);
    return NULL;
  }
  MPI_Comm_set_errhandler(talk->comm, MPI_ERRORS_RETURN);
  MPI_Comm_rank(talk->comm, &talk->rank);
  MPI_Comm_size(talk->comm, &talk->size);
  if (MPI_Comm_set_attr(comm, talk_key, talk) != MPI_SUCCESS) return NULL;
  return talk;
}

static int32_t table_of(MPI_Comm comm, hfrac_exchange* exchange) {
  Talk* talk = comm == MPI_COMM_NULL ? NULL : talk_of(comm);
  if (talk == NULL) return HFRAC_ERR_EXCHANGE;
  const int32_t status = hfrac_exchange_init(exchange, (int32_t)sizeof *exchange);
  if (status != HFRAC_OK) return status;
  exchange->rank = talk->rank;
  exchange->size = talk->size;
  exchange->user = talk;
  exchange->start = start;
  exchange->finish = finish;
  exchange->sum = sum;
  exchange->gather = gather;
  exchange->fail = fail;
  exchange->fail_text = fail_text;
  exchange->failed = failed;
  return HFRAC_OK;
}

static int is_running(void) {
  int begun = 0, over = 0;
  MPI_Initialized(&begun);
  MPI_Finalized(&over);
  return begun && !over;
}

int32_t hfrac_mpi_exchange(int32_t fortran_comm, hfrac_exchange* exchange) {
  if (exchange == NULL) return HFRAC_ERR_ARGUMENT;
  return is_running() ? table_of(MPI_Comm_f2c((MPI_Fint)fortran_comm), exchange) : HFRAC_ERR_EXCHANGE;
}

int32_t hfrac_sim_create_mpi(const hfrac_sim_def* def, int32_t fortran_comm, hfrac_sim** sim) {
  hfrac_exchange exchange;
  if (sim == NULL) return HFRAC_ERR_ARGUMENT;
  *sim = NULL;
  const int32_t status = hfrac_mpi_exchange(fortran_comm, &exchange);
  return status == HFRAC_OK ? hfrac_sim_create_on(def, &exchange, sim) : status;
}

int32_t hfrac_mpi_begin(hfrac_exchange* exchange) {
  if (exchange == NULL) return HFRAC_ERR_ARGUMENT;
  if (!is_running() && MPI_Init(NULL, NULL) != MPI_SUCCESS) return HFRAC_ERR_EXCHANGE;
  return table_of(MPI_COMM_WORLD, exchange);
}

/* Of hfrac_mpi_begin_on_machines: the processes of this machine, and of the first of each. */
static MPI_Comm here = MPI_COMM_NULL, firsts = MPI_COMM_NULL;

/* The workers of the first may run where any of a machine's processes may. */
static void take_cores_of_all(int first) {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) != 0) CPU_ZERO(&cores);
  MPI_Allreduce(MPI_IN_PLACE, &cores, (int)sizeof cores, MPI_BYTE, MPI_BOR, here);
  if (first && CPU_COUNT(&cores) > 0) sched_setaffinity(0, sizeof cores, &cores);
}

int32_t hfrac_mpi_begin_on_machines(hfrac_exchange* exchange, int32_t* processes_here) {
  if (exchange == NULL || processes_here == NULL) return HFRAC_ERR_ARGUMENT;
  if (!is_running() && MPI_Init(NULL, NULL) != MPI_SUCCESS) return HFRAC_ERR_EXCHANGE;
  int rank = 0, place = 0, count = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank, MPI_INFO_NULL, &here) != MPI_SUCCESS ||
      MPI_Comm_rank(here, &place) != MPI_SUCCESS || MPI_Comm_size(here, &count) != MPI_SUCCESS ||
      MPI_Comm_split(MPI_COMM_WORLD, place == 0 ? 0 : MPI_UNDEFINED, rank, &firsts) != MPI_SUCCESS)
    return HFRAC_ERR_EXCHANGE;
  take_cores_of_all(place == 0);
  *processes_here = place == 0 ? count : 0;
  return place == 0 ? table_of(firsts, exchange) : HFRAC_OK;
}

/* What the first of this machine came to: from it, to the others, who sleep until they know. */
static int32_t end_of_the_first(int32_t failed) {
  const struct timespec nap = {0, 2000000};
  MPI_Request request;
  int known = 0;
  if (MPI_Ibcast(&failed, 1, MPI_INT32_T, 0, here, &request) != MPI_SUCCESS) return 1;
  while (MPI_Test(&request, &known, MPI_STATUS_IGNORE) == MPI_SUCCESS) {
    if (known) return failed;
    nanosleep(&nap, NULL);
  }
  return 1;
}

int32_t hfrac_mpi_end(int32_t failed) {
  if (!is_running()) return HFRAC_OK;
  if (here != MPI_COMM_NULL) failed = end_of_the_first(failed);
  if (here != MPI_COMM_NULL && firsts == MPI_COMM_NULL) {
    if (failed) return HFRAC_ERR_EXCHANGE;
    return MPI_Finalize() == MPI_SUCCESS ? HFRAC_OK : HFRAC_ERR_EXCHANGE;
  }
  Talk* talk = talk_of(firsts != MPI_COMM_NULL ? firsts : MPI_COMM_WORLD);
  if (talk != NULL && failed && !talk->failed) fail(talk);
  /* The launcher ends those that wait for a rank that is gone; a process that has failed waits for nobody. */
  if (talk != NULL && has_failed(talk)) return HFRAC_ERR_EXCHANGE;
  return MPI_Finalize() == MPI_SUCCESS ? HFRAC_OK : HFRAC_ERR_EXCHANGE;
}
