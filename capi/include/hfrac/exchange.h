/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * One simulation on several ranks: processes of a parallel program, or threads of one, that share the work of its cycles.
 *
 * Every rank creates the simulation from the same definition, holds all of it, and gets the same results, to the last bit those of
 * a single one, whatever the number of ranks and of run.workers. What is shared is the explicit motion (rest, real time), the flow
 * step of large models (conjugate gradients), the quasi-static solver's factor and the vectors of its GMRES; heat, fractures and the rest
 * every rank does for itself. So a model needs the memory of one on each rank, but for that factor, which is the largest part.
 * State images are those of a single simulation: any number of ranks goes on from what any other wrote.
 *
 * Calls that change the simulation are collective: all ranks make them, in the same order and with the same arguments. Definitions that
 * differ, but for run.workers, and loads, lengths of steps or states that differ before a step are refused on all ranks with
 * HFRAC_ERR_ARGUMENT and the name of what differs. Calls that read are not collective. A progress or log function may differ by
 * rank; if one asks to stop, all stop. What fails on all ranks alike is undone as ever. If one rank alone fails (memory, a rank killed), the calls of the others end with HFRAC_ERR_EXCHANGE and its text, if
 * it could still give one, and the simulation can only be destroyed: go on from the last saved state.
 *
 * The library knows no MPI: a table of functions carries its messages. hfrac/mpi.h (libhfrac_mpi) fills it with MPI's.
 */
#ifndef HFRAC_EXCHANGE_H
#define HFRAC_EXCHANGE_H

#include "linear_solver.h"
#include "sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What goes to another rank, and what comes from it; either may be empty. */
typedef struct hfrac_message {
  int32_t rank;          /**< the other one */
  int32_t struct_pad;    /**< 0 */
  int64_t send_bytes;    /**< [B] */
  int64_t receive_bytes; /**< [B] */
  const void *send;      /**< borrowed until hfrac_finish_fn returns */
  void *receive;         /**< written by then */
} hfrac_message;

/** Begins to exchange `count` messages, at most one with each rank. All functions of the table return 0, or nonzero once any rank
 * has failed: then they go on to return nonzero. They are called by one thread of a rank at a time. */
typedef int32_t (*hfrac_start_fn)(void *user, const hfrac_message *messages, int32_t count);
/** Waits until all messages begun have come and gone. */
typedef int32_t (*hfrac_finish_fn)(void *user);
/** Adds up `count` integers over all ranks, in place, on all of them; overflow wraps. */
typedef int32_t (*hfrac_sum_fn)(void *user, int64_t *values, int32_t count);
/** Of the bytes at `all`, rank r has those from begin[r] up to begin[r + 1]; afterwards all ranks have all. */
typedef int32_t (*hfrac_gather_fn)(void *user, void *all, const int64_t *begin);
/** This rank cannot go on: calls that others wait in, or make later, return nonzero. */
typedef int32_t (*hfrac_fail_fn)(void *user);
/** Called before hfrac_fail_fn: why this rank cannot go on, UTF-8 that ends with 0, borrowed for the call. */
typedef int32_t (*hfrac_fail_text_fn)(void *user, const char *text);
/** Called after a nonzero return: of the ranks that have failed with a text the lowest, into `rank`, and its text into the `size`
 * bytes at `text`, cut where it has to be. Returns nonzero if no text is known, as of a rank that was killed. */
typedef int32_t (*hfrac_failed_fn)(void *user, int32_t *rank, char *text, int32_t size);

/** How ranks talk. Fill with hfrac_exchange_init, then all members up to `fail`. */
typedef struct hfrac_exchange {
  int32_t struct_size;    /**< sizeof(hfrac_exchange) of the caller, set by init */
  int32_t rank;           /**< this one, 0 to size - 1 */
  int32_t size;           /**< ranks, 1 to 1048576; with 1 no function is called */
  int32_t struct_pad;     /**< 0 */
  void *user;             /**< handed to all functions; must live as long as the simulation */
  hfrac_start_fn start;   /**< messages between two ranks */
  hfrac_finish_fn finish; /**< the end of those */
  hfrac_sum_fn sum;       /**< integers over all ranks */
  hfrac_gather_fn gather; /**< bytes of all ranks */
  hfrac_fail_fn fail;     /**< the end of it all */
  const hfrac_linear_solver *linear_solver; /**< of these ranks, copied at creation; NULL: hfrac's own only */
  hfrac_fail_text_fn fail_text; /**< why, before the end; NULL: nobody is told */
  hfrac_failed_fn failed;       /**< which rank failed, and why; NULL: "another rank" */
} hfrac_exchange;

/** Defaults into `exchange`, one rank; `struct_size` is sizeof(hfrac_exchange) in the caller. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_exchange_init(hfrac_exchange *exchange, int32_t struct_size);

/** hfrac_sim_create on each of several ranks, which all wait for each other here and in every call that changes the simulation.
 * HFRAC_ERR_EXCHANGE: another rank failed. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_sim_create_on(const hfrac_sim_def *def, const hfrac_exchange *exchange, hfrac_sim **sim);

/** What a rank does for the others in a cycle, since the model was built; zeros with one rank. Set struct_size before the call. */
typedef struct hfrac_traffic {
  int32_t struct_size;     /**< sizeof(hfrac_traffic) of the caller */
  int32_t struct_pad;      /**< 0 */
  int64_t messages;        /**< received a cycle */
  int64_t bytes;           /**< [B] received a cycle */
  int64_t foreign_discs;   /**< discs of other ranks whose motion is received */
  int64_t shared_bonds;    /**< bonds that this rank does beside another, which counts them */
} hfrac_traffic;

/** What this rank receives in a cycle. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_get_traffic(const hfrac_sim *sim, hfrac_traffic *traffic);

#ifdef __cplusplus
}
#endif

#endif
