/* SPDX-License-Identifier: BSD-3-Clause
 *
 * From a list of entries, several of them for one place, to rows with each place once, columns ascending; found once for as long as
 * places stay.
 */
#ifndef HFRAC_ROW_PATTERN_H
#define HFRAC_ROW_PATTERN_H

#include <petscsys.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "hfrac/linear_solver.h"

typedef struct RowPattern {
  int64_t rows, entries;
  PetscInt *start, *column; /* of rows, of places; columns for as long as nobody else has them */
  int32_t* place;           /* of each entry */
} RowPattern;

static void forget_pattern(RowPattern* p) {
  free(p->start);
  free(p->column);
  free(p->place);
  memset(p, 0, sizeof *p);
}

static int by_column(const void* a, const void* b) {
  const int64_t p = *(const int64_t*)a, q = *(const int64_t*)b;
  return (p > q) - (p < q);
}

/* 0, or nonzero if there is no memory, or more than 2^31 entries of one rank. */
static int find_pattern(RowPattern* p, const hfrac_matrix* m) {
  forget_pattern(p);
  const int64_t rows = m->end_row - m->first_row;
  if (m->count > INT32_MAX) return 1;
  p->rows = rows;
  p->entries = m->count;
  int64_t* begin = calloc((size_t)rows + 2, sizeof *begin);
  int64_t* key = malloc(((size_t)m->count + 1) * sizeof *key); /* column, then entry */
  p->start = malloc(((size_t)rows + 1) * sizeof *p->start);
  p->place = malloc(((size_t)m->count + 1) * sizeof *p->place);
  int good = begin && key && p->start && p->place;
  if (good) {
    for (int64_t k = 0; k < m->count; ++k) ++begin[m->row[k] - m->first_row + 2];
    for (int64_t r = 0; r < rows; ++r) begin[r + 2] += begin[r + 1];
    for (int64_t k = 0; k < m->count; ++k)
      key[begin[m->row[k] - m->first_row + 1]++] = ((int64_t)m->column[k] << 32) | k;
    int64_t places = 0;
    for (int64_t r = 0; r < rows; ++r) {
      p->start[r] = (PetscInt)places;
      qsort(key + begin[r], (size_t)(begin[r + 1] - begin[r]), sizeof *key, by_column);
      for (int64_t k = begin[r]; k < begin[r + 1]; ++k) {
        if (k == begin[r] || key[k] >> 32 != key[k - 1] >> 32) ++places;
        p->place[key[k] & 0xffffffff] = (int32_t)(places - 1);
      }
    }
    p->start[rows] = (PetscInt)places;
    p->column = malloc(((size_t)places + 1) * sizeof *p->column);
    good = p->column != NULL;
    for (int64_t k = 0; good && k < m->count; ++k) p->column[p->place[k]] = (PetscInt)m->column[k];
  }
  free(begin);
  free(key);
  if (!good) forget_pattern(p);
  return !good;
}

/* Of places, in rows; to be freed. NULL: no memory. */
static PetscScalar* add_up(const RowPattern* p, const double* value) {
  PetscScalar* sum = calloc((size_t)p->start[p->rows] + 1, sizeof *sum);
  for (int64_t k = 0; sum != NULL && k < p->entries; ++k) sum[p->place[k]] += value[k];
  return sum;
}

#endif
