/* SPDX-License-Identifier: BSD-3-Clause */
/* The variables of the model, in the style of the CSDMS Standard Names: an object, two underscores, a quantity. Values are
 * read from the simulation when asked for. */
#include <stdlib.h>
#include <string.h>

#include "model.h"

#define ROCK(name, units, type, place, field, component) \
  { name, units, type, place, OUT, field, component, 0 }
#define WELL(name, units, direction, member) \
  { name, units, "double", AT_WELL, direction, -1, 0, offsetof(hfrac_well_state, member) }
#define CELL(name, units, direction, member) \
  { name, units, "double", AT_CELL, direction, -1, 0, offsetof(hfrac_cell, member) }
#define MODEL(name, units, type, direction) \
  { name, units, type, AT_MODEL, direction, -1, 0, 0 }

enum { /* rows of MODEL, by their place in the table */
       SIGMA_H_MAX = 16,
       SIGMA_H_MIN,
       FORMATION_PRESSURE,
       CRACK_COUNT,
       FRACTURE_LENGTH,
       FRACTURE_APERTURE,
       FRACTURE_VOLUME,
       LEAKED_VOLUME,
       BOUNDARY_PRESSURE /* the first of CELL */
};

const Variable variables[VARIABLE_COUNT] = {
    ROCK("rock_disc__radius", "m", "double", AT_NODE, HFRAC_DISC_RADIUS, 0),
    ROCK("rock_disc__x_component_of_displacement", "m", "double", AT_NODE, HFRAC_DISC_DISPLACEMENT, 0),
    ROCK("rock_disc__y_component_of_displacement", "m", "double", AT_NODE, HFRAC_DISC_DISPLACEMENT, 1),
    ROCK("rock_disc__rotation_angle", "radian", "double", AT_NODE, HFRAC_DISC_ROTATION, 0),
    ROCK("rock__xx_component_of_stress", "Pa", "double", AT_NODE, HFRAC_DISC_STRESS, 0),
    ROCK("rock__yy_component_of_stress", "Pa", "double", AT_NODE, HFRAC_DISC_STRESS, 1),
    ROCK("rock__xy_component_of_stress", "Pa", "double", AT_NODE, HFRAC_DISC_STRESS, 2),
    ROCK("rock_bond__state", "1", "int", AT_EDGE, HFRAC_BOND_STATE, 0),
    ROCK("rock_bond__normal_force_per_thickness", "N m-1", "double", AT_EDGE, HFRAC_BOND_NORMAL_FORCE, 0),
    ROCK("rock_pipe__hydraulic_aperture", "m", "double", AT_EDGE, HFRAC_PIPE_APERTURE, 0),
    ROCK("rock_pipe_fluid__volume_flow_rate_per_thickness", "m2 s-1", "double", AT_EDGE, HFRAC_PIPE_FLOW, 0),
    ROCK("rock_pore_fluid__pressure", "Pa", "double", AT_FACE, HFRAC_DOMAIN_PRESSURE, 0),
    ROCK("rock_pore_fluid__volume_per_thickness", "m2", "double", AT_FACE, HFRAC_DOMAIN_VOLUME, 0),
    WELL("well_fluid__pressure", "Pa", BOTH, pressure),
    WELL("well_fluid__injection_rate_per_thickness", "m2 s-1", BOTH, rate),
    WELL("well_fluid__injected_volume_per_thickness", "m2", OUT, injected_volume),
    MODEL("rock__maximum_horizontal_stress", "Pa", "double", BOTH),
    MODEL("rock__minimum_horizontal_stress", "Pa", "double", BOTH),
    MODEL("rock_formation_fluid__pressure", "Pa", "double", BOTH),
    MODEL("rock_crack__count", "1", "long", OUT),
    MODEL("rock_fracture__length", "m", "double", OUT),
    MODEL("rock_fracture__largest_aperture", "m", "double", OUT),
    MODEL("rock_fracture__volume_per_thickness", "m2", "double", OUT),
    MODEL("rock_boundary_fluid__leaked_volume_per_thickness", "m2", "double", OUT),
    CELL("cell_boundary_fluid__pressure", "Pa", BOTH, pressure), /* not the member: what was set */
    CELL("cell_boundary_fluid__outflow_rate_per_thickness", "m2 s-1", OUT, outflow),
    CELL("cell_boundary_fluid__conductance_per_thickness", "m2 Pa-1 s-1", OUT, conductance),
    CELL("cell_rock_fluid__leak-off_rate_per_thickness", "m2 s-1", OUT, leak_off),
    CELL("cell_rock_fluid__pressure", "Pa", OUT, pressure),
    CELL("cell_rock_fracture_fluid__pressure", "Pa", OUT, fracture_pressure),
    CELL("cell_rock_fracture__xx_component_of_permeability", "m2", OUT, permeability[0]),
    CELL("cell_rock_fracture__yy_component_of_permeability", "m2", OUT, permeability[1]),
    CELL("cell_rock_fracture__xy_component_of_permeability", "m2", OUT, permeability[2]),
    CELL("cell_rock_matrix__permeability", "m2", OUT, matrix_permeability),
};

int fail(Model* model, const char* text) {
  strncpy(model->error, text, sizeof model->error - 1);
  return -1;
}

int passed(Model* model, int32_t status) {
  model->error[0] = 0;
  return status >= 0 ? 0 : -1;
}

int well_count(const Model* model) {
  int32_t count = 0;
  return hfrac_well_count(model->sim, &count) == HFRAC_OK ? count : 0;
}

int64_t cell_count(const Model* model) {
  return model->grid.nx * model->grid.ny;
}

int has_variable(const Model* model, int variable) {
  if (variables[variable].place == AT_CELL) return cell_count(model) > 0;
  return variables[variable].place != AT_WELL || well_count(model) > 0;
}

int find_variable(Model* model, const char* name) {
  int v;
  for (v = 0; name != NULL && v < VARIABLE_COUNT; ++v) {
    if (strcmp(variables[v].name, name) == 0 && has_variable(model, v)) return v;
  }
  return fail(
      model,
      "the model has no variable of that name; get_input_var_names and get_output_var_names list them.");
}

int64_t item_count(Model* model, int field) {
  hfrac_field_desc desc;
  desc.struct_size = (int32_t)sizeof desc;
  return passed(model, hfrac_field_info(model->sim, field, &desc)) == 0 ? desc.count : -1;
}

int64_t value_count(Model* model, int variable) {
  int64_t count;
  switch (variables[variable].place) {
    case AT_WELL:
      return well_count(model);
    case AT_MODEL:
      return 1;
    case AT_CELL:
      return cell_count(model);
    default:
      count = item_count(model, variables[variable].field);
      /* Domain 0, the outside, is no face. */
      return variables[variable].place == AT_FACE && count > 0 ? count - 1 : count;
  }
}

size_t item_size(int variable) {
  return strcmp(variables[variable].type, "int") == 0 ? sizeof(int32_t) : sizeof(double);
}

static int get_field(Model* model, const Variable* v, void* to) {
  hfrac_field_desc desc;
  const void* data = NULL;
  int64_t count = 0, epoch = 0, i, first = v->place == AT_FACE ? 1 : 0;
  desc.struct_size = (int32_t)sizeof desc;
  if (passed(model, hfrac_field_info(model->sim, v->field, &desc)) != 0 ||
      passed(model, hfrac_field_view(model->sim, v->field, &data, &count, &epoch)) != 0) {
    return -1;
  }
  for (i = first; i < desc.count; ++i) {
    const int64_t from = i * desc.components + v->component;
    if (desc.dtype == 0) {
      ((double*)to)[i - first] = ((const double*)data)[from];
    } else {
      ((int32_t*)to)[i - first] = ((const int32_t*)data)[from];
    }
  }
  return 0;
}

static int get_wells(Model* model, const Variable* v, double* to) {
  hfrac_well_state state;
  int w, count = well_count(model);
  for (w = 0; w < count; ++w) {
    state.struct_size = (int32_t)sizeof state;
    if (passed(model, hfrac_well_get(model->sim, w, &state)) != 0) return -1;
    memcpy(&to[w], (const char*)&state + v->offset, sizeof(double));
  }
  return 0;
}

static int get_cells(Model* model, int variable, double* to) {
  const int64_t count = cell_count(model);
  const size_t offset = variables[variable].offset;
  /* The tensor of the flow is dear, all else is the same by either way. */
  const int flow = strstr(variables[variable].name, "permeability") != NULL;
  int64_t there = 0, c;
  int result;
  hfrac_cell* cells;
  if (variable == BOUNDARY_PRESSURE) {
    memcpy(to, model->boundary, (size_t)count * sizeof *to);
    return 0;
  }
  cells = (hfrac_cell*)malloc((size_t)count * sizeof *cells);
  if (cells == NULL) return fail(model, "out of memory.");
  result = passed(model, hfrac_grid_cells(model->sim, flow ? HFRAC_UPSCALE_FLOW : HFRAC_UPSCALE_ODA,
                                          (int32_t)sizeof *cells, cells, count, &there));
  for (c = 0; result == 0 && c < count; ++c) memcpy(&to[c], (const char*)&cells[c] + offset, sizeof(double));
  free(cells);
  return result;
}

int lay_cells(Model* model, int nx, int ny, const double* origin, const double* spacing) {
  hfrac_grid grid;
  hfrac_sim_state state;
  double* boundary;
  int64_t c;
  int v;
  memset(&grid, 0, sizeof grid);
  grid.struct_size = (int32_t)sizeof grid;
  grid.nx = nx;
  grid.ny = ny;
  grid.origin[0] = origin[0];
  grid.origin[1] = origin[1];
  grid.dx = spacing[0];
  grid.dy = spacing[1];
  state.struct_size = (int32_t)sizeof state;
  if (passed(model, hfrac_sim_get_state(model->sim, &state)) != 0 ||
      passed(model, hfrac_set_grid(model->sim, &grid)) != 0)
    return -1;
  boundary = (double*)malloc((size_t)(grid.nx * grid.ny) * sizeof *boundary);
  if (boundary == NULL) return fail(model, "out of memory.");
  for (c = 0; c < grid.nx * grid.ny; ++c) boundary[c] = state.formation_pressure;
  free(model->boundary);
  model->boundary = boundary;
  model->grid = grid;
  for (v = 0; v < VARIABLE_COUNT; ++v) {
    if (variables[v].place != AT_CELL) continue;
    free(model->shared[v]);
    model->shared[v] = NULL;
  }
  return 0;
}

static int get_of_model(Model* model, int variable, void* to) {
  hfrac_sim_state state;
  hfrac_fracture largest;
  hfrac_balance balance;
  int64_t fractures = 0;
  double* value = (double*)to;
  state.struct_size = (int32_t)sizeof state;
  balance.struct_size = (int32_t)sizeof balance;
  memset(&largest, 0, sizeof largest);
  switch (variable) {
    case SIGMA_H_MAX:
    case SIGMA_H_MIN:
    case FORMATION_PRESSURE:
    case CRACK_COUNT:
      if (passed(model, hfrac_sim_get_state(model->sim, &state)) != 0) return -1;
      if (variable == CRACK_COUNT) {
        memcpy(to, &state.crack_count, sizeof state.crack_count);
      } else {
        *value = variable == SIGMA_H_MAX   ? state.sigma_Hmax
                 : variable == SIGMA_H_MIN ? state.sigma_hmin
                                           : state.formation_pressure;
      }
      return 0;
    case LEAKED_VOLUME:
      if (passed(model, hfrac_get_balance(model->sim, &balance)) != 0) return -1;
      *value = balance.leaked_volume;
      return 0;
    default: /* of the largest fracture, 0 without one */
      if (passed(model, hfrac_fractures(model->sim, (int32_t)sizeof largest, NULL, 0, &fractures)) != 0)
        return -1;
      if (fractures > 0 &&
          passed(model, hfrac_fractures(model->sim, (int32_t)sizeof largest, &largest, 1, &fractures)) != 0)
        return -1;
      *value = variable == FRACTURE_LENGTH     ? largest.length
               : variable == FRACTURE_APERTURE ? largest.largest_aperture
                                               : largest.volume;
      return 0;
  }
}

int get_all(Model* model, int variable, void* to) {
  const Variable* v = &variables[variable];
  if (v->place == AT_WELL) return get_wells(model, v, (double*)to);
  if (v->place == AT_CELL) return get_cells(model, variable, (double*)to);
  if (v->place == AT_MODEL) return get_of_model(model, variable, to);
  return get_field(model, v, to);
}

static int set_one(Model* model, int variable, int at, double value) {
  hfrac_sim_state state;
  if (variables[variable].place == AT_WELL) {
    return passed(model, variables[variable].offset == offsetof(hfrac_well_state, pressure)
                             ? hfrac_well_set_pressure(model->sim, at, value)
                             : hfrac_well_set_rate(model->sim, at, value));
  }
  if (variable == FORMATION_PRESSURE) return passed(model, hfrac_set_formation_pressure(model->sim, value));
  state.struct_size = (int32_t)sizeof state;
  if (passed(model, hfrac_sim_get_state(model->sim, &state)) != 0) return -1;
  return passed(model, hfrac_set_far_field(model->sim, variable == SIGMA_H_MAX ? value : state.sigma_Hmax,
                                           variable == SIGMA_H_MIN ? value : state.sigma_hmin));
}

/* All cells at once, as the library takes them; nothing changes if it refuses them. */
static int set_boundary(Model* model, const int* indices, int64_t count, const double* values) {
  const size_t size = (size_t)cell_count(model) * sizeof(double);
  double* wanted = (double*)malloc(size);
  int64_t k;
  if (wanted == NULL) return fail(model, "out of memory.");
  memcpy(wanted, model->boundary, size);
  for (k = 0; k < count; ++k) wanted[indices != NULL ? indices[k] : (int)k] = values[k];
  if (passed(model, hfrac_set_boundary_pressure(model->sim, wanted, cell_count(model))) != 0) {
    free(wanted);
    return -1;
  }
  free(model->boundary);
  model->boundary = wanted;
  return 0;
}

int set_some(Model* model, int variable, const int* indices, int64_t count, const void* values) {
  const int64_t there = value_count(model, variable);
  int64_t k;
  if ((variables[variable].direction & IN) == 0) {
    return fail(model, "this variable is an output; get_input_var_names lists what can be set.");
  }
  if (values == NULL || count < 0) return fail(model, "the values are NULL, or their count is negative.");
  for (k = 0; indices != NULL && k < count; ++k) {
    if (indices[k] < 0 || indices[k] >= there)
      return fail(model, "an index is outside the variable's values.");
  }
  if (variable == BOUNDARY_PRESSURE) return set_boundary(model, indices, count, (const double*)values);
  for (k = 0; k < count; ++k) {
    if (set_one(model, variable, indices != NULL ? indices[k] : (int)k, ((const double*)values)[k]) != 0)
      return -1;
  }
  return 0;
}

int renew_shared(Model* model) {
  int v;
  for (v = 0; v < VARIABLE_COUNT; ++v) {
    if (model->shared[v] != NULL && get_all(model, v, model->shared[v]) != 0) return -1;
  }
  return 0;
}
