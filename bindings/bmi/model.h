/* SPDX-License-Identifier: BSD-3-Clause */
/* What is behind Bmi.data, and the table of variables. Inside this folder only. */
#ifndef HFRAC_BMI_MODEL_H
#define HFRAC_BMI_MODEL_H

#include <hfrac/hfrac.h>
#include <stddef.h>

enum grid { GRID_ROCK = 0, GRID_SCALAR = 1, GRID_WELLS = 2, GRID_CELLS = 3 };
enum place { AT_NODE, AT_EDGE, AT_FACE, AT_WELL, AT_MODEL, AT_CELL };
enum direction { OUT = 1, IN = 2, BOTH = 3 };
enum { VARIABLE_COUNT = 34 };

typedef struct Variable {
  const char *name, *units;
  const char* type; /* "double", "int" or "long", of 8, 4 and 8 bytes: C's own names, as BMI asks */
  enum place place;
  int direction;
  int field, component; /* of the rock's variables */
  size_t offset;        /* of a well's: member of hfrac_well_state; of a cell's: of hfrac_cell */
} Variable;

typedef struct Model {
  hfrac_sim* sim;
  hfrac_sim_def def;
  char error[1024];             /* of this layer; empty: the library has the text */
  void* shared[VARIABLE_COUNT]; /* what get_value_ptr gave out */
  hfrac_grid grid;              /* of cells; nx 0: none is laid */
  double* boundary;             /* Pa beyond the model's edge, by cell */
} Model;

extern const Variable variables[VARIABLE_COUNT];

/* Index of a variable that this model has, -1 with a text if there is none. */
int find_variable(Model* model, const char* name);
/* Whether the model has the variable: those of wells need wells, those of cells a grid. */
int has_variable(const Model* model, int variable);
/* Number of values; -1 with a text on failure. */
int64_t value_count(Model* model, int variable);
size_t item_size(int variable);
/* Writes all values; 0 on success, as all below. */
int get_all(Model* model, int variable, void* to);
/* Sets values[k] at indices[k]; indices NULL: all in order. */
int set_some(Model* model, int variable, const int* indices, int64_t count, const void* values);
/* Renews what get_value_ptr gave out. */
int renew_shared(Model* model);

/* Lays cells over the model, in place of earlier ones. */
int lay_cells(Model* model, int nx, int ny, const double* origin, const double* spacing);
int64_t cell_count(const Model* model);

/* Items of a field. */
int64_t item_count(Model* model, int field);
int well_count(const Model* model);

/* The rock's grid: around each face, node to node and edge to edge, in order; nodes_per_face has face_count entries. Any
 * result may be NULL. */
int face_rings(Model* model, int* nodes_per_face, int* nodes, int* edges);

int fail(Model* model, const char* text);
/* 0 for a status of the library that is none of failure; its text stays with the simulation. */
int passed(Model* model, int32_t status);

#endif
