/* SPDX-License-Identifier: BSD-3-Clause */
/* The rock as an unstructured grid. A face's corners come in order from the library; the edge between two of them is the
 * bond of these two discs. */
#include <stdlib.h>

#include "model.h"

/* All values of an int32 field, to be freed; NULL on failure. */
static int32_t* copy_of(Model* model, int field, int64_t* count) {
  int32_t* values = NULL;
  if (passed(model, hfrac_field_copy_i32(model->sim, field, NULL, 0, count)) != 0) return NULL;
  values = (int32_t*)malloc((size_t)*count * sizeof *values + 1);
  if (values == NULL) {
    fail(model, "out of memory.");
    return NULL;
  }
  if (passed(model, hfrac_field_copy_i32(model->sim, field, values, *count, count)) != 0) {
    free(values);
    return NULL;
  }
  return values;
}

/* Bonds by disc: those of disc i are bond[start[i]] to bond[start[i + 1] - 1]. */
typedef struct Adjacency {
  int32_t *start, *bond;
  const int32_t* discs;
} Adjacency;

static int make_adjacency(Adjacency* a, const int32_t* discs, int64_t bonds, int64_t disc_count) {
  int64_t b, i;
  int end;
  a->discs = discs;
  a->start = (int32_t*)calloc((size_t)disc_count + 2, sizeof *a->start);
  a->bond = (int32_t*)malloc((size_t)(2 * bonds) * sizeof *a->bond + 1);
  if (a->start == NULL || a->bond == NULL) return -1;
  /* Counted one place further on, so that filling moves each start to where it belongs. */
  for (b = 0; b < 2 * bonds; ++b) ++a->start[discs[b] + 2];
  for (i = 1; i <= disc_count; ++i) a->start[i + 1] += a->start[i];
  for (b = 0; b < bonds; ++b) {
    for (end = 0; end < 2; ++end) a->bond[a->start[discs[2 * b + end] + 1]++] = (int32_t)b;
  }
  return 0;
}

static int32_t bond_between(const Adjacency* a, int32_t from, int32_t to) {
  int32_t k;
  for (k = a->start[from]; k < a->start[from + 1]; ++k) {
    const int32_t b = a->bond[k];
    if (a->discs[2 * b] == to || a->discs[2 * b + 1] == to) return b;
  }
  return -1;
}

int face_rings(Model* model, int* nodes_per_face, int* nodes, int* edges) {
  int64_t corner_count = 0, domains = 0, bonds = 0, d, k, out = 0;
  const int64_t discs = item_count(model, HFRAC_DISC_RADIUS);
  int32_t* corners = copy_of(model, HFRAC_DOMAIN_CORNERS, &corner_count);
  int32_t* start = copy_of(model, HFRAC_DOMAIN_OFFSET, &domains);
  int32_t* ends = copy_of(model, HFRAC_BOND_DISCS, &bonds);
  Adjacency adjacency = {NULL, NULL, NULL};
  int result = corners != NULL && start != NULL && ends != NULL && discs >= 0 ? 0 : -1;
  bonds /= 2;
  if (result == 0 && edges != NULL && make_adjacency(&adjacency, ends, bonds, discs) != 0) {
    result = fail(model, "out of memory.");
  }
  for (d = 1; result == 0 && d < domains; ++d) { /* domain 0 is the outside */
    const int64_t first = start[d], last = d + 1 < domains ? start[d + 1] : corner_count;
    if (nodes_per_face != NULL) nodes_per_face[d - 1] = (int)(last - first);
    for (k = first; k < last; ++k, ++out) {
      if (nodes != NULL) nodes[out] = corners[k];
      if (edges != NULL) {
        edges[out] = bond_between(&adjacency, corners[k], corners[k + 1 < last ? k + 1 : first]);
        if (edges[out] < 0) result = fail(model, "two corners of a face have no bond between them.");
      }
    }
  }
  free(adjacency.start);
  free(adjacency.bond);
  free(corners);
  free(start);
  free(ends);
  return result;
}
