/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Solvers of linear equations from outside: for the flow step (flow.solver = "petsc") and in the place of the factor that
 * preconditions the quasi-static solver's own Krylov method (solver.factor = "petsc"). hfrac/petsc.h (libhfrac_petsc) fills the table
 * with PETSc's; the library knows none.
 *
 * Over ranks each gives the entries of its own rows, so that nobody's memory holds all of the matrix or of what a solver makes of it;
 * right sides and solutions are whole on all. The functions are collective. What they return may differ by rank: a failure of one is
 * made everybody's.
 */
#ifndef HFRAC_LINEAR_SOLVER_H
#define HFRAC_LINEAR_SOLVER_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What the equations are, by which a solver chooses its way. */
enum hfrac_matrix_kind {
  HFRAC_MATRIX_FLOW = 1,   /**< symmetric, positive definite, no positive entry off the diagonal; solved to a tolerance */
  HFRAC_MATRIX_TANGENT = 2 /**< symmetric in its pattern only, indefinite; solved once through a factor */
};

/** The rows of a square matrix that this rank gives, as a list of entries; those for the same place add up. Borrowed for the call. */
typedef struct hfrac_matrix {
  int32_t struct_size;   /**< sizeof(hfrac_matrix) of the library */
  int32_t kind;          /**< hfrac_matrix_kind */
  int64_t size;          /**< rows of all ranks */
  int64_t first_row;     /**< this rank's are first_row up to end_row, which is the next one's first_row */
  int64_t end_row;       /**< the one behind the last */
  int64_t count;         /**< entries */
  const int32_t *row;    /**< of each entry; NULL: places are those of the last call, on all ranks */
  const int32_t *column; /**< likewise */
  const double *value;   /**< of each entry */
} hfrac_matrix;

/** Takes the matrix; a factor may be left to the first solve, when the caller's lists are gone. `*prepared` is NULL at first, and what it is set to in later calls for the same equations.
 * All functions of the table return 0, or nonzero if they failed. */
typedef int32_t (*hfrac_prepare_fn)(void *user, const hfrac_matrix *matrix, void **prepared);
/** x of matrix x = right, to |right - matrix x| <= tolerance |right| in a norm of the solver's choice, with the same bits on all ranks;
 * `iterations`: what it took. */
typedef int32_t (*hfrac_solve_fn)(void *user, void *prepared, const double *right, double *x, double tolerance, int32_t *iterations);
/** The end of what was prepared; NULL is allowed. Not collective after a failure of another rank. */
typedef int32_t (*hfrac_release_fn)(void *user, void *prepared);
/** Why the last call on this rank failed: at most `size` bytes with the ending 0. */
typedef int32_t (*hfrac_reason_fn)(void *user, char *text, int64_t size);

/** Solvers from outside. Fill with hfrac_linear_solver_init, then all members, and let hfrac_exchange::linear_solver point to it. */
typedef struct hfrac_linear_solver {
  int32_t struct_size;      /**< sizeof(hfrac_linear_solver) of the caller, set by init */
  int32_t struct_pad;       /**< 0 */
  void *user;               /**< handed to all functions; must live as long as the simulation */
  hfrac_prepare_fn prepare; /**< the matrix */
  hfrac_solve_fn solve;     /**< a right side */
  hfrac_release_fn release; /**< the end */
  hfrac_reason_fn reason;   /**< why not */
} hfrac_linear_solver;

/** Defaults into `solver`; `struct_size` is sizeof(hfrac_linear_solver) in the caller. Unstable since 0.2. */
HFRAC_UNSTABLE_API int32_t hfrac_linear_solver_init(hfrac_linear_solver *solver, int32_t struct_size);

#ifdef __cplusplus
}
#endif

#endif
