/* SPDX-License-Identifier: BSD-3-Clause */
/* hfrac as a BMI framework sees it in C: all 41 functions, in the stages in which the public tester goes (control, info and
 * time, variables, grids, values), then what frameworks do to models: two at once, again after the end, wrong use.
 *   bmi_test CASE            all of it
 *   bmi_test CASE --table    prints the variables, for comparison with the Python face */
#include <bmi_hfrac.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64 };

static int failures = 0;

static void check(int holds, const char* what, const Bmi* model) {
  char text[1024] = "";
  if (holds) return;
  if (model != NULL) bmi_hfrac_last_error(model, text, (int)sizeof text);
  fprintf(stderr, "not so: %s (%s)\n", what, text);
  ++failures;
}
#define GOOD(call) check((call) == BMI_SUCCESS, #call, m)
#define BAD(call) check((call) == BMI_FAILURE, #call " must fail", NULL)

typedef struct Names {
  char* list[MOST];
  int count;
} Names;

static Names names_of(Bmi* m, int input) {
  Names names;
  int k;
  GOOD(input ? m->get_input_item_count(m, &names.count) : m->get_output_item_count(m, &names.count));
  check(names.count > 0 && names.count <= MOST, "there are variables", m);
  for (k = 0; k < names.count; ++k) names.list[k] = (char*)calloc(1, BMI_MAX_VAR_NAME);
  GOOD(input ? m->get_input_var_names(m, names.list) : m->get_output_var_names(m, names.list));
  return names;
}
static void free_names(Names* names) {
  int k;
  for (k = 0; k < names->count; ++k) free(names->list[k]);
}

static double time_of(Bmi* m) {
  double time = -1.0;
  GOOD(m->get_current_time(m, &time));
  return time;
}

/* Control */
static void control(const char* file) {
  Bmi model, *m = &model;
  check(register_bmi_hfrac(m) == m && m->data == NULL, "registering hands the model back", NULL);
  check(register_bmi_hfrac(NULL) == NULL, "NULL is no model", NULL);
  GOOD(m->initialize(m, file));
  GOOD(m->finalize(m));
  GOOD(m->initialize(m, file));
  GOOD(m->update(m));
  GOOD(m->finalize(m));
  check(m->data == NULL, "nothing is left", NULL);
}

/* Info and time */
static void info(Bmi* m) {
  char text[BMI_MAX_COMPONENT_NAME] = "";
  double start = -1.0, end = -1.0, step = -1.0, now;
  GOOD(m->get_component_name(m, text));
  check(strcmp(text, "hfrac") == 0, "the name", m);
  GOOD(m->get_start_time(m, &start));
  GOOD(m->get_end_time(m, &end));
  GOOD(m->get_time_step(m, &step));
  GOOD(m->get_time_units(m, text));
  now = time_of(m);
  check(start == 0.0 && step > 0.0 && start <= now && now <= end && strcmp(text, "s") == 0, "times", m);
}

/* Variables */
static void variable(Bmi* m, const char* name) {
  int size = 0, bytes = 0, grid = -1, there = 0;
  char type[BMI_MAX_TYPE_NAME], units[BMI_MAX_UNITS_NAME], location[BMI_MAX_UNITS_NAME],
      grid_type[BMI_MAX_TYPE_NAME];
  GOOD(m->get_var_itemsize(m, name, &size));
  GOOD(m->get_var_nbytes(m, name, &bytes));
  GOOD(m->get_var_location(m, name, location));
  GOOD(m->get_var_grid(m, name, &grid));
  GOOD(m->get_grid_type(m, grid, grid_type));
  GOOD(m->get_var_type(m, name, type));
  GOOD(m->get_var_units(m, name, units));
  check(size > 0 && bytes > 0 && bytes % size == 0, name, m);
  check(strcmp(type, "double") == 0 || strcmp(type, "int") == 0 || strcmp(type, "long") == 0, name, m);
  check(units[0] != 0 && strstr(name, "__") != NULL, name, m);
  if (strcmp(location, "node") == 0) {
    GOOD(m->get_grid_node_count(m, grid, &there));
  } else if (strcmp(location, "edge") == 0) {
    GOOD(m->get_grid_edge_count(m, grid, &there));
  } else if (strcmp(location, "face") == 0) {
    GOOD(m->get_grid_face_count(m, grid, &there));
  } else {
    check(strcmp(location, "none") == 0 && strcmp(grid_type, "scalar") == 0, name, m);
    there = 1;
  }
  check(there * size == bytes, name, m);
}

/* Grids */
static void grid(Bmi* m, int id) {
  int rank = -1, size = 0, nodes = 0, edges = -1, faces = -1, corners = 0, k, f, at;
  int *edge_nodes, *per_face, *face_nodes, *face_edges;
  double *x, *y;
  char type[BMI_MAX_TYPE_NAME];
  GOOD(m->get_grid_rank(m, id, &rank));
  GOOD(m->get_grid_size(m, id, &size));
  GOOD(m->get_grid_type(m, id, type));
  check(rank <= 3 && size > 0, "rank and size", m);
  if (strcmp(type, "scalar") == 0) {
    check(rank == 0 && size == 1, "one value", m);
    return;
  }
  check(strcmp(type, "unstructured") == 0, type, m);
  GOOD(m->get_grid_node_count(m, id, &nodes));
  GOOD(m->get_grid_edge_count(m, id, &edges));
  GOOD(m->get_grid_face_count(m, id, &faces));
  check(nodes == size && edges >= 0 && faces >= 0 && (edges > 0 || faces == 0), "counts", m);
  x = (double*)malloc((size_t)nodes * sizeof *x);
  y = (double*)malloc((size_t)nodes * sizeof *y);
  for (k = 0; k < nodes; ++k) x[k] = y[k] = NAN;
  GOOD(m->get_grid_x(m, id, x));
  GOOD(m->get_grid_y(m, id, y));
  for (k = 0; k < nodes; ++k)
    check(x[k] > -1.0 && x[k] < 101.0 && y[k] > -1.0 && y[k] < 101.0, "coordinates", m);
  edge_nodes = (int*)malloc((size_t)(2 * edges + 1) * sizeof(int));
  GOOD(m->get_grid_edge_nodes(m, id, edge_nodes));
  for (k = 0; k < 2 * edges; ++k) check(edge_nodes[k] >= 0 && edge_nodes[k] < nodes, "nodes of edges", m);
  per_face = (int*)malloc((size_t)(faces + 1) * sizeof(int));
  GOOD(m->get_grid_nodes_per_face(m, id, per_face));
  for (f = 0; f < faces; ++f) corners += per_face[f];
  face_nodes = (int*)malloc((size_t)(corners + 1) * sizeof(int));
  face_edges = (int*)malloc((size_t)(corners + 1) * sizeof(int));
  GOOD(m->get_grid_face_nodes(m, id, face_nodes));
  GOOD(m->get_grid_face_edges(m, id, face_edges));
  for (f = 0, at = 0; f < faces; at += per_face[f++]) {
    double area = 0.0;
    for (k = 0; k < per_face[f]; ++k) {
      const int from = face_nodes[at + k], to = face_nodes[at + (k + 1) % per_face[f]],
                *ends = &edge_nodes[2 * face_edges[at + k]];
      check((ends[0] == from && ends[1] == to) || (ends[0] == to && ends[1] == from),
            "edges run around their face", m);
      area += 0.5 * (x[from] * y[to] - x[to] * y[from]);
    }
    check(area > 0.0, "faces are anticlockwise", m);
  }
  BAD(m->get_grid_shape(m, id, edge_nodes));
  BAD(m->get_grid_spacing(m, id, x));
  BAD(m->get_grid_origin(m, id, x));
  BAD(m->get_grid_z(m, id, x));
  free(x);
  free(y);
  free(edge_nodes);
  free(per_face);
  free(face_nodes);
  free(face_edges);
}

/* Values */
static void value(Bmi* m, const char* name) {
  int bytes = 0, size = 0, last, zero = 0;
  unsigned char *values, one[8];
  void *shared = NULL, *again = NULL;
  GOOD(m->get_var_nbytes(m, name, &bytes));
  GOOD(m->get_var_itemsize(m, name, &size));
  values = (unsigned char*)malloc((size_t)bytes);
  memset(values, 0xA5, (size_t)bytes);
  GOOD(m->get_value(m, name, values));
  last = bytes / size - 1;
  check(values[0] != 0xA5 || values[bytes - 1] != 0xA5, "values are written", m);
  GOOD(m->get_value_at_indices(m, name, one, &last, 1));
  check(memcmp(one, values + (size_t)last * (size_t)size, (size_t)size) == 0, name, m);
  GOOD(m->get_value_ptr(m, name, &shared));
  check(shared != NULL && memcmp(shared, values, (size_t)bytes) == 0, name, m);
  GOOD(m->get_value_ptr(m, name, &again));
  check(again == shared, "the pointer stays", m);
  last += 1;
  BAD(m->get_value_at_indices(m, name, one, &last, 1));
  last = -1;
  BAD(m->get_value_at_indices(m, name, one, &last, 1));
  GOOD(m->get_value_at_indices(m, name, one, &zero, 1));
  free(values);
}

static void run(Bmi* m) {
  double step = 0.0, *time_series, pressure = 30e6, kept = 0.0, rate = 1e-4;
  void* crack_count = NULL;
  int zero = 0;
  GOOD(m->get_time_step(m, &step));
  GOOD(m->get_value_ptr(m, "rock_crack__count", &crack_count));
  GOOD(m->get_value_ptr(m, "well_fluid__pressure", (void**)&time_series));
  GOOD(m->update(m));
  GOOD(m->update_until(m, time_of(m) + 2.0 * step));
  check(fabs(time_of(m) - 3.0 * step) < 1e-9 * step, "three steps", m);
  GOOD(m->update_until(m, 4.25 * step));
  check(fabs(time_of(m) - 4.25 * step) < 1e-9 * step, "and a part of one", m);
  GOOD(m->update_until(m, time_of(m)));
  check(*(int64_t*)crack_count > 0, "what a pointer shows follows", m);
  BAD(m->update_until(m, 0.0));
  BAD(m->update_until(m, NAN));

  GOOD(m->set_value(m, "well_fluid__pressure", &pressure));
  GOOD(m->update(m));
  GOOD(m->get_value(m, "well_fluid__pressure", &kept));
  check(kept == pressure && *time_series == pressure, "a well's pressure is set", m);
  GOOD(m->set_value_at_indices(m, "well_fluid__injection_rate_per_thickness", &zero, 1, &rate));
  GOOD(m->update(m));
  GOOD(m->get_value(m, "well_fluid__injection_rate_per_thickness", &kept));
  check(fabs(kept - rate) < 1e-9 * rate, "a well's rate is set", m);
  pressure = 26e6;
  GOOD(m->set_value(m, "rock_formation_fluid__pressure", &pressure));
  GOOD(m->get_value(m, "rock_formation_fluid__pressure", &kept));
  check(kept == pressure, "the formation's pressure is set", m);
  pressure = NAN;
  BAD(m->set_value(m, "rock_formation_fluid__pressure", &pressure));
  BAD(m->set_value(m, "rock__maximum_horizontal_stress", &rate)); /* walls of this case are fixed */
  BAD(m->set_value(m, "rock_crack__count", &rate));
}

/* Two models know nothing of each other. */
static void two_at_once(const char* file) {
  Bmi one, other, alone, *m = &one;
  double a = 0.0, b = 0.0, c = 0.0, pressure = 20e6;
  register_bmi_hfrac(&one);
  register_bmi_hfrac(&other);
  register_bmi_hfrac(&alone);
  GOOD(one.initialize(&one, file));
  GOOD(other.initialize(&other, file));
  check(one.data != other.data, "each has its own", m);
  GOOD(other.set_value(&other, "well_fluid__pressure", &pressure));
  GOOD(one.update(&one));
  GOOD(other.update(&other));
  GOOD(other.update(&other));
  GOOD(one.update(&one));
  GOOD(other.finalize(&other));
  GOOD(one.update(&one));
  GOOD(alone.initialize(&alone, file));
  GOOD(alone.update(&alone));
  GOOD(alone.update(&alone));
  GOOD(alone.update(&alone));
  GOOD(one.get_value(&one, "well_fluid__injected_volume_per_thickness", &a));
  GOOD(alone.get_value(&alone, "well_fluid__injected_volume_per_thickness", &b));
  GOOD(one.get_value(&one, "rock_fracture__volume_per_thickness", &c));
  check(a == b && a > 0.0 && c > 0.0, "interleaved is as alone", m);
  GOOD(one.finalize(&one));
  GOOD(alone.finalize(&alone));
}

static void wrong_use(const char* file) {
  Bmi model, *m = &model;
  char text[BMI_MAX_VAR_NAME];
  int number = 0;
  double real = 0.0;
  register_bmi_hfrac(m);
  BAD(m->update(m));
  BAD(m->update_until(m, 1.0));
  BAD(m->get_current_time(m, &real));
  BAD(m->get_input_item_count(m, &number));
  BAD(m->get_value(m, "rock_crack__count", &real));
  GOOD(m->finalize(m));
  BAD(m->initialize(m, NULL));
  BAD(m->initialize(m, "/nonexistent/case.toml"));
  check(bmi_hfrac_last_error(m, text, (int)sizeof text) == BMI_SUCCESS && strstr(text, "case.toml") != NULL,
        "the text names the file", NULL);
  BAD(m->finalize(NULL));
  BAD(m->update(NULL));
  GOOD(m->initialize(m, file));
  BAD(m->initialize(m, file));
  BAD(m->get_value(m, "no_such__variable", &real));
  check(bmi_hfrac_last_error(m, text, (int)sizeof text) == BMI_SUCCESS &&
            strstr(text, "get_output_var_names") != NULL,
        "the text says where to look", NULL);
  check(bmi_hfrac_last_error(m, text, 4) == BMI_SUCCESS && strlen(text) == 3, "texts are cut", NULL);
  BAD(bmi_hfrac_last_error(m, NULL, 4));
  BAD(m->get_value(m, NULL, &real));
  BAD(m->get_value(m, "rock_crack__count", NULL));
  BAD(m->get_value_ptr(m, "rock_crack__count", NULL));
  BAD(m->set_value(m, "well_fluid__pressure", NULL));
  BAD(m->get_var_type(m, "rock_crack__count", NULL));
  BAD(m->get_grid_type(m, 77, text));
  BAD(m->get_grid_rank(m, -1, &number));
  BAD(m->get_grid_x(m, 0, NULL));
  GOOD(m->finalize(m));
  GOOD(m->finalize(m));
}

/* A framework's cells: laid once, then read and given boundary pressures. */
static void cells(const char* file) {
  Bmi model, *m = &model;
  const double origin[2] = {-10.0, 0.0}, spacing[2] = {30.0, 50.0};
  const char* boundary = "cell_boundary_fluid__pressure";
  const int some[2] = {0, 7};
  double x[4], y[2], values[8], pair[2], before[8], matrix[8];
  double formation = 0.0, high[2] = {30e6, 31e6};
  int shape[2], k, count = 0, outputs = 0, more = 0;
  char text[BMI_MAX_TYPE_NAME];
  void* shown = NULL;
  register_bmi_hfrac(m);
  BAD(bmi_hfrac_set_grid(m, 4, 2, origin, spacing));
  GOOD(m->initialize(m, file));
  BAD(m->get_value(m, boundary, values));
  BAD(m->get_grid_type(m, 3, text));
  BAD(m->get_grid_shape(m, 0, shape));
  GOOD(m->get_output_item_count(m, &outputs));
  BAD(bmi_hfrac_set_grid(m, 0, 2, origin, spacing));
  BAD(bmi_hfrac_set_grid(m, 4, 2, NULL, spacing));
  GOOD(bmi_hfrac_set_grid(m, 4, 2, origin, spacing));
  GOOD(m->get_output_item_count(m, &more));
  check(more == outputs + 10, "there are ten variables of cells", m);
  GOOD(m->get_grid_type(m, 3, text));
  check(strcmp(text, "uniform_rectilinear") == 0, "cells are a lattice", m);
  GOOD(m->get_grid_size(m, 3, &count));
  GOOD(m->get_grid_shape(m, 3, shape));
  check(count == 8 && shape[0] == 2 && shape[1] == 4, "of so many rows and columns", m);
  GOOD(m->get_grid_spacing(m, 3, pair));
  check(pair[0] == 50.0 && pair[1] == 30.0, "so far apart", m);
  GOOD(m->get_grid_origin(m, 3, pair));
  check(pair[0] == 25.0 && pair[1] == 5.0, "from the middle of the first", m);
  GOOD(m->get_grid_x(m, 3, x));
  GOOD(m->get_grid_y(m, 3, y));
  check(x[3] == 95.0 && y[1] == 75.0, "to the middle of the last", m);
  GOOD(m->get_value(m, "rock_formation_fluid__pressure", &formation));
  GOOD(m->get_value_ptr(m, boundary, &shown));
  for (k = 0; k < 8; ++k) check(((double*)shown)[k] == formation, "the formation's pressure at first", m);
  GOOD(m->set_value_at_indices(m, boundary, (int*)some, 2, high));
  check(((double*)shown)[0] == 30e6 && ((double*)shown)[7] == 31e6 && ((double*)shown)[1] == formation,
        "then what was set", m);
  high[0] = NAN;
  BAD(m->set_value_at_indices(m, boundary, (int*)some, 2, high));
  check(((double*)shown)[0] == 30e6, "and no number that is none", m);
  GOOD(m->get_value(m, "cell_boundary_fluid__outflow_rate_per_thickness", before));
  GOOD(m->update(m));
  GOOD(m->get_value(m, "cell_boundary_fluid__outflow_rate_per_thickness", values));
  check(values[0] < before[0], "fluid comes in where the pressure is high", m);
  GOOD(m->get_value(m, "cell_rock_matrix__permeability", matrix));
  GOOD(m->get_value(m, "cell_rock_fluid__leak-off_rate_per_thickness", values));
  for (k = 0; k < 8; ++k) check(matrix[k] > 0.0 && values[k] == values[k], "cells have values", m);
  GOOD(m->get_value(m, "cell_rock_fracture__xx_component_of_permeability", values));
  GOOD(m->finalize(m));
}

static void table(Bmi* m) {
  Names in = names_of(m, 1), out = names_of(m, 0);
  char type[BMI_MAX_TYPE_NAME], units[BMI_MAX_UNITS_NAME], location[BMI_MAX_UNITS_NAME];
  int k, i, id = 0, bytes = 0, input;
  for (k = 0; k < out.count; ++k) {
    GOOD(m->get_var_type(m, out.list[k], type));
    GOOD(m->get_var_units(m, out.list[k], units));
    GOOD(m->get_var_location(m, out.list[k], location));
    GOOD(m->get_var_grid(m, out.list[k], &id));
    GOOD(m->get_var_nbytes(m, out.list[k], &bytes));
    for (i = 0, input = 0; i < in.count; ++i) input |= strcmp(in.list[i], out.list[k]) == 0;
    printf("%s|%s|%s|%s|%d|%d|%d\n", out.list[k], type, units, location, id, bytes, input);
  }
  free_names(&in);
  free_names(&out);
}

int main(int argc, char** argv) {
  Bmi model, *m = &model;
  const double origin[2] = {0.0, 0.0}, spacing[2] = {25.0, 50.0};
  Names in, out;
  int k;
  if (argc < 2) return 2;
  if (argc > 2) {
    register_bmi_hfrac(m);
    GOOD(m->initialize(m, argv[1]));
    GOOD(bmi_hfrac_set_grid(m, 4, 2, origin, spacing));
    table(m);
    GOOD(m->finalize(m));
    return failures == 0 ? 0 : 1;
  }
  control(argv[1]);
  register_bmi_hfrac(m);
  GOOD(m->initialize(m, argv[1]));
  info(m);
  in = names_of(m, 1);
  out = names_of(m, 0);
  for (k = 0; k < in.count; ++k) variable(m, in.list[k]);
  for (k = 0; k < out.count; ++k) variable(m, out.list[k]);
  for (k = 0; k < 3; ++k) grid(m, k);
  for (k = 0; k < out.count; ++k) value(m, out.list[k]);
  run(m);
  info(m);
  free_names(&in);
  free_names(&out);
  GOOD(m->finalize(m));
  two_at_once(argv[1]);
  cells(argv[1]);
  wrong_use(argv[1]);
  if (failures == 0) printf("all good\n");
  return failures == 0 ? 0 : 1;
}
