/* SPDX-License-Identifier: BSD-3-Clause */
/* The 41 functions of BMI 2.0 over the C interface of hfrac. Nothing is shared between models but constant tables. */
#include <bmi_hfrac.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"

static int done(int result) {
  return result == 0 ? BMI_SUCCESS : BMI_FAILURE;
}

/* The model between initialize and finalize; NULL otherwise. */
static Model* model_of(const Bmi* self) {
  return self != NULL ? (Model*)self->data : NULL;
}

/* Looks the variable up; leaves the function if there is no model, no such variable, or nowhere to put the result. */
#define WITH_VARIABLE(result)                                \
  Model* model = model_of(self);                             \
  int variable;                                              \
  if (model == NULL || (result) == NULL) return BMI_FAILURE; \
  variable = find_variable(model, name);                     \
  if (variable < 0) return BMI_FAILURE
#define WITH_GRID(result)                                    \
  Model* model = model_of(self);                             \
  if (model == NULL || (result) == NULL) return BMI_FAILURE; \
  if (!has_grid(model, grid)) return done(fail(model, "the model has no such grid; they are 0 to 3."))

static int has_grid(const Model* model, int grid) {
  return grid == GRID_ROCK || grid == GRID_SCALAR || (grid == GRID_WELLS && well_count(model) > 0) ||
         (grid == GRID_CELLS && cell_count(model) > 0);
}

static int put_text(char* to, const char* text) {
  if (to == NULL) return BMI_FAILURE;
  strcpy(to, text); /* all are shorter than the 2048 bytes that BMI asks for */
  return BMI_SUCCESS;
}

static int put_int(Model* model, int64_t value, int* to) {
  if (value < 0) return BMI_FAILURE;
  if (value > INT_MAX) return done(fail(model, "the count is too large for an int, which BMI asks for."));
  *to = (int)value;
  return BMI_SUCCESS;
}

/* Initialize, run, finalize */

static int finalize(Bmi* self) {
  Model* model = model_of(self);
  int v, result = BMI_SUCCESS;
  if (self == NULL) return BMI_FAILURE;
  if (model == NULL) return BMI_SUCCESS;
  for (v = 0; v < VARIABLE_COUNT; ++v) free(model->shared[v]);
  free(model->boundary);
  if (hfrac_sim_destroy(&model->sim) < 0) result = BMI_FAILURE;
  free(model);
  self->data = NULL;
  return result;
}

static int initialize(Bmi* self, const char* config_file) {
  Model* model;
  if (self == NULL || config_file == NULL || self->data != NULL) return BMI_FAILURE;
  model = (Model*)calloc(1, sizeof *model);
  if (model == NULL) return BMI_FAILURE;
  if (hfrac_sim_def_init(&model->def, (int32_t)sizeof model->def) < 0 ||
      hfrac_sim_def_load(&model->def, config_file) < 0 || hfrac_sim_create(&model->def, &model->sim) < 0) {
    hfrac_sim_def_free(&model->def);
    free(model);
    return BMI_FAILURE;
  }
  hfrac_sim_def_free(&model->def); /* options are all that is asked for later */
  self->data = model;
  return BMI_SUCCESS;
}

static double step_of(const Model* model) {
  return model->def.stepping_flow_step;
}

static int update(Bmi* self) {
  Model* model = model_of(self);
  if (model == NULL) return BMI_FAILURE;
  return done(passed(model, hfrac_step(model->sim, 1)) != 0 ? -1 : renew_shared(model));
}

static int get_current_time(Bmi* self, double* time) {
  Model* model = model_of(self);
  hfrac_sim_state state;
  state.struct_size = (int32_t)sizeof state;
  if (model == NULL || time == NULL || passed(model, hfrac_sim_get_state(model->sim, &state)) != 0)
    return BMI_FAILURE;
  *time = state.time;
  return BMI_SUCCESS;
}

/* A step of any length: what is left of an interval. */
static int part_of_step(Model* model, double duration) {
  int32_t status;
  if (passed(model, hfrac_step_prepare(model->sim)) != 0) return -1;
  status = hfrac_step_do(model->sim, duration);
  if (status < 0) {
    hfrac_step_reject(model->sim);
    return passed(model, status);
  }
  return passed(model, hfrac_step_finalize(model->sim));
}

static int update_until(Bmi* self, double then) {
  Model* model = model_of(self);
  double now = 0.0, whole;
  if (model == NULL || get_current_time(self, &now) != BMI_SUCCESS) return BMI_FAILURE;
  if (!(then >= now) || !(then < 1e300))
    return done(fail(model, "update_until: the time lies behind, or is no number."));
  /* Rounding of added steps must neither cost one more nor leave a splinter of one. */
  whole = floor((then - now) / step_of(model) + 1e-6);
  if (whole > 9e15)
    return done(fail(model, "update_until: too many steps; use a longer stepping.flow_step."));
  if (passed(model, hfrac_step(model->sim, (int64_t)whole)) != 0) return BMI_FAILURE;
  if (then - (now + whole * step_of(model)) > 1e-6 * step_of(model) &&
      part_of_step(model, then - (now + whole * step_of(model))) != 0) {
    return BMI_FAILURE;
  }
  return done(renew_shared(model));
}

/* Exchange items */

static int get_component_name(Bmi* self, char* name) {
  (void)self;
  return put_text(name, "hfrac");
}

static int count_of(const Bmi* self, int direction, int* count) {
  const Model* model = model_of(self);
  int v;
  if (model == NULL || count == NULL) return BMI_FAILURE;
  *count = 0;
  for (v = 0; v < VARIABLE_COUNT; ++v)
    *count += (variables[v].direction & direction) != 0 && has_variable(model, v);
  return BMI_SUCCESS;
}

static int names_of(const Bmi* self, int direction, char** names) {
  const Model* model = model_of(self);
  int v, k = 0;
  if (model == NULL || names == NULL) return BMI_FAILURE;
  for (v = 0; v < VARIABLE_COUNT; ++v) {
    if ((variables[v].direction & direction) == 0 || !has_variable(model, v)) continue;
    if (put_text(names[k++], variables[v].name) != BMI_SUCCESS) return BMI_FAILURE;
  }
  return BMI_SUCCESS;
}

static int get_input_item_count(Bmi* self, int* count) {
  return count_of(self, IN, count);
}
static int get_output_item_count(Bmi* self, int* count) {
  return count_of(self, OUT, count);
}
static int get_input_var_names(Bmi* self, char** names) {
  return names_of(self, IN, names);
}
static int get_output_var_names(Bmi* self, char** names) {
  return names_of(self, OUT, names);
}

/* Variables */

static int get_var_grid(Bmi* self, const char* name, int* grid) {
  WITH_VARIABLE(grid);
  *grid = variables[variable].place == AT_WELL    ? GRID_WELLS
          : variables[variable].place == AT_MODEL ? GRID_SCALAR
          : variables[variable].place == AT_CELL  ? GRID_CELLS
                                                  : GRID_ROCK;
  return BMI_SUCCESS;
}

static int get_var_type(Bmi* self, const char* name, char* type) {
  WITH_VARIABLE(type);
  return put_text(type, variables[variable].type);
}

static int get_var_units(Bmi* self, const char* name, char* units) {
  WITH_VARIABLE(units);
  return put_text(units, variables[variable].units);
}

static int get_var_itemsize(Bmi* self, const char* name, int* size) {
  WITH_VARIABLE(size);
  *size = (int)item_size(variable);
  return BMI_SUCCESS;
}

static int get_var_nbytes(Bmi* self, const char* name, int* nbytes) {
  int64_t count;
  WITH_VARIABLE(nbytes);
  count = value_count(model, variable);
  return put_int(model, count < 0 ? count : count * (int64_t)item_size(variable), nbytes);
}

static int get_var_location(Bmi* self, const char* name, char* location) {
  WITH_VARIABLE(location);
  switch (variables[variable].place) {
    case AT_EDGE:
      return put_text(location, "edge");
    case AT_FACE:
      return put_text(location, "face");
    case AT_MODEL:
      return put_text(location, "none");
    default:
      return put_text(location, "node");
  }
}

/* Time */

static int get_start_time(Bmi* self, double* time) {
  if (model_of(self) == NULL || time == NULL) return BMI_FAILURE;
  *time = 0.0;
  return BMI_SUCCESS;
}

static int get_end_time(Bmi* self, double* time) {
  const Model* model = model_of(self);
  if (model == NULL || time == NULL) return BMI_FAILURE;
  *time = model->def.stepping_end_time > 0.0 ? model->def.stepping_end_time
                                             : step_of(model) * (double)model->def.stepping_steps;
  return BMI_SUCCESS;
}

static int get_time_units(Bmi* self, char* units) {
  (void)self;
  return put_text(units, "s");
}

static int get_time_step(Bmi* self, double* time_step) {
  const Model* model = model_of(self);
  if (model == NULL || time_step == NULL) return BMI_FAILURE;
  *time_step = step_of(model);
  return BMI_SUCCESS;
}

/* Getters and setters */

static int get_value(Bmi* self, const char* name, void* dest) {
  WITH_VARIABLE(dest);
  return done(get_all(model, variable, dest));
}

/* All values in memory of ours, to be freed. */
static void* fresh_copy(Model* model, int variable) {
  const int64_t count = value_count(model, variable);
  void* values = count >= 0 ? malloc((size_t)count * item_size(variable) + 1) : NULL;
  if (values != NULL && get_all(model, variable, values) == 0) return values;
  if (values == NULL && count >= 0) fail(model, "out of memory.");
  free(values);
  return NULL;
}

static int get_value_ptr(Bmi* self, const char* name, void** dest_ptr) {
  WITH_VARIABLE(dest_ptr);
  if (model->shared[variable] == NULL) model->shared[variable] = fresh_copy(model, variable);
  *dest_ptr = model->shared[variable];
  return *dest_ptr != NULL ? BMI_SUCCESS : BMI_FAILURE;
}

static int get_value_at_indices(Bmi* self, const char* name, void* dest, int* inds, int count) {
  char* all;
  size_t size;
  int64_t there;
  int k;
  WITH_VARIABLE(dest);
  if (inds == NULL || count < 0)
    return done(fail(model, "the indices are NULL, or their count is negative."));
  there = value_count(model, variable);
  for (k = 0; k < count; ++k) {
    if (inds[k] < 0 || inds[k] >= there)
      return done(fail(model, "an index is outside the variable's values."));
  }
  all = (char*)fresh_copy(model, variable);
  if (all == NULL) return BMI_FAILURE;
  size = item_size(variable);
  for (k = 0; k < count; ++k) memcpy((char*)dest + (size_t)k * size, all + (size_t)inds[k] * size, size);
  free(all);
  return BMI_SUCCESS;
}

static int set_value(Bmi* self, const char* name, void* src) {
  WITH_VARIABLE(src);
  if (set_some(model, variable, NULL, value_count(model, variable), src) != 0) return BMI_FAILURE;
  return done(renew_shared(model));
}

static int set_value_at_indices(Bmi* self, const char* name, int* inds, int count, void* src) {
  WITH_VARIABLE(src);
  if (inds == NULL) return done(fail(model, "the indices are NULL."));
  if (set_some(model, variable, inds, count, src) != 0) return BMI_FAILURE;
  return done(renew_shared(model));
}

/* Grids */

static int get_grid_rank(Bmi* self, int grid, int* rank) {
  WITH_GRID(rank);
  *rank = grid == GRID_SCALAR ? 0 : 2;
  return BMI_SUCCESS;
}

static int get_grid_node_count(Bmi* self, int grid, int* count) {
  WITH_GRID(count);
  if (grid == GRID_ROCK) return put_int(model, item_count(model, HFRAC_DISC_RADIUS), count);
  if (grid == GRID_CELLS) return put_int(model, cell_count(model), count);
  return put_int(model, grid == GRID_WELLS ? well_count(model) : 1, count);
}

static int get_grid_size(Bmi* self, int grid, int* size) {
  return get_grid_node_count(self, grid, size);
}

static int get_grid_type(Bmi* self, int grid, char* type) {
  WITH_GRID(type);
  return put_text(type, grid == GRID_SCALAR  ? "scalar"
                        : grid == GRID_CELLS ? "uniform_rectilinear"
                                             : "unstructured");
}

/* The model of a lattice, which only the grid of cells is; NULL with a text otherwise. */
static const Model* lattice(Bmi* self, int grid, const void* result) {
  Model* model = model_of(self);
  if (model == NULL || result == NULL) return NULL;
  if (grid == GRID_CELLS && cell_count(model) > 0) return model;
  fail(model, "this grid is no lattice; see get_grid_type.");
  return NULL;
}
/* BMI has the axes from the slowest, y, to the fastest, x. Nodes are the middles of cells. */
static int get_grid_shape(Bmi* self, int grid, int* shape) {
  const Model* model = lattice(self, grid, shape);
  if (model == NULL) return BMI_FAILURE;
  shape[0] = (int)model->grid.ny;
  shape[1] = (int)model->grid.nx;
  return BMI_SUCCESS;
}
static int get_grid_spacing(Bmi* self, int grid, double* spacing) {
  const Model* model = lattice(self, grid, spacing);
  if (model == NULL) return BMI_FAILURE;
  spacing[0] = model->grid.dy;
  spacing[1] = model->grid.dx;
  return BMI_SUCCESS;
}
static int get_grid_origin(Bmi* self, int grid, double* origin) {
  const Model* model = lattice(self, grid, origin);
  if (model == NULL) return BMI_FAILURE;
  origin[0] = model->grid.origin[1] + 0.5 * model->grid.dy;
  origin[1] = model->grid.origin[0] + 0.5 * model->grid.dx;
  return BMI_SUCCESS;
}

/* Coordinates of a grid's nodes; axis 0: x, 1: y. */
static int coordinates(Bmi* self, int grid, int axis, double* to) {
  hfrac_well_state state;
  const void* data = NULL;
  int64_t count = 0, k;
  int w;
  WITH_GRID(to);
  if (grid == GRID_SCALAR) return done(fail(model, "one value for the model has no coordinates."));
  if (grid == GRID_CELLS) {
    const double step = axis == 0 ? model->grid.dx : model->grid.dy;
    for (k = 0; k < (axis == 0 ? model->grid.nx : model->grid.ny); ++k)
      to[k] = model->grid.origin[axis] + ((double)k + 0.5) * step;
    return BMI_SUCCESS;
  }
  if (grid == GRID_WELLS) {
    for (w = 0; w < well_count(model); ++w) {
      state.struct_size = (int32_t)sizeof state;
      if (passed(model, hfrac_well_get(model->sim, w, &state)) != 0) return BMI_FAILURE;
      to[w] = axis == 0 ? state.x : state.y;
    }
    return BMI_SUCCESS;
  }
  if (passed(model, hfrac_field_view(model->sim, HFRAC_DISC_POSITION, &data, &count, NULL)) != 0)
    return BMI_FAILURE;
  for (k = 0; k < count / 2; ++k) to[k] = ((const double*)data)[2 * k + axis];
  return BMI_SUCCESS;
}
static int get_grid_x(Bmi* self, int grid, double* x) {
  return coordinates(self, grid, 0, x);
}
static int get_grid_y(Bmi* self, int grid, double* y) {
  return coordinates(self, grid, 1, y);
}
static int get_grid_z(Bmi* self, int grid, double* z) {
  WITH_GRID(z);
  return done(fail(model, "the model is two-dimensional: there is no z."));
}

static int get_grid_edge_count(Bmi* self, int grid, int* count) {
  WITH_GRID(count);
  return put_int(model, grid == GRID_ROCK ? item_count(model, HFRAC_BOND_STATE) : 0, count);
}

static int get_grid_face_count(Bmi* self, int grid, int* count) {
  WITH_GRID(count);
  return put_int(model, grid == GRID_ROCK ? item_count(model, HFRAC_DOMAIN_PRESSURE) - 1 : 0, count);
}

static int get_grid_edge_nodes(Bmi* self, int grid, int* edge_nodes) {
  int64_t count = 0;
  WITH_GRID(edge_nodes);
  if (grid != GRID_ROCK) return BMI_SUCCESS; /* none */
  if (passed(model, hfrac_field_copy_i32(model->sim, HFRAC_BOND_DISCS, NULL, 0, &count)) != 0)
    return BMI_FAILURE;
  return done(passed(model, hfrac_field_copy_i32(model->sim, HFRAC_BOND_DISCS, edge_nodes, count, &count)));
}

static int get_grid_face_edges(Bmi* self, int grid, int* face_edges) {
  WITH_GRID(face_edges);
  return grid == GRID_ROCK ? done(face_rings(model, NULL, NULL, face_edges)) : BMI_SUCCESS;
}

static int get_grid_face_nodes(Bmi* self, int grid, int* face_nodes) {
  WITH_GRID(face_nodes);
  return grid == GRID_ROCK ? done(face_rings(model, NULL, face_nodes, NULL)) : BMI_SUCCESS;
}

static int get_grid_nodes_per_face(Bmi* self, int grid, int* nodes_per_face) {
  WITH_GRID(nodes_per_face);
  return grid == GRID_ROCK ? done(face_rings(model, nodes_per_face, NULL, NULL)) : BMI_SUCCESS;
}

int bmi_hfrac_last_error(const Bmi* model, char* text, int capacity) {
  const Model* inside = model_of(model);
  if (text == NULL || capacity < 1) return BMI_FAILURE;
  if (inside != NULL && inside->error[0] != 0) {
    text[0] = 0;
    strncat(text, inside->error, (size_t)capacity - 1);
    return BMI_SUCCESS;
  }
  if (hfrac_last_error(inside != NULL ? inside->sim : NULL, text, capacity, NULL) != HFRAC_OK)
    return BMI_FAILURE;
  if (inside == NULL && text[0] == 0)
    strncat(text, "the model is not initialized; call initialize with a case file first.",
            (size_t)capacity - 1);
  return BMI_SUCCESS;
}

int bmi_hfrac_set_grid(Bmi* model, int nx, int ny, const double* origin, const double* spacing) {
  Model* inside = model_of(model);
  if (inside == NULL || origin == NULL || spacing == NULL) return BMI_FAILURE;
  return done(lay_cells(inside, nx, ny, origin, spacing));
}

Bmi* register_bmi_hfrac(Bmi* model) {
  static const Bmi functions = {
      NULL,
      initialize,
      update,
      update_until,
      finalize,
      get_component_name,
      get_input_item_count,
      get_output_item_count,
      get_input_var_names,
      get_output_var_names,
      get_var_grid,
      get_var_type,
      get_var_units,
      get_var_itemsize,
      get_var_nbytes,
      get_var_location,
      get_current_time,
      get_start_time,
      get_end_time,
      get_time_units,
      get_time_step,
      get_value,
      get_value_ptr,
      get_value_at_indices,
      set_value,
      set_value_at_indices,
      get_grid_rank,
      get_grid_size,
      get_grid_type,
      get_grid_shape,
      get_grid_spacing,
      get_grid_origin,
      get_grid_x,
      get_grid_y,
      get_grid_z,
      get_grid_node_count,
      get_grid_edge_count,
      get_grid_face_count,
      get_grid_edge_nodes,
      get_grid_face_edges,
      get_grid_face_nodes,
      get_grid_nodes_per_face,
  };
  if (model != NULL) *model = functions;
  return model;
}
