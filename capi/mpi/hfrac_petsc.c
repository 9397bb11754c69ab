/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What hfrac/linear_solver.h asks of a solver, by PETSc's KSP: methods are set here and can be changed by PETSc's options. A matrix is
 * a Mat of the rows that each rank gives. The place of a factor is taken by KSP's "preonly" with MUMPS.
 */
#define HFRAC_ENABLE_UNSTABLE
#include "hfrac/petsc.h"

#include <petscksp.h>
#include <stdio.h>

#include "row_pattern.h"

/* Of one communicator. */
typedef struct Solvers {
  MPI_Comm comm;
  char reason[512];
} Solvers;

/* Of one matrix. */
typedef struct Prepared {
  RowPattern pattern;
  PetscInt first;
  Mat matrix;
  KSP ksp;
  Vec right, x, all; /* all: of all ranks, the whole of x */
  VecScatter gather;
} Prepared;

/* PETSc's own state of the process. */
static MPI_Comm world = MPI_COMM_NULL; /* PETSC_COMM_WORLD, if PETSc was initialised here */
static int end_key = MPI_KEYVAL_INVALID, solvers_key = MPI_KEYVAL_INVALID;

static int is_running(void) {
  int begun = 0, over = 0;
  MPI_Initialized(&begun);
  MPI_Finalized(&over);
  return begun && !over;
}

/* Before MPI ends. */
static int end_petsc(MPI_Comm comm, int key, void* attribute, void* extra) {
  (void)comm, (void)key, (void)attribute, (void)extra;
  PetscBool begun = PETSC_FALSE;
  PetscInitialized(&begun);
  if (begun && world != MPI_COMM_NULL) PetscFinalize();
  return MPI_SUCCESS;
}

static PetscErrorCode begin_petsc(MPI_Comm comm) {
  PetscBool begun = PETSC_FALSE;
  PetscCall(PetscInitialized(&begun));
  if (begun) return 0;
  char name[] = "hfrac", no_file[] = "-skip_petscrc", no_handler[] = "-no_signal_handler";
  char* words[] = {name, no_file, no_handler, NULL};
  char** arguments = words;
  int count = 3;
  if (MPI_Comm_dup(comm, &world) != MPI_SUCCESS) return PETSC_ERR_MPI;
  PETSC_COMM_WORLD = world;
  PetscCall(PetscInitialize(&count, &arguments, NULL, NULL));
  if (MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, end_petsc, &end_key, NULL) != MPI_SUCCESS ||
      MPI_Comm_set_attr(MPI_COMM_SELF, end_key, NULL) != MPI_SUCCESS)
    return PETSC_ERR_MPI;
  return 0;
}

/* PETSc's first words about an error; it is only told, and goes up as a code. */
static PetscErrorCode note(MPI_Comm comm, int line, const char* function, const char* file,
                           PetscErrorCode code, PetscErrorType type, const char* text, void* user) {
  (void)comm, (void)line, (void)file;
  Solvers* s = user;
  if (type == PETSC_ERROR_INITIAL || s->reason[0] == '\0')
    snprintf(s->reason, sizeof s->reason, "PETSc's %s: %s", function, text != NULL ? text : "failed");
  return code;
}

/* Error handlers are a stack of the process: ours is on it for the call only. */
static int32_t with_handler(Solvers* s, PetscErrorCode (*work)(Solvers*, void*), void* of) {
  s->reason[0] = '\0';
  if (PetscPushErrorHandler(note, s)) return 1;
  const PetscErrorCode code = work(s, of);
  PetscPopErrorHandler();
  if (code && s->reason[0] == '\0') snprintf(s->reason, sizeof s->reason, "PETSc's error %d", (int)code);
  return code ? 1 : 0;
}

static PetscErrorCode fill(Prepared* p, const PetscScalar* value) {
  PetscBool alone;
  PetscScalar* to;
  PetscFunctionBegin;
  PetscCall(PetscObjectTypeCompare((PetscObject)p->matrix, MATSEQAIJ, &alone));
  if (alone) {
    PetscCall(MatSeqAIJGetArrayWrite(p->matrix, &to));
    memcpy(to, value, (size_t)p->pattern.start[p->pattern.rows] * sizeof *to);
    PetscCall(MatSeqAIJRestoreArrayWrite(p->matrix, &to));
  } else {
    PetscCall(MatUpdateMPIAIJWithArray(p->matrix, value));
  }
  PetscFunctionReturn(0);
}

static PetscErrorCode choose_flow(KSP ksp) {
  PC pc;
  PetscBool hypre;
  PetscFunctionBegin;
  PetscCall(KSPSetType(ksp, KSPCG));
  PetscCall(KSPSetNormType(ksp, KSP_NORM_NATURAL)); /* of the energy: conductances differ by 1e10 */
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PetscHasExternalPackage("hypre", &hypre));
  PetscCall(PCSetType(pc, hypre ? PCHYPRE : PCGAMG));
  if (hypre) PetscCall(PCHYPRESetType(pc, "boomeramg"));
  PetscFunctionReturn(0);
}

static PetscErrorCode choose_tangent(KSP ksp) {
  PC pc;
  PetscBool mumps;
  PetscFunctionBegin;
  PetscCall(PetscHasExternalPackage("mumps", &mumps));
  PetscCheck(mumps, PETSC_COMM_SELF, PETSC_ERR_SUP, "it was built without MUMPS, which solver.factor needs");
  PetscCall(KSPSetType(ksp, KSPPREONLY));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCSetType(pc, PCLU));
  PetscCall(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  PetscFunctionReturn(0);
}

static PetscErrorCode destroy(Solvers* s, void* of) {
  Prepared* p = of;
  (void)s;
  PetscFunctionBegin;
  PetscCall(KSPDestroy(&p->ksp));
  PetscCall(MatDestroy(&p->matrix));
  PetscCall(VecScatterDestroy(&p->gather));
  PetscCall(VecDestroy(&p->right));
  PetscCall(VecDestroy(&p->x));
  PetscCall(VecDestroy(&p->all));
  PetscFunctionReturn(0);
}

typedef struct Preparation {
  const hfrac_matrix* m;
  Prepared* p;
  const PetscScalar* value;
} Preparation;

static const char* prefix_of(const hfrac_matrix* m) {
  return m->kind == HFRAC_MATRIX_FLOW ? "hfrac_flow_" : "hfrac_tangent_";
}

static PetscErrorCode make(Solvers* s, const hfrac_matrix* m, Prepared* p, const PetscScalar* value) {
  const PetscInt rows = (PetscInt)(m->end_row - m->first_row), all = (PetscInt)m->size;
  PetscFunctionBegin;
  PetscCall(destroy(s, p));
  p->first = (PetscInt)m->first_row;
  PetscCall(MatCreate(s->comm, &p->matrix));
  PetscCall(MatSetSizes(p->matrix, rows, rows, all, all));
  PetscCall(MatSetOptionsPrefixFactor(p->matrix, prefix_of(m)));
  PetscCall(MatSetType(p->matrix, MATAIJ));
  PetscCall(MatSeqAIJSetPreallocationCSR(p->matrix, p->pattern.start, p->pattern.column, value));
  PetscCall(MatMPIAIJSetPreallocationCSR(p->matrix, p->pattern.start, p->pattern.column, value));
  if (m->kind == HFRAC_MATRIX_FLOW) PetscCall(MatSetOption(p->matrix, MAT_SPD, PETSC_TRUE));
  PetscCall(MatCreateVecs(p->matrix, &p->x, &p->right));
  PetscCall(VecScatterCreateToAll(p->x, &p->gather, &p->all));
  PetscCall(KSPCreate(s->comm, &p->ksp));
  PetscCall(KSPSetOptionsPrefix(p->ksp, prefix_of(m)));
  PetscCall(KSPSetOperators(p->ksp, p->matrix, p->matrix)); /* MUMPS is chosen for a matrix */
  PetscCall(m->kind == HFRAC_MATRIX_FLOW ? choose_flow(p->ksp) : choose_tangent(p->ksp));
  PetscCall(KSPSetFromOptions(p->ksp));
  PetscFunctionReturn(0);
}

/* A matrix without a factor, and equations without a solution, are no errors to PETSc but reasons why KSP ended. */
static PetscErrorCode require_good(KSP ksp) {
  KSPConvergedReason why;
  const char* words = NULL;
  PC pc;
  PCFailedReason failed;
  PetscFunctionBegin;
  PetscCall(KSPGetConvergedReason(ksp, &why));
  PetscCall(KSPGetConvergedReasonString(ksp, &words));
  PetscCall(KSPGetPC(ksp, &pc));
  PetscCall(PCGetFailedReason(pc, &failed));
  PetscCheck(failed == PC_NOERROR, PETSC_COMM_SELF, PETSC_ERR_NOT_CONVERGED,
             "the preconditioner could not be made (%s): is the matrix singular?", PCFailedReasons[failed]);
  PetscCheck(why >= 0, PETSC_COMM_SELF, PETSC_ERR_NOT_CONVERGED, "no solution (%s)", words);
  PetscFunctionReturn(0);
}

static PetscErrorCode set_up(Solvers* s, void* of) {
  const Preparation* preparation = of;
  const hfrac_matrix* m = preparation->m;
  Prepared* p = preparation->p;
  PetscFunctionBegin;
  if (m->row != NULL)
    PetscCall(make(s, m, p, preparation->value));
  else
    PetscCall(fill(p, preparation->value));
  PetscCall(KSPSetOperators(p->ksp, p->matrix,
                            p->matrix)); /* new numbers; without it the old preconditioner stays */
  PetscFunctionReturn(0);
}

static int32_t prepare(void* user, const hfrac_matrix* m, void** prepared) {
  Solvers* s = user;
  snprintf(s->reason, sizeof s->reason,
           m->count > INT32_MAX
               ? "%lld entries on one rank, and PETSc counts up to 2147483647; take more ranks"
               : "no memory for %lld entries",
           (long long)m->count);
  int status = m->size > PETSC_MAX_INT;
  if (*prepared == NULL) *prepared = calloc(1, sizeof(Prepared));
  Prepared* p = *prepared;
  if (status == 0 && p != NULL && m->row != NULL) status = find_pattern(&p->pattern, m);
  PetscScalar* value = status == 0 && p != NULL ? add_up(&p->pattern, m->value) : NULL;
  /* PETSc waits for all: none may be missing. */
  int failed = value == NULL;
  if (MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, s->comm) != MPI_SUCCESS) failed = 1;
  Preparation preparation = {m, p, value};
  status = failed ? 1 : with_handler(s, set_up, &preparation);
  free(value);
  if (p != NULL) {
    free(p->pattern.column);
    p->pattern.column = NULL;
  }
  return status;
}

typedef struct Solution {
  Prepared* p;
  const double* right;
  double *x, tolerance;
  int32_t* iterations;
} Solution;

static PetscErrorCode find(Solvers* s, void* of) {
  Solution* solution = of;
  Prepared* p = solution->p;
  PetscScalar* to;
  const PetscScalar* from;
  PetscInt size, count;
  (void)s;
  PetscFunctionBegin;
  PetscCall(VecGetLocalSize(p->right, &size));
  PetscCall(VecGetArrayWrite(p->right, &to));
  for (PetscInt k = 0; k < size; ++k) to[k] = solution->right[p->first + k];
  PetscCall(VecRestoreArrayWrite(p->right, &to));
  if (solution->tolerance > 0.0)
    PetscCall(KSPSetTolerances(p->ksp, solution->tolerance, 0.0, PETSC_DEFAULT, PETSC_DEFAULT));
  PetscCall(KSPSolve(p->ksp, p->right, p->x)); /* with new numbers: makes the preconditioner first */
  PetscCall(require_good(p->ksp));
  PetscCall(KSPGetIterationNumber(p->ksp, &count));
  *solution->iterations = (int32_t)count;
  PetscCall(VecScatterBegin(p->gather, p->x, p->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecScatterEnd(p->gather, p->x, p->all, INSERT_VALUES, SCATTER_FORWARD));
  PetscCall(VecGetLocalSize(p->all, &size));
  PetscCall(VecGetArrayRead(p->all, &from));
  for (PetscInt k = 0; k < size; ++k) solution->x[k] = PetscRealPart(from[k]);
  PetscCall(VecRestoreArrayRead(p->all, &from));
  PetscFunctionReturn(0);
}

static int32_t solve(void* user, void* prepared, const double* right, double* x, double tolerance,
                     int32_t* iterations) {
  Solution solution = {prepared, right, x, tolerance, iterations};
  return with_handler(user, find, &solution);
}

static int32_t release(void* user, void* prepared) {
  Prepared* p = prepared;
  PetscBool begun = PETSC_FALSE;
  if (p == NULL) return 0;
  int32_t status = 0;
  /* After MPI nothing of PETSc can be given back. */
  PetscInitialized(&begun);
  if (is_running() && begun) status = with_handler(user, destroy, p);
  forget_pattern(&p->pattern);
  free(p);
  return status;
}

static int32_t reason(void* user, char* text, int64_t size) {
  const Solvers* s = user;
  if (size > 0) snprintf(text, (size_t)size, "%s", s->reason);
  return 0;
}

static int forget(MPI_Comm comm, int key, void* attribute, void* extra) {
  (void)comm, (void)key, (void)extra;
  Solvers* s = attribute;
  MPI_Comm_free(&s->comm);
  free(s);
  return MPI_SUCCESS;
}

/* The one of a communicator, made when it is first asked for. */
static Solvers* solvers_of(MPI_Comm comm) {
  Solvers* s = NULL;
  int found = 0;
  if (solvers_key == MPI_KEYVAL_INVALID &&
      MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, forget, &solvers_key, NULL) != MPI_SUCCESS)
    return NULL;
  if (MPI_Comm_get_attr(comm, solvers_key, &s, &found) != MPI_SUCCESS) return NULL;
  if (found) return s;
  s = calloc(1, sizeof *s);
  if (s == NULL || MPI_Comm_dup(comm, &s->comm) != MPI_SUCCESS) {
    free(s);
    return NULL;
  }
  MPI_Comm_set_errhandler(s->comm, MPI_ERRORS_RETURN);
  return MPI_Comm_set_attr(comm, solvers_key, s) == MPI_SUCCESS ? s : NULL;
}

int32_t hfrac_petsc_solver(int32_t fortran_comm, hfrac_linear_solver* solver) {
  if (solver == NULL) return HFRAC_ERR_ARGUMENT;
  if (!is_running()) return HFRAC_ERR_EXCHANGE;
  const MPI_Comm comm = MPI_Comm_f2c((MPI_Fint)fortran_comm);
  if (comm == MPI_COMM_NULL || begin_petsc(comm)) return HFRAC_ERR_EXCHANGE;
  const int32_t status = hfrac_linear_solver_init(solver, (int32_t)sizeof *solver);
  if (status != HFRAC_OK) return status;
  solver->user = solvers_of(comm);
  solver->prepare = prepare;
  solver->solve = solve;
  solver->release = release;
  solver->reason = reason;
  return solver->user != NULL ? HFRAC_OK : HFRAC_ERR_EXCHANGE;
}

int32_t hfrac_petsc_begin(hfrac_linear_solver* solver) {
  return hfrac_petsc_solver(is_running() ? (int32_t)MPI_Comm_c2f(MPI_COMM_WORLD) : 0, solver);
}
